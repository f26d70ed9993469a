//! The strains that the stress of an element is free of.

use crate::model::material::j2::PlasticPoint;
use crate::solver::solve::model::system::Model;

impl Model<'_> {
    /// The thermal strain along every axis at the integration points of `element`, at share `time` of `step`; `None`
    /// where there is none.
    pub fn thermal_strain(&self, element: u32, (step, time): (usize, f64)) -> Option<[f64; 8]> {
        let mut sum = None;
        for body in &self.heated {
            let element = element as usize;
            if !body.elements.contains(&element) {
                continue;
            }
            let factor = self.scene.factor(&body.name, step, time);
            let strain = &body.strain[element - body.elements.start];
            let sum = sum.get_or_insert([0.0; 8]);
            sum.iter_mut()
                .zip(strain)
                .for_each(|(s, e)| *s += factor * e);
        }
        sum
    }

    /// The strains that the stress of `element` is free of: those of `points` and the thermal one.
    pub fn free_strains(
        &self,
        element: u32,
        mut points: [PlasticPoint; 8],
        moment: (usize, f64),
    ) -> [PlasticPoint; 8] {
        if let Some(strain) = self.thermal_strain(element, moment) {
            for (point, strain) in points.iter_mut().zip(strain) {
                point.strain[..3].iter_mut().for_each(|e| *e += strain);
            }
        }
        points
    }
}
