//! From one problem file to another with the same entries: all numbers at once, so that a slope gets steeper or a wall longer.

use std::path::Path;

use serde_json::Value;
use soilctl_limit_analysis::{Description, LimitError};

use crate::AppError;
use crate::files::read_text;

/// Two files of the same entries.
pub(super) struct Between {
    first: Value,
    second: Value,
}

impl Between {
    /// Reads both; they must be problems each, and differ in numbers alone.
    pub(super) fn read(first: &Path, second: &Path) -> Result<Self, AppError> {
        let both = Self { first: raw(first)?, second: raw(second)? };
        let mut place = Vec::new();
        let mut differ = 0;
        check(&both.first, &both.second, &mut place, &mut differ)?;
        if differ == 0 {
            let problem = format!(
                "{} and {} say the same; nothing changes between them",
                first.display(),
                second.display()
            );
            return Err(AppError::Request(problem));
        }
        Ok(both)
    }

    /// The problem at a part of the way.
    pub(super) fn at(&self, part: f64) -> Result<Description, AppError> {
        Ok(serde_json::from_value(mixed(&self.first, &self.second, part))?)
    }
}

/// The keys as they stand in the file, also those whose value is the default.
fn raw(path: &Path) -> Result<Value, AppError> {
    Description::read(path).map_err(LimitError::from)?;
    let text = read_text(path)?;
    let is_json = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
    let value = if is_json { serde_json::from_str(&text).ok() } else { toml::from_str(&text).ok() };
    value.ok_or_else(|| {
        AppError::Request(format!("{}: it was read, and cannot be read again", path.display()))
    })
}

/// Refuses what differs other than by a number; titles may.
fn check(a: &Value, b: &Value, place: &mut Vec<String>, differ: &mut usize) -> Result<(), AppError> {
    let here = |place: &[String], words: &str| {
        let at = if place.is_empty() { "the file".to_owned() } else { place.join(".") };
        AppError::Request(format!(
            "{at} {words}: both files must have the same entries and keys, and differ in numbers alone"
        ))
    };
    match (a, b) {
        (Value::Number(x), Value::Number(y)) => {
            *differ += usize::from(x.as_f64() != y.as_f64());
            Ok(())
        }
        (Value::Array(x), Value::Array(y)) => {
            if x.len() != y.len() {
                return Err(here(
                    place,
                    &format!("has {} entries in one file and {} in the other", x.len(), y.len()),
                ));
            }
            for (i, (x, y)) in x.iter().zip(y).enumerate() {
                place.push((i + 1).to_string());
                check(x, y, place, differ)?;
                place.pop();
            }
            Ok(())
        }
        (Value::Object(x), Value::Object(y)) => {
            if let Some(key) =
                x.keys().find(|k| !y.contains_key(*k)).or(y.keys().find(|k| !x.contains_key(*k)))
            {
                place.push(key.clone());
                return Err(here(place, "is in one file only"));
            }
            for (key, x) in x.iter().filter(|(key, _)| *key != "title") {
                place.push(key.clone());
                check(x, &y[key], place, differ)?;
                place.pop();
            }
            Ok(())
        }
        _ if a == b => Ok(()),
        _ => Err(here(place, &format!("is {a} in one file and {b} in the other"))),
    }
}

fn mixed(a: &Value, b: &Value, part: f64) -> Value {
    match (a, b) {
        (Value::Number(x), Value::Number(y)) => match (x.as_f64(), y.as_f64()) {
            (Some(x), Some(y)) if x != y => Value::from(x * (1.0 - part) + y * part),
            _ => a.clone(),
        },
        (Value::Array(x), Value::Array(y)) => x.iter().zip(y).map(|(x, y)| mixed(x, y, part)).collect(),
        (Value::Object(x), Value::Object(y)) => {
            let value = |(key, x): (&String, &Value)| {
                (key.clone(), y.get(key).map_or_else(|| x.clone(), |y| mixed(x, y, part)))
            };
            Value::Object(x.iter().map(value).collect())
        }
        _ => a.clone(),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use serde_json::json;

    use super::*;

    fn refused(a: &Value, b: &Value) -> String {
        check(a, b, &mut Vec::new(), &mut 0).unwrap_err().to_string()
    }

    #[test]
    fn numbers_go_along_and_nothing_else_may() {
        let a = json!({"title": "a", "region": [{"soil": "sand", "polygon": [[0, 0], [1.5, 2]]}], "kh": 0});
        let b = json!({"title": "b", "region": [{"soil": "sand", "polygon": [[0, 0], [2.5, 4]]}], "kh": 0});
        let mut differ = 0;
        check(&a, &b, &mut Vec::new(), &mut differ).unwrap();
        assert_eq!(differ, 2);
        let half =
            json!({"title": "a", "region": [{"soil": "sand", "polygon": [[0, 0], [2.0, 3.0]]}], "kh": 0});
        assert_eq!(mixed(&a, &b, 0.5), half);
        assert_eq!(mixed(&a, &b, 0.0)["region"][0]["polygon"][1][0], 1.5);
        let other =
            json!({"title": "b", "region": [{"soil": "clay", "polygon": [[0, 0], [2.5, 4]]}], "kh": 0});
        assert!(refused(&a, &other).starts_with("region.1.soil is \"sand\" in one file"));
        let longer = json!({"title": "b", "region": [{"soil": "sand", "polygon": [[0, 0]]}], "kh": 0});
        assert!(refused(&a, &longer).starts_with("region.1.polygon has 2 entries"));
        assert!(refused(&a, &json!({"title": "b"})).starts_with("kh is in one file only"));
    }
}
