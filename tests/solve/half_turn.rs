//! A scene that is its own image under a half turn: one half solved is as good as the whole.

use brinell::model::half_turn::{HalfTurn, NoHalfTurn};
use brinell::model::material::Steel;
use brinell::model::mesh::Mesh;
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::scene::{
    ContactPair, Controls, Partner, PlaneMotion, RigidPlane, Scene, Side, SolverKind, Step, Support,
};
use brinell::model::state::State;
use brinell::solver::solve::{Silent, Solution, solve};

/// Two bars, crossed, press a plate between them; both beside its middle. They yield, rub and are
/// unloaded.
fn crossed_bars(layers: usize) -> Scene {
    let turned = |list: Vec<f64>| list.into_iter().rev().map(|v| -v).collect::<Vec<f64>>();
    let across = || vec![-0.3, 0.0, 0.3, 0.5];
    let along = || vec![-1.0, -0.5, 0.0, 0.4, 1.0];
    let up = || vec![0.5, 0.7, 1.0];
    let plate = || vec![-1.2, -0.7, -0.3, 0.0, 0.3, 0.5, 0.8, 1.2];
    let upper = Block::new("upper", across(), along(), up());
    let middle = Block::new("middle", plate(), plate(), uniform(-0.5, 0.5, layers));
    let lower = Block::new("lower", along(), across(), turned(up()));
    let part = |block: Block, name: &str| block.build().unwrap().prefixed(name);
    let parts = [part(upper, "u_"), part(middle, "m_"), part(lower, "l_")];
    let pair = |name: &str, upper: &str, lower: &str, carrier| ContactPair {
        name: name.into(),
        upper: Partner::Surface(upper.into()),
        lower: Partner::Surface(lower.into()),
        carrier,
        friction: 0.2,
        penalty_factor: 1.0,
        true_geometry: true,
    };
    let mesh = Mesh::join(parts).unwrap();
    let steel = Steel {
        youngs_modulus: 29500.0,
        poissons_ratio: 0.3,
        yield_stress: 100.0,
        hardening_modulus: 249.471,
    };
    Scene {
        contacts: vec![
            pair("upper-middle", "u_z_min", "m_z_max", Side::Upper),
            pair("middle-lower", "m_z_min", "l_z_max", Side::Lower),
        ],
        supports: vec![Support {
            name: "bottom".into(),
            surface: "l_z_min".into(),
            components: [Some(0.0); 3],
            ..Support::default()
        }],
        rigid_planes: vec![RigidPlane {
            name: "top".into(),
            surface: "u_z_max".into(),
            motion: [
                PlaneMotion::Held(0.0),
                PlaneMotion::Held(0.0),
                PlaneMotion::Driven(-130.0),
            ],
            ..RigidPlane::default()
        }],
        steps: vec![Step::to("load", 1.0), Step::to("unload", 0.02)],
        controls: Controls {
            residual: 1e-11,
            ..Controls::default()
        },
        ..Scene::bare("crossed bars", mesh, steel)
    }
}

fn solved(scene: &Scene, half_turn: bool) -> Solution {
    let mut scene = scene.clone();
    scene.controls.half_turn = half_turn;
    let solution = solve(&mut scene, &mut Silent).expect("converges");
    assert_eq!(solution.half_turn, half_turn);
    solution
}

fn close(what: &str, ours: &[f64], theirs: &[f64], tolerance: f64) {
    assert_eq!(ours.len(), theirs.len(), "{what}");
    let size = theirs.iter().fold(0.0f64, |size, v| size.max(v.abs()));
    let apart = ours.iter().zip(theirs).map(|(a, b)| (a - b).abs());
    let apart = apart.fold(0.0, f64::max);
    assert!(
        size > 0.0 && apart <= tolerance * size,
        "{what}: {apart:e} of {size:e}"
    );
}

fn alike(half: &State, whole: &State, tolerance: f64) {
    let flat = |state: &State| state.displacement.as_flattened().to_vec();
    close("displacement", &flat(half), &flat(whole), tolerance);
    let flat = |state: &State| state.stress.as_flattened().as_flattened().to_vec();
    close("stress", &flat(half), &flat(whole), tolerance);
    let flat = |state: &State| state.peeq.as_flattened().to_vec();
    close("plastic strain", &flat(half), &flat(whole), tolerance);
    for (own, other) in half.contacts.iter().zip(&whole.contacts) {
        assert_eq!(own.nodes, other.nodes);
        assert_eq!(own.status, other.status);
        close("pressure", &own.pressure, &other.pressure, tolerance);
        let flat = |f: &[[f64; 3]]| f.as_flattened().to_vec();
        close("force", &flat(&own.force), &flat(&other.force), tolerance);
        close(
            "traction",
            &flat(&own.traction),
            &flat(&other.traction),
            tolerance,
        );
        let flat = |f: &[[[f64; 3]; 2]]| f.as_flattened().as_flattened().to_vec();
        close(
            "place",
            &flat(&own.acts_at),
            &flat(&other.acts_at),
            tolerance,
        );
        close("slip", &own.slip, &other.slip, tolerance);
        close("area", &own.area, &other.area, tolerance);
    }
    let planes = |state: &State| {
        let both = state.planes.iter().map(|p| [p.travel[2], p.force[2]]);
        both.collect::<Vec<_>>().as_flattened().to_vec()
    };
    close("plane", &planes(half), &planes(whole), tolerance);
    let work = |state: &State| {
        let energy = state.energy.unwrap();
        [energy.work, energy.elastic, energy.plastic, energy.friction]
    };
    close("energy", &work(half), &work(whole), tolerance);
}

#[test]
fn half_of_a_scene_says_what_the_whole_says_loaded_yielding_rubbing_and_unloaded() {
    let scene = crossed_bars(4);
    let (half, whole) = (solved(&scene, true), solved(&scene, false));
    let [loaded, unloaded] = [0, 1].map(|i| (&half.states[i], &whole.states[i]));
    let flowed = loaded.1.peeq.as_flattened().iter().any(|p| *p > 1e-4);
    let slips = loaded.1.contacts.iter().all(|c| c.status.contains(&2));
    assert!(flowed && slips, "the scene shows what it is made for");
    alike(loaded.0, loaded.1, 1e-8);
    alike(unloaded.0, unloaded.1, 1e-8);
    // Of the 64 nodes of the cut 28 pairs share three unknowns, and the 8 on the axis have one each; the load has one.
    let (ours, all) = (half.counters.equations, whole.counters.equations);
    let beside = ours - (28 * 3 + 8) - 1;
    assert_eq!(all, 2 * beside + 64 * 3 + 1);
}

#[test]
fn half_of_a_divided_scene_says_what_the_whole_says() {
    let mut scene = crossed_bars(4);
    scene.controls.solver = SolverKind::Divided;
    let half = solved(&scene, true);
    scene.controls.solver = SolverKind::Direct;
    let whole = solved(&scene, false);
    alike(&half.states[0], &whole.states[0], 1e-7);
}

#[test]
fn what_breaks_the_symmetry_is_named() {
    let reason = |scene: &Scene| HalfTurn::of(scene).err().map(|why| why.to_string());
    assert_eq!(reason(&crossed_bars(4)), None);
    let why = |change: &dyn Fn(&mut Scene)| {
        let mut scene = crossed_bars(4);
        change(&mut scene);
        reason(&scene).expect("is not its own image")
    };
    let layers = reason(&crossed_bars(3)).unwrap();
    assert!(
        layers.contains("`m_middle`") && layers.contains("even number"),
        "{layers}"
    );
    let steel = why(&|scene| scene.materials[0].youngs_modulus *= 2.0);
    assert!(
        steel.contains("steel") && steel.contains("`u_upper`"),
        "{steel}"
    );
    let moved = why(&|scene| scene.mesh.points[5][1] += 1e-3);
    assert!(moved.contains("mesh"), "{moved}");
    let rough = why(&|scene| scene.contacts[1].friction = 0.3);
    assert!(rough.contains("`upper-middle`"), "{rough}");
    let carrier = why(&|scene| scene.contacts[1].carrier = Side::Upper);
    assert!(carrier.contains("`upper-middle`"), "{carrier}");
    let sideways = why(&|scene| scene.rigid_planes[0].motion[0] = PlaneMotion::Driven(1.0));
    assert!(sideways.contains("load"), "{sideways}");
    let free = why(&|scene| scene.supports[0].components[0] = None);
    assert!(free.contains("load"), "{free}");
    let held = why(&|scene| {
        scene.supports.push(Support {
            name: "side".into(),
            surface: "m_x_min".into(),
            components: [Some(0.0), None, None],
            ..Support::default()
        })
    });
    assert!(held.contains("`side`"), "{held}");
    assert!(!NoHalfTurn::NotWanted.is_worth_telling());
}
