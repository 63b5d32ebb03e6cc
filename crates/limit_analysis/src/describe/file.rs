//! Problem files in and out.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::error::DescriptionError;
use super::input::Description;

/// What [`Description::schema`] may say.
pub const PROBLEM_SCHEMA: &str = "soilctl.problem/1";

/// Longest file in bytes: far above what the greatest number of points needs.
const MAX_BYTES: u64 = 1 << 20;

impl Description {
    /// Reads a problem file, in TOML or JSON as its name ends.
    ///
    /// # Errors
    ///
    /// [`DescriptionError`] for a file that cannot be read, is longer than 1 MiB, or is not a description.
    pub fn read(path: &Path) -> Result<Self, DescriptionError> {
        let ending = path.extension().and_then(|e| e.to_str()).unwrap_or("").to_ascii_lowercase();
        let parse: fn(&str, &str) -> Result<Self, DescriptionError> = match ending.as_str() {
            "toml" => from_toml,
            "json" => from_json,
            _ => return Err(DescriptionError::Ending { path: path.to_owned() }),
        };
        let mut text = String::new();
        // Some files have no length, or grow.
        File::open(path)
            .and_then(|f| f.take(MAX_BYTES + 1).read_to_string(&mut text))
            .map_err(|e| DescriptionError::File { path: path.to_owned(), message: e.to_string() })?;
        if text.len() as u64 > MAX_BYTES {
            return Err(DescriptionError::TooLarge { path: path.to_owned(), limit: MAX_BYTES });
        }
        parse(&text, &path.display().to_string())
    }

    /// Reads TOML.
    ///
    /// # Errors
    ///
    /// [`DescriptionError::Format`] with the line and what was expected there.
    pub fn from_toml(text: &str) -> Result<Self, DescriptionError> {
        from_toml(text, "the text")
    }

    /// Reads JSON.
    ///
    /// # Errors
    ///
    /// [`DescriptionError::Format`] with the line and what was expected there.
    pub fn from_json(text: &str) -> Result<Self, DescriptionError> {
        from_json(text, "the text")
    }

    /// The description as TOML.
    ///
    /// # Errors
    ///
    /// [`DescriptionError::Format`] if a number cannot be written.
    pub fn to_toml(&self) -> Result<String, DescriptionError> {
        toml::to_string(self)
            .map_err(|e| DescriptionError::Format { place: "the description".into(), message: e.to_string() })
    }
}

fn from_toml(text: &str, place: &str) -> Result<Description, DescriptionError> {
    let parsed = toml::from_str(text);
    known_schema(parsed.map_err(|e: toml::de::Error| format(place, &e.to_string()))?, place)
}

fn from_json(text: &str, place: &str) -> Result<Description, DescriptionError> {
    known_schema(serde_json::from_str(text).map_err(|e| format(place, &e.to_string()))?, place)
}

fn format(place: &str, message: &str) -> DescriptionError {
    DescriptionError::Format { place: place.into(), message: message.trim_end().into() }
}

fn known_schema(description: Description, place: &str) -> Result<Description, DescriptionError> {
    match &description.schema {
        Some(other) if other != PROBLEM_SCHEMA => {
            Err(format(place, &format!("schema is \"{other}\", this version reads \"{PROBLEM_SCHEMA}\"")))
        }
        _ => Ok(description),
    }
}
