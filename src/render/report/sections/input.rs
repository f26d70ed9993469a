//! The case file, as it was read.

use crate::render::report::Inputs;
use maud::{Markup, html};

pub fn input(inputs: &Inputs) -> Markup {
    let (name, text) = inputs.case;
    html! {
        p { (name) }
        details { summary { "the case file" } pre { (text) } }
    }
}
