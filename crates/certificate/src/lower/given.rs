//! Lines along which the shear stress is given: smooth ones, faces without friction, far ones.
//!
//! With `t = to - from` and `n` that turned left, the derivative of `g = grad f . n` along `t` is the shear stress
//! `t . stress n` of the stress function with its sign changed. The total shear stress vanishes if `g' = t . ref n`; it is
//! that of the reference if `g' = 0`. The reference is linear, so `g` is a quadratic polynomial that is known up to a
//! constant. The slope of a cubic across an edge is quadratic too: it equals `g` all along an edge if it does at both
//! ends and in the middle.

use super::chains::Chains;
use super::ends;
use crate::CertificateError;
use crate::fields::{Jet, LowerField};
use crate::interval::Interval;
use crate::problem::{Problem, Reference};
use crate::statement::Condition;
use crate::tiling::{Beyond, Side, Tiling, fraction};

/// Where the slope across a line is known.
#[derive(Debug, Clone, Copy)]
enum Origin {
    /// It is that of a chain at this fraction of the line.
    Chain { chain: usize, at: f64 },
    /// It is given at the start of the line.
    Start(f64),
}

/// The slope across one line.
#[derive(Debug, Clone, Copy)]
struct GivenLine {
    origin: Origin,
    /// Its derivative at the start and the end of the line.
    rate: [Interval; 2],
    /// Whether the line is far.
    far: bool,
}

/// All lines of given shear.
pub(super) struct GivenLines {
    lines: Vec<Option<GivenLine>>,
    /// For each vertex copy, such lines that have an edge with this copy at an end.
    at: Vec<[Option<usize>; 2]>,
}

impl GivenLines {
    pub(super) fn new(
        problem: &Problem,
        tiling: &Tiling,
        field: &LowerField,
        reference: &Reference,
    ) -> Result<Self, CertificateError> {
        let mut lines: Vec<Option<GivenLine>> = vec![None; problem.statement.lines.len()];
        let mut at = vec![[None; 2]; field.copies.len()];
        for side in tiling.sides() {
            let Beyond::Boundary(on, condition) = tiling.beyond(side) else { continue };
            if !condition.shear_is_given() {
                continue;
            }
            let line = on.side.line;
            let far = condition == Condition::Far;
            let given = lines[line].get_or_insert_with(|| GivenLine {
                origin: Origin::Start(field.lines[line]),
                rate: if far { [Interval::ZERO; 2] } else { rates(problem, reference, line) },
                far,
            });
            if given.far != far {
                let problem = "far on one side and a boundary on the other";
                return Err(CertificateError::BadStatement { place: format!("line {line}"), problem });
            }
            for (copy, s) in ends(field, side).into_iter().zip([on.start, on.end]) {
                if let (Origin::Start(_), Jet::Chain { chain }) = (given.origin, field.copies[copy].jet) {
                    given.origin = Origin::Chain { chain, at: s };
                }
                note(&mut at[copy], line, side)?;
            }
        }
        Ok(Self { lines, at })
    }

    /// Lines of given shear at a vertex copy.
    pub(super) fn at(&self, copy: usize) -> [Option<usize>; 2] {
        self.at[copy]
    }

    /// Whether a line is one of given shear.
    pub(super) fn is_on(&self, line: usize) -> bool {
        self.lines.get(line).is_some_and(Option::is_some)
    }

    /// The slope across a line at the fraction `s`, beyond that of the chain `base`. Any number if the line is not one of
    /// given shear.
    pub(super) fn across(&self, chains: &Chains, line: usize, s: Interval, base: usize) -> Interval {
        let Some(given) = self.lines[line] else { return Interval::point(f64::NAN) };
        let (known, origin) = match given.origin {
            Origin::Chain { chain, at } => (chains.across(chain, base, line), Interval::point(at)),
            Origin::Start(slope) => (Interval::point(slope) + chains.across(0, base, line), Interval::ZERO),
        };
        let rate = |s: Interval| given.rate[0] * (Interval::ONE - s) + given.rate[1] * s;
        // The mean of a linear function over an interval is that of its ends.
        known + (s - origin) * (rate(origin) + rate(s)).half()
    }

    /// Checks that at the ends of all edges on such lines the slopes across are those of the lines, exactly.
    pub(super) fn check(
        &self,
        problem: &Problem,
        field: &LowerField,
        chains: &Chains,
    ) -> Result<(), CertificateError> {
        for (copy, lines) in self.at.iter().enumerate() {
            for line in lines.iter().flatten() {
                let place = field.mesh.vertices[field.copies[copy].vertex].place;
                let same = |base| {
                    let s = fraction(problem, place, *line).map_or(f64::NAN, |s| s);
                    self.across(chains, *line, Interval::point(s), base).is_zero()
                };
                let holds = match field.copies[copy].jet {
                    Jet::Chain { chain: base } | Jet::Zero { base } => same(base),
                    // Their slopes are vertical.
                    Jet::ManyApexes { base, .. } => problem.direction(*line).x.is_zero() && same(base),
                    Jet::OneLine { line: along, .. } => along == *line,
                    // Built from all lines here, of which there are as many as needed.
                    Jet::TwoLines { .. } => true,
                    Jet::OneApex { .. } => lines[1].is_none(),
                    Jet::Free { .. } => false,
                };
                if !holds {
                    let place = format!("vertex copy {copy} on line {line}");
                    let problem = "the slope across is not proven to be the one of this line of given shear";
                    return Err(CertificateError::BadField { place, problem });
                }
            }
        }
        Ok(())
    }
}

/// `t . ref n` at both ends of a line.
fn rates(problem: &Problem, reference: &Reference, line: usize) -> [Interval; 2] {
    let t = problem.direction(line);
    let ends = problem.statement.lines[line];
    [ends.from, ends.to].map(|p| {
        let y = Interval::point(problem.statement.points[p][1]);
        reference.shear(y, t)
    })
}

fn note(at: &mut [Option<usize>; 2], line: usize, side: Side) -> Result<(), CertificateError> {
    for slot in at.iter_mut() {
        if slot.is_none_or(|l| l == line) {
            *slot = Some(line);
            return Ok(());
        }
    }
    let what = "more than two lines of given shear that meet in one piece of soil";
    Err(CertificateError::NotCovered { place: side.to_string(), what })
}
