//! What the page says of the calculation beside its answer, from the case.

use super::verified::verified;
use crate::case::bearing::{Dimensions, RollerEnd, RollerPlace};
use crate::case::keys::{self, Keys};
use crate::case::{BearingCase, Case, TemplateLoads, Top};
use crate::ground::units::UnitLabels;
use crate::model::scene::Scene;
use crate::render::report::calculation::{
    Calculation, CrossedSketch, InputRow, LineSketch, Origin, Sketch,
};
use crate::render::text::significant;
use toml::{Table, Value};

/// The study that the shipped references belong to.
const STUDY: &str = "G. C. Lee, Y.-C. Ou, Z. Liang, T. Niu and J. Song, Principles and Performance of Roller Seismic \
                     Isolation Bearings for Highway Bridges, technical report MCEER-07-0019, University at Buffalo, 2007";

/// All of it.
pub fn calculation(case: &Case, scene: &Scene) -> Calculation {
    Calculation {
        scope: scope(case, scene),
        cited: case.reference.is_some().then_some(STUDY),
        sketch: (case.bearing()).map(|bearing| sketch(&bearing.geometry)),
        inputs: inputs(case),
        actions: actions(case, scene),
        verified: verified(case, scene),
    }
}

fn scope(case: &Case, scene: &Scene) -> Vec<String> {
    let bodies = scene.mesh.bodies.len();
    let (pairs, plural) = match scene.contacts.len() {
        1 => (1, "pair"),
        pairs => (pairs, "pairs"),
    };
    let steel = match scene.may_yield() {
        true => "elastic-plastic",
        false => "elastic",
    };
    let mut said: Vec<String> = case.description.iter().cloned().collect();
    said.push(format!(
        "Static contact analysis by finite elements in three dimensions: {bodies} bodies of {steel} steel, {pairs} {plural} \
         of surfaces that may touch, small displacements, loaded in {}.",
        match scene.steps.len() {
            0 | 1 => "one step".to_owned(),
            steps => format!("{steps} steps, one after the other"),
        }
    ));
    said.push(format!(
        "It answers for stresses, plastic strain, pressures and forces of contact, and displacements under the actions \
         below, in {}, {} and {}. It does not answer for: impact and vibration, fatigue but by the design rules named, wear, \
         residual stress, roughness, buckling, and what the bodies are fastened to.",
        case.units.length(),
        case.units.force(),
        case.units.stress()
    ));
    said
}

fn sketch(geometry: &Dimensions) -> Sketch {
    match geometry {
        Dimensions::Crossed(g) => Sketch::Crossed(CrossedSketch {
            diameter: g.roller.diameter,
            wall: g.roller.wall,
            length: g.roller.length,
            slope: g.slope,
            offset: g.offset,
            thickness: [
                g.upper_thickness,
                g.intermediate_thickness,
                g.lower_thickness,
            ],
            plan: g.plan,
            ends: ends(g.roller.end),
        }),
        Dimensions::Line(g) => Sketch::Line(LineSketch {
            diameter: g.roller.diameter,
            wall: g.roller.wall,
            length: g.roller.length,
            places: (1..=g.rollers).map(|number| g.place(number)).collect(),
            thickness: [g.upper.thickness, g.lower.thickness],
            plan: [g.upper.plan, g.lower.plan],
            ends: ends(g.roller.end),
            curved: g.curve.map(|curve| {
                format!(
                    "The face of the {} plate is a cylinder along the roller, {}, of radius {}; drawn flat.",
                    if curve.upper { "upper" } else { "lower" },
                    if curve.convex { "convex" } else { "concave" },
                    significant(curve.radius, 4)
                )
            }),
        }),
    }
}

fn ends(end: RollerEnd) -> String {
    let said = |value| significant(value, 4);
    match end {
        RollerEnd::Square => "square".to_owned(),
        RollerEnd::Radius(radius) => format!("fillets of radius {}", said(radius)),
        RollerEnd::Crown(drop) => format!("crowned, {} lower at the ends", said(drop)),
        RollerEnd::CrownedRadius { radius, crown } => format!(
            "crowned, {} lower at the ends, with fillets of radius {}",
            said(crown),
            said(radius)
        ),
    }
}

/// What acts on the top beside its vertical load, in words.
fn beside(loads: &TemplateLoads, units: &UnitLabels) -> Vec<String> {
    let pair = |pair: [f64; 2], unit: &str| {
        let [x, y] = pair.map(|value| significant(value, 4));
        (pair != [0.0; 2]).then(|| format!("{x}, {y} {unit}"))
    };
    let tilt = match loads.top {
        Top::Tilted(angles) => pair(angles.map(|angle| 1e3 * angle), "mrad"),
        Top::Free | Top::Held => None,
    };
    let free = (loads.top == Top::Free).then(|| "free to turn about x and y".to_owned());
    let moment = format!("{} {}", units.force, units.length);
    [
        (
            "eccentricity of the vertical load along x, y:",
            pair(loads.eccentricity, &units.length),
        ),
        (
            "horizontal force on the top along x, y:",
            pair(loads.horizontal, &units.force),
        ),
        ("moment on the top about x, y:", pair(loads.moment, &moment)),
        ("the top is turned about x, y by", tilt),
        ("the top is", free),
    ]
    .into_iter()
    .filter_map(|(what, value)| Some(format!("{what} {}", value?)))
    .collect()
}

/// Rollers that do not lie straight, in words.
fn askew(bearing: &BearingCase) -> Vec<String> {
    let turned = bearing.geometry.rollers(true).into_iter();
    let turned = turned.filter(|roller| roller.skew != 0.0);
    let said = |roller: RollerPlace| {
        let by = significant(1e3 * roller.skew, 4);
        format!("{} is askew: turned about z by {by} mrad", roller.body)
    };
    turned.map(said).collect()
}

/// What acts, in words.
fn actions(case: &Case, scene: &Scene) -> Vec<String> {
    let units = UnitLabels::of(case.units);
    let mut said = Vec::new();
    if let Some(bearing) = case.bearing() {
        said.push(format!(
            "vertical load on the top face, {} {}",
            significant(bearing.load, 5),
            units.force
        ));
        said.extend(beside(&bearing.loads, &units));
        said.extend(askew(bearing));
    }
    for temperature in &scene.temperatures {
        let of = significant(temperature.value, 4);
        let mut text = format!("temperature of {}: {of} K in its middle", temperature.body);
        if temperature.gradient != [0.0; 3] {
            let [x, y, z] = temperature
                .gradient
                .map(|gradient| significant(gradient, 4));
            let gradient = format!(", rising by ({x}, {y}, {z}) K/{}", units.length);
            text.push_str(&gradient);
        }
        said.push(text);
    }
    for step in &scene.steps {
        let factors: Vec<String> = (step.factors.iter())
            .map(|(name, factor)| format!("{name} × {}", significant(*factor, 4)))
            .collect();
        let others = match factors.is_empty() {
            true => "everything".to_owned(),
            false => format!("{}, everything else", factors.join(", ")),
        };
        let factor = significant(step.factor, 4);
        said.push(format!("step {}: {others} × {factor}", step.name));
    }
    said
}

/// Every input with its origin: given, assumed, or the default of a key that is not there.
fn inputs(case: &Case) -> Vec<InputRow> {
    // A case that was read is TOML.
    let text: Table = case.source.text().parse().unwrap_or_default();
    let mut rows = Vec::new();
    given("", &Value::Table(text.clone()), &mut rows);
    // Text for readers is no input.
    rows.retain(|row| !(row.key == "description" || row.key.starts_with("title_block.")));
    for assumption in &case.assumptions {
        rows.retain(|row| row.key != assumption.key);
        rows.push(InputRow {
            key: assumption.key.to_string(),
            value: assumption.value.to_string(),
            origin: match assumption.given {
                true => Origin::Given,
                false => Origin::Assumed,
            },
            about: assumption.why.to_string(),
        });
    }
    let mut tables: Vec<(&str, &Keys)> = vec![("controls", &keys::CONTROLS)];
    match case.bearing().map(|bearing| bearing.geometry.line()) {
        Some(Some(_)) => tables.extend([
            ("line_bearing", &keys::LINE_BEARING),
            ("mesh", &keys::LINE_BEARING_MESH),
        ]),
        Some(None) => tables.extend([("bearing", &keys::BEARING), ("mesh", &keys::BEARING_MESH)]),
        None => {}
    }
    for (table, keys) in tables {
        let there = text.get(table).and_then(Value::as_table);
        for key in keys.keys {
            let path = format!("{table}.{}", key.name);
            let said = there.is_some_and(|there| there.contains_key(key.name));
            let known = said || rows.iter().any(|row| row.key == path);
            // What is required is given, and what is none is not there.
            let is_value = !(key.default.starts_with("required")
                || key.default == "none"
                || key.default == "of the preset");
            if !known && is_value {
                rows.push(InputRow {
                    key: path,
                    value: key.default.replace('`', ""),
                    origin: Origin::Default,
                    about: key.meaning.to_owned(),
                });
            }
        }
    }
    rows
}

/// The values below a key, one a row.
fn given(key: &str, value: &Value, rows: &mut Vec<InputRow>) {
    let path = |name: &str| match key.is_empty() {
        true => name.to_owned(),
        false => format!("{key}.{name}"),
    };
    match value {
        Value::Table(table) => {
            for (name, value) in table {
                given(&path(name), value, rows);
            }
        }
        Value::Array(list) if list.iter().any(Value::is_table) => {
            for (index, value) in list.iter().enumerate() {
                let name = value.get("name").and_then(Value::as_str);
                let name = name.map_or_else(|| format!("{}", index + 1), str::to_owned);
                given(&path(&name), value, rows);
            }
        }
        _ => rows.push(InputRow {
            key: key.to_owned(),
            value: match value {
                Value::String(text) => text.clone(),
                other => other.to_string(),
            },
            origin: Origin::Given,
            about: keys::meaning(key).unwrap_or_default().to_owned(),
        }),
    }
}
