//! A roller on a block, turned about three axes: every claimed figure and its error are those of the scene along the axes.

use brinell::answer::certify::Quantity;
use brinell::ground::geometry::Vec3;
use brinell::prelude::{
    Block, Contact, Cylinder, Grading, Scene, SceneBuilder, Solved, Steel, uniform,
};

const RADIUS: f64 = 10.0;
const FINE: f64 = 0.4;
const PRESS: f64 = -0.01;

/// Along z, pressed down y by its cut surface, which is held.
fn along_axes() -> Scene {
    let steel = || Steel::elastic(210e3, 0.3);
    let grown = || Grading::new(FINE / 4.0, FINE, 0.4 * RADIUS, 1.5).nodes(1);
    let both = (grown().iter().rev().map(|x| -x))
        .chain(grown().iter().skip(1).copied())
        .collect();
    let deep = grown().iter().rev().map(|y| -y).collect();
    let length = || uniform(0.0, 6.0, 6);
    SceneBuilder::new("turned")
        .body(
            Cylinder::half("roller", RADIUS, 6.0)
                .layers(6)
                .fine(FINE / 4.0, FINE),
            steel(),
        )
        .body(Block::new("block", both, deep, length()), steel())
        .contact(Contact::between("roller_contact", "block_y_max").named("contact"))
        .fix("block_y_min")
        .displace("roller_top", [Some(0.0), Some(PRESS), Some(0.0)])
        .build()
        .expect("a scene")
}

/// The same, turned about z, then y, then x.
fn turned([about_x, about_y, about_z]: [f64; 3]) -> Scene {
    let in_plane = |v: Vec3, (i, j): (usize, usize), angle: f64| {
        let (sin, cos) = angle.sin_cos();
        let mut turned = v;
        turned[i] = cos * v[i] - sin * v[j];
        turned[j] = sin * v[i] + cos * v[j];
        turned
    };
    let turn = |v: Vec3| {
        let v = in_plane(v, (0, 1), about_z);
        let v = in_plane(v, (2, 0), about_y);
        in_plane(v, (1, 2), about_x)
    };
    let mut scene = along_axes();
    scene.mesh.points.iter_mut().for_each(|p| *p = turn(*p));
    for support in &mut scene.supports {
        let moved = turn(support.components.map(|u| u.expect("held all ways")));
        support.components = moved.map(Some);
    }
    scene
}

#[test]
fn figures_and_errors_are_those_along_the_axes() {
    let figures = |scene: Scene| Solved::of(scene).expect("converges").answer.certificate;
    let before = figures(along_axes());
    for what in [
        Quantity::LineLoad,
        Quantity::HertzPressure,
        Quantity::HalfWidth,
    ] {
        assert!(
            before.iter().any(|figure| figure.what == what),
            "{}",
            what.name()
        );
    }
    for angles in [[0.0, 0.4, 0.0], [0.3, -0.5, 1.1]] {
        let after = figures(turned(angles));
        assert_eq!(before.len(), after.len());
        for (a, b) in before.iter().zip(&after) {
            let same = |a: f64, b: f64| (a - b).abs() <= 1e-6 * a.abs();
            assert_eq!(a.what, b.what);
            assert!(
                same(a.value, b.value),
                "{}: {} and {}",
                a.what.name(),
                a.value,
                b.value
            );
            let bars = a.bar().zip(b.bar());
            assert!(a.bar().is_some() == b.bar().is_some());
            assert!(
                bars.is_none_or(|(a, b)| same(a, b)),
                "{}: {bars:?}",
                a.what.name()
            );
        }
    }
}
