//! A case with some of its keys changed.

use std::collections::BTreeMap;
use toml::{Table, Value};

/// The case `text` with the values of `set` in place of its own, by dotted key. What is no TOML, or
/// cannot take a key, stays as it is: the reader of the case then says what is wrong.
pub fn changed(text: &str, set: &BTreeMap<String, Value>) -> String {
    let Ok(mut case) = text.parse::<Table>() else {
        return text.to_owned();
    };
    for (key, value) in set {
        let keys: Vec<&str> = key.split('.').collect();
        let mut place = Value::Table(case);
        put(&mut place, &keys, value);
        case = match place {
            Value::Table(table) => table,
            _ => Table::new(),
        };
    }
    case.to_string()
}

fn put(place: &mut Value, keys: &[&str], value: &Value) {
    let [key, rest @ ..] = keys else {
        *place = value.clone();
        return;
    };
    let inner = match place {
        Value::Table(table) => {
            let empty = || Value::Table(Table::new());
            Some(table.entry(*key).or_insert_with(empty))
        }
        Value::Array(list) => key.parse().ok().and_then(|at: usize| list.get_mut(at)),
        _ => None,
    };
    if let Some(inner) = inner {
        put(inner, rest, value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_replaced_and_added() {
        let text = "a = 1\n[[contact]]\nfriction = 0.1\n[[contact]]\nfriction = 0.2\n";
        let set = [
            ("contact.1.friction", Value::Float(5.0)),
            ("steel.lower.elastic", Value::Boolean(true)),
        ];
        let set = set.map(|(k, v)| (k.to_owned(), v)).into();
        let case: Table = changed(text, &set).parse().unwrap();
        assert_eq!(case["contact"][0]["friction"].as_float(), Some(0.1));
        assert_eq!(case["contact"][1]["friction"].as_float(), Some(5.0));
        assert_eq!(case["steel"]["lower"]["elastic"].as_bool(), Some(true));
    }
}
