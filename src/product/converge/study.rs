//! The levels of a study, and how each quantity approaches its reference.

use super::cost::Cost;
use super::quantity::{Known, StudyQuantity};
use super::rates::{between, fitted, richardson};
use crate::model::scene::ElementKind;
use serde::Serialize;

/// One mesh, solved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StudyLevel {
    pub level: usize,
    pub element: &'static str,
    pub mesh: String,
    /// Element size, relative to that of level 0.
    pub size: f64,
    pub elements: usize,
    pub dofs: usize,
    pub iterations: usize,
    pub factorisations: usize,
    #[serde(flatten)]
    pub cost: Cost,
    /// In the order of [`Study::quantities`]; not a number where the level does not have one.
    pub values: Vec<f64>,
}

/// What a quantity is: its name, unit and, where it is known, its exact value.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StudiedQuantity {
    pub name: String,
    pub unit: String,
    pub known: Option<Known>,
    /// On one level at least, a peak beside a loaded edge, which grows with every refinement.
    pub at_singular_edge: bool,
}

/// What errors are measured from.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Reference {
    /// A value from elsewhere.
    Known {
        value: f64,
        within: f64,
        origin: &'static str,
    },
    /// Richardson's extrapolation of the three finest levels.
    Extrapolated { value: f64, order: f64 },
    /// The finest level, whose own error is then not known.
    Finest { value: f64 },
}

impl Reference {
    pub fn value(&self) -> f64 {
        match self {
            Self::Known { value, .. }
            | Self::Extrapolated { value, .. }
            | Self::Finest { value } => *value,
        }
    }
}

/// One quantity with one element over the levels.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Curve {
    pub quantity: String,
    pub unit: String,
    pub element: &'static str,
    /// Is it, on one level at least, a peak beside a loaded edge, which grows with every refinement?
    pub at_singular_edge: bool,
    pub reference: Option<Reference>,
    /// Limit and order of the three finest levels, whatever the reference is.
    pub extrapolated: Option<[f64; 2]>,
    pub sizes: Vec<f64>,
    pub values: Vec<f64>,
    /// (value − reference) / |reference|, or the value itself where the reference is zero; `None`
    /// where the level is the reference.
    pub errors: Vec<Option<f64>>,
    /// Observed orders: where the reference is exact, from the errors of this level and the one
    /// before; else from the differences between three levels, which need no reference.
    pub orders: Vec<Option<f64>>,
    /// Over the three finest levels: by least squares where the reference is exact, else that of
    /// the extrapolation. `None` where there is no clean order.
    pub order: Option<f64>,
}

/// A case on a series of meshes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Study {
    pub case: String,
    /// In words: how the meshes of the series follow from one another.
    pub series: String,
    pub threads: usize,
    pub quantities: Vec<StudiedQuantity>,
    pub levels: Vec<StudyLevel>,
}

/// As in case files.
pub fn element_name(element: ElementKind) -> &'static str {
    match element {
        ElementKind::Bbar => "bbar",
        ElementKind::Full => "full",
        ElementKind::Enhanced => "enhanced",
    }
}

impl Study {
    pub fn new(case: &str, series: String) -> Self {
        Self {
            case: case.to_owned(),
            series,
            threads: rayon::current_num_threads(),
            quantities: Vec::new(),
            levels: Vec::new(),
        }
    }

    /// Adds a level. Its quantities are matched by name with those of the levels before.
    pub fn push(&mut self, mut level: StudyLevel, quantities: Vec<StudyQuantity>) {
        for q in &quantities {
            if !self.quantities.iter().any(|m| m.name == q.name) {
                self.quantities.push(StudiedQuantity {
                    name: q.name.clone(),
                    unit: q.unit.clone(),
                    known: q.known.clone(),
                    at_singular_edge: false,
                });
                for earlier in &mut self.levels {
                    earlier.values.push(f64::NAN);
                }
            }
        }
        let value = |name: &str| quantities.iter().find(|q| q.name == name);
        for measured in &mut self.quantities {
            measured.at_singular_edge |= value(&measured.name).is_some_and(|q| q.at_singular_edge);
        }
        level.values = self
            .quantities
            .iter()
            .map(|m| value(&m.name).map_or(f64::NAN, |q| q.value))
            .collect();
        self.levels.push(level);
    }

    /// The elements of the study, in the order they came.
    pub fn elements(&self) -> Vec<&'static str> {
        let mut names = Vec::new();
        for level in &self.levels {
            if !names.contains(&level.element) {
                names.push(level.element);
            }
        }
        names
    }

    /// The levels solved with `element`, coarse to fine.
    pub fn levels_of(&self, element: &str) -> Vec<&StudyLevel> {
        let of = self.levels.iter().filter(|l| l.element == element);
        of.collect()
    }

    /// Every quantity with every element.
    pub fn curves(&self) -> Vec<Curve> {
        let elements = self.elements();
        let quantities = self.quantities.iter().enumerate();
        quantities
            .flat_map(|(i, _)| elements.iter().map(move |e| self.curve(i, e)))
            .collect()
    }

    fn curve(&self, quantity: usize, element: &'static str) -> Curve {
        let measured = &self.quantities[quantity];
        let levels = self.levels_of(element);
        let sizes: Vec<f64> = levels.iter().map(|l| l.size).collect();
        let values: Vec<f64> = levels.iter().map(|l| l.values[quantity]).collect();
        // Of the first levels, so many.
        let limit_of = |levels: usize| {
            let three = last_three(&sizes[..levels]).zip(last_three(&values[..levels]));
            three.and_then(|(sizes, values)| richardson(sizes, values))
        };
        // Beside a singular edge elastic stress has no limit.
        let limit = limit_of(sizes.len()).filter(|_| !measured.at_singular_edge);
        let reference = match (&measured.known, limit) {
            (Some(known), _) => Some(Reference::Known {
                value: known.value,
                within: known.within,
                origin: known.origin,
            }),
            (None, Some(limit)) => Some(Reference::Extrapolated {
                value: limit.value,
                order: limit.order,
            }),
            (None, None) => values
                .last()
                .filter(|v| v.is_finite() && values.len() > 1)
                .map(|value| Reference::Finest { value: *value }),
        };
        let errors = errors(&values, reference.as_ref());
        let exact = matches!(reference, Some(Reference::Known { within, .. }) if within == 0.0);
        let from_errors = |i: usize| {
            let [before, now] = [*errors.get(i.checked_sub(1)?)?, errors[i]];
            between([sizes[i - 1], sizes[i]], [before?, now?])
        };
        let from_differences = |i: usize| limit_of(i + 1).map(|limit| limit.order);
        let orders = (0..errors.len())
            .map(|i| {
                if exact {
                    from_errors(i)
                } else {
                    from_differences(i)
                }
            })
            .collect();
        let with_error = sizes.iter().zip(&errors);
        let points: Vec<(f64, f64)> = with_error.filter_map(|(s, e)| Some((*s, (*e)?))).collect();
        let by_squares = fitted(&points[points.len().saturating_sub(3)..]);
        Curve {
            quantity: measured.name.clone(),
            unit: measured.unit.clone(),
            element,
            at_singular_edge: measured.at_singular_edge,
            extrapolated: limit.map(|l| [l.value, l.order]),
            order: if exact {
                by_squares
            } else {
                limit.map(|l| l.order)
            },
            reference,
            sizes,
            values,
            errors,
            orders,
        }
    }
}

fn errors(values: &[f64], reference: Option<&Reference>) -> Vec<Option<f64>> {
    let Some(reference) = reference else {
        return vec![None; values.len()];
    };
    let exact = reference.value();
    let scale = if exact == 0.0 { 1.0 } else { exact.abs() };
    let own = matches!(reference, Reference::Finest { .. });
    let error = |(i, value): (usize, &f64)| {
        let is_reference = own && i + 1 == values.len();
        let error = (value - exact) / scale;
        (error.is_finite() && !is_reference).then_some(error)
    };
    values.iter().enumerate().map(error).collect()
}

fn last_three(list: &[f64]) -> Option<[f64; 3]> {
    list.get(list.len().checked_sub(3)?..)?.try_into().ok()
}

#[cfg(test)]
mod tests {
    use super::super::sample::study;
    use super::*;

    #[test]
    fn the_reference_is_known_extrapolated_or_the_finest() {
        let curves = study().curves();
        let [energy, pressure, stress] = &curves[..] else {
            panic!("{curves:?}")
        };
        assert!(
            matches!(energy.reference, Some(Reference::Extrapolated { value, order })
            if (value - 2.0).abs() < 1e-12 && (order - 2.0).abs() < 1e-12)
        );
        assert!((energy.errors[2].unwrap() - 1.0 / 32.0).abs() < 1e-12);
        assert_eq!(pressure.reference, Some(Reference::Finest { value: 4.0 }));
        assert!(pressure.at_singular_edge && !energy.at_singular_edge);
        assert_eq!(pressure.errors, [Some(-0.25), Some(0.25), None]);
        assert!(matches!(stress.reference, Some(Reference::Known { .. })));
        assert!((stress.order.unwrap() - 1.0).abs() < 1e-12);
        assert_eq!(stress.orders[0], None);
        assert!((stress.orders[2].unwrap() - 1.0).abs() < 1e-12);
    }
}
