//! The page of the book about grades.

use super::grade::{Grade, Strength};
use super::list::Grades;
use crate::case::error::CaseError;
use crate::ground::markdown::table;

/// The page, in Markdown.
///
/// # Errors
/// None: a test reads the file of grades.
pub fn page() -> Result<String, CaseError> {
    let mut text = String::from(
        "# Steels by name\n\nMade from `src/case/grades/grades.toml` by `cargo run --release --example reference`; \
         not edited by hand.\n\n`steel = \"S355\"` in a case, `--steel S355` for `brinell hertz`. Case, blanks and \
         hyphens of a name do not matter. Strengths are the least ones that the standard asks for, by the thickness \
         or diameter of the product as delivered, and the texts of the standards were not at hand: look them up \
         before you build. Grades of your own stand in a file with the same keys, which the key `grades` of a case \
         names, or the option `--grades`:\n\n```toml\n[[grade]]\nname = \"Shop steel\"\nalso = [\"SS\"]\nsource = \"mill \
         certificate 17\"\nyoungs_modulus = \"205 GPa\"\npoissons_ratio = 0.29\nyield_stress = [{ up_to = \"50 mm\", \
         value = \"800 MPa\" }, { up_to = \"120 mm\", value = \"750 MPa\" }]\nultimate_strength = \"950 MPa\"\nhardness = \
         280\n```\n\n",
    );
    let grades = Grades::shipped()?;
    let headings = [
        "name",
        "also",
        "yield stress",
        "ultimate strength",
        "E",
        "ν",
        "HB",
        "source",
    ];
    text.push_str(&table(headings, grades.all().iter().map(row)));
    for grade in grades.all() {
        if let Some(note) = &grade.note {
            text.push_str(&format!("\n{}: {note}.\n", grade.name));
        }
    }
    Ok(text)
}

fn row(grade: &Grade) -> [String; 8] {
    let strength = |strength: &Option<Strength>| {
        strength
            .as_ref()
            .map_or_else(|| "-".to_owned(), Strength::to_string)
    };
    let hardness = grade
        .hardness
        .map_or_else(|| "-".to_owned(), |h| h.to_string());
    [
        grade.name.clone(),
        grade.also.join(", "),
        strength(&grade.yield_stress),
        strength(&grade.ultimate_strength),
        grade.youngs_modulus.to_string(),
        grade.poissons_ratio.to_string(),
        hardness,
        grade.source.clone(),
    ]
}
