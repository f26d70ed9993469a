//! `[[contact]]`: pairs of surfaces that may touch.

use super::error::{CaseError, ErrorKind};
use super::keys;
use super::parse::{Field, Table};
use super::place::Located;
use crate::ground::units::Dimension;
use crate::model::scene::{Partner, Side};

/// A contact pair before it meets the mesh.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// Its name.
    pub name: Located<String>,
    /// The upper surface or plane.
    pub upper: Located<Partner>,
    /// The lower surface or plane.
    pub lower: Located<Partner>,
    /// The non-mortar (slave) side. `None`: chosen by how stiff the two sides are, see `model/scene/carrier.rs`.
    pub carrier: Option<Side>,
    /// The side that carries where both are equally stiff.
    pub preferred: Side,
    /// Coulomb's coefficient.
    pub friction: f64,
    /// Was no friction given?
    pub friction_is_default: bool,
    /// Multiplies the automatic penalty.
    pub penalty_factor: f64,
    /// Are round surfaces taken as round, and not by their facets?
    pub true_geometry: bool,
}

/// Reads all `[[contact]]`.
pub(super) fn read(root: &Table) -> Result<Vec<Contact>, CaseError> {
    let mut contacts: Vec<Contact> = Vec::new();
    for table in root.tables("contact")? {
        let contact = Contact::read(&table.only(&keys::CONTACT)?)?;
        if contacts
            .iter()
            .any(|other| other.name.value == contact.name.value)
        {
            let why = format!("there are two contacts called `{}`", contact.name.value);
            return Err(contact.name.place.error(ErrorKind::Duplicate, why));
        }
        if let Some(other) = contacts.iter().find(|other| other.same_partners(&contact)) {
            let why = format!("the contact `{}` has the same two sides", other.name.value);
            return Err(contact.upper.place.error(ErrorKind::Duplicate, why));
        }
        contacts.push(contact);
    }
    Ok(contacts)
}

impl Contact {
    fn read(table: &Table) -> Result<Self, CaseError> {
        let (upper, lower) = (
            partner(&table.need("upper")?)?,
            partner(&table.need("lower")?)?,
        );
        if upper.value == lower.value {
            let why = "a surface cannot be in contact with itself";
            return Err(lower.place.error(ErrorKind::Conflict, why));
        }
        if is_plane(&upper) && is_plane(&lower) {
            let why = "both sides are planes; one must be a surface";
            return Err(lower.place.error(ErrorKind::Conflict, why));
        }
        let name = match table.get("name") {
            Some(field) => field.string()?,
            None => {
                let value = format!("{}-{}", called(&upper.value), called(&lower.value));
                Located {
                    value,
                    place: upper.place.clone(),
                }
            }
        };
        let friction = table.maybe("friction", |field| field.ratio()?.not_negative())?;
        let penalty_factor = table.maybe("penalty_factor", |field| field.ratio()?.positive())?;
        let true_geometry = table.maybe("true_geometry", Field::boolean)?;
        Ok(Self {
            carrier: carrier(table, &upper, &lower)?,
            preferred: Side::Upper,
            name,
            upper,
            lower,
            friction_is_default: friction.is_none(),
            friction: friction.map_or(0.0, |f| f.value),
            penalty_factor: penalty_factor.map_or(1.0, |f| f.value),
            true_geometry: true_geometry.is_none_or(|t| t.value),
        })
    }

    fn same_partners(&self, other: &Self) -> bool {
        let (u, l) = (&self.upper.value, &self.lower.value);
        let (ou, ol) = (&other.upper.value, &other.lower.value);
        (u == ou && l == ol) || (u == ol && l == ou)
    }
}

/// The side that was asked for; a plane has no nodes to carry anything.
fn carrier(
    table: &Table,
    upper: &Located<Partner>,
    lower: &Located<Partner>,
) -> Result<Option<Side>, CaseError> {
    let only = match (is_plane(upper), is_plane(lower)) {
        (true, _) => Some(Side::Lower),
        (_, true) => Some(Side::Upper),
        _ => None,
    };
    let Some(field) = table.get("carrier") else {
        return Ok(only);
    };
    let asked = field.choice(&[("upper", Side::Upper), ("lower", Side::Lower)])?;
    if only.is_some_and(|side| side != asked.value) {
        let why = "is a plane, which has no nodes to carry the contact pressure";
        return Err(asked.place.error(ErrorKind::Conflict, why));
    }
    Ok(Some(asked.value))
}

fn partner(field: &Field) -> Result<Located<Partner>, CaseError> {
    if !field.is_table() {
        return Ok(field.string()?.map(Partner::Surface));
    }
    let table = field.table()?.only(&keys::PARTNER)?;
    let plane = table.need("plane")?.table()?.only(&keys::PLANE)?;
    let point = plane.need("point")?.vector(Dimension::LENGTH)?.value;
    let normal = plane.need("normal")?.vector(Dimension::RATIO)?;
    let length = normal.value.iter().fold(0.0, |sum: f64, c| sum.hypot(*c));
    let normal = normal.require(|_| length > 0.0, "the normal must not be zero")?;
    Ok(field.located(Partner::Plane {
        point,
        normal: normal.value.map(|c| c / length),
    }))
}

fn is_plane(partner: &Located<Partner>) -> bool {
    matches!(partner.value, Partner::Plane { .. })
}

fn called(partner: &Partner) -> &str {
    match partner {
        Partner::Surface(name) => name,
        Partner::Plane { .. } => "plane",
    }
}
