//! Names of sets as decks take them: capital letters, digits and underscores, each used once.

use crate::model::mesh::Mesh;
use std::collections::BTreeSet;

/// Names longer than this are cut: programs take 80 characters.
const LONGEST: usize = 60;

/// The names of a deck.
pub struct Names {
    bodies: Vec<String>,
    surfaces: Vec<String>,
    taken: BTreeSet<String>,
}

impl Names {
    pub fn new(mesh: &Mesh) -> Self {
        let mut names = Self {
            bodies: Vec::new(),
            surfaces: Vec::new(),
            taken: BTreeSet::from(["NALL".to_string(), "EALL".to_string()]),
        };
        for body in &mesh.bodies {
            let name = names.unused(&body.name);
            names.bodies.push(name);
        }
        for surface in &mesh.surfaces {
            let name = names.unused(&surface.name);
            names.surfaces.push(name);
        }
        names
    }

    /// Element set, material and section of body `index`.
    pub fn body(&self, index: usize) -> &str {
        &self.bodies[index]
    }

    /// Node set of the mesh's surface `index`.
    pub fn surface(&self, index: usize) -> &str {
        &self.surfaces[index]
    }

    /// A name for `wanted` that nothing else has.
    pub fn unused(&mut self, wanted: &str) -> String {
        let plain = |c: char| {
            if c.is_ascii_alphanumeric() {
                c.to_ascii_uppercase()
            } else {
                '_'
            }
        };
        let mut base: String = wanted.chars().take(LONGEST).map(plain).collect();
        if !base.starts_with(|c: char| c.is_ascii_alphabetic()) {
            base.insert_str(0, "N_");
        }
        let mut name = base.clone();
        let mut count = 1;
        while !self.taken.insert(name.clone()) {
            count += 1;
            name = format!("{base}_{count}");
        }
        name
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_plain_and_differ() {
        let mut names = Names::new(&Mesh::default());
        assert_eq!(names.unused("upper-plate"), "UPPER_PLATE");
        assert_eq!(names.unused("Upper plate"), "UPPER_PLATE_2");
        assert_eq!(names.unused("eall"), "EALL_2");
        assert_eq!(names.unused("2é"), "N_2_");
        assert_eq!(names.unused(""), "N_");
        assert_eq!(names.unused(&"x".repeat(200)).len(), LONGEST);
    }
}
