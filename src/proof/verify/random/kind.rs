//! The two kinds of random cases.

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RandomKind {
    /// Bearings of the template, on the mesh of the report.
    Bearing,
    /// Two or three blocks.
    Stack,
}

impl RandomKind {
    /// What they are, as a heading.
    pub fn title(self) -> &'static str {
        match self {
            Self::Bearing => "Bearings on `report-like`",
            Self::Stack => "Stacks of two or three blocks",
        }
    }

    /// What case `number` of a seed is called.
    pub fn name(self, seed: u64, number: usize) -> String {
        match self {
            Self::Bearing => format!("random-{seed}-{number:03}"),
            Self::Stack => format!("stack-{seed}-{number:03}"),
        }
    }
}

/// How many of each are drawn for a page.
pub const COUNT: [(RandomKind, usize); 2] = [(RandomKind::Bearing, 300), (RandomKind::Stack, 200)];
