//! Net coefficient of all models against one angle.

use soilctl_earth_pressure::{Case, EarthPressureError, ForceModel, Prediction, model};
use soilctl_figure::{Axis, Band, Dash, Figure, Legend, Line, RefLine};
use soilctl_soil::Angle as PlaneAngle;

use super::angles_in_words;
use crate::PageError;

/// Points on a curve.
const STEPS: usize = 120;
/// Models drawn as a curve; the bracket of numerical bounds is drawn as a band.
const MODELS: [(&str, &str, Dash); 4] = [
    ("coulomb", "Coulomb", Dash::Solid),
    ("log-spiral", "log-spiral", Dash::Dash),
    ("caquot", "Caquot & Kerisel", Dash::Dot),
    ("chen", "Chen & Liu", Dash::DashDot),
];
const BRACKET: (&str, &str) = ("table", "proven bounds");

/// The angle that runs along the x axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Angle {
    Phi,
    Delta,
    Alpha,
}

impl Angle {
    const fn name(self) -> &'static str {
        match self {
            Self::Phi => "phi",
            Self::Delta => "delta",
            Self::Alpha => "alpha",
        }
    }

    const fn label(self) -> &'static str {
        match self {
            Self::Phi => "Friction angle of the soil, phi (deg)",
            Self::Delta => "Interface friction angle, delta (deg)",
            Self::Alpha => "Tool angle, alpha (deg)",
        }
    }

    /// Ends in degrees: what the printed tables cover and as far as delta and phi allow.
    fn range(self, case: &Case) -> (f64, f64) {
        match self {
            Self::Phi => (case.interface.degrees().clamp(25.0, 45.0), 50.0),
            Self::Delta => (0.0, case.friction.degrees().clamp(5.0, 30.0)),
            Self::Alpha => (60.0, 110.0),
        }
    }

    fn of(self, case: &Case) -> f64 {
        match self {
            Self::Phi => case.friction.degrees(),
            Self::Delta => case.interface.degrees(),
            Self::Alpha => case.tool_angle.degrees(),
        }
    }

    fn set(self, case: &Case, degrees: f64) -> Case {
        let angle = PlaneAngle::from_degrees(degrees);
        match self {
            Self::Phi => Case { friction: angle, ..*case },
            Self::Delta => Case { interface: angle, ..*case },
            Self::Alpha => Case { tool_angle: angle, ..*case },
        }
    }
}

pub(super) fn figure(case: &Case, angle: Angle) -> Result<Figure, PageError> {
    let mut curves = Vec::new();
    for (color, (id, name, dash)) in MODELS.into_iter().enumerate() {
        for (i, points) in runs(model(id)?.as_ref(), case, angle).into_iter().enumerate() {
            let points: Vec<_> = points.into_iter().map(|(x, found)| (x, found.k_net().0)).collect();
            // A curve broken by a case without answer is one entry of the legend.
            let name = if i == 0 { name } else { "" };
            curves.push(Line::new(name, points).color(color).dash(dash));
        }
    }
    let bands: Vec<Band> = runs(model(BRACKET.0)?.as_ref(), case, angle)
        .into_iter()
        .filter(|points| points.len() > 1)
        .map(|points| {
            let x: Vec<f64> = points.iter().map(|(x, _)| *x).collect();
            let low: Vec<f64> = points.iter().map(|(_, found)| found.net_lower.0).collect();
            let high: Vec<f64> = points.iter().map(|(_, found)| found.net_upper.0).collect();
            Band::new(BRACKET.1, x, low, high).color(MODELS.len())
        })
        .collect();
    let title = format!("Net coefficient at {}", angles_in_words(case, angle.name()));
    let mut figure =
        Figure::new(title, x_axis(angle, case)?, y_axis(&curves, &bands)?).with_legend(Legend::Below);
    for band in bands {
        figure.push(band)?;
    }
    for curve in curves {
        figure.push(curve)?;
    }
    figure.push(RefLine::vertical("this case", angle.of(case)))?;
    Ok(figure)
}

/// A point of a curve: the angle in degrees and what the model says there.
type Answered = (f64, Prediction);

/// The stretches on which a model answers with something above zero.
fn runs(model: &dyn ForceModel, case: &Case, angle: Angle) -> Vec<Vec<Answered>> {
    let (low, high) = angle.range(case);
    let mut found: Vec<Vec<Answered>> = vec![Vec::new()];
    for step in 0..=STEPS {
        let x = low + (high - low) * step as f64 / STEPS as f64;
        let answer: Result<Prediction, EarthPressureError> = model.predict(&angle.set(case, x));
        match (answer, found.last_mut()) {
            (Ok(answer), Some(run)) if answer.net_lower.0 > 0.0 => run.push((x, answer)),
            (_, Some(run)) if !run.is_empty() => found.push(Vec::new()),
            _ => {}
        }
    }
    found.retain(|run| !run.is_empty());
    found
}

fn x_axis(angle: Angle, case: &Case) -> Result<Axis, PageError> {
    let ((low, high), at) = (angle.range(case), angle.of(case));
    Ok(Axis::linear(angle.label()).range(low.min(at), high.max(at))?)
}

/// Fits all models but Coulomb's, whose plane surface sends it to infinity at rough plates.
fn y_axis(curves: &[Line], bands: &[Band]) -> Result<Axis, PageError> {
    let axis = Axis::log("Net coefficient per slant length, k_net");
    let of_curves = curves.iter().filter(|curve| curve.color != Some(0)).flat_map(|curve| &curve.points);
    let values =
        of_curves.map(|(_, k)| *k).chain(bands.iter().flat_map(|b| b.low.iter().chain(&b.high)).copied());
    let (low, high) = values.fold((f64::INFINITY, 0.0), |(low, high), k| (k.min(low), k.max(high)));
    if low > high {
        return Ok(axis);
    }
    Ok(axis.range(0.8 * low, 1.25 * high)?)
}
