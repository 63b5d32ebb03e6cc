//! Where the shear points come from: a table of angles, or raw records.

use soilctl_direct_shear::{ShearSeries, read_shear_points};

use super::Args;
use super::raw::Evaluated;
use crate::error::CliError;

/// The tests of every soil.
pub(super) struct Input {
    /// Name of the file.
    pub(super) name: String,
    pub(super) series: Vec<ShearSeries>,
    /// The evaluated records, if the points come from such.
    pub(super) raw: Option<Evaluated>,
}

pub(super) fn read(args: &Args) -> Result<Input, CliError> {
    if let Some(path) = &args.raw.raw {
        let evaluated = args.raw.analyse(path)?;
        let series = vec![evaluated.analysis.series(args.raw.soil_name.clone())?];
        return Ok(Input { name: path.display().to_string(), series, raw: Some(evaluated) });
    }
    let Some(path) = &args.file else {
        return Err(CliError::Usage("give FILE or --raw RUNS.csv".into()));
    };
    let name = path.display().to_string();
    let series = chosen(read_shear_points(path)?, &args.soil, &name)?;
    Ok(Input { name, series, raw: None })
}

/// The soils asked for, in the order of the file; all if none is named.
fn chosen(mut series: Vec<ShearSeries>, names: &[String], file: &str) -> Result<Vec<ShearSeries>, CliError> {
    for name in names {
        if !series.iter().any(|one| one.soil.as_ref() == Some(name)) {
            let present: Vec<&str> = series.iter().filter_map(|one| one.soil.as_deref()).collect();
            let present = match present.as_slice() {
                [] => "it has no column soil".to_owned(),
                soils => format!("its soils are {}", soils.join(", ")),
            };
            return Err(CliError::Usage(format!("{file}: --soil {name} is not in it; {present}")));
        }
    }
    if !names.is_empty() {
        series.retain(|one| one.soil.as_ref().is_some_and(|soil| names.contains(soil)));
    }
    Ok(series)
}
