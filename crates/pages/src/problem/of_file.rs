//! What a problem file says, drawn.

use soilctl_app::solve::BoundaryKind;
use soilctl_app::text::number;
use soilctl_limit_analysis::describe::{Aim, Hold, SoilEntry, Water};
use soilctl_limit_analysis::results::{Point, problem_units};
use soilctl_limit_analysis::{Described, Description};

use super::of_statement::soils;
use super::place::{add, along, between, middle};
use super::regions::is_inside;
use super::{Load, Scene};

impl Scene {
    /// All that a problem file says. Regions, boundaries and loads are those of the statement that it was turned into.
    pub(crate) fn of_file(description: &Description, described: &Described) -> Self {
        let (statement, units) = (&described.statement, problem_units(description, described));
        let title = described.title.as_deref().unwrap_or("the problem");
        let mut scene = Self::of_statement(statement, &units, title, 0.0);
        scene.soils = soils(statement, |region| soil(description, described, region), |p| units.point(p));
        scene.surcharge = description.surcharge_kpa;
        scene.structures(description);
        scene.table = Vec::new();
        if let Some(water) = &description.water {
            scene.water(water);
        }
        if let Some(flowed) = &described.flowed {
            let weight = description.seepage.unwrap_or_default().unit_weight_kn_m3;
            scene.flow(&description.heads, weight, flowed);
        }
        scene.shaking = shaking(description);
        scene
    }

    fn structures(&mut self, description: &Description) {
        let held = |name: &str, hold: Option<Hold>| match hold {
            None => name.to_owned(),
            Some(Hold::Fixed) => format!("{name} (held fixed)"),
            Some(Hold::Smooth) => format!("{name} (held, smooth)"),
        };
        self.faces.clear();
        for s in &description.structures {
            let name = held(&s.name, s.held);
            if s.polygon.is_empty() {
                self.faces.push((name, s.edge.clone()));
            } else {
                self.bodies.push((name, s.polygon.clone()));
            }
        }
        self.faces.extend(description.plates.iter().map(|p| (held(&p.name, p.held), p.line.clone())));
        self.motion = match &description.objective {
            Aim::Structure { name, direction } => {
                let structures = description.structures.iter().filter(|s| s.name == *name);
                let plates = description.plates.iter().filter(|p| p.name == *name);
                let points = structures.flat_map(|s| s.polygon.iter().chain(&s.edge));
                let points: Vec<Point> = points.chain(plates.flat_map(|p| &p.line)).copied().collect();
                // First to the order of one, against overflow.
                let most = direction[0].abs().max(direction[1].abs());
                let to = along([[0.0; 2], direction.map(|x| x / most)]).1;
                Some((format!("motion of “{name}”, whose force is bounded"), middle(&points), to))
            }
            Aim::Load {} | Aim::UnitWeight {} | Aim::Seismic { .. } | Aim::StrengthReduction {} => None,
        };
    }

    /// The table over the whole width, open water above the ground, and no arrows for the pressure of that.
    fn water(&mut self, water: &Water) {
        let table = water.levels();
        let xs = || self.sides.iter().flat_map(|(ends, _)| ends).map(|p| p[0]);
        let (low, high) = (xs().fold(f64::INFINITY, f64::min), xs().fold(f64::NEG_INFINITY, f64::max));
        let stretch = |low: f64, high: f64| {
            let kinks = table.iter().copied().filter(|p| p[0] > low && p[0] < high);
            let ends = [low, high].map(|x| [x, level(&table, x)]);
            [ends[0]].into_iter().chain(kinks).chain([ends[1]]).collect::<Vec<Point>>()
        };
        self.table = vec![stretch(low, high)];
        let depth = |p: Point| (level(&table, p[0]) - p[1]).max(0.0);
        let is_water = |load: &Load| {
            let expected = load.ends.map(|p| self.surcharge + water.unit_weight_kn_m3 * depth(p));
            let near = |i: usize| (load.pressure[i] - expected[i]).abs() <= 1e-6 * expected[i].abs();
            load.shear == [0.0; 2] && !load.live && near(0) && near(1)
        };
        let (under, others): (Vec<_>, Vec<_>) = self.loads.drain(..).partition(is_water);
        self.loads = others;
        // What is free in the file is free in the drawing.
        self.sides.extend(under.iter().map(|load| (load.ends, BoundaryKind::Free)));
        let free = self.sides.iter().filter(|side| side.1 == BoundaryKind::Free).map(|side| side.0);
        let ground = free.chain(self.loads.iter().map(|load| load.ends));
        // From left to right; the ground is walked the other way.
        let mut wet: Vec<[Point; 2]> = ground
            .filter(|ends| ends[1][0] < ends[0][0] && depth(between(*ends, 0.5)) > 0.0)
            .map(|[right, left]| [left, right])
            .collect();
        wet.sort_by(|a, b| a[0][0].total_cmp(&b[0][0]));
        let pond = |bottom: &[[Point; 2]]| {
            let (first, last) = (bottom[0][0], bottom[bottom.len() - 1][1]);
            let mut corners = stretch(first[0], last[0]);
            corners.extend(bottom.iter().rev().flat_map(|[left, right]| [*right, *left]));
            corners
        };
        self.ponds = wet.chunk_by(|a, b| a[1] == b[0]).map(pond).collect();
    }
}

/// Height of the water table at `x`: level beyond its ends.
fn level(table: &[Point], x: f64) -> f64 {
    let piece = table.windows(2).find(|w| (w[0][0]..=w[1][0]).contains(&x));
    let end = |p: Option<&Point>| p.map_or(f64::NEG_INFINITY, |p| p[1]);
    match piece {
        Some([a, b]) if b[0] > a[0] => a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]),
        Some(w) => end(w.first()),
        None if table.first().is_some_and(|p| x < p[0]) => end(table.first()),
        None => end(table.last()),
    }
}

/// The soil of a region of the statement, in words: that of the entry which has a point of the region in it.
fn soil(description: &Description, described: &Described, region: usize) -> String {
    let (statement, units) = (&described.statement, problem_units(description, described));
    let sides = statement.regions[region].loops.iter().flatten();
    let mut inside = sides.map(|side| {
        let ends = statement.lines[side.line].walked(side.forward).map(|p| units.point(statement.points[p]));
        let (length, _, out) = along(ends);
        add(between(ends, 0.5), -1e-4 * length, out)
    });
    let entry = inside.find_map(|p| description.regions.iter().find(|entry| is_inside(&entry.polygon, p)));
    let entry = entry.and_then(|entry| description.soils.iter().find(|soil| soil.name == entry.soil));
    entry.map_or_else(|| "soil".to_owned(), soil_words)
}

fn soil_words(soil: &SoilEntry) -> String {
    let mut words = match soil.law_words() {
        Some(law) => format!("{}: {law}", soil.name),
        None => {
            let phi_deg = number(soil.phi_deg.unwrap_or_default());
            format!("{}: φ {phi_deg}°, c {} kPa", soil.name, number(soil.cohesion_kpa))
        }
    };
    if let Some(dilation_deg) = soil.dilation_deg {
        words += &format!(", ψ {}°", number(dilation_deg));
    }
    if let Some(of) = soil.anisotropy {
        words += &format!(", passive {} c, shear {} c", number(of.passive), number(of.shear));
    }
    if soil.cohesion_gradient_kpa_per_m != 0.0 {
        let level = soil.cohesion_level_m.unwrap_or(0.0);
        words +=
            &format!(" + {} kPa/m below y = {} m", number(soil.cohesion_gradient_kpa_per_m), number(level));
    }
    words + &format!(", {} kN/m³", number(soil.unit_weight_kn_m3))
}

/// Accelerations as forces on the soil over its weight.
fn shaking(description: &Description) -> Vec<(String, Point)> {
    let seismic = description.seismic.unwrap_or_default();
    let mut all = Vec::new();
    for (name, value, axis) in [("kh", seismic.kh, 0), ("kv", seismic.kv, 1)] {
        if value != 0.0 {
            let mut to = [0.0; 2];
            to[axis] = value.signum();
            all.push((format!("earthquake, {name} = {}", number(value)), to));
        }
    }
    if let Aim::Seismic { leftwards } = description.objective {
        let to = if leftwards { [-1.0, 0.0] } else { [1.0, 0.0] };
        all.push(("acceleration, bounded".to_owned(), to));
    }
    all
}
