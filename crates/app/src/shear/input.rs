//! Where the shear points come from: a table of angles, or raw records.

use soilctl_direct_shear::ShearSeries;

use super::Request;
use super::raw::Evaluated;
use crate::AppError;

/// The tests of every soil.
pub(super) struct Input {
    /// Name of the file.
    pub(super) name: String,
    pub(super) series: Vec<ShearSeries>,
    /// The evaluated records, if the points come from such.
    pub(super) raw: Option<Evaluated>,
}

pub(super) fn read(request: &Request) -> Result<Input, AppError> {
    if let Some(path) = &request.raw.raw {
        let evaluated = request.raw.analyse(path)?;
        let series = vec![evaluated.analysis.series(request.raw.soil_name.clone())?];
        return Ok(Input { name: path.display().to_string(), series, raw: Some(evaluated) });
    }
    let Some(table) = &request.file else {
        return Err(AppError::Request("give FILE or --raw RUNS.csv".into()));
    };
    let name = table.name();
    let series = chosen(table.shear_points()?, &request.soil, &name)?;
    Ok(Input { name, series, raw: None })
}

/// The soils asked for, in the order of the file; all if none is named.
fn chosen(mut series: Vec<ShearSeries>, names: &[String], file: &str) -> Result<Vec<ShearSeries>, AppError> {
    for name in names {
        if !series.iter().any(|one| one.soil.as_ref() == Some(name)) {
            let present: Vec<&str> = series.iter().filter_map(|one| one.soil.as_deref()).collect();
            let present = match present.as_slice() {
                [] => "it has no column soil".to_owned(),
                soils => format!("its soils are {}", soils.join(", ")),
            };
            return Err(AppError::Request(format!("{file}: --soil {name} is not in it; {present}")));
        }
    }
    if !names.is_empty() {
        series.retain(|one| one.soil.as_ref().is_some_and(|soil| names.contains(soil)));
    }
    Ok(series)
}
