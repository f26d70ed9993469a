//! The case files of a proposal.

use brinell::case::bearing::{Preset, RollerEnd};
use brinell::case::{self, BearingCase, Kind};
use brinell::ground::units::{Dimension, UnitSystem};
use brinell::product::size::{Position, Proposal, Request, Setting, case_file};

fn read(proposal: &Proposal, position: Position) -> BearingCase {
    let text = case_file(proposal, proposal.choice().unwrap(), position);
    let case = case::parse("sized.toml", &text).expect(&text);
    assert_eq!(case.units, proposal.request.units);
    match case.kind {
        Kind::Bearing(bearing) => bearing,
        Kind::General(_) => panic!("not a bearing"),
    }
}

/// What is written reads back to the very same numbers, in every system of units.
#[test]
fn reads_back_to_the_same_bearing() {
    for units in UnitSystem::ALL {
        let to = |value: f64, dimension| value * UnitSystem::InKipKsi.factor_to(units, dimension);
        for end in [
            RollerEnd::Square,
            RollerEnd::Crown(to(0.001, Dimension::LENGTH)),
        ] {
            let request = Request {
                slope: Setting::or(Some(5.3f64.to_radians()), 0.0),
                wall: Setting::or(Some(0.23), 0.25),
                end: Setting::or(Some(end), RollerEnd::Square),
                preset: Setting::or(Some(Preset::H025), Preset::H0125),
                ..Request::new(
                    units,
                    to(210.0, Dimension::FORCE),
                    to(175.0, Dimension::STRESS),
                    to(3.0, Dimension::LENGTH),
                )
            };
            let proposal = Proposal::new(&request).unwrap();
            let choice = proposal.choice().unwrap();
            for (position, offset) in [
                (Position::Centre, 0.0),
                (Position::Displaced, request.roller_displacement()),
            ] {
                let bearing = read(&proposal, position);
                let mut placed = choice.geometry.clone();
                placed.offset = offset;
                assert_eq!(bearing.geometry.crossed(), Some(&placed));
                assert_eq!(bearing.load, request.load);
                assert_eq!(bearing.friction, request.friction.value);
                let steel = bearing.steels.of("lower_roller").unwrap();
                assert_eq!(steel.youngs_modulus, request.modulus.value);
                assert_eq!(steel.yield_stress, request.yield_stress);
            }
        }
    }
}

#[test]
fn a_bearing_that_does_not_move_has_one_case() {
    assert_eq!(Position::of(0.0), [Position::Centre]);
    assert_eq!(Position::of(3.0), [Position::Centre, Position::Displaced]);
}
