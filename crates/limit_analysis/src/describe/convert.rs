//! From a description to a statement.

use std::collections::BTreeMap;

use soilctl_certificate::{Boundary, Condition, Line, LineUse, Objective, Region, Statement};

use super::columns::{ratio_cuts, weight_cuts};
use super::described::{Described, Quantity};
use super::error::DescriptionError;
use super::faces::Face;
use super::fill::{Units, material};
use super::ground::{Map, Occupant};
use super::holds::{Holder, Holds};
use super::input::{Aim, Description};
use super::plan::Plan;
use super::seepage::{PoreField, Uncut};
use super::segments::{Drawing, Segment};
use super::size::units;
use crate::error::LimitError;
use crate::vector::{Point, length};

/// Most lines of a statement that the checker takes.
const MAX_LINES: usize = 1024;

/// Cutting a region may bend the top of the one below, once for each layer.
const MAX_ROUNDS: usize = 64;

impl Description {
    /// The problem in the units of the solver.
    ///
    /// # Errors
    ///
    /// [`LimitError::Description`] for what is wrong with the description, [`LimitError::NotCovered`] for what no proof
    /// covers.
    pub fn described(&self) -> Result<Described, LimitError> {
        self.check()?;
        self.described_under(self.pore_field()?.as_ref())
    }

    /// The flow of ground water, if heads are given. It does not depend on strength, so it can be kept for weaker soil.
    pub(crate) fn pore_field(&self) -> Result<Option<PoreField>, LimitError> {
        if self.heads.is_empty() {
            return Ok(None);
        }
        self.check()?;
        let (drawing, segments, map) = self.uncut()?;
        let faces = map.faces();
        let holder = Holder { description: self, drawing: &drawing, segments: &segments, map: &map };
        let holds: BTreeMap<LineUse, Holds> = holder.all()?.into_iter().collect();
        let heads = holder.heads(&holds)?;
        let uncut = Uncut { description: self, map: &map, faces: &faces, holds: &holds, heads: &heads };
        uncut.pore_field().map(Some)
    }

    /// The problem with pore pressures that were found before.
    pub(crate) fn described_under(&self, pores: Option<&PoreField>) -> Result<Described, LimitError> {
        self.check()?;
        let plan = self.plan(pores)?;
        self.check_covered(&plan)?;
        self.check_placed(&plan)?;
        let at_far = self.far_pressure(&plan)?;
        let units = units(self, &plan, at_far)?;
        let statement = self.statement(&plan, &units, at_far)?;
        let quantity = match self.objective {
            Aim::Structure { .. } => Quantity::ForceKnPerM,
            Aim::Load {} => Quantity::LoadFactor,
            Aim::UnitWeight {} | Aim::StrengthReduction {} => Quantity::WeightFactor,
            Aim::Seismic { .. } => Quantity::Acceleration,
        };
        let Units { length_m, stress_kpa, .. } = units;
        let flowed = pores.map(|pores| pores.flowed.clone());
        let soils =
            plan.faces.iter().filter_map(|face| self.regions.get(face.region)).map(|r| r.soil.clone());
        Ok(Described {
            statement,
            soils: soils.collect(),
            length_m,
            stress_kpa,
            quantity,
            title: self.title.clone(),
            flowed,
        })
    }

    /// The lines that are named, before any cuts that proofs need.
    fn uncut(&self) -> Result<(Drawing, Vec<Segment>, Map), DescriptionError> {
        let drawing = Drawing::new(self);
        let segments = drawing.segments(self)?;
        let map = Map::new(self, &drawing, &segments)?;
        Ok((drawing, segments, map))
    }

    fn plan<'a>(&self, pores: Option<&'a PoreField>) -> Result<Plan<'a>, DescriptionError> {
        let (drawing, mut segments, mut map) = self.uncut()?;
        if let Some(pores) = pores {
            segments.extend(pores.cuts());
            map = Map::new(self, &drawing, &segments)?;
        }
        let ratio = ratio_cuts(self, &drawing, &map);
        if !ratio.is_empty() {
            segments.extend(ratio);
            map = Map::new(self, &drawing, &segments)?;
        }
        for _ in 0..MAX_ROUNDS {
            let mut faces = map.faces();
            let holder = Holder { description: self, drawing: &drawing, segments: &segments, map: &map };
            let holds: BTreeMap<LineUse, Holds> = holder.all()?.into_iter().collect();
            let members = self.paths(&drawing, &map, &segments)?;
            self.top_first(&map, &mut faces);
            let Some(first) = faces.first() else {
                return Err(DescriptionError::entry("the problem", "its regions enclose no soil"));
            };
            let base = self.soils[self.soil_of(first.region)].unit_weight_kn_m3;
            let cuts = weight_cuts(self, &map, &faces, &holds, base);
            if cuts.is_empty() {
                let heads = holder.heads(&holds)?;
                let heads = heads.into_iter().map(|(walk, entry)| (walk, self.heads[entry].head_m)).collect();
                return Ok(Plan { drawing, map, faces, holds, members, heads, pores });
            }
            segments.extend(cuts);
            map = Map::new(self, &drawing, &segments)?;
        }
        let problem = "unit weights differ in a way that cannot be cut into regions with straight tops";
        Err(DescriptionError::entry("the problem", problem))
    }

    /// The soil on top gives the unit weight of the reference: then there is no more to add to it.
    fn top_first(&self, map: &Map, faces: &mut [Face]) {
        let top = |face: &Face| {
            face.loops.iter().flatten().map(|w| map.walked_points(*w)[0][1]).fold(f64::NEG_INFINITY, f64::max)
        };
        // Stable: equal tops stay in order.
        faces.sort_by(|a, b| top(b).total_cmp(&top(a)));
    }

    fn check_covered(&self, plan: &Plan) -> Result<(), LimitError> {
        let weight = |f: &Face| self.soils[self.soil_of(f.region)].unit_weight_kn_m3;
        let differ = plan.faces.iter().any(|f| weight(f) != weight(&plan.faces[0]));
        let level =
            self.seismic.is_some_and(|s| s.kh != 0.0) || matches!(self.objective, Aim::Seismic { .. });
        if differ && level {
            return Err(LimitError::NotCovered {
                what: "different unit weights together with a horizontal acceleration",
                advice: "give all soils the same unit weight",
            });
        }
        if plan.map.arrangement.edges.len() > MAX_LINES {
            let count = plan.map.arrangement.edges.len();
            return Err(
                DescriptionError::TooMuch { what: "lines after cutting", count, limit: MAX_LINES }.into()
            );
        }
        Ok(())
    }

    /// Pressure of open water on a side at a point.
    fn water_pressure(&self, plan: &Plan, walk: LineUse, p: Point) -> f64 {
        let depth = plan.open_water(walk, p);
        let at_rest = self.water.as_ref().map(|w| w.unit_weight_kn_m3);
        depth * at_rest.unwrap_or_else(|| self.seepage.unwrap_or_default().unit_weight_kn_m3)
    }

    /// Pressure on the ground beyond far sides in kPa.
    fn far_pressure(&self, plan: &Plan) -> Result<f64, DescriptionError> {
        let far = plan.holds.iter().filter(|(_, h)| **h == Holds::Far);
        let mut tops: BTreeMap<bool, (LineUse, Point)> = BTreeMap::new();
        for (walk, ends) in
            far.map(|(w, _)| (*w, plan.map.walked_points(*w))).filter(|(_, [a, b])| a[0] == b[0])
        {
            for p in ends {
                let top = tops.entry(p[0] == plan.drawing.low[0]).or_insert((walk, p));
                if p[1] > top.1[1] {
                    *top = (walk, p);
                }
            }
        }
        let mut pressures =
            tops.values().map(|(walk, p)| self.surcharge_kpa + self.water_pressure(plan, *walk, *p));
        let first = pressures.next().unwrap_or(self.surcharge_kpa);
        match pressures.find(|p| (p - first).abs() > 1e-12 * first.abs()) {
            Some(other) => {
                let problem = format!(
                    "water stands at different heights above the ground beyond the two far sides ({first:.4} and \
                     {other:.4} kPa with the surcharge); make one of them smooth or fixed"
                );
                Err(DescriptionError::entry("water", problem))
            }
            None => Ok(first),
        }
    }

    fn statement(&self, plan: &Plan, units: &Units, at_far: f64) -> Result<Statement, DescriptionError> {
        let map = &plan.map;
        let mut numbers: BTreeMap<usize, usize> = BTreeMap::new();
        let mut points = Vec::new();
        let mut number = |p: usize| {
            *numbers.entry(p).or_insert_with(|| {
                points.push(units.place(map.arrangement.points[p]));
                points.len() - 1
            })
        };
        let lines =
            map.arrangement.edges.iter().map(|e| Line { from: number(e.ends[0]), to: number(e.ends[1]) });
        let lines = lines.collect();
        let region = |face: &Face| {
            let material = material(self, plan, face, units)?;
            Ok(Region { loops: face.loops.clone(), material })
        };
        let boundary = |(walk, holds): (&LineUse, &Holds)| Boundary {
            line: walk.line,
            forward: walk.forward,
            condition: self.condition(plan, units, at_far, *walk, *holds),
        };
        let (gravity, objective) = self.forces();
        Ok(Statement {
            points,
            lines,
            regions: plan.faces.iter().map(region).collect::<Result<_, DescriptionError>>()?,
            gravity,
            // The origin is at the datum.
            datum: 0.0,
            surcharge: units.stress(at_far),
            objective,
            width: None,
            members: self.statement_members(plan, units),
            boundaries: plan.holds.iter().map(boundary).collect(),
        })
    }

    fn condition(&self, plan: &Plan, units: &Units, at_far: f64, walk: LineUse, holds: Holds) -> Condition {
        let is_lined = self.is_lined(plan, walk.line);
        match holds {
            Holds::Fixed => Condition::Fixed,
            Holds::Smooth => Condition::Smooth,
            Holds::Far => Condition::Far,
            Holds::Face(face) => {
                Condition::Face { delta_deg: face.delta_deg, adhesion: units.stress(face.adhesion_kpa) }
            }
            Holds::Load { pressure, shear, live } => {
                let [pressure, shear] = [pressure, shear].map(|ends| ends.map(|kpa| units.stress(kpa)));
                if is_lined {
                    return Condition::Lined { pressure, shear, live };
                }
                Condition::Loaded { pressure, shear, live }
            }
            Holds::Free => {
                let ends = plan.map.arrangement.ends(walk.line);
                let pressure = ends.map(|p| self.surcharge_kpa + self.water_pressure(plan, walk, p));
                if is_lined {
                    let pressure = pressure.map(|kpa| units.stress(kpa));
                    return Condition::Lined { pressure, shear: [0.0; 2], live: false };
                }
                if pressure.iter().all(|p| (p - at_far).abs() <= 1e-12 * at_far.abs()) {
                    return Condition::Free;
                }
                if self.is_under_water_alone(plan, at_far, walk) {
                    return Condition::Submerged;
                }
                let pressure = pressure.map(|kpa| units.stress(kpa));
                Condition::Loaded { pressure, shear: [0.0; 2], live: false }
            }
        }
    }

    /// Whether a free side is of soil without cohesion, below open water and nothing else.
    fn is_under_water_alone(&self, plan: &Plan, at_far: f64, walk: LineUse) -> bool {
        let is_wet =
            plan.is_drowned(walk) || matches!(plan.map.left_of(walk), Occupant::Soil { submerged: true, .. });
        is_wet && at_far == 0.0 && self.surcharge_kpa == 0.0 && plan.is_bare(self, &walk)
    }

    /// Gravity and the objective.
    fn forces(&self) -> ([f64; 2], Objective) {
        let seismic = self.seismic.unwrap_or_default();
        let gravity = [seismic.kh, -(1.0 - seismic.kv)];
        match self.objective {
            Aim::Structure { direction, .. } => {
                // First to the order of one, against overflow.
                let most = direction[0].abs().max(direction[1].abs());
                let direction = direction.map(|x| x / most);
                let long = length(direction);
                (gravity, Objective::Structure { velocity: direction.map(|x| x / long) })
            }
            Aim::Load {} => (gravity, Objective::Loads),
            Aim::UnitWeight {} => ([0.0; 2], Objective::Body { gravity }),
            Aim::StrengthReduction {} => (gravity, Objective::Everything),
            Aim::Seismic { leftwards } => {
                (gravity, Objective::Body { gravity: [if leftwards { -1.0 } else { 1.0 }, 0.0] })
            }
        }
    }
}
