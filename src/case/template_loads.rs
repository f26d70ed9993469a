//! Loads beside the central vertical one that templates have in common: off the centre, sideways, moments, and what the
//! top does.

use super::error::{CaseError, ErrorKind};
use super::keys;
use super::parse::{Field, Table};
use super::rigid_plane::LARGEST_ANGLE;
use crate::ground::units::Dimension;
use crate::model::scene::{PlaneMotion, PlaneTurn};

/// Read from the table of a template. Of the whole bearing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TemplateLoads {
    /// Where the vertical load acts, along x and y from the middle of the top, a length.
    pub eccentricity: [f64; 2],
    /// Force on the top along x and y.
    pub horizontal: [f64; 2],
    /// Moment on the top about x and y.
    pub moment: [f64; 2],
    /// What the top does.
    pub top: Top,
}

/// What the top face does beside moving along z.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Top {
    /// It does not turn.
    #[default]
    Held,
    /// It turns about x and y under the moments.
    Free,
    /// It is turned by these angles about x and y, in radians.
    Tilted([f64; 2]),
}

impl TemplateLoads {
    /// Reads `eccentricity`, `horizontal`, `moment` and `top`, all of which may be left out.
    pub(super) fn read(table: &Table) -> Result<Self, CaseError> {
        let of = |key, dimension| {
            let pair = table.maybe(key, |field| pair(field, dimension))?;
            Ok(pair.unwrap_or_default())
        };
        let loads = Self {
            eccentricity: of("eccentricity", Dimension::LENGTH)?,
            horizontal: of("horizontal", Dimension::FORCE)?,
            moment: of("moment", Dimension::MOMENT)?,
            top: table.maybe("top", top)?.unwrap_or_default(),
        };
        if loads.top != Top::Free {
            let turning = ["eccentricity", "moment"].into_iter();
            let mut turning = turning.filter_map(|key| table.get(key));
            if let Some(field) = turning.next() {
                let why =
                    "changes nothing: the top does not turn, and what holds it bears the moment";
                let help = "say top = \"free\", or leave it out and read the moment of the top";
                return Err(field.place().error(ErrorKind::Conflict, why).help(help));
            }
        }
        Ok(loads)
    }

    /// Motion and turns of the top under the vertical load `vertical` down, where its face lies `above` the point that it
    /// turns about.
    pub(super) fn plane(&self, vertical: f64, above: f64) -> ([PlaneMotion; 3], [PlaneTurn; 3]) {
        let along = self.horizontal.map(|force| match force {
            0.0 => PlaneMotion::Held(0.0),
            _ => PlaneMotion::Driven(force),
        });
        let [ex, ey] = self.eccentricity;
        // r × F with F = (horizontal, −vertical), which acts at r = (e, above).
        let moment = [
            self.moment[0] - ey * vertical - above * self.horizontal[1],
            self.moment[1] + ex * vertical + above * self.horizontal[0],
        ];
        let stays = PlaneTurn::Held(0.0);
        let [x, y] = match self.top {
            Top::Held => [stays; 2],
            Top::Free => moment.map(PlaneTurn::Driven),
            Top::Tilted(angles) => angles.map(PlaneTurn::Held),
        };
        let [along_x, along_y] = along;
        (
            [along_x, along_y, PlaneMotion::Driven(-vertical)],
            [x, y, stays],
        )
    }

    /// What breaks the symmetry about x = 0 or y = 0, in words; `None` where both stay. A top that is free to turn
    /// under a central load does not break it.
    pub fn breaks_symmetry(&self) -> Option<&'static str> {
        let is = |pair: [f64; 2]| pair != [0.0; 2];
        match self.top {
            _ if is(self.eccentricity) => Some("an eccentric load"),
            _ if is(self.horizontal) => Some("a horizontal force"),
            _ if is(self.moment) => Some("a moment"),
            Top::Tilted(angles) if is(angles) => Some("a tilted top"),
            _ => None,
        }
    }
}

fn top(field: &Field) -> Result<Top, CaseError> {
    if field.is_text() {
        let choices = [("held", Top::Held), ("free", Top::Free)];
        return Ok(field.choice(&choices)?.value);
    }
    let table = field.table()?.only(&keys::TILTED_TOP)?;
    let tilt = table.need("tilt")?;
    let angles = pair(&tilt, Dimension::ANGLE)?;
    if angles.iter().any(|angle| angle.abs() > LARGEST_ANGLE) {
        let why = format!("angles are small here: {LARGEST_ANGLE} rad at most");
        return Err(tilt.place().error(ErrorKind::Value, why));
    }
    Ok(Top::Tilted(angles))
}

/// Two numbers or quantities, along or about x and y.
fn pair(field: &Field, dimension: Dimension) -> Result<[f64; 2], CaseError> {
    let items = field.list()?;
    let [x, y] = items.as_slice() else {
        let why = format!(
            "two components, of x and y, are wanted, these are {}",
            items.len()
        );
        return Err(field.place().error(ErrorKind::Value, why));
    };
    Ok([x.quantity(dimension)?.value, y.quantity(dimension)?.value])
}
