//! Ohde's logarithmic spiral (1938) after Terzaghi (1943): a spiral from the tip to the Rankine zone, whose
//! pole lies on the line that bounds that zone (Hong 2001, section 4.1.2.3).
//!
//! Coordinates: plate top at the origin, x ahead, y up, slant length 1. The bounding line dips at
//! `alpha_1 = 45 deg - phi/2 - (beta + omega)/2`, `sin(omega) = sin(beta)/sin(phi)`. The pole O1 is at distance
//! l0 (any sign) from the plate's top along it, the spiral `r = r0 e^(theta tan phi)` runs from the tip b to d1
//! on that line, and f1 is the surface point above d1. All frictional forces on the spiral pass through O1, so
//! the moments about it give the plate's force:
//! plate force x arm = soil weight x arm + Rankine thrust on d1-f1 x arm (+ loads). The least force over l0 is
//! the answer. Instead of l0 the search runs over the spiral's angle theta in (0, pi), which covers all l0.
//!
//! The thesis's printed column has two quirks, kept as a variant for reproduction: the Rankine thrust acts
//! H_d1/3 **below** d1 instead of above, and the spiral is cut into 10 chords.

use std::f64::consts::{FRAC_PI_2, PI};

use soilctl_soil::{Angle, WidthRatio};

use crate::minimise::minimise;
use crate::model::{DirectSlice, FailureSurface, ForceModel, ModelSlice, ValidRange};
use crate::{Case, EarthPressureError, LoadFactors, Prediction};

use super::caquot::Caquot;
use super::chen_liu;

/// Points of the first scan over the spiral's angle.
const SCAN: usize = 24;

/// Ohde's log-spiral model.
#[derive(Debug, Clone, Copy)]
pub struct LogSpiral {
    /// Reproduce the thesis's printed column with its two quirks.
    thesis: bool,
}

impl LogSpiral {
    /// The correct model, with Chen & Liu's active side.
    pub const CORRECT: Self = Self { thesis: false };
    /// The variant behind the thesis's printed column, with Caquot's active side where that is tabulated.
    pub const THESIS: Self = Self { thesis: true };
}

impl ForceModel for LogSpiral {
    fn id(&self) -> &'static str {
        if self.thesis { "log-spiral-thesis" } else { "log-spiral" }
    }

    fn reference(&self) -> &'static str {
        if self.thesis {
            "Ohde 1938 as computed in Hong 2001, Appendix C: up to 23 % too high on the passive side; use \
             log-spiral for anything but reproduction"
        } else {
            "Ohde 1938; Terzaghi 1943; limit equilibrium; active side after Chen & Liu"
        }
    }

    fn valid_range(&self) -> ValidRange {
        ValidRange::closed_form()
    }

    fn has_load_terms(&self, case: &Case) -> bool {
        case.surface_slope.radians() == 0.0
    }

    fn predict(&self, case: &Case) -> Result<Prediction, EarthPressureError> {
        self.valid_range().check(self.id(), case)?;
        let spiral = Spiral::new(case, self.thesis);
        let (theta, _) = spiral.optimum().ok_or_else(|| self.no_spiral(case))?;
        let passive = spiral.factors(theta);
        let (active, note) = self.active(case);
        let mut prediction = Prediction::from_sides(self.id(), case, passive, active)?;
        prediction.notes.extend(note);
        Ok(prediction)
    }

    fn failure_surface(&self, case: &Case) -> Result<Option<FailureSurface>, EarthPressureError> {
        self.valid_range().check(self.id(), case)?;
        let spiral = Spiral::new(case, self.thesis);
        let (theta, _) = spiral.optimum().ok_or_else(|| self.no_spiral(case))?;
        Ok(Some(FailureSurface::from_tip(case, spiral.surface(theta))))
    }

    fn at(
        &self,
        tool_angle: Angle,
        surface_slope: Angle,
        width_ratio: WidthRatio,
    ) -> Result<Box<dyn ModelSlice + '_>, EarthPressureError> {
        DirectSlice::boxed(self, tool_angle, surface_slope, width_ratio)
    }
}

impl LogSpiral {
    /// The log-spiral has no active side of its own.
    fn active(&self, case: &Case) -> (LoadFactors, Option<&'static str>) {
        if !self.thesis {
            return (chen_liu::active(case), Some("active side after Chen & Liu"));
        }
        match Caquot::active(case) {
            Some(weight) => {
                let factors = LoadFactors { weight, ..chen_liu::active(case) };
                (factors, Some("active side after Caquot & Kerisel"))
            }
            None => (
                chen_liu::active(case),
                Some("active side after Chen & Liu: outside Caquot & Kerisel's tabulated range"),
            ),
        }
    }

    fn no_spiral(&self, case: &Case) -> EarthPressureError {
        case.singular(
            self.id(),
            "the plate is flatter than the Rankine zone's boundary, so no spiral fits; use chen",
        )
    }
}

type Point = (f64, f64);

fn cross(a: Point, b: Point) -> f64 {
    a.0 * b.1 - a.1 * b.0
}

fn minus(a: Point, b: Point) -> Point {
    (a.0 - b.0, a.1 - b.1)
}

/// The family of spirals of one case, slant length 1, radians.
struct Spiral {
    alpha: f64,
    beta: f64,
    phi: f64,
    delta: f64,
    /// Dip of the line from the plate's top through the pole to d1.
    dip: f64,
    thesis: bool,
}

/// One member of the family.
struct Member {
    pole: Point,
    tip: Point,
    /// Spiral points from tip to d1; a chord polygon in the thesis's variant.
    r0: f64,
    theta: f64,
    d1: Point,
    f1: Point,
}

impl Spiral {
    fn new(case: &Case, thesis: bool) -> Self {
        let (beta, phi) = (case.slope_below_phi(), case.friction.radians());
        let omega = libm::asin((libm::sin(beta) / libm::sin(phi)).clamp(-1.0, 1.0));
        Self {
            alpha: case.tool_angle.radians(),
            beta,
            phi,
            delta: case.interface.radians(),
            dip: 0.5 * (FRAC_PI_2 - phi - beta - omega),
            thesis,
        }
    }

    fn optimum(&self) -> Option<(f64, f64)> {
        if self.alpha <= self.dip {
            return None;
        }
        minimise(1e-4, PI - 1e-3, SCAN, |theta| {
            let weight = self.weight(&self.member(theta));
            if weight > 0.0 { weight } else { f64::NAN }
        })
    }

    fn member(&self, theta: f64) -> Member {
        let along = self.alpha - self.dip;
        let l0 = libm::cos(along) - libm::sin(along) / libm::tan(theta);
        let line = (libm::cos(self.dip), -libm::sin(self.dip));
        let pole = (l0 * line.0, l0 * line.1);
        let tip = (libm::cos(self.alpha), -libm::sin(self.alpha));
        let r0 = libm::sin(along) / libm::sin(theta);
        let reach = l0 + r0 * libm::exp(theta * libm::tan(self.phi));
        let d1 = (reach * line.0, reach * line.1);
        Member { pole, tip, r0, theta, d1, f1: (d1.0, d1.0 * libm::tan(self.beta)) }
    }

    /// Point of the spiral at angle s from the tip.
    fn on_spiral(&self, m: &Member, s: f64) -> Point {
        let direction = -self.dip - m.theta + s;
        let r = m.r0 * libm::exp(s * libm::tan(self.phi));
        (m.pole.0 + r * libm::cos(direction), m.pole.1 + r * libm::sin(direction))
    }

    /// Weight factor of one spiral, from the moments about its pole; NaN where no Rankine zone is left.
    fn weight(&self, m: &Member) -> f64 {
        let height = m.f1.1 - m.d1.1;
        if m.d1.0 <= 0.0 || height <= 0.0 {
            return f64::NAN;
        }
        let above_d1 = if self.thesis { -height / 3.0 } else { height / 3.0 };
        let zone = 0.5 * self.rankine() * height * height * self.thrust_arm(m, above_d1);
        // Unit weight 1 and slant length 1: the factor is twice the force.
        -2.0 * (self.weight_moment(m) + zone) / self.plate_arm(m, 1.0 / 3.0)
    }

    /// Passive factors of one spiral; surcharge and cohesion press evenly, so theirs act at half the height.
    fn factors(&self, theta: f64) -> LoadFactors {
        let m = self.member(theta);
        let height = m.f1.1 - m.d1.1;
        let (zone, plate) = (height * self.thrust_arm(&m, 0.5 * height), self.plate_arm(&m, 0.5));

        let surface = m.d1.0 / libm::cos(self.beta);
        let middle = (0.5 * m.f1.0, 0.5 * m.f1.1);
        let on_surface = cross(minus(middle, m.pole), (0.0, -surface));
        let surcharge = -(on_surface + self.rankine() / libm::cos(self.beta) * zone) / plate;

        let t = libm::tan(self.phi);
        let along_spiral = -m.r0 * m.r0 * libm::expm1(2.0 * t * m.theta) / (2.0 * t);
        let root_n = libm::tan(FRAC_PI_2 / 2.0 + self.phi / 2.0);
        let cohesion = -(along_spiral + 2.0 * root_n * zone) / plate;

        let down_plate = (libm::cos(self.alpha), -libm::sin(self.alpha));
        let adhesion = -cross(minus((0.0, 0.0), m.pole), down_plate) / plate;
        LoadFactors { weight: self.weight(&m), surcharge, cohesion, adhesion }
    }

    /// Rankine's passive coefficient on a vertical plane, thrust parallel to the surface.
    fn rankine(&self) -> f64 {
        let root = (libm::cos(self.beta).powi(2) - libm::cos(self.phi).powi(2)).max(0.0).sqrt();
        libm::cos(self.beta) * (libm::cos(self.beta) + root) / (libm::cos(self.beta) - root)
    }

    /// Moment about the pole of a unit thrust of the Rankine zone at a height above d1.
    fn thrust_arm(&self, m: &Member, above_d1: f64) -> f64 {
        let push = (-libm::cos(self.beta), -libm::sin(self.beta));
        cross(minus((m.d1.0, m.d1.1 + above_d1), m.pole), push)
    }

    /// Moment about the pole of a unit force of the plate acting at a fraction of the slant length above the tip.
    fn plate_arm(&self, m: &Member, above_tip: f64) -> f64 {
        let point = (m.tip.0 * (1.0 - above_tip), m.tip.1 * (1.0 - above_tip));
        cross(minus(point, m.pole), (libm::sin(self.alpha + self.delta), libm::cos(self.alpha + self.delta)))
    }

    /// Moment about the pole of the weight (unit weight 1, acting down) of the soil between plate, spiral,
    /// d1-f1 and surface: a shoelace sum whose spiral edge is integrated exactly.
    fn weight_moment(&self, m: &Member) -> f64 {
        let triangle = |a: Point, b: Point| {
            let (a, b) = (minus(a, m.pole), minus(b, m.pole));
            0.5 * cross(a, b) * (a.0 + b.0) / 3.0
        };
        let top = (0.0, 0.0);
        let spiral = if self.thesis {
            let chord = |i: usize| self.on_spiral(m, m.theta * i as f64 / 10.0);
            (0..10).map(|i| triangle(chord(i), chord(i + 1))).sum()
        } else {
            // Integral of r^3/3 cos(direction) over the angle.
            let (b, start) = (3.0 * libm::tan(self.phi), -self.dip - m.theta);
            let primitive = |s: f64| {
                let angle = start + s;
                libm::exp(b * s) * (b * libm::cos(angle) + libm::sin(angle)) / (b * b + 1.0)
            };
            m.r0.powi(3) / 3.0 * (primitive(m.theta) - primitive(0.0))
        };
        // First moment of area about the vertical through the pole; a unit weight down turns clockwise.
        -(triangle(top, m.tip) + spiral + triangle(m.d1, m.f1) + triangle(m.f1, top))
    }

    /// Failure surface from the tip at the origin: spiral, then the straight slip line of the Rankine zone.
    fn surface(&self, theta: f64) -> Vec<Point> {
        const CHORDS: usize = 48;
        let m = self.member(theta);
        let mut points: Vec<Point> = (0..=CHORDS)
            .map(|i| minus(self.on_spiral(&m, theta * i as f64 / CHORDS as f64), m.tip))
            .collect();
        // The rising slip line makes 90 deg - phi with the falling one.
        let rise = FRAC_PI_2 - self.phi - self.dip;
        let run = (m.f1.1 - m.d1.1) * libm::cos(self.beta) / libm::sin(rise - self.beta);
        let end = minus((m.d1.0 + run * libm::cos(rise), m.d1.1 + run * libm::sin(rise)), m.tip);
        points.push(end);
        points
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_support::rel;
    use crate::{ChenLiu, Coulomb};
    use proptest::prelude::*;

    #[test]
    fn smooth_vertical_wall_is_rankine_with_every_load() {
        let p = LogSpiral::CORRECT.predict(&Case::level_deg(90.0, 30.0, 0.0)).unwrap().passive.unwrap();
        assert!(rel(p.weight, 3.0) < 1e-6, "{p:?}");
        assert!(rel(p.surcharge, 3.0) < 1e-6, "{p:?}");
        assert!(rel(p.cohesion, 2.0 * 3f64.sqrt()) < 1e-6, "{p:?}");
    }

    #[test]
    fn flat_spirals_tend_to_a_plane() {
        // As the pole goes to minus infinity the spiral becomes a straight line, whose force is a Coulomb
        // wedge's on that line, so it cannot be below Coulomb's least.
        let case = Case::level_deg(80.0, 35.0, 10.0);
        let spiral = Spiral::new(&case, false);
        let flat = spiral.weight(&spiral.member(1e-3));
        assert!(flat > 0.95 * Coulomb.predict(&case).unwrap().passive.unwrap().weight);
    }

    proptest! {
        /// The exact area of the spiral is the limit of ever finer chords.
        #[test]
        fn exact_moment_is_the_limit_of_chords(alpha in 60.0..110.0, phi in 20.0..45.0, beta in -8.0..8.0, theta in 0.2..1.4) {
            let case = Case::from_deg(alpha, beta, phi, 0.5 * phi);
            let spiral = Spiral::new(&case, false);
            let m = spiral.member(theta);
            let n = 2000;
            let mut chords = 0.0;
            for i in 0..n {
                let a = minus(spiral.on_spiral(&m, theta * f64::from(i) / f64::from(n)), m.pole);
                let b = minus(spiral.on_spiral(&m, theta * f64::from(i + 1) / f64::from(n)), m.pole);
                chords += 0.5 * cross(a, b) * (a.0 + b.0) / 3.0;
            }
            let edges = [((0.0, 0.0), m.tip), (m.d1, m.f1), (m.f1, (0.0, 0.0))];
            let rest: f64 = edges.iter().map(|&(a, b)| {
                let (a, b) = (minus(a, m.pole), minus(b, m.pole));
                0.5 * cross(a, b) * (a.0 + b.0) / 3.0
            }).sum();
            prop_assert!((spiral.weight_moment(&m) + chords + rest).abs() < 1e-5 * (1.0 + chords.abs()));
        }

        /// Two methods of different kind agree where both are known to be good (Chen's is an upper bound and
        /// leaves the spiral behind for rough, overhanging plates), with sloping ground too.
        #[test]
        fn close_to_chen(alpha in 75.0..95.0, phi in 25.0..42.0, ratio in 0.0..0.5, beta in -10.0..10.0) {
            let case = Case::from_deg(alpha, beta, phi, ratio * phi);
            let spiral = LogSpiral::CORRECT.predict(&case).unwrap().passive.unwrap().weight;
            let chen = ChenLiu.predict(&case).unwrap().passive.unwrap().weight;
            prop_assert!(rel(spiral, chen) < 0.12, "{spiral} {chen}");
        }
    }

    #[test]
    fn the_surface_ends_on_the_ground() {
        for beta in [-10.0, 0.0, 10.0] {
            let case = Case::from_deg(80.0, beta, 40.0, 25.0);
            let surface = LogSpiral::CORRECT.failure_surface(&case).unwrap().unwrap();
            let (top, end) = (surface.plate_top, surface.points[surface.points.len() - 1]);
            let slope = libm::atan((end.1 - top.1) / (end.0 - top.0)).to_degrees();
            assert!((slope - beta).abs() < 1e-6, "{slope}");
        }
    }
}
