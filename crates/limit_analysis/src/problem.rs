//! The statement of a problem, made ready for the solver.

use std::collections::BTreeMap;

use soilctl_certificate::{Boundary, Condition, LineUse, Linear, Material, Member, Objective, Statement};

use crate::anisotropy::{Ellipse, ROUND};
use crate::envelope::Envelope;
use crate::error::{LimitError, in_range};
use crate::mesh::check;

/// One region's soil.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Soil {
    pub(crate) sin: f64,
    pub(crate) cos: f64,
    pub(crate) tan: f64,
    /// Without friction, and nowhere torn: a limit to tension lets soil tear unless a face holds it by adhesion alone.
    pub(crate) is_isochoric: bool,
    pub(crate) cohesion: Linear,
    pub(crate) pore_pressure: Linear,
    /// Greatest effective tension.
    pub(crate) cut_off: Option<f64>,
    pub(crate) unit_weight: f64,
    /// What limits the strength beside friction and cohesion.
    pub(crate) envelope: Option<Envelope>,
    /// How the strength depends on the direction.
    pub(crate) ellipse: Ellipse,
}

impl Soil {
    fn new(m: &Material, is_held: bool) -> Self {
        let (sin, cos) = m.phi_deg.to_radians().sin_cos();
        Self {
            sin,
            cos,
            tan: sin / cos,
            is_isochoric: sin == 0.0 && (m.tension.is_none() || is_held),
            cohesion: m.cohesion,
            pore_pressure: m.pore_pressure,
            cut_off: m.tension,
            unit_weight: m.unit_weight,
            envelope: Envelope::of(m),
            ellipse: Ellipse::of(m),
        }
    }

    /// Sine of the friction angle that the flow rule asks for: where pressure is greatest.
    pub(crate) fn flow_sin(&self) -> f64 {
        self.envelope.as_ref().map_or(self.sin, |envelope| envelope.flattest.sin)
    }

    /// Its tangent.
    pub(crate) fn flow_tan(&self) -> f64 {
        self.envelope.as_ref().map_or(self.tan, |envelope| envelope.flattest.tan())
    }

    /// What acts on the grains of a unit volume: the weight less the change of the pore pressure.
    pub(crate) fn effective_weight(&self, gravity: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|i| self.unit_weight * gravity[i] - self.pore_pressure.gradient[i])
    }

    pub(crate) fn has_friction(&self) -> bool {
        self.tan > 0.0
    }

    /// Tangent of the friction angle, and cohesion at a point, of the strength at a pressure.
    pub(crate) fn strength_at(&self, pressure: f64, p: [f64; 2]) -> [f64; 2] {
        let own = [self.tan, self.cohesion.at(p)];
        let further = self.envelope.iter().flat_map(|envelope| &envelope.inside);
        let lines = further.map(|line| [line.tan(), line.cohesion]);
        let bears = |[tan, cohesion]: &[f64; 2]| cohesion + tan * pressure;
        lines.fold(own, |a, b| if bears(&b) < bears(&a) { b } else { a })
    }

    /// Effective tension at the apex of the yield cone. Without friction there is none.
    pub(crate) fn tension(&self, p: [f64; 2]) -> f64 {
        self.cohesion.at(p) / self.tan
    }

    /// The same soil with a part of the cohesion and the greatest tension.
    pub(crate) fn part(&self, part: f64) -> Self {
        let Linear { at_origin, gradient } = self.cohesion;
        let cohesion = Linear { at_origin: part * at_origin, gradient: gradient.map(|g| part * g) };
        let envelope = self.envelope.as_ref().map(|envelope| envelope.part(part));
        Self { cohesion, cut_off: self.cut_off.map(|t| part * t), envelope, ..self.clone() }
    }
}

/// A limit-analysis problem: a [`Statement`] whose geometry has been checked and whose numbers are of the order of one.
///
/// The solver works on the numbers as they are, so lengths should be in units of the structure's size and stresses in
/// units of unit weight times that length; [`crate::EmbeddedPlate`] does that.
#[derive(Debug, Clone)]
pub struct Problem {
    statement: Statement,
    pub(crate) soils: Vec<Soil>,
    conditions: BTreeMap<LineUse, Condition>,
    /// The member whose left side a side is.
    members: BTreeMap<LineUse, usize>,
    /// Height of the highest point.
    top: f64,
    /// The greatest load on the surface.
    load: f64,
}

impl Problem {
    /// Takes over a statement.
    ///
    /// # Errors
    ///
    /// [`LimitError::Mesh`] for geometry that is not a set of regions; [`LimitError::Range`] for numbers out of range.
    pub fn new(statement: Statement) -> Result<Self, LimitError> {
        check(&statement)?;
        let lines = statement.lines.len() as f64;
        let named =
            statement.boundaries.iter().map(|b| ("the line of a boundary", b.line as f64, 0.0, lines));
        // Gravity points down, or is left out.
        let most = if statement.gravity == [0.0; 2] { f64::MIN_POSITIVE } else { 0.0 };
        let down = ("gravity along y", statement.gravity[1], f64::MIN, most);
        for (quantity, value, low, high) in named.chain([down]) {
            in_range(quantity, value, low, high, "")?;
        }
        let mut soils = Vec::new();
        for region in &statement.regions {
            let m = &region.material;
            in_range("the friction angle", m.phi_deg, 0.0, 90.0, "deg")?;
            in_range("the unit weight", m.unit_weight, 0.0, f64::INFINITY, "")?;
            for used in region.loops.iter().flatten() {
                let line = statement.lines[used.line];
                let least = [line.from, line.to]
                    .map(|p| m.cohesion.at(statement.points[p]))
                    .into_iter()
                    .fold(f64::INFINITY, f64::min);
                // At a surface it may be zero but for rounding.
                in_range("the cohesion", least, -1e-12, f64::INFINITY, "")?;
            }
            if let Some(tension) = m.tension {
                in_range("the greatest tension", tension, 0.0, f64::INFINITY, "")?;
            }
            let is_held = |b: &Boundary| {
                matches!(b.condition, Condition::Face { .. })
                    && b.condition.is_wall()
                    && region.loops.iter().any(|l| l.contains(&b.side()))
            };
            soils.push(Soil::new(m, statement.boundaries.iter().any(is_held)));
        }
        let conditions = statement.boundaries.iter().map(|b| (b.side(), b.condition)).collect();
        let top = statement.points.iter().map(|p| p[1]).fold(f64::NEG_INFINITY, f64::max);
        let loads = statement.boundaries.iter().flat_map(|b| match b.condition {
            Condition::Loaded { pressure, shear, .. } | Condition::Lined { pressure, shear, .. } => {
                [pressure[0], pressure[1], shear[0], shear[1]]
            }
            Condition::Submerged => {
                let [a, b] = statement.pore_pressure(b.side());
                [a, b, 0.0, 0.0]
            }
            Condition::Free
            | Condition::Fixed
            | Condition::Smooth
            | Condition::Far
            | Condition::Face { .. } => [0.0; 4],
        });
        let load = loads.fold(0.0, |most: f64, l| most.max(l.abs())) + statement.surcharge;
        let on = |(i, m): (usize, &Member)| m.path.iter().map(move |side| (*side, i)).collect::<Vec<_>>();
        let members: BTreeMap<LineUse, usize> = statement.members.iter().enumerate().flat_map(on).collect();
        for (side, i) in &members {
            in_range("the line of a member", side.line as f64, 0.0, lines, "")?;
            let member = &statement.members[*i];
            for (quantity, force) in [
                ("the tension of a member", member.tension),
                ("the compression of a member", member.compression),
            ] {
                in_range(quantity, force, 0.0, f64::INFINITY, "")?;
            }
            for (quantity, most) in member.bending.iter().flat_map(|b| {
                [("the greatest moment of a beam", b.moment), ("the greatest shear force of a beam", b.shear)]
            }) {
                in_range(quantity, most, f64::MIN_POSITIVE, f64::INFINITY, "")?;
            }
            in_range("the bond of a member", member.bond, f64::MIN_POSITIVE, 1.0_f64.next_up(), "")?;
            for grip in member.pullout.iter().flatten() {
                for resistance in grip.resistance {
                    in_range("the pullout resistance of a bar", resistance, 0.0, f64::INFINITY, "")?;
                }
            }
        }
        Ok(Self { statement, soils, conditions, members, top, load })
    }

    /// The greatest load on the surface.
    pub(crate) fn load(&self) -> f64 {
        self.load
    }

    /// The statement.
    #[must_use]
    pub fn statement(&self) -> &Statement {
        &self.statement
    }

    /// The same for a structure of this width, above zero, in the problem's unit of length: see [`crate::bound_section`].
    ///
    /// # Errors
    ///
    /// [`LimitError::Range`] for a width that is none; [`LimitError::NotCovered`] for more than one soil.
    pub fn with_width(self, width: f64) -> Result<Self, LimitError> {
        in_range("the width", width, f64::MIN_POSITIVE, f64::MAX, "")?;
        if self.soils.len() != 1 {
            return Err(LimitError::NotCovered {
                what: "the ends of a structure in more than one soil",
                advice: "leave the width out, which gives bounds in plane strain",
            });
        }
        if !self.statement.members.is_empty() {
            return Err(LimitError::NotCovered {
                what: "the ends of a structure beside bars and sheets",
                advice: "leave the width out, which gives bounds in plane strain",
            });
        }
        if self.soils.iter().any(|soil| soil.envelope.is_some() || soil.ellipse != ROUND) {
            return Err(LimitError::NotCovered {
                what: "the ends of a structure in soil whose strength is curved or depends on the direction",
                advice: "leave the width out, which gives bounds in plane strain",
            });
        }
        Ok(Self { statement: self.statement.with_width(width), ..self })
    }

    /// The statement in plane strain, whatever its width.
    pub(crate) fn plane_statement(&self) -> Statement {
        Statement { width: None, ..self.statement.clone() }
    }

    /// Whether lower bounds shall hold for a structure with ends.
    pub(crate) fn is_spliced(&self) -> bool {
        self.statement.width.is_some()
    }

    /// The condition on a side of a line.
    pub(crate) fn condition(&self, side: LineUse) -> Option<Condition> {
        self.conditions.get(&side).copied()
    }

    /// All members.
    pub(crate) fn members(&self) -> &[Member] {
        &self.statement.members
    }

    /// The member whose left side a side is.
    pub(crate) fn member_whose_left_is(&self, side: LineUse) -> Option<usize> {
        self.members.get(&side).copied()
    }

    /// The member on a line.
    pub(crate) fn member_on(&self, line: usize) -> Option<usize> {
        let of = |forward| self.members.get(&LineUse { line, forward });
        of(true).or_else(|| of(false)).copied()
    }

    /// Whether a member is a beam.
    pub(crate) fn bends(&self, member: usize) -> bool {
        self.statement.members[member].bending.is_some()
    }

    /// Whether any member is a beam.
    pub(crate) fn has_beams(&self) -> bool {
        self.statement.members.iter().any(|member| member.bending.is_some())
    }

    /// Index of the point at the start (0) or the end (1) of a member.
    pub(crate) fn member_end_point(&self, member: usize, end: usize) -> usize {
        let path = &self.statement.members[member].path;
        let side = path[if end == 0 { 0 } else { path.len() - 1 }];
        self.statement.lines[side.line].walked(side.forward)[end]
    }

    /// Start and end of a member.
    pub(crate) fn member_ends(&self, member: usize) -> [[f64; 2]; 2] {
        [0, 1].map(|end| self.statement.points[self.member_end_point(member, end)])
    }

    /// The region with a side on its rim.
    pub(crate) fn owner(&self, side: LineUse) -> Option<usize> {
        self.statement.owner(side)
    }

    /// First and last point of a line.
    pub(crate) fn ends(&self, line: usize) -> [[f64; 2]; 2] {
        self.statement.lines[line].walked(true).map(|p| self.statement.points[p])
    }

    /// Whether the programs can state the problem yet.
    pub(crate) fn covered(&self) -> Result<(), LimitError> {
        let weightless =
            self.statement.gravity == [0.0; 2] || self.soils.iter().all(|s| s.unit_weight == 0.0);
        if weightless
            && self.load == 0.0
            && self.soils.iter().all(|s| s.cohesion.is_zero() && s.envelope.is_none())
        {
            return Err(LimitError::NoCollapse {
                reason: "soil without weight, cohesion and load resists nothing",
                advice: "give it one of these",
            });
        }
        for b in &self.statement.boundaries {
            let Condition::Face { delta_deg, adhesion } = b.condition else { continue };
            let friction = self.owner(b.side()).is_none_or(|r| self.soils[r].has_friction());
            if !friction && delta_deg > 0.0 {
                return Err(LimitError::NotCovered {
                    what: "interface friction on soil without friction",
                    advice: "give such a face an adhesion and no friction angle",
                });
            }
            if friction && delta_deg == 0.0 && adhesion > 0.0 {
                return Err(LimitError::NotCovered {
                    what: "adhesion on a face without friction, in soil with friction",
                    advice: "give the face a friction angle above zero",
                });
            }
        }
        Ok(())
    }

    /// Velocity of the structure.
    pub(crate) fn velocity(&self) -> [f64; 2] {
        self.statement.objective.velocity()
    }

    /// Whether some soil bears no tension at all.
    pub(crate) fn has_no_tension(&self) -> bool {
        self.soils.iter().any(|soil| soil.cut_off == Some(0.0))
    }

    /// Whether a factor on loads or a body force is bounded, and not a structure's force.
    pub(crate) fn has_factor(&self) -> bool {
        !matches!(self.statement.objective, Objective::Structure { .. })
    }

    /// A typical stress at a point of a region, seen over a length `h`: what rows and columns of the programs are
    /// scaled by.
    pub(crate) fn stress_scale(&self, region: usize, p: [f64; 2], h: f64) -> f64 {
        let soil = &self.soils[region];
        soil.unit_weight * ((self.top - p[1]).max(0.0) + 0.3 * h) + self.load + soil.cohesion.at(p).max(0.0)
    }
}
