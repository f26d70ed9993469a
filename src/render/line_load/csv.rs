//! Line loads as comma-separated values.

use super::WholeLine;
use crate::ground::units::UnitLabels;
use crate::render::text::shown;
use std::fmt::Write;

/// One row for each row of nodes of each line, in full precision, under a line of headings with
/// units. A line is told from others of its interface by its place across.
pub fn csv(lines: &[WholeLine], units: &UnitLabels) -> String {
    let (length, load) = (&units.length, units.line_load());
    let mut text =
        format!("interface,axis,line across at [{length}],along [{length}],line load [{load}]\n");
    for line in lines {
        let interface = field(line.interface);
        for (along, load) in &line.rows {
            let (axis, across) = (field(line.axis), line.across);
            // Writing to a string cannot fail.
            let _ = writeln!(text, "{interface},{axis},{across},{along},{load}");
        }
    }
    text
}

/// A text as one field (RFC 4180).
fn field(text: &str) -> String {
    let text = shown(text);
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.into_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_with_commas_stay_one_field() {
        let line = WholeLine {
            interface: "a \"b\", c",
            axis: "(0.6000, 0.8000, 0.0000)",
            across_axis: "(0.8000, -0.6000, 0.0000)",
            across: -0.5,
            rows: vec![(0.1, 1.0 / 3.0)],
            mean: 1.0,
        };
        let text = csv(&[line], &UnitLabels::new("in", "kip", "ksi"));
        let expected = "interface,axis,line across at [in],along [in],line load [kip/in]\n\
                        \"a \"\"b\"\", c\",\"(0.6000, 0.8000, 0.0000)\",-0.5,0.1,0.3333333333333333\n";
        assert_eq!(text, expected);
    }
}
