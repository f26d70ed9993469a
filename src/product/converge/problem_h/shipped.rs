//! The shipped case of problem H.

use crate::case::{Case, CaseError, parse};

/// The case that is built in goes by this name, without a file.
pub const NAME: &str = "problem-h";
const TEXT: &str = include_str!("../../../../cases/problem-h.toml");

/// The built-in problem H.
///
/// # Errors
/// Never, as long as the shipped case is sound.
pub fn case() -> Result<Case, CaseError> {
    parse(NAME, TEXT)
}

/// Is `case` problem H as it is shipped, so that its limits are known?
pub fn is_problem_h(case: &Case) -> bool {
    case.source.text() == TEXT
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_built_in_case_is_the_shipped_one() {
        let shipped = case().unwrap();
        assert!(is_problem_h(&shipped));
        let other = parse("other", &TEXT.replace("1.5 in", "2 in"));
        assert!(!is_problem_h(&other.unwrap()));
    }
}
