//! Files of a diagnosis: model file, predictions, gap, next experiment.

use std::path::{Path, PathBuf};

use soilctl_diagnosis::{Data, Diagnosis};
use soilctl_effects::{Loaded, ModelFile};
use soilctl_jobs::fnv1a;

use super::Against;
use crate::AppError;
use crate::files::{failed, save};

/// Where things were written.
pub(super) struct Written {
    pub(super) patch: PathBuf,
    pub(super) twin: Option<PathBuf>,
    pub(super) next: Option<PathBuf>,
}

/// Writes all files but the page into a folder.
pub(super) fn write(
    against: &Against,
    data: &Data,
    diagnosis: &Diagnosis,
    twin: Option<&ModelFile>,
    strokes: &Path,
    out: &Path,
) -> Result<Written, AppError> {
    std::fs::create_dir_all(out).map_err(failed(out))?;
    let comparison = &diagnosis.comparison;
    let hash = fnv1a(&std::fs::read(strokes).map_err(failed(strokes))?);
    let file = diagnosis.model_file(data, &against.model, against.known(), hash.clone());
    let twin = match twin {
        Some(twin) => {
            let path = out.join("twin.json");
            ModelFile { data_hash: hash, ..twin.clone() }.write(&path)?;
            Some(path)
        }
        None => None,
    };
    let patch = out.join("patch.json");
    file.write(&patch)?;
    let name = patch.display().to_string();
    let known = [against.known().len(), data.known_terms().len()];
    let before = Loaded::new(comparison.without_effects(&file, known), &name)?;
    let after = Loaded::new(file, &name)?;
    save(&out.join("predictions.csv"), &comparison.predictions_csv(data, &before, &after)?)?;
    save(&out.join("gap.csv"), &comparison.gap_csv()?)?;
    let next = match &diagnosis.next {
        Some(next) => {
            let path = out.join("next_experiment.csv");
            save(&path, &next.design_csv()?)?;
            Some(path)
        }
        None => None,
    };
    Ok(Written { patch, twin, next })
}
