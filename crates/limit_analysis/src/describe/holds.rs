//! What holds on each side of each edge, in the units of the description.

use soilctl_certificate::LineUse;

use super::error::DescriptionError;
use super::ground::{Map, Occupant};
use super::input::Description;
use super::parts::{Hold, Interface, Kind, Profile, Side, SoilInterface};
use super::segments::{Drawing, Owner, Segment};
use crate::vector::{Point, between, length};

/// What holds on one side of an edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Holds {
    Fixed,
    Smooth,
    Free,
    Far,
    /// Pressure and shear stress at the first and the last point of the edge itself; shear along the side with the soil on
    /// the left.
    Load {
        pressure: [f64; 2],
        shear: [f64; 2],
        live: bool,
    },
    Face(Interface),
}

/// Finds what holds.
pub(super) struct Holder<'a> {
    pub(super) description: &'a Description,
    pub(super) drawing: &'a Drawing,
    pub(super) segments: &'a [Segment],
    pub(super) map: &'a Map,
}

impl Holder<'_> {
    /// What holds on all sides with soil that are no interface between soils.
    pub(super) fn all(&self) -> Result<Vec<(LineUse, Holds)>, DescriptionError> {
        let mut all = Vec::new();
        let mut missing = Vec::new();
        let mut covered = Coverage::new(self.description);
        for edge in 0..self.map.arrangement.edges.len() {
            for forward in [true, false] {
                let walk = LineUse { line: edge, forward };
                let Occupant::Soil { region, .. } = self.map.left_of(walk) else { continue };
                match self.side(walk, region, &mut covered)? {
                    Some(Some(holds)) => all.push((walk, holds)),
                    Some(None) => missing.push(self.map.walked_points(walk)),
                    None => {}
                }
            }
        }
        if !missing.is_empty() {
            return Err(DescriptionError::NoCondition { parts: parts(&missing) });
        }
        self.check_found(&covered)?;
        Ok(all)
    }

    /// Segments of the given kind on an edge, and whether they run as it is walked.
    pub(super) fn uses<T>(
        &self,
        walk: LineUse,
        wanted: impl Fn(Owner) -> Option<T>,
    ) -> Vec<(T, usize, bool)> {
        let uses = &self.map.arrangement.edges[walk.line].uses;
        let with =
            |(s, same): &(usize, bool)| Some((wanted(self.segments[*s].owner)?, *s, *same == walk.forward));
        uses.iter().filter_map(with).collect()
    }

    /// What holds on one side: nothing where other soil is, and nothing known where no entry says so.
    fn side(
        &self,
        walk: LineUse,
        region: usize,
        covered: &mut Coverage,
    ) -> Result<Option<Option<Holds>>, DescriptionError> {
        let soil = self.description.soil_of(region);
        let beyond = self.map.left_of(walk.reversed());
        let boundaries = self.uses(walk, |o| if let Owner::Boundary(i) = o { Some(i) } else { None });
        let plates = self.uses(walk, |o| if let Owner::Plate(i) = o { Some(i) } else { None });
        let edges = self.uses(walk, |o| if let Owner::Edge(i) = o { Some(i) } else { None });
        let structure = match beyond {
            Occupant::Structure(i) => Some(i),
            Occupant::Outside => edges.first().map(|e| e.0),
            Occupant::Soil { .. } => None,
        };
        let [a, b] = self.map.walked_points(walk);
        let long = length(between(a, b));
        edges.iter().for_each(|e| covered.edges[e.0] += if beyond.is_soil() { 0.0 } else { long });
        boundaries.iter().for_each(|b| covered.lines[b.0] += if beyond.is_soil() { 0.0 } else { long });
        let holds = if let Some((plate, _, same)) = plates.first() {
            covered.plates[*plate] = true;
            let p = &self.description.plates[*plate];
            let both = Interface { delta_deg: p.delta_deg, adhesion_kpa: p.adhesion_kpa };
            let own = if *same { p.left } else { p.right };
            Some((
                self.description.plate_title(*plate),
                self.face(own.unwrap_or(both), &p.in_soil, p.held, soil),
            ))
        } else if let Some(structure) = structure {
            covered.structures[structure] = true;
            let s = &self.description.structures[structure];
            let face = Interface { delta_deg: s.delta_deg, adhesion_kpa: s.adhesion_kpa };
            Some((self.description.structure_title(structure), self.face(face, &s.in_soil, s.held, soil)))
        } else {
            None
        };
        if let Some((title, holds)) = holds {
            if let (Some((other, _, _)), false) = (boundaries.first(), beyond.is_soil()) {
                let second = self.description.boundary_title(*other);
                return Err(DescriptionError::Conflict { first: title, second, line: [a, b] });
            }
            self.check_face(&title, holds, soil)?;
            return Ok(Some(Some(holds)));
        }
        if beyond.is_soil() {
            return Ok(None);
        }
        if let [(first, _, _), (second, _, _), ..] = boundaries[..] {
            let [first, second] = [first, second].map(|i| self.description.boundary_title(i));
            return Err(DescriptionError::Conflict { first, second, line: [a, b] });
        }
        let by_side =
            |entry: &usize| self.description.boundaries[*entry].sides.iter().any(|s| self.is_on(walk, *s));
        let mut sides = (0..self.description.boundaries.len()).filter(by_side);
        let of_side = sides.next();
        if let (Some(first), Some(second)) = (of_side, sides.next()) {
            let [first, second] = [first, second].map(|i| self.description.boundary_title(i));
            return Err(DescriptionError::Conflict { first, second, line: [a, b] });
        }
        if let Some(entry) = of_side {
            covered.sides[entry] = true;
        }
        let holds = match (boundaries.first(), of_side, self.description.default_boundary) {
            (Some((entry, segment, same)), _, _) => {
                Some(self.boundary(walk, *entry, Some((*segment, *same))))
            }
            (None, Some(entry), _) => Some(self.boundary(walk, entry, None)),
            (None, None, Some(kind)) => Some(of_kind(kind)),
            (None, None, None) => None,
        };
        if holds == Some(Holds::Far)
            && ![Side::Left, Side::Right, Side::Bottom].iter().any(|s| self.is_on(walk, *s))
        {
            let at = format!("the outline from ({}, {}) to ({}, {})", a[0], a[1], b[0], b[1]);
            let problem =
                "only vertical lines on the far left and right and a level one at the bottom can be far";
            return Err(DescriptionError::entry(at, problem));
        }
        Ok(Some(holds))
    }

    fn is_on(&self, walk: LineUse, side: Side) -> bool {
        let [a, b] = self.map.walked_points(walk);
        let all = |axis: usize, at: f64| a[axis] == at && b[axis] == at;
        match side {
            Side::Left => all(0, self.drawing.low[0]),
            Side::Right => all(0, self.drawing.high[0]),
            Side::Bottom => all(1, self.drawing.low[1]),
            Side::Top => b[0] < a[0],
        }
    }

    fn face(&self, face: Interface, in_soil: &[SoilInterface], held: Option<Hold>, soil: usize) -> Holds {
        let name = &self.description.soils[soil].name;
        match (held, in_soil.iter().find(|f| f.soil == *name)) {
            (Some(Hold::Fixed), _) => Holds::Fixed,
            (Some(Hold::Smooth), _) => Holds::Smooth,
            (None, Some(f)) => {
                Holds::Face(Interface { delta_deg: f.delta_deg, adhesion_kpa: f.adhesion_kpa })
            }
            (None, None) => Holds::Face(face),
        }
    }

    /// What faces bear must fit the soil.
    fn check_face(&self, entry: &str, holds: Holds, soil: usize) -> Result<(), DescriptionError> {
        let (Holds::Face(face), s) = (holds, &self.description.soils[soil]) else { return Ok(()) };
        let problem = if face.delta_deg > s.steepest_deg() {
            format!(
                "delta is {} deg, but it meets soil \"{}\" with phi {} deg",
                face.delta_deg,
                s.name,
                s.steepest_deg()
            )
        } else if face.delta_deg == 0.0 && face.adhesion_kpa > 0.0 && s.steepest_deg() > 0.0 {
            format!("it has adhesion without friction, but meets soil \"{}\", which has friction", s.name)
        } else {
            return Ok(());
        };
        let advice = "give delta_deg and adhesion_kpa for this soil under in_soil";
        Err(DescriptionError::entry(entry, format!("{problem}; {advice}")))
    }

    fn boundary(&self, walk: LineUse, entry: usize, line: Option<(usize, bool)>) -> Holds {
        let b = &self.description.boundaries[entry];
        if b.kind != Kind::Load {
            return of_kind(b.kind);
        }
        let profile = |p: Option<Profile>| p.map_or([0.0; 2], Profile::ends);
        let (pressure, shear) = (profile(b.pressure_kpa), profile(b.shear_kpa));
        let ends = self.map.arrangement.ends(walk.line);
        let at = |[first, last]: [f64; 2], p: Point| match line {
            Some((segment, _)) if first != last => first + (last - first) * self.along(entry, segment, p),
            _ => first,
        };
        let sign = if line.is_none_or(|(_, same)| same) { 1.0 } else { -1.0 };
        Holds::Load {
            pressure: ends.map(|p| at(pressure, p)),
            shear: ends.map(|p| sign * at(shear, p)),
            live: b.live,
        }
    }

    /// Fraction of the length of a boundary's line at a point on one of its segments.
    fn along(&self, entry: usize, segment: usize, p: Point) -> f64 {
        let line = &self.drawing.lines[entry];
        let lengths: Vec<f64> = line.windows(2).map(|w| length(between(w[0], w[1]))).collect();
        let number = self.segments[segment].number;
        let before: f64 = lengths[..number].iter().sum();
        let within = length(between(line[number], p));
        ((before + within) / lengths.iter().sum::<f64>()).clamp(0.0, 1.0)
    }

    /// Entries must lie where they can hold.
    fn check_found(&self, covered: &Coverage) -> Result<(), DescriptionError> {
        let whole = |points: &[Point]| points.windows(2).map(|w| length(between(w[0], w[1]))).sum::<f64>();
        for (i, entry) in self.description.boundaries.iter().enumerate() {
            let title = self.description.boundary_title(i);
            if !entry.line.is_empty()
                && covered.lines[i] < whole(&self.drawing.lines[i]) - 2.0 * self.drawing.near
            {
                let problem =
                    "its line is not on the outline of the soil all along; give points of the outline";
                return Err(DescriptionError::entry(title, problem));
            }
            if entry.line.is_empty() && !covered.sides[i] {
                let problem =
                    "there is no outline on its sides; left and right must be vertical, bottom level";
                return Err(DescriptionError::entry(title, problem));
            }
        }
        for (i, s) in self.description.structures.iter().enumerate() {
            let title = self.description.structure_title(i);
            if !s.edge.is_empty() && covered.edges[i] < whole(&s.edge) - 2.0 * self.drawing.near {
                let problem =
                    "its edge is not on the outline of the soil all along; give points of the outline";
                return Err(DescriptionError::entry(title, problem));
            }
            if !covered.structures[i] {
                return Err(DescriptionError::entry(title, "it does not touch the soil"));
            }
        }
        match covered.plates.iter().position(|covered| !covered) {
            Some(i) => Err(DescriptionError::entry(self.description.plate_title(i), "it is not in the soil")),
            None => Ok(()),
        }
    }
}

/// How much of each entry was met.
struct Coverage {
    lines: Vec<f64>,
    sides: Vec<bool>,
    edges: Vec<f64>,
    structures: Vec<bool>,
    plates: Vec<bool>,
}

impl Coverage {
    fn new(description: &Description) -> Self {
        Self {
            lines: vec![0.0; description.boundaries.len()],
            sides: vec![false; description.boundaries.len()],
            edges: vec![0.0; description.structures.len()],
            structures: vec![false; description.structures.len()],
            plates: vec![false; description.plates.len()],
        }
    }
}

fn of_kind(kind: Kind) -> Holds {
    match kind {
        Kind::Fixed => Holds::Fixed,
        Kind::Smooth | Kind::Symmetric => Holds::Smooth,
        Kind::Far => Holds::Far,
        Kind::Free | Kind::Load => Holds::Free,
    }
}

/// A few lines in words.
fn parts(lines: &[[Point; 2]]) -> String {
    const SHOWN: usize = 6;
    let word = |[a, b]: &[Point; 2]| format!("from ({}, {}) to ({}, {})", a[0], a[1], b[0], b[1]);
    let mut words: Vec<String> = lines.iter().take(SHOWN).map(word).collect();
    if lines.len() > SHOWN {
        words.push(format!("{} more", lines.len() - SHOWN));
    }
    words.join(", ")
}
