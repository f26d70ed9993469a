//! Reads the keys of `[line_bearing]` that have its geometry. Whether the dimensions make a bearing is for
//! [`LineGeometry::check`] to say.

use super::geometry::{LineGeometry, LinePlate, PlateCurve};
use super::limits::MOST_ROLLERS;
use crate::case::bearing::reader::{BearingReader, plan};
use crate::case::bearing::roller_shape::RollerShape;
use crate::case::error::{CaseError, ErrorKind};
use crate::case::keys;
use crate::ground::units::Dimension;

impl BearingReader<'_, '_> {
    /// Parallel rollers.
    pub fn line_geometry(&mut self) -> Result<LineGeometry, CaseError> {
        let diameter = self.length("roller_diameter")?;
        let wall = self.wall()?;
        let length = self.length("roller_length")?;
        let rollers = self.rollers()?;
        let spacing = match (self.table.get("spacing"), rollers) {
            (Some(field), 2..) => field.quantity(Dimension::LENGTH)?.value,
            (None, 2..) => {
                let help = "the distance between the axes of neighbouring rollers";
                let field = (self.table.need("spacing")).map_err(|error| error.help(help))?;
                field.quantity(Dimension::LENGTH)?.value
            }
            (Some(field), _) => {
                let why = "is the distance between rollers, and there is one";
                let error = field.place().error(ErrorKind::Conflict, why);
                return Err(error.help("drop it, or give `rollers`"));
            }
            (None, _) => 0.0,
        };
        let [upper, lower] = self.thicknesses(["upper", "lower"], &keys::LINE_PLATE_THICKNESS)?;
        let own = [spacing * (rollers as f64 - 1.0) + 1.5 * diameter, length];
        let [upper_plan, lower_plan] = self.plate_plans(own)?;
        Ok(LineGeometry {
            rollers,
            spacing,
            roller: RollerShape {
                diameter,
                wall,
                length,
                end: self.end()?,
            },
            skew: self.skew(rollers)?,
            upper: LinePlate {
                thickness: upper,
                plan: upper_plan,
            },
            lower: LinePlate {
                thickness: lower,
                plan: lower_plan,
            },
            curve: self.plate_curve()?,
            alike: true,
        })
    }

    fn rollers(&self) -> Result<usize, CaseError> {
        let Some(field) = self.table.get("rollers") else {
            return Ok(1);
        };
        let count = field.count()?.value;
        // A number that no memory holds gets no further.
        match count > MOST_ROLLERS {
            true => {
                let why = format!("must lie between 1 and {MOST_ROLLERS}");
                let error = field.place().error(ErrorKind::Value, why);
                Err(error.help("how many rollers lie side by side"))
            }
            false => Ok(count),
        }
    }

    /// Upper, lower; `own` where the case does not say.
    fn plate_plans(&mut self, own: [f64; 2]) -> Result<[[f64; 2]; 2], CaseError> {
        let plans = match self.table.get("plate_size") {
            None => [own; 2],
            Some(field) if field.is_table() => {
                let table = field.table()?.only(&keys::LINE_PLATE_SIZE)?;
                [plan(&table.need("upper")?)?, plan(&table.need("lower")?)?]
            }
            Some(field) => [plan(&field)?; 2],
        };
        let shown = |[x, y]: [f64; 2]| format!("{} x {}", self.show(x), self.show(y));
        let text = match plans[0] == plans[1] {
            true => shown(plans[0]),
            false => format!("{} above, {} below", shown(plans[0]), shown(plans[1])),
        };
        let why = "by default 3/4 of a diameter beyond the outermost axes along x, and as long as a roller along y";
        self.note("plate_size", text, why);
        Ok(plans)
    }

    fn plate_curve(&self) -> Result<Option<PlateCurve>, CaseError> {
        let Some(field) = self.table.get("plate_curve") else {
            return Ok(None);
        };
        let table = field.table()?.only(&keys::LINE_PLATE_CURVE)?;
        let plates = [("upper", true), ("lower", false)];
        let senses = [("convex", true), ("concave", false)];
        Ok(Some(PlateCurve {
            upper: table.need("plate")?.choice(&plates)?.value,
            radius: (table.need("radius")?.quantity(Dimension::LENGTH)?)
                .positive()?
                .value,
            convex: table.need("sense")?.choice(&senses)?.value,
        }))
    }

    /// Is no use made of symmetry? `geometry` knows whether the steels allow it.
    pub fn line_full(
        &mut self,
        geometry: &LineGeometry,
        breaks: Option<&str>,
    ) -> Result<bool, CaseError> {
        let full = self.flag("full")?.is_some_and(|asked| asked.value);
        let images = match geometry.rollers {
            1 => String::new(),
            n => format!(
                "; {} stands for {} too, and so on",
                geometry.body(n),
                geometry.body(1)
            ),
        };
        let broken = breaks.map(|breaks| format!("{breaks} breaks the symmetry"));
        let (text, why) = match (full, geometry.alike) {
            (false, _) if broken.is_some() => (
                "the whole bearing".to_owned(),
                broken.as_deref().unwrap_or_default(),
            ),
            (true, _) => ("the whole bearing".to_owned(), "no use is made of symmetry"),
            (false, true) => (
                format!("a quarter{images}"),
                "parallel rollers under a central load are symmetric about x = 0 and y = 0",
            ),
            (false, false) => (
                "a half".to_owned(),
                "symmetric about y = 0 only: rollers left and right are of different steels or temperatures",
            ),
        };
        self.note("full", text, why);
        Ok(full || broken.is_some())
    }
}
