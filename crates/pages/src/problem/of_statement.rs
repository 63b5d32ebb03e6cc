//! What a statement says, drawn: for saved solutions and plates, which have no problem file.

use soilctl_app::solve::BoundaryKind;
use soilctl_app::text::{line_force_unit, moment_unit, number};
use soilctl_certificate::{Boundary, Condition, Grip, LineUse, Material, Member, Objective, Statement};
use soilctl_figure::Polygon;
use soilctl_limit_analysis::results::{Point, Units};

use super::place::{along, middle};
use super::regions::union;
use super::{Load, Scene};
use crate::limits::{between_soils, water_table};

impl Scene {
    /// All that a statement says, turned counter-clockwise by an angle: statements may lie along a slope.
    pub(crate) fn of_statement(statement: &Statement, units: &Units, title: &str, turn_deg: f64) -> Self {
        let (sin, cos) = turn_deg.to_radians().sin_cos();
        let turned = |[x, y]: Point| [cos * x - sin * y, sin * x + cos * y];
        let place = |p: Point| turned(units.point(p));
        let label = |region: usize| material_words(&statement.regions[region].material, units);
        let ends =
            |b: &Boundary| statement.lines[b.line].walked(b.forward).map(|p| place(statement.points[p]));
        // Where a beam lines the soil there is the beam.
        let is_lined = |b: &&Boundary| matches!(b.condition, Condition::Lined { .. });
        let outline = statement.boundaries.iter().filter(|b| !is_lined(b));
        let sides: Vec<_> = outline.map(|b| (ends(b), BoundaryKind::from(&b.condition))).collect();
        let faces: Vec<[Point; 2]> =
            sides.iter().filter(|side| side.1 == BoundaryKind::Face).map(|side| side.0).collect();
        let moves = statement.objective.velocity();
        let motion = (moves != [0.0; 2] && !faces.is_empty()).then(|| {
            let centre = middle(faces.as_flattened());
            (
                "motion of the structure, whose force is bounded".to_owned(),
                centre,
                along([[0.0; 2], turned(moves)]).1,
            )
        });
        Self {
            title: title.to_owned(),
            length_name: units.length_name.clone(),
            stress_name: units.stress_name.clone(),
            soils: soils(statement, label, place),
            interfaces: between_soils(statement)
                .into_iter()
                .map(|line| line.into_iter().map(place).collect())
                .collect(),
            bodies: Vec::new(),
            faces: faces.iter().map(|ends| (String::new(), ends.to_vec())).collect(),
            members: members(statement, units, place),
            table: water_table(statement).into_iter().map(|line| line.map(place).to_vec()).collect(),
            ponds: Vec::new(),
            free_surface: Vec::new(),
            equipotentials: Vec::new(),
            heads: Vec::new(),
            loads: loads(statement, units, place),
            surcharge: units.stress * statement.surcharge,
            motion,
            shaking: shaking(statement, turned),
            sides,
        }
    }
}

/// Members, in words, and their ends.
fn members(
    statement: &Statement,
    units: &Units,
    place: impl Fn(Point) -> Point,
) -> Vec<(String, [Point; 2])> {
    let force = |x: f64| number(round(units.length * units.stress * x));
    let unit = line_force_unit(&units.stress_name, &units.length_name);
    let of = |m: &Member| {
        let corner = |side: &LineUse, i: usize| {
            place(statement.points[statement.lines[side.line].walked(side.forward)[i]])
        };
        let ends = [corner(m.path.first()?, 0), corner(m.path.last()?, 1)];
        let compression = if m.compression > 0.0 {
            format!(", {} in compression", force(m.compression))
        } else {
            String::new()
        };
        let bond = if m.bond < 1.0 { format!(", bond {}", number(m.bond)) } else { String::new() };
        let words = match m.bending {
            Some(bending) => {
                let [moment, unit] = moment_words(units, bending.moment);
                format!("beam: {moment} {unit}{bond}")
            }
            None => match &m.pullout {
                Some(grips) => {
                    let grip = gripped(grips, |x| number(round(units.stress * x)));
                    format!("bars: {} {unit}{compression}, {grip} {}", force(m.tension), units.stress_name)
                }
                None => format!("member: {} {unit}{compression}{bond}", force(m.tension)),
            },
        };
        Some((words, ends))
    };
    statement.members.iter().filter_map(of).collect()
}

/// The pullout resistance of bars, from the least to the greatest.
fn gripped(grips: &[Grip], number: impl Fn(f64) -> String) -> String {
    let all = || grips.iter().flat_map(|grip| grip.resistance);
    let (low, high) = (all().fold(f64::INFINITY, f64::min), all().fold(0.0, f64::max));
    let is_free = low < high || grips.iter().any(|grip| grip.part != [0.0, 1.0]);
    let up_to = if is_free { "up to " } else { "" };
    format!("pullout {up_to}{}", number(high))
}

fn moment_words(units: &Units, moment: f64) -> [String; 2] {
    let unit = moment_unit(&units.stress_name, &units.length_name);
    [number(round(units.length * units.length * units.stress * moment)), unit]
}

/// Soils in the order of their regions, each with all of these.
pub(super) fn soils(
    statement: &Statement,
    label: impl Fn(usize) -> String,
    place: impl Fn(Point) -> Point,
) -> Vec<(String, Vec<Polygon>)> {
    let mut named: Vec<(String, Vec<usize>)> = Vec::new();
    for region in 0..statement.regions.len() {
        let name = label(region);
        match named.iter_mut().find(|(known, _)| *known == name) {
            Some((_, regions)) => regions.push(region),
            None => named.push((name, vec![region])),
        }
    }
    named.into_iter().map(|(name, regions)| (name, union(statement, &regions, &place))).collect()
}

fn material_words(material: &Material, units: &Units) -> String {
    let cohesion = if material.cohesion.gradient == [0.0; 2] {
        format!("c {} {}", number(round(units.stress * material.cohesion.at_origin)), units.stress_name)
    } else {
        "c by place".to_owned()
    };
    let value = round(units.stress / units.length * material.unit_weight);
    let weight = match (units.stress_name.as_str(), number(value)) {
        ("kPa", value) => format!("{value} kN/m³"),
        (_, one) if one == "1" => "unit weight γ".to_owned(),
        (_, value) => format!("unit weight {value} γ"),
    };
    format!("soil: φ {}°, {cohesion}, {weight}", number(round(material.phi_deg)))
}

/// Loads of neighbours in line are one.
pub(super) fn loads(statement: &Statement, units: &Units, place: impl Fn(Point) -> Point) -> Vec<Load> {
    let mut all: Vec<Load> = Vec::new();
    for b in &statement.boundaries {
        let (pressure, shear, live) = match b.condition {
            Condition::Loaded { pressure, shear, live } | Condition::Lined { pressure, shear, live } => {
                (pressure, shear, live)
            }
            Condition::Submerged => (statement.pore_pressure(b.side()), [0.0; 2], false),
            Condition::Free
            | Condition::Fixed
            | Condition::Smooth
            | Condition::Far
            | Condition::Face { .. } => continue,
        };
        // Free ground that a beam lines bears no load.
        if (pressure, shear) == ([0.0; 2], [0.0; 2]) {
            continue;
        }
        let ends = statement.lines[b.line].walked(b.forward).map(|p| place(statement.points[p]));
        // Both are given from the start of the line on, whichever way the side is walked.
        let walked =
            |[a, c]: [f64; 2]| if b.forward { [a, c] } else { [c, a] }.map(|x| units.stress * x + 0.0);
        let live = live && statement.objective == Objective::Loads;
        all.push(Load { ends, pressure: walked(pressure), shear: walked(shear), live });
    }
    let mut joined: Vec<Load> = Vec::new();
    while let Some(mut load) = all.pop() {
        while let Some(next) = all.iter().position(|other| follows(&load, other)) {
            let next = all.swap_remove(next);
            load = Load {
                ends: [load.ends[0], next.ends[1]],
                pressure: [load.pressure[0], next.pressure[1]],
                shear: [load.shear[0], next.shear[1]],
                live: load.live,
            };
        }
        match joined.iter_mut().find(|other| follows(&load, other)) {
            Some(other) => {
                other.ends[0] = load.ends[0];
                other.pressure[0] = load.pressure[0];
                other.shear[0] = load.shear[0];
            }
            None => joined.push(load),
        }
    }
    joined
}

/// Whether the second is the same load further on: in line, with what it has where the first ends, growing alike.
fn follows(a: &Load, b: &Load) -> bool {
    let ((long_a, t, _), (long_b, s, _)) = (along(a.ends), along(b.ends));
    let near = |x: f64, y: f64, size: f64| (x - y).abs() <= 1e-9 * size;
    let size = |ends: [f64; 2]| ends[0].abs().max(ends[1].abs());
    let goes_on = |x: [f64; 2], y: [f64; 2]| {
        let most = size(x).max(size(y));
        near(x[1], y[0], most)
            && near((x[1] - x[0]) * long_b, (y[1] - y[0]) * long_a, most * (long_a + long_b))
    };
    a.live == b.live
        && a.ends[1] == b.ends[0]
        && near(t[0] * s[1], t[1] * s[0], 1.0)
        && goes_on(a.pressure, b.pressure)
        && goes_on(a.shear, b.shear)
}

/// Gravity that is not vertical, and the body force that is bounded.
fn shaking(statement: &Statement, turned: impl Fn(Point) -> Point) -> Vec<(String, Point)> {
    let direction = |p: Point| along([[0.0; 2], p]).1;
    let mut all = Vec::new();
    let gravity = turned(statement.gravity);
    if gravity[0].abs() > 1e-9 {
        all.push(("gravity".to_owned(), direction(gravity)));
    }
    if let Objective::Body { gravity } = statement.objective {
        all.push(("body force, bounded".to_owned(), direction(turned(gravity))));
    }
    all
}

/// Four digits.
fn round(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
