//! A study made up for tests.

use super::cost::Cost;
use super::quantity::{Known, StudyQuantity};
use super::study::{Study, StudyLevel};

/// Three levels of an energy that converges with order 2 and of a pressure that wanders.
pub fn study() -> Study {
    let mut study = Study::new("trial", "halved".into());
    for level in 0..3usize {
        let size = 0.5f64.powi(level as i32);
        let quantity = |name: &str, value: f64, known: Option<f64>| StudyQuantity {
            name: name.into(),
            unit: "ksi".into(),
            value,
            known: known.map(|value| Known {
                value,
                within: 0.0,
                origin: "made up",
            }),
            at_singular_edge: name == "pressure",
        };
        let quantities = vec![
            quantity("energy", 2.0 + size * size, None),
            quantity("pressure", [3.0, 5.0, 4.0][level], None),
            quantity("stress", 10.0 + size, Some(10.0)),
        ];
        let made = StudyLevel {
            level,
            element: "bbar",
            mesh: format!("mesh {level}"),
            size,
            elements: 8usize.pow(level as u32),
            dofs: 24 * 8usize.pow(level as u32),
            iterations: 3,
            factorisations: 1,
            cost: Cost {
                wall_s: 0.1,
                cpu_s: 0.1 * 8f64.powi(level as i32),
                peak_memory_bytes: Some(1 << 20),
                peak_is_own: true,
            },
            values: Vec::new(),
        };
        study.push(made, quantities);
    }
    study
}
