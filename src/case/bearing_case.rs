//! `[bearing]`: the rolling bearing of five bodies, described by its dimensions.
//!
//! z points up and the origin is the centre of the intermediate plate. The upper roller lies
//! along y at x = s, the upper plate is centred on x = 2 s; the lower roller lies along x at
//! y = s, the lower plate is centred on y = 2 s, with s the offset.

use super::assumption::Assumption;
use super::error::{CaseError, ErrorKind};
use super::mesh_choice;
use super::parse::{Field, Table};
use super::source::Located;
use super::steel::Steels;
use super::template::{BODIES, BearingGeometry, MeshRequest, RollerEnd};
use crate::units::Dimension;

const KEYS: &[&str] = &[
    "load",
    "friction",
    "roller_diameter",
    "roller_wall",
    "solid",
    "roller_length",
    "roller_end",
    "offset",
    "offset_is",
    "slope",
    "plate_thickness",
    "plate_size",
    "full",
    "unload",
    "unload_to",
];

/// A bearing, in the units of its case.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingCase {
    pub geometry: BearingGeometry,
    pub mesh: MeshRequest,
    /// Vertical, on the whole bearing.
    pub load: f64,
    /// Coulomb's coefficient, on all four interfaces.
    pub friction: f64,
    /// The share of the load that is left after unloading; `None` where it stays on.
    pub unload_to: Option<f64>,
    pub steels: Steels,
}

impl BearingCase {
    pub(super) fn read(root: &Table, assumptions: &mut Vec<Assumption>) -> Result<Self, CaseError> {
        let table = root.need("bearing")?.table()?.only(KEYS)?;
        let mut reader = Reader {
            table: &table,
            assumptions,
        };
        let load = reader.positive("load", Dimension::FORCE)?;
        let friction = reader
            .quantity("friction", Dimension::RATIO)?
            .not_negative()?;
        let diameter = reader.positive("roller_diameter", Dimension::LENGTH)?;
        let wall = reader.wall(diameter.value)?;
        let length = reader.positive("roller_length", Dimension::LENGTH)?.value;
        let slope = reader.slope()?;
        let [upper_thickness, intermediate_thickness, lower_thickness] = reader.thicknesses()?;
        let plan = reader.plate_size(length)?;
        let end = reader.end(diameter.value, wall, length)?;
        let offset = reader.offset()?;
        let reach = offset.value + diameter.value / 2.0 * slope.sin();
        check_offset(&offset, reach, length, plan, &table)?;
        check_grip(&friction, offset.value, slope)?;
        let full = reader.full(offset.value)?;
        let unload_to = reader.unload()?;
        let steels = Steels::read(root, assumptions)?;
        steels.check_names(&BODIES)?;
        for body in BODIES {
            steels.of(body)?;
        }
        let geometry = BearingGeometry {
            diameter: diameter.value,
            wall,
            length,
            slope,
            offset: offset.value,
            intermediate_thickness,
            upper_thickness,
            lower_thickness,
            plan,
            end,
        };
        let mesh = mesh_choice::request(root, full, assumptions)?;
        let (load, friction) = (load.value, friction.value);
        Ok(Self {
            geometry,
            mesh,
            load,
            friction,
            unload_to,
            steels,
        })
    }

    /// Is the whole bearing modelled, or a quarter?
    pub fn is_whole(&self) -> bool {
        self.mesh.full || !self.geometry.is_centred()
    }

    /// Axes of the symmetry planes.
    pub fn mirrors(&self) -> Vec<usize> {
        if self.is_whole() {
            Vec::new()
        } else {
            vec![0, 1]
        }
    }
}

/// Reads the keys of `[bearing]`, noting what is taken for granted.
struct Reader<'a, 'b> {
    table: &'b Table<'a>,
    assumptions: &'b mut Vec<Assumption>,
}

impl Reader<'_, '_> {
    fn quantity(&self, key: &str, dimension: Dimension) -> Result<Located<f64>, CaseError> {
        self.table.need(key)?.quantity(dimension)
    }

    fn positive(&self, key: &str, dimension: Dimension) -> Result<Located<f64>, CaseError> {
        self.quantity(key, dimension)?.positive()
    }

    fn flag(&self, key: &str) -> Result<Option<Located<bool>>, CaseError> {
        self.table.get(key).map(|field| field.boolean()).transpose()
    }

    fn show(&self, value: f64) -> String {
        self.table.units().show(value, Dimension::LENGTH)
    }

    fn note(&mut self, key: &str, value: impl Into<String>, why: &str) {
        let given = self.table.get(key).is_some();
        let key = format!("bearing.{key}");
        self.assumptions
            .push(Assumption::new(&key, value, why, given));
    }

    fn wall(&self, diameter: f64) -> Result<Option<f64>, CaseError> {
        let solid = self.flag("solid")?.filter(|solid| solid.value);
        match (self.table.get("roller_wall"), solid) {
            (Some(wall), Some(solid)) => {
                let why = format!("contradicts `{} = true`", solid.place.key);
                Err(wall
                    .place()
                    .error(ErrorKind::Conflict, why)
                    .help("drop one of the two"))
            }
            (None, Some(_)) => Ok(None),
            (None, None) => {
                let missing = self.quantity("roller_wall", Dimension::LENGTH);
                let help = "give the wall of a hollow roller, or solid = true";
                missing
                    .map(|wall| Some(wall.value))
                    .map_err(|error| error.help(help))
            }
            (Some(field), None) => {
                let wall = field.quantity(Dimension::LENGTH)?.positive()?;
                let why = format!(
                    "must be less than half of the roller diameter, {}; a roller without a bore \
                     is solid = true",
                    self.show(diameter / 2.0)
                );
                Ok(Some(
                    wall.require(|wall| *wall < diameter / 2.0, why)?.value,
                ))
            }
        }
    }

    fn slope(&self) -> Result<f64, CaseError> {
        let slope = self.quantity("slope", Dimension::ANGLE)?;
        let within = |slope: &f64| *slope > 0.0 && *slope < std::f64::consts::FRAC_PI_4;
        Ok(slope
            .require(within, "must be more than 0 and less than 45 deg")?
            .value)
    }

    fn thicknesses(&self) -> Result<[f64; 3], CaseError> {
        let field = self.table.need("plate_thickness")?;
        let positive = |field: &Field| field.quantity(Dimension::LENGTH)?.positive();
        if !field.is_table() {
            return Ok([positive(&field)?.value; 3]);
        }
        let keys = ["upper", "intermediate", "lower"];
        let table = field.table()?.only(&keys)?;
        let mut thickness = [0.0; 3];
        for (value, key) in thickness.iter_mut().zip(keys) {
            *value = positive(&table.need(key)?)?.value;
        }
        Ok(thickness)
    }

    fn plate_size(&mut self, length: f64) -> Result<[f64; 2], CaseError> {
        let size = match self.table.get("plate_size") {
            None => [length; 2],
            Some(field) if field.is_list() => {
                let sides = field.list()?;
                let [x, y] = sides.as_slice() else {
                    let why = "must be one length, or two: along x and along y";
                    return Err(field.place().error(ErrorKind::Value, why));
                };
                let side = |f: &Field| Ok(f.quantity(Dimension::LENGTH)?.positive()?.value);
                [side(x)?, side(y)?]
            }
            Some(field) => [field.quantity(Dimension::LENGTH)?.positive()?.value; 2],
        };
        let text = format!("{} x {}", self.show(size[0]), self.show(size[1]));
        let why = "by default roller length x roller length: the study does not give the plan \
                   size; 5 in more on each side lowers the roller stress about 10 %";
        self.note("plate_size", text, why);
        Ok(size)
    }

    fn end(
        &mut self,
        diameter: f64,
        wall: Option<f64>,
        length: f64,
    ) -> Result<RollerEnd, CaseError> {
        let end = match self.table.get("roller_end") {
            None => RollerEnd::Square,
            Some(field) if field.is_table() => {
                let table = field.table()?.only(&["radius", "crown"])?;
                let radius = table.get("radius").map(|f| f.quantity(Dimension::LENGTH));
                let crown = table.get("crown").map(|f| f.quantity(Dimension::LENGTH));
                match (radius.transpose()?, crown.transpose()?) {
                    (Some(radius), None) => {
                        let most = wall.unwrap_or(diameter / 2.0).min(length / 2.0);
                        let why = format!("must be less than {}", self.show(most));
                        let radius = radius.positive()?.require(|r| *r < most, why)?;
                        RollerEnd::Radius(radius.value)
                    }
                    (None, Some(crown)) => {
                        let most = wall.unwrap_or(diameter / 2.0);
                        let why = format!("must be less than {}", self.show(most));
                        RollerEnd::Crown(crown.positive()?.require(|c| *c < most, why)?.value)
                    }
                    _ => {
                        let why = "must have one of radius and crown";
                        return Err(field.place().error(ErrorKind::Conflict, why));
                    }
                }
            }
            Some(field) => {
                field
                    .choice(&[("square", RollerEnd::Square)])
                    .map_err(|error| error.help("\"square\", { radius = … } or { crown = … }"))?
                    .value
            }
        };
        let text = match end {
            RollerEnd::Square => "square".to_string(),
            RollerEnd::Radius(radius) => format!("rounded, radius {}", self.show(radius)),
            RollerEnd::Crown(drop) => format!("crowned, drop {}", self.show(drop)),
        };
        let why = "a square end is a singular point: the elastic peak stress there grows without \
                   bound as the mesh is refined";
        self.note("roller_end", text, why);
        Ok(end)
    }

    fn offset(&mut self) -> Result<Located<f64>, CaseError> {
        let field = self.table.need("offset")?;
        let why = "must not be negative; the bearing is symmetric";
        let given = field
            .quantity(Dimension::LENGTH)?
            .require(|s| *s >= 0.0, why)?;
        let choices = [("roller", 1.0), ("bearing", 0.5)];
        let is = self
            .table
            .get("offset_is")
            .map(|field| field.choice(&choices))
            .transpose()?;
        let share = is.map_or(1.0, |is| is.value);
        let offset = given.map(|value| value * share);
        if offset.value > 0.0 {
            let word = if share == 1.0 { "roller" } else { "bearing" };
            let text = format!("{word}: the rollers are {} off", self.show(offset.value));
            let why = "both rollers are displaced by s from the centre of the intermediate plate \
                       and the outer plates by 2 s, one pair along x, the other along y";
            self.note("offset_is", text, why);
        }
        Ok(offset)
    }

    fn full(&mut self, offset: f64) -> Result<bool, CaseError> {
        let asked = self.flag("full")?;
        if let Some(asked) = asked.as_ref().filter(|asked| !asked.value && offset > 0.0) {
            let why = "a bearing with displaced rollers has no planes of symmetry";
            return Err(asked.place.error(ErrorKind::Conflict, why));
        }
        let full = offset > 0.0 || asked.is_some_and(|asked| asked.value);
        let (text, why) = match full {
            true => ("the whole bearing", "no use is made of symmetry"),
            false => (
                "a quarter",
                "a centred bearing is symmetric about x = 0 and y = 0",
            ),
        };
        self.note("full", text, why);
        Ok(full)
    }

    fn unload(&mut self) -> Result<Option<f64>, CaseError> {
        let asked = self.flag("unload")?.is_some_and(|asked| asked.value);
        let within = |share: &f64| *share > 0.0 && *share < 1.0;
        let share = match self.table.get("unload_to") {
            Some(field) => {
                field
                    .ratio()?
                    .require(within, "must lie between 0 and 1")?
                    .value
            }
            None => 1e-3,
        };
        if asked {
            let why = "a little load keeps the rollers in place while dents are read";
            self.note("unload_to", format!("{share} of the load"), why);
        }
        Ok(asked.then_some(share))
    }
}

/// The rollers still cross, and still lie on the plates.
fn check_offset(
    offset: &Located<f64>,
    reach: f64,
    length: f64,
    plate: [f64; 2],
    table: &Table,
) -> Result<(), CaseError> {
    let show = |value| table.units().show(value, Dimension::LENGTH);
    let half_plate = plate[0].min(plate[1]) / 2.0;
    let why = if offset.value >= length / 2.0 {
        format!(
            "the rollers no longer cross: half of a roller is {}",
            show(length / 2.0)
        )
    } else if reach >= half_plate {
        format!(
            "a roller would touch its slope {} off the centre, beyond the edge of the plate at {}",
            show(reach),
            show(half_plate)
        )
    } else {
        return Ok(());
    };
    Err(offset.place.error(ErrorKind::Value, why))
}

/// A displaced roller has one line of contact below and one above, whose normals differ by the
/// slope θ; it is in balance only where the coefficient is at least tan(θ/2).
fn check_grip(friction: &Located<f64>, offset: f64, slope: f64) -> Result<(), CaseError> {
    let least = (slope / 2.0).tan();
    if offset == 0.0 || friction.value >= least {
        return Ok(());
    }
    let why = format!(
        "cannot hold a displaced roller on a slope of {:.4} deg, which takes tan(slope/2) = {:.4}",
        slope.to_degrees(),
        least
    );
    Err(friction.place.error(ErrorKind::Value, why))
}
