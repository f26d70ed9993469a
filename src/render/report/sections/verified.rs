//! How the program is verified: the families of claims that cover what this run used.

use crate::render::report::Inputs;
use crate::render::table::Table;
use crate::render::table::html::table;
use maud::{Markup, html};

/// A row for each family.
pub fn verified(inputs: &Inputs) -> Markup {
    let rows = &inputs.calculation.verified;
    if rows.is_empty() {
        return html! {};
    }
    let mut families = Table::new("")
        .words("what this run used")
        .words("family of claims")
        .figures(["claims", "outside their tolerance"])
        .about("Each claim is solved and compared with a closed form, a book's equation or an independent program; \
                `brinell verify --suite FAMILY` repeats it, and docs/verification.md has the values.");
    for row in rows {
        families.row([
            row.used.into(),
            row.family.into(),
            row.claims.into(),
            row.outside.into(),
        ]);
    }
    html! {
        (table(&families))
        p class="note" {
            "Verification says that the equations are solved; whether the model is that of the structure is for the \
             engineer to judge."
        }
    }
}
