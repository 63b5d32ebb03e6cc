//! Values of a description by the name of their parameter.
//!
//! A parameter is a key of the file with dots between tables: `surcharge_kpa`, `seismic.kh`, `soil.sand.phi_deg`. Of tables
//! that there may be several of, the second part is the name of one, which may have dots itself; parts of a structure share
//! a name, and all of them are set.

use serde_json::{Map, Value};

use super::Setting;
use crate::describe::error::DescriptionError;
use crate::describe::input::Description;

/// A description with other values.
pub(super) fn set(
    plain: &Description,
    title: &str,
    changes: &[(&str, Setting)],
) -> Result<Description, DescriptionError> {
    if changes.is_empty() {
        return Ok(plain.clone());
    }
    let wrong = |problem: String| DescriptionError::entry(title, problem);
    let mut value = serde_json::to_value(plain).map_err(|e| wrong(e.to_string()))?;
    for (parameter, setting) in changes {
        let setting = serde_json::to_value(setting).map_err(|e| wrong(e.to_string()))?;
        let parts = places(&mut value, parameter).map_err(wrong)?;
        for (table, key) in parts {
            table.insert(key, setting.clone());
        }
    }
    // A key that there is none of, or one that takes something else, is refused as it would be in a file.
    let parameters: Vec<&str> = changes.iter().map(|(parameter, _)| *parameter).collect();
    serde_json::from_value(value)
        .map_err(|e| wrong(format!("it sets {}, which does not fit: {e}", parameters.join(", "))))
}

/// A table that holds a parameter, and its key there.
type Place<'a> = (&'a mut Map<String, Value>, String);

/// Where a parameter stands: in each part of a structure, or in one table.
fn places<'a>(root: &'a mut Value, parameter: &str) -> Result<Vec<Place<'a>>, String> {
    let none = || {
        format!("there is no parameter \"{parameter}\"; one is called like soil.NAME.phi_deg or seismic.kh")
    };
    let root = root.as_object_mut().ok_or_else(none)?;
    let Some((first, rest)) = parameter.split_once('.') else {
        return match root.get(parameter) {
            Some(Value::Array(_) | Value::Object(_)) => Err(none()),
            _ => Ok(vec![(root, parameter.to_owned())]),
        };
    };
    // An earthquake that the file does not have may come with a case.
    if first == "seismic" {
        root.entry(first).or_insert_with(|| Value::Object(Map::new()));
    }
    match root.get_mut(first) {
        Some(Value::Array(entries)) => {
            let known: Vec<String> = entries
                .iter()
                .filter_map(|e| e.get("name").and_then(Value::as_str))
                .map(|name| format!("\"{name}\""))
                .collect();
            let found: Vec<_> = entries
                .iter_mut()
                .filter_map(Value::as_object_mut)
                .filter_map(|entry| {
                    let name = entry.get("name").and_then(Value::as_str)?;
                    let key = rest.strip_prefix(name)?.strip_prefix('.')?.to_owned();
                    Some((entry, key))
                })
                .collect();
            if found.is_empty() {
                let known = if known.is_empty() { "none has a name".to_owned() } else { known.join(", ") };
                return Err(format!("there is no {first} for the parameter \"{parameter}\"; known: {known}"));
            }
            Ok(found)
        }
        Some(Value::Object(table)) => Ok(vec![(table, rest.to_owned())]),
        _ => Err(none()),
    }
}
