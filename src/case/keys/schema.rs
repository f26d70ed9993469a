//! The JSON schema of case files, read as JSON: made from what the keys say that they take.

use super::{
    ACTION, AXES, BEARING, BEARING_MESH, BODY, COMBINATION, COMPARISON, CONTACT, CONTROLS,
    FAMILY_MESH, FILE_MESH, HARDENING, Key, Keys, LINE_BEARING, LINE_BEARING_MESH,
    LINE_PLATE_CURVE, LINE_PLATE_SIZE, LINE_PLATE_THICKNESS, LOAD, PARTNER, PLANE, PLATE_THICKNESS,
    RIGID_PLANE, ROLLER_END, ROOT, SCENE, STEEL, STEP, SUPPORT, TEMPERATURE, TIE, TILTED_TOP,
    TITLE_BLOCK,
};
use serde_json::{Map, Value, json};

/// The schema of a case file.
pub fn schema() -> Value {
    let steel = steel();
    let body_steel = json!({ "anyOf": [{ "type": "string" }, steel] });
    let mesh = any([
        object(&BEARING_MESH, &[]),
        object(&LINE_BEARING_MESH, &[]),
        object(&FILE_MESH, &[]),
        object(&FAMILY_MESH, &[]),
    ]);
    let root = [
        ("bearing", bearing()),
        ("line_bearing", line_bearing()),
        ("steel", any([json!({ "type": "string" }), steels(&steel)])),
        ("mesh", mesh),
        ("controls", object(&CONTROLS, &[])),
        ("comparison", object(&COMPARISON, &[])),
        ("title_block", object(&TITLE_BLOCK, &[])),
        ("action", list(object(&ACTION, &[]))),
        ("combination", list(object(&COMBINATION, &[]))),
        ("body", list(object(&BODY, &[("steel", body_steel)]))),
        ("contact", list(contact())),
        ("tie", list(object(&TIE, &[]))),
        ("support", list(object(&SUPPORT, &[]))),
        ("rigid_plane", list(object(&RIGID_PLANE, &rigid_plane()))),
        ("pressure", list(object(&LOAD, &[]))),
        ("traction", list(object(&LOAD, &[]))),
        ("temperature", list(object(&TEMPERATURE, &[]))),
        ("step", list(object(&STEP, &[]))),
    ];
    let mut whole = properties(&ROOT, &root);
    whole.extend(properties(&SCENE, &root));
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Case file of Brinell, read as JSON",
        "type": "object",
        "properties": whole,
        "required": required(&ROOT),
        "additionalProperties": false,
    })
}

fn bearing() -> Value {
    let thickness = any([quantity(), object(&PLATE_THICKNESS, &[])]);
    let end = any([json!({ "const": "square" }), object(&ROLLER_END, &[])]);
    let inner = [
        ("plate_thickness", thickness),
        ("roller_end", end),
        ("top", top()),
    ];
    object(&BEARING, &inner)
}

fn top() -> Value {
    any([
        json!({ "enum": ["held", "free"] }),
        object(&TILTED_TOP, &[]),
    ])
}

fn line_bearing() -> Value {
    let of_each = |keys: &Keys, whole: Value| any([whole, object(keys, &[])]);
    let plan = || any([quantity(), list(quantity())]);
    let end = any([json!({ "const": "square" }), object(&ROLLER_END, &[])]);
    let each = [("upper", plan()), ("lower", plan())];
    object(
        &LINE_BEARING,
        &[
            (
                "plate_thickness",
                of_each(&LINE_PLATE_THICKNESS, quantity()),
            ),
            ("plate_size", any([plan(), object(&LINE_PLATE_SIZE, &each)])),
            ("plate_curve", object(&LINE_PLATE_CURVE, &[])),
            ("top", top()),
            ("roller_end", end),
        ],
    )
}

fn steel() -> Value {
    object(&STEEL, &[("hardening", object(&HARDENING, &[]))])
}

/// `[steel]` has keys of its own and tables of bodies.
fn steels(steel: &Value) -> Value {
    let mut whole = steel.clone();
    whole["additionalProperties"] = steel.clone();
    whole
}

fn contact() -> Value {
    let plane = object(&PARTNER, &[("plane", object(&PLANE, &[]))]);
    let side = any([json!({ "type": "string" }), plane]);
    object(&CONTACT, &[("upper", side.clone()), ("lower", side)])
}

fn rigid_plane() -> [(&'static str, Value); 4] {
    [
        ("rotation", object(&AXES, &[])),
        ("moment", object(&AXES, &[])),
        ("displacement", object(&AXES, &[])),
        ("force", object(&AXES, &[])),
    ]
}

/// A table with the keys `keys`; what of them is not of one line is in `inner`.
fn object(keys: &Keys, inner: &[(&str, Value)]) -> Value {
    json!({
        "description": keys.about,
        "type": "object",
        "properties": properties(keys, inner),
        "required": required(keys),
        "additionalProperties": false,
    })
}

fn required(keys: &Keys) -> Vec<&'static str> {
    let all = keys.keys.iter().filter(|key| key.default == "required");
    all.map(|key| key.name).collect()
}

fn properties(keys: &Keys, inner: &[(&str, Value)]) -> Map<String, Value> {
    let of = |key: &Key| {
        let known = inner.iter().find(|(name, _)| *name == key.name);
        let mut value = match known {
            Some((_, value)) => value.clone(),
            // What is not understood is not restricted.
            None => takes(key.takes).unwrap_or(json!({})),
        };
        value["description"] = format!("{}; default: {}", key.meaning, key.default).into();
        (key.name.to_owned(), value)
    };
    keys.keys.iter().map(of).collect()
}

fn any<const N: usize>(choices: [Value; N]) -> Value {
    json!({ "anyOf": choices.to_vec() })
}

fn list(of: Value) -> Value {
    json!({ "type": "array", "items": of })
}

/// A bare number in the units of the case, or a string with its unit.
fn quantity() -> Value {
    json!({ "type": ["number", "string"] })
}

/// The schema of what a key says that it takes; `None` of words that are not known.
pub fn takes(words: &str) -> Option<Value> {
    const QUANTITIES: [&str; 7] = [
        "length",
        "force",
        "stress",
        "angle",
        "share",
        "difference of temperature",
        "expansion",
    ];
    let begins = |word: &str| {
        let rest = words.strip_prefix(word);
        rest.is_some_and(|rest| rest.is_empty() || rest.starts_with([',', ' ']))
    };
    if words.starts_with('`') {
        return Some(choice(words));
    }
    if words.contains(", or a list of") {
        return Some(any([quantity(), list(quantity())]));
    }
    if let Some(of) = words.strip_prefix("list of ") {
        return Some(list(listed(of)?));
    }
    if words.starts_with("stress of a pressure") {
        return Some(any([quantity(), list(quantity())]));
    }
    if QUANTITIES.iter().any(|word| begins(word)) {
        return Some(quantity());
    }
    if begins("table of") || begins("table by axis of") {
        return Some(json!({ "type": "object", "additionalProperties": quantity() }));
    }
    if begins("table") {
        return Some(json!({ "type": "object" }));
    }
    if begins("true or false") {
        return Some(json!({ "type": "boolean" }));
    }
    if begins("whole number") {
        return Some(json!({ "type": "integer", "minimum": 1 }));
    }
    if begins("number") {
        return Some(json!({ "type": ["number", "string"] }));
    }
    let texts = [
        "text",
        "surface",
        "name",
        "path",
        "some of the letters",
        "unit of length",
    ];
    texts
        .iter()
        .any(|word| begins(word))
        .then(|| json!({ "type": "string" }))
}

/// What a list has.
fn listed(words: &str) -> Option<Value> {
    if words.starts_with('`') {
        return Some(choice(words));
    }
    let of = [
        "tables",
        "names",
        "forces",
        "three shares",
        "three lengths",
        "three differences of temperature",
        "two surfaces",
        "two lengths",
        "two forces",
        "two moments",
        "two angles",
    ];
    let found = of.iter().find(|of| words.starts_with(*of))?;
    Some(match *found {
        "tables" => json!({ "type": "object" }),
        "names" | "two surfaces" => json!({ "type": "string" }),
        _ => quantity(),
    })
}

/// One of the words between backquotes.
fn choice(words: &str) -> Value {
    let quoted = words.split('`').skip(1).step_by(2);
    let words: Vec<&str> = quoted.map(|word| word.trim_matches('"')).collect();
    json!({ "enum": words })
}

/// Keys whose words say nothing to [`takes`], of all tables.
pub fn not_understood() -> Vec<String> {
    let tables = super::CHAPTERS.iter().flat_map(|(_, tables)| tables.iter());
    let all = tables.flat_map(|keys| keys.keys.iter().map(move |key| (keys, key)));
    let strange = all.filter(|(_, key)| takes(key.takes).is_none());
    let name =
        |(keys, key): (&&Keys, &Key)| format!("{}: {}: {}", keys.heading, key.name, key.takes);
    strange.map(name).collect()
}
