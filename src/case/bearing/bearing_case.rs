//! `[bearing]` and `[line_bearing]`: a bearing by its dimensions, its load, friction and steels.

use super::dimensions::Dimensions;
use super::error::GeometryError;
use super::geometry::BearingGeometry;
use super::layout::Layout;
use super::line::LineGeometry;
use super::reader::BearingReader;
use super::request::MeshRequest;
use super::seat::Seat;
use super::strips::Strips;
use crate::analytic::{DomainError, Elastic, contact_compliance};
use crate::case::assumption::Assumption;
use crate::case::error::{CaseError, ErrorKind};
use crate::case::keys;
use crate::case::mesh_choice;
use crate::case::parse::Table;
use crate::case::place::Located;
use crate::case::steel::Steels;
use crate::case::temperature;
use crate::case::template_loads::TemplateLoads;
use crate::ground::units::Dimension;
use crate::model::material::Steel;
use crate::model::scene::Temperature;

/// The name of the rigid plane that carries the load.
pub(super) const LOADED_PLANE: &str = "top";

/// A bearing, in the units of its case.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingCase {
    /// Dimensions of the bearing.
    pub geometry: Dimensions,
    /// What mesh is asked for.
    pub mesh: MeshRequest,
    /// Vertical, on the whole bearing.
    pub load: f64,
    /// What acts beside it.
    pub loads: TemplateLoads,
    /// Differences of temperature of its bodies.
    pub temperatures: Vec<Located<Temperature>>,
    /// Coulomb's coefficient, on all interfaces.
    pub friction: f64,
    /// Shares of the load at which its descent is read on the way up, ascending, below one.
    pub stages: Vec<f64>,
    /// The share of the load that is left after unloading; `None` where it stays on.
    pub unload_to: Option<f64>,
    /// How often the bearing rolls over a point of its surfaces, for design rules of fatigue.
    pub rollings: Option<f64>,
    /// Steels by body.
    pub steels: Steels,
}

impl BearingCase {
    pub(in crate::case) fn read(
        root: &Table,
        assumptions: &mut Vec<Assumption>,
    ) -> Result<Self, CaseError> {
        let parallel = root.get("line_bearing").is_some();
        let table = match parallel {
            true => ("line_bearing", &keys::LINE_BEARING),
            false => ("bearing", &keys::BEARING),
        };
        let mut reader = BearingReader::new(root, table, assumptions)?;
        let load = reader.quantity("load", Dimension::FORCE)?.positive()?.value;
        let friction = reader
            .quantity("friction", Dimension::RATIO)?
            .not_negative()?;
        let misfit = |table: &str, error: GeometryError| {
            let place = root.deepest(&format!("{table}.{}", error.key));
            place.error(ErrorKind::Value, error.range).help(error.help)
        };
        let loads = reader.loads()?;
        let breaks = loads.breaks_symmetry();
        let mut said = Vec::new();
        let mut steels = Steels::read(root, &mut said)?;
        let warm = |steels: &Steels, said: &mut Vec<Assumption>| {
            let mut names = vec![LOADED_PLANE.to_string()];
            temperature::read(root, steels, (&mut names, said))
        };
        let (geometry, full, temperatures) = match parallel {
            true => {
                let mut geometry = reader.line_geometry()?;
                (geometry.check()).map_err(|error| misfit("line_bearing", error))?;
                size_steels(&mut steels, &geometry, &mut said)?;
                let temperatures = warm(&steels, &mut said)?;
                geometry.alike =
                    are_alike(&geometry, &steels)? && alike_warm(&geometry, &temperatures);
                let full = reader.line_full(&geometry, breaks.or(askew(&geometry)))?;
                (Dimensions::Line(geometry), full, temperatures)
            }
            false => {
                let geometry = reader.geometry()?;
                (geometry.check()).map_err(|error| misfit("bearing", error))?;
                check_grip(&friction, &geometry)?;
                size_steels(&mut steels, &geometry, &mut said)?;
                let temperatures = warm(&steels, &mut said)?;
                let full = reader.full(&geometry, breaks.or(askew(&geometry)))?;
                (Dimensions::Crossed(geometry), full, temperatures)
            }
        };
        let stages = reader.stages(load)?;
        let unload_to = reader.unload()?;
        let rollings = reader.rollings()?;
        let mut mesh = mesh_choice::request(root, (full, &*geometry), reader.assumptions())?;
        reader.assumptions().append(&mut said);
        for (body, _) in geometry.bodies() {
            steels.of(&body)?;
        }
        temperature::check_bodies(&temperatures, &geometry.bodies())?;
        let help = format!("say `full = true` in [{}]", geometry.table());
        temperature::check_symmetry(root, &geometry.mirrors(full), &help)?;
        mesh.strips = strips(&*geometry, full, load, &steels)?;
        mesh.check(&*geometry)
            .map_err(|error| misfit("mesh", error))?;
        Ok(Self {
            geometry,
            mesh,
            load,
            loads,
            temperatures,
            friction: friction.value,
            stages,
            unload_to,
            rollings,
            steels,
        })
    }

    /// What its template says of it.
    pub fn layout(&self) -> &dyn Layout {
        &*self.geometry
    }

    /// Is the whole bearing modelled, or a part?
    pub fn is_whole(&self) -> bool {
        self.mirrors().is_empty()
    }

    /// Does nothing but the dimensions decide how rollers and lines that are images of each other share the load?
    pub fn shares_evenly(&self) -> bool {
        let straight = self.loads.breaks_symmetry().is_none() && !self.layout().is_askew();
        straight && self.temperatures.is_empty()
    }

    /// About how many elements its mesh has.
    pub fn elements(&self) -> f64 {
        let sizes = self.mesh.sizes(self.layout());
        self.layout().elements(&sizes, self.mesh.full)
    }

    /// Axes of the symmetry planes.
    pub fn mirrors(&self) -> Vec<usize> {
        self.layout().mirrors(self.mesh.full)
    }

    /// The interfaces that are modelled, from the top down.
    pub fn seats(&self) -> Vec<Seat> {
        self.layout().seats(self.mesh.full)
    }

    /// The interface of this name.
    pub fn seat(&self, interface: &str) -> Option<Seat> {
        let mut seats = self.seats().into_iter();
        seats.find(|seat| seat.interface == interface)
    }
}

/// What breaks the symmetry of rollers that do not lie straight.
fn askew(geometry: &dyn Layout) -> Option<&'static str> {
    geometry.is_askew().then_some("a roller askew")
}

/// The widths of the lines of contact as statics predicts them; `None` where it cannot.
fn strips(
    geometry: &dyn Layout,
    full: bool,
    load: f64,
    steels: &Steels,
) -> Result<Option<Strips>, CaseError> {
    let mut compliance: Result<Vec<f64>, DomainError> = Ok(Vec::new());
    for seat in geometry.seats(full) {
        let [roller, plate] = [steels.of(&seat.roller)?, steels.of(&seat.plate)?];
        let elastic = |steel: &Steel| Elastic::new(steel.youngs_modulus, steel.poissons_ratio);
        let of_pair = || contact_compliance(elastic(&roller)?, elastic(&plate)?);
        compliance = compliance.and_then(|mut list| {
            list.push(of_pair()?);
            Ok(list)
        });
    }
    let predicted = compliance.and_then(|list| geometry.predicted(load, full, &list));
    Ok(predicted.ok())
}

/// Tells the steels the bodies of a bearing and how thick they are.
fn size_steels(
    steels: &mut Steels,
    geometry: &dyn Layout,
    said: &mut Vec<Assumption>,
) -> Result<(), CaseError> {
    let bodies = geometry.bodies();
    let sizes: Vec<(&str, f64)> = (bodies.iter())
        .map(|(body, size)| (body.as_str(), *size))
        .collect();
    let names: Vec<&str> = sizes.iter().map(|(body, _)| *body).collect();
    steels.check_names(&names)?;
    steels.set_sizes(&sizes, said);
    Ok(())
}

/// Are rollers that are images of each other across x = 0 of the same steel?
fn are_alike(geometry: &LineGeometry, steels: &Steels) -> Result<bool, CaseError> {
    for number in 1..=geometry.rollers / 2 {
        let [a, b] = [number, geometry.rollers + 1 - number].map(|n| geometry.body(n));
        if steels.of(&a)? != steels.of(&b)? || steels.strength_of(&a)? != steels.strength_of(&b)? {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Are rollers that are images of each other across x = 0 as warm?
fn alike_warm(geometry: &LineGeometry, temperatures: &[Located<Temperature>]) -> bool {
    let of = |number: usize| {
        let body = geometry.body(number);
        let own = temperatures.iter().map(|located| &located.value);
        let own = own.filter(move |temperature| temperature.body == body);
        own.map(|temperature| {
            let Temperature {
                expansion,
                value,
                gradient,
                ..
            } = temperature;
            (*expansion, *value, *gradient)
        })
    };
    (1..=geometry.rollers / 2).all(|number| of(number).eq(of(geometry.rollers + 1 - number)))
}

/// A displaced roller has one line of contact below and one above, whose normals differ by the
/// slope θ; it is in balance only where the coefficient of friction is at least tan(θ/2).
fn check_grip(friction: &Located<f64>, geometry: &BearingGeometry) -> Result<(), CaseError> {
    let least = (geometry.slope / 2.0).tan();
    if geometry.is_centred() || friction.value >= least {
        return Ok(());
    }
    let why = format!(
        "cannot hold a displaced roller on a slope of {:.4} deg, which takes tan(slope/2) = {:.4}",
        geometry.slope.to_degrees(),
        least
    );
    Err(friction.place.error(ErrorKind::Value, why))
}
