use std::collections::BTreeMap;

use crate::spread::{Spread, mean_of_some};
use crate::{Place, StrokeTable, StrokesError, TextColumn};

/// Number of lines listed in a message.
const LISTED: usize = 8;

/// Whether forces may be exact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Uncertainty {
    /// Every measurement needs a positive standard deviation, given or from repetition.
    Required,
    /// Exact data: a standard deviation of 0 is allowed, and a lone stroke without one has 0.
    ExactAllowed,
}

/// A failure force with its standard deviation at one geometry: one stroke that brings its own, or the mean of
/// repeated strokes.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurement {
    /// Tool angle in degrees.
    pub alpha_deg: f64,
    /// Vertical depth of the plate's lower edge in m.
    pub depth_m: f64,
    /// Width of the plate in m.
    pub width_m: f64,
    /// Mean failure force in N.
    pub force_n: f64,
    /// Standard deviation of one stroke in N (sample standard deviation, n - 1, where strokes were grouped).
    pub force_sd_n: f64,
    /// Least force in N.
    pub force_min_n: f64,
    /// Greatest force in N.
    pub force_max_n: f64,
    /// Number of strokes.
    pub count: usize,
    /// Their lines in the file.
    pub lines: Vec<usize>,
    /// Their names, where they have one.
    pub stroke_ids: Vec<String>,
    /// The geometry in words, such as `70 deg, 24 mm`.
    pub label: String,
    /// Mean of the column `density_kg_m3` over the strokes that have it.
    pub density_kg_m3: Option<f64>,
    /// Mean of the column `delta_set_deg` over the strokes that have it.
    pub delta_set_deg: Option<f64>,
}

/// The measurements of a table, in the order in which they first appear.
///
/// A row with `force_sd_n` is a measurement by itself. The others are grouped by tool angle, depth and width, each
/// rounded to 1e-9 (deg or m).
///
/// # Errors
/// [`StrokesError::LoneStroke`] if a group has one stroke, [`StrokesError::ZeroSpread`] if all its forces are equal,
/// [`StrokesError::ZeroUncertainty`] if a given standard deviation is 0; none of these where exact data is allowed.
pub fn measurements(table: &StrokeTable, uncertainty: Uncertainty) -> Result<Vec<Measurement>, StrokesError> {
    let cells = Cells::of(table);
    let mut groups: Vec<Vec<usize>> = Vec::new();
    let mut open: BTreeMap<[i64; 3], usize> = BTreeMap::new();
    for i in 0..table.len() {
        if cells.own_sd(i).is_some() {
            groups.push(vec![i]);
            continue;
        }
        let group = *open.entry(cells.key(i)).or_insert(groups.len());
        match groups.get_mut(group) {
            Some(members) => members.push(i),
            None => groups.push(vec![i]),
        }
    }
    groups.iter().map(|members| cells.measurement(members, uncertainty)).collect()
}

/// The columns that measurements are made of, in the order of the file.
struct Cells<'a> {
    table: &'a StrokeTable,
    alpha: &'a [f64],
    depth: &'a [f64],
    width: &'a [f64],
    force: &'a [f64],
    sd: Option<&'a [f64]>,
    density: Option<&'a [f64]>,
    delta: Option<&'a [f64]>,
    ids: Option<&'a TextColumn>,
}

impl<'a> Cells<'a> {
    fn of(table: &'a StrokeTable) -> Self {
        // No table is without its required columns.
        let required = |name| table.numbers(name).unwrap_or_default();
        Self {
            table,
            alpha: required("alpha_deg"),
            depth: required("depth_m"),
            width: required("width_m"),
            force: required("force_n"),
            sd: table.numbers("force_sd_n"),
            density: table.numbers("density_kg_m3"),
            delta: table.numbers("delta_set_deg"),
            ids: table.stroke_ids(),
        }
    }

    fn own_sd(&self, i: usize) -> Option<f64> {
        self.sd.map(|values| values[i]).filter(|sd| !sd.is_nan())
    }

    /// Geometry in units of 1e-9, which an i64 holds for every value that a table takes.
    fn key(&self, i: usize) -> [i64; 3] {
        [self.alpha[i], self.depth[i], self.width[i]].map(|x| (x * 1e9).round() as i64)
    }

    fn measurement(&self, members: &[usize], uncertainty: Uncertainty) -> Result<Measurement, StrokesError> {
        let first = members[0];
        let spread = Spread::of(&members.iter().map(|&i| self.force[i]).collect::<Vec<_>>());
        let mean = |column: Option<&[f64]>| mean_of_some(members.iter().map(|&i| column.map(|c| c[i])));
        let ids = members.iter().filter_map(|&i| self.ids?.cell(i)).filter(|id| !id.is_empty());
        let found = Measurement {
            alpha_deg: self.alpha[first],
            depth_m: self.depth[first],
            width_m: self.width[first],
            force_n: spread.mean,
            force_sd_n: self.own_sd(first).unwrap_or(spread.sd),
            force_min_n: spread.min,
            force_max_n: spread.max,
            count: members.len(),
            lines: members.iter().map(|&i| self.table.lines()[i]).collect(),
            stroke_ids: ids.map(str::to_owned).collect(),
            label: format!("{} deg, {} mm", short(self.alpha[first]), short(self.depth[first] * 1e3)),
            density_kg_m3: mean(self.density),
            delta_set_deg: mean(self.delta),
        };
        if found.force_sd_n > 0.0 || uncertainty == Uncertainty::ExactAllowed {
            return Ok(found);
        }
        Err(without_uncertainty(self.table.name(), self.own_sd(first), found))
    }
}

fn without_uncertainty(file: &str, own_sd: Option<f64>, found: Measurement) -> StrokesError {
    let (file, line, label) = (file.to_owned(), found.lines[0], found.label);
    if let Some(sd) = own_sd {
        let place = Place { file, line, column: "force_sd_n".into() };
        return StrokesError::ZeroUncertainty { place, text: sd.to_string() };
    }
    match found.count {
        1 => StrokesError::LoneStroke { file, line, label },
        count => StrokesError::ZeroSpread { file, lines: listed(&found.lines), count, label },
    }
}

pub(crate) fn listed(lines: &[usize]) -> String {
    let mut text = lines.iter().take(LISTED).map(usize::to_string).collect::<Vec<_>>().join(", ");
    if lines.len() > LISTED {
        text += ", ...";
    }
    text
}

/// At most two decimals, without trailing zeros.
fn short(value: f64) -> String {
    format!("{value:.2}").trim_end_matches('0').trim_end_matches('.').to_owned()
}
