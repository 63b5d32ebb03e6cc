//! Figures of flow and stress field.

use soilctl_app::limits::Fields;
use soilctl_app::text::number;
use soilctl_figure::{Figure, Paths, Shade, Shades};
use soilctl_limit_analysis::results::{MOVING, Point, Principal, shear_work};

use super::frame::{INK, Window, add_outline, drawn};
use super::trails::{bits, trails};
use crate::PageError;

/// Arrows and crosses in a figure, where there is soil everywhere and all of it moves.
const ARROWS: usize = 780;
const CROSSES: usize = 520;
/// Length of the arrow of the structure's speed, and of the arms of all but the greatest crosses, over the distance between
/// them.
const ARROW: f64 = 0.85;
const ARM: f64 = 0.5;
/// The part of all crosses whose arms may be longer.
const LONGER: f64 = 0.1;

/// How much longer the arrow of the structure is.
const STRUCTURE: f64 = 3.0;

/// Jumps below this fraction of the structure's speed are not drawn.
const SLIP: f64 = 0.05;

/// The part of all shearing soil, by area, that has the last colour of the scale.
const SATURATED: f64 = 0.02;

/// Mesh, velocities and failure surface.
pub(super) fn velocity(fields: &Fields, window: &Window) -> Result<Option<Figure>, PageError> {
    let Some(flow) = &fields.flow else { return Ok(None) };
    let mut figure = window.figure(fields, "Upper bound, mesh and velocities")?;
    let edges = trails(flow.triangles().iter().filter(|t| window.shows(t)), bits);
    figure.push(Paths::new("", drawn(fields, edges)).width(0.3))?;
    let (points, step) = window.grid(ARROWS);
    let scale = ARROW * step / flow.speed();
    let arrow = |p: Point| {
        let [x, y] = flow.velocity(p)?;
        let moves = x.hypot(y) >= MOVING * flow.speed();
        moves.then(|| vec![p, [p[0] + scale * x, p[1] + scale * y]])
    };
    let arrows: Vec<_> = points.into_iter().filter_map(arrow).collect();
    if !arrows.is_empty() {
        figure.push(Paths::new("velocity", drawn(fields, arrows)).width(1.0).color(0).arrows())?;
    }
    let surface = flow.failure_surface(MOVING);
    if !surface.is_empty() {
        figure.push(Paths::new("boundary of moving soil", drawn(fields, surface)).width(2.0).color(1))?;
    }
    add_outline(&mut figure, fields, window)?;
    let faces = flow.jumps().into_iter().filter(|j| j.at_structure).map(|j| j.ends[0]);
    // In the middle of the structure, and longer than others to be seen.
    let (sum, count) = faces.fold(([0.0; 2], 0.0), |(sum, n), p| ([sum[0] + p[0], sum[1] + p[1]], n + 1.0));
    let [x, y] = flow.statement().objective.velocity();
    if count > 0.0 && (x, y) != (0.0, 0.0) {
        let p = [sum[0] / count, sum[1] / count];
        let arrow = vec![p, [p[0] + STRUCTURE * scale * x, p[1] + STRUCTURE * scale * y]];
        let name = format!("velocity of the structure, drawn {STRUCTURE} times as long");
        figure.push(Paths::new(name, drawn(fields, vec![arrow])).width(2.5).color(INK).arrows())?;
    }
    Ok(Some(figure))
}

/// Where the soil shears, as a map, and lines along which it slips.
pub(super) fn dissipation(fields: &Fields, window: &Window) -> Result<Option<Figure>, PageError> {
    let Some(flow) = &fields.flow else { return Ok(None) };
    let (values, name, unit) = match &fields.stress {
        Some(stress) => {
            let name = format!(
                "shear strength × shear rate ({} v/{})",
                fields.units.stress_name, fields.units.length_name
            );
            (shear_work(flow, stress), name, fields.units.stress / fields.units.length)
        }
        None => (
            flow.shear_rate(),
            format!("shear rate (v/{})", fields.units.length_name),
            1.0 / fields.units.length,
        ),
    };
    let mut parts = Vec::new();
    let mut areas = Vec::new();
    for (pieces, values) in flow.pieces().iter().zip(values) {
        for (piece, value) in pieces.iter().zip(values) {
            if window.shows(&piece.corners) {
                let ring = piece.corners.map(|p| fields.units.point(p).into()).to_vec();
                parts.push(Shade { ring, value: unit * value });
                areas.push((unit * value, area(&piece.corners)));
            }
        }
    }
    let mut figure = window.figure(fields, "Plastic dissipation")?;
    let high = saturation(areas);
    if high > 0.0 {
        figure.push(Shades::new(name, parts, 0.0, high))?;
    }
    let slips = flow.jumps().into_iter().filter(|j| !j.at_structure && j.speed() > SLIP * flow.speed());
    let slips: Vec<Vec<Point>> = slips.map(|j| j.ends.to_vec()).collect();
    if !slips.is_empty() {
        figure.push(Paths::new("slip", drawn(fields, slips)).width(1.2).color(0))?;
    }
    add_outline(&mut figure, fields, window)?;
    Ok(Some(figure))
}

fn area(t: &[Point; 3]) -> f64 {
    0.5 * ((t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[1][1] - t[0][1]) * (t[2][0] - t[0][0]))
}

/// A round number near the value that is exceeded on a small part of the area on which there is something.
fn saturation(mut areas: Vec<(f64, f64)>) -> f64 {
    areas.sort_by(|a, b| b.0.total_cmp(&a.0));
    let most = areas.first().map_or(0.0, |a| a.0);
    let active = |a: &&(f64, f64)| a.0 > 1e-3 * most;
    let mut left: f64 = SATURATED * areas.iter().filter(active).map(|a| a.1).sum::<f64>();
    let value = areas.iter().find(|(_, area)| {
        left -= area;
        left <= 0.0
    });
    let value = value.map_or(0.0, |v| v.0);
    if value <= 0.0 {
        return 0.0;
    }
    let unit = 10.0_f64.powf(value.log10().floor());
    unit * [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0].into_iter().find(|n| n * unit >= value).unwrap_or(10.0)
}

/// Crosses along the principal stresses.
pub(super) fn stress(fields: &Fields, window: &Window) -> Result<Option<Figure>, PageError> {
    let Some(stress) = &fields.stress else { return Ok(None) };
    let mut figure = window.figure(fields, "Lower bound, principal stresses")?;
    let (points, step) = window.grid(CROSSES);
    let found: Vec<(Point, Principal)> =
        points.into_iter().filter_map(|p| Some((p, Principal::of(stress.stress(p)?)))).collect();
    let mut greatest: Vec<f64> = found.iter().map(|(_, s)| s.major.abs().max(s.minor.abs())).collect();
    greatest.sort_by(f64::total_cmp);
    let longest = greatest.last().copied().unwrap_or(0.0);
    if longest > 0.0 {
        let most = greatest[((1.0 - LONGER) * greatest.len() as f64) as usize];
        let scale = ARM * step / most.max(0.5 * longest);
        let arms = |along: fn(&Principal) -> (f64, Point), wanted: fn(f64) -> bool| {
            let arm = |(p, s): &(Point, Principal)| {
                let (value, [x, y]) = along(s);
                let (x, y) = (scale * value * x, scale * value * y);
                (wanted(value) && value.abs() > 1e-3 * longest)
                    .then(|| vec![[p[0] - x, p[1] - y], [p[0] + x, p[1] + y]])
            };
            found.iter().filter_map(arm).collect::<Vec<_>>()
        };
        let major = |s: &Principal| (s.major, s.direction);
        let minor = |s: &Principal| (s.minor, [-s.direction[1], s.direction[0]]);
        let longest = number(rounded(fields.units.stress * longest));
        let unit = &fields.units.stress_name;
        let mut tension = arms(major, |v| v < 0.0);
        tension.extend(arms(minor, |v| v < 0.0));
        for (name, lines, width, color) in [
            (format!("greater compression, up to {longest} {unit}"), arms(major, |v| v > 0.0), 1.6, 0),
            ("lesser compression (thin)".to_owned(), arms(minor, |v| v > 0.0), 1.0, 1),
            ("tension (thick)".to_owned(), tension, 3.0, 2),
        ] {
            if !lines.is_empty() {
                figure.push(Paths::new(name, drawn(fields, lines)).width(width).color(color))?;
            }
        }
    }
    if let Some(flow) = &fields.flow {
        let surface = flow.failure_surface(MOVING);
        if !surface.is_empty() {
            let name = "boundary of moving soil (upper bound)";
            figure.push(Paths::new(name, drawn(fields, surface)).width(0.8).color(INK))?;
        }
    }
    add_outline(&mut figure, fields, window)?;
    Ok(Some(figure))
}

/// Three digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.2e}").parse().unwrap_or(value)
}
