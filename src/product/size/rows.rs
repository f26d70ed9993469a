//! The rows of a table of candidates.

use super::SizeError;

/// Of the candidates that are tried, in their order, those that can be built: up to the first that will do and `beyond` more, or to the
/// first that `ends` the table. One that cannot be built is left out, for another may do: only the larger rollers would touch each
/// other, only the smaller ones have no room for their ends.
///
/// # Errors
/// Why the first one cannot be built, where none can.
pub fn rows<C>(
    tried: impl Iterator<Item = Result<C, SizeError>>,
    beyond: usize,
    will_do: impl Fn(&C) -> bool,
    ends: impl Fn(&C) -> bool,
) -> Result<Vec<C>, SizeError> {
    let mut found: Vec<C> = Vec::new();
    let mut cannot = None;
    let mut do_so = 0;
    for candidate in tried {
        match candidate {
            Ok(candidate) => {
                do_so += usize::from(do_so > 0 || will_do(&candidate));
                let is_last = do_so > beyond || ends(&candidate);
                found.push(candidate);
                if is_last {
                    break;
                }
            }
            Err(why) => cannot = cannot.or(Some(why)),
        }
    }
    cannot.filter(|_| found.is_empty()).map_or(Ok(found), Err)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(tried: Vec<Result<u32, SizeError>>) -> Result<Vec<u32>, SizeError> {
        rows(tried.into_iter(), 1, |n| *n >= 3, |n| *n == 9)
    }

    fn cannot() -> SizeError {
        SizeError::Range {
            option: "--diameter",
            value: "0".to_owned(),
            range: "more",
        }
    }

    #[test]
    fn what_cannot_be_built_is_left_out() {
        let tried = vec![Err(cannot()), Ok(1), Ok(3), Err(cannot()), Ok(4), Ok(5)];
        assert_eq!(numbers(tried).unwrap(), [1, 3, 4]);
        assert_eq!(numbers(vec![Ok(1), Ok(9), Ok(3)]).unwrap(), [1, 9]);
        assert!(numbers(vec![Err(cannot()), Err(cannot())]).is_err());
    }
}
