use super::*;
use nalgebra::{Matrix2, Vector2};

const LAW: Law = Law {
    friction: 0.15,
    penalty: 1000.0,
    firmest: 1000.0,
    stiffness: 10.0,
};

fn closed(multiplier: [f64; 3], sticks: bool) -> Node {
    Node {
        closed: true,
        sticks,
        multiplier,
        bound: 0.15 * multiplier[0],
        ..Node::default()
    }
}

#[test]
fn an_overloaded_node_slips_along_its_shear() {
    let node = closed([10.0, 3.0, -4.0], true);
    let traction = LAW.traction(&node, &[0.0; 3]).traction;
    assert_eq!(traction, [10.0, 3.0, -4.0]);
    let next = LAW.decide(&node, &traction, &[0.0; 3], LAW.bound(&traction));
    assert!(!next.sticks);
    let answer = LAW.traction(&next, &[0.0; 3]);
    assert_eq!(answer.status, Status::Slip);
    let t = answer.traction;
    assert!((t[1] - 0.9).abs() < 1e-14 && (t[2] + 1.2).abs() < 1e-14);
}

#[test]
fn a_slipping_node_that_moves_back_sticks() {
    let node = closed([10.0, 1.5, 0.0], false);
    let back = [0.0, -0.01, 0.0];
    let traction = LAW.traction(&node, &back).traction;
    assert!(
        LAW.decide(&node, &traction, &back, LAW.bound(&traction))
            .sticks
    );
    let on = [0.0, 0.01, 0.0];
    let traction = LAW.traction(&node, &on).traction;
    assert!(
        !LAW.decide(&node, &traction, &on, LAW.bound(&traction))
            .sticks
    );
}

#[test]
fn the_tangent_is_the_derivative_of_the_traction() {
    for sticks in [true, false] {
        let d = [0.001, 0.03, 0.02];
        let mut node = closed([10.0, 0.5, -0.2], sticks);
        if !sticks {
            LAW.linearise_slip(&mut node, [0.5, -0.2], [0.025, 0.02]);
            assert!(node.slope[0][0] > 1.0);
        }
        let base = LAW.traction(&node, &d);
        for j in 0..3 {
            let mut moved = d;
            moved[j] += 1e-7;
            let next = LAW.traction(&node, &moved);
            for i in 0..3 {
                let slope = (next.traction[i] - base.traction[i]) / 1e-7;
                assert!((slope - base.tangent[i][j]).abs() < 1e-3, "{i}{j}");
            }
        }
    }
}

#[test]
fn a_slipping_shear_settles_on_the_bound_along_the_slip() {
    let d = [0.0, 0.3, 0.4];
    let mut node = closed([10.0, -1.5, 0.0], false);
    for _ in 0..6 {
        let traction = LAW.traction(&node, &d).traction;
        node = LAW.decide(&node, &[10.0, traction[1], traction[2]], &d, 1.5);
    }
    assert!(!node.sticks);
    let [_, s, t] = LAW.traction(&node, &d).traction;
    assert!((s - 0.9).abs() < 1e-6 && (t - 1.2).abs() < 1e-6, "{s} {t}");
    // It turns with the slip and grows no more.
    let [_, s, t] = LAW
        .traction(&node, &[0.0, 0.3 - 0.004, 0.4 + 0.003])
        .traction;
    assert!(
        (s - 0.9 + 1.5 * 0.004 / 0.5).abs() < 1e-6 && (t - 1.2 - 1.5 * 0.003 / 0.5).abs() < 1e-6
    );
    let [_, s, t] = LAW.traction(&node, &[0.0, 0.33, 0.44]).traction;
    assert!((s - 0.9).abs() < 1e-6 && (t - 1.2).abs() < 1e-6);
}

/// A node on springs as stiff as c, pulled by any shear from any other, settles in few iterations.
#[test]
fn a_node_on_springs_settles_soon() {
    for pull in [1.2, 3.0, 9.0] {
        settles(2.5, 12, pull, 12);
    }
}

/// Across its shear a node that hardly slips all but sticks: what it had slipped there is gone in an iteration. It is pulled
/// on, up to 75 degrees aside.
#[test]
fn a_node_that_begins_to_slip_settles_as_soon() {
    for (from, pull) in [(0.2, 1.001), (0.2, 1.01), (0.9, 1.001), (0.9, 1.01)] {
        settles(from, 5, pull, 8);
    }
}

/// From shears `from` times the bound, so many times 15 degrees and less `aside` of their pull, nodes settle under a `pull` of
/// any direction, times the bound, in `most` iterations.
fn settles(from: f64, aside: usize, pull: f64, most: usize) {
    let bound = LAW.bound(&[10.0, 0.0, 0.0]);
    let turn = |k: usize, size: f64| {
        let angle = k as f64 * std::f64::consts::PI / 12.0;
        [size * angle.cos(), size * angle.sin()]
    };
    let starts = |k: usize| (24 + k - aside..=24 + k + aside).map(move |start| (start, k));
    for (start, towards) in (0..24).flat_map(starts) {
        let pulled = turn(towards, pull * bound);
        let [s, t] = turn(start, from * bound);
        let mut node = closed([10.0, s, t], false);
        node.raised = MOST_RAISED;
        LAW.linearise_slip(
            &mut node,
            [s, t],
            [0, 1].map(|i| (pulled[i] - [s, t][i]) / LAW.stiffness),
        );
        let settles = (0..most).any(|_| {
            // Balance: the node's shear is the pull less what the springs take.
            let d = balance(&node, pulled);
            let traction = LAW.traction(&node, &d).traction;
            let next = LAW.decide(&node, &traction, &d, bound);
            let rests = next.sticks == node.sticks
                && (1..3).all(|i| (next.multiplier[i] - traction[i]).abs() < 1e-6 * bound);
            node = Node {
                raised: MOST_RAISED,
                ..next
            };
            rests
        });
        assert!(
            settles,
            "from {start}, towards {towards}, {pull} times the bound"
        );
        let [_, s, t] = node.multiplier;
        // Alone on springs that are alike in all directions it slips the way that it is pulled.
        assert!((s * pulled[1] - t * pulled[0]).abs() < 1e-4 * bound * bound * pull);
    }
}

/// The displacement at which the shear of a node that slips or sticks is `pulled` less c times the slip.
fn balance(node: &Node, pulled: [f64; 2]) -> [f64; 3] {
    let answer = LAW.traction(node, &[0.0; 3]);
    let tangent = Matrix2::from_fn(|i, j| answer.tangent[1 + i][1 + j]);
    let missing = Vector2::from_fn(|i, _| pulled[i] - answer.traction[1 + i]);
    let stiffness = tangent + Matrix2::from_diagonal_element(LAW.stiffness);
    let slip = stiffness.lu().solve(&missing).expect("positive definite");
    [0.0, slip[0], slip[1]]
}

#[test]
fn caution_returns_to_the_disc_within_the_iteration() {
    let node = Node {
        cautious: true,
        ..closed([10.0, 0.0, 0.0], true)
    };
    assert_eq!(
        LAW.traction(&node, &[0.0, 0.004, 0.0]).status,
        Status::Stick
    );
    let answer = LAW.traction(&node, &[0.0, 0.03, -0.04]);
    assert_eq!(answer.status, Status::Slip);
    assert!((answer.traction[1] - 0.9).abs() < 1e-14);
    assert!((answer.traction[2] + 1.2).abs() < 1e-14);
}

/// Bodies that all but hold a node let it slip by next to nothing: its shear turns that way all the same. What is left of its angle
/// falls by 1/(1 + ε_t (pull - bound) / (K bound)) each time: 0.77 once ε_t is raised, 0.997 if it never were.
#[test]
fn the_shear_of_a_cautious_node_turns_with_the_least_slip() {
    let bound = 0.15 * 10.0;
    let (pull, held) = ([0.0, 2.0 * bound], 1e4 * LAW.stiffness);
    let mut node = Node {
        cautious: true,
        ..closed([10.0, bound, 0.0], false)
    };
    for _ in 0..60 {
        let mut d = [0.0; 3];
        for _ in 0..100 {
            let [_, s, t] = LAW.traction(&node, &d).traction;
            d = [0.0, (pull[0] - s) / held, (pull[1] - t) / held];
        }
        let answer = LAW.traction(&node, &d);
        LAW.take_shear(&mut node, &answer);
    }
    let [_, s, t] = node.multiplier;
    assert!(s.abs() < 1e-5 && (t - bound).abs() < 1e-5, "{s} {t}");
}

#[test]
fn a_soft_penalty_is_raised_as_far_as_the_automatic_one() {
    let law = Law {
        penalty: 20.0,
        ..LAW
    };
    let pressure = |firmer| {
        let node = Node {
            firmer,
            ..closed([10.0, 0.0, 0.0], true)
        };
        law.traction(&node, &[0.01, 0.0, 0.0]).traction[0]
    };
    assert_eq!([0, 1, 9].map(pressure), [10.2, 12.0, 20.0]);
}

#[test]
fn tension_opens_and_penetration_closes() {
    let node = closed([10.0, 0.0, 0.0], false);
    let d = [1e-6, 0.0, 0.0];
    assert!(!LAW.decide(&node, &[-1.0, 0.0, 0.0], &d, 0.0).closed);
    assert!(LAW.decide(&Node::default(), &[0.0; 3], &d, 0.0).closed);
    // λ was far too large: d says so, and nothing else.
    let d = [-0.5, 0.0, 0.0];
    assert!(LAW.decide(&node, &[1e-6, 0.0, 0.0], &d, 0.0).closed);
}
