//! A case with some of its keys changed, from its text to a text.

use std::collections::BTreeMap;
use toml::{Table, Value};

/// The case `text` with the values of `set` in place of its own, by dotted key such as
/// `bearing.load`; entries of an array by their number from 0, or by their `name`. What is no TOML,
/// or cannot take a key, stays as it is: the reader of the case then says what is wrong.
pub fn changed(text: &str, set: &BTreeMap<String, Value>) -> String {
    let Ok(mut case) = text.parse::<Table>() else {
        return text.to_owned();
    };
    for (key, value) in set {
        put_in(&mut case, key, value);
    }
    case.to_string()
}

/// Has the case `text` a place for the dotted key?
pub fn has_place(text: &str, key: &str) -> bool {
    let case = text.parse::<Table>();
    case.is_ok_and(|mut case| put_in(&mut case, key, &Value::Boolean(true)))
}

/// Was there a place for it?
fn put_in(case: &mut Table, key: &str, value: &Value) -> bool {
    let keys: Vec<&str> = key.split('.').collect();
    let mut place = Value::Table(std::mem::take(case));
    let done = put(&mut place, &keys, value);
    if let Value::Table(table) = place {
        *case = table;
    }
    done
}

fn put(place: &mut Value, keys: &[&str], value: &Value) -> bool {
    let [key, rest @ ..] = keys else {
        *place = value.clone();
        return true;
    };
    let inner = match place {
        Value::Table(table) => {
            let empty = || Value::Table(Table::new());
            Some(table.entry(*key).or_insert_with(empty))
        }
        Value::Array(list) => entry(list, key),
        _ => None,
    };
    inner.is_some_and(|inner| put(inner, rest, value))
}

/// The entry of an array that has this number or this name.
fn entry<'v>(list: &'v mut [Value], key: &str) -> Option<&'v mut Value> {
    let named = |v: &Value| v.get("name").and_then(Value::as_str) == Some(key);
    match key.parse::<usize>() {
        Ok(at) => list.get_mut(at),
        Err(_) => list.iter_mut().find(|v| named(v)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str =
        "a = 1\n[[contact]]\nfriction = 0.1\n[[contact]]\nname = \"b-c\"\nfriction = 0.2\n";

    #[test]
    fn keys_are_replaced_and_added() {
        let set = [
            ("contact.1.friction", Value::Float(5.0)),
            ("steel.lower.elastic", Value::Boolean(true)),
        ];
        let set = set.map(|(k, v)| (k.to_owned(), v)).into();
        let case: Table = changed(TEXT, &set).parse().unwrap();
        assert_eq!(case["contact"][0]["friction"].as_float(), Some(0.1));
        assert_eq!(case["contact"][1]["friction"].as_float(), Some(5.0));
        assert_eq!(case["steel"]["lower"]["elastic"].as_bool(), Some(true));
    }

    #[test]
    fn entries_of_an_array_have_numbers_and_names() {
        let set = BTreeMap::from([("contact.b-c.friction".to_owned(), Value::Float(3.0))]);
        let case: Table = changed(TEXT, &set).parse().unwrap();
        assert_eq!(case["contact"][1]["friction"].as_float(), Some(3.0));
        assert!(has_place(TEXT, "contact.0.friction") && has_place(TEXT, "new.key"));
        for nowhere in ["contact.2.friction", "contact.c-d.friction", "a.b"] {
            assert!(!has_place(TEXT, nowhere), "{nowhere}");
        }
    }
}
