//! Exponents: least squares on the logarithms, over the sizes from [`LEAST`] unknowns up.

use crate::record::{Record, Run};
use brinell::product::converge::rates;
use std::collections::BTreeSet;

/// Smaller sizes are spent on start-up and on bodies a few elements thick.
pub const LEAST: f64 = 50e3;
/// Counts of elements are whole numbers: what is meant to be the least may fall a little short.
const SHORT: f64 = 0.95;

/// What is read of a run.
type Reading = Box<dyn Fn(&Record, &Run) -> f64>;

/// Something that grows with the unknowns.
pub struct Quantity {
    pub name: String,
    /// The exponent that is to be kept.
    pub bound: Option<f64>,
    value: Reading,
}

/// The exponent of a quantity, with its value at the largest size.
pub struct Growth {
    pub name: String,
    pub bound: Option<f64>,
    pub exponent: Option<f64>,
    pub largest: f64,
}

impl Quantity {
    fn new(name: &str, bound: Option<f64>, value: fn(&Record, &Run) -> f64) -> Self {
        Self {
            name: name.into(),
            bound,
            value: Box::new(value),
        }
    }

    /// Unknowns and value of each run.
    pub fn points(&self, rows: &[Record]) -> Vec<(f64, f64)> {
        let runs = rows.iter().filter_map(|r| Some((r, r.run.as_ref().ok()?)));
        runs.map(|(row, run)| (run.unknowns, (self.value)(row, run)))
            .filter(|(_, value)| *value > 0.0)
            .collect()
    }

    pub fn growth(&self, rows: &[Record]) -> Growth {
        let mut points = self.points(rows);
        points.retain(|p| p.0 > SHORT * LEAST);
        let largest = points.iter().max_by(|a, b| a.0.total_cmp(&b.0));
        Growth {
            name: self.name.clone(),
            bound: self.bound,
            exponent: rates::fitted(&points),
            largest: largest.map_or(f64::NAN, |p| p.1),
        }
    }
}

pub fn cpu() -> Quantity {
    Quantity::new("CPU s in total", Some(1.3), |_, run| run.cpu_s)
}

pub fn cpu_per_iteration() -> Quantity {
    let value = |_: &Record, run: &Run| run.cpu_per_iteration();
    Quantity::new("CPU s of the solution a Newton iteration", Some(1.3), value)
}

pub fn memory() -> Quantity {
    Quantity::new("peak memory, MB", Some(1.2), |_, run| {
        1e-6 * run.peak_memory_bytes
    })
}

/// The phases of the runs, in seconds on the clock, and what is beside the solution.
pub fn phases(rows: &[Record]) -> Vec<Quantity> {
    let runs = || rows.iter().filter_map(|r| r.run.as_ref().ok());
    let names: BTreeSet<&String> = runs().flat_map(|run| run.phases.keys()).collect();
    let mut list: Vec<Quantity> = names
        .into_iter()
        .map(|name| {
            let key = name.clone();
            Quantity {
                name: name.replace('_', " "),
                bound: None,
                value: Box::new(move |_, run| run.phases.get(&key).copied().unwrap_or(0.0)),
            }
        })
        .collect();
    list.push(Quantity::new("rest of the solution", None, |_, run| {
        run.solve_s - run.phases.values().sum::<f64>()
    }));
    list.push(Quantity::new("reading the mesh", None, |_, r| r.mesh_s));
    list.push(Quantity::new("writing fields", None, |_, r| r.write_s));
    list.push(Quantity::new(
        "start and end of the process",
        None,
        |_, r| r.start_s,
    ));
    list
}

/// Everything that is fitted.
pub fn all(rows: &[Record]) -> Vec<Growth> {
    let counts = [
        Quantity::new("Newton iterations", None, |_, r| r.iterations),
        Quantity::new("Krylov directions", None, |_, r| r.krylov_directions),
        Quantity::new("unknowns of the Newton iterations", None, |_, r| {
            r.kept_unknowns
        }),
        Quantity::new("entries of the factors", None, |_, r| r.factor_entries),
        Quantity::new("wall s in total", None, |_, r| r.wall_s),
    ];
    let mut list = vec![cpu_per_iteration(), cpu(), memory()];
    list.extend(counts);
    list.extend(phases(rows));
    list.push(Quantity::new("meshing by gmsh", None, |row, _| {
        row.meshing_s
    }));
    list.iter().map(|q| q.growth(rows)).collect()
}
