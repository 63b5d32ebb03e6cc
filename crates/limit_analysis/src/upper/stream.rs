//! The stream function of soil without friction: `v = (s_y, -s_x)`, on the same element as the stress function of the
//! lower bound. No volume changes and nothing jumps, whatever the unknowns are.

use std::collections::{BTreeMap, BTreeSet};

use soilctl_certificate::{LineUse, Place, Side, StreamCopy, StreamJet};
use soilctl_conic::{Form, Program};

use super::beams::BeamMotion;
use super::meshed::{Edge, MeshedProblem};
use super::nodes::{Element, Slipping};
use super::walls::{WallSide, wall_sides};
use crate::members::member_edges;
use crate::vector::{Point, between, cross, distance, turned};

/// What is known about a vertex copy; the same kinds as [`StreamJet`].
#[derive(Debug, Clone)]
enum UnknownJet {
    Free,
    Wall { wall: usize, line: usize, across: Form },
    Corner { wall: usize },
    Kinked { copy: usize, line: usize, jump: Form },
    Slip { copy: usize, towards: usize, jump: Form },
    SlipAtWall { copy: usize, towards: usize },
}

/// Vertex copies that depend on others: across members, and at toes.
pub(super) struct Depending {
    pub(super) kinks: BTreeMap<usize, (usize, usize)>,
    pub(super) slips: Vec<Slipping>,
}

#[derive(Debug, Default)]
pub(crate) struct StreamFunction {
    /// Vertex of each copy.
    vertices: Vec<usize>,
    shapes: Vec<UnknownJet>,
    /// Value and slopes at each copy.
    pub(super) jets: Vec<[Form; 3]>,
    /// For each triangle, slopes across the middles of its edges, along the edge vectors turned left.
    pub(super) slopes: Vec<[Form; 3]>,
    /// Constants of the walls.
    walls: Vec<Form>,
}

impl StreamFunction {
    pub(super) fn new(
        meshed: &MeshedProblem,
        elements: &[Element],
        vertices: Vec<usize>,
        Depending { kinks, slips }: Depending,
        beams: &mut BTreeMap<usize, BeamMotion>,
        program: &mut Program,
    ) -> Self {
        if vertices.is_empty() {
            return Self::default();
        }
        let (sides, walls) = wall_sides(meshed.problem);
        let on = sides_at(meshed, elements, &sides, vertices.len());
        let (gauge_walls, gauge_copies) = gauges(elements, &on, walls, &kinks, &slips);
        let size = sizes(meshed, elements, vertices.len());
        let on_beams = on_beams(meshed, elements, vertices.len());
        for (beam, motion) in beams.iter_mut() {
            let of = || on_beams.iter().enumerate().filter(|(_, at)| at.is_some_and(|at| at.beam == *beam));
            // Unless it is one of its copies that the function is relative to.
            if let Some(unit) = of().map(|(copy, _)| size[copy]).reduce(f64::max)
                && !of().any(|(copy, _)| gauge_copies[copy])
            {
                motion.float(unit, program);
            }
        }
        let mut wall_size = vec![0.0_f64; walls];
        for (copy, sides) in on.iter().enumerate() {
            sides.iter().for_each(|s| wall_size[s.wall] = wall_size[s.wall].max(size[copy]));
        }
        let mut unknown = |unit: f64| Form::unknown(program.unknown(), unit);
        let mut constants = Vec::new();
        for wall in 0..walls {
            // A wall without edges of this kind of flow has no size.
            let given = gauge_walls[wall] || wall_size[wall] == 0.0;
            constants.push(if given { Form::default() } else { unknown(wall_size[wall]) });
        }
        let mut stream = Self { vertices, walls: constants, ..Self::default() };
        let slipping: BTreeSet<usize> = slips.iter().map(|slip| slip.own).collect();
        for (copy, sides) in on.iter().enumerate() {
            let (shape, jet) = match sides.as_slice() {
                // Once all others are known.
                [] | [_] if slipping.contains(&copy) => {
                    (UnknownJet::Free, [Form::default(), Form::default(), Form::default()])
                }
                [] if kinks.contains_key(&copy) => {
                    (UnknownJet::Free, [Form::default(), Form::default(), Form::default()])
                }
                [] if on_beams[copy].is_some_and(|at| beams.contains_key(&at.beam)) => {
                    let jet = on_beams[copy].and_then(|at| Some(at.jet(beams.get(&at.beam)?, &mut unknown)));
                    (UnknownJet::Free, jet.unwrap_or_default())
                }
                [] => {
                    let s = if gauge_copies[copy] { Form::default() } else { unknown(size[copy]) };
                    (UnknownJet::Free, [s, unknown(1.0), unknown(1.0)])
                }
                [side, rest @ ..] => {
                    let place = meshed.mesh.vertices[stream.vertices[copy]].place;
                    let value = stream.walls[side.wall]
                        .clone()
                        .plus(1.0, &Form::constant(side.value(way(meshed, place, side.line))));
                    let (shape, [sx, sy]) = on_wall(side, rest.first(), &mut unknown);
                    (shape, [value, sx, sy])
                }
            };
            stream.shapes.push(shape);
            stream.jets.push(jet);
        }
        for (&own, &(copy, line)) in &kinks {
            let [p, q] = meshed.problem.ends(line);
            let n = [p[1] - q[1], q[0] - p[0]];
            let jump = unknown(1.0 / n[0].hypot(n[1]));
            let [s, sx, sy] = stream.jets[copy].clone();
            stream.jets[own] = [s, sx.plus(n[0], &jump), sy.plus(n[1], &jump)];
            stream.shapes[own] = UnknownJet::Kinked { copy, line, jump };
        }
        for slip in &slips {
            stream.add_slipping(meshed, *slip, &on[slip.own], &mut unknown);
        }
        stream.slopes = vec![[Form::default(), Form::default(), Form::default()]; elements.len()];
        for (triangle, element) in elements.iter().enumerate() {
            for corner in (0..3).filter(|_| matches!(element, Element::Stream(_))) {
                let side = Side { triangle, corner };
                let other = meshed.topology.across[triangle][corner];
                let [p, q] = meshed.ends(side);
                let length = distance(q, p);
                stream.slopes[triangle][corner] = match (meshed.edge(side), other) {
                    (Edge::Boundary(c), _) if is_holding(c) => continue,
                    (Edge::Glued, Some(o)) if o.triangle < triangle => {
                        Form::default().plus(-1.0, &stream.slopes[o.triangle][o.corner])
                    }
                    _ => unknown(length),
                };
            }
        }
        stream
    }

    /// Value and slopes of a copy that slips, given those of the copy from which it does.
    fn add_slipping(
        &mut self,
        meshed: &MeshedProblem,
        Slipping { own, copy, towards }: Slipping,
        sides: &[WallSide],
        unknown: &mut impl FnMut(f64) -> Form,
    ) {
        let position = |vertex: usize| meshed.mesh.vertices[vertex].position;
        let q = between(position(self.vertices[own]), position(towards));
        let [s, sx, sy] = self.jets[copy].clone();
        let Some(side) = sides.first() else {
            let n = turned(q);
            let jump = unknown(1.0 / n[0].hypot(n[1]));
            self.jets[own] = [s, sx.plus(n[0], &jump), sy.plus(n[1], &jump)];
            self.shapes[own] = UnknownJet::Slip { copy, towards, jump };
            return;
        };
        let place = meshed.mesh.vertices[self.vertices[own]].place;
        let value = Form::constant(side.value(way(meshed, place, side.line)));
        let (p, along_edge) = (side.direction, Form::default().plus(q[0], &sx).plus(q[1], &sy));
        let area = cross(p, q);
        let ([px, py], [qx, qy]) = (turned(p), turned(q));
        let of = |p: f64, q: f64| Form::constant(-q * side.flow() / area).plus(p / area, &along_edge);
        self.jets[own] = [self.walls[side.wall].clone().plus(1.0, &value), of(px, qx), of(py, qy)];
        self.shapes[own] = UnknownJet::SlipAtWall { copy, towards };
    }

    /// Value and slopes at the corners of a triangle, then the slopes across the middles of its edges.
    pub(super) fn local(&self, triangle: usize, copies: [usize; 3]) -> [Form; 12] {
        std::array::from_fn(|i| match i {
            0..9 => self.jets[copies[i / 3]][i % 3].clone(),
            _ => self.slopes[triangle][i - 9].clone(),
        })
    }

    pub(super) fn saved_slopes(&self, triangle: usize, x: &[f64]) -> [f64; 3] {
        self.slopes[triangle].each_ref().map(|slope| slope.value(x))
    }

    pub(super) fn saved(&self, x: &[f64]) -> (Vec<StreamCopy>, Vec<f64>) {
        let copies = self.vertices.iter().zip(&self.shapes).zip(&self.jets).map(|((vertex, shape), jet)| {
            let jet = match shape {
                UnknownJet::Free => {
                    let [s, sx, sy] = jet.each_ref().map(|f| f.value(x));
                    StreamJet::Free { s, sx, sy }
                }
                UnknownJet::Wall { wall, line, across } => {
                    StreamJet::Wall { wall: *wall, line: *line, across: across.value(x) }
                }
                UnknownJet::Corner { wall } => StreamJet::Corner { wall: *wall },
                UnknownJet::Slip { copy, towards, jump } => {
                    StreamJet::Slip { copy: *copy, towards: *towards, jump: jump.value(x) }
                }
                UnknownJet::SlipAtWall { copy, towards } => {
                    StreamJet::SlipAtWall { copy: *copy, towards: *towards }
                }
                UnknownJet::Kinked { copy, line, jump } => {
                    StreamJet::Kinked { copy: *copy, line: *line, jump: jump.value(x) }
                }
            };
            StreamCopy { vertex: *vertex, jet }
        });
        (copies.collect(), self.walls.iter().map(|w| w.value(x)).collect())
    }
}

fn is_holding(condition: soilctl_certificate::Condition) -> bool {
    use soilctl_certificate::Condition::{Far, Fixed};
    matches!(condition, Fixed | Far)
}

/// Fraction of a line at which a vertex on it is.
fn way(meshed: &MeshedProblem, place: Place, line: usize) -> f64 {
    match place {
        Place::OnLine { s, .. } => s,
        Place::Corner { point } if meshed.problem.statement().lines[line].from == point => 0.0,
        Place::Corner { .. } | Place::Inside => 1.0,
    }
}

/// Slopes at a copy that is on one side of a wall, or where two meet.
fn on_wall(
    side: &WallSide,
    other: Option<&WallSide>,
    unknown: &mut impl FnMut(f64) -> Form,
) -> (UnknownJet, [Form; 2]) {
    let [dx, dy] = side.direction;
    let square = dx * dx + dy * dy;
    let holds = side.holds || other.is_some_and(|o| o.holds);
    if other.is_none_or(|other| go_on(side, other) && !holds) {
        let across = if holds { Form::default() } else { unknown(1.0 / square.sqrt()) };
        let along = side.flow() / square;
        let slopes = [(dx, -dy), (dy, dx)].map(|(d, n)| Form::constant(along * d).plus(n, &across));
        return (UnknownJet::Wall { wall: side.wall, line: side.line, across }, slopes);
    }
    let slopes = other.map_or([0.0; 2], |other| corner(side, other));
    (UnknownJet::Corner { wall: side.wall }, slopes.map(Form::constant))
}

/// Whether two sides are one as far as the soil can tell. What is in line but for rounding is not.
fn go_on(a: &WallSide, b: &WallSide) -> bool {
    let level = |s: &WallSide| s.direction[1] == 0.0;
    let upright = |s: &WallSide| s.direction[0] == 0.0;
    let parallel = a.line == b.line || (level(a) && level(b)) || (upright(a) && upright(b));
    parallel && (a.velocity == b.velocity || (a.flow() == 0.0 && b.flow() == 0.0))
}

fn corner(a: &WallSide, b: &WallSide) -> [f64; 2] {
    let (f, g) = (a.flow(), b.flow());
    if f == 0.0 && g == 0.0 {
        return [0.0; 2];
    }
    if a.velocity == b.velocity {
        return [-a.velocity[1], a.velocity[0]];
    }
    let ([px, py], [qx, qy]) = (a.direction, b.direction);
    let area = px * qy - py * qx;
    [(-py * g + qy * f) / area, (px * g - qx * f) / area]
}

/// A vertex copy on a beam.
#[derive(Debug, Clone, Copy)]
struct OnBeam {
    beam: usize,
    place: f64,
    /// Unit vector along the beam.
    along: Point,
}

impl OnBeam {
    /// The soil goes with the beam across it, and slides along it.
    fn jet(self, beam: &BeamMotion, unknown: &mut impl FnMut(f64) -> Form) -> [Form; 3] {
        let (t, n) = (self.along, turned(self.along));
        let (velocity, slope) = (beam.across(self.place), unknown(1.0));
        let of = |i: usize| Form::default().plus(-t[i], &velocity).plus(n[i], &slope);
        [beam.stream(self.place), of(0), of(1)]
    }
}

/// For each copy, where on a beam it is.
fn on_beams(meshed: &MeshedProblem, elements: &[Element], copies: usize) -> Vec<Option<OnBeam>> {
    let mut on = vec![None; copies];
    for edge in member_edges(meshed.problem, meshed.mesh, meshed.topology) {
        if !meshed.problem.bends(edge.member) {
            continue;
        }
        for (right, side) in edge.sides.into_iter().enumerate() {
            let Some(side) = side else { continue };
            let Element::Stream(corners) = elements[side.triangle] else { continue };
            let mut ends = [1, 2].map(|i| corners[(side.corner + i) % 3]);
            if right == 1 {
                ends.reverse();
            }
            for (copy, place) in ends.into_iter().zip(edge.place) {
                on[copy] = Some(OnBeam { beam: edge.member, place, along: edge.along() });
            }
        }
    }
    on
}

/// For each copy, the sides of walls on which it is the end of an edge.
fn sides_at(
    meshed: &MeshedProblem,
    elements: &[Element],
    sides: &BTreeMap<LineUse, WallSide>,
    copies: usize,
) -> Vec<Vec<WallSide>> {
    let mut on: Vec<Vec<WallSide>> = vec![Vec::new(); copies];
    let mut used = vec![Vec::new(); copies];
    for (triangle, element) in elements.iter().enumerate() {
        let Element::Stream(corners) = element else { continue };
        for k in 0..3 {
            let Some(side) = meshed.topology.line[triangle][k] else { continue };
            let Some(wall) = sides.get(&side) else { continue };
            for copy in [corners[(k + 1) % 3], corners[(k + 2) % 3]] {
                if !used[copy].contains(&side) {
                    used[copy].push(side);
                    on[copy].push(*wall);
                }
            }
        }
    }
    on
}

/// A typical edge length at each copy.
fn sizes(meshed: &MeshedProblem, elements: &[Element], copies: usize) -> Vec<f64> {
    let mut sums = vec![(0.0, 0.0); copies];
    for (triangle, element) in elements.iter().enumerate() {
        let Element::Stream(corners) = element else { continue };
        for corner in 0..3 {
            let [p, q] = meshed.ends(Side { triangle, corner });
            for copy in [corners[(corner + 1) % 3], corners[(corner + 2) % 3]] {
                sums[copy].0 += distance(p, q);
                sums[copy].1 += 1.0;
            }
        }
    }
    sums.into_iter().map(|(sum, count)| sum / f64::max(count, 1.0)).collect()
}

/// The value of one wall, or else of one copy, in each part of the soil that hangs together: the function is only known
/// up to a constant.
fn gauges(
    elements: &[Element],
    on: &[Vec<WallSide>],
    walls: usize,
    kinks: &BTreeMap<usize, (usize, usize)>,
    slips: &[Slipping],
) -> (Vec<bool>, Vec<bool>) {
    // Walls come first, so the root of a part is its first wall if it has one.
    let mut root: Vec<usize> = (0..walls + on.len()).collect();
    fn find(root: &mut [usize], mut i: usize) -> usize {
        while root[i] != i {
            root[i] = root[root[i]];
            i = root[i];
        }
        i
    }
    let mut join = |a: usize, b: usize| {
        let (a, b) = (find(&mut root, a), find(&mut root, b));
        root[a.max(b)] = a.min(b);
    };
    for element in elements {
        let Element::Stream([a, b, c]) = element else { continue };
        join(walls + a, walls + b);
        join(walls + a, walls + c);
    }
    for (copy, sides) in on.iter().enumerate() {
        sides.iter().for_each(|s| join(walls + copy, s.wall));
    }
    for (own, (copy, _)) in kinks {
        join(walls + own, walls + copy);
    }
    slips.iter().for_each(|slip| join(walls + slip.own, walls + slip.copy));
    let mut is_root: Vec<bool> = (0..root.len()).map(|i| root[i] == i).collect();
    for (own, (copy, _)) in kinks {
        // What depends on another has no value of its own.
        if std::mem::replace(&mut is_root[walls + own], false) {
            is_root[walls + copy] = true;
        }
    }
    (is_root[..walls].to_vec(), is_root[walls..].to_vec())
}
