//! What the study prints beside what is computed.

use super::cells::{cell, printed};
use super::member::SolvedMember;
use super::quantities::ROWS;
use crate::ground::markdown;
use crate::render::Summary;
use crate::render::text::significant;

/// One line a printed value.
pub fn table(solved: &[SolvedMember]) -> String {
    let headings = [
        "case",
        "Mises stress of",
        "printed, ksi",
        "report-like mesh, centroid",
        "report-like mesh, nodal",
        "resolved mesh, centroid",
        "resolved mesh, nodal",
        "resolved, elastic, away from edges",
        "largest plastic strain, %",
        "Hertz, even load",
    ];
    let mut rows = Vec::new();
    for case in solved {
        let (Some(coarse), Some(fine)) = (&case.report_like, case.finest()) else {
            continue;
        };
        for row in &fine.comparison {
            let Some(report) = printed(row) else { continue };
            let bodies = match row.place.as_str() {
                "rollers" => "rollers",
                _ => "overall",
            };
            let read = |name: &str, of: &Summary| {
                let row = ROWS.iter().find(|row| row.name == name);
                cell(row.and_then(|row| (row.read)(of)))
            };
            let [centroid, nodal] =
                ["centroid", "nodal"].map(|r| format!("Mises, {r}, {bodies}, ksi"));
            rows.push([
                case.name.to_owned(),
                bodies.to_owned(),
                significant(report, 3),
                read(&centroid, coarse),
                read(&nodal, coarse),
                read(&centroid, fine),
                read(&nodal, fine),
                read("Mises away from loaded edges, elastic, ksi", fine),
                read("largest plastic strain, %", fine),
                row.hertz
                    .map_or_else(|| "-".to_owned(), |h| significant(h, 4)),
            ]);
        }
    }
    markdown::table(headings, rows)
}
