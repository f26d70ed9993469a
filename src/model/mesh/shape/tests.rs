//! Surfaces of mapped blocks, whose shapes are known from the map.

use std::f64::consts::PI;

use nalgebra::{Rotation3, Vector3};

use super::{Shape, fit};
use crate::model::mesh::block::{Block, cylindrical, graded, uniform};
use crate::model::mesh::{Mesh, Surface};

/// A tube of radii 1 and 2 from angle -`half` to `half` degrees, `cells` around, 0.7 long.
fn tube(half: f64, cells: usize, place: impl Fn([f64; 3]) -> [f64; 3]) -> Mesh {
    let half = half.to_radians();
    Block::new(
        "tube",
        uniform(1.0, 2.0, 2),
        uniform(-half, half, cells),
        uniform(0.0, 0.7, 3),
    )
    .mapped(|p| place(cylindrical(p)))
    .build()
    .unwrap()
}

fn shape(mesh: &Mesh, surface: &str) -> Shape {
    fit(mesh, mesh.surface(surface).unwrap())
}

/// The faces of several surfaces as one.
fn together<'a>(mesh: &Mesh, names: impl IntoIterator<Item = &'a str>) -> Surface {
    let surfaces = names.into_iter().map(|name| mesh.surface(name).unwrap());
    Surface {
        name: "together".into(),
        faces: surfaces.flat_map(|surface| surface.faces.clone()).collect(),
    }
}

/// Scaled, turned and moved; by a proper rotation, so that the handedness stays.
fn moved(scale: f64) -> impl Fn([f64; 3]) -> [f64; 3] {
    let turn = Rotation3::from_euler_angles(0.3, -1.1, 2.0);
    move |p| ((turn * Vector3::from(p) + Vector3::new(3.0, -1.0, 0.5)) * scale).into()
}

#[track_caller]
fn assert_cylinder(found: Shape, exact: f64, solid: bool, tolerance: f64) {
    match found {
        Shape::Cylinder { radius, convex, .. } => {
            assert!(
                (radius / exact - 1.0).abs() < tolerance,
                "{radius:?} instead of {exact:?}"
            );
            assert_eq!(convex, solid);
        }
        other => panic!("a cylinder, not {other:?}"),
    }
}

#[test]
fn parts_of_a_cylinder_are_found_in_any_unit_and_place() {
    for scale in [1e-9, 1e-3, 1.0, 25.4, 1e3, 1e6] {
        for (half, cells) in [
            (180.0 - 1e-3, 40),
            (90.0, 12),
            (45.0, 24),
            (10.0, 3),
            (0.5, 4),
        ] {
            let mesh = tube(half, cells, moved(scale));
            let tolerance = if half < 1.0 { 1e-6 } else { 1e-9 };
            assert_cylinder(shape(&mesh, "x_max"), 2.0 * scale, true, tolerance);
            assert_cylinder(shape(&mesh, "x_min"), 1.0 * scale, false, tolerance);
            for flat in ["y_min", "y_max", "z_min", "z_max"] {
                let found = shape(&mesh, flat);
                assert!(
                    matches!(found, Shape::Plane { .. }),
                    "{flat} {scale} {half}: {found:?}"
                );
            }
        }
    }
}

#[test]
fn axis_and_projection_are_those_of_the_cylinder() {
    let mesh = tube(20.0, 6, moved(25.4));
    let turn = Rotation3::from_euler_angles(0.3, -1.1, 2.0);
    for (name, exact, side) in [("x_max", 50.8, 1.0), ("x_min", 25.4, -1.0)] {
        let surface = mesh.surface(name).unwrap();
        let found = fit(&mesh, surface);
        let Shape::Cylinder { axis, .. } = found else {
            panic!("{found:?}")
        };
        let along = turn * Vector3::z();
        assert!((along.dot(&Vector3::from(axis)).abs() - 1.0).abs() < 1e-12);
        for face in &surface.faces {
            let centre = face.centre(&mesh);
            let (foot, normal) = found.project(centre).unwrap();
            let from = turn.inverse() * Vector3::from(foot) / 25.4
                - turn.inverse() * Vector3::new(3.0, -1.0, 0.5);
            let radius = (from.x * from.x + from.y * from.y).sqrt() * 25.4;
            assert!((radius - exact).abs() < 1e-9, "{radius}");
            let out = turn * Vector3::new(from.x, from.y, 0.0).normalize() * side;
            assert!((out - Vector3::from(normal)).norm() < 1e-9);
            let area = Vector3::from(face.area_vector(&mesh));
            assert!(area.normalize().dot(&Vector3::from(normal)) > 0.99);
        }
        assert_eq!(found.project([f64::NAN; 3]), None);
    }
}

#[test]
fn a_narrow_long_strip_is_round_and_one_row_of_facets_is_flat() {
    // 0.02 wide, 10 long, radius 1.5: 2e-7 of the length in depth.
    let strip = |cells| {
        let angles = uniform(-0.01 / 1.5, 0.01 / 1.5, cells);
        Block::new("strip", vec![1.0, 1.5], angles, uniform(0.0, 10.0, 20)).mapped(cylindrical)
    };
    assert_cylinder(shape(&strip(6).build().unwrap(), "x_max"), 1.5, true, 1e-5);
    let one = strip(1).build().unwrap();
    assert!(matches!(shape(&one, "x_max"), Shape::Plane { .. }));
}

#[test]
fn planes_stay_planes_with_their_outward_normal() {
    for scale in [1e-9, 1.0, 1e6] {
        let block = Block::new(
            "b",
            graded(0.0, 1.0, 9, 1.4),
            uniform(0.0, 8.0, 5),
            uniform(0.0, 0.01, 3),
        );
        let mesh = block.mapped(moved(scale)).build().unwrap();
        let turn = Rotation3::from_euler_angles(0.3, -1.1, 2.0);
        let exact = [
            ("x_min", -Vector3::x()),
            ("y_max", Vector3::y()),
            ("z_min", -Vector3::z()),
        ];
        for (name, out) in exact {
            let found = shape(&mesh, name);
            let Shape::Plane { normal, .. } = found else {
                panic!("{name}: {found:?}")
            };
            assert!(
                (turn * out - Vector3::from(normal)).norm() < 1e-9,
                "{name} {scale}"
            );
            let (foot, _) = found.project(moved(scale)([0.3, 0.2, 0.7])).unwrap();
            let back = found.project(foot).unwrap().0;
            assert!((Vector3::from(back) - Vector3::from(foot)).norm() < 1e-9 * scale);
        }
    }
}

#[test]
fn parts_of_a_sphere_are_found() {
    // Rays through a square, from radius 2 to 3.
    let ray = |[x, y, z]: [f64; 3]| Vector3::new(x, y, 1.0).normalize() * z;
    for (half, scale) in [(0.6, 1.0), (0.05, 1e-6), (0.05, 1e5)] {
        let list = || uniform(-half, half, 6);
        let block = Block::new("ball", list(), list(), uniform(2.0, 3.0, 2));
        let mesh = block
            .mapped(|p| moved(scale)(ray(p).into()))
            .build()
            .unwrap();
        for (name, exact, solid) in [("z_max", 3.0, true), ("z_min", 2.0, false)] {
            let found = shape(&mesh, name);
            let Shape::Sphere {
                radius,
                convex,
                centre,
            } = found
            else {
                panic!("{found:?}")
            };
            assert!((radius / (exact * scale) - 1.0).abs() < 1e-8, "{radius}");
            assert_eq!(convex, solid);
            let there = Vector3::from(moved(scale)([0.0; 3]));
            assert!((Vector3::from(centre) - there).norm() < 1e-8 * scale);
            assert_eq!(found.project(centre), None);
        }
    }
}

#[test]
fn other_shapes_stay_facets() {
    let cone = |[x, y, z]: [f64; 3]| [x * (1.0 + 0.2 * z), y * (1.0 + 0.2 * z), z];
    let ellipse = |[x, y, z]: [f64; 3]| [1.01 * x, y, z];
    let wave = |[x, y, z]: [f64; 3]| [x + 1e-5 * (20.0 * y).sin(), y, z];
    for mesh in [
        tube(80.0, 24, cone),
        tube(80.0, 24, ellipse),
        tube(80.0, 24, wave),
    ] {
        assert_eq!(shape(&mesh, "x_max"), Shape::Facets);
    }
    // One node off by 1e-5 of the size.
    let mut mesh = tube(45.0, 12, |p| p);
    let node = mesh.surface("x_max").unwrap().faces[7].nodes[0] as usize;
    mesh.points[node] = mesh.points[node].map(|c| c * (1.0 + 2e-5));
    assert_eq!(shape(&mesh, "x_max"), Shape::Facets);
    let list = || uniform(0.0, 1.0, 4);
    let bump = |[x, y, z]: [f64; 3]| [x, y, z + 1e-4 * x * x * y];
    let mesh = Block::new("b", list(), list(), list())
        .mapped(bump)
        .build()
        .unwrap();
    assert_eq!(shape(&mesh, "z_max"), Shape::Facets);
}

/// All nodes of a prism with one facet a side lie on a cylinder, those of a cube on a sphere.
#[test]
fn bars_and_cubes_are_not_round() {
    for sides in [3, 4, 6, 8] {
        let half = 180.0 - 180.0 / f64::from(sides) - 1e-3;
        let mesh = tube(half, sides as usize - 1, |p| p);
        assert_eq!(shape(&mesh, "x_max"), Shape::Facets, "{sides} sides");
    }
    let cells = || uniform(-1.0, 1.0, 1);
    let mesh = Block::new("cube", cells(), cells(), cells())
        .build()
        .unwrap();
    let all = mesh.surfaces.iter().map(|surface| surface.name.as_str());
    assert_eq!(fit(&mesh, &together(&mesh, all)), Shape::Facets);
}

/// The union of a flat and a round surface is neither.
#[test]
fn mixed_and_empty_surfaces_are_facets() {
    let mesh = tube(30.0, 8, |p| p);
    let mixed = together(&mesh, ["x_max", "z_max"]);
    assert_eq!(fit(&mesh, &mixed), Shape::Facets);
    assert_eq!(fit(&mesh, &Surface::default()), Shape::Facets);
    assert_eq!(Shape::Facets.project([0.0; 3]), None);
}

/// Rounded to seven digits, as some programs write them.
#[test]
fn rounded_coordinates_do_not_hide_a_shape() {
    let rounded = |p: [f64; 3]| p.map(|c| f64::from(c as f32));
    let mesh = tube(45.0, 16, rounded);
    assert_cylinder(shape(&mesh, "x_max"), 2.0, true, 1e-5);
    assert!(matches!(shape(&mesh, "y_min"), Shape::Plane { .. }));
}

#[test]
fn distorted_facets_on_a_cylinder_are_accepted() {
    // The rows wander along the angle with z, and the rings along z with the angle.
    let wander = |[r, a, z]: [f64; 3]| [r, a + 0.05 * (9.0 * z).sin(), z + 0.05 * (7.0 * a).sin()];
    let block = Block::new(
        "b",
        uniform(1.0, 2.0, 2),
        uniform(-PI / 2.0, PI / 2.0, 30),
        uniform(0.0, 0.7, 6),
    );
    let mesh = block.mapped(|p| cylindrical(wander(p))).build().unwrap();
    assert_cylinder(shape(&mesh, "x_max"), 2.0, true, 1e-9);
}

/// Top and bottom of a slab of one layer lie on some cylinder, whatever the slab is: four rows, but two in each piece.
#[test]
fn flat_pieces_apart_are_no_cylinder() {
    let block = Block::new(
        "slab",
        uniform(0.0, 10.0, 5),
        uniform(-6.0, 0.0, 3),
        uniform(0.0, 1.0, 1),
    );
    let mesh = block.build().unwrap();
    let both = together(&mesh, ["y_min", "y_max"]);
    assert_eq!(fit(&mesh, &both), Shape::Facets);
}
