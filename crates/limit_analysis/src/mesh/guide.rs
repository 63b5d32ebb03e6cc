//! Guides as they come, and where they meet lines.

use super::MeshError;
use super::cut::Profile;
use super::domain::Domain;
use super::fan::Disc;
use super::triangulation::to_spade;
use super::wanted::Wanted;
use soilctl_certificate::{Member, Statement};

use crate::vector::{Point, along, angle, between, cross, distance, dot};

/// Two things nearer than this fraction of the wanted size become one.
pub(super) const NEAR: f64 = 0.6;

/// How far beyond its end, in wanted sizes, a guide is taken to touch a line.
const REACH: f64 = 0.4;

/// A bend of a guide by more than this angle (30 degrees) becomes a vertex.
const BEND: f64 = std::f64::consts::FRAC_PI_6;

/// A line of the solution, such as a slip line, that edges of the mesh shall follow as far as they can. What is outside
/// the regions does not matter; what is closer to a line or another guide than about half the wanted size gives way.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Guide {
    /// Points of the polyline, x and y.
    pub points: Vec<[f64; 2]>,
}

/// A guide with what is needed to follow it.
pub(super) struct Trail {
    /// Points, no two neighbours equal, at least two.
    points: Vec<Point>,
    /// Distance of each point from the first, along the guide.
    distance: Vec<f64>,
    /// Distances that must become vertices, ascending, with both ends.
    nodes: Vec<f64>,
}

impl Guide {
    /// What there is of the guide in a box, which may be in several parts; no two neighbouring points are equal.
    pub(super) fn parts(&self, index: usize, bounds: [Point; 2]) -> Result<Vec<Vec<Point>>, MeshError> {
        if let Some(point) = self.points.iter().position(|p| !(p[0].abs() <= 1e30 && p[1].abs() <= 1e30)) {
            let [x, y] = self.points[point];
            return Err(MeshError::BadGuide { guide: index, point, x, y });
        }
        let mut parts: Vec<Vec<Point>> = Vec::new();
        for pair in self.points.windows(2) {
            let Some([a, b]) = clip(pair[0], pair[1], bounds).filter(|[a, b]| a != b) else { continue };
            match parts.last_mut() {
                Some(part) if part.last() == Some(&a) => part.push(b),
                _ => parts.push(vec![a, b]),
            }
        }
        Ok(parts)
    }
}

impl Trail {
    /// The trail of points of which no two neighbours are equal.
    pub(super) fn new(points: Vec<Point>) -> Self {
        let mut lengths = vec![0.0];
        let mut nodes = vec![0.0];
        for i in 1..points.len() {
            lengths.push(lengths[i - 1] + distance(points[i - 1], points[i]));
            let bend = |&next: &Point| angle(between(points[i - 1], points[i]), between(points[i], next));
            if points.get(i + 1).is_none_or(|next| bend(next) > BEND) {
                nodes.push(lengths[i]);
            }
        }
        Self { points, distance: lengths, nodes }
    }

    /// The point at a distance from the start.
    fn at(&self, x: f64) -> Point {
        let i = self.distance.partition_point(|&d| d < x).clamp(1, self.points.len() - 1);
        let (d0, d1) = (self.distance[i - 1], self.distance[i]);
        if d1 > d0 {
            along(self.points[i - 1], self.points[i], ((x - d0) / (d1 - d0)).min(1.0))
        } else {
            self.points[i]
        }
    }

    fn length(&self) -> f64 {
        self.distance[self.points.len() - 1]
    }

    /// Notes where the trail crosses or touches lines, as nodes of the trail; the result is each line and the fraction
    /// along it.
    pub(super) fn meet(&mut self, domain: &Domain, wanted: &Wanted) -> Result<Vec<(usize, f64)>, MeshError> {
        let mut met = Vec::new();
        for i in 1..self.points.len() {
            let (mut a, mut b) = (self.points[i - 1], self.points[i]);
            let length = distance(a, b);
            if i == 1 {
                a = along(b, a, 1.0 + REACH * wanted.at(a)? / length);
            }
            if i + 1 == self.points.len() {
                b = along(a, b, 1.0 + REACH * wanted.at(b)? / distance(a, b));
            }
            for edge in domain.base.get_conflicting_edges_between_points(to_spade(a), to_spade(b)) {
                let Some((line, _)) = domain.base_line(edge.fix()) else { continue };
                let [p, q] = domain.ends(line);
                let denominator = cross(between(p, q), between(a, b));
                let s = cross(between(p, a), between(a, b)) / denominator;
                if s > 0.0 && s < 1.0 {
                    let (start, way) = (self.points[i - 1], between(self.points[i - 1], self.points[i]));
                    let x = dot(between(start, along(p, q, s)), way) / length;
                    self.nodes.push(self.distance[i - 1] + x.clamp(0.0, length));
                    met.push((line, s));
                }
            }
        }
        self.nodes.sort_by(f64::total_cmp);
        self.nodes.dedup();
        Ok(met)
    }

    /// Points along the trail, about as far apart as the wanted size, the nodes among them.
    pub(super) fn stations(&self, wanted: &Wanted) -> Result<Vec<Point>, MeshError> {
        let mut profile = Profile::new(wanted, self.length(), |x| self.at(x))?;
        profile.limit([f64::INFINITY; 2]);
        let mut stations = vec![self.at(0.0)];
        for node in self.nodes.windows(2) {
            stations.extend(profile.cuts(node[0], node[1]).into_iter().map(|x| self.at(x)));
            stations.push(self.at(node[1]));
        }
        Ok(stations)
    }
}

/// The part of a segment that is in a box given by its lowest and highest corner.
fn clip(a: Point, b: Point, bounds: [Point; 2]) -> Option<[Point; 2]> {
    let (mut first, mut last) = (0f64, 1f64);
    for d in 0..2 {
        let way = b[d] - a[d];
        if way == 0.0 {
            if a[d] < bounds[0][d] || a[d] > bounds[1][d] {
                return None;
            }
            continue;
        }
        let (s, t) = ((bounds[0][d] - a[d]) / way, (bounds[1][d] - a[d]) / way);
        first = first.max(s.min(t));
        last = last.min(s.max(t));
    }
    let at = |s: f64| if s == 1.0 { b } else { along(a, b, s) };
    (first < last).then(|| [at(first), at(last)])
}

/// Where a line must have vertices: fractions along it, ascending.
#[derive(Clone)]
pub(super) struct Forced {
    /// Where the line leaves the fan at its first point and enters that at its last; 0 and 1 without fans.
    pub(super) free: [f64; 2],
    /// Where guides meet the line between these, not too close to one another or to these.
    pub(super) met: Vec<f64>,
}

/// Where each line must have vertices because of fans and guides.
pub(super) fn forced(
    domain: &Domain,
    profiles: &[Profile],
    discs: &[Disc],
    met: &[(usize, f64)],
) -> Vec<Forced> {
    let mut forced = vec![Forced { free: [0.0, 1.0], met: Vec::new() }; profiles.len()];
    for disc in discs {
        for (line, starts) in disc.sectors.iter().flat_map(|s| s.lines) {
            let s = disc.radius / domain.length(line);
            forced[line].free[usize::from(!starts)] = if starts { s } else { 1.0 - s };
        }
    }
    for &(line, s) in met {
        forced[line].met.push(s);
    }
    for (line, Forced { free, met }) in forced.iter_mut().enumerate() {
        let length = domain.length(line);
        let room = |s: f64| NEAR * profiles[line].size(s * length) / length;
        let grips = grips_of(domain.statement, line);
        let grips: Vec<f64> = grips.into_iter().filter(|s| free[0] < *s && *s < free[1]).collect();
        // Where the grip on bars begins and ends comes before where guides meet their line.
        met.retain(|s| grips.iter().all(|grip| (grip - s).abs() > room(*s)));
        met.sort_by(f64::total_cmp);
        let mut last = free[0];
        met.retain(|&s| {
            let keep = s - last > room(s) && free[1] - s > room(s);
            if keep {
                last = s;
            }
            keep
        });
        met.extend(grips);
        met.sort_by(f64::total_cmp);
        met.dedup();
    }
    forced
}

/// Where on a line soil begins and ends to hand force to bars along it.
fn grips_of(statement: &Statement, line: usize) -> Vec<f64> {
    let of = |member: &Member| {
        let number = member.path.iter().position(|side| side.line == line)?;
        member.pullout.as_ref()?.get(number).map(|grip| grip.part)
    };
    statement.members.iter().find_map(of).map_or_else(Vec::new, |part| part.to_vec())
}
