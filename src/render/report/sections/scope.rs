//! What is calculated and of which inputs: scope, actions, inputs with their origin.

use crate::render::report::Inputs;
use crate::render::report::calculation::InputRow;
use crate::render::report::html::list;
use crate::render::table::Table;
use crate::render::table::html::table;
use maud::{Markup, html};

/// What is calculated, how far that goes, and what acts.
pub fn scope(inputs: &Inputs) -> Markup {
    let calculation = inputs.calculation;
    html! {
        @for sentence in &calculation.scope { p { (sentence) } }
        @if let Some(study) = calculation.cited { p { "The case belongs to a published study: " (study) "." } }
        (list("Actions", &calculation.actions))
    }
}

/// Every input: what the case says, and what was taken where it does not.
pub fn inputs(inputs: &Inputs) -> Markup {
    let rows = &inputs.calculation.inputs;
    if rows.is_empty() {
        return html! {};
    }
    let mut all = Table::new("")
        .words("key of the case file")
        .words("value")
        .words("origin")
        .words("what it is, or why it was taken")
        .about("Given: the case file says it. Default: it does not, and the usual is taken. Assumed: it does not, and the \
                engineer has to judge what was taken.");
    for InputRow {
        key,
        value,
        origin,
        about,
    } in rows
    {
        all.row([key.into(), value.into(), origin.name().into(), about.into()]);
    }
    table(&all)
}
