//! A ball that presses with one node alone.

use brinell::answer::certify::Quantity;
use brinell::prelude::{Axis, Block, Contact, Load, SceneBuilder, Side, Solved, Steel, uniform};

/// mm.
const RADIUS: f64 = 10.0;

/// Of one node its area is read, and nothing of the patch, which is far smaller: 7.3 ± 0.8 MPa were claimed where it is 1370 (Johnson,
/// Contact Mechanics, (4.24)). Neither a pressure nor the stress below it is.
#[test]
fn nothing_is_claimed_of_a_patch_that_one_node_reads() {
    let cap = |[x, y, z]: [f64; 3]| {
        let bottom = RADIUS - (RADIUS * RADIUS - x * x - y * y).sqrt();
        [x, y, bottom + z * (RADIUS - bottom) / RADIUS]
    };
    let side = |half: f64, count| uniform(-half, half, count);
    let ball = Block::new("ball", side(2.0, 4), side(2.0, 4), uniform(0.0, RADIUS, 3)).mapped(cap);
    let plate = Block::new("plate", side(3.0, 2), side(3.0, 2), uniform(-4.0, 0.0, 2));
    let scene = SceneBuilder::new("ball")
        .body(ball, Steel::elastic(210e3, 0.3))
        .body(plate, Steel::elastic(210e3, 0.3))
        .contact(
            Contact::between("ball_z_min", "plate_z_max")
                .named("touch")
                .carried_by(Side::Lower),
        )
        .fix("plate_z_min")
        .load(Load::press("ball_z_max", Axis::Z, -100.0))
        .build()
        .expect("a scene");
    let solved = Solved::of(scene).expect("converges");
    let pressed = solved.interface("touch").expect("a contact").status_counts;
    assert_eq!(pressed.stick + pressed.slip, 1, "{pressed:?}");
    for (what, place) in [
        (Quantity::PeakPressure, "touch"),
        (Quantity::PeakMises, "ball"),
    ] {
        let figure = solved.figure(what, place).expect("a figure");
        assert!(!figure.is_resolved(), "{}: {figure:?}", what.name());
    }
}
