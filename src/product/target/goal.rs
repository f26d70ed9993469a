//! What is asked for: `3%` of all certified figures together, or `mises=2%` of one.

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
    /// [`Goal::CERTIFIED`], together.
    Certified,
    /// The largest nodal Mises stress; where that has yielded, the largest of the elastic solution
    /// and the largest plastic strain.
    Mises,
    /// The largest nodal Mises stress of the elastic solution, away from loaded edges.
    ElasticMises,
    PlasticStrain,
    Pressure,
    HertzPressure,
    LineLoad,
    Bore,
    HalfWidth,
    Area,
    Descent,
}

/// A target that cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error, miette::Diagnostic)]
#[error("`{text}` is no target")]
#[diagnostic(
    code(brinell::target),
    help(
        "the largest error of all certified figures, such as 3%, or a figure and its largest error, such as \
         mises=2%; figures: {}",
        Goal::SINGLE.map(Goal::name).join(", ")
    )
)]
pub struct TargetError {
    /// What was written.
    pub text: String,
}

impl Goal {
    /// That no figure of the certificate is one of it.
    pub fn has_no_claim(self) -> String {
        format!(
            "the certificate has no {}, as where nothing yields, or where a fillet or an edge decides it: the last summary has what is \
             not resolved, and why",
            self.name()
        )
    }

    /// What a bearing is judged by.
    pub const CERTIFIED: [Self; 6] = [
        Self::Pressure,
        Self::HertzPressure,
        Self::LineLoad,
        Self::ElasticMises,
        Self::Bore,
        Self::Descent,
    ];

    const SINGLE: [Self; 10] = [
        Self::Mises,
        Self::ElasticMises,
        Self::PlasticStrain,
        Self::Pressure,
        Self::HertzPressure,
        Self::LineLoad,
        Self::Bore,
        Self::HalfWidth,
        Self::Area,
        Self::Descent,
    ];

    /// Is that figure of the elastic twin, where steel flows?
    pub(super) fn is_elastic(self) -> bool {
        matches!(self, Self::Mises | Self::ElasticMises | Self::HertzPressure)
    }

    /// As it is asked for.
    pub fn name(self) -> &'static str {
        match self {
            Self::Certified => "certified figures",
            Self::Mises => "mises",
            Self::ElasticMises => "elastic-mises",
            Self::PlasticStrain => "plastic-strain",
            Self::Pressure => "pressure",
            Self::HertzPressure => "hertz-p0",
            Self::LineLoad => "line-load",
            Self::Bore => "bore",
            Self::HalfWidth => "half-width",
            Self::Area => "area",
            Self::Descent => "descent",
        }
    }
}

impl FromStr for Target {
    type Err = TargetError;

    fn from_str(text: &str) -> Result<Self, TargetError> {
        let bad = || TargetError {
            text: text.to_owned(),
        };
        let (goal, share) = match text.split_once('=') {
            Some((name, share)) => {
                let named = |goal: &Goal| goal.name() == name.trim();
                let goal = Goal::SINGLE.into_iter().find(named);
                (goal.ok_or_else(bad)?, share)
            }
            None => (Goal::Certified, text),
        };
        let number = share.trim().strip_suffix('%').ok_or_else(bad)?;
        let percent: f64 = number.trim().parse().map_err(|_| bad())?;
        let sensible = percent > 0.0 && percent <= 100.0;
        sensible
            .then_some(Self {
                goal,
                within: percent / 100.0,
            })
            .ok_or_else(bad)
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
        let all: Target = "3%".parse().unwrap();
        assert_eq!((all.goal, all.within), (Goal::Certified, 0.03));
        for bad in [
            "",
            "mises",
            "mises=2",
            "3",
            "=3%",
            "certified figures=3%",
            "mises=0%",
            "mises=-1%",
            "mises=NaN%",
            "mass=2%",
        ] {
            assert!(bad.parse::<Target>().is_err(), "{bad}");
        }
    }
}
