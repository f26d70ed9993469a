//! Strain energy of a stress.

use crate::model::material::Steel;

/// τ : C⁻¹ : τ of a stress.
pub(super) fn density(stress: &[f64; 6], steel: &Steel) -> f64 {
    work(stress, &elastic_strain(stress, steel))
}

/// C⁻¹ : σ, with engineering shears.
pub(super) fn elastic_strain(stress: &[f64; 6], steel: &Steel) -> [f64; 6] {
    let (e, nu) = (steel.youngs_modulus, steel.poissons_ratio);
    let trace = stress[0] + stress[1] + stress[2];
    std::array::from_fn(|i| match i < 3 {
        true => ((1.0 + nu) * stress[i] - nu * trace) / e,
        false => 2.0 * (1.0 + nu) * stress[i] / e,
    })
}

/// σ : ε of a stress and a strain with engineering shears.
pub(super) fn work(stress: &[f64; 6], strain: &[f64; 6]) -> f64 {
    stress.iter().zip(strain).map(|(s, e)| s * e).sum()
}
