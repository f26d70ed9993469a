//! Small vector arithmetic on `[f64; 3]`.

/// A point or a vector: x, y, z.
pub type Vec3 = [f64; 3];

/// Names of the axes.
pub const AXES: [&str; 3] = ["x", "y", "z"];

/// a + b.
pub fn add(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// a − b.
pub fn sub(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `a` times a number.
pub fn scale(a: Vec3, s: f64) -> Vec3 {
    [a[0] * s, a[1] * s, a[2] * s]
}

/// Component by component.
pub fn times(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2]]
}

/// Scalar product.
pub fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Vector product, right-handed.
pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Euclidean length.
pub fn norm(a: Vec3) -> f64 {
    dot(a, a).sqrt()
}

/// `a` scaled to length one; `None` where it has no direction.
pub fn unit(a: Vec3) -> Option<Vec3> {
    let length = norm(a);
    (length > 0.0 && length.is_finite()).then(|| scale(a, 1.0 / length))
}

/// Two unit vectors that make a right-handed frame with the unit vector `n`.
pub fn tangents(n: Vec3) -> [Vec3; 2] {
    // The axis least aligned with n, so that the cross product is well conditioned.
    let least = (0..3)
        .min_by(|i, j| n[*i].abs().total_cmp(&n[*j].abs()))
        .unwrap_or(0);
    let mut axis = [0.0; 3];
    axis[least] = 1.0;
    let first = unit(cross(axis, n)).unwrap_or([1.0, 0.0, 0.0]);
    [first, cross(n, first)]
}

/// Least and largest of numbers; ∞ and −∞ where there are none.
pub fn range(numbers: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    let numbers = numbers.into_iter();
    numbers.fold(none, |[low, high], x| [low.min(x), high.max(x)])
}

/// The two corners of the box around points, the low one first; ∞ and −∞ where there are none.
pub fn bounds(points: impl IntoIterator<Item = Vec3>) -> [Vec3; 2] {
    let none = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    points.into_iter().fold(none, |[low, high], p| {
        [
            [0, 1, 2].map(|k| low[k].min(p[k])),
            [0, 1, 2].map(|k| high[k].max(p[k])),
        ]
    })
}

/// Those of `axes` whose coordinate plane the point `at` lies on, but for rounding.
pub fn planes_through(axes: &[usize], at: &Vec3) -> impl Iterator<Item = usize> {
    let size = at.iter().fold(0.0f64, |size, c| size.max(c.abs()));
    let on = at.map(|c| c.abs() <= 1e-9 * size);
    let axes = axes.iter().copied();
    axes.filter(move |axis| *axis < 3 && on[*axis])
}
