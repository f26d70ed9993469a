//! The bearing template, meshed by gmsh and held against the geometry it stands for.

use std::collections::{BTreeSet, HashMap};

use brinell::case::bearing::{
    BearingGeometry, CROSSED, MeshRequest, Preset, Roller, RollerEnd, RollerShape, Strips,
    elements, gmsh_parameters, rescale, shape_roller_ends,
};
use brinell::model::mesh::{Mesh, gmsh, msh};
use brinell::model::scene::EDGE_REACH;

fn initial() -> BearingGeometry {
    BearingGeometry {
        roller: RollerShape {
            diameter: 3.0,
            wall: Some(0.75),
            length: 8.0,
            end: RollerEnd::Square,
        },
        slope: 4f64.to_radians(),
        offset: 0.0,
        intermediate_thickness: 1.0,
        upper_thickness: 1.0,
        lower_thickness: 1.0,
        plan: [8.0, 8.0],
        skew: [0.0; 2],
    }
}

fn displaced(offset: f64) -> BearingGeometry {
    BearingGeometry {
        offset,
        ..initial()
    }
}

fn solid() -> BearingGeometry {
    BearingGeometry {
        roller: RollerShape {
            wall: None,
            ..initial().roller
        },
        ..initial()
    }
}

fn request(preset: Preset) -> MeshRequest {
    MeshRequest {
        preset,
        ..MeshRequest::default()
    }
}

fn mesh(geometry: &BearingGeometry, request: &MeshRequest) -> Mesh {
    request.check(geometry).unwrap();
    let work = tempfile::tempdir().unwrap();
    let template = CROSSED.write(work.path()).unwrap();
    let out = work.path().join("bearing.msh");
    gmsh::run(&template, &gmsh_parameters(geometry, request), &out).unwrap();
    let mesh = msh::read(&out).unwrap();
    check_count(&mesh, geometry, request);
    mesh
}

/// Elements are counted before gmsh is called: to the element for hollow rollers, nearly for solid ones, whose core
/// has as many along one side as along the opposite one.
fn check_count(mesh: &Mesh, geometry: &BearingGeometry, request: &MeshRequest) {
    let whole = request.full || !geometry.is_centred();
    let counted = elements(geometry, &request.sizes(geometry), whole);
    let made = mesh.hexes.len() as f64;
    let within = if geometry.roller.wall.is_some() {
        0.0
    } else {
        0.1
    };
    assert!(
        (counted / made - 1.0).abs() <= within,
        "{counted} counted, {made} made"
    );
}

/// Nodes of a body.
fn nodes(mesh: &Mesh, body: &str) -> Vec<[f64; 3]> {
    let body = &mesh.bodies[mesh.body(body).unwrap()];
    let used: BTreeSet<u32> = mesh.hexes[body.elements.clone()]
        .iter()
        .flatten()
        .copied()
        .collect();
    used.iter().map(|n| mesh.points[*n as usize]).collect()
}

/// How many nodes of a body lie on the line `across` = a, z = z.
fn on_line(mesh: &Mesh, body: &str, across: usize, a: f64, z: f64) -> usize {
    let near = |p: &&[f64; 3]| (p[across] - a).abs() < 1e-9 && (p[2] - z).abs() < 1e-9;
    nodes(mesh, body).iter().filter(near).count()
}

/// What every mesh of the template has to be.
fn check(mesh: &Mesh, geometry: &BearingGeometry, rows: bool, whole: bool) {
    let names: Vec<&str> = mesh.bodies.iter().map(|b| b.name.as_str()).collect();
    for name in [
        "upper_plate",
        "upper_roller",
        "intermediate_plate",
        "lower_roller",
        "lower_plate",
    ] {
        assert!(names.contains(&name), "{names:?}");
    }
    assert_eq!(names.len(), 5);
    for quality in mesh.quality() {
        assert!(quality.min_scaled_jacobian > 0.7, "{quality:?}");
    }
    // Bodies share no nodes.
    let sum: usize = names.iter().map(|body| nodes(mesh, body).len()).sum();
    assert_eq!(sum, mesh.points.len());

    check_surfaces(mesh, geometry, whole);
    if rows {
        check_contact_lines(mesh, geometry, whole);
    }
    for axis in [0, 1] {
        let ridge = nodes(mesh, "intermediate_plate")
            .iter()
            .filter(|p| p[axis] == 0.0)
            .count();
        assert!(ridge > 0);
    }
}

type Predicate<'a> = Box<dyn Fn([f64; 3]) -> bool + 'a>;

/// Every named surface is all of the faces of its body, or of all bodies, that lie where it lies.
fn check_surfaces(mesh: &Mesh, geometry: &BearingGeometry, whole: bool) {
    let level = |z: f64| -> Predicate { Box::new(move |p| (p[2] - z).abs() < 1e-9) };
    let roof = |side: f64, across: usize| -> Predicate {
        let tan = geometry.slope.tan();
        let half = geometry.intermediate_thickness / 2.0;
        Box::new(move |p| (side * p[2] - half - tan * p[across].abs()).abs() < 1e-9)
    };
    let round = |roller: Roller, radius: f64| -> Predicate {
        let centre = geometry.roller_centre(roller);
        Box::new(move |p| {
            let a = p[roller.across()] - centre[roller.across()];
            (a.hypot(p[2] - centre[2]) - radius).abs() < 1e-9 * radius
        })
    };
    let [bottom, top] = geometry.height_range();
    let flat = geometry.flat_face();
    let radius = geometry.radius();
    let mut wanted: Vec<(&str, Option<&str>, Predicate)> = vec![
        ("upper_plate_top", Some("upper_plate"), level(top)),
        ("upper_plate_bottom", Some("upper_plate"), level(flat)),
        ("lower_plate_top", Some("lower_plate"), level(-flat)),
        ("lower_plate_bottom", Some("lower_plate"), level(bottom)),
        (
            "intermediate_plate_top",
            Some("intermediate_plate"),
            roof(1.0, 0),
        ),
        (
            "intermediate_plate_bottom",
            Some("intermediate_plate"),
            roof(-1.0, 1),
        ),
        (
            "upper_roller_surface",
            Some("upper_roller"),
            round(Roller::Upper, radius),
        ),
        (
            "lower_roller_surface",
            Some("lower_roller"),
            round(Roller::Lower, radius),
        ),
    ];
    if geometry.roller.wall.is_some() {
        let bore = geometry.roller.bore_radius();
        wanted.push((
            "upper_roller_bore",
            Some("upper_roller"),
            round(Roller::Upper, bore),
        ));
        wanted.push((
            "lower_roller_bore",
            Some("lower_roller"),
            round(Roller::Lower, bore),
        ));
    }
    if !whole {
        wanted.push(("x_symmetry", None, Box::new(|p| p[0] == 0.0)));
        wanted.push(("y_symmetry", None, Box::new(|p| p[1] == 0.0)));
    }
    assert_eq!(mesh.surfaces.len(), wanted.len());
    for (name, body, lies) in wanted {
        let bodies = match body {
            Some(body) => vec![mesh.body(body).unwrap()],
            None => (0..mesh.bodies.len()).collect(),
        };
        let sorted = |mut nodes: [u32; 4]| {
            nodes.sort_unstable();
            nodes
        };
        let faces: BTreeSet<[u32; 4]> = bodies
            .into_iter()
            .flat_map(|body| mesh.outer_faces(body))
            .filter(|face| face.nodes.iter().all(|n| lies(mesh.points[*n as usize])))
            .map(|face| sorted(face.nodes))
            .collect();
        let surface = mesh.surface(name).expect(name);
        let named: BTreeSet<[u32; 4]> = surface.faces.iter().map(|f| sorted(f.nodes)).collect();
        assert!(!named.is_empty() && named == faces, "{name}");
    }
}

/// Both sides of every line of contact are node rows.
fn check_contact_lines(mesh: &Mesh, geometry: &BearingGeometry, whole: bool) {
    let flat = geometry.flat_face();
    for (roller, plate) in Roller::BOTH.into_iter().zip(["upper_plate", "lower_plate"]) {
        let (across, side) = (roller.across(), roller.side());
        let along = on_line(mesh, roller.body(), across, geometry.offset, side * flat);
        assert!(along >= 13);
        assert!(on_line(mesh, plate, across, geometry.offset, side * flat) >= 11);
        for line in geometry.v_lines() {
            if line < 0.0 && !whole {
                continue;
            }
            let half = geometry.intermediate_thickness / 2.0;
            let z = side * (half + line.abs() * geometry.slope.tan());
            assert_eq!(on_line(mesh, roller.body(), across, line, z), along);
            assert!(on_line(mesh, "intermediate_plate", across, line, z) >= 11);
        }
    }
}

#[test]
fn quarter_of_the_hollow_bearing() {
    for (preset, nodes) in [(Preset::H025, 7000..9500), (Preset::H0125, 11_000..13_500)] {
        let mesh = mesh(&initial(), &request(preset));
        check(&mesh, &initial(), true, false);
        assert!(nodes.contains(&mesh.points.len()), "{}", mesh.points.len());
    }
}

/// Bearings whose lines of contact are wide or narrow, with walls thin and thick and all ends.
#[test]
fn a_mesh_sized_by_its_lines() {
    let base = initial();
    let thin = BearingGeometry {
        roller: RollerShape {
            wall: Some(0.25),
            end: RollerEnd::Radius(0.1),
            ..base.clone().roller
        },
        ..base.clone()
    };
    let long = BearingGeometry {
        roller: RollerShape {
            length: 15.0,
            end: RollerEnd::Crown(0.003),
            ..displaced(6.0).roller
        },
        plan: [15.0, 18.0],
        upper_thickness: 3.0,
        ..displaced(6.0)
    };
    let shallow = BearingGeometry {
        slope: 0.5f64.to_radians(),
        ..solid()
    };
    for (geometry, widths, scale) in [
        (&base, [0.032, 0.034], 1.0),
        (&base, [0.003, 0.003], 1.0),
        (&base, [0.032, 0.034], 0.6),
        (&thin, [0.02, 0.03], 1.0),
        (&long, [0.05, 0.09], 1.3),
        (&shallow, [0.08, 0.1], 1.0),
        (&displaced(2.5), [0.055, 0.06], 1.3),
    ] {
        let request = MeshRequest {
            strips: Some(Strips {
                narrowest: widths[0],
                widest: widths[1],
                found: false,
            }),
            scale,
            ..request(Preset::Auto)
        };
        let mesh = mesh(geometry, &request);
        check(&mesh, geometry, false, !geometry.is_centred());
        check_fine(&mesh, geometry, [scale * widths[0], widths[1]]);
        // A tenth of the width takes some rows more, and no multiple.
        assert!(mesh.points.len() < 120_000, "{}", mesh.points.len());
    }
}

/// Three elements or more across the narrower width, out to 1.3 of the wider, below the upper plate.
fn check_fine(mesh: &Mesh, geometry: &BearingGeometry, [narrow, wide]: [f64; 2]) {
    let surface = mesh.surface("upper_plate_bottom").unwrap();
    let mut rows: Vec<f64> = surface
        .nodes()
        .iter()
        .map(|n| mesh.points[*n as usize][0] - geometry.offset)
        .collect();
    rows.sort_by(f64::total_cmp);
    rows.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    for pair in rows.windows(2) {
        if pair[0].abs() < 1.299 * wide && pair[1].abs() < 1.299 * wide {
            assert!(3.0 * (pair[1] - pair[0]) <= narrow, "{pair:?}");
        }
    }
}

#[test]
fn report_like_mesh_has_its_counts() {
    let mesh = mesh(&initial(), &request(Preset::ReportLike));
    check(&mesh, &initial(), false, false);
    let count = |body: &str| mesh.bodies[mesh.body(body).unwrap()].elements.len();
    // Half the circumference, half the length; a quarter of a plate.
    assert_eq!(count("upper_roller"), 12 * 2 * 8);
    assert_eq!(count("upper_plate"), 13 * 13 * 3);
}

#[test]
fn displaced_bearings_are_whole() {
    for offset in [1.25, 2.5] {
        let geometry = displaced(offset);
        let fine = mesh(&geometry, &request(Preset::H025));
        check(&fine, &geometry, true, true);
        let coarse = mesh(&geometry, &request(Preset::ReportLike));
        check(&coarse, &geometry, false, true);
    }
}

/// Beside ends that carry, in every body that ends there: as far from a sharp end as its stress counts, and where a fillet
/// begins.
#[test]
fn a_plane_of_nodes_parts_loaded_ends_from_the_rest() {
    let geometry = displaced(2.5);
    check_planes(&geometry, EDGE_REACH * geometry.roller.length);
    let radius = 0.3;
    let rounded = BearingGeometry {
        roller: RollerShape {
            end: RollerEnd::Radius(radius),
            ..geometry.roller
        },
        ..geometry
    };
    check_planes(&rounded, radius);
}

fn check_planes(geometry: &BearingGeometry, from_end: f64) {
    let end = 0.5 * geometry.roller.length;
    let beside = end - from_end;
    let mesh = mesh(geometry, &request(Preset::H025));
    for (body, axes) in [
        ("upper_plate", vec![1]),
        ("upper_roller", vec![1]),
        ("intermediate_plate", vec![0, 1]),
        ("lower_roller", vec![0]),
        ("lower_plate", vec![0]),
    ] {
        let nodes = nodes(&mesh, body);
        for axis in axes {
            let at = |place: f64| {
                let on = |p: &&[f64; 3]| (p[axis] - place).abs() < 1e-9;
                nodes.iter().filter(on).count()
            };
            assert!(at(end) > 0, "{body}");
            assert_eq!(at(beside), at(end), "{body}");
            // The valley of the other roller has but one such end.
            if body != "intermediate_plate" {
                assert_eq!(at(-beside), at(-end), "{body}");
            }
        }
    }
}

#[test]
fn every_element_scales_in_every_direction() {
    for (geometry, whole) in [(initial(), false), (displaced(2.5), true), (solid(), false)] {
        let meshes = [1.6, 0.8].map(|scale| {
            let mesh = mesh(&geometry, &request(Preset::H025).scaled(scale));
            // Coarser ones have fewer elements along the rollers than the presets promise.
            check(&mesh, &geometry, scale <= 1.0, whole);
            mesh
        });
        // Each body has about eight times the elements, and elements of the same shapes.
        let [coarse, fine] = meshes.map(|mesh| mesh.quality());
        for (coarse, fine) in coarse.iter().zip(&fine) {
            let times = fine.elements as f64 / coarse.elements as f64;
            assert!((5.0..13.0).contains(&times), "{}: {times}", fine.name);
            let longer = fine.max_aspect_ratio / coarse.max_aspect_ratio;
            assert!((0.6..1.6).contains(&longer), "{}: {longer}", fine.name);
        }
    }
}

#[test]
fn solid_rollers_have_a_core() {
    let quarter = mesh(&solid(), &request(Preset::H025));
    check(&quarter, &solid(), true, false);
    let geometry = BearingGeometry {
        roller: RollerShape {
            wall: None,
            ..displaced(2.5).roller
        },
        ..displaced(2.5)
    };
    let whole = mesh(&geometry, &request(Preset::H025));
    check(&whole, &geometry, true, true);
}

#[test]
fn the_whole_mesh_is_the_quarter_mirrored() {
    for geometry in [initial(), solid()] {
        let quarter = mesh(&geometry, &request(Preset::H025));
        let full = MeshRequest {
            full: true,
            ..request(Preset::H025)
        };
        let whole = mesh(&geometry, &full);
        check(&whole, &geometry, true, true);
        assert_eq!(whole.hexes.len(), 4 * quarter.hexes.len());
        for body in &quarter.bodies {
            let one = Nearby::new(nodes(&quarter, &body.name));
            for [x, y, z] in nodes(&whole, &body.name) {
                assert!(one.has([x.abs(), y.abs(), z]), "{}: {x} {y} {z}", body.name);
            }
        }
    }
}

/// Points, to be found by place.
struct Nearby(HashMap<[i64; 3], [f64; 3]>);

impl Nearby {
    const CELL: f64 = 1e-6;

    fn new(points: Vec<[f64; 3]>) -> Self {
        let cells = points.into_iter().map(|p| (Self::cell(p), p));
        Self(cells.collect())
    }

    fn cell(point: [f64; 3]) -> [i64; 3] {
        point.map(|x| (x / Self::CELL).floor() as i64)
    }

    /// Is there a point here, to rounding?
    fn has(&self, point: [f64; 3]) -> bool {
        let [i, j, k] = Self::cell(point);
        (0..27).any(|n| {
            let cell = [i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1];
            let found = self.0.get(&cell);
            found.is_some_and(|p| (0..3).all(|i| (p[i] - point[i]).abs() < 1e-11))
        })
    }
}

#[test]
fn other_bearings_and_other_plates() {
    let bearing = |diameter: f64, wall: f64, length: f64, degrees: f64| BearingGeometry {
        roller: RollerShape {
            diameter,
            wall: Some(wall),
            length,
            ..initial().roller
        },
        slope: degrees.to_radians(),
        plan: [length, length],
        ..initial()
    };
    let cases = [
        bearing(4.5, 0.75, 17.0, 2.0),
        bearing(4.92, 4.92 * 0.2154, 8.19, 5.0),
        bearing(8.0, 2.0, 29.0, 6.0),
        bearing(3.0, 0.15, 8.0, 4.0),
        BearingGeometry {
            plan: [18.0, 14.0],
            ..displaced(2.5)
        },
        BearingGeometry {
            plan: [6.0, 7.0],
            upper_thickness: 0.5,
            lower_thickness: 2.0,
            ..initial()
        },
    ];
    for geometry in cases {
        let mesh = mesh(&geometry, &request(Preset::H025));
        check(&mesh, &geometry, true, !geometry.is_centred());
    }
}

#[test]
fn the_unit_of_length_does_not_matter() {
    let inch = initial();
    let metre = BearingGeometry {
        roller: RollerShape {
            diameter: 3.0 * 0.0254,
            wall: Some(0.75 * 0.0254),
            length: 8.0 * 0.0254,
            ..initial().roller
        },
        intermediate_thickness: 0.0254,
        upper_thickness: 0.0254,
        lower_thickness: 0.0254,
        plan: [8.0 * 0.0254; 2],
        ..initial()
    };
    for preset in [Preset::H025, Preset::ReportLike] {
        let in_inch = mesh(&inch, &request(preset));
        let mut in_metre = mesh(&metre, &request(preset));
        assert!(rescale(&mut in_metre, &inch));
        assert_eq!(in_inch.hexes, in_metre.hexes);
        for (a, b) in in_inch.points.iter().zip(&in_metre.points) {
            assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-12), "{a:?} {b:?}");
        }
    }
}

#[test]
fn shaped_ends_keep_the_elements_sound() {
    for end in [RollerEnd::Radius(0.125), RollerEnd::Crown(0.01)] {
        for wall in [Some(0.75), None] {
            let geometry = BearingGeometry {
                roller: RollerShape {
                    end,
                    wall,
                    ..initial().roller
                },
                ..initial()
            };
            let mut mesh = mesh(&geometry, &request(Preset::H025));
            let before = mesh.clone();
            shape_roller_ends(&mut mesh, &geometry, false);
            assert_ne!(mesh.points, before.points);
            for quality in mesh.quality() {
                assert!(quality.min_scaled_jacobian > 0.2, "{end:?} {quality:?}");
            }
        }
    }
}
