//! A solid disc under two opposed point loads, in closed form.

use crate::analytic::error::{self, DomainError};

/// Radial, hoop and shear stress over P/πr_o at the share r/r_o of the radius and the angle θ.
///
/// Timoshenko and Goodier, art. 41.
pub(super) fn under_points(share: f64, theta: f64) -> Result<[f64; 3], DomainError> {
    let (sin, cos) = theta.sin_cos();
    let (along, across) = (share * cos, share * sin);
    let apart = (1.0 - along.abs()).hypot(across);
    error::require(
        "distance from the point load",
        apart,
        apart > 1e-9,
        "above zero",
    )?;
    // σ along the load, σ across it and their shear, over P/πr_o.
    let mut sum = [1.0, 1.0, 0.0];
    for side in [1.0, -1.0] {
        let depth = 1.0 - side * along;
        let field = -2.0 * depth / (depth * depth + across * across).powi(2);
        sum[0] += field * depth * depth;
        sum[1] += field * across * across;
        sum[2] -= side * field * depth * across;
    }
    let [x, y, xy] = sum;
    let (square, product) = ([cos * cos, sin * sin], sin * cos);
    Ok([
        x * square[0] + y * square[1] + 2.0 * xy * product,
        x * square[1] + y * square[0] - 2.0 * xy * product,
        (y - x) * product + xy * (square[0] - square[1]),
    ])
}
