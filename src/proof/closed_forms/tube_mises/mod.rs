//! The yielding tube by Mises' criterion for any ν: no closed form exists, so solve the one
//! radial equation of equilibrium numerically, independent of the rest of the program.
//!
//! Quadratic elements over the wall, two Gauss points each, radial return in plane strain,
//! Newton's method in equal steps of pressure.

mod banded;
mod law;

use banded::Banded;
use law::{LawResponse, MisesLaw, PlasticState};

use crate::analytic::error::{self, DomainError};
use crate::proof::closed_forms::tube::Tube;

/// Elements across the wall.
const ELEMENTS: usize = 100;
const NODES: usize = 2 * ELEMENTS + 1;
const ITERATIONS: usize = 40;

/// Displacements of a yielding tube.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Expansion {
    /// Outward displacement of the inner wall.
    pub inner: f64,
    /// Outward displacement of the outer wall.
    pub outer: f64,
    /// Largest radius with plastic strain (at an integration point); the inner radius, where none.
    pub front: f64,
}

/// Expansion of `tube` under a pressure that rises from zero to `pressure` in `steps` equal steps.
///
/// `poissons_ratio` in (-1, 0.4999]; Mises with the tube's hardening. The error falls with the
/// step. Inner displacement without hardening, b = 2a, ν = 0.3: with 50 steps 3e-4 at 95 % of the
/// limit pressure and 1.3e-3 at 99 %, with 400 steps 4e-5 and 1.5e-4.
///
/// # Errors
/// [`DomainError::OutOfRange`] for a pressure not positive, or not below the limit pressure of a
/// steel without hardening, ν out of range or no steps; [`DomainError::NotConverged`].
pub fn expand(
    tube: &Tube,
    poissons_ratio: f64,
    pressure: f64,
    steps: usize,
) -> Result<Expansion, DomainError> {
    let nu = error::poissons_ratio(poissons_ratio)?;
    error::require("Poisson's ratio", nu, nu <= 0.4999, "at most 0.4999 here")?;
    let p = error::positive("pressure", pressure)?;
    let steel = tube.steel();
    let limit = tube.limit_pressure();
    let carries = steel.hardening_modulus() > 0.0 || p < limit;
    error::require(
        "pressure",
        p,
        carries,
        format!("below the limit pressure, {limit}"),
    )?;
    error::require("number of steps", steps as f64, steps > 0, "at least one")?;
    let e = steel.youngs_modulus();
    let law = MisesLaw {
        bulk: e / (3.0 - 6.0 * nu),
        shear: 0.5 * e / (1.0 + nu),
        yield_stress: steel.yield_stress(),
        hardening: steel.hardening_modulus(),
    };
    let wall = Wall::new(tube);
    let mut displacement = vec![0.0; NODES];
    let mut plastic = vec![[PlasticState::default(); 2]; ELEMENTS];
    for step in 1..=steps {
        wall.advance(
            &law,
            p * step as f64 / steps as f64,
            &mut displacement,
            &mut plastic,
        )?;
    }
    let yielded = |i: usize, k: usize| (plastic[i][k].size > 0.0).then(|| wall.radius(i, GAUSS[k]));
    let reached = (0..ELEMENTS)
        .flat_map(|i| [yielded(i, 0), yielded(i, 1)])
        .flatten();
    Ok(Expansion {
        inner: displacement[0],
        outer: displacement[NODES - 1],
        front: reached.fold(wall.inner, f64::max),
    })
}

/// Two-point Gauss rule on [-1, 1], weights one.
const GAUSS: [f64; 2] = [-0.577_350_269_189_625_8, 0.577_350_269_189_625_8];

/// Shape functions of the quadratic element and their derivatives at ξ.
fn shape(xi: f64) -> [[f64; 2]; 3] {
    [
        [0.5 * xi * (xi - 1.0), xi - 0.5],
        [1.0 - xi * xi, -2.0 * xi],
        [0.5 * xi * (xi + 1.0), xi + 0.5],
    ]
}

/// The wall, cut into elements of equal thickness.
struct Wall {
    inner: f64,
    thickness: f64,
}

impl Wall {
    fn new(tube: &Tube) -> Self {
        let wall = tube.outer_radius() - tube.inner_radius();
        Self {
            inner: tube.inner_radius(),
            thickness: wall / ELEMENTS as f64,
        }
    }

    fn radius(&self, element: usize, xi: f64) -> f64 {
        self.inner + self.thickness * (element as f64 + 0.5 * (1.0 + xi))
    }

    /// Newton's method for one step: changes the displacements and the plastic strains.
    fn advance(
        &self,
        law: &MisesLaw,
        pressure: f64,
        displacement: &mut [f64],
        plastic: &mut [[PlasticState; 2]],
    ) -> Result<(), DomainError> {
        let scale = pressure * self.inner;
        for _ in 0..ITERATIONS {
            let mut system = Banded::new(NODES);
            let mut next = plastic.to_vec();
            for (i, points) in next.iter_mut().enumerate() {
                self.add_element(law, i, displacement, points, &mut system);
            }
            system.right[0] += scale;
            let residual = system.right.iter().fold(0.0, |m: f64, r| m.max(r.abs()));
            // Near ν = 0.5 the bulk modulus lifts the rounding to about 1e-11.
            if residual <= 1e-9 * scale {
                plastic.copy_from_slice(&next);
                return Ok(());
            }
            for (u, change) in displacement.iter_mut().zip(system.solve()) {
                *u += change;
            }
        }
        Err(DomainError::NotConverged {
            quantity: "expansion of the tube",
            iterations: ITERATIONS,
        })
    }

    /// Adds stiffness and negative internal force of element `i`; `points` holds the old plastic
    /// state and receives the new one.
    fn add_element(
        &self,
        law: &MisesLaw,
        i: usize,
        displacement: &[f64],
        points: &mut [PlasticState; 2],
        system: &mut Banded,
    ) {
        for (point, xi) in points.iter_mut().zip(GAUSS) {
            let r = self.radius(i, xi);
            let weight = 0.5 * self.thickness * r;
            // Radial and hoop strain that each node's displacement makes.
            let rows = shape(xi).map(|[value, slope]| [2.0 * slope / self.thickness, value / r]);
            let mut strain = [0.0; 2];
            for (row, u) in rows.iter().zip(&displacement[2 * i..]) {
                strain = [strain[0] + row[0] * u, strain[1] + row[1] * u];
            }
            let LawResponse {
                stress,
                tangent,
                plastic,
            } = law.respond(strain, point);
            *point = plastic;
            for (j, row) in rows.iter().enumerate() {
                system.right[2 * i + j] -= weight * (row[0] * stress[0] + row[1] * stress[1]);
                let pull = [0, 1].map(|k| row[0] * tangent[0][k] + row[1] * tangent[1][k]);
                for (k, other) in rows.iter().enumerate().take(j + 1) {
                    system.diagonals[j - k][2 * i + k] +=
                        weight * (pull[0] * other[0] + pull[1] * other[1]);
                }
            }
        }
    }
}
