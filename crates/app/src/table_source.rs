//! A table that a request brings along: the path of its file, or its text.

use std::path::{Path, PathBuf};

use clap::builder::{MapValueParser, PathBufValueParser, TypedValueParser, ValueParserFactory};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};
use soilctl_direct_shear::{ShearSeries, parse_shear_points, read_shear_points};
use soilctl_strokes::{Campaign, ReadOptions, StrokeTable};

use crate::AppError;
#[cfg(not(target_family = "wasm"))]
use crate::files;

/// Stands for the file in messages about a table that has none.
const NAME: &str = "the table";

/// A table as the path of a file, or as the text that such a file would have, in CSV.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
pub enum TableSource {
    /// The path of a file.
    Path(PathBuf),
    /// The text itself.
    Text {
        /// A header, then one row a line.
        csv: String,
    },
}

impl TableSource {
    /// The path, if it is a file.
    #[must_use]
    pub fn path(&self) -> Option<&Path> {
        match self {
            Self::Path(path) => Some(path),
            Self::Text { .. } => None,
        }
    }

    /// What messages call it.
    #[must_use]
    pub fn name(&self) -> String {
        self.path().map_or_else(|| NAME.to_owned(), |path| path.display().to_string())
    }

    /// Its text.
    #[cfg(not(target_family = "wasm"))]
    pub(crate) fn text(&self) -> Result<String, AppError> {
        match self {
            Self::Path(path) => files::read_text(path),
            Self::Text { csv } => Ok(csv.clone()),
        }
    }

    pub(crate) fn strokes(&self, options: ReadOptions) -> Result<StrokeTable, AppError> {
        Ok(match self {
            Self::Path(path) => StrokeTable::read(path, options)?,
            Self::Text { csv } => StrokeTable::from_reader(csv.as_bytes(), NAME, options)?,
        })
    }

    /// What is known of the campaign, from the file beside the table.
    pub(crate) fn campaign(&self) -> Result<Campaign, AppError> {
        let beside = self.path().map(Campaign::read_beside).transpose()?;
        Ok(beside.flatten().unwrap_or_default())
    }

    pub(crate) fn shear_points(&self) -> Result<Vec<ShearSeries>, AppError> {
        Ok(match self {
            Self::Path(path) => read_shear_points(path)?,
            Self::Text { csv } => parse_shear_points(csv.as_bytes(), NAME)?,
        })
    }
}

impl Default for TableSource {
    fn default() -> Self {
        Self::Path(PathBuf::new())
    }
}

impl<P: Into<PathBuf>> From<P> for TableSource {
    fn from(path: P) -> Self {
        Self::Path(path.into())
    }
}

/// The command line takes paths only.
impl ValueParserFactory for TableSource {
    type Parser = MapValueParser<PathBufValueParser, fn(PathBuf) -> Self>;

    fn value_parser() -> Self::Parser {
        PathBufValueParser::new().map(Self::Path)
    }
}

impl JsonSchema for TableSource {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        "TableSource".into()
    }

    fn inline_schema() -> bool {
        true
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({"anyOf": [
            {"type": "string"},
            {"type": "object", "properties": {"csv": {"type": "string"}}, "required": ["csv"],
             "additionalProperties": false},
        ]})
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_reads_as_its_file_does() {
        let csv = "alpha_deg,depth_m,width_m,force_n\n80,0.02,0.1,5\n";
        let text: TableSource = serde_json::from_value(serde_json::json!({"csv": csv})).unwrap();
        let found = text.strokes(ReadOptions::default()).unwrap();
        let row = found.rows().next().unwrap();
        assert_eq!((row.line, row.alpha_deg, row.force_n), (2, 80.0, 5.0));
        let bad = TableSource::Text { csv: csv.replace("0.1", "x") };
        let problem = bad.strokes(ReadOptions::default()).unwrap_err().to_string();
        assert!(problem.starts_with("the table, line 2") && problem.contains("width_m"), "{problem}");
        let path: TableSource = serde_json::from_value(serde_json::json!("strokes.csv")).unwrap();
        assert_eq!(path, "strokes.csv".into());
    }
}
