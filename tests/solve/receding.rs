//! A plate that a punch presses on a foundation, and that lifts off beside it: contact ends where the gap opens at once, with
//! nothing round about either side.

use brinell::answer::results::interface::interfaces;
use brinell::model::scene::Scene;
use brinell::model::state::State;
use brinell::prelude::{Axis, Block, Contact, Load, SceneBuilder, Steel, uniform};
use brinell::solver::solve::{Silent, solve};

/// mm: the punch over half of its width, and the plate's thickness.
const PUNCH: f64 = 1.0;
/// N/mm of the half that is modelled.
const LOAD: f64 = 100.0;

/// The plate with `per_thickness` elements through it and elements twice as long, or longer by `stretch` beyond 2 mm; its answer.
fn lifted(per_thickness: usize, stretch: usize) -> (Scene, State) {
    let steel = |modulus| Steel::elastic(modulus, 0.3);
    let size = 0.5 * PUNCH / per_thickness as f64;
    let near = uniform(0.0, 2.0, (2.0 / size).round() as usize);
    let far = uniform(2.0, 8.0, (6.0 / size).round() as usize / stretch);
    let along: Vec<f64> = near.iter().chain(far.iter().skip(1)).copied().collect();
    let one = || uniform(0.0, 1.0, 1);
    let under = near.iter().copied().filter(|x| *x <= PUNCH).collect();
    let mut scene = SceneBuilder::new("receding")
        .body(
            Block::new("punch", under, uniform(0.0, 1.0, per_thickness), one()),
            steel(210e3),
        )
        .body(
            Block::new(
                "plate",
                along.clone(),
                uniform(-1.0, 0.0, per_thickness),
                one(),
            ),
            steel(70e3),
        )
        .body(
            Block::new(
                "foundation",
                along,
                uniform(-4.0, -1.0, 3 * per_thickness),
                one(),
            ),
            steel(20e3),
        )
        .contact(Contact::between("punch_y_min", "plate_y_max").named("load"))
        .contact(Contact::between("plate_y_min", "foundation_y_max").named("lift"))
        .fix("foundation_y_min")
        .load(Load::press("punch_y_max", Axis::Y, -LOAD))
        .mirror(Axis::X)
        .plane_strain(Axis::Z)
        .build()
        .unwrap();
    let state = solve(&mut scene, &mut Silent).expect("converges").last;
    (scene, state)
}

#[test]
fn what_opens_beyond_the_rim_explains_what_overlaps_before_it() {
    let mut before = f64::INFINITY;
    for (per_thickness, stretch) in [(2, 1), (2, 3), (4, 1), (8, 1)] {
        let (scene, state) = lifted(per_thickness, stretch);
        let contacts = interfaces(&scene, &state);
        let lift = contacts.iter().find(|c| c.name == "lift").expect("a pair");
        let (rim, beyond) = (lift.rim_penetration, lift.unexplained_penetration);
        assert!(rim > 0.0);
        assert!(beyond < 1e-9 * PUNCH, "{per_thickness}: {beyond:e}");
        if stretch == 1 {
            assert!(rim < before, "{per_thickness}: {rim:e} of {before:e}");
            before = rim;
        }
    }
}
