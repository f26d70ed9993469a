//! The figures of the shipped cases beyond section 2.6.2.

use brinell::case::bearing::MeshRequest;
use brinell::case::{BearingCase, Case, Kind, read};
use std::path::Path;

fn case(name: &str) -> Case {
    read(&Path::new("cases").join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn bearing(case: &Case) -> &BearingCase {
    match &case.kind {
        Kind::Bearing(bearing) => bearing,
        Kind::General(_) => panic!("{} is no bearing", case.title),
    }
}

/// Load; diameter, wall and length of the rollers; slope in degrees; plate thickness and size;
/// modulus and yield stress. Wall 0: solid.
#[test]
fn bearings_of_the_study_beyond_section_2_6_2() {
    let given = [
        (
            "prototype-1",
            [60.0, 4.5, 0.75, 17.0, 2.0, 1.0, 18.33, 29500.0, 75.0],
        ),
        (
            "prototype-2",
            [315.0, 4.92, 1.06, 8.19, 5.0, 1.18, 8.19, 29500.0, 175.0],
        ),
        (
            "chapter-5",
            [1485.0, 8.0, 2.0, 29.0, 6.0, 2.0, 29.0, 29500.0, 240.0],
        ),
        (
            "ncree",
            [56.0, 3.0, 0.0, 10.0, 2.0, 1.0, 14.0, 30000.0, 100.0],
        ),
    ];
    for (name, figures) in given {
        let case = case(&format!("{name}.toml"));
        let bearing = bearing(&case);
        let g = bearing.geometry.crossed().unwrap();
        let steel = bearing.steels.of("upper_roller").unwrap();
        let read = [
            bearing.load,
            g.roller.diameter,
            g.roller.wall.unwrap_or(0.0),
            g.roller.length,
            g.slope.to_degrees(),
            g.intermediate_thickness,
            g.plan[0],
            steel.youngs_modulus,
            steel.yield_stress,
        ];
        for (read, given) in read.into_iter().zip(figures) {
            assert!((read - given).abs() < 1e-9, "{name}: {read}, not {given}");
        }
        let thicknesses = [g.upper_thickness, g.lower_thickness];
        assert_eq!(thicknesses, [g.intermediate_thickness; 2]);
        assert_eq!((g.offset, bearing.friction), (0.0, 0.15));
        assert!(!case.discrepancies.is_empty(), "{name}");
        // Where the study gives no hardening: a tangent of E/100.
        let tangent = 1.0 / (1.0 / steel.hardening_modulus + 1.0 / steel.youngs_modulus);
        assert!((tangent * 100.0 / steel.youngs_modulus - 1.0).abs() < 1e-9);
    }
}

#[test]
fn the_load_line_of_prototype_2() {
    let case = case("prototype-2.toml");
    let shares = &bearing(&case).stages;
    assert_eq!(shares, &[90.0 / 315.0, 210.0 / 315.0]);
}

/// The wall alone is varied, so that nothing else can move the answer.
#[test]
fn the_wall_sweep_is_the_initial_design_with_other_walls() {
    let mut initial = case("section-2.6.2/initial-centre.toml");
    // Their figures are of one mesh.
    initial.set_preset("h025").unwrap();
    let initial = bearing(&initial);
    for ratio in [0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5] {
        let case = case(&format!("wall-sweep/wall-{ratio}.toml"));
        let bearing = bearing(&case);
        let wall = bearing.geometry.wall();
        assert_eq!(wall.is_none(), ratio == 0.5);
        if let Some(wall) = wall {
            assert!((wall - 3.0 * ratio).abs() < 1e-12);
        }
        let mut geometry = initial.geometry.crossed().unwrap().clone();
        geometry.roller.wall = wall;
        assert_eq!(bearing.geometry.crossed(), Some(&geometry));
        assert_eq!(bearing.load, initial.load);
        assert_eq!(bearing.friction, initial.friction);
        // Thinner walls spread the load of the other roller less: the lines are as wide as that makes them.
        let strips = initial.mesh.strips;
        assert_eq!(
            MeshRequest {
                strips,
                ..bearing.mesh.clone()
            },
            initial.mesh
        );
        let steel = |b: &BearingCase| b.steels.of("lower_roller").unwrap();
        if ratio == 0.05 {
            // Its wall would yield through.
            assert!(steel(bearing).yield_stress.is_infinite());
        } else {
            assert_eq!(steel(bearing), steel(initial));
        }
    }
}
