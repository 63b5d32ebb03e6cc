//! What holds along the outline, in the symbols of structural drawings: hatching where the ground is fixed, rollers where it slides,
//! dashes where it goes on.

use soilctl_app::solve::BoundaryKind;
use soilctl_figure::{Dash, Figure, Line, Paths};
use soilctl_limit_analysis::results::Point;

use super::INK;
use super::place::{Scale, add as plus, along, between, ring, stations};
use crate::PageError;

type Parts = Vec<Vec<(f64, f64)>>;

/// Corners of the polygon that stands for the circle of a roller.
const CORNERS: usize = 12;

pub(super) fn add(
    figure: &mut Figure,
    sides: &[([Point; 2], BoundaryKind)],
    scale: &Scale,
) -> Result<(), PageError> {
    for kind in BoundaryKind::ALL {
        let held: Vec<[Point; 2]> = sides.iter().filter(|side| side.1 == kind).map(|side| side.0).collect();
        if held.is_empty() {
            continue;
        }
        let name = words(kind, &held);
        let (width, color, symbols) = match kind {
            // The arrows of a load say what it is.
            BoundaryKind::Free | BoundaryKind::Load => (2.0, None, Parts::new()),
            BoundaryKind::Fixed => (2.5, Some(INK), hatching(&held, scale)),
            BoundaryKind::Smooth => (1.2, Some(INK), rollers(&held, scale)),
            BoundaryKind::Far => {
                add_broken(figure, &held, &name)?;
                continue;
            }
            // Structures are drawn as bodies.
            BoundaryKind::Face => continue,
        };
        let lines: Parts = held.iter().map(|ends| ring(ends)).collect();
        let name = if kind == BoundaryKind::Load { String::new() } else { name };
        figure.push(Paths { color, ..Paths::new(name, lines).width(width) })?;
        if !symbols.is_empty() {
            figure.push(Paths::new("", symbols).width(0.8).color(INK))?;
        }
    }
    Ok(())
}

/// What holds, and on what sort of side.
fn words(kind: BoundaryKind, held: &[[Point; 2]]) -> String {
    let upright = held.iter().any(|[a, b]| a[0] == b[0]);
    let level = held.iter().any(|[a, b]| a[1] == b[1]);
    let other = held.iter().any(|[a, b]| a[0] != b[0] && a[1] != b[1]);
    let place = match (upright, level, other) {
        (true, false, false) => "side",
        (false, true, false) => "base",
        (true, true, false) => "base and side",
        _ => "boundary",
    };
    match kind {
        BoundaryKind::Free => "free surface".to_owned(),
        BoundaryKind::Fixed => format!("fixed {place}: no motion"),
        BoundaryKind::Smooth => format!("smooth {place}: slides along"),
        BoundaryKind::Far => format!("far {place}: the ground goes on"),
        BoundaryKind::Load => "loaded surface".to_owned(),
        BoundaryKind::Face => "face of a structure".to_owned(),
    }
}

/// Short oblique strokes outside.
fn hatching(held: &[[Point; 2]], scale: &Scale) -> Parts {
    let stroke = |ends: &[Point; 2], part: f64| {
        let (_, t, out) = along(*ends);
        let from = between(*ends, part);
        let reach = scale.px(9.0);
        ring(&[from, plus(plus(from, reach, out), -reach, t)])
    };
    let of = |ends: &[Point; 2]| {
        let ends = *ends;
        stations(along(ends).0, scale.px(10.0), 1).into_iter().map(move |part| stroke(&ends, part))
    };
    held.iter().flat_map(of).collect()
}

/// Circles outside, and the line on which they roll.
fn rollers(held: &[[Point; 2]], scale: &Scale) -> Parts {
    let radius = scale.px(4.0);
    let mut parts = Parts::new();
    for ends in held {
        let (length, _, out) = along(*ends);
        for part in stations(length, scale.px(26.0), 1) {
            let centre = plus(between(*ends, part), radius, out);
            let corner = |k: usize| {
                let angle = std::f64::consts::TAU * k as f64 / CORNERS as f64;
                plus(centre, radius, [angle.cos(), angle.sin()])
            };
            parts.push(ring(&(0..=CORNERS).map(corner).collect::<Vec<_>>()));
        }
        parts.push(ring(&ends.map(|p| plus(p, 2.0 * radius, out))));
    }
    parts
}

/// Broken lines, of which the legend shows the first.
fn add_broken(figure: &mut Figure, held: &[[Point; 2]], name: &str) -> Result<(), PageError> {
    for (i, ends) in held.iter().enumerate() {
        let line = Line::new(if i == 0 { name } else { "" }, ring(ends));
        figure.push(line.dash(Dash::Dash).width(1.6).color(INK))?;
    }
    Ok(())
}
