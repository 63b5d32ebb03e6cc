//! The folder of a demonstration: it holds nothing else, and says with which options it was made.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use crate::AppError;
use crate::files::{failed, save};

const SCHEMA: &str = "soilctl.demo-folder/1";
const NAME: &str = "demo.json";

/// What must be the same for a folder to be gone on with.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Made {
    schema: String,
    program_version: String,
    soil: String,
    seed: u64,
    model: String,
    #[serde(default)]
    end_factor: f64,
    quick: bool,
}

impl Made {
    pub(super) fn new(soil: String, seed: u64, model: String, end_factor: f64, quick: bool) -> Self {
        let program_version = env!("CARGO_PKG_VERSION").into();
        Self { schema: SCHEMA.into(), program_version, soil, seed, model, end_factor, quick }
    }
}

/// Names of what a demonstration leaves.
#[derive(Debug, Clone)]
pub(super) struct Folder {
    pub(super) path: PathBuf,
}

impl Folder {
    /// Opens the folder, or makes it.
    pub(super) fn open(path: &Path, made: &Made) -> Result<Self, AppError> {
        std::fs::create_dir_all(path).map_err(failed(path))?;
        let folder = Self { path: path.to_owned() };
        let note = folder.file(NAME);
        match std::fs::read_to_string(&note) {
            Ok(text) => folder.check(&text, made)?,
            Err(problem) if problem.kind() == std::io::ErrorKind::NotFound => {
                if std::fs::read_dir(path).map_err(failed(path))?.next().is_some() {
                    return Err(AppError::Request(format!(
                        "{} is not empty and holds no demonstration; give another folder with --out",
                        path.display()
                    )));
                }
                save(&note, (serde_json::to_string_pretty(made)? + "\n").as_bytes())?;
            }
            Err(problem) => return Err(failed(&note)(problem)),
        }
        Ok(folder)
    }

    fn check(&self, text: &str, wanted: &Made) -> Result<(), AppError> {
        let note = self.file(NAME);
        let found: Made = serde_json::from_str(text).map_err(|problem| {
            AppError::Request(format!(
                "{}: {problem}; empty the folder, or give another with --out",
                note.display()
            ))
        })?;
        let pairs = [
            ("format", &found.schema, &wanted.schema),
            ("program version", &found.program_version, &wanted.program_version),
            ("soil", &found.soil, &wanted.soil),
            ("seed", &found.seed.to_string(), &wanted.seed.to_string()),
            ("model", &found.model, &wanted.model),
            ("end factor", &found.end_factor.to_string(), &wanted.end_factor.to_string()),
            ("choice of --quick", &found.quick.to_string(), &wanted.quick.to_string()),
        ];
        for (what, found, wanted) in pairs {
            if found != wanted {
                return Err(AppError::Request(format!(
                    "{} holds a demonstration with another {what} ({found}; this one: {wanted}); give another folder \
                     with --out, or empty it",
                    self.path.display()
                )));
            }
        }
        Ok(())
    }

    /// A file in it.
    pub(super) fn file(&self, name: &str) -> PathBuf {
        self.path.join(name)
    }
}
