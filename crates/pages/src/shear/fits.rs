//! Friction angle against normal stress: the tests of every soil and the curves through them.

use soilctl_app::shear::{Fitted, SoilAnswer};
use soilctl_direct_shear::FrictionCurve;
use soilctl_figure::{Axis, Dash, DataPoint, Figure, Line, Points, Span};

use crate::PageError;

/// Points on a stretch of a curve.
const STEPS: usize = 80;
/// Black, for the key to the line styles.
const KEY_COLOR: usize = 6;
const PASCALS: f64 = 1000.0;

/// Stretches of a stress axis in Pa.
type Stretch = (f64, f64);

pub(super) fn figure(fitted: &[Fitted], soils: &[SoilAnswer]) -> Result<Figure, PageError> {
    let (low, high) = stress_range(fitted, soils);
    let mut lines = Vec::new();
    for (color, one) in fitted.iter().enumerate() {
        if let Some(power) = &one.power {
            let (from, to) = power.stress_range_pa();
            lines.push(Line::new("", along(power, (from, to))).color(color).dash(Dash::Solid));
            for stretch in [(low, from), (to, high)] {
                lines.push(Line::new("", along(power, stretch)).color(color).dash(Dash::Dash).width(1.5));
            }
        }
        if let Some(floor) = &one.floor {
            let (from, to) = floor.stress_range_pa();
            let corner = floor.floor_stress_pa.clamp(from, to);
            let points = [along(floor, (from, corner)), along(floor, (corner, to))].concat();
            lines.push(Line::new("", points).color(color).dash(Dash::Dot).width(1.8));
            for stretch in [(low, from), (to, high)] {
                lines.push(Line::new("", along(floor, stretch)).color(color).dash(Dash::LooseDot).width(1.8));
            }
        }
    }
    lines.retain(|line| !line.points.is_empty());
    let tests: Vec<Vec<DataPoint>> = fitted.iter().map(measured).collect();

    let angles =
        lines.iter().flat_map(|line| &line.points).chain(tests.iter().flatten()).map(|(_, deg)| *deg);
    let (lowest, highest) =
        angles.fold((f64::INFINITY, 0.0), |(a, b), deg| (f64::min(a, deg), f64::max(b, deg)));
    let mut figure = Figure::new(
        "Friction angle in direct shear",
        Axis::log("Normal stress (kPa)").range(low / PASCALS, high / PASCALS)?,
        Axis::linear("Peak friction angle (deg)").range(lowest - 1.0, highest + 1.0)?,
    );
    if let Some((from, to)) = stroke_range(soils).filter(|(from, to)| from < to) {
        figure.push(Span::vertical("stresses of the stroke", from / PASCALS, to / PASCALS))?;
    }
    for line in lines {
        figure.push(line)?;
    }
    for (color, (one, points)) in fitted.iter().zip(tests).enumerate() {
        figure.push(Points::new(one.name(), points).color(color))?;
    }
    push_key(&mut figure, low / PASCALS, fitted)?;
    Ok(figure)
}

/// Entries of the legend for the line styles, which all soils share: lines left of the plot, so only their samples
/// are seen.
fn push_key(figure: &mut Figure, left: f64, fitted: &[Fitted]) -> Result<(), PageError> {
    let power = fitted.iter().any(|one| one.power.is_some());
    let floor = fitted.iter().any(|one| one.floor.is_some());
    let styles = [
        ("power law", Dash::Solid, 2.0, power),
        ("power law, extrapolated", Dash::Dash, 1.5, power),
        ("slope and floor", Dash::Dot, 1.8, floor),
        ("slope and floor, extrapolated", Dash::LooseDot, 1.8, floor),
    ];
    for (name, dash, width, _) in styles.into_iter().filter(|style| style.3) {
        let unseen = [(left / 4.0, 1.0), (left / 2.0, 1.0)];
        figure.push(Line::new(name, unseen).color(KEY_COLOR).dash(dash).width(width))?;
    }
    Ok(())
}

fn measured(fitted: &Fitted) -> Vec<DataPoint> {
    let place = |pa: f64, deg: f64| (pa / PASCALS, deg);
    fitted.points.iter().map(|point| place(point.normal_stress_pa(), point.friction().degrees())).collect()
}

/// A curve on a stretch, as far as it gives possible angles.
fn along(curve: &dyn FrictionCurve, (from, to): Stretch) -> Vec<DataPoint> {
    if from >= to {
        return Vec::new();
    }
    let at = |step: usize| from * (to / from).powf(step as f64 / STEPS as f64);
    let angle = |pa: f64| Some((pa / PASCALS, curve.friction_at(pa).ok()?.friction.degrees()));
    (0..=STEPS).filter_map(|step| angle(at(step))).collect()
}

/// All stresses that matter, with some room.
fn stress_range(fitted: &[Fitted], soils: &[SoilAnswer]) -> Stretch {
    let asked = soils.iter().flat_map(|soil| &soil.at).map(|at| at.normal_stress_pa);
    let stroke = stroke_range(soils).into_iter().flat_map(|(low, high)| [low, high]);
    let tested = fitted.iter().map(Fitted::tested_pa).flat_map(|(low, high)| [low, high]);
    let (low, high) = tested
        .chain(asked)
        .chain(stroke)
        .fold((f64::INFINITY, 0.0), |(low, high), pa| (f64::min(low, pa), f64::max(high, pa)));
    (low / 1.6, high * 1.6)
}

/// Lowest and highest stress of the stroke over all soils.
fn stroke_range(soils: &[SoilAnswer]) -> Option<Stretch> {
    let points = soils.iter().filter_map(|soil| soil.stroke.as_ref()).flat_map(|stroke| &stroke.points);
    let stresses = points.flat_map(|point| [point.low_stress_pa, point.high_stress_pa]);
    stresses.fold(None, |range, pa| match range {
        None => Some((pa, pa)),
        Some((low, high)) => Some((pa.min(low), pa.max(high))),
    })
}
