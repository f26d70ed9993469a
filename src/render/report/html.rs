//! Small pieces of markup that the sections share.

use maud::{Markup, PreEscaped, Render, html};

/// Begins the heading of a column of words, which stand flush left as the first column does.
const WORDS: char = '<';

/// A table: headings, then rows whose first cell names them.
pub fn table(caption: &str, headings: &[&str], rows: &[Vec<Markup>]) -> Markup {
    let class = |k: usize| {
        let words = headings.get(k).is_some_and(|h| h.starts_with(WORDS));
        words.then_some("left")
    };
    html! {
        @if !rows.is_empty() {
            div class="scroll" {
                table {
                    @if !caption.is_empty() { caption { (caption) } }
                    thead {
                        tr {
                            @for (k, heading) in headings.iter().enumerate() {
                                th scope="col" class=[class(k)] { (heading.trim_start_matches(WORDS)) }
                            }
                        }
                    }
                    tbody {
                        @for row in rows {
                            tr {
                                @for (k, cell) in row.iter().enumerate() {
                                    @if k == 0 {
                                        th scope="row" { (cell) }
                                    } @else {
                                        td class=[class(k)] { (cell) }
                                    }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

/// Texts as the cells of a row.
pub fn row<T: Render, const N: usize>(cells: [T; N]) -> Vec<Markup> {
    cells.iter().map(Render::render).collect()
}

/// Sentences below one another, under a heading; nothing where there are none.
pub fn list(heading: &str, sentences: &[String]) -> Markup {
    html! {
        @if !sentences.is_empty() {
            h3 { (heading) }
            ul { @for sentence in sentences { li { (sentence) } } }
        }
    }
}

/// Met or missed, in a word and a colour.
pub fn met(met: bool) -> Markup {
    match met {
        true => html! { b class="good" { "yes" } },
        false => html! { b class="bad" { "NO" } },
    }
}

/// Text that may stand inside a script element: nothing in it can end the element.
pub fn in_script(text: &str) -> Markup {
    PreEscaped(text.replace('<', "\\u003c"))
}
