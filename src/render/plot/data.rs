//! What is drawn: lines in panels, panels in a figure.

/// A line in a panel: its place in the legend, and its points.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    pub style: usize,
    /// Are the points shown, or only the line through them?
    pub dots: bool,
    pub points: Vec<(f64, f64)>,
}

impl Line {
    /// A line whose points are shown.
    pub fn dotted(style: usize, points: Vec<(f64, f64)>) -> Self {
        Self {
            style,
            dots: true,
            points,
        }
    }

    /// A curve: its points are as many as it takes.
    pub fn smooth(style: usize, points: Vec<(f64, f64)>) -> Self {
        Self {
            style,
            dots: false,
            points,
        }
    }
}

/// How the axes of a panel are divided.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// Both are logarithmic, over whole decades.
    Decades,
    /// Both are linear, and the upright one starts at zero where nothing is negative.
    Linear,
    /// Linear along, logarithmic upwards.
    DecadesUp,
}

/// One diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    pub title: String,
    /// What is drawn along and upwards, with units; an empty one has no label.
    pub axes: [String; 2],
    pub scale: Scale,
    pub lines: Vec<Line>,
    /// Dashed levels across the panel.
    pub dashed: Vec<f64>,
}

impl Panel {
    /// A diagram without dashed levels.
    pub fn new(title: String, axes: [String; 2], scale: Scale, lines: Vec<Line>) -> Self {
        Self {
            title,
            axes,
            scale,
            lines,
            dashed: Vec::new(),
        }
    }
}

/// Diagrams in two columns, with one legend. A figure with a single panel is a diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct PlotFigure {
    pub panels: Vec<Panel>,
    /// The names of the styles.
    pub legend: Vec<String>,
    /// What dashed levels are.
    pub dashed: String,
}

impl PlotFigure {
    /// One diagram without dashed levels.
    pub fn single(panel: Panel, legend: Vec<String>) -> Self {
        Self {
            panels: vec![panel],
            legend,
            dashed: String::new(),
        }
    }
}
