use super::gauges::{Gauges, LocalJet};
use super::given::GivenLines;
use super::loads::{Loads, Station};
use super::surfaces::{AT_REST, Surfaces};
use crate::CertificateError;
use crate::fields::{Jet, LowerField};
use crate::interval::{Interval, Vector};
use crate::problem::{Problem, exists, finite};
use crate::tiling::{Tiling, fraction};

/// Checks that lists have the right lengths, indices point at something, and numbers are finite.
pub(super) fn check_numbers(
    problem: &Problem,
    field: &LowerField,
    runs: usize,
) -> Result<(), CertificateError> {
    let (triangles, line_count) = (field.mesh.triangles.len(), problem.statement.lines.len());
    // There is a first gauge even if nothing is free; further ones are branches.
    let gauges = runs.max(1);
    let enough = if field.gauges.len() < gauges { gauges } else { field.gauges.len() };
    let lengths = [
        ("chains", field.gauges.len(), enough, "run of free or loaded boundary, at least one"),
        ("corners", field.corners.len(), triangles, "triangle"),
        ("slopes", field.slopes.len(), triangles, "triangle"),
        ("lines", field.lines.len(), line_count, "line of the statement"),
    ];
    for (list, found, needed, each) in lengths {
        if found != needed {
            return Err(CertificateError::Length { list, found, needed, each });
        }
    }
    for (i, copies) in field.corners.iter().enumerate() {
        for copy in copies {
            exists(|| format!("triangle {i}"), "vertex copy", *copy, field.copies.len())?;
        }
        for slope in field.slopes[i] {
            finite("slope", || format!("triangle {i}"), slope, "force")?;
        }
    }
    for (i, slope) in field.lines.iter().enumerate() {
        finite("slope", || format!("line {i}"), *slope, "force")?;
    }
    finite("multiplier", || "the field".into(), field.multiplier, "")?;
    finite("far stress", || "the field".into(), field.far_stress, "stress")?;
    for (i, copy) in field.copies.iter().enumerate() {
        let place = || format!("vertex copy {i}");
        exists(place, "vertex", copy.vertex, field.mesh.vertices.len())?;
        let numbers = match copy.jet {
            Jet::Gauge { .. } | Jet::Zero { .. } => [0.0; 3],
            Jet::Free { f, fx, fy, .. } => [f, fx, fy],
            Jet::OneApex { f, turn, .. } => [f, turn, 0.0],
            Jet::ManyApexes { f, .. } | Jet::TwoLines { f } => [f, 0.0, 0.0],
            Jet::OneLine { f, along, .. } => [f, along, 0.0],
            Jet::Kinked { jump, .. } => [jump, 0.0, 0.0],
        };
        for x in numbers {
            finite("value or slope", place, x, "")?;
        }
        let gauge = |gauge| exists(place, "chain", gauge, field.gauges.len());
        match copy.jet {
            Jet::Gauge { gauge: base } | Jet::Free { base, .. } => gauge(base)?,
            Jet::ManyApexes { base, .. } | Jet::Zero { base } => gauge(base)?,
            Jet::OneApex { base, apex, .. } => {
                gauge(base)?;
                exists(place, "vertex copy", apex, field.copies.len())?;
            }
            Jet::OneLine { line, .. } => exists(place, "line", line, line_count)?,
            Jet::TwoLines { .. } => {}
            Jet::Kinked { copy, line, .. } => {
                exists(place, "vertex copy", copy, field.copies.len())?;
                exists(place, "line", line, line_count)?;
            }
        }
    }
    Ok(())
}

/// Says what values and slopes the numbers of the field mean.
pub(super) struct Maker<'a> {
    pub(super) problem: &'a Problem<'a>,
    pub(super) tiling: &'a Tiling<'a>,
    pub(super) field: &'a LowerField,
    pub(super) loads: &'a Loads,
    pub(super) stations: &'a [Option<Station>],
    pub(super) gauges: &'a Gauges<'a>,
    pub(super) given: &'a GivenLines<'a>,
    pub(super) surfaces: &'a Surfaces<'a>,
}

const UPWARDS: Vector = Vector { x: Interval::ZERO, y: Interval::ONE };

fn bad(copy: usize, problem: &'static str) -> CertificateError {
    CertificateError::BadField { place: format!("vertex copy {copy}"), problem }
}

impl Maker<'_> {
    /// All of them.
    pub(super) fn jets(&self) -> Result<Vec<LocalJet>, CertificateError> {
        (0..self.field.copies.len()).map(|copy| self.jet(copy)).collect()
    }

    fn jet(&self, copy: usize) -> Result<LocalJet, CertificateError> {
        let surface = self.surfaces.of_copy(copy);
        let (base, f, slopes) = match self.field.copies[copy].jet {
            Jet::Gauge { gauge: base } => {
                let (f, slopes) =
                    self.stations[copy].map_or((Interval::ZERO, Vector::ZERO), |at| self.loads.jet(at));
                return Ok(LocalJet { base, surface: AT_REST, f, slopes });
            }
            Jet::Zero { base } => (base, 0.0, Vector::ZERO),
            Jet::Free { base, f, fx, fy } => (base, f, Vector::point([fx, fy])),
            Jet::OneApex { base, apex, f, turn } => (base, f, self.one_apex(copy, base, apex, [f, turn])?),
            Jet::ManyApexes { base, f } => {
                let p = self.position(copy);
                let height = p.y - Interval::point(self.problem.statement.datum);
                let away_from_side = self.surfaces.away_from_side(surface, p);
                let (n, away) =
                    away_from_side.map_or((UPWARDS, height), |(t, e)| (t.turned(), e * t.square()));
                if !away.is_not_zero() {
                    return Err(bad(copy, "it is next to a surface and itself not away from it"));
                }
                (base, f, n * (Interval::point(3.0) * Interval::point(f) / away))
            }
            Jet::OneLine { line, f, along } => {
                let n = self.problem.direction(line).turned();
                let across = self.across(copy, line, 0)?;
                // `-n` turned left is `(n_y, -n_x)`.
                (0, f, n * (across / n.square()) - n.turned() * Interval::point(along))
            }
            Jet::TwoLines { f } => (0, f, self.two_lines(copy)?),
            Jet::Kinked { copy: other, line, jump } => return self.kinked(copy, other, line, jump),
        };
        Ok(LocalJet { base, surface, f: f.into(), slopes })
    }

    /// Beyond the jet on the other side of a member.
    fn kinked(
        &self,
        copy: usize,
        other: usize,
        line: usize,
        jump: f64,
    ) -> Result<LocalJet, CertificateError> {
        let across = self.field.copies[other];
        if matches!(across.jet, Jet::Kinked { .. }) || across.vertex != self.field.copies[copy].vertex {
            return Err(bad(copy, "it must depend on a copy of the same vertex that depends on no other"));
        }
        let Some(piece) = self.problem.piece(line) else {
            return Err(bad(copy, "it depends on a line that is no member"));
        };
        // All lines of a member are proven to be in one line.
        let mut path = self.problem.statement.members[piece.member].path.iter();
        if !path.any(|side| self.fraction(copy, side.line).is_ok()) {
            return Err(bad(copy, "not on the member that it depends on"));
        }
        let jet = self.jet(other)?;
        let n = self.problem.direction(line).turned();
        Ok(LocalJet { slopes: jet.slopes + n * Interval::point(jump), ..jet })
    }

    fn position(&self, copy: usize) -> Vector {
        self.tiling.position(self.field.copies[copy].vertex)
    }

    /// The fraction of a line at which a vertex copy is.
    fn fraction(&self, copy: usize, line: usize) -> Result<f64, CertificateError> {
        let place = self.field.mesh.vertices[self.field.copies[copy].vertex].place;
        fraction(self.problem, place, line).ok_or_else(|| bad(copy, "not on the line that it depends on"))
    }

    /// The slope across a line at a vertex copy.
    fn across(&self, copy: usize, line: usize, base: usize) -> Result<Interval, CertificateError> {
        if !self.given.is_on(line) {
            return Err(bad(copy, "depends on a line along which the shear stress is not given"));
        }
        let s = Interval::point(self.fraction(copy, line)?);
        Ok(self.given.across(self.gauges, line, s, base))
    }

    /// Slopes such that the value and a third of the slope towards the apex add up to zero.
    fn one_apex(
        &self,
        copy: usize,
        base: usize,
        apex: usize,
        [f, turn]: [f64; 2],
    ) -> Result<Vector, CertificateError> {
        let along = Interval::point(3.0) * Interval::point(f);
        let lines = self.given.at(copy);
        if let Some(line) =
            lines.iter().copied().find(|l| self.fraction(apex, *l).is_ok()).or(lines.first().copied())
        {
            // Then `r = s t`, and the slope across is that of the line.
            let s = Interval::point(self.fraction(copy, line)?) - Interval::point(self.fraction(apex, line)?);
            if !s.is_not_zero() {
                return Err(bad(copy, "it is next to itself"));
            }
            let t = self.problem.direction(line);
            let (_, less) = self.surfaces.jet(self.surfaces.of_copy(copy), self.position(copy));
            let across = self.across(copy, line, base)?;
            let across = if less.is_zero() { across } else { across - less.dot(t.turned()) };
            return Ok(t * (along / (s * t.square())) + t.turned() * (across / t.square()));
        }
        let r = self.position(copy) - self.position(apex);
        if !r.square().is_positive() {
            return Err(bad(copy, "it is not proven to be away from the apex next to it"));
        }
        Ok(r * (along / r.square()) + r.turned() * Interval::point(turn))
    }

    /// Slopes where two lines of given shear meet.
    fn two_lines(&self, copy: usize) -> Result<Vector, CertificateError> {
        let Some([a, b]) = self.given.two_at(copy) else {
            return Err(bad(copy, "there are no two lines of given shear here"));
        };
        let [m, n] = [a, b].map(|line| self.problem.direction(line).turned());
        let (over_m, over_n) = (self.across(copy, a, 0)?, self.across(copy, b, 0)?);
        let area = m.cross(n);
        if !area.is_not_zero() {
            let (place, what) = (format!("vertex copy {copy}"), "parallel lines of given shear that meet");
            return Err(CertificateError::NotCovered { place, what });
        }
        // The quarter turn of either has no part along itself.
        Ok((m.turned() * over_n - n.turned() * over_m) * (Interval::ONE / area))
    }
}
