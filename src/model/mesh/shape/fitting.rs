//! Least-squares cylinders and spheres: a first guess from linear equations, then Gauss-Newton on
//! the distances.

use nalgebra::{Matrix3, SMatrix, SVector, SymmetricEigen, Vector3};

use super::patch::Patch;
use super::surface_shape::Shape;

const ITERATIONS: usize = 30;

/// The cylinder next to the nodes, if there is one.
pub(super) fn cylinder(patch: &Patch) -> Option<Shape> {
    // The normals of a cylinder are perpendicular to its axis.
    let spread: Matrix3<f64> = patch
        .facets
        .iter()
        .map(|f| f.normal * f.normal.transpose() * f.area)
        .sum();
    let mut axis = least(&spread)?;
    let (mut point, mut radius) = circle(patch, axis)?;
    for _ in 0..ITERATIONS {
        let (e, f) = perpendicular(axis);
        let mut equations = Normal::<5>::default();
        for p in &patch.points {
            let from = p - point;
            let along = from.dot(&axis);
            let across = from - axis * along;
            let distance = across.norm();
            let out = across.try_normalize(0.0)?;
            // Unknowns: shifts of the point along e and f, tilts of the axis towards e and f, the
            // change of the radius.
            let (u, v) = (out.dot(&e), out.dot(&f));
            equations.add([-u, -v, -along * u, -along * v, -1.0], distance - radius);
        }
        let step = equations.solve()?;
        point += e * step[0] + f * step[1];
        axis = (axis + e * step[2] + f * step[3]).try_normalize(0.0)?;
        // Keep the point beside the middle of the patch, which is the origin.
        point -= axis * point.dot(&axis);
        radius += step[4];
        if step.norm() <= 1e-14 * radius.abs().max(1.0) {
            break;
        }
    }
    let towards = axis.iamax();
    let axis = if axis[towards] < 0.0 { -axis } else { axis };
    let sound = radius > 0.0 && radius.is_finite();
    let first = patch.facets.first().filter(|_| sound)?;
    let from = first.centre - point;
    let convex = (from - axis * from.dot(&axis)).dot(&first.normal) > 0.0;
    Some(Shape::Cylinder {
        point: point.into(),
        axis: axis.into(),
        radius,
        convex,
    })
}

/// The sphere next to the nodes, if there is one.
pub(super) fn sphere(patch: &Patch) -> Option<Shape> {
    // |p|^2 = 2 c . p + k is linear in the centre c and in k = r^2 - |c|^2.
    let mut equations = Normal::<4>::default();
    for p in &patch.points {
        equations.add([2.0 * p.x, 2.0 * p.y, 2.0 * p.z, 1.0], -p.norm_squared());
    }
    let guess = equations.solve()?;
    let mut centre = Vector3::new(guess[0], guess[1], guess[2]);
    let mut radius = (guess[3] + centre.norm_squared()).max(0.0).sqrt();
    for _ in 0..ITERATIONS {
        let mut equations = Normal::<4>::default();
        for p in &patch.points {
            let out = (p - centre).try_normalize(0.0)?;
            equations.add([-out.x, -out.y, -out.z, -1.0], (p - centre).norm() - radius);
        }
        let step = equations.solve()?;
        centre += Vector3::new(step[0], step[1], step[2]);
        radius += step[3];
        if step.norm() <= 1e-14 * radius.abs().max(1.0) {
            break;
        }
    }
    let sound = radius > 0.0 && radius.is_finite();
    let first = patch.facets.first().filter(|_| sound)?;
    let convex = (first.centre - centre).dot(&first.normal) > 0.0;
    Some(Shape::Sphere {
        centre: centre.into(),
        radius,
        convex,
    })
}

/// A circle through the nodes seen along `axis`: a point of its axis, and its radius.
fn circle(patch: &Patch, axis: Vector3<f64>) -> Option<(Vector3<f64>, f64)> {
    let (e, f) = perpendicular(axis);
    let mut equations = Normal::<3>::default();
    for p in &patch.points {
        let (x, y) = (p.dot(&e), p.dot(&f));
        equations.add([2.0 * x, 2.0 * y, 1.0], -(x * x + y * y));
    }
    let [x, y, k] = equations.solve()?.into();
    Some((e * x + f * y, (k + x * x + y * y).max(0.0).sqrt()))
}

/// Two unit vectors that make a right-handed frame with `axis`.
fn perpendicular(axis: Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
    let mut other = Vector3::zeros();
    other[axis.iamin()] = 1.0;
    let e = axis.cross(&other).normalize();
    (e, axis.cross(&e))
}

/// The unit vector along which a symmetric matrix is least.
fn least(matrix: &Matrix3<f64>) -> Option<Vector3<f64>> {
    let eigen = SymmetricEigen::try_new(*matrix, f64::EPSILON, 1000)?;
    eigen
        .eigenvectors
        .column(eigen.eigenvalues.imin())
        .into_owned()
        .try_normalize(0.0)
}

/// Normal equations of a least-squares problem with `N` unknowns.
struct Normal<const N: usize> {
    matrix: SMatrix<f64, N, N>,
    right: SVector<f64, N>,
}

impl<const N: usize> Default for Normal<N> {
    fn default() -> Self {
        Self {
            matrix: SMatrix::zeros(),
            right: SVector::zeros(),
        }
    }
}

impl<const N: usize> Normal<N> {
    /// Adds the equation `row . unknowns + residual = 0`.
    fn add(&mut self, row: [f64; N], residual: f64) {
        let row = SVector::from(row);
        self.matrix += row * row.transpose();
        self.right -= row * residual;
    }

    /// The solution, if the unknowns are determined.
    fn solve(self) -> Option<SVector<f64, N>> {
        // Scaled to a unit diagonal; full pivoting tells a singular matrix.
        let scale = self
            .matrix
            .diagonal()
            .map(|d| if d > 0.0 { d.sqrt().recip() } else { 0.0 });
        let scaled = SMatrix::from_diagonal(&scale) * self.matrix * SMatrix::from_diagonal(&scale);
        let solution = gauss(scaled, self.right.component_mul(&scale))?.component_mul(&scale);
        solution.iter().all(|c| c.is_finite()).then_some(solution)
    }
}

/// Gauss elimination with full pivoting.
fn gauss<const N: usize>(
    mut a: SMatrix<f64, N, N>,
    mut b: SVector<f64, N>,
) -> Option<SVector<f64, N>> {
    let mut order: [usize; N] = std::array::from_fn(|k| k);
    for k in 0..N {
        let (mut row, mut column) = (k, k);
        for i in k..N {
            for j in k..N {
                if a[(i, j)].abs() > a[(row, column)].abs() {
                    (row, column) = (i, j);
                }
            }
        }
        if a[(row, column)].is_nan() || a[(row, column)] == 0.0 {
            return None;
        }
        a.swap_rows(k, row);
        b.swap_rows(k, row);
        a.swap_columns(k, column);
        order.swap(k, column);
        for i in k + 1..N {
            let factor = a[(i, k)] / a[(k, k)];
            for j in k..N {
                a[(i, j)] -= factor * a[(k, j)];
            }
            b[i] -= factor * b[k];
        }
    }
    let mut x = SVector::<f64, N>::zeros();
    for k in (0..N).rev() {
        let known: f64 = (k + 1..N).map(|j| a[(k, j)] * x[order[j]]).sum();
        x[order[k]] = (b[k] - known) / a[(k, k)];
    }
    Some(x)
}
