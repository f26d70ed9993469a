//! Problem H solved by other programs: stored results, with where they come from.

use super::ConvergeError;
use serde::Deserialize;

/// Stored results.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Peers {
    /// Programs, meshes, machine and references, in words.
    pub origin: Vec<String>,
    pub curves: Vec<PeerCurve>,
}

/// One program and method over its meshes.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct PeerCurve {
    pub program: String,
    pub element: String,
    pub contact: String,
    pub rows: Vec<PeerRow>,
}

/// One mesh.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct PeerRow {
    /// Elements across the half-width.
    pub a_over_h: u32,
    /// Held components included.
    pub unknowns: usize,
    pub cpu_s: f64,
    pub memory_mb: f64,
    pub error_percent: PeerErrors,
}

/// Errors in percent.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct PeerErrors {
    pub p0: Option<f64>,
    pub half_width: Option<f64>,
    pub integration_point_block: Option<f64>,
    pub integration_point_cylinder: Option<f64>,
    pub nodal_block: Option<f64>,
    pub nodal_cylinder: Option<f64>,
}

impl PeerErrors {
    /// The error of what Brinell calls `quantity`, as a share.
    pub fn of(&self, quantity: &str) -> Option<f64> {
        let percent = match quantity {
            "p0" => self.p0,
            "half-width" => self.half_width,
            "Mises block, integration point" => self.integration_point_block,
            "Mises cylinder, integration point" => self.integration_point_cylinder,
            "Mises block, nodal" => self.nodal_block,
            "Mises cylinder, nodal" => self.nodal_cylinder,
            _ => None,
        };
        percent.map(|p| 0.01 * p)
    }
}

impl PeerCurve {
    /// For legends and tables.
    pub fn name(&self) -> String {
        format!("{} {}, {}", self.program, self.element, self.contact)
    }
}

/// The stored results.
///
/// # Errors
/// Never, as long as the stored file is sound.
pub fn peers() -> Result<Peers, ConvergeError> {
    serde_json::from_str(include_str!("peers.json"))
        .map_err(|error| ConvergeError::Peers(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stored_results_are_whole() {
        let peers = peers().unwrap();
        assert_eq!(peers.curves.len(), 4);
        for curve in &peers.curves {
            let refined = |w: &[PeerRow]| w[0].a_over_h < w[1].a_over_h && w[0].cpu_s < w[1].cpu_s;
            assert!(curve.rows.windows(2).all(refined), "{}", curve.name());
            assert!(
                curve
                    .rows
                    .iter()
                    .all(|r| r.error_percent.of("p0").is_some())
            );
        }
    }
}
