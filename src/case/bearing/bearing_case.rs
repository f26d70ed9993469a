//! `[bearing]`: the rolling bearing of five bodies, its load, friction and steels.

use super::count;
use super::error::GeometryError;
use super::geometry::BearingGeometry;
use super::reader::BearingReader;
use super::request::MeshRequest;
use super::strips::Strips;
use crate::analytic::{DomainError, Elastic, contact_compliance};
use crate::case::assumption::Assumption;
use crate::case::error::{CaseError, ErrorKind};
use crate::case::interfaces::BODIES;
use crate::case::mesh_choice;
use crate::case::parse::Table;
use crate::case::place::Located;
use crate::case::steel::Steels;
use crate::ground::units::Dimension;

/// A bearing, in the units of its case.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingCase {
    /// Dimensions of the bearing.
    pub geometry: BearingGeometry,
    /// What mesh is asked for.
    pub mesh: MeshRequest,
    /// Vertical, on the whole bearing.
    pub load: f64,
    /// Coulomb's coefficient, on all four interfaces.
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
        let mut reader = BearingReader::new(root, assumptions)?;
        let load = reader.quantity("load", Dimension::FORCE)?.positive()?.value;
        let friction = reader
            .quantity("friction", Dimension::RATIO)?
            .not_negative()?;
        let geometry = reader.geometry()?;
        let misfit = |table: &str, error: GeometryError| {
            let place = root.deepest(&format!("{table}.{}", error.key));
            place.error(ErrorKind::Value, error.range).help(error.help)
        };
        geometry.check().map_err(|error| misfit("bearing", error))?;
        check_grip(&friction, &geometry)?;
        let full = reader.full(&geometry)?;
        let stages = reader.stages(load)?;
        let unload_to = reader.unload()?;
        let rollings = reader.rollings()?;
        let mut mesh = mesh_choice::request(root, full, assumptions)?;
        let mut steels = Steels::read(root, assumptions)?;
        steels.check_names(&BODIES)?;
        steels.set_sizes(&geometry.sizes_as_delivered(), assumptions);
        for body in BODIES {
            steels.of(body)?;
        }
        mesh.strips = strips(&geometry, load, &steels)?;
        mesh.check(&geometry)
            .map_err(|error| misfit("mesh", error))?;
        Ok(Self {
            geometry,
            mesh,
            load,
            friction: friction.value,
            stages,
            unload_to,
            rollings,
            steels,
        })
    }

    /// Is the whole bearing modelled, or a quarter?
    pub fn is_whole(&self) -> bool {
        self.mesh.full || !self.geometry.is_centred()
    }

    /// About how many elements its mesh has, see [`elements`](super::elements).
    pub fn elements(&self) -> f64 {
        let sizes = self.mesh.sizes(&self.geometry);
        count::elements(&self.geometry, &sizes, self.is_whole())
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

/// The widths of the lines of contact as statics predicts them; `None` where it cannot.
fn strips(
    geometry: &BearingGeometry,
    load: f64,
    steels: &Steels,
) -> Result<Option<Strips>, CaseError> {
    let elastic = |body: &str| -> Result<Result<Elastic, DomainError>, CaseError> {
        let steel = steels.of(body)?;
        Ok(Elastic::new(steel.youngs_modulus, steel.poissons_ratio))
    };
    let [upper, upper_roller, middle, lower_roller, lower] = BODIES.map(elastic);
    let [upper, upper_roller, middle, lower_roller, lower] =
        [upper?, upper_roller?, middle?, lower_roller?, lower?];
    let predicted = || {
        let (upper_roller, lower_roller, middle) = (upper_roller?, lower_roller?, middle?);
        let flat = [
            contact_compliance(upper?, upper_roller)?,
            contact_compliance(lower_roller, lower?)?,
        ];
        let valley = [
            contact_compliance(upper_roller, middle)?,
            contact_compliance(middle, lower_roller)?,
        ];
        Strips::predicted(geometry, load, flat, valley)
    };
    Ok(predicted().ok())
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
