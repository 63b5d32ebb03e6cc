//! Figures of an estimate, for `--plot` and the report.

use clap::ValueEnum;
use soilctl_app::estimate::Estimation;
use soilctl_app::text::number;
use soilctl_estimator::{EstimatorError, Region, Setup, bands as estimator_bands};
use soilctl_figure::{Axis, Band, Dash, Figure, Line, Marker, Points, Polygon, Polygons, Span};
use soilctl_soil::{Angle, WidthRatio};

use crate::PageError;

/// What to draw.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Consistent friction angle and density, with the sections
    Region,
    /// The band of each measurement at the middle delta
    Bands,
    /// Consistent friction angle and interface friction
    PhiDelta,
    /// Consistent interface friction and density
    DeltaDensity,
    /// Measured coefficients over the tool angle, with the model
    Fit,
    /// Contours and their crossings for exact data
    Contours,
}

/// A figure of an estimate; the region, or contours for exact data, if no kind is given.
///
/// # Errors
/// [`PageError`] if there is nothing of that kind to draw.
pub fn figure(work: &Estimation, kind: Option<Kind>) -> Result<Figure, PageError> {
    let usual = if work.request.exact { Kind::Contours } else { Kind::Region };
    match kind.unwrap_or(usual) {
        Kind::Region => region(work),
        Kind::Bands => bands(work),
        Kind::PhiDelta => phi_delta(work),
        Kind::DeltaDensity => delta_density(work),
        Kind::Fit => fit(work),
        Kind::Contours => contours(work),
    }
}

const PHI: &str = "Friction angle φ (deg)";
const DENSITY: &str = "Density ρ (kg/m³)";
const DELTA: &str = "Interface friction δ (deg)";

fn polygons(region: &Region) -> Vec<Polygon> {
    let ring = |ring: &[[f64; 2]]| ring.iter().map(|p| (p[0], p[1])).collect::<Vec<_>>();
    region
        .polygons()
        .iter()
        .filter_map(|rings| {
            let (outer, holes) = rings.split_first()?;
            Some(holes.iter().fold(Polygon::new(ring(outer)), |polygon, hole| polygon.hole(ring(hole))))
        })
        .collect()
}

/// Adds a region to a figure of friction angle and density.
///
/// # Errors
/// [`PageError`] if a polygon of it is none.
pub fn push_region(figure: &mut Figure, name: &str, region: &Region, color: usize) -> Result<(), PageError> {
    if !region.is_empty() {
        figure.push(Polygons::new(name, polygons(region)).color(color))?;
    }
    Ok(())
}

fn push_density(figure: &mut Figure, work: &Estimation) -> Result<(), PageError> {
    if let Some((low, high)) = work.inputs.density_kg_m3 {
        figure.push(Span::horizontal("density known", low, high))?;
    }
    Ok(())
}

/// A figure of an empty set still needs something to stand on: the search range.
fn push_nothing(figure: &mut Figure, text: &str) -> Result<(), PageError> {
    if figure.layers().is_empty() {
        figure.push(soilctl_figure::Text::new(text, (0.0, 0.0)))?;
    }
    Ok(())
}

/// Consistent (phi, density): union over delta, sections, best soil and centre.
pub(crate) fn region(work: &Estimation) -> Result<Figure, PageError> {
    let mut figure =
        Figure::new("Soils that explain every measurement", Axis::linear(PHI), Axis::linear(DENSITY));
    push_density(&mut figure, work)?;
    push_region(&mut figure, "all δ", &work.estimate.region, 0)?;
    if work.sections.len() > 1 {
        for (i, (delta, region)) in work.sections.iter().enumerate() {
            push_region(&mut figure, &format!("δ = {}°", number(*delta)), region, i + 1)?;
        }
    }
    // On top, and in the colour of the frame: the sections below are many.
    if let Some(plane) = &work.answer.plane_strain {
        for outline in plane.region.iter().filter_map(|rings| rings.first()) {
            let closed = outline.iter().chain(outline.first()).map(|p| (p[0], p[1]));
            figure.push(Line::new("without ends", closed.collect::<Vec<_>>()).dash(Dash::Dash).color(6))?;
        }
    }
    if let Some(best) = &work.answer.best_estimate {
        let label =
            format!("φ {:.2}°, ρ {:.0} kg/m³, δ {:.2}°", best.phi_deg, best.density_kg_m3, best.delta_deg);
        let at = vec![(best.phi_deg, best.density_kg_m3)];
        figure.push(Points::new("least misfit", at).marker(Marker::Diamond).labels([label]).color(5))?;
    }
    if let Some(centre) = &work.answer.centre {
        let at = vec![(centre.phi_deg, centre.density_kg_m3)];
        figure.push(Points::new("centre", at).marker(Marker::Cross).color(6))?;
    }
    push_nothing(&mut figure, "no soil explains every measurement")?;
    Ok(figure)
}

/// Refuses a figure that shows the soil's weight alone where loads or slope are unknowns.
fn knows_loads(work: &Estimation, task: &'static str) -> Result<(), PageError> {
    match work.answer.unknowns {
        Some(_) => Err(EstimatorError::KnownLoadsOnly { task }.into()),
        None => Ok(()),
    }
}

/// Band of each measurement at the middle delta, and what they share.
pub(crate) fn bands(work: &Estimation) -> Result<Figure, PageError> {
    knows_loads(work, "the figure of bands")?;
    let (low, high) = work.inputs.delta_deg;
    let delta = f64::midpoint(low, high);
    let setup = work.setup()?;
    let shared = soilctl_estimator::section(&setup, delta)?;
    let regions = estimator_bands(&setup, delta)?;
    let (mut x, mut y) = (Axis::linear(PHI), Axis::linear(DENSITY));
    if work.answer.consistent || work.inputs.density_kg_m3.is_some() {
        let [phi, density] = extent(work, &setup, &regions);
        x = x.range(phi[0], phi[1])?;
        y = y.range(density[0], density[1])?;
    }
    let title = format!("Band of each measurement at δ = {}°", number(delta));
    let mut figure = Figure::new(title, x, y);
    push_density(&mut figure, work)?;
    for (i, (region, observation)) in regions.iter().zip(&setup.observations).enumerate() {
        push_region(&mut figure, observation.label(), region, i)?;
    }
    push_region(&mut figure, "all together", &shared, regions.len())?;
    push_nothing(&mut figure, "no band in range")?;
    Ok(figure)
}

/// Densities of sands, which are worth to be seen where nothing is known.
const SANDS_KG_M3: (f64, f64) = (1000.0, 2000.0);

/// Friction angles (deg) and densities (kg/m3) around the answer, or around what is known of the density if there is none.
#[must_use]
pub fn extent(work: &Estimation, setup: &Setup<'_>, bands: &[Region]) -> [[f64; 2]; 2] {
    let (phi, density) = match (work.answer.phi_deg, work.answer.density_kg_m3) {
        (Some(phi), Some(density)) => (phi, density),
        _ => {
            let (low, high) = work.inputs.density_kg_m3.unwrap_or(SANDS_KG_M3);
            (phi_window(bands, low, high), [low, high])
        }
    };
    let (wide, tall) = ((phi[1] - phi[0]).max(1.5), (density[1] - density[0]).max(0.15 * density[1]));
    let range = setup.phi_range_deg();
    [
        [(phi[0] - 0.8 * wide).max(range.0), (phi[1] + 0.8 * wide).min(range.1)],
        [(density[0] - 0.8 * tall).max(0.0), density[1] + 0.8 * tall],
    ]
}

/// Friction angles at which bands cross a range of densities.
fn phi_window(regions: &[Region], low: f64, high: f64) -> [f64; 2] {
    let points = regions.iter().flat_map(Region::polygons).flatten().flatten();
    let inside = points.filter(|p| p[1] >= 0.9 * low && p[1] <= 1.1 * high).map(|p| p[0]);
    let [a, b] = inside.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(x), b.max(x)]);
    if a < b { [a, b] } else { [25.0, 50.0] }
}

/// Projection on friction angle and interface friction.
pub(crate) fn phi_delta(work: &Estimation) -> Result<Figure, PageError> {
    let mut figure =
        Figure::new("Friction angle and interface friction", Axis::linear(PHI), Axis::linear(DELTA));
    push_region(&mut figure, "consistent", &work.projections.phi_delta, 0)?;
    push_nothing(&mut figure, "nothing to show: no soil is consistent, or δ is known exactly")?;
    Ok(figure)
}

/// Projection on interface friction and density.
pub(crate) fn delta_density(work: &Estimation) -> Result<Figure, PageError> {
    let mut figure =
        Figure::new("Interface friction and density", Axis::linear(DELTA), Axis::linear(DENSITY));
    push_density(&mut figure, work)?;
    push_region(&mut figure, "consistent", &work.projections.delta_density, 0)?;
    push_nothing(&mut figure, "nothing to show: no soil is consistent, or δ is known exactly")?;
    Ok(figure)
}

/// Measured coefficients over the tool angle with the model at the ends and the best of phi.
pub(crate) fn fit(work: &Estimation) -> Result<Figure, PageError> {
    knows_loads(work, "the figure of measured coefficients")?;
    let setup = work.setup()?;
    let density = match (&work.answer.best_estimate, work.inputs.density_kg_m3) {
        (Some(best), _) => best.density_kg_m3,
        (None, Some((low, high))) => f64::midpoint(low, high),
        (None, None) => 1500.0,
    };
    let delta = work
        .answer
        .best_estimate
        .map_or(f64::midpoint(setup.delta_deg.0, setup.delta_deg.1), |best| best.delta_deg);
    let phis: Vec<f64> = match (work.answer.phi_deg, &work.answer.best_estimate) {
        (Some([low, high]), Some(best)) => vec![low, best.phi_deg, high],
        _ => vec![35.0, 40.0, 45.0],
    };
    let title = format!("Measured and predicted at ρ = {density:.0} kg/m³, δ = {delta:.1}°");
    let mut figure =
        Figure::new(title, Axis::linear("Tool angle α (deg)"), Axis::linear("Net coefficient K = 2F/(γL²w)"));
    let angles = setup.observations.iter().map(|o| o.plate().tool_angle().degrees());
    let (low, high) = angles.fold((f64::MAX, f64::MIN), |(l, h), a| (l.min(a), h.max(a)));
    // Plates of several widths are not on one curve; the first one's is drawn.
    let first = setup.observations.first();
    let width_ratio = first.map_or(WidthRatio::PLANE_STRAIN, |o| setup.width_ratio(o.plate()));
    let range = work.model.valid_range().alpha_deg;
    let (low, high) = ((low - 3.0).max(range.0), (high + 3.0).min(range.1));
    for (i, phi) in phis.iter().enumerate() {
        let curve: Vec<(f64, f64, f64)> = (0..=60)
            .filter_map(|k| {
                let alpha = low + (high - low) * f64::from(k) / 60.0;
                let slice = work
                    .model
                    .at(
                        Angle::from_degrees(alpha),
                        Angle::from_degrees(work.request.loads.beta_deg),
                        width_ratio,
                    )
                    .ok()?;
                let net = slice.net(*phi, delta.min(*phi)).ok()?;
                Some((alpha, net.weight_lower, net.weight_upper))
            })
            .collect();
        if curve.len() < 2 {
            continue;
        }
        let name = format!("φ = {phi:.1}°");
        if curve.iter().any(|(_, l, u)| l != u) {
            let column = |f: fn(&(f64, f64, f64)) -> f64| curve.iter().map(f).collect::<Vec<_>>();
            figure.push(Band::new(name, column(|c| c.0), column(|c| c.1), column(|c| c.2)).color(i))?;
        } else {
            let dash = [Dash::Dash, Dash::Solid, Dash::Dot][i % 3];
            figure.push(
                Line::new(name, curve.iter().map(|c| (c.0, c.1)).collect::<Vec<_>>()).dash(dash).color(i),
            )?;
        }
    }
    let scale = |plate: &soilctl_soil::Plate| {
        0.5 * density * setup.gravity_m_s2 * plate.slant_length_m().powi(2) * plate.width_m()
    };
    let (mut points, mut errors, mut labels) = (Vec::new(), Vec::new(), Vec::new());
    for o in &setup.observations {
        let s = scale(o.plate());
        points.push((o.plate().tool_angle().degrees(), o.force_n() / s));
        errors.push(((o.force_n() - o.low_n()) / s, (o.high_n() - o.force_n()) / s));
        labels.push(format!("{}: {:.3} N ({:.3} to {:.3})", o.label(), o.force_n(), o.low_n(), o.high_n()));
    }
    figure.push(
        Points::new("measured", points).y_error(errors).labels(labels).marker(Marker::Circle).color(5),
    )?;
    Ok(figure)
}

/// Contours of exact data at the best delta, their crossings and the smallest ellipse around them.
pub(crate) fn contours(work: &Estimation) -> Result<Figure, PageError> {
    let Some(best) = work.answer.exact.as_ref().and_then(|exact| exact.best.as_ref()) else {
        return Err(PageError::Nothing(
            "contours are drawn with --exact, where at least two of them cross".into(),
        ));
    };
    let crossings: Vec<(f64, f64)> = best.crossings();
    let ends = |d: fn(&(f64, f64)) -> f64| {
        crossings.iter().map(d).fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(x), h.max(x)))
    };
    let ((p0, p1), (d0, d1)) = (ends(|c| c.0), ends(|c| c.1));
    let (dp, dd) = ((p1 - p0).max(1.0), (d1 - d0).max(100.0));
    let title = format!("Contours at δ = {:.2}°, where they come closest", best.delta_deg);
    let mut figure = Figure::new(
        title,
        Axis::linear(PHI).range((p0 - dp).max(0.0), p1 + dp)?,
        Axis::linear(DENSITY).range((d0 - dd).max(0.0), d1 + dd)?,
    );
    for (contour, m) in best.contours.iter().zip(&work.answer.measurements) {
        if contour.len() > 1 {
            figure.push(Line::new(&m.label, contour.iter().map(|p| (p[0], p[1])).collect::<Vec<_>>()))?;
        }
    }
    if let Some(outline) = best.outline() {
        figure.push(Polygons::new("smallest ellipse", vec![Polygon::new(outline)]))?;
    }
    figure.push(Points::new("crossings", crossings))?;
    Ok(figure)
}
