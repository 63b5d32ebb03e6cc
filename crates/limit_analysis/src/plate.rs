//! The embedded plate: a thin straight plate in a half-space, pushed along level ground.

use soilctl_certificate::{
    Boundary, Condition, Line, LineUse, Linear, Material, Objective, Region, Statement,
};

use crate::describe::{StrengthLaw, greatest_phi_deg};
use crate::error::{LimitError, in_range};
use crate::problem::Problem;

/// Greatest sum of tool angle and interface friction in degrees: beyond it a plate has no finite force.
pub const MAX_ANGLE_SUM_DEG: f64 = 175.0;

/// Stresses about a plate are seldom greater, in units of unit weight times slant length. A law of stress is followed up to there.
const GREATEST: f64 = 100.0;

/// Friction that falls with the logarithm of the normal stress: `phi_deg` of the plate is that at the reference, it is less by the slope at ten times as much, and at most
/// 55 degrees or `phi_deg`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StressLaw {
    /// Fall of the friction angle in degrees a decade of stress, 0.1 to 8.
    pub slope_deg_per_decade: f64,
    /// Normal stress at which the friction angle is `phi_deg`, over unit weight times slant length; above zero.
    pub reference: f64,
}

/// An embedded plate, in units of its slant length and of unit weight times slant length.
///
/// Its top is at the surface. It moves towards positive x; at tool angles below 90 degrees its tip is ahead of its top.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EmbeddedPlate {
    /// Tool angle in degrees, 10 to 170.
    pub alpha_deg: f64,
    /// Slope of the surface in degrees, rising ahead of the plate; less than the friction angle either way.
    pub beta_deg: f64,
    /// Friction angle in degrees, above 0 and below 70.
    pub phi_deg: f64,
    /// Interface friction in degrees, 0 to the friction angle.
    pub delta_deg: f64,
    /// Cohesion over unit weight times slant length.
    pub cohesion: f64,
    /// Adhesion likewise; not with frictionless faces.
    pub adhesion: f64,
    /// Surcharge on the whole surface likewise.
    pub surcharge: f64,
}

impl Default for EmbeddedPlate {
    /// An upright, smooth plate in level soil without cohesion, at a friction angle of 30 degrees.
    fn default() -> Self {
        Self {
            alpha_deg: 90.0,
            beta_deg: 0.0,
            phi_deg: 30.0,
            delta_deg: 0.0,
            cohesion: 0.0,
            adhesion: 0.0,
            surcharge: 0.0,
        }
    }
}

impl EmbeddedPlate {
    /// Index of the plate's tip among the points of the statement.
    pub const TIP: usize = 5;

    /// The problem, in axes along and across the surface: a slope turns gravity, not the ground.
    ///
    /// # Errors
    ///
    /// [`LimitError::Range`] or [`LimitError::NotCovered`] for numbers out of the ranges named above.
    pub fn problem(&self) -> Result<Problem, LimitError> {
        // Against the surface, which is level in these axes, the plate stands at alpha + beta.
        let (sin, cos) = (self.alpha_deg.to_radians() + self.beta_deg.to_radians()).sin_cos();
        self.with_tip([cos, -sin])
    }

    /// The problem in soil whose friction falls with stress, of which nothing is known but its chords (for the lower bound) and tangents
    /// (for the upper).
    ///
    /// # Errors
    ///
    /// As [`problem`](Self::problem); [`LimitError::Range`] for a law out of its ranges and for a friction angle below 15 degrees, and
    /// [`LimitError::NotCovered`] with cohesion.
    pub fn problem_under(&self, law: StressLaw) -> Result<Problem, LimitError> {
        in_range("the friction angle phi at the reference", self.phi_deg, 15.0, 69.9, "deg")?;
        in_range("the slope of the law of stress", law.slope_deg_per_decade, 0.1, 8.0, "deg a decade")?;
        let over = "(over unit weight times length)";
        in_range("the reference stress", law.reference, f64::MIN_POSITIVE, f64::MAX, over)?;
        if self.cohesion > 0.0 {
            return Err(LimitError::NotCovered {
                what: "cohesion in soil whose friction falls with stress",
                advice: "leave one of them out, or state the curve of its strength in a problem file",
            });
        }
        let greatest_phi_deg = self.phi_deg.max(greatest_phi_deg());
        let lines = StrengthLaw::FrictionLaw {
            phi_deg: self.phi_deg,
            slope_deg_per_decade: law.slope_deg_per_decade,
            // Lines are in the unit of the stresses that they are asked for.
            reference_kpa: law.reference,
            greatest_phi_deg,
            up_to_kpa: None,
        }
        .lines(GREATEST);
        let first = lines.inside.first().map_or(self.phi_deg, |line| line.phi_deg);
        // About the friction where most of the soil slips; it says how far the mesh reaches, and what the plate may be.
        let about = self.phi_deg - law.slope_deg_per_decade * (1.0 / law.reference).log10();
        let plate = Self { phi_deg: about.clamp(1.0, greatest_phi_deg), ..*self };
        let mut statement = plate.problem()?.statement().clone();
        for region in &mut statement.regions {
            region.material.phi_deg = first;
            region.material.envelope = lines.envelope(|stress| stress);
        }
        Problem::new(statement)
    }

    /// The same for a plate of a width in slant lengths that has ends, per unit of its width. An upright plate on level ground
    /// stands exactly upright, as stress fields in space demand; the cosine of 90 degrees is not zero in doubles.
    ///
    /// # Errors
    ///
    /// As [`problem`](Self::problem), and [`LimitError::Range`] for a width that is not above zero.
    pub fn problem_with_ends(&self, width: f64) -> Result<Problem, LimitError> {
        let is_upright = self.alpha_deg == 90.0 && self.beta_deg == 0.0;
        let plane = if is_upright { self.with_tip([0.0, -1.0]) } else { self.problem() };
        plane?.with_width(width)
    }

    /// The problem of the plate from the origin to a tip.
    fn with_tip(&self, tip: [f64; 2]) -> Result<Problem, LimitError> {
        in_range("the tool angle alpha", self.alpha_deg, 10.0, 170.0, "deg")?;
        in_range("the friction angle phi", self.phi_deg, f64::MIN_POSITIVE, 70.0, "deg")?;
        in_range("the interface friction delta", self.delta_deg, 0.0, self.phi_deg.next_up(), "deg")?;
        in_range("the surface slope beta", self.beta_deg, (-self.phi_deg).next_up(), self.phi_deg, "deg")?;
        in_range("alpha + delta", self.alpha_deg + self.delta_deg, 0.0, MAX_ANGLE_SUM_DEG, "deg")?;
        in_range("alpha + beta", self.alpha_deg + self.beta_deg, 10.0, 170.0, "deg")?;
        for (name, value) in [
            ("the cohesion", self.cohesion),
            ("the adhesion", self.adhesion),
            ("the surcharge", self.surcharge),
        ] {
            in_range(name, value, 0.0, f64::MAX, "(over unit weight times length)")?;
        }
        if self.delta_deg == 0.0 && self.adhesion > 0.0 {
            return Err(LimitError::NotCovered {
                what: "adhesion on a plate without interface friction",
                advice: "give an interface friction delta above zero",
            });
        }
        let beta = self.beta_deg.to_radians();
        let reach = 1.0 + 1.5 * (self.phi_deg / 25.0).powi(3);
        let (behind, ahead, below) = (8.0, 8.0 + 4.0 * reach, 8.0);
        let points = vec![[-behind, 0.0], [-behind, -below], [ahead, -below], [ahead, 0.0], [0.0, 0.0], tip];
        let ends = [(0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (4, 0)];
        let outside = [0, 1, 2, 3, 4, 4, 5];
        let forward = [true, true, true, true, true, false, true];
        let uses: Vec<LineUse> =
            outside.into_iter().zip(forward).map(|(line, forward)| LineUse { line, forward }).collect();
        let face = Condition::Face { delta_deg: self.delta_deg, adhesion: self.adhesion };
        let conditions =
            [Condition::Far, Condition::Far, Condition::Far, Condition::Free, face, face, Condition::Free];
        let material = Material {
            phi_deg: self.phi_deg,
            cohesion: Linear::uniform(self.cohesion),
            unit_weight: 1.0,
            pore_pressure: Linear::default(),
            tension: None,
            envelope: None,
            anisotropy: None,
        };
        Problem::new(Statement {
            points,
            lines: ends.map(|(from, to)| Line { from, to }).to_vec(),
            regions: vec![Region { loops: vec![uses.clone()], material }],
            gravity: [-beta.sin(), -beta.cos()],
            datum: 0.0,
            surcharge: self.surcharge,
            // Level in space, so inclined against a sloping surface.
            objective: Objective::Structure { velocity: [beta.cos(), -beta.sin()] },
            width: None,
            members: Vec::new(),
            boundaries: uses
                .iter()
                .zip(conditions)
                .map(|(side, condition)| Boundary { line: side.line, forward: side.forward, condition })
                .collect(),
        })
    }
}
