//! A hollow roller squeezed by two opposed loads, in plane strain, at four thicknesses of wall.
//!
//! Reference: Michell's series of the annulus under semi-elliptic pressure of half angle 0.02, the
//! width of a Hertz contact. The model carries the same pressure, as its exact mean on each facet,
//! on a quarter of one layer.
//!
//! On the bore, stress comes from the strain of the surface with zero radial stress (what the
//! program prints as `bore_mises`); its error falls with h² and is a few thousandths with
//! sixteen layers through the wall. Nodal averages, shown beside it, are one-sided there and lose
//! an order.

mod mesh;

use crate::analytic::Elastic;
use crate::analytic::ring::{PlaneState, Ring, RingLoad};
use crate::answer::results::bore::{Bore, bore_stress};
use crate::answer::results::recovery::recover;
use crate::model::material::Steel;
use crate::model::scene::{ElementKind, Scene};
use crate::proof::verify::kit::{self, SolvedScene};
use crate::proof::verify::{Extent, LadderClaim, VerifyError};
use mesh::{LOAD, RADIUS, SPREAD, mean_pressure, mesh, strip};
use std::f64::consts::FRAC_PI_2;

const YOUNG: f64 = 29500.0;
const POISSON: f64 = 0.3;

pub fn claims(extent: Extent) -> Result<Vec<LadderClaim>, VerifyError> {
    let mut claims = Vec::new();
    for wall in [0.25, 0.167, 0.1, 0.05] {
        for kind in kit::ELEMENTS {
            claims.extend(SolvedRing::new(wall, 16, kind)?.claims()?);
        }
    }
    if extent == Extent::All {
        for layers in [4, 8, 32] {
            for kind in kit::ELEMENTS {
                claims.extend(SolvedRing::new(0.25, layers, kind)?.series()?);
            }
        }
    }
    Ok(claims)
}

/// A solved ring beside its exact solution.
struct SolvedRing {
    name: String,
    inner: f64,
    exact: Ring,
    run: SolvedScene,
}

impl SolvedRing {
    fn new(
        wall: f64,
        layers: usize,
        (element, name): (ElementKind, &str),
    ) -> Result<Self, VerifyError> {
        let inner = RADIUS * (1.0 - 2.0 * wall);
        let (mesh, angles) = mesh(inner, layers)?;
        let mut scene = Scene::bare("ring", mesh, Steel::elastic(YOUNG, POISSON));
        // Bending of a thin ring: forces are small beside stiffness times displacement.
        scene.controls.residual = 1e-7;
        scene.controls.element = element;
        scene.supports = kit::quarter_supports();
        scene.mirrors = vec![0, 1];
        scene.tractions = angles
            .windows(2)
            .enumerate()
            .map(|(k, arc)| kit::pressure(&strip(k), mean_pressure(arc[0], arc[1])))
            .collect();
        Ok(Self {
            name: format!("t/D = {wall}, {layers} layers, {name}"),
            inner,
            exact: Ring::new(
                inner,
                RADIUS,
                LOAD,
                Elastic::new(YOUNG, POISSON)?,
                PlaneState::Strain,
                RingLoad::SemiElliptic { half_angle: SPREAD },
            )?,
            run: kit::run(scene)?,
        })
    }

    fn claim(&self, what: &str, value: f64, reference: f64, tolerance: f64) -> LadderClaim {
        let claim = LadderClaim::relative(
            format!("{}: {what}", self.name),
            value,
            reference,
            tolerance,
        );
        self.run
            .claim(claim)
            .from("Michell 1899; Timoshenko and Goodier, art. 43 to 46")
    }

    fn claims(&self) -> Result<Vec<LadderClaim>, VerifyError> {
        const STRESS: &str = "strain of the bore's edges, h² with 16 layers";
        const DIAMETER: &str = "16 layers: B-bar is too stiff in bending by some (h/t)²";
        let [mises, nodal] = self.under_load()?;
        let top = self.exact.bore_stress(0.0)?.mises();
        let side = self.exact.bore_stress(FRAC_PI_2)?.hoop;
        let [vertical, pressed, horizontal] = self.diameter_changes()?;
        let inner = self.exact.diameter_change(self.inner, 0.0)?;
        let whole = self.exact.diameter_change(RADIUS, 0.0)?;
        let outer = self.exact.diameter_change(RADIUS, FRAC_PI_2)?;
        Ok(vec![
            self.claim("Mises, bore under the load", mises, top, 0.01)
                .because(STRESS),
            self.claim("the same, nodal average", nodal, top, f64::INFINITY),
            self.claim(
                "hoop stress, bore at the side",
                self.side_hoop()?,
                side,
                0.01,
            )
            .because(STRESS),
            self.claim("inner diameter along the load", vertical, inner, 0.01)
                .because(DIAMETER),
            self.claim("outer diameter along the load", pressed, whole, 0.01)
                .because(DIAMETER),
            self.claim("outer diameter across it", horizontal, outer, 0.01)
                .because(DIAMETER),
        ])
    }

    /// The bore under the load on another mesh, shown.
    fn series(&self) -> Result<[LadderClaim; 2], VerifyError> {
        let [mises, nodal] = self.under_load()?;
        let top = self.exact.bore_stress(0.0)?.mises();
        let shown = f64::INFINITY;
        Ok([
            self.claim("Mises, bore under the load", mises, top, shown),
            self.claim("the same, nodal average", nodal, top, shown),
        ])
    }

    /// Mises stress on the bore under the load: from its strain, and the largest nodal average.
    fn under_load(&self) -> Result<[f64; 2], VerifyError> {
        let bore = Bore {
            body: "ring".into(),
            surface: "x_min".into(),
            axis: 2,
            lean: 0.0,
        };
        let recovered = recover(&self.run.scene, self.run.state());
        let stress = bore_stress(&self.run.scene, self.run.state(), &recovered, &bore)
            .ok_or(VerifyError::Missing("bore"))?;
        let mises = stress.mises.ok_or(VerifyError::Missing("bore stress"))?;
        let nodal = stress.nodal.ok_or(VerifyError::Missing("nodal stress"))?;
        Ok([mises, nodal])
    }

    /// Hoop stress at the side: the edge of the bore that ends there, with zero radial stress.
    fn side_hoop(&self) -> Result<f64, VerifyError> {
        let mesh = &self.run.scene.mesh;
        let mut nodes = kit::surface(mesh, "x_min")?.nodes();
        nodes.retain(|n| mesh.points[*n as usize][2] == 0.0);
        let at = |n: &u32| mesh.points[*n as usize];
        nodes.sort_by(|a, b| at(a)[0].total_cmp(&at(b)[0]));
        let [a, b, ..] = nodes[..] else {
            return Err(VerifyError::Missing("bore"));
        };
        let moved = |n: u32| self.run.state().displacement[n as usize];
        let (edge, stretch) = ([0, 1].map(|i| at(&b)[i] - at(&a)[i]), |i: usize| {
            moved(b)[i] - moved(a)[i]
        });
        let square = edge[0] * edge[0] + edge[1] * edge[1];
        let strain = (edge[0] * stretch(0) + edge[1] * stretch(1)) / square;
        Ok(YOUNG / (1.0 - POISSON * POISSON) * strain)
    }

    /// Change of the inner and the outer diameter along the load, and of the outer across it.
    fn diameter_changes(&self) -> Result<[f64; 3], VerifyError> {
        let at = |p| kit::displacement_at(&self.run.scene.mesh, self.run.state(), p);
        let inner = at([self.inner, 0.0, 0.0])?[0];
        let (pressed, across) = (at([RADIUS, 0.0, 0.0])?[0], at([0.0, RADIUS, 0.0])?[1]);
        Ok([inner, pressed, across].map(|u| 2.0 * u))
    }
}
