//! `[[tie]]`: pairs of surfaces that are joined.

use super::error::{CaseError, ErrorKind};
use super::keys;
use super::parse::Table;
use super::place::Located;
use crate::ground::units::Dimension;
use crate::model::scene::Tie;

/// Reads all `[[tie]]`, each marked at its surfaces.
pub(super) fn read(root: &Table) -> Result<Vec<Located<Tie>>, CaseError> {
    let mut ties: Vec<Located<Tie>> = Vec::new();
    for table in root.tables("tie")? {
        let table = table.only(&keys::TIE)?;
        let field = table.need("surfaces")?;
        let mut surfaces = Vec::new();
        for item in field.list()? {
            surfaces.push(item.string()?.value);
        }
        let [first, second] = &surfaces[..] else {
            let why = format!("a tie joins two surfaces, and here are {}", surfaces.len());
            let help = "give surfaces = [\"a\", \"b\"]";
            return Err(field
                .located(())
                .place
                .error(ErrorKind::Value, why)
                .help(help));
        };
        let place = field.located(()).place;
        if first == second {
            let why = "a surface cannot be tied to itself";
            return Err(place.error(ErrorKind::Conflict, why));
        }
        let mut tie = Tie::between(first, second);
        if let Some(field) = table.get("name") {
            tie = tie.named(&field.string()?.value);
        }
        if let Some(field) = table.get("tolerance") {
            tie = tie.within(field.quantity(Dimension::LENGTH)?.positive()?.value);
        }
        if ties.iter().any(|other| other.value.name == tie.name) {
            let why = format!("there are two ties called `{}`", tie.name);
            return Err(place.error(ErrorKind::Duplicate, why));
        }
        ties.push(Located { value: tie, place });
    }
    Ok(ties)
}
