//! Unites the tables of bounds that shards built.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_earth_pressure::table::{BracketRules, BracketTable};

pub use super::Answer;
use super::Head;
use super::brackets::{Gaps, NAME, SOURCE};
use crate::table_file::{for_brackets, read_brackets, write_brackets};
use crate::{AppError, Watch};

/// Unites the tables of bounds that `build --shard` made.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct Request {
    /// Files to unite, built by the same version with the same --max-gap and --max-elements
    #[arg(value_name = "FILE", required = true)]
    pub files: Vec<PathBuf>,

    /// File to write (.csv)
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
}

/// Unites the files of shards.
///
/// # Errors
/// [`AppError`] if a file cannot be read or was built otherwise than the first, or the table cannot be written.
pub fn run(request: &Request, _watch: &dyn Watch) -> Result<Answer, AppError> {
    let Request { files, out } = request;
    for_brackets(out)?;
    let (mut rows, mut first) = (Vec::new(), None);
    for path in files {
        let (table, version) = read_brackets(path)?;
        rows.extend_from_slice(table.rows());
        let made = (table.rules(), version);
        let (expected, whence) = first.get_or_insert_with(|| (made.clone(), path));
        if made != *expected {
            let words = |(rules, version): &(BracketRules, String)| {
                format!(
                    "soilctl {version} with --max-gap {} --max-elements {}",
                    rules.max_gap, rules.max_elements
                )
            };
            return Err(AppError::Request(format!(
                "{} was built by {}, but {} by {}; a table keeps to one rule, so build them alike",
                path.display(),
                words(&made),
                whence.display(),
                words(expected)
            )));
        }
    }
    let Some(((rules, version), _)) = first else {
        return Err(AppError::Request("no file to merge was given".into()));
    };
    if version != env!("CARGO_PKG_VERSION") {
        return Err(AppError::Request(format!(
            "the files were built by soilctl {version}; merge them with that version, this is {}",
            env!("CARGO_PKG_VERSION")
        )));
    }
    let table = BracketTable::new(NAME, rules, rows)?;
    write_brackets(&table, SOURCE, out)?;
    let file = out.display().to_string();
    Ok(Answer::Merge { table: Head::of_brackets(&table), gaps: Gaps::of(&table), file })
}
