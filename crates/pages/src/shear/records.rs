//! Friction angle against displacement: the corrected record of every run.

use soilctl_app::text::number;
use soilctl_direct_shear::raw::{LoadSummary, RawAnalysis, RunResult};
use soilctl_figure::{Axis, Dash, DataPoint, Figure, Legend, Line, Points};

use crate::PageError;

/// Black, for the key to dropped runs.
const KEY_COLOR: usize = 6;

pub(super) fn figure(analysis: &RawAnalysis) -> Result<Figure, PageError> {
    let mut figure = Figure::new(
        "Friction angle in the shear box (markers: peaks)",
        Axis::linear("Displacement (mm)"),
        Axis::linear("Mobilised friction angle (deg)"),
    )
    .with_legend(Legend::Right);
    for (color, load) in analysis.loads.iter().enumerate() {
        for run in runs(analysis, load) {
            let dash = if load.dropped.contains(&run.run_id) { Dash::Dot } else { Dash::Solid };
            figure.push(Line::new("", trace(run)).color(color).dash(dash).width(1.3))?;
        }
    }
    for (color, load) in analysis.loads.iter().enumerate() {
        let peak = |run: &RunResult| (run.peak_displacement_m * 1e3, run.friction.degrees());
        let peaks: Vec<DataPoint> = runs(analysis, load).map(peak).collect();
        figure.push(Points::new(kilopascals(load.normal_stress_pa), peaks).color(color))?;
    }
    if let Some(dropped) = analysis.loads.iter().find(|load| !load.dropped.is_empty()) {
        // Without length, so only its sample in the legend is seen.
        let at: Vec<DataPoint> =
            runs(analysis, dropped).filter_map(|run| trace(run).first().copied()).collect();
        if let Some(&first) = at.first() {
            figure.push(Line::new("dropped run", [first; 2]).color(KEY_COLOR).dash(Dash::Dot).width(1.3))?;
        }
    }
    Ok(figure)
}

/// The runs of a load, dropped ones included.
fn runs<'a>(analysis: &'a RawAnalysis, load: &'a LoadSummary) -> impl Iterator<Item = &'a RunResult> {
    let belongs = |run: &&RunResult| load.kept.contains(&run.run_id) || load.dropped.contains(&run.run_id);
    analysis.runs.iter().filter(belongs)
}

fn trace(run: &RunResult) -> Vec<DataPoint> {
    run.trace.iter().map(|sample| (sample.displacement_m * 1e3, sample.friction.degrees())).collect()
}

fn kilopascals(stress_pa: f64) -> String {
    format!("{} kPa", number((stress_pa / 10.0).round() / 100.0))
}
