//! Where heads are given, and what open water presses on the ground there.

use soilctl_certificate::LineUse;

use std::collections::BTreeMap;

use super::error::DescriptionError;
use super::holds::{Holder, Holds};
use super::plan::Plan;
use super::segments::Owner;
use crate::vector::{Point, distance};

impl Holder<'_> {
    /// The entry of `[[head]]` on each side of the outline on which there is one.
    pub(super) fn heads(
        &self,
        holds: &BTreeMap<LineUse, Holds>,
    ) -> Result<BTreeMap<LineUse, usize>, DescriptionError> {
        let entries = &self.description.heads;
        let mut covered = vec![0.0; entries.len()];
        let mut found = BTreeMap::new();
        for (walk, hold) in holds {
            let on = self.uses(*walk, |owner| if let Owner::Head(i) = owner { Some(i) } else { None });
            let Some((entry, _, _)) = on.first() else { continue };
            let [a, b] = self.map.walked_points(*walk);
            let title = self.description.head_title(*entry);
            if let Some((other, _, _)) = on.get(1) {
                let second = self.description.head_title(*other);
                return Err(DescriptionError::Conflict { first: title, second, line: [a, b] });
            }
            if let Holds::Face(_) = hold {
                let problem = format!(
                    "its line is on a structure or plate, which lets no water through, between ({}, {}) and ({}, {})",
                    a[0], a[1], b[0], b[1]
                );
                return Err(DescriptionError::entry(title, problem));
            }
            covered[*entry] += distance(a, b);
            found.insert(*walk, *entry);
        }
        for (i, covered) in covered.into_iter().enumerate() {
            let whole: f64 = self.drawing.heads[i].windows(2).map(|w| distance(w[0], w[1])).sum();
            if covered < whole - 2.0 * self.drawing.near {
                let problem =
                    "its line is not on the outline of the soil all along; give points of the outline";
                return Err(DescriptionError::entry(self.description.head_title(i), problem));
            }
        }
        if let (true, Some((walk, _))) =
            (!entries.is_empty(), holds.iter().find(|(_, hold)| **hold == Holds::Far))
        {
            let [x, y] = self.map.walked_points(*walk)[0];
            let problem = format!(
                "the ground is far at ({x}, {y}), and beyond far sides water is at rest; draw the ground as far as the \
                 flow matters, and make its sides smooth or fixed"
            );
            return Err(DescriptionError::entry(self.description.head_title(0), problem));
        }
        Ok(found)
    }
}

impl Plan<'_> {
    /// Height of open water above a place on a side, zero where there is none.
    pub(super) fn open_water(&self, walk: LineUse, p: Point) -> f64 {
        let level = self.heads.get(&walk).copied().or_else(|| self.drawing.table(p[0]));
        level.map_or(0.0, |level| (level - p[1]).max(0.0))
    }

    /// Whether all of a side is below open water.
    pub(super) fn is_drowned(&self, walk: LineUse) -> bool {
        let ends = self.map.walked_points(walk);
        self.heads.get(&walk).is_some_and(|head| ends.iter().all(|p| p[1] <= *head))
    }
}
