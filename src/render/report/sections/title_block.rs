//! The title block: whose calculation it is, and of which inputs.

use crate::ground::hash::Fnv;
use crate::render::report::Inputs;
use maud::{Markup, html};

/// Nothing where the case has no title block. What it leaves out is blank, to be filled in by hand.
pub fn title_block(inputs: &Inputs) -> Markup {
    let entries = &inputs.summary.title_block.0;
    if entries.is_empty() {
        return html! {};
    }
    html! {
        section id="title" { dl class="title-block" {
            @for (name, text) in entries {
                div { dt { (name) } dd { (text.as_deref().unwrap_or_default()) } }
            }
            // A changed input is another calculation.
            div { dt { "case file, FNV-1a" } dd { (Fnv::hex(inputs.case.1)) } }
            div { dt { "program" } dd { "Brinell " (inputs.summary.brinell_version) } }
        } }
    }
}
