//! The largest Mises stress below strips that a mesh has one or two nodes for in a half-width.

use brinell::analytic::subsurface::LineField;
use brinell::prelude::*;

const RADIUS: f64 = 20.0;
const LOAD: f64 = 1500.0;

/// The claim of the block, in N/mm² over McEwen's (Johnson, Contact Mechanics, 4.49), with its error, and its nodal peak.
fn below(nodes_in_half_width: f64) -> [f64; 3] {
    let elastic = Elastic::new(210e3, 0.3).unwrap();
    let compliance = contact_compliance(elastic, elastic).unwrap();
    let hertz = LineContact::new(LOAD, RADIUS, compliance).unwrap();
    let a = hertz.half_width;
    let size = a / nodes_in_half_width;
    let steel = || Steel::elastic(210e3, 0.3);
    let wide = Grading::new(size, 1.5 * a, 8.0 * RADIUS, 1.4).nodes(1);
    let deep = wide.iter().rev().map(|y| -y).collect();
    let roller = Cylinder::quarter("roller", RADIUS, a).fine(size, 1.5 * a);
    let scene = SceneBuilder::new("coarse strip")
        .body(roller, steel())
        .body(Block::new("block", wide, deep, uniform(0.0, a, 1)), steel())
        .contact(Contact::between("roller_contact", "block_y_max"))
        .fix("block_y_min")
        .load(Load::pressure("roller_top", LOAD / (2.0 * RADIUS)))
        .mirror(Axis::X)
        .plane_strain(Axis::Z);
    let answer = Solved::of(scene.build().unwrap()).unwrap();
    let true_value = LineField::below(&hertz, 0.3).unwrap().peak_mises().value;
    let claim = answer.figure(Quantity::PeakMises, "block").unwrap();
    let body = answer.body("block").unwrap();
    let nodal = body.mises_max.nodal.unwrap();
    [claim.value, claim.bar().unwrap_or(f64::INFINITY), nodal].map(|s| s / true_value)
}

#[test]
fn half_spaces_tell_the_stress_that_a_few_nodes_do_not() {
    for nodes in [1.2, 1.5, 2.0, 2.5] {
        let [value, bar, nodal] = below(nodes);
        assert!((value - 1.0).abs() <= bar, "{nodes}: {value} ± {bar}");
        assert!(bar < 0.1, "{nodes}: {value} ± {bar}, nodal {nodal}");
    }
}
