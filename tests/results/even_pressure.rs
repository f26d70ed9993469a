//! Largest pressures that fall to no neighbour: their bars know what is wrong elsewhere.

use brinell::answer::certify::Quantity;
use brinell::prelude::*;

/// Value and bar of the largest pressure in the middle of a face.
fn pressure(scene: Scene, contact: &str) -> [f64; 2] {
    let answer = Solved::of(scene).unwrap().answer;
    let claim = [Quantity::PressureAway, Quantity::PeakPressure]
        .iter()
        .find_map(|what| answer.figure(*what, contact));
    let claim = claim.unwrap();
    [claim.value, claim.bar().unwrap()]
}

/// A layer 2 mm thick and 100 wide that sticks to a plane and to a plate, pressed by 10 MPa in the mean; ν = 0.45. Its sides
/// bulge, so that the middle carries more. Source: own meshes with one, two and four elements in a millimetre in a series in h²,
/// 10.2193, 10.2529 and 10.2637, which tends to 10.269; a program of biquadratic elements found 10.2697.
#[test]
fn an_even_pressure_has_the_error_of_the_sides_of_its_layer() {
    for cells in [1, 2, 4] {
        let layer = Block::new(
            "layer",
            uniform(0.0, 50.0, 50 * cells),
            uniform(0.0, 1.0, 1),
            uniform(0.0, 2.0, 2 * cells),
        );
        let held = PlaneMotion::Held(0.0);
        let plate = [held, held, PlaneMotion::Driven(-500.0)];
        let plane = Contact::on_plane("layer_z_min", [0.0; 3], [0.0, 0.0, 1.0]);
        let scene = SceneBuilder::new("layer")
            .body(layer, Steel::elastic(100e3, 0.45))
            .contact(plane.named("plane").friction(1.0))
            .load(Load::plane("layer_z_max", plate))
            .mirror(Axis::X)
            .plane_strain(Axis::Y)
            .build()
            .unwrap();
        let [value, bar] = pressure(scene, "plane");
        let off = (value - 10.2697).abs();
        assert!(off <= bar && bar < 0.01 * value, "{cells}: {value} ± {bar}");
    }
}
