//! Friction angle against displacement: the corrected record of every run.

use soilctl_direct_shear::raw::{RawAnalysis, RunResult};
use soilctl_figure::{Axis, Dash, DataPoint, Figure, Legend, Line, Marker, Points};

use crate::error::CliError;
use crate::text::number;

/// Black, for the peaks.
const PEAK_COLOR: usize = 6;

pub(super) fn figure(analysis: &RawAnalysis) -> Result<Figure, CliError> {
    let mut figure = Figure::new(
        "Mobilised friction angle in the shear box",
        Axis::linear("Displacement (mm)"),
        Axis::linear("Friction angle (deg)"),
    )
    .with_legend(Legend::Right);
    for (place, load) in analysis.loads.iter().enumerate() {
        // Seven colours before black, which is for the peaks.
        let color = if place % 7 == PEAK_COLOR { PEAK_COLOR + 1 } else { place % 7 };
        let name = format!("{} kPa", number((load.normal_stress_pa / 10.0).round() / 100.0));
        let mut named = Some(name);
        for id in load.kept.iter().chain(&load.dropped) {
            let Some(run) = analysis.runs.iter().find(|run| run.run_id == *id) else { continue };
            let dropped = load.dropped.contains(id);
            let dash = if dropped { Dash::Dot } else { Dash::Solid };
            let name = named.take().unwrap_or_default();
            figure.push(Line::new(name, trace(run)).color(color).dash(dash).width(1.3))?;
        }
    }
    let peaks: Vec<DataPoint> =
        analysis.runs.iter().map(|run| (run.peak_displacement_m * 1e3, run.friction.degrees())).collect();
    figure.push(Points::new("peak", peaks).color(PEAK_COLOR).marker(Marker::Cross))?;
    if let Some(run) = analysis.loads.iter().flat_map(|load| &load.dropped).next() {
        push_dropped_key(&mut figure, analysis, run)?;
    }
    Ok(figure)
}

/// An entry of the legend for dropped runs: a piece of one of them that its own line covers.
fn push_dropped_key(figure: &mut Figure, analysis: &RawAnalysis, id: &str) -> Result<(), CliError> {
    if let Some(first) =
        analysis.runs.iter().find(|run| run.run_id == id).and_then(|run| trace(run).first().copied())
    {
        figure.push(Line::new("dropped run", [first, first]).color(PEAK_COLOR).dash(Dash::Dot).width(1.3))?;
    }
    Ok(())
}

fn trace(run: &RunResult) -> Vec<DataPoint> {
    run.trace.iter().map(|sample| (sample.displacement_m * 1e3, sample.friction.degrees())).collect()
}
