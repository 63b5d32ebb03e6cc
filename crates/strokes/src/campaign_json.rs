use std::cell::RefCell;

use serde_json::{Map, Value};

use crate::StrokesError;
use crate::cell::shortened;

/// Largest magnitude of a number; keeps squares finite.
const MOST: f64 = 1e12;

/// The keys of a JSON object, with what is needed to say which one is wrong.
pub(crate) struct Keys<'a> {
    map: Map<String, Value>,
    file: &'a str,
    /// What stands before a key in messages.
    prefix: String,
    /// The keys that were asked for: those that mean something.
    known: RefCell<Vec<&'static str>>,
}

impl<'a> Keys<'a> {
    pub(crate) fn parse(text: &str, file: &'a str) -> Result<Self, StrokesError> {
        let bad = |problem: String| StrokesError::NotAnObject { file: file.into(), problem };
        // Editors on Windows put a byte-order mark in front.
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        match serde_json::from_str(text).map_err(|problem| bad(problem.to_string()))? {
            Value::Object(map) => Ok(Self { map, file, prefix: String::new(), known: RefCell::default() }),
            other => Err(bad(format!("it is {}; put the keys in braces", shortened(&other.to_string())))),
        }
    }

    /// The value of a key; `null` counts as left out.
    fn get(&self, key: &'static str) -> Option<&Value> {
        self.known.borrow_mut().push(key);
        self.map.get(key).filter(|value| !value.is_null())
    }

    /// Refuses a key that nothing has asked for: a misspelt one would otherwise be as if it were left out.
    pub(crate) fn refuse_unknown(&self) -> Result<(), StrokesError> {
        let known = self.known.borrow();
        let Some(key) = self.map.keys().find(|key| !known.contains(&key.as_str())) else { return Ok(()) };
        let nearest = known.iter().min_by_key(|other| strsim::damerau_levenshtein(key, other));
        Err(StrokesError::UnknownKey {
            file: self.file.into(),
            key: format!("{}{}", self.prefix, shortened(key)),
            nearest: format!("{}{}", self.prefix, nearest.copied().unwrap_or_default()),
            known: known.join(", "),
        })
    }

    fn bad(&self, key: &str, found: &Value, allowed: &'static str, default: String) -> StrokesError {
        StrokesError::BadKey {
            file: self.file.into(),
            key: format!("{}{key}", self.prefix),
            found: shortened(&found.to_string()),
            allowed,
            default,
        }
    }

    /// The keys of an inner object; none if it is left out.
    pub(crate) fn object(&self, key: &'static str) -> Result<Self, StrokesError> {
        let map = match self.get(key) {
            None => Map::new(),
            Some(Value::Object(map)) => map.clone(),
            Some(other) => return Err(self.bad(key, other, "an object in braces", "all defaults".into())),
        };
        Ok(Self { map, file: self.file, prefix: format!("{key}."), known: RefCell::default() })
    }

    fn number(
        &self,
        key: &'static str,
        default: &str,
        allowed: &'static str,
        ok: impl Fn(f64) -> bool,
    ) -> Result<Option<f64>, StrokesError> {
        let Some(value) = self.get(key) else { return Ok(None) };
        match value.as_f64() {
            Some(number) if number.is_finite() && ok(number) => Ok(Some(number)),
            _ => Err(self.bad(key, value, allowed, default.into())),
        }
    }

    pub(crate) fn optional_angle(&self, key: &'static str) -> Result<Option<f64>, StrokesError> {
        self.number(key, "unknown", "a number above 0 and below 90 (deg)", |x| x > 0.0 && x < 90.0)
    }

    pub(crate) fn optional_positive(&self, key: &'static str) -> Result<Option<f64>, StrokesError> {
        self.number(key, "1", "a number above 0 (up to 1e12)", |x| x > 0.0 && x <= MOST)
    }

    pub(crate) fn positive(&self, key: &'static str, default: f64) -> Result<f64, StrokesError> {
        let allowed = "a number above 0 (up to 1e12), in the unit of the key";
        let found = self.number(key, &default.to_string(), allowed, |x| x > 0.0 && x <= MOST)?;
        Ok(found.unwrap_or(default))
    }

    pub(crate) fn at_least_zero(&self, key: &'static str, default: f64) -> Result<f64, StrokesError> {
        let allowed = "a number of at least 0 (up to 1e12), in the unit of the key";
        let found = self.number(key, &default.to_string(), allowed, |x| (0.0..=MOST).contains(&x))?;
        Ok(found.unwrap_or(default))
    }

    pub(crate) fn bool(&self, key: &'static str, default: bool) -> Result<bool, StrokesError> {
        match self.get(key) {
            None => Ok(default),
            Some(Value::Bool(value)) => Ok(*value),
            Some(other) => Err(self.bad(key, other, "true or false", default.to_string())),
        }
    }

    pub(crate) fn text(&self, key: &'static str) -> Result<String, StrokesError> {
        match self.get(key) {
            None => Ok(String::new()),
            Some(Value::String(value)) => Ok(value.clone()),
            Some(other) => Err(self.bad(key, other, "text in quotes", "empty".into())),
        }
    }
}
