//! Small pieces of markup that the sections share.

use maud::{Markup, PreEscaped, html};

/// Sentences below one another, under a heading; nothing where there are none.
pub fn list(heading: &str, sentences: &[String]) -> Markup {
    html! {
        @if !sentences.is_empty() {
            h3 { (heading) }
            ul { @for sentence in sentences { li { (sentence) } } }
        }
    }
}

/// Text that may stand inside a script element: nothing in it can end the element.
pub fn in_script(text: &str) -> Markup {
    PreEscaped(text.replace('<', "\\u003c"))
}
