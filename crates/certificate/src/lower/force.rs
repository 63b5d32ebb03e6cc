use std::collections::BTreeMap;

use super::StressFunction;
use crate::interval::{Interval, Vector};
use crate::statement::Condition;
use crate::tiling::Beyond;

impl StressFunction<'_> {
    /// The structure's force on the soil times its velocity.
    pub(super) fn power(&self) -> Interval {
        let velocity = Vector::point(self.problem.statement.objective.velocity());
        self.function_power(velocity) + self.reference_power(velocity)
    }

    /// The part of the stress function: along a boundary walked with the soil on the left its tractions add up to the
    /// change of `(f_y, -f_x)`. Where one edge ends and the next one starts, slopes cancel; they are counted as whole
    /// numbers first, so that they do so exactly.
    fn function_power(&self, velocity: Vector) -> Interval {
        let mut at_copies = vec![0_i32; self.field.copies.len()];
        for side in self.tiling.sides() {
            if let Beyond::Boundary(_, Condition::Face { .. }) = self.tiling.beyond(side) {
                let [start, end] = self.ends(side);
                at_copies[start] -= 1;
                at_copies[end] += 1;
            }
        }
        let mut of_gauges = vec![0_i32; self.field.gauges.len()];
        let mut power = Interval::ZERO;
        let add = |power: Interval, count: i32, slopes: Vector| {
            // `(f_y, -f_x) . velocity`.
            power + Interval::point(f64::from(count)) * slopes.cross(velocity) * Interval::point(-1.0)
        };
        for (copy, count) in at_copies.into_iter().enumerate().filter(|(_, count)| *count != 0) {
            let jet = self.jets[copy];
            let at = self.tiling.position(self.field.copies[copy].vertex);
            power = add(power, count, jet.slopes + self.surfaces.jet(jet.surface, at).1);
            of_gauges[jet.base] += count;
        }
        for (gauge, count) in of_gauges.into_iter().enumerate() {
            power = add(power, count, self.gauges.gradient(gauge, 0));
        }
        power
    }

    /// The part of the reference, which is linear along a line. On both sides of a thin plate it cancels, where they are in
    /// one region.
    fn reference_power(&self, velocity: Vector) -> Interval {
        let statement = self.problem.statement;
        let mut senses: BTreeMap<(usize, usize), i32> = BTreeMap::new();
        for boundary in &statement.boundaries {
            let (Condition::Face { .. }, Some(region)) =
                (boundary.condition, self.problem.owner(boundary.side()))
            else {
                continue;
            };
            *senses.entry((boundary.line, region)).or_default() += if boundary.forward { 1 } else { -1 };
        }
        let mut power = Interval::ZERO;
        for ((line, region), sense) in senses.into_iter().filter(|(_, sense)| *sense != 0) {
            let outward = -self.problem.direction(line).turned() * Interval::point(f64::from(sense));
            let ends = [statement.lines[line].from, statement.lines[line].to];
            for end in ends {
                let stress = self.references.of(region).at(Vector::point(statement.points[end]));
                power = power + stress.on(outward).dot(velocity).half();
            }
        }
        power
    }
}
