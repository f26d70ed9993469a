//! Reads the keys of `[bearing]`, noting what is taken for granted. Whether the dimensions make
//! a bearing is for [`BearingGeometry::check`] to say.

use super::end_shape::RollerEnd;
use super::geometry::BearingGeometry;
use super::roller_shape::RollerShape;
use super::skew;
use crate::case::assumption::Assumption;
use crate::case::error::{CaseError, ErrorKind};
use crate::case::keys;
use crate::case::parse::{Field, Table};
use crate::case::place::Located;
use crate::case::template_loads::TemplateLoads;
use crate::ground::units::Dimension;
use crate::model::scene::UNLOADED_SHARE;

/// Share of the load that is left after unloading, where the case does not say.
pub(in crate::case) const UNLOAD_TO: f64 = 1e-3;

/// The table `[bearing]`.
pub(in crate::case) struct BearingReader<'a, 'b> {
    pub(super) table: Table<'a>,
    name: &'static str,
    assumptions: &'b mut Vec<Assumption>,
}

impl<'a, 'b> BearingReader<'a, 'b> {
    /// Reads the table called `name`, whose keys are `keys`.
    pub fn new(
        root: &Table<'a>,
        (name, keys): (&'static str, &keys::Keys),
        assumptions: &'b mut Vec<Assumption>,
    ) -> Result<Self, CaseError> {
        let table = root.need(name)?.table()?.only(keys)?;
        Ok(Self {
            table,
            name,
            assumptions,
        })
    }

    pub fn quantity(&self, key: &str, dimension: Dimension) -> Result<Located<f64>, CaseError> {
        self.table.need(key)?.quantity(dimension)
    }

    /// What acts beside the vertical load.
    pub fn loads(&self) -> Result<TemplateLoads, CaseError> {
        TemplateLoads::read(&self.table)
    }

    /// Where its assumptions go.
    pub fn assumptions(&mut self) -> &mut Vec<Assumption> {
        self.assumptions
    }

    pub fn geometry(&mut self) -> Result<BearingGeometry, CaseError> {
        let diameter = self.length("roller_diameter")?;
        let wall = self.wall()?;
        let length = self.length("roller_length")?;
        let slope = self.quantity("slope", Dimension::ANGLE)?.value;
        let skew = self.skew(2)?;
        let [upper_thickness, intermediate_thickness, lower_thickness] =
            self.thicknesses(["upper", "intermediate", "lower"], &keys::PLATE_THICKNESS)?;
        Ok(BearingGeometry {
            roller: RollerShape {
                diameter,
                wall,
                length,
                end: self.end()?,
            },
            slope,
            offset: self.offset()?,
            intermediate_thickness,
            upper_thickness,
            lower_thickness,
            plan: self.plate_size(length)?,
            skew: [skew[0], skew[1]],
        })
    }

    pub(super) fn length(&self, key: &str) -> Result<f64, CaseError> {
        Ok(self.quantity(key, Dimension::LENGTH)?.value)
    }

    /// Of each of so many rollers.
    pub(super) fn skew(&self, rollers: usize) -> Result<Vec<f64>, CaseError> {
        skew::read(&self.table, rollers)
    }

    pub(super) fn flag(&self, key: &str) -> Result<Option<Located<bool>>, CaseError> {
        self.table.maybe(key, Field::boolean)
    }

    pub(super) fn show(&self, value: f64) -> String {
        self.table.units().show(value, Dimension::LENGTH)
    }

    pub(super) fn note(&mut self, key: &str, value: impl Into<String>, why: &str) {
        let given = self.table.get(key).is_some();
        let key = format!("{}.{key}", self.name);
        self.assumptions
            .push(Assumption::new(&key, value, why, given));
    }

    pub(super) fn wall(&self) -> Result<Option<f64>, CaseError> {
        let solid = self.flag("solid")?.filter(|solid| solid.value);
        match (self.table.get("roller_wall"), solid) {
            (Some(wall), Some(solid)) => {
                let why = format!("contradicts `{} = true`", solid.place.key);
                let error = wall.place().error(ErrorKind::Conflict, why);
                Err(error.help("drop one of the two"))
            }
            (None, Some(_)) => Ok(None),
            (_, None) => {
                let help = "give the wall of a hollow roller, or solid = true";
                let field = self
                    .table
                    .need("roller_wall")
                    .map_err(|error| error.help(help))?;
                Ok(Some(field.quantity(Dimension::LENGTH)?.value))
            }
        }
    }

    /// Of these plates: one for all, or those of a table that has `known` keys.
    pub(super) fn thicknesses<const N: usize>(
        &self,
        plates: [&str; N],
        known: &keys::Keys,
    ) -> Result<[f64; N], CaseError> {
        let field = self.table.need("plate_thickness")?;
        if !field.is_table() {
            return Ok([field.quantity(Dimension::LENGTH)?.value; N]);
        }
        let table = field.table()?.only(known)?;
        let mut thickness = [0.0; N];
        for (value, key) in thickness.iter_mut().zip(plates) {
            *value = table.need(key)?.quantity(Dimension::LENGTH)?.value;
        }
        Ok(thickness)
    }

    fn plate_size(&mut self, length: f64) -> Result<[f64; 2], CaseError> {
        let size = match self.table.get("plate_size") {
            None => [length; 2],
            Some(field) => plan(&field)?,
        };
        let text = format!("{} x {}", self.show(size[0]), self.show(size[1]));
        let why = "by default roller length x roller length: the study does not give the plan \
                   size; 5 in more on each side lowers the roller stress about 10 %";
        self.note("plate_size", text, why);
        Ok(size)
    }

    pub(super) fn end(&mut self) -> Result<RollerEnd, CaseError> {
        let end = match self.table.get("roller_end") {
            None => RollerEnd::Square,
            Some(field) => roller_end(&field)?,
        };
        let text = match end {
            RollerEnd::Square => "square".to_string(),
            RollerEnd::Radius(radius) => format!("rounded, radius {}", self.show(radius)),
            RollerEnd::Crown(drop) => format!("crowned, drop {}", self.show(drop)),
            RollerEnd::CrownedRadius { radius, crown } => format!(
                "crowned, drop {}, and rounded, radius {}",
                self.show(crown),
                self.show(radius)
            ),
        };
        let why = "a square end is a singular point: the elastic peak stress there grows without \
                   bound as the mesh is refined";
        self.note("roller_end", text, why);
        Ok(end)
    }

    /// s, whichever of the two displacements is given.
    fn offset(&mut self) -> Result<f64, CaseError> {
        let given = self.length("offset")?;
        let choices = [("roller", 1.0), ("bearing", 0.5)];
        let is = (self.table).maybe("offset_is", |field| field.choice(&choices))?;
        let share = is.map_or(1.0, |is| is.value);
        let offset = given * share;
        if offset != 0.0 {
            let word = if share == 1.0 { "roller" } else { "bearing" };
            let text = format!("{word}: the rollers are {} off", self.show(offset));
            let why = "both rollers are displaced by s from the centre of the intermediate plate \
                       and the outer plates by 2 s, one pair along x, the other along y";
            self.note("offset_is", text, why);
        }
        Ok(offset)
    }

    /// Is no use made of symmetry, as is asked for or as something `breaks` it?
    pub fn full(
        &mut self,
        geometry: &BearingGeometry,
        breaks: Option<&str>,
    ) -> Result<bool, CaseError> {
        let full = self.flag("full")?.is_some_and(|asked| asked.value);
        let broken = breaks.map(|breaks| format!("{breaks} breaks the symmetry"));
        let (text, why) = match (full, geometry.is_centred()) {
            (true, _) => ("the whole bearing", "no use is made of symmetry"),
            (false, _) if broken.is_some() => {
                ("the whole bearing", broken.as_deref().unwrap_or_default())
            }
            (false, true) => (
                "a quarter",
                "a centred bearing is symmetric about x = 0 and y = 0",
            ),
            (false, false) => (
                "the whole bearing",
                "displaced rollers have no planes of symmetry",
            ),
        };
        self.note("full", text, why);
        Ok(full || broken.is_some())
    }

    /// Shares of the load at which it pauses on its way up, ascending, each less than one.
    pub fn stages(&self, load: f64) -> Result<Vec<f64>, CaseError> {
        let Some(field) = self.table.get("stages") else {
            return Ok(Vec::new());
        };
        let mut stages: Vec<f64> = Vec::new();
        for field in field.list()? {
            let stage = field.quantity(Dimension::FORCE)?.positive()?;
            let before = stages.last().copied().unwrap_or(0.0);
            let share = stage
                .require(
                    |stage| *stage < load,
                    format!("must be less than `{}.load`", self.name),
                )?
                .require(
                    |stage| *stage / load > before,
                    "must be more than the stage before",
                )?;
            stages.push(share.value / load);
        }
        Ok(stages)
    }

    /// How often a point of the surfaces is rolled over.
    pub fn rollings(&self) -> Result<Option<f64>, CaseError> {
        let given = (self.table).maybe("rollings", |field| field.ratio()?.positive())?;
        Ok(given.map(|rollings| rollings.value))
    }

    /// The share of the load that is left in the end, where there is unloading.
    pub fn unload(&mut self) -> Result<Option<f64>, CaseError> {
        let asked = self.flag("unload")?;
        if let (None, Some(field)) = (&asked, self.table.get("unload_to")) {
            let why = "says where unloading ends, and nothing is unloaded";
            let error = field.place().error(ErrorKind::Conflict, why);
            return Err(error.help("say `unload = true`, or drop it"));
        }
        let asked = asked.is_some_and(|asked| asked.value);
        let share = match self.table.get("unload_to") {
            None => UNLOAD_TO,
            Some(field) => {
                // Beyond that the end would be a lesser load, of which the figures are.
                let within = |share: &f64| *share > 0.0 && *share <= UNLOADED_SHARE;
                field
                    .ratio()?
                    .require(within, "must lie between 0 and 0.05")?
                    .value
            }
        };
        if asked {
            let why = "a little load keeps the rollers in place while dents are read";
            self.note("unload_to", format!("{share} of the load"), why);
        }
        Ok(asked.then_some(share))
    }
}

fn roller_end(field: &Field) -> Result<RollerEnd, CaseError> {
    if !field.is_table() {
        let word = field.choice(&[("square", RollerEnd::Square)]);
        let help = "\"square\", { radius = … }, { crown = … } or both keys";
        return word.map(|end| end.value).map_err(|error| error.help(help));
    }
    let table = field.table()?.only(&keys::ROLLER_END)?;
    let length = |key| table.maybe(key, |field| Ok(field.quantity(Dimension::LENGTH)?.value));
    match (length("radius")?, length("crown")?) {
        (Some(radius), None) => Ok(RollerEnd::Radius(radius)),
        (None, Some(crown)) => Ok(RollerEnd::Crown(crown)),
        (Some(radius), Some(crown)) => Ok(RollerEnd::CrownedRadius { radius, crown }),
        (None, None) => Err(field
            .place()
            .error(ErrorKind::Conflict, "must have radius, crown, or both")),
    }
}

/// A length for both sides, or along x and along y.
pub(super) fn plan(field: &Field) -> Result<[f64; 2], CaseError> {
    let side = |field: &Field| field.quantity(Dimension::LENGTH).map(|side| side.value);
    if !field.is_list() {
        return Ok([side(field)?; 2]);
    }
    match field.list()?.as_slice() {
        [x, y] => Ok([side(x)?, side(y)?]),
        _ => {
            let why = "must be one length, or two: along x and along y";
            Err(field.place().error(ErrorKind::Value, why))
        }
    }
}
