//! Values by name, and the three readings of a Mises peak.

use serde::{Serialize, Serializer};

/// One value for each of the three ways to read a Mises peak.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize)]
pub struct Three<T> {
    /// Of the mean of an element's integration points.
    pub centroid: T,
    /// At an integration point.
    pub integration_point: T,
    /// Extrapolated to the nodes and averaged.
    pub nodal: T,
}

impl<T: Copy> Three<T> {
    /// The three in the order of their printing.
    pub fn each(&self) -> [T; 3] {
        [self.centroid, self.integration_point, self.nodal]
    }
}

/// Named values in the order of the scene; an object in JSON.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Named<T>(pub Vec<(String, T)>);

impl<T: Serialize> Serialize for Named<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}

impl<T> Named<T> {
    /// The value called `name`.
    pub fn get(&self, name: &str) -> Option<&T> {
        self.0
            .iter()
            .find(|(n, _)| n == name)
            .map(|(_, value)| value)
    }
}
