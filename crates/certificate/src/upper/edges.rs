//! What happens at the edges of triangles: jumps, and boundaries.

use super::VelocityField;
use super::edge_velocity::EdgeVelocity;
use super::means;
use super::power::Power;
use super::resistance::Resistance;
use crate::CertificateError;
use crate::fields::{Flow, Velocity};
use crate::interval::{Interval, Vector, angle};
use crate::mesh::Side;
use crate::problem::Strength;
use crate::statement::{Condition, Linear, Objective};
use crate::tiling::{Beyond, OnLine, after};

impl VelocityField<'_> {
    /// What an edge adds to the power. Checks the flow rule.
    pub(super) fn edge(&self, side: Side) -> Result<Power, CertificateError> {
        match self.tiling.beyond(side) {
            // Members are looked at from end to end.
            Beyond::Soil(_) if self.tiling.member(side).is_some() => Ok(Power::ZERO),
            // Once for the two triangles.
            Beyond::Soil(other) if other < side || self.is_glued(side, other) => Ok(Power::ZERO),
            Beyond::Soil(other) => self.interface(side, other),
            Beyond::Boundary(on, condition) => self.boundary(side, on, condition),
        }
    }

    /// What a jump of the velocity across an edge dissipates. A jump is a thin layer of the soil of either side: the
    /// traction there is within the strength of both, each with its own pore pressure, so either proves a bound.
    fn interface(&self, side: Side, other: Side) -> Result<Power, CertificateError> {
        let mut jump = self.jump(side, other);
        if self.slips_along(side, other) {
            jump.opening = [Interval::ZERO; 3];
        }
        if jump.opening.iter().chain(&jump.slip).all(|x| x.is_zero()) {
            return Ok(Power::ZERO);
        }
        let [first, second] = [side, other]
            .map(|s| self.layer(side, &self.problem.strengths[self.tiling.region(s.triangle)], jump));
        match (first, second) {
            (Ok(a), Ok(b)) => Ok(a.or_lesser(b)),
            (Ok(a), Err(_)) | (Err(_), Ok(a)) => Ok(a),
            (Err(e), Err(_)) => Err(e),
        }
    }

    /// What a triangle adds to the power at a boundary.
    fn boundary(&self, side: Side, on: OnLine, condition: Condition) -> Result<Power, CertificateError> {
        let statement = self.problem.statement;
        let all = statement.objective == Objective::Everything;
        let bad = |problem| Err(CertificateError::BadField { place: side.to_string(), problem });
        match condition {
            Condition::Free => {
                let surcharge = Interval::point(statement.surcharge);
                Ok(self.load(side, on, [surcharge; 2], [Interval::ZERO; 2], all))
            }
            Condition::Loaded { pressure, shear, live } => {
                let live = all || (live && statement.objective == Objective::Loads);
                let [pressure, shear] = [pressure, shear].map(|at_ends| at_ends.map(Interval::point));
                Ok(self.load(side, on, pressure, shear, live))
            }
            Condition::Submerged => {
                Ok(self.load(side, on, self.problem.pore_pressure(on.side), [Interval::ZERO; 2], all))
            }
            Condition::Fixed | Condition::Far if !self.is_at_rest(side) => {
                bad("the soil must be at rest here")
            }
            Condition::Smooth if !self.slides(side, on) => {
                bad("the soil must be at rest here or slide along this line")
            }
            Condition::Fixed | Condition::Far | Condition::Smooth => Ok(Power::ZERO),
            Condition::Face { delta_deg, adhesion } => self.face(side, delta_deg, adhesion),
            // Beams are looked at from end to end.
            Condition::Lined { .. } => Ok(Power::ZERO),
        }
    }

    /// Power of tractions that are linear along a line, from their values at its ends. On the soil on the left a pressure
    /// acts along the edge vector turned left.
    fn load(
        &self,
        side: Side,
        on: OnLine,
        pressure: [Interval; 2],
        shear: [Interval; 2],
        live: bool,
    ) -> Power {
        Self::load_on(self.slide(side), on, pressure, shear, live)
    }

    /// The same, of what moves like this along the edge.
    pub(super) fn load_on(
        slide: EdgeVelocity,
        on: OnLine,
        pressure: [Interval; 2],
        shear: [Interval; 2],
        live: bool,
    ) -> Power {
        let at_ends =
            |[from, to]: [Interval; 2]| [on.start, on.end].map(|s| from + (to - from) * Interval::point(s));
        let pushed = means::over_edge(at_ends(pressure), slide.opening);
        let sheared = means::over_edge(at_ends(shear), slide.slip);
        Power::of_load(pushed + sheared, live)
    }

    /// Whether the velocity is exactly zero along an edge.
    fn is_at_rest(&self, side: Side) -> bool {
        match self.field.flows[side.triangle] {
            Flow::Quadratic(nodes) => {
                Self::on_edge(nodes, side).iter().all(|node| self.velocities[*node].is_zero())
            }
            // The value does not change along such a wall.
            Flow::Stream { corners, .. } => {
                let ends = [1, 2].map(|i| corners[after(side.corner, i)]);
                ends.iter().all(|copy| self.stream[*copy].slopes.is_zero()) && self.slope(side).is_zero()
            }
        }
    }

    /// Whether the soil has no velocity across a smooth line.
    fn slides(&self, side: Side, on: OnLine) -> bool {
        let line = on.side.line;
        let across = self.problem.direction(line).turned();
        match self.field.flows[side.triangle] {
            Flow::Quadratic(nodes) => {
                Self::on_edge(nodes, side).iter().all(|node| match self.field.velocities[*node] {
                    Velocity::Zero => true,
                    Velocity::Slide { line: along, .. } if along == line => true,
                    _ => self.velocities[*node].dot(across).is_zero(),
                })
            }
            // It is a wall, along which the stream function has been made not to change.
            Flow::Stream { .. } => true,
        }
    }

    /// What slip and opening at a face of the structure dissipate.
    fn face(&self, side: Side, delta_deg: f64, adhesion: f64) -> Result<Power, CertificateError> {
        let structure = Vector::point(self.problem.statement.objective.velocity());
        let along = self.along(side);
        let mut relative = match self.field.flows[side.triangle] {
            Flow::Quadratic(nodes) => {
                let relative = |node: usize| self.velocities[node] - structure;
                EdgeVelocity::new(along, Self::on_edge(nodes, side).map(relative))
            }
            Flow::Stream { .. } => self.slide(side).less(EdgeVelocity::new(along, [structure; 3])),
        };
        let bears_pressure_only = delta_deg == 0.0 && adhesion == 0.0;
        if matches!(self.field.flows[side.triangle], Flow::Stream { .. }) && !bears_pressure_only {
            // It is a wall, along which the stream function has been made to change as the structure moves.
            relative.opening = [Interval::ZERO; 3];
        }
        let soil = &self.problem.strengths[self.tiling.region(side.triangle)];
        let strength = Strength {
            friction: angle(delta_deg),
            cohesion: Linear::uniform(adhesion),
            pore_pressure: soil.pore_pressure,
            tension: bears_pressure_only.then_some(Interval::ZERO),
            envelope: None,
            anisotropy: None,
        };
        self.layer(side, &strength, relative)
    }

    /// What sliding along an edge dissipates. Checks that it opens as much as the friction demands: since Bernstein
    /// polynomials are not negative and add up to one, it does so between the control points too. Without friction it may
    /// open only if the tension is limited.
    fn layer(&self, side: Side, strength: &Strength, slide: EdgeVelocity) -> Result<Power, CertificateError> {
        let tan = strength.flow_friction().tan();
        let may_open = !strength.friction.sin.is_zero() || strength.tension.is_some();
        for (i, (open, slip)) in slide.opening.into_iter().zip(slide.slip).enumerate() {
            // For slip in either sense.
            let spares = if may_open { [open - slip * tan, open + slip * tan] } else { [open, -open] };
            if let Some(spare) = spares.into_iter().find(|spare| !spare.is_at_least_zero()) {
                let quantity = "opening beyond what the friction demands";
                let place = format!("{side}, control point {i} of 3");
                let (low, unit) = (spare.lo(), "velocity*length");
                return Err(CertificateError::NotProven { quantity, place, low, unit });
            }
        }
        let resistance = Resistance::new(strength, self.ends(side));
        let resisted = resistance.of_layer(slide.opening, slide.slip);
        Ok(Power::resisted(resisted, &self.problem.statement.objective))
    }
}
