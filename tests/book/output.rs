//! Is an excerpt what the program printed?

/// Numbers agree within this share: digits depend a little on the processor, seconds are never shown.
const SHARE: f64 = 0.02;
/// Residuals and the like: numbers below this are only as small as each other.
const ROUNDING: f64 = 1e-6;

/// The first line of `excerpt` that is not in `printed` in its turn. A line `...` skips lines, a word
/// `...` skips the rest of a line; other lines follow each other closely.
pub fn missing(excerpt: &str, printed: &str) -> Option<String> {
    let printed: Vec<&str> = printed.lines().collect();
    let (mut next, mut skips) = (0, true);
    for wanted in excerpt.lines() {
        if wanted.trim() == "..." || wanted.trim().is_empty() {
            skips = true;
            continue;
        }
        let from = next;
        let to = if skips {
            printed.len()
        } else {
            printed.len().min(next + 1)
        };
        match (from..to).find(|i| same(wanted, printed[*i])) {
            Some(found) => next = found + 1,
            None => return Some(wanted.to_string()),
        }
        skips = false;
    }
    None
}

fn same(wanted: &str, printed: &str) -> bool {
    let mut printed = printed.split_whitespace();
    for wanted in wanted.split_whitespace() {
        if wanted == "..." {
            return true;
        }
        if !printed.next().is_some_and(|word| agree(wanted, word)) {
            return false;
        }
    }
    printed.next().is_none()
}

/// The same word, or nearly the same number with the same signs about it.
fn agree(wanted: &str, printed: &str) -> bool {
    if wanted == printed {
        return true;
    }
    let sign = |c: char| "[](),;:*+%".contains(c);
    let bare = |word: &str| word.trim_matches(sign).parse::<f64>();
    let about = |word: &str| -> String { word.chars().filter(|c| sign(*c)).collect() };
    match (bare(wanted), bare(printed)) {
        (Ok(a), Ok(b)) if about(wanted) == about(printed) => {
            let small = a.abs() < ROUNDING && b.abs() < ROUNDING;
            small || (a - b).abs() <= SHARE * a.abs().max(b.abs())
        }
        _ => false,
    }
}

#[test]
fn excerpts_are_compared_word_by_word() {
    let printed = "head\n\n  load  65.00 kip\n  error  2.6e-12\n  x (1.002, 3)\nend\n";
    assert_eq!(
        missing("load 65.01 kip\nerror 1e-11\n...\nend", printed),
        None
    );
    assert_eq!(missing("load ...", printed), None);
    assert_eq!(missing("x (1.000, 3)", printed), None);
    for wrong in ["load 70 kip", "load 65.00", "load 65 kip\nend", "end\nhead"] {
        assert!(missing(wrong, printed).is_some(), "{wrong}");
    }
}
