//! A sphere on a rigid flat.

use super::bumps::{Round, bump};
use super::kit;
use super::{Claim, Extent, VerifyError};
use crate::analytic::hertz::PointContact;
use crate::analytic::subsurface::sphere::SphereField;
use crate::material::Steel;
use crate::results::recovery::recover;

pub fn claims(_: Extent) -> Result<Vec<Claim>, VerifyError> {
    const RADIUS: f64 = 50.0;
    const YOUNG: f64 = 210e3;
    const POISSON: f64 = 0.3;
    const LOAD: f64 = 1000.0;
    let hertz = PointContact::new(LOAD, RADIUS, (1.0 - POISSON * POISSON) / YOUNG)?;
    let a = hertz.contact_radius;
    let h = a / 7.0;
    let mesh = bump(
        "sphere",
        Round::Sphere(RADIUS),
        [h; 3],
        [1.15 * a, 1.15 * a, 0.8 * a],
        [12.0 * a; 3],
        1.35,
    )?;
    let mut scene = kit::scene("sphere", mesh, Steel::elastic(YOUNG, POISSON));
    scene.contacts = vec![kit::on_rigid_flat("z_min", 2)];
    scene.supports = vec![kit::held("x_min", 0), kit::held("y_min", 1)];
    scene.rigid_planes = vec![kit::driven("press", "z_max", 2, -0.25 * LOAD)];
    scene.mirrors = vec![0, 1];
    let run = kit::run(scene)?;
    let field = &run.state().contacts[0];
    let pressure = field.pressure.iter().copied().fold(0.0, f64::max);
    // The mean stress of the elements on the axis against the field at their centres.
    let exact = SphereField::below(&hertz, POISSON)?;
    let recovered = recover(&run.scene.mesh, run.state());
    let deep = exact.peak_mises_on_axis();
    let nodal = recovered.mises_nodal.iter().copied().fold(0.0, f64::max);
    // ∫ p r² = (2/5) a² ∫ p for a half ellipsoid.
    let (mut force, mut second) = (0.0, 0.0);
    for ((node, p), area) in field.nodes.iter().zip(&field.pressure).zip(&field.area) {
        let x = run.scene.mesh.points[*node as usize];
        force += p * area;
        second += p * area * (x[0] * x[0] + x[1] * x[1]);
    }
    let radius = (2.5 * second / force).sqrt();
    Ok(vec![
        run.claim(
            Claim::relative(
                "sphere on a rigid flat, h/a = 1/7: p0, MPa",
                pressure,
                hertz.peak_pressure,
                0.01,
            )
            .from("Hertz; Johnson 3.42")
            .because("(h/a)² is 2 %, of which the weighted nodal pressure sees a part"),
        ),
        run.claim(
            Claim::relative(
                "contact radius by the second moment of p, mm",
                radius,
                a,
                0.02,
            )
            .from("Hertz; Johnson 3.42")
            .because("h/a = 1/7, lumped second moment at the rim"),
        ),
        run.claim(
            Claim::relative(
                "peak nodal Mises below the surface, MPa",
                nodal,
                deep.value,
                0.03,
            )
            .from("Johnson 3.45")
            .because("nodal averages of a peak that is 0.5 a deep err by some (h/a)²"),
        ),
    ])
}
