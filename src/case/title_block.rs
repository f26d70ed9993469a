//! `[title_block]`: whose calculation it is, for the head of the page.

use super::error::CaseError;
use super::keys;
use super::parse::{Field, Table};

/// The entries of a title block in their order; what the case leaves out is to be filled in by hand.
pub type TitleBlock = Vec<(&'static str, Option<String>)>;

/// Every entry where the case has a title block, none where it has not.
pub(super) fn read(root: &Table) -> Result<TitleBlock, CaseError> {
    let Some(field) = root.get("title_block") else {
        return Ok(Vec::new());
    };
    let table = field.table()?.only(&keys::TITLE_BLOCK)?;
    let entry = |key| {
        let text = table.maybe(key, Field::string)?;
        Ok((key, text.map(|text| text.value)))
    };
    keys::TITLE_BLOCK.names().into_iter().map(entry).collect()
}
