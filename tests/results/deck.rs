//! Decks for other programs, read back keyword by keyword.

use crate::block::{close, stack};
use brinell::model::scene::TractionValue::{Pressure, Vector};
use brinell::model::scene::{
    ElementKind, Partner, PlaneMotion, PlaneTurn, Scene, Step, Support, Temperature, Traction,
};
use brinell::product::deck::{InpError, check};
use brinell::render::inp::{ContactType, Settings};

/// A keyword with its parameters, and the lines of data below it.
struct Card {
    keyword: String,
    data: Vec<String>,
}

fn settings() -> Settings {
    Settings {
        title: "*a stack\n*END STEP".into(),
        units: ["in", "kip", "ksi"].map(str::to_string),
        ..Settings::default()
    }
}

fn deck(scene: &Scene, settings: &Settings) -> Vec<Card> {
    let mut bytes = Vec::new();
    check(scene, settings).unwrap().write(&mut bytes).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    let mut cards: Vec<Card> = Vec::new();
    for line in text.lines().filter(|l| !l.starts_with("**")) {
        assert!(line.len() <= 132, "too long: {line}");
        match line.starts_with('*') {
            true => cards.push(Card {
                keyword: line.into(),
                data: Vec::new(),
            }),
            false => cards.last_mut().unwrap().data.push(line.into()),
        }
    }
    cards
}

fn all<'a>(cards: &'a [Card], keyword: &str) -> Vec<&'a Card> {
    let of = |card: &&Card| card.keyword.split(',').next() == Some(keyword);
    cards.iter().filter(of).collect()
}

fn numbers(line: &str) -> Vec<f64> {
    let parts = line.split(',').filter(|p| !p.is_empty());
    parts.map(|p| p.trim().parse().unwrap()).collect()
}

/// Corners of the six faces in the manual's numbering: S1 is 1-2-3-4, S2 5-8-7-6, S3 1-5-6-2,
/// S4 2-6-7-3, S5 3-7-8-4, S6 4-8-5-1.
const FACES: [[usize; 4]; 6] = [
    [1, 2, 3, 4],
    [5, 8, 7, 6],
    [1, 5, 6, 2],
    [2, 6, 7, 3],
    [3, 7, 8, 4],
    [4, 8, 5, 1],
];

/// Nodes, from 0, of face `number` of element `element`, both from 1.
fn face(scene: &Scene, element: usize, number: usize) -> Vec<u32> {
    let hex = scene.mesh.hexes[element - 1];
    let mut nodes = FACES[number - 1].map(|corner| hex[corner - 1]).to_vec();
    nodes.sort_unstable();
    nodes
}

#[test]
fn the_mesh_comes_back() {
    let scene = stack();
    let cards = deck(&scene, &settings());
    let nodes = &all(&cards, "*NODE")[0].data;
    assert_eq!(nodes.len(), scene.mesh.points.len());
    for (line, point) in nodes.iter().zip(&scene.mesh.points) {
        let found = &numbers(line)[1..];
        found.iter().zip(point).for_each(|(a, b)| close(*a, *b));
    }
    let bodies = all(&cards, "*ELEMENT");
    assert_eq!(bodies[0].keyword, "*ELEMENT,TYPE=C3D8,ELSET=BLOCK");
    assert_eq!(bodies[1].keyword, "*ELEMENT,TYPE=C3D8,ELSET=PLATE");
    let elements = bodies.iter().flat_map(|b| &b.data);
    for (index, (line, hex)) in elements.zip(&scene.mesh.hexes).enumerate() {
        let found = numbers(line);
        assert_eq!(found[0] as usize, index + 1);
        assert!(found[1..].iter().zip(hex).all(|(a, b)| *a as u32 == b + 1));
    }
    assert_eq!(all(&cards, "*NSET").len(), scene.mesh.surfaces.len());
    // A title cannot smuggle in a keyword.
    assert_eq!(cards[0].data, ["a stack *END STEP"]);
}

#[test]
fn faces_bear_their_numbers() {
    let scene = stack();
    let cards = deck(&scene, &settings());
    let surfaces = all(&cards, "*SURFACE");
    assert_eq!(
        surfaces[0].keyword,
        "*SURFACE,NAME=BLOCK_PLATE_CARRIER,TYPE=ELEMENT"
    );
    for (card, name) in surfaces.iter().zip(["block_w-", "plate_w+"]) {
        let mut expected: Vec<Vec<u32>> = Vec::new();
        for face in &scene.mesh.surface(name).unwrap().faces {
            let mut nodes = face.nodes.to_vec();
            nodes.sort_unstable();
            expected.push(nodes);
        }
        for line in &card.data {
            let (element, number) = line.split_once(",S").unwrap();
            let nodes = face(&scene, element.parse().unwrap(), number.parse().unwrap());
            assert!(expected.contains(&nodes), "{line} is no face of {name}");
        }
    }
    // The plate reaches beyond the block: only faces that may touch are there.
    assert_eq!(surfaces[0].data.len(), 6);
    assert!(surfaces[1].data.len() < 4 + 1);
}

#[test]
fn steel_contact_and_friction_are_those_of_the_scene() {
    let scene = stack();
    let cards = deck(&scene, &settings());
    let plastic = all(&cards, "*PLASTIC");
    assert_eq!(plastic.len(), 2);
    assert_eq!(numbers(&plastic[0].data[0]), [100.0, 0.0]);
    assert_eq!(numbers(&plastic[0].data[1]), [349.471, 1.0]);
    assert_eq!(numbers(&all(&cards, "*ELASTIC")[1].data[0]), [29500.0, 0.3]);
    let stiffness = numbers(&all(&cards, "*SURFACE BEHAVIOR")[0].data[0])[0];
    // The shortest edge below the block measures 0.2.
    close(stiffness / 29500.0, 20.0 / 0.2);
    let friction = numbers(&all(&cards, "*FRICTION")[0].data[0]);
    assert_eq!(friction[0], 0.15);
    let mut other = settings();
    other.contact_stiffness = Some(4e7);
    other.contact = ContactType::Mortar;
    other.solver = Some("ITERATIVE CHOLESKY".into());
    let mut elastic = scene;
    elastic.controls.plasticity = false;
    elastic.controls.element = ElementKind::Enhanced;
    elastic.contacts[0].friction = 0.0;
    let cards = deck(&elastic, &other);
    assert_eq!(numbers(&all(&cards, "*SURFACE BEHAVIOR")[0].data[0]), [4e7]);
    assert!(all(&cards, "*PLASTIC").is_empty() && all(&cards, "*FRICTION").is_empty());
    assert!(
        all(&cards, "*CONTACT PAIR")[0]
            .keyword
            .ends_with("TYPE=MORTAR")
    );
    assert!(all(&cards, "*ELEMENT")[0].keyword.contains("TYPE=C3D8I,"));
    let statics = all(&cards, "*STATIC");
    assert!(
        statics
            .iter()
            .all(|s| s.keyword == "*STATIC,SOLVER=ITERATIVE CHOLESKY")
    );
}

#[test]
fn a_driven_plane_is_closed_by_motion_and_loaded_by_force() {
    let mut scene = stack();
    scene.steps.push(Step::to("unload", 0.25));
    let top = scene.mesh.surface("block_w+").unwrap().nodes();
    let cards = deck(&scene, &settings());
    let equations = &all(&cards, "*EQUATION")[0].data;
    assert_eq!(equations.len(), 2 * (top.len() - 1));
    let reference = f64::from(top[0] + 1);
    for pair in equations.chunks(2) {
        assert_eq!(pair[0], "2");
        let terms = numbers(&pair[1]);
        assert!(top.contains(&(terms[0] as u32 - 1)));
        assert_eq!(terms[1..], [3.0, 1.0, reference, 3.0, -1.0]);
    }
    assert_eq!(all(&cards, "*STEP").len(), 3);
    let boundaries = all(&cards, "*BOUNDARY");
    let closing = numbers(boundaries[0].data.last().unwrap());
    assert_eq!(closing[..3], [reference, 3.0, 3.0]);
    // A solid block 1 x 0.5 in plan and 2 high.
    close(closing[3], -65.0 / 4.0 * 2.0 / (29500.0 * 0.5));
    for boundary in &boundaries[1..] {
        assert!(boundary.keyword == "*BOUNDARY,OP=NEW" && boundary.data.len() == 3 + 2);
    }
    let forces: Vec<f64> = all(&cards, "*CLOAD")
        .iter()
        .map(|c| numbers(&c.data[0])[2])
        .collect();
    assert_eq!(forces, [-16.25, -4.0625]);
    // The plane holds the block along x and y, and drives it along z: no springs.
    assert!(all(&cards, "*SPRING").is_empty());
    let mut told = settings();
    told.closing = Some(0.01);
    told.increment = Some(1.0);
    let cards = deck(&scene, &told);
    let closing = numbers(all(&cards, "*BOUNDARY")[0].data.last().unwrap());
    assert_eq!(closing[3], -0.01);
    assert!(all(&cards, "*STATIC")[1].data[0].starts_with("1,1.,"));
}

#[test]
fn a_plane_that_turns_has_a_node_for_its_point_and_one_for_its_angles() {
    let mut scene = stack();
    scene.mirrors.clear();
    let plane = &mut scene.rigid_planes[0];
    plane.turn = [
        PlaneTurn::Driven(12.0),
        PlaneTurn::Held(0.001),
        PlaneTurn::Held(0.0),
    ];
    plane.about = Some([0.3, 0.1, 1.5]);
    scene.steps.push(Step::to("unload", 0.25));
    let cards = deck(&scene, &settings());
    let top = scene.mesh.surface("block_w+").unwrap().nodes();
    let point = scene.mesh.points.len() as f64 + 1.0;
    let own = all(&cards, "*NODE");
    assert_eq!(own[1].keyword, "*NODE,NSET=TOP_POINT");
    assert_eq!(numbers(&own[1].data[0]), [point, 0.3, 0.1, 1.5]);
    assert_eq!(numbers(&own[1].data[1])[0], point + 1.0);
    // Whatever the point and the angles do, the nodes follow as those of a rigid body: u = t + w x r.
    let (t, w) = ([0.01, -0.02, 0.005], [0.003, -0.001]);
    let equations = &all(&cards, "*EQUATION")[0].data;
    assert_eq!(equations.len(), 2 * 3 * top.len());
    for pair in equations.chunks(2) {
        let terms = numbers(&pair[1]);
        assert_eq!(terms.len(), 3 * pair[0].parse::<usize>().unwrap());
        let at = scene.mesh.points[terms[0] as usize - 1];
        let r = [at[0] - 0.3, at[1] - 0.1, at[2] - 1.5];
        let motion = [
            t[0] + w[1] * r[2],
            t[1] - w[0] * r[2],
            t[2] + w[0] * r[1] - w[1] * r[0],
        ];
        let sum: f64 = terms
            .chunks(3)
            .map(|term| {
                let axis = term[1] as usize - 1;
                let value = match term[0] - point {
                    0.0 => t[axis],
                    1.0 => w[axis],
                    _ => motion[axis],
                };
                term[2] * value
            })
            .sum();
        assert!(sum.abs() < 1e-16, "{pair:?}: {sum}");
    }
    let loads = all(&cards, "*CLOAD");
    let loads: Vec<Vec<f64>> = loads.iter().map(|c| numbers(&c.data[0])).collect();
    let of = |factor: f64| {
        [
            vec![point, 3.0, -16.25 * factor],
            vec![point + 1.0, 1.0, 12.0 * factor],
        ]
    };
    assert_eq!(loads, [of(1.0), of(0.25)].concat());
    let angles = |step: usize| -> Vec<Vec<f64>> {
        let lines = all(&cards, "*BOUNDARY")[step].data.iter();
        let lines = lines.filter(|line| line.starts_with(|c: char| c.is_ascii_digit()));
        let lines = lines.map(|line| numbers(line));
        lines.filter(|line| line[0] == point + 1.0).collect()
    };
    let turned = |about: f64, angle: f64| vec![point + 1.0, about, about, angle];
    // While the contact closes nothing turns.
    assert_eq!(angles(0), [1.0, 2.0, 3.0].map(|about| turned(about, 0.0)));
    assert_eq!(angles(1), [turned(2.0, 0.001), turned(3.0, 0.0)]);
    assert_eq!(angles(2), [turned(2.0, 0.00025), turned(3.0, 0.0)]);
    // Where a support holds a node that the plane moves, they contradict each other.
    scene.supports.push(Support {
        name: "side".into(),
        surface: "block_u-".into(),
        components: [Some(0.0), None, None],
        ..Support::default()
    });
    let settings = settings();
    let twice = check(&scene, &settings).err();
    assert!(matches!(twice, Some(InpError::HeldTwice { .. })));
}

#[test]
fn pressures_tractions_and_floating_bodies() {
    let mut scene = stack();
    scene.rigid_planes.clear();
    let traction = |surface: &str, value| Traction {
        name: surface.into(),
        surface: surface.into(),
        value,
    };
    scene.tractions = vec![
        traction("block_w+", Pressure(30.0)),
        traction("block_u+", Vector([0.0, 2.0, 0.0])),
    ];
    scene.supports.push(Support {
        name: "wall".into(),
        surface: "block_u-".into(),
        components: [Some(0.5), None, None],
        gradient: [[0.0, 0.1, 0.0], [0.0; 3], [0.0; 3]],
    });
    let cards = deck(&scene, &settings());
    assert_eq!(all(&cards, "*STEP").len(), 1);
    let pressed = &all(&cards, "*DLOAD")[0].data;
    assert_eq!(
        pressed.len(),
        scene.mesh.surface("block_w+").unwrap().faces.len()
    );
    for line in pressed {
        let (place, pressure) = line.rsplit_once(',').unwrap();
        let (element, number) = place.split_once(",P").unwrap();
        close(pressure.parse().unwrap(), 30.0);
        let nodes = face(&scene, element.parse().unwrap(), number.parse().unwrap());
        assert!(
            nodes
                .iter()
                .all(|n| scene.mesh.points[*n as usize][2] == 1.0)
        );
    }
    let pulled = all(&cards, "*CLOAD")[0].data.iter().map(|l| numbers(l)[2]);
    close(pulled.sum(), 2.0);
    // Other programs keep a force that a step does not give anew: one that is taken off is written as zero.
    scene.steps.push(Step {
        factors: vec![("block_u+".into(), 0.0)],
        ..Step::to("off", 1.0)
    });
    let both = deck(&scene, &settings());
    let [on, off] = all(&both, "*CLOAD")[..] else {
        panic!("one in each step")
    };
    assert_eq!(on.data.len(), off.data.len());
    assert!(off.data.iter().all(|line| numbers(line)[2] == 0.0));
    // Held along x by the wall, free along y and z.
    let names: Vec<&str> = all(&cards, "*SPRING")
        .iter()
        .map(|c| c.keyword.as_str())
        .collect();
    assert_eq!(
        names,
        [
            "*SPRING,ELSET=BLOCK_SPRING_Y",
            "*SPRING,ELSET=BLOCK_SPRING_Z"
        ]
    );
    // A support that is linear in position goes node by node.
    let walls = &all(&cards, "*BOUNDARY")[0].data[3..];
    for line in walls {
        let terms = numbers(line);
        close(
            terms[3],
            0.5 + 0.1 * scene.mesh.points[terms[0] as usize - 1][1],
        );
    }
}

#[track_caller]
fn refused(scene: &Scene, settings: &Settings) -> InpError {
    match check(scene, settings) {
        Ok(_) => panic!("taken"),
        Err(error) => error,
    }
}

#[test]
fn what_cannot_be_expressed_is_named() {
    let mut rigid = stack();
    rigid.contacts[0].lower = Partner::Plane {
        point: [0.0; 3],
        normal: [0.0, 0.0, 1.0],
    };
    let error = refused(&rigid, &settings());
    assert!(matches!(&error, InpError::Plane { pair } if pair == "block-plate"));

    let mut twice = stack();
    twice.supports.push(Support {
        name: "lid".into(),
        surface: "block_w+".into(),
        components: [None, None, Some(0.0)],
        ..Support::default()
    });
    let text = refused(&twice, &settings()).to_string();
    assert!(
        text.contains("`top`") && text.contains("along z") && text.contains("`lid`"),
        "{text}"
    );

    let mut apart = stack();
    for point in &mut apart.mesh.points[..36] {
        point[2] += 3.0;
    }
    assert!(matches!(
        refused(&apart, &settings()),
        InpError::Apart { .. }
    ));
    // Faces that are made to travel as far meet.
    apart.rigid_planes[0].motion[2] = PlaneMotion::Held(-3.1);
    let cards = deck(&apart, &settings());
    assert_eq!(all(&cards, "*SURFACE")[0].data.len(), 6);

    let mut lost = stack();
    lost.rigid_planes[0].surface = "roof".into();
    lost.rigid_planes[0].motion = [PlaneMotion::Free; 3];
    assert!(refused(&lost, &settings()).to_string().contains("`roof`"));

    for value in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let wrong = Settings {
            contact_stiffness: Some(value),
            ..settings()
        };
        assert!(matches!(
            refused(&stack(), &wrong),
            InpError::NotPositive { .. }
        ));
    }
}

/// A block that is warm by 40 K and by 30 K/length more along x, and a plate that is not, in two steps.
#[test]
fn a_warm_body_has_its_expansion_and_the_temperatures_of_its_nodes() {
    let mut scene = stack();
    scene.temperatures.push(Temperature {
        name: "sun".into(),
        body: "block".into(),
        expansion: 12e-6,
        value: 40.0,
        gradient: [30.0, 0.0, 0.0],
    });
    scene.steps.push(Step::to("night", -0.5));
    let cards = deck(&scene, &settings());
    let expansions = all(&cards, "*EXPANSION");
    assert_eq!(expansions.len(), 1);
    close(numbers(&expansions[0].data[0])[0], 12e-6);
    assert_eq!(all(&cards, "*INITIAL CONDITIONS")[0].data, ["NALL,0."]);
    let steps = all(&cards, "*TEMPERATURE");
    assert_eq!(steps.len(), 2);
    let block = &scene.mesh.hexes[scene.mesh.bodies[0].elements.clone()];
    let nodes: std::collections::BTreeSet<u32> = block.as_flattened().iter().copied().collect();
    for (card, factor) in steps.iter().zip([1.0, -0.5]) {
        assert_eq!(card.data.len(), nodes.len());
        for (line, node) in card.data.iter().zip(&nodes) {
            let [number, value] = numbers(line)[..] else {
                panic!("{line}")
            };
            close(number, f64::from(node + 1));
            // The block is mirrored at x = 0: its middle is there.
            let x = scene.mesh.points[*node as usize][0];
            close(value, factor * (40.0 + 30.0 * x));
        }
    }
}
