//! What is asked for: `mises=2%`.

use std::str::FromStr;

/// A figure and how good it must be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Target {
    pub goal: Goal,
    /// Largest error, relative to the figure.
    pub within: f64,
}

/// The figures that can be asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Goal {
    /// The largest nodal Mises stress; where that has yielded, the largest of the elastic solution
    /// and the largest plastic strain.
    Mises,
    PlasticStrain,
    Pressure,
    HalfWidth,
    Area,
    Descent,
}

/// A target that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error, miette::Diagnostic)]
#[error("`{0}` is no target")]
#[diagnostic(
    code(brinell::target),
    help(
        "a figure and its largest error, such as mises=2%; figures: mises, plastic-strain, \
         pressure, half-width, area, descent"
    )
)]
pub struct TargetError(pub String);

impl Goal {
    const ALL: [Self; 6] = [
        Self::Mises,
        Self::PlasticStrain,
        Self::Pressure,
        Self::HalfWidth,
        Self::Area,
        Self::Descent,
    ];

    /// As it is asked for.
    pub fn name(self) -> &'static str {
        match self {
            Self::Mises => "mises",
            Self::PlasticStrain => "plastic-strain",
            Self::Pressure => "pressure",
            Self::HalfWidth => "half-width",
            Self::Area => "area",
            Self::Descent => "descent",
        }
    }
}

impl FromStr for Target {
    type Err = TargetError;

    fn from_str(text: &str) -> Result<Self, TargetError> {
        let bad = || TargetError(text.to_owned());
        let (name, share) = text.split_once('=').ok_or_else(bad)?;
        let goal = Goal::ALL.into_iter().find(|g| g.name() == name.trim());
        let number = share.trim().strip_suffix('%').ok_or_else(bad)?;
        let percent: f64 = number.trim().parse().map_err(|_| bad())?;
        let sensible = percent > 0.0 && percent <= 100.0;
        Ok(Self {
            goal: goal.filter(|_| sensible).ok_or_else(bad)?,
            within: percent / 100.0,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn targets_are_read() {
        let target: Target = "mises=2%".parse().unwrap();
        assert_eq!((target.goal, target.within), (Goal::Mises, 0.02));
        assert!("half-width = 0.5 %".parse::<Target>().is_ok());
        for bad in [
            "",
            "mises",
            "mises=2",
            "mises=0%",
            "mises=-1%",
            "mises=NaN%",
            "mass=2%",
        ] {
            assert!(bad.parse::<Target>().is_err(), "{bad}");
        }
    }
}
