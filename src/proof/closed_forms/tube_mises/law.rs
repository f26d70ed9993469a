//! Mises plasticity with linear isotropic hardening where the axial strain is zero.

/// Isotropic elasticity and hardening, in the form the return map uses.
pub(super) struct MisesLaw {
    pub bulk: f64,
    pub shear: f64,
    pub yield_stress: f64,
    pub hardening: f64,
}

/// Plastic strain (radial, hoop, axial) and its accumulated size at an integration point.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct PlasticState {
    pub strain: [f64; 3],
    pub size: f64,
}

/// Radial and hoop stress, their derivatives with the radial and hoop strain, new state.
pub(super) struct LawResponse {
    pub stress: [f64; 2],
    pub tangent: [[f64; 2]; 2],
    pub plastic: PlasticState,
}

impl MisesLaw {
    /// Radial return from the plastic strain `old` at the strain (radial, hoop), axial strain zero.
    pub fn respond(&self, strain: [f64; 2], old: &PlasticState) -> LawResponse {
        let volume = strain[0] + strain[1];
        let elastic = [
            strain[0] - old.strain[0],
            strain[1] - old.strain[1],
            -old.strain[2],
        ];
        let trial = elastic.map(|e| 2.0 * self.shear * (e - volume / 3.0));
        let norm = trial.iter().map(|s| s * s).sum::<f64>().sqrt();
        let mises = 1.5f64.sqrt() * norm;
        let excess = mises - self.yield_stress - self.hardening * old.size;
        if excess <= 0.0 {
            return self.response(volume, trial, 1.0, None, *old);
        }
        let growth = excess / (3.0 * self.shear + self.hardening);
        let direction = trial.map(|s| s / norm);
        let grow = |i: usize| old.strain[i] + 1.5f64.sqrt() * growth * direction[i];
        let plastic = PlasticState {
            strain: [grow(0), grow(1), grow(2)],
            size: old.size + growth,
        };
        let scale = 1.0 - 3.0 * self.shear * growth / mises;
        let slope = 3.0 * self.shear / (3.0 * self.shear + self.hardening);
        self.response(
            volume,
            trial,
            scale,
            Some((direction, slope - 1.0 + scale)),
            plastic,
        )
    }

    /// `scale` shrinks the trial deviator; `flow` is its direction and how much softer it is along
    /// that direction.
    fn response(
        &self,
        volume: f64,
        trial: [f64; 3],
        scale: f64,
        flow: Option<([f64; 3], f64)>,
        plastic: PlasticState,
    ) -> LawResponse {
        let stress = [0, 1].map(|i| self.bulk * volume + scale * trial[i]);
        let tangent = [0, 1].map(|i| {
            [0, 1].map(|j| {
                let unit = if i == j { 2.0 / 3.0 } else { -1.0 / 3.0 };
                let along = flow.map_or(0.0, |(n, soft)| soft * n[i] * n[j]);
                self.bulk + 2.0 * self.shear * (scale * unit - along)
            })
        });
        LawResponse {
            stress,
            tangent,
            plastic,
        }
    }
}
