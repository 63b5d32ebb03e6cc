//! What acts: loads and surcharge as arrows with their values, earthquakes, and the motion of a structure.

use soilctl_app::text::number;
use soilctl_figure::{Figure, Paths, Text, TextPlace};
use soilctl_limit_analysis::results::Point;

use super::place::{Scale, add as plus, along, between, data, ring, stations};
use super::{ACTING, INK, Load, Scene};
use crate::PageError;
use soilctl_app::solve::BoundaryKind;

/// Lengths in px: of the arrows of the greatest pressure, of surcharge, of shear stress, of motion and acceleration.
const PRESSURE: f64 = 38.0;
const SURCHARGE: f64 = 13.0;
const SHEAR: f64 = 20.0;
const WHOLE: f64 = 55.0;

pub(super) fn add(figure: &mut Figure, scene: &Scene, scale: &Scale) -> Result<(), PageError> {
    add_surcharge(figure, scene, scale)?;
    let most = scene.loads.iter().flat_map(|l| l.pressure).map(f64::abs).fold(0.0, f64::max);
    for (live, name) in [(false, "load"), (true, "load whose factor is bounded")] {
        let loads: Vec<&Load> = scene.loads.iter().filter(|load| load.live == live).collect();
        if loads.is_empty() {
            continue;
        }
        let arrows: Vec<_> = loads.iter().flat_map(|load| arrows(load, most, scale)).collect();
        let tails: Vec<_> = loads.iter().map(|load| ring(&tail(load, most, scale))).collect();
        let width = if live { 2.2 } else { 1.4 };
        figure.push(Paths::new(name, arrows).width(width).color(ACTING).arrows())?;
        figure.push(Paths::new("", tails).width(1.0).color(ACTING))?;
        for load in loads {
            add_values(figure, load, &scene.stress_name, &tail(load, most, scale))?;
        }
    }
    let reach = scale.px(WHOLE);
    if let Some((name, from, to)) = &scene.motion {
        let arrow = vec![ring(&[*from, plus(*from, reach, *to)])];
        figure.push(Paths::new(name.clone(), arrow).width(3.0).color(INK).arrows())?;
    }
    for (place, (words, to)) in scene.shaking.iter().enumerate() {
        // Above the soil at its left, beside each other.
        let middle =
            [scale.low[0] + scale.px(60.0 + 150.0 * place as f64), scale.high[1] + scale.px(PRESSURE + 40.0)];
        let arrow = vec![ring(&[plus(middle, -0.5 * reach, *to), plus(middle, 0.5 * reach, *to)])];
        let name = if place == 0 { "what pushes the whole ground" } else { "" };
        figure.push(Paths::new(name, arrow).width(3.0).color(ACTING).arrows())?;
        let beside = if to[0].abs() > to[1].abs() { TextPlace::Above } else { TextPlace::Right };
        figure.push(Text::new(words.clone(), data(middle)).place(beside))?;
    }
    Ok(())
}

fn add_surcharge(figure: &mut Figure, scene: &Scene, scale: &Scale) -> Result<(), PageError> {
    if scene.surcharge == 0.0 {
        return Ok(());
    }
    let free = scene.sides.iter().filter(|side| side.1 == BoundaryKind::Free);
    let of = |ends: [Point; 2]| {
        let (length, _, out) = along(ends);
        stations(length, scale.px(28.0), 1).into_iter().map(move |part| {
            let at = between(ends, part);
            ring(&[plus(at, scale.px(SURCHARGE), out), at])
        })
    };
    let arrows: Vec<_> = free.flat_map(|side| of(side.0)).collect();
    if !arrows.is_empty() {
        let name = format!("surcharge {} {}", number(scene.surcharge), scene.stress_name);
        figure.push(Paths::new(name, arrows).width(1.0).color(ACTING).arrows())?;
    }
    Ok(())
}

/// How far from the side the arrows of a load begin, a part of the way along it.
fn height(load: &Load, part: f64, most: f64, scale: &Scale) -> f64 {
    let pressure = load.pressure[0] + part * (load.pressure[1] - load.pressure[0]);
    if most > 0.0 { scale.px(PRESSURE) * pressure.abs() / most } else { 0.0 }
}

fn arrows(load: &Load, most: f64, scale: &Scale) -> Vec<Vec<(f64, f64)>> {
    let (length, t, out) = along(load.ends);
    let mut parts = Vec::new();
    for part in stations(length, scale.px(18.0), 3) {
        let (foot, far) = (between(load.ends, part), height(load, part, most, scale));
        let pressure = load.pressure[0] + part * (load.pressure[1] - load.pressure[0]);
        if far > scale.px(1.0) {
            let tail = plus(foot, far, out);
            parts.push(ring(&if pressure > 0.0 { [tail, foot] } else { [foot, tail] }));
        }
    }
    for part in stations(length, scale.px(1.6 * SHEAR), 2) {
        let shear = load.shear[0] + part * (load.shear[1] - load.shear[0]);
        if shear != 0.0 {
            // Beside the heads of the arrows of pressure.
            let middle = plus(between(load.ends, part), scale.px(4.0), out);
            let half = 0.5 * scale.px(SHEAR).copysign(shear);
            parts.push(ring(&[plus(middle, -half, t), plus(middle, half, t)]));
        }
    }
    parts
}

/// The line along which arrows begin.
fn tail(load: &Load, most: f64, scale: &Scale) -> [Point; 2] {
    let (_, _, out) = along(load.ends);
    [0.0, 1.0].map(|part| plus(between(load.ends, part), height(load, part, most, scale), out))
}

/// Pressure, and shear stress if there is one, in words at the tails.
fn add_values(figure: &mut Figure, load: &Load, unit: &str, tail: &[Point; 2]) -> Result<(), PageError> {
    let (_, _, out) = along(load.ends);
    let place = match out {
        [x, y] if x.abs() <= y.abs() && y > 0.0 => TextPlace::Above,
        [x, y] if x.abs() <= y.abs() => TextPlace::Below,
        [x, _] if x > 0.0 => TextPlace::Right,
        _ => TextPlace::Left,
    };
    // From left to right, or upwards, whichever way the side is walked.
    let [from, to] = load.ends;
    let forward = (from[0], from[1]) <= (to[0], to[1]);
    let span = |[a, b]: [f64; 2]| {
        let [a, b] = if forward { [a, b] } else { [b, a] };
        if (a - b).abs() <= 1e-9 * a.abs() {
            number(round(a))
        } else {
            format!("{} to {}", number(round(a)), number(round(b)))
        }
    };
    let mut words = format!("{} {unit}", span(load.pressure));
    if load.pressure == [0.0; 2] {
        words.clear();
    }
    if load.shear != [0.0; 2] {
        let comma = if words.is_empty() { "" } else { ", " };
        words += &format!("{comma}shear {} {unit}", span(load.shear.map(f64::abs)));
    }
    if !words.is_empty() {
        figure.push(Text::new(words, data(between(*tail, 0.5))).place(place))?;
    }
    Ok(())
}

/// Values were divided by the unit of the solver.
fn round(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}
