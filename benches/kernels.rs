//! Time of the parts that a solution is made of: `cargo bench`.

use brinell::answer::results::recovery::recover;
use brinell::model::material::Steel;
use brinell::model::material::j2::{self, PlasticPoint};
use brinell::model::mesh::Mesh;
use brinell::model::mesh::block::{Block as Brick, uniform};
use brinell::model::mesh::family::problem_h::{Sizes, half};
use brinell::model::mesh::msh;
use brinell::model::scene::{ElementKind, Scene};
use brinell::model::state::State;
use brinell::render::fields;
use brinell::solver::contact::mortar::{self, Opposite, Pair};
use brinell::solver::fem::element::Element;
use brinell::solver::linear::cholesky::Symbolic;
use brinell::solver::linear::ordering::Block;
use brinell::solver::linear::sparse::{Pattern, SymmetricMatrix};
use brinell::solver::linear::substructure::Condensation;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

const STEEL: Steel = Steel {
    youngs_modulus: 29500.0,
    poissons_ratio: 0.3,
    yield_stress: 100.0,
    hardening_modulus: 249.471,
};
const KINDS: [ElementKind; 2] = [ElementKind::Bbar, ElementKind::Enhanced];

/// A cube of `cells` elements along each edge.
fn cube(cells: usize) -> Mesh {
    let list = || uniform(0.0, 1.0, cells);
    let brick = Brick::new("cube", list(), list(), list());
    brick.build().expect("a valid brick")
}

fn equations(nodes: &[u32; 8]) -> [u32; 24] {
    std::array::from_fn(|k| 3 * nodes[k / 3] + (k % 3) as u32)
}

fn pattern(mesh: &Mesh) -> Pattern {
    let starts = (0..=mesh.points.len() as u32).map(|n| 3 * n).collect();
    Pattern::new(starts, mesh.hexes.iter().map(|h| h.as_slice()))
}

/// Elastic stiffness of a cube with one face tied to the ground by springs.
fn stiffness(mesh: &Mesh, pattern: &Pattern) -> SymmetricMatrix {
    let mut matrix = pattern.zeros();
    for (index, nodes) in mesh.hexes.iter().enumerate() {
        let element = Element::new(ElementKind::Bbar, &mesh.corners(index));
        let block = element.stiffness(&STEEL.moduli());
        pattern.add_block(&mut matrix, &equations(nodes), |i, j| block[i][j]);
    }
    for (node, point) in mesh.points.iter().enumerate() {
        if point[2] == 0.0 {
            let node = node as u32;
            let own = [3 * node, 3 * node + 1, 3 * node + 2];
            pattern.add_block(&mut matrix, &own, |i, j| if i == j { 1e6 } else { 0.0 });
        }
    }
    matrix
}

#[divan::bench(args = KINDS)]
fn element_stiffness(bencher: Bencher, kind: ElementKind) {
    let element = Element::new(kind, &cube(1).corners(0));
    let moduli = STEEL.moduli();
    bencher.bench(|| black_box(&element).stiffness(&moduli));
}

#[divan::bench(args = KINDS)]
fn element_update_in_flow(bencher: Bencher, kind: ElementKind) {
    let element = Element::new(kind, &cube(1).corners(0));
    let moduli = STEEL.moduli();
    let corners = cube(1).corners(0);
    let u = corners.map(|[x, y, z]| [0.01 * x, -0.004 * y + 0.001 * x * z, 0.002 * z]);
    let old = [PlasticPoint::default(); 8];
    bencher.bench(|| black_box(&element).answer(&STEEL, &moduli, &u, &old));
}

#[divan::bench]
fn radial_return(bencher: Bencher) {
    let moduli = STEEL.moduli();
    let strain = [0.01, -0.004, -0.004, 0.002, 0.0, 0.001];
    let old = PlasticPoint::default();
    bencher.bench(|| j2::update(&STEEL, &moduli, black_box(&strain), &old));
}

#[divan::bench(args = [8, 16, 32])]
fn contact_rows(bencher: Bencher, across: usize) {
    let mesh = half(&Sizes::with(across)).expect("problem H");
    let surface = |name| mesh.surface(name).expect("a surface of problem H");
    let pair = Pair {
        mesh: &mesh,
        carrier: surface("cylinder_contact"),
        opposite: Opposite::Surface(surface("block_contact")),
        true_geometry: true,
        friction: true,
        closely: false,
        follow: &[],
        reach: 1e-3,
        moduli: &[STEEL.youngs_modulus; 2],
        held: &[],
        mirrors: &[0],
    };
    bencher.bench(|| mortar::rows(&pair));
}

#[divan::bench(args = [10, 20])]
fn assembly(bencher: Bencher, cells: usize) {
    let mesh = cube(cells);
    let pattern = pattern(&mesh);
    bencher.bench(|| stiffness(&mesh, &pattern));
}

#[divan::bench(args = [10, 20, 26], sample_count = 5, sample_size = 1)]
fn factorisation(bencher: Bencher, cells: usize) {
    let mesh = cube(cells);
    let pattern = pattern(&mesh);
    let matrix = stiffness(&mesh, &pattern);
    let all = [Block::Sparse(0..mesh.points.len() as u32)];
    let symbolic = Symbolic::new(&pattern, &all).expect("memory");
    bencher.bench(|| symbolic.factorise::<f32>(&pattern, &matrix, None));
}

/// The same cube seen from its upper face.
#[divan::bench(args = [10, 20], sample_count = 5, sample_size = 1)]
fn condensation(bencher: Bencher, cells: usize) {
    let mesh = cube(cells);
    let pattern = pattern(&mesh);
    let matrix = stiffness(&mesh, &pattern);
    let top: Vec<bool> = mesh.points.iter().map(|p| p[2] == 1.0).collect();
    bencher.bench(|| {
        let condensation = Condensation::new(&pattern, &top)?;
        condensation.eliminate(&pattern, &matrix)
    });
}

/// A mesh file in memory, read as text.
#[divan::bench(args = [10, 40], sample_count = 5, sample_size = 1)]
fn reading(bencher: Bencher, cells: usize) {
    let text = msh::write::msh41(&cube(cells));
    bencher.bench(|| msh::parse(text.as_bytes(), "cube").expect("a mesh"));
}

/// Nodal averages of a state, as before each VTK file.
#[divan::bench(args = [10, 40], sample_count = 5, sample_size = 1)]
fn recovery(bencher: Bencher, cells: usize) {
    let (scene, state) = loaded(cells);
    bencher.bench(|| recover(&scene, &state));
}

/// The VTK file of an increment.
#[divan::bench(args = [10, 40], sample_count = 5, sample_size = 1)]
fn writing(bencher: Bencher, cells: usize) {
    let (scene, state) = loaded(cells);
    let recovered = recover(&scene, &state);
    let path = tempfile::tempdir().expect("a folder");
    let path = path.path().join("cube.vtu");
    bencher.bench(|| {
        let grid = fields::bodies(&scene, &state, &recovered).expect("a state of the scene");
        grid.write(&path)
    });
}

/// A cube with a state that does not compress well.
fn loaded(cells: usize) -> (Scene, State) {
    let mesh = cube(cells);
    let wave = |k: usize| (0.1 * k as f64).sin();
    let state = State {
        displacement: (mesh.points.iter())
            .map(|p| p.map(|c| 1e-3 * (7.0 * c).sin()))
            .collect(),
        stress: (0..mesh.hexes.len())
            .map(|e| std::array::from_fn(|k| std::array::from_fn(|i| wave(e + 3 * k + i))))
            .collect(),
        ..State::default()
    };
    (Scene::bare("cube", mesh, STEEL), state)
}
