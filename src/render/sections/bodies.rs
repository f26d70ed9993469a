//! The largest Mises stress of each body, read in three ways, and of the bores of rollers.

use crate::answer::certify::{Figure, Quantity};
use crate::answer::{Answer, BodyFigures, Three};
use crate::render::figures::{DIGITS, POSITION_DIGITS};
use crate::render::summary::Summary;
use crate::render::table::{Cell, Number, Table};

/// Largest stress and strain, where they are, and the bores.
pub fn bodies(summary: &Summary) -> Vec<Table> {
    let units = &summary.units;
    let mut stress = Table::new(format!("Largest Mises stress, {}", units.stress))
        .words("body")
        .figures(["centroid", "integration pt", "nodal", "plastic strain"])
        .figure("yielded", units.volume())
        .figures(["of body"])
        .about(
            "Centroid: of the mean of an element's integration points. Integration point: the largest at any. \
             Nodal: extrapolated to the nodes and averaged, with its estimated error.",
        );
    let mut places = Table::new(format!("Peaks at, {}", units.length))
        .words("where")
        .figures(["centroid", "integration pt", "nodal"]);
    for (name, body) in &summary.answer.bodies.0 {
        stress.row(yielding(name, body, &summary.answer));
        if let Some(elastic) = &body.elastic_mises_max {
            let error = error(&summary.answer, Quantity::ElasticPeakMises, name);
            let peaks = peaks(elastic, &body.at_singular_edge, error);
            stress.row(std::iter::once("  elastic".into()).chain(peaks));
        }
        places.row(std::iter::once(name.into()).chain(body.at.each().map(Cell::Place)));
    }
    let bodies = summary.answer.bodies.0.iter();
    if bodies
        .flat_map(|(_, body)| body.at_singular_edge.each())
        .any(|at_edge| at_edge)
    {
        stress.note("* beside a singular edge: a value of this mesh, see the warnings");
    }
    vec![stress, places, bores(summary)]
}

fn yielding(name: &String, body: &BodyFigures, answer: &Answer) -> Vec<Cell> {
    let mut row = vec![name.into()];
    let error_of = |what| error(answer, what, name);
    row.extend(peaks(
        &body.mises_max,
        &body.at_singular_edge,
        error_of(Quantity::PeakMises),
    ));
    row.extend([
        Cell::Figure(Number {
            error: error_of(Quantity::PeakPlasticStrain).filter(|_| body.peeq_max > 0.0),
            ..Number::new(body.peeq_max, POSITION_DIGITS)
        }),
        Cell::rough(body.yielded_volume),
        Cell::Share(Some(body.yielded_volume / body.volume)),
    ]);
    row
}

fn error(answer: &Answer, what: Quantity, place: &str) -> Option<f64> {
    answer.figure(what, place).and_then(Figure::bar)
}

/// The nodal reading, the last, is the one with an error.
fn peaks(values: &Three<Option<f64>>, at_edge: &Three<bool>, error: Option<f64>) -> [Cell; 3] {
    let (values, at_edge) = (values.each(), at_edge.each());
    std::array::from_fn(|k| {
        Cell::Figure(Number {
            error: error.filter(|_| k == 2),
            at_edge: at_edge[k] && values[k].is_some(),
            ..Number::new(values[k], DIGITS)
        })
    })
}

fn bores(summary: &Summary) -> Table {
    let title = format!("Mises stress at the bore, {}", summary.units.stress);
    let mut table = Table::new(title)
        .words("roller")
        .figures(["from strain", "at", "nodal", "at"]);
    for (name, roller) in &summary.answer.rollers.0 {
        table.row([
            name.into(),
            Cell::figure(roller.bore_mises),
            Cell::Place(roller.bore_mises_at),
            Cell::figure(roller.bore_mises_nodal),
            Cell::Place(roller.bore_mises_nodal_at),
        ]);
    }
    table
}
