//! Lines along which the shear stress is given: smooth ones, faces without friction, far ones.
//!
//! With `t = to - from` and `n` that turned left, the derivative of `g = grad f . n` along `t` is the shear stress
//! `t . stress n` of the stress function with its sign changed. The total shear stress vanishes if `g' = t . ref n`; it is
//! that of the reference if `g' = 0`. The reference is linear, so `g` is a quadratic polynomial that is known up to a
//! constant. The slope of a cubic across an edge is quadratic too: it equals `g` all along an edge if it does at both
//! ends and in the middle.
//!
//! Joined lines are level or vertical. There column parts add nothing to `t . ref n`, so the slope across, divided by the
//! length of `n` with its sign, is one polynomial for all of them.

use super::ends;
use super::gauges::{Gauges, LocalJet};
use super::joined::{Joined, joined};
use super::loads::Station;
use super::references::ReferenceStresses;
use super::surfaces::AT_REST;
use crate::CertificateError;
use crate::fields::{Jet, LowerField};
use crate::interval::{Interval, Vector};
use crate::mesh::Side;
use crate::problem::Problem;
use crate::tiling::{Beyond, Tiling, fraction};

fn not_the_one(copy: usize, line: usize) -> CertificateError {
    let place = format!("vertex copy {copy} on line {line}");
    let problem = "the slope across is not proven to be the one of this line of given shear";
    CertificateError::BadField { place, problem }
}

/// Where the slope across joined lines is known.
#[derive(Debug, Clone, Copy)]
struct Origin {
    /// A line and a fraction of it.
    line: usize,
    at: f64,
    known: Known,
}

#[derive(Debug, Clone, Copy)]
enum Known {
    /// The slopes are those of this vertex copy, which belongs to a gauge: those of the gauge and, beyond it, of its loads.
    Copy { station: Option<Station>, gauge: usize, beyond: Vector },
    /// The slope across the line.
    Slope(f64),
}

/// One line.
#[derive(Debug, Clone, Copy)]
struct GivenLine {
    joined: Joined,
    /// A region beside it.
    region: usize,
}

/// All lines of given shear.
pub(super) struct GivenLines<'a> {
    problem: &'a Problem<'a>,
    references: &'a ReferenceStresses,
    lines: Vec<Option<GivenLine>>,
    /// For each line that is the first of joined ones, where their slope is known.
    origins: Vec<Origin>,
    /// For each vertex copy, such lines that have an edge with this copy at an end.
    at: Vec<Vec<usize>>,
}

impl<'a> GivenLines<'a> {
    pub(super) fn new(
        problem: &'a Problem<'a>,
        references: &'a ReferenceStresses,
        tiling: &Tiling,
        field: &LowerField,
        stations: &[Option<Station>],
        slopes_of_loads: impl Fn(Station) -> Vector,
    ) -> Result<Self, CertificateError> {
        let joined = joined(problem)?;
        let start = |(line, slope): (usize, &f64)| Origin { line, at: 0.0, known: Known::Slope(*slope) };
        let mut given = Self {
            problem,
            references,
            lines: vec![None; joined.len()],
            origins: field.lines.iter().enumerate().map(start).collect(),
            at: vec![Vec::new(); field.copies.len()],
        };
        for side in tiling.sides() {
            let Beyond::Boundary(on, condition) = tiling.beyond(side) else { continue };
            let line = on.side.line;
            let Some(joined) = joined[line].filter(|_| condition.shear_is_given()) else { continue };
            given.note_line(line, joined, tiling.region(side.triangle))?;
            for (copy, at) in ends(field, side).into_iter().zip([on.start, on.end]) {
                let origin = &mut given.origins[joined.first];
                if let (Known::Slope(_), Jet::Gauge { gauge }) = (origin.known, field.copies[copy].jet) {
                    let station = stations[copy];
                    let beyond = station.map_or(Vector::ZERO, &slopes_of_loads);
                    *origin = Origin { line, at, known: Known::Copy { station, gauge, beyond } };
                }
                given.note_copy(copy, line, side)?;
            }
        }
        Ok(given)
    }

    fn note_line(&mut self, line: usize, joined: Joined, region: usize) -> Result<(), CertificateError> {
        let other = self.lines[line].get_or_insert(GivenLine { joined, region }).region;
        let t = self.problem.direction(line);
        if joined.far || t.x.is_zero() || t.y.is_zero() || self.references.same(other, region) {
            return Ok(());
        }
        let what = "a sloping line of given shear between soils of different unit weight";
        Err(CertificateError::NotCovered { place: format!("line {line}"), what })
    }

    fn note_copy(&mut self, copy: usize, line: usize, side: Side) -> Result<(), CertificateError> {
        if self.at[copy].contains(&line) {
            return Ok(());
        }
        self.at[copy].push(line);
        let mut firsts: Vec<Option<usize>> = self.at[copy].iter().map(|l| self.first(*l)).collect();
        firsts.sort_unstable();
        firsts.dedup();
        if firsts.len() <= 2 {
            return Ok(());
        }
        let what = "more than two lines of given shear that meet in one piece of soil";
        Err(CertificateError::NotCovered { place: side.to_string(), what })
    }

    fn first(&self, line: usize) -> Option<usize> {
        self.lines.get(line).copied().flatten().map(|given| given.joined.first)
    }

    /// Lines of given shear at a vertex copy.
    pub(super) fn at(&self, copy: usize) -> &[usize] {
        &self.at[copy]
    }

    /// Two of them that are not joined.
    pub(super) fn two_at(&self, copy: usize) -> Option<[usize; 2]> {
        let a = *self.at[copy].first()?;
        let b = self.at[copy].iter().find(|b| self.first(**b) != self.first(a))?;
        Some([a, *b])
    }

    /// Whether a line is one of given shear.
    pub(super) fn is_on(&self, line: usize) -> bool {
        self.first(line).is_some()
    }

    /// `t . ref n` where the total shear stress is zero.
    fn rate(&self, given: GivenLine, line: usize, s: Interval) -> Interval {
        if given.joined.far { Interval::ZERO } else { self.shear(given, line, s) }
    }

    /// `t . ref n`.
    fn shear(&self, given: GivenLine, line: usize, s: Interval) -> Interval {
        let t = self.problem.direction(line);
        self.references.of(given.region).shear(self.problem.start(line) + t * s, t)
    }

    /// The slope across a line at the fraction `s`, beyond that of the gauge `base`. Any number if the line is not one of
    /// given shear.
    pub(super) fn across(&self, gauges: &Gauges, line: usize, s: Interval, base: usize) -> Interval {
        let Some(given) = self.lines.get(line).copied().flatten() else { return Interval::point(f64::NAN) };
        let origin = self.origins[given.joined.first];
        let t = self.problem.direction(line);
        // The origin, in fractions of this line, and the length of this line in those of the origin's.
        let (at, length) = if origin.line == line {
            (Interval::point(origin.at), Interval::ONE)
        } else {
            let u = self.problem.direction(origin.line);
            let place = self.problem.start(origin.line) + u * Interval::point(origin.at);
            ((place - self.problem.start(line)).dot(t) / t.square(), t.dot(u) / u.square())
        };
        let known = match origin.known {
            Known::Copy { gauge, beyond, .. } => gauges.across(gauge, base, line) + beyond.dot(t.turned()),
            Known::Slope(slope) => Interval::point(slope) * length + gauges.across(0, base, line),
        };
        // The mean of a linear function over an interval is that of its ends.
        known + (s - at) * (self.rate(given, line, at) + self.rate(given, line, s)).half()
    }

    /// Checks that at the ends of all edges on such lines the slopes across are those of the lines, exactly.
    pub(super) fn check(
        &self,
        field: &LowerField,
        gauges: &Gauges,
        stations: &[Option<Station>],
        apexes: &[bool],
        jets: &[LocalJet],
        is_level: impl Fn(usize, Option<Station>) -> bool,
    ) -> Result<(), CertificateError> {
        for (copy, lines) in self.at.iter().enumerate() {
            for line in lines {
                let Some(given) = self.lines[*line] else { continue };
                let vertex = field.mesh.vertices[field.copies[copy].vertex].place;
                let s = Interval::point(fraction(self.problem, vertex, *line).map_or(f64::NAN, |s| s));
                let zero = |base| self.across(gauges, *line, s, base).is_zero();
                let n = self.problem.direction(*line).turned();
                let holds = match field.copies[copy].jet {
                    Jet::Gauge { gauge } => {
                        let is_origin = match self.origins[given.joined.first].known {
                            Known::Copy { station, gauge: known, .. } => {
                                known == gauge && station.is_some() && station == stations[copy]
                            }
                            Known::Slope(_) => false,
                        };
                        is_origin || (zero(gauge) && jets[copy].slopes.dot(n).is_zero())
                    }
                    // Beyond the polynomial, their slopes are vertical; and its slope along x is that of the gauge, where the line
                    // meets the surface.
                    Jet::Zero { base } | Jet::ManyApexes { base, .. } if jets[copy].surface != AT_REST => {
                        let origin = self.origins[given.joined.first].known;
                        let Known::Copy { station, gauge, .. } = origin else {
                            return Err(not_the_one(copy, *line));
                        };
                        n.y.is_zero() && gauge == base && is_level(jets[copy].surface, station)
                    }
                    Jet::Zero { base } => zero(base),
                    // Their slopes are vertical.
                    Jet::ManyApexes { base, .. } => n.y.is_zero() && zero(base),
                    Jet::OneLine { line: along, .. } => self.first(along) == Some(given.joined.first),
                    // Built from all lines here, of which there are as many as needed.
                    Jet::TwoLines { .. } => true,
                    Jet::OneApex { .. } => self.two_at(copy).is_none(),
                    // The other copy is looked at by itself.
                    Jet::Kinked { copy: other, line: along, jump } => {
                        let first = Some(given.joined.first);
                        let has_it = self.at[other].iter().any(|l| self.first(*l) == first);
                        let d = self.problem.direction(along);
                        let t = self.problem.direction(*line);
                        let is_square = (d.x.is_zero() && t.y.is_zero()) || (d.y.is_zero() && t.x.is_zero());
                        has_it && (jump == 0.0 || is_square)
                    }
                    Jet::Free { .. } => false,
                };
                if !holds {
                    return Err(not_the_one(copy, *line));
                }
                // The stress vanishes at an apex, and far lines bear the shear stress of the reference.
                if apexes[copy] && given.joined.far && !self.shear(given, *line, s).is_zero() {
                    let (place, what) =
                        (format!("line {line}"), "shear stress of the reference at a surface");
                    return Err(CertificateError::NotCovered { place, what });
                }
            }
        }
        Ok(())
    }
}
