//! Figures of the demonstration, on the page and as files.

use std::collections::BTreeMap;
use std::path::Path;

use soilctl_app::AppError;
use soilctl_app::demo::{Answer, EachStroke, TRUE_FORCES, Work};
use soilctl_app::text::number;
use soilctl_figure::{Axis, Band, Dash, Figure, Line, Marker, Points, RefLine, Size};
use soilctl_strokes::{TraceSample, TraceTable};

use crate::process::figures as process;
use crate::{PageError, estimate, save_figure};

/// Palette index of what is true: black.
const TRUE_COLOR: usize = 6;

/// Figures in the order of the page, by the names of their files.
pub(super) struct Drawn {
    pub(super) curves: Option<Figure>,
    pub(super) forces: Option<Figure>,
    pub(super) friction: Option<Figure>,
    pub(super) region: Option<Figure>,
    pub(super) bands: Option<Figure>,
}

impl Drawn {
    fn named(&self) -> [(&'static str, &Option<Figure>); 5] {
        [
            ("curves", &self.curves),
            ("forces", &self.forces),
            ("friction", &self.friction),
            ("region", &self.region),
            ("bands", &self.bands),
        ]
    }
}

pub(super) fn all(answer: &Answer, work: &Work) -> Result<Drawn, PageError> {
    let mut friction = process::friction(&work.processed.analysis)?;
    if let Some(figure) = &mut friction {
        figure.push(RefLine::vertical("truth", answer.truth.delta_deg).color(TRUE_COLOR))?;
    }
    Ok(Drawn {
        curves: curves(answer)?,
        forces: forces(answer)?,
        friction,
        region: region(answer, work)?,
        bands: bands(answer, work)?,
    })
}

/// Writes all figures as SVG, PNG and CSV; their paths.
pub(super) fn save_all(drawn: &Drawn, folder: &Path) -> Result<Vec<String>, PageError> {
    let figures = folder.join("figures");
    std::fs::create_dir_all(&figures)
        .map_err(|problem| AppError::File { path: figures.display().to_string(), problem })?;
    let mut written = Vec::new();
    for (name, figure) in drawn.named() {
        if let Some(figure) = figure {
            for form in ["svg", "png", "csv"] {
                let path = figures.join(format!("{name}.{form}"));
                save_figure(figure, &path, Size::default())?;
                written.push(path.display().to_string());
            }
        }
    }
    Ok(written)
}

/// For each tool angle the stroke whose set-point is nearest to the published friction, force over way.
fn curves(answer: &Answer) -> Result<Option<Figure>, PageError> {
    let mut shown: BTreeMap<u64, &EachStroke> = BTreeMap::new();
    let off = |stroke: &EachStroke| (stroke.delta_set_deg - answer.delta_guess_deg).abs();
    for stroke in answer.each.iter().filter(|stroke| stroke.trace_id.is_some()) {
        // Bits of positive numbers are in the numbers' order.
        let best = shown.entry(stroke.alpha_deg.to_bits()).or_insert(stroke);
        // One with a failure force before one without.
        let rank = |stroke: &EachStroke| (stroke.force_n.is_none(), off(stroke), -stroke.depth_m);
        if rank(stroke) < rank(best) {
            *best = stroke;
        }
    }
    if shown.is_empty() {
        return Ok(None);
    }
    let traces =
        TraceTable::read(&Path::new(&answer.files.folder).join("traces.csv")).map_err(AppError::from)?;
    let mut figure = Figure::new(
        "One stroke at each tool angle",
        Axis::linear("Way of the plate (mm)"),
        Axis::linear("Force (N)"),
    );
    let (mut found, mut bars, mut truths) = (Vec::new(), Vec::new(), Vec::new());
    for (color, stroke) in shown.values().enumerate() {
        let Some(trace) = stroke.trace_id.as_ref().and_then(|id| traces.get(id)) else { continue };
        let trace = from_the_least(trace, stroke.found_at_s.or(stroke.true_at_s));
        let Some(first) = trace.first().filter(|_| trace.len() > 1) else { continue };
        let mm = |sample: &TraceSample| (way_m(sample) - way_m(first)) * 1e3;
        let points: Vec<(f64, f64)> = trace.iter().map(|sample| (mm(sample), sample.force_n)).collect();
        let name = format!("{}°, {:.0} mm deep", number(stroke.alpha_deg), stroke.depth_m * 1e3);
        figure.push(Line::new(name, points).width(1.5).color(color))?;
        let way_mm = |time_s: Option<f64>| {
            let at = trace.partition_point(|sample| Some(sample.t_s) < time_s);
            trace.get(at.min(trace.len() - 1)).filter(|_| time_s.is_some()).map(mm)
        };
        if let (Some(x), Some(y)) = (way_mm(stroke.found_at_s), stroke.force_n) {
            found.push((x, y));
            let sd = stroke.force_sd_n.unwrap_or(0.0);
            bars.push((sd, sd));
        }
        if let (Some(x), Some(y)) = (way_mm(stroke.true_at_s), stroke.true_force_n) {
            truths.push((x, y));
        }
    }
    if !found.is_empty() {
        figure
            .push(Points::new("failure found ± sd", found).y_error(bars).marker(Marker::Circle).color(5))?;
    }
    if !truths.is_empty() {
        figure.push(Points::new("failure in truth", truths).marker(Marker::Diamond).color(TRUE_COLOR))?;
    }
    Ok((!figure.layers().is_empty()).then_some(figure))
}

/// Way of the plate by the motors' encoders, which logs of the simulated arm have.
fn way_m(sample: &TraceSample) -> f64 {
    sample.x_mtr_m.unwrap_or(sample.x_ext_m)
}

/// The trace from its least force before the failure on: until then fades what the insertion has left along the plate.
fn from_the_least(trace: &[TraceSample], failure_s: Option<f64>) -> &[TraceSample] {
    let failure_s = failure_s.unwrap_or(f64::INFINITY);
    let before = trace.partition_point(|sample| sample.t_s < failure_s);
    let least = (0..before).min_by(|a, b| trace[*a].force_n.total_cmp(&trace[*b].force_n));
    &trace[least.unwrap_or(0)..]
}

/// Forces that were found over those of the soil.
fn forces(answer: &Answer) -> Result<Option<Figure>, PageError> {
    let mut groups: BTreeMap<u64, Vec<&EachStroke>> = BTreeMap::new();
    for stroke in answer.each.iter().filter(|stroke| stroke.error.is_some()) {
        groups.entry(stroke.alpha_deg.to_bits()).or_default().push(stroke);
    }
    let ends =
        answer.each.iter().filter(|s| s.error.is_some()).flat_map(|s| [s.limit_force_n, s.force_n]).flatten();
    let (low, high) =
        ends.fold((f64::INFINITY, 0.0_f64), |(low, high), force| (low.min(force), high.max(force)));
    if groups.is_empty() || low >= high {
        return Ok(None);
    }
    let (low, high) = (0.9 * low, 1.1 * high);
    let mut figure = Figure::new(
        "Failure forces against the truth",
        Axis::linear("Most that the soil bore then and there (N)"),
        Axis::linear("Force that was found (N)"),
    );
    let ends = vec![low, high];
    figure.push(
        Band::new("within 10 %", ends, vec![0.9 * low, 0.9 * high], vec![1.1 * low, 1.1 * high])
            .color(TRUE_COLOR),
    )?;
    figure
        .push(Line::new("equal", [(low, low), (high, high)]).width(1.0).dash(Dash::Dash).color(TRUE_COLOR))?;
    for (color, strokes) in groups.values().enumerate() {
        let points: Vec<(f64, f64)> =
            strokes.iter().filter_map(|s| Some((s.limit_force_n?, s.force_n?))).collect();
        let bars: Vec<(f64, f64)> =
            strokes.iter().map(|s| s.force_sd_n.unwrap_or(0.0)).map(|sd| (sd, sd)).collect();
        let labels = strokes.iter().map(|s| format!("stroke {}", s.number));
        let name = format!("{}°", number(strokes[0].alpha_deg));
        figure.push(Points::new(name, points).y_error(bars).labels(labels).color(color))?;
    }
    Ok(Some(figure))
}

fn truth_point(answer: &Answer) -> Points {
    let label =
        format!("φ {}°, ρ {} kg/m³", number(answer.truth.phi_deg), number(answer.truth.density_kg_m3));
    Points::new("truth", vec![(answer.truth.phi_deg, answer.truth.density_kg_m3)])
        .marker(Marker::Diamond)
        .labels([label])
        .color(TRUE_COLOR)
}

/// Every consistent friction angle and density, with the truth.
fn region(answer: &Answer, work: &Work) -> Result<Option<Figure>, PageError> {
    let mut figure = Figure::new(
        "Soils that explain every force",
        Axis::linear("Friction angle φ (deg)"),
        Axis::linear("Density ρ (kg/m³)"),
    );
    for (color, estimated) in work.estimates.iter().enumerate() {
        if let Ok(work) = &estimated.work {
            estimate::push_region(&mut figure, estimated.name, &work.estimate.region, color)?;
        }
    }
    if figure.layers().is_empty() {
        return Ok(None);
    }
    figure.push(truth_point(answer))?;
    Ok(Some(figure))
}

/// The band of each measurement, with the truth.
fn bands(answer: &Answer, work: &Work) -> Result<Option<Figure>, PageError> {
    let measured = work.estimates.iter().rev().filter(|estimated| estimated.name != TRUE_FORCES);
    let Some(work) = measured.filter_map(|e| e.work.as_ref().ok()).next() else {
        return Ok(None);
    };
    let mut figure = estimate::figure(work, Some(estimate::Kind::Bands))?;
    figure.push(truth_point(answer))?;
    Ok(Some(figure))
}
