//! Strength that grows less and less with pressure, as straight lines.
//!
//! Chords of a curve are nowhere above it and tangents nowhere below. Both lie between knots whose distances from the curve's tip grow by
//! one ratio, so that what is between chord and tangent is about the same part of the strength everywhere. Beyond the greatest stress that
//! is looked at the inner strength does not grow, and the outer one grows as it did there.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_certificate::{Envelope, StrengthLine};

use super::check::{Range, STRESS, number};
use super::error::DescriptionError;
use super::input::{Aim, Description, SoilEntry};
use super::parts::{Kind, Profile};

/// How much of the strength is between a curve's chords and tangents, on average.
const BETWEEN: f64 = 0.008;
/// The first knot's distance from the tip, as a part of the greatest stress.
const FIRST: f64 = 3e-3;
/// Factors on loads, and forces on structures, are not known before: stresses may be so many times those of the weight.
const UNKNOWN_LOAD: f64 = 30.0;
/// Lines are moved outwards by this part of the strength, more than what is rounded here and where they are proven to be in order.
const ROUNDING: f64 = 1e-10;
/// Slopes that differ by less are one.
const SAME_SLOPE: f64 = 1e-9;

/// How the shear strength of a soil grows with the effective normal stress. Stresses are in kPa.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
pub enum StrengthLaw {
    /// Through points, straight between them; before the first and beyond the last as between the nearest two.
    Points {
        /// Normal stress and shear strength, at least two; both grow, and the slope does not.
        points_kpa: Vec<[f64; 2]>,
    },
    /// `factor (sigma + tension_kpa)^exponent`.
    Power {
        /// The shear strength in kPa where `sigma + tension_kpa` is 1 kPa: 0.01 to 1e4.
        factor: f64,
        /// 0.3 to 0.999.
        exponent: f64,
        /// The tension at which there is no strength left.
        #[serde(default, skip_serializing_if = "super::parts::is_zero")]
        tension_kpa: f64,
        /// The normal stress up to which the curve is followed; a multiple of what the weight and the loads make if it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        up_to_kpa: Option<f64>,
    },
    /// `sigma tan(phi)` with a friction angle that falls with the logarithm of stress, `phi_deg - slope log10(sigma / reference)`, and is at most
    /// `greatest_phi_deg`: sand, as estimates with a law of stress tell it. It is followed down to a third of `phi_deg`; beyond, strength does not fall.
    FrictionLaw {
        /// Friction angle in degrees at the reference stress, 15 to 69.9.
        phi_deg: f64,
        /// Fall of the friction angle in degrees a decade of stress, 0.1 to 8.
        slope_deg_per_decade: f64,
        /// The reference, 0.001 to 1e6 kPa.
        reference_kpa: f64,
        /// Friction angle in degrees where stress is small; from `phi_deg` to 69.9.
        #[serde(default = "greatest_phi_deg")]
        greatest_phi_deg: f64,
        /// The normal stress up to which the curve is followed; a multiple of what the weight and the loads make if it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        up_to_kpa: Option<f64>,
    },
    /// Rock after Hoek, Carranza-Torres and Corkum (2002): `sigma_1 = sigma_3 + ucs (m_b sigma_3/ucs + s)^a`.
    HoekBrown {
        /// Uniaxial compressive strength of the intact rock, 0.01 to 1000 MPa.
        ucs_mpa: f64,
        /// Geological strength index, 5 to 100.
        gsi: f64,
        /// The constant of the intact rock, 1 to 50.
        mi: f64,
        /// Disturbance factor, 0 to 1.
        #[serde(default, skip_serializing_if = "super::parts::is_zero")]
        disturbance: f64,
        /// The least principal stress up to which the curve is followed; a multiple of what the weight and the loads make if it is left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        up_to_kpa: Option<f64>,
    },
}

/// The part of its friction down to which a law of stress is followed.
const LEFT: f64 = 1.0 / 3.0;

/// Few sands have more, at any stress.
pub(crate) const fn greatest_phi_deg() -> f64 {
    55.0
}

impl fmt::Display for StrengthLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Points { points_kpa } => {
                let [first, last] = [points_kpa.first(), points_kpa.last()].map(|p| p.map_or(0.0, |p| p[0]));
                write!(f, "strength through {} points from {first} to {last} kPa", points_kpa.len())
            }
            Self::Power { factor, exponent, tension_kpa, .. } if *tension_kpa == 0.0 => {
                write!(f, "strength {factor} σ^{exponent} kPa")
            }
            Self::Power { factor, exponent, tension_kpa, .. } => {
                write!(f, "strength {factor} (σ + {tension_kpa})^{exponent} kPa")
            }
            Self::FrictionLaw { phi_deg, slope_deg_per_decade, reference_kpa, greatest_phi_deg, .. } => {
                write!(
                    f,
                    "phi {phi_deg} deg at {reference_kpa} kPa, less by {slope_deg_per_decade} deg a decade, at most {greatest_phi_deg} deg"
                )
            }
            Self::HoekBrown { ucs_mpa, gsi, mi, disturbance, .. } => {
                write!(f, "Hoek-Brown, UCS {ucs_mpa} MPa, GSI {gsi}, mi {mi}, D {disturbance}")
            }
        }
    }
}

/// A strength as lines: friction angle in degrees and cohesion in kPa, steepest first.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Lines {
    pub(crate) inside: Vec<StrengthLine>,
    /// None if it is the inner one.
    pub(crate) outside: Vec<StrengthLine>,
}

impl Lines {
    /// The friction angle where pressure is greatest.
    pub(super) fn flattest_deg(&self) -> f64 {
        self.outside.last().or(self.inside.last()).map_or(0.0, |line| line.phi_deg)
    }

    /// With strength multiplied by a factor.
    fn times(mut self, factor: f64) -> Self {
        if factor != 1.0 {
            for line in self.inside.iter_mut().chain(&mut self.outside) {
                line.phi_deg = (factor * line.phi_deg.to_radians().tan()).atan().to_degrees();
                line.cohesion *= factor;
            }
        }
        self
    }

    /// The lines beside the first, in another unit of stress.
    pub(crate) fn envelope(&self, stress: impl Fn(f64) -> f64) -> Option<Envelope> {
        let scaled = |lines: &[StrengthLine]| {
            lines.iter().map(|l| StrengthLine { cohesion: stress(l.cohesion), ..*l }).collect::<Vec<_>>()
        };
        let envelope = Envelope { inside: scaled(self.inside.get(1..)?), outside: scaled(&self.outside) };
        (!envelope.inside.is_empty()).then_some(envelope)
    }
}

/// A place of a curved envelope: effective normal stress, shear strength, and how that grows.
struct At {
    normal: f64,
    shear: f64,
    slope: f64,
}

/// A concave envelope, by some measure of pressure.
struct Curve<'a> {
    /// About the exponent.
    exponent: f64,
    tip: f64,
    up_to: f64,
    /// Up to here from the tip it is straight.
    straight_to: f64,
    at: &'a dyn Fn(f64) -> At,
}

impl Curve<'_> {
    fn lines(&self) -> Lines {
        let reach = self.up_to - self.tip;
        let first = FIRST.max((self.straight_to - self.tip) / reach).min(0.5);
        // Between knots whose distances from the tip have the ratio `exp(l)`, a power `x^b` is at most `b (1 - b) l^2/8` above its chord.
        let log_ratio = (8.0 * BETWEEN / (self.exponent * (1.0 - self.exponent))).sqrt();
        let chords = 1 + (-first.ln() / log_ratio).ceil() as i32;
        let knot = |i: i32| {
            let power = f64::from(chords - i) / f64::from(chords - 1);
            if i == 0 { self.tip } else { self.tip + reach * first.powf(power) }
        };
        let times = |part: f64, slope: f64, cohesion: f64| of_slope(part * slope, part * cohesion);
        let [less, more] = [1.0 - ROUNDING, 1.0 + ROUNDING];
        let chord = |i: i32| {
            let [a, b] = [knot(i), knot(i + 1)].map(self.at);
            let slope = (b.shear - a.shear) / (b.normal - a.normal);
            times(less, slope, a.shear - slope * a.normal)
        };
        let tangent = |measure: f64| {
            let At { normal, shear, slope } = (self.at)(measure);
            times(more, slope, shear - slope * normal)
        };
        let between = |i: i32| {
            let [a, b] = [knot(i), knot(i + 1)].map(|x| x - self.tip);
            self.tip + if i == 0 { 0.25 * b } else { (a * b).sqrt() }
        };
        let level = times(less, 0.0, (self.at)(self.up_to).shear);
        let mut lines = Lines {
            inside: (0..chords).map(chord).chain([level]).collect(),
            outside: (0..chords).map(|i| tangent(between(i))).chain([tangent(self.up_to)]).collect(),
        };
        // What is straight is one line.
        for side in [&mut lines.inside, &mut lines.outside] {
            side.dedup_by(|next, line| (next.phi_deg - line.phi_deg).abs() < SAME_SLOPE);
        }
        lines
    }
}

fn of_slope(slope: f64, cohesion: f64) -> StrengthLine {
    StrengthLine { phi_deg: slope.atan().to_degrees(), cohesion }
}

impl StrengthLaw {
    pub(super) fn check(&self, entry: &str) -> Result<(), DescriptionError> {
        let wrong = |problem: &str| Err(DescriptionError::entry(entry, problem));
        let limit = |stress: Option<f64>| {
            let above = Range { low: 1e-3, high: 1e9, words: "0.001 to 1e9 kPa" };
            stress.map_or(Ok(()), |stress| number(entry, "strength.up_to_kpa", stress, above))
        };
        match self {
            Self::Points { points_kpa: points } => {
                for p in points {
                    number(entry, "strength.points_kpa", p[0], STRESS)?;
                    number(entry, "strength.points_kpa", p[1], STRESS)?;
                }
                if points.len() < 2 {
                    return wrong("strength.points_kpa has fewer than two points");
                }
                if !points.windows(2).all(|p| p[0][0] < p[1][0] && p[0][1] < p[1][1]) {
                    return wrong(
                        "normal stress and strength must grow from one of strength.points_kpa to the next",
                    );
                }
                let slopes: Vec<f64> = slopes(points).collect();
                if slopes.windows(2).any(|two| two[1] > two[0] + SAME_SLOPE) {
                    return wrong(
                        "the slope between strength.points_kpa must not grow; leave out points that lie below",
                    );
                }
                if points[0][1] < slopes[0] * points[0][0] - SAME_SLOPE {
                    return wrong(
                        "the first two of strength.points_kpa lead to a strength below zero at no stress; begin at 0 kPa",
                    );
                }
                Ok(())
            }
            Self::Power { factor, exponent, tension_kpa, up_to_kpa } => {
                number(
                    entry,
                    "strength.factor",
                    *factor,
                    Range { low: 0.01, high: 1e4, words: "0.01 to 1e4" },
                )?;
                let exponents =
                    Range { low: 0.3, high: 0.999, words: "0.3 to 0.999; a straight line has phi_deg" };
                number(entry, "strength.exponent", *exponent, exponents)?;
                number(entry, "strength.tension_kpa", *tension_kpa, STRESS)?;
                limit(*up_to_kpa)
            }
            Self::FrictionLaw {
                phi_deg,
                slope_deg_per_decade,
                reference_kpa,
                greatest_phi_deg,
                up_to_kpa,
            } => {
                let friction = Range { low: 15.0, high: 69.9, words: "15 to 69.9 deg" };
                number(entry, "strength.phi_deg", *phi_deg, friction)?;
                let slopes = Range { low: 0.1, high: 8.0, words: "0.1 to 8 deg a decade" };
                number(entry, "strength.slope_deg_per_decade", *slope_deg_per_decade, slopes)?;
                let stresses = Range { low: 1e-3, high: 1e6, words: "0.001 to 1e6 kPa" };
                number(entry, "strength.reference_kpa", *reference_kpa, stresses)?;
                let most = Range { low: *phi_deg, high: 69.9, words: "from strength.phi_deg to 69.9 deg" };
                number(entry, "strength.greatest_phi_deg", *greatest_phi_deg, most)?;
                limit(*up_to_kpa)
            }
            Self::HoekBrown { ucs_mpa, gsi, mi, disturbance, up_to_kpa } => {
                let ucs = Range { low: 0.01, high: 1e3, words: "0.01 to 1000 MPa" };
                number(entry, "strength.ucs_mpa", *ucs_mpa, ucs)?;
                number(entry, "strength.gsi", *gsi, Range { low: 5.0, high: 100.0, words: "5 to 100" })?;
                number(entry, "strength.mi", *mi, Range { low: 1.0, high: 50.0, words: "1 to 50" })?;
                let range = Range { low: 0.0, high: 1.0, words: "0 to 1" };
                number(entry, "strength.disturbance", *disturbance, range)?;
                limit(*up_to_kpa)
            }
        }
    }

    /// Its lines, where stresses are about so great.
    pub(crate) fn lines(&self, about_kpa: f64) -> Lines {
        match *self {
            Self::Points { points_kpa: ref points } => {
                let lines =
                    slopes(points).zip(points).map(|(slope, p)| (slope, (p[1] - slope * p[0]).max(0.0)));
                let mut inside: Vec<(f64, f64)> = Vec::new();
                for (slope, cohesion) in lines {
                    let is_new =
                        |(last, before): &(f64, f64)| slope < last - SAME_SLOPE && cohesion > *before;
                    if inside.last().is_none_or(is_new) {
                        inside.push((slope, cohesion));
                    }
                }
                let inside = inside.into_iter().map(|(slope, cohesion)| of_slope(slope, cohesion)).collect();
                Lines { inside, outside: Vec::new() }
            }
            Self::Power { factor, exponent, tension_kpa, up_to_kpa } => Curve {
                exponent,
                tip: -tension_kpa,
                up_to: up_to_kpa
                    .unwrap_or_else(|| about_kpa.max(UNKNOWN_LOAD * factor * tension_kpa.powf(exponent))),
                straight_to: -tension_kpa,
                at: &|sigma| At {
                    normal: sigma,
                    shear: factor * (sigma + tension_kpa).max(0.0).powf(exponent),
                    slope: factor * exponent * (sigma + tension_kpa).powf(exponent - 1.0),
                },
            }
            .lines(),
            Self::FrictionLaw {
                phi_deg,
                slope_deg_per_decade,
                reference_kpa,
                greatest_phi_deg,
                up_to_kpa,
            } => {
                let slope = slope_deg_per_decade.to_radians() / std::f64::consts::LN_10;
                let (most, at_reference) = (greatest_phi_deg.to_radians(), phi_deg.to_radians());
                let straight_to = reference_kpa * ((at_reference - most) / slope).exp();
                let at = |sigma: f64| {
                    let phi = at_reference - slope * (sigma / reference_kpa).ln();
                    if sigma <= straight_to {
                        return At { normal: sigma, shear: sigma * most.tan(), slope: most.tan() };
                    }
                    At {
                        normal: sigma,
                        shear: sigma * phi.tan(),
                        slope: phi.tan() - slope / phi.cos().powi(2),
                    }
                };
                // A third of the friction is left there, and strength still grows.
                let farthest = reference_kpa * (at_reference * (1.0 - LEFT) / slope).exp();
                let up_to = up_to_kpa.unwrap_or(about_kpa).min(farthest);
                let At { normal, shear, slope } = at(up_to);
                // Where the curve is flattest it bends most, in the measure of logarithms.
                let exponent = if up_to > straight_to { normal * slope / shear } else { 0.99 };
                Curve { exponent, tip: 0.0, up_to, straight_to, at: &at }.lines()
            }
            Self::HoekBrown { ucs_mpa, gsi, mi, disturbance, up_to_kpa } => {
                let ucs = 1e3 * ucs_mpa;
                let mb = mi * ((gsi - 100.0) / (28.0 - 14.0 * disturbance)).exp();
                let s = ((gsi - 100.0) / (9.0 - 3.0 * disturbance)).exp();
                let a = 0.5 + ((-gsi / 15.0).exp() - (-20.0_f64 / 3.0).exp()) / 6.0;
                let difference = |least: f64| ucs * (mb * least / ucs + s).max(0.0).powf(a);
                Curve {
                    exponent: a,
                    tip: -s * ucs / mb,
                    up_to: up_to_kpa.unwrap_or_else(|| about_kpa.max(UNKNOWN_LOAD * difference(0.0))),
                    straight_to: -s * ucs / mb,
                    // Balmer (1952): where the circle of a least principal stress touches the envelope.
                    at: &|least| {
                        let grows = a * mb * (mb * least / ucs + s).max(0.0).powf(a - 1.0);
                        let over = difference(least) / (2.0 + grows);
                        let root = (1.0 + grows).sqrt();
                        // At the tip it is upright.
                        let shear = if root.is_finite() { over * root } else { 0.0 };
                        At { normal: least + over, shear, slope: 0.5 * grows / root }
                    },
                }
                .lines()
            }
        }
    }
}

fn slopes(points: &[[f64; 2]]) -> impl Iterator<Item = f64> {
    points.windows(2).map(|p| (p[1][1] - p[0][1]) / (p[1][0] - p[0][0]))
}

impl SoilEntry {
    /// The lines of its law of strength, if it has one, where stresses are about so great.
    pub(super) fn lines(&self, about_kpa: f64) -> Option<Lines> {
        Some(self.strength.as_ref()?.lines(about_kpa).times(self.strength_factor.unwrap_or(1.0)))
    }

    /// Its shear strength at the reference level where there is no pressure, in kPa.
    pub(super) fn at_no_pressure_kpa(&self) -> f64 {
        let least = |lines: Lines| lines.inside.iter().map(|l| l.cohesion).fold(f64::INFINITY, f64::min);
        self.lines(GREAT_KPA).map_or(self.cohesion_kpa, least)
    }

    /// The steepest friction angle in degrees of its strength, which is that near no pressure if it is curved.
    pub(super) fn steepest_deg(&self) -> f64 {
        let steepest = |lines: &Lines| lines.inside.first().map(|line| line.phi_deg);
        self.lines(GREAT_KPA).as_ref().and_then(steepest).unwrap_or_else(|| self.friction_deg())
    }

    /// Its friction angle in degrees, that at great pressure if its strength is curved.
    #[must_use]
    pub fn friction_deg(&self) -> f64 {
        let straight = || self.after_davis().phi_deg.unwrap_or(0.0);
        self.lines(GREAT_KPA).map_or_else(straight, |lines| lines.flattest_deg())
    }

    /// Its law of strength in words, if it has one.
    #[must_use]
    pub fn law_words(&self) -> Option<String> {
        let law = self.strength.as_ref()?;
        let words = law.to_string();
        Some(self.strength_factor.map_or(words.clone(), |factor| format!("{words}, times {factor:.4}")))
    }

    /// The soil with the strength that Davis (1968) gives to one that dilates less than the flow rule says: `c` and `tan(phi)` times
    /// `cos(psi) cos(phi)/(1 - sin(psi) sin(phi))`, with the dilation angle `psi`.
    #[must_use]
    pub fn after_davis(&self) -> Self {
        let (Some(phi_deg), Some(dilation_deg)) = (self.phi_deg, self.dilation_deg) else {
            return self.clone();
        };
        if dilation_deg >= phi_deg {
            return Self { dilation_deg: None, ..self.clone() };
        }
        let ((sin, cos), (sin_psi, cos_psi)) =
            (phi_deg.to_radians().sin_cos(), dilation_deg.to_radians().sin_cos());
        let part = cos_psi * cos / (1.0 - sin_psi * sin);
        Self {
            phi_deg: Some((part * sin / cos).atan().to_degrees()),
            cohesion_kpa: part * self.cohesion_kpa,
            cohesion_gradient_kpa_per_m: part * self.cohesion_gradient_kpa_per_m,
            dilation_deg: None,
            ..self.clone()
        }
    }

    /// Whether it has no strength where there is no pressure.
    pub(super) fn is_cohesionless(&self) -> bool {
        self.at_no_pressure_kpa() == 0.0 && self.cohesion_gradient_kpa_per_m == 0.0
    }
}

/// A pressure that is great wherever people build.
const GREAT_KPA: f64 = 1000.0;

impl Description {
    /// Stresses that are to be expected at most, in kPa.
    pub(super) fn expected_kpa(&self) -> f64 {
        let heights = || self.regions.iter().flat_map(|r| &r.polygon).map(|p| p[1]);
        let height = heights().fold(f64::NEG_INFINITY, f64::max) - heights().fold(f64::INFINITY, f64::min);
        let weight = self.soils.iter().map(|s| s.unit_weight_kn_m3).fold(0.0, f64::max);
        let loads = self.boundaries.iter().filter(|b| b.kind == Kind::Load);
        let pressure = |p: Option<Profile>| p.map_or([0.0; 2], Profile::ends).map(f64::abs);
        let load = loads.flat_map(|b| pressure(b.pressure_kpa)).fold(0.0, f64::max);
        let about = 2.0 * (weight * height.max(0.0) + load + self.surcharge_kpa);
        let about = match self.objective {
            Aim::Load {} | Aim::Structure { .. } | Aim::UnitWeight {} => UNKNOWN_LOAD * about,
            Aim::Seismic { .. } | Aim::StrengthReduction {} => about,
        };
        about.clamp(1.0, 1e9)
    }
}
