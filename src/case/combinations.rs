//! Combinations of actions: `[[action]]` names what acts, `[[combination]]` with which factors. Each combination is a case
//! of its own.

use super::document::{Context, document};
use super::error::{CaseError, ErrorKind};
use super::named_files::NamedFiles;
use super::parse::Table;
use super::source::Source;
use super::{Case, TEMPLATE_TABLES, keys};
use crate::ground::units::{Dimension, UnitSystem};
use std::path::Path;
use toml::Value;

/// One combination, as a case.
#[derive(Debug, Clone, PartialEq)]
pub struct Combination {
    /// Its name.
    pub name: String,
    /// Names of the actions and their factors.
    pub factors: Vec<(String, f64)>,
    /// What is to be solved.
    pub case: Case,
}

impl Combination {
    /// The actions with their factors, in words.
    pub fn acts(&self) -> String {
        let all = self.factors.iter();
        let all: Vec<String> = all
            .map(|(name, factor)| format!("{factor} {name}"))
            .collect();
        all.join(" + ")
    }
}

/// What acts, at its characteristic value.
struct Action {
    name: String,
    /// On a bearing.
    load: Option<f64>,
    /// Names of supports, planes, pressures and tractions of a scene.
    loads: Vec<String>,
}

/// The combinations of the case file at `path`; `None` where it has none and is one case.
///
/// # Errors
/// As [`read`](super::read), and for what the combinations say wrong.
pub fn combinations(path: &Path) -> Result<Option<Vec<Combination>>, CaseError> {
    combinations_of(&path.display().to_string(), &super::text_of_file(path)?)
}

/// The same of a text; `name` is its path, for messages and to find its mesh.
///
/// # Errors
/// As [`combinations`].
pub fn combinations_of(name: &str, text: &str) -> Result<Option<Vec<Combination>>, CaseError> {
    let source = Source::new(name, text);
    let document = document(&source)?;
    let context = Context {
        source: &source,
        units: UnitSystem::MNPa,
    };
    let root = Table::root(context, &document);
    if root.get("action").is_none() && root.get("combination").is_none() {
        return Ok(None);
    }
    let root = root.only_either(&[&keys::ROOT, &keys::SCENE])?;
    let units = super::read_units(&root)?;
    let root = root.with_units(units);
    let is_bearing = TEMPLATE_TABLES
        .iter()
        .any(|table| root.get(table).is_some());
    let actions = actions(&root, is_bearing)?;
    let tables = root.tables("combination")?;
    if tables.is_empty() {
        let message = "the file has actions and no combination of them";
        let help = "add [[combination]] with `name` and `factors = { ACTION = FACTOR }`";
        return Err(CaseError::new(ErrorKind::MissingKey, message).help(help));
    }
    refuse_the_load_itself(&root, is_bearing)?;
    let mut all: Vec<Combination> = Vec::new();
    for table in tables {
        let table = table.only(&keys::COMBINATION)?;
        let named = table.need("name")?.string()?;
        if all.iter().any(|other| other.name == named.value) {
            return Err(named
                .place
                .error(ErrorKind::Value, "another combination has that name"));
        }
        let factors = factors(&table, &actions)?;
        let text = text_of(text, units, &named.value, (&actions, &factors), is_bearing);
        let text = NamedFiles::new(Path::new(name)).absolute(text);
        all.push(Combination {
            factors: factors
                .iter()
                .map(|(action, factor)| (action.name.clone(), *factor))
                .collect(),
            // The lines that are marked are those of the combination, not of the file.
            case: super::parse(name, &text).map_err(|error| {
                error.of_file(&format!("{name} with combination {}", named.value))
            })?,
            name: named.value,
        });
    }
    Ok(Some(all))
}

fn actions(root: &Table, is_bearing: bool) -> Result<Vec<Action>, CaseError> {
    let mut actions: Vec<Action> = Vec::new();
    for table in root.tables("action")? {
        let table = table.only(&keys::ACTION)?;
        let name = table.need("name")?.string()?;
        if actions.iter().any(|other| other.name == name.value) {
            return Err(name
                .place
                .error(ErrorKind::Value, "another action has that name"));
        }
        let (wanted, other) = match is_bearing {
            true => ("load", "loads"),
            false => ("loads", "load"),
        };
        if table.get(other).is_some() {
            let why = "`load` is of a bearing, `loads` are those of a general scene, by name";
            return Err(table.place_of_key(other).error(ErrorKind::Conflict, why));
        }
        let field = table.need(wanted)?;
        let (load, loads) = match is_bearing {
            true => (Some(field.quantity(Dimension::FORCE)?.value), Vec::new()),
            false => {
                let names = field.list()?;
                let names: Result<Vec<String>, CaseError> =
                    names.iter().map(|name| Ok(name.string()?.value)).collect();
                (None, names?)
            }
        };
        actions.push(Action {
            name: name.value,
            load,
            loads,
        });
    }
    Ok(actions)
}

/// The factors of a combination, each with its action.
fn factors<'a>(table: &Table, actions: &'a [Action]) -> Result<Vec<(&'a Action, f64)>, CaseError> {
    let factors = table.need("factors")?.table()?;
    let mut all = Vec::new();
    for name in factors.keys() {
        let Some(action) = actions.iter().find(|action| action.name == name) else {
            let place = factors.place_of_key(name);
            let known = actions.iter().map(|action| action.name.as_str());
            return Err(place.unknown("is not an action", name, known));
        };
        all.push((action, factors.need(name)?.ratio()?.value));
    }
    match all.is_empty() {
        true => Err(table.error(ErrorKind::Value, "the combination names no action")),
        false => Ok(all),
    }
}

/// What the combinations set the file may not say as well.
fn refuse_the_load_itself(root: &Table, is_bearing: bool) -> Result<(), CaseError> {
    let bearing = TEMPLATE_TABLES.iter().find_map(|table| root.get(table));
    let (place, what) = match (is_bearing, bearing, root.get("step")) {
        (true, Some(bearing), _) => {
            let bearing = bearing.table()?;
            match bearing.get("load") {
                Some(_) => (
                    bearing.place_of_key("load"),
                    "the load of a combination is that of its actions",
                ),
                None => return Ok(()),
            }
        }
        (false, _, Some(_)) => (
            root.place_of_key("step"),
            "a combination is one step, with the factors of its actions",
        ),
        _ => return Ok(()),
    };
    Err(place.error(ErrorKind::Conflict, what).help("leave it out"))
}

/// The case file of one combination.
fn text_of(
    text: &str,
    units: UnitSystem,
    name: &str,
    (actions, factors): (&[Action], &[(&Action, f64)]),
    is_bearing: bool,
) -> String {
    // It was read before, so it is TOML.
    let mut case: toml::Table = text.parse().unwrap_or_default();
    case.remove("action");
    case.remove("combination");
    if let Some(title) = case.get("title").and_then(Value::as_str) {
        let title = format!("{title}: {name}");
        case.insert("title".to_owned(), title.into());
    }
    if is_bearing {
        let load: f64 = factors
            .iter()
            .map(|(action, factor)| factor * action.load.unwrap_or_default())
            .sum();
        let load = units.write(load, Dimension::FORCE);
        for table in TEMPLATE_TABLES {
            if let Some(bearing) = case.get_mut(table).and_then(Value::as_table_mut) {
                bearing.insert("load".to_owned(), load.clone().into());
            }
        }
        return case.to_string();
    }
    // A load that several actions name acts with the sum of their factors, and that of an action that the combination does
    // not name does not act.
    let mut by_load = toml::Table::new();
    for load in actions.iter().flat_map(|action| &action.loads) {
        by_load.insert(load.clone(), 0.0.into());
    }
    for (action, factor) in factors {
        for load in &action.loads {
            let before = by_load
                .get(load)
                .and_then(Value::as_float)
                .unwrap_or_default();
            by_load.insert(load.clone(), (before + factor).into());
        }
    }
    let mut step = toml::Table::new();
    step.insert("name".to_owned(), name.into());
    step.insert("factors".to_owned(), by_load.into());
    case.insert("step".to_owned(), Value::Array(vec![step.into()]));
    case.to_string()
}
