//! What a page says of a calculation beside what was solved: scope, sketch, inputs, what verified the program.

/// Plain data, made by whoever knows the case.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Calculation {
    /// What is calculated, and how far that goes, in sentences.
    pub scope: Vec<String>,
    /// The published study that the case belongs to, by authors, title and number.
    pub cited: Option<&'static str>,
    /// Dimensions of a bearing.
    pub sketch: Option<Sketch>,
    /// Every input and where it comes from.
    pub inputs: Vec<InputRow>,
    /// What acts.
    pub actions: Vec<String>,
    /// Families of claims that cover what was used.
    pub verified: Vec<VerifiedBy>,
}

/// Where an input comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// The case file says it.
    Given,
    /// The case file does not, and nothing else would be usual.
    Default,
    /// The case file does not, and somebody has to judge it.
    Assumed,
}

impl Origin {
    /// In a word.
    pub fn name(self) -> &'static str {
        match self {
            Self::Given => "given",
            Self::Default => "default",
            Self::Assumed => "assumed",
        }
    }
}

/// An input.
#[derive(Debug, Clone, PartialEq)]
pub struct InputRow {
    /// Dotted key of the case file.
    pub key: String,
    /// As it stands there, or as it was taken.
    pub value: String,
    pub origin: Origin,
    /// What it is, or why it was taken.
    pub about: String,
}

/// A family of claims of the verification, as last measured.
#[derive(Debug, Clone, PartialEq)]
pub struct VerifiedBy {
    /// What of this run it covers.
    pub used: &'static str,
    pub family: &'static str,
    /// How many claims it has, and how many of them are outside of their tolerance.
    pub claims: usize,
    pub outside: usize,
}

/// The dimensions of a bearing, all lengths in the unit of the case.
#[derive(Debug, Clone, PartialEq)]
pub enum Sketch {
    /// Of crossed rollers.
    Crossed(CrossedSketch),
    /// Of parallel rollers.
    Line(LineSketch),
}

/// Parallel rollers between two plates.
#[derive(Debug, Clone, PartialEq)]
pub struct LineSketch {
    pub diameter: f64,
    pub wall: Option<f64>,
    pub length: f64,
    /// Where the axes of the rollers lie along x, ascending.
    pub places: Vec<f64>,
    /// Upper and lower plate.
    pub thickness: [f64; 2],
    /// Upper and lower plate, each along x and y.
    pub plan: [[f64; 2]; 2],
    /// Shape of the ends of the rollers, in words.
    pub ends: String,
    /// A plate whose face is curved, in a sentence.
    pub curved: Option<String>,
}

/// Two crossed rollers between three plates.
#[derive(Debug, Clone, PartialEq)]
pub struct CrossedSketch {
    pub diameter: f64,
    pub wall: Option<f64>,
    pub length: f64,
    /// Of each side of a valley, in radians.
    pub slope: f64,
    /// Of the roller axes from the middle of the intermediate plate.
    pub offset: f64,
    /// Upper, intermediate (where the valleys cross) and lower plate.
    pub thickness: [f64; 3],
    /// Of the plates, along x and y.
    pub plan: [f64; 2],
    /// Shape of the ends of the rollers, in words.
    pub ends: String,
}
