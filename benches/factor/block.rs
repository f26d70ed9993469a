//! Matrices like those of a bearing's bodies: blocks of hexahedra on springs, elastic.

use brinell::model::material::Steel;
use brinell::model::mesh::Mesh;
use brinell::model::mesh::block::{Block, uniform};
use brinell::model::scene::ElementKind;
use brinell::solver::fem::element::Element;
use brinell::solver::linear::sparse::{Pattern, SymmetricMatrix};

const STEEL: Steel = Steel {
    youngs_modulus: 29500.0,
    poissons_ratio: 0.3,
    yield_stress: 100.0,
    hardening_modulus: 249.471,
};
/// Stiffness of the springs below the lowest nodes.
const SPRING: f64 = 1e6;

/// Cells of a block along x, y and z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cells(pub [usize; 3]);

impl Cells {
    pub fn words(self) -> String {
        let [x, y, z] = self.0;
        format!("{x} × {y} × {z}")
    }
}

/// The stiffness of a block of unit cells.
pub fn matrix(cells: Cells) -> Result<(Pattern, SymmetricMatrix), crate::kit::Failure> {
    let [x, y, z] = cells.0.map(|n| uniform(0.0, n as f64, n));
    let mesh: Mesh = Block::new("block", x, y, z).build()?;
    let starts = (0..=mesh.points.len() as u32).map(|n| 3 * n).collect();
    let pattern = Pattern::new(starts, mesh.hexes.iter().map(|h| h.as_slice()));
    let mut matrix = pattern.zeros();
    // All cells are alike.
    let stiffness = Element::new(ElementKind::Bbar, &mesh.corners(0)).stiffness(&STEEL.moduli());
    for nodes in &mesh.hexes {
        let equations: [u32; 24] = std::array::from_fn(|k| 3 * nodes[k / 3] + (k % 3) as u32);
        pattern.add_block(&mut matrix, &equations, |i, j| stiffness[i][j]);
    }
    for (node, _) in mesh.points.iter().enumerate().filter(|(_, p)| p[2] == 0.0) {
        let own = [0, 1, 2].map(|k| 3 * node as u32 + k);
        pattern.add_block(&mut matrix, &own, |i, j| if i == j { SPRING } else { 0.0 });
    }
    Ok((pattern, matrix))
}

/// What the factor is, exactly: no zeros stored beside it are counted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Size {
    pub entries: f64,
    /// Multiplications, additions, divisions and square roots.
    pub flops: f64,
}

/// The size of the factor under an order of the equations, the three of a node side by side.
pub fn factor_size(pattern: &Pattern, order: &[u32]) -> Size {
    const NONE: usize = usize::MAX;
    let nodes: Vec<usize> = order.iter().step_by(3).map(|e| *e as usize / 3).collect();
    let mut position = vec![0; nodes.len()];
    for (k, node) in nodes.iter().enumerate() {
        position[*node] = k;
    }
    // Row by row along the elimination tree, which grows with them.
    let mut below = vec![0usize; nodes.len()];
    let (mut parent, mut seen) = (vec![NONE; nodes.len()], vec![NONE; nodes.len()]);
    for (k, node) in nodes.iter().enumerate() {
        seen[k] = k;
        let neighbours = pattern.adjacency_start[*node]..pattern.adjacency_start[node + 1];
        for other in &pattern.adjacency[neighbours.start as usize..neighbours.end as usize] {
            let mut i = position[*other as usize];
            while i < k && seen[i] != k {
                seen[i] = k;
                below[i] += 1;
                if parent[i] == NONE {
                    parent[i] = k;
                }
                i = parent[i];
            }
        }
    }
    // A column of c entries takes c² operations.
    let columns = below
        .iter()
        .flat_map(|b| [1, 2, 3].map(|k| (3 * b + k) as f64));
    columns.fold(
        Size {
            entries: 0.0,
            flops: 0.0,
        },
        |sum, c| Size {
            entries: sum.entries + c,
            flops: sum.flops + c * c,
        },
    )
}
