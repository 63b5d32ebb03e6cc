//! The geometry of a description, with what holds where.

use std::collections::BTreeMap;

use soilctl_certificate::LineUse;

use super::faces::Face;
use super::ground::{Map, Occupant};
use super::holds::Holds;
use super::input::Description;
use super::seepage::PoreField;
use super::segments::Drawing;
use crate::vector::{Point, between, length};

/// Soil and what holds on its sides, in the units of the description.
pub(super) struct Plan<'a> {
    pub(super) drawing: Drawing,
    pub(super) map: Map,
    pub(super) faces: Vec<Face>,
    pub(super) holds: BTreeMap<LineUse, Holds>,
    /// For each member, the edges along it, walked from its start to its end.
    pub(super) members: Vec<Vec<LineUse>>,
    /// The head at the sides where one is given, in m.
    pub(super) heads: BTreeMap<LineUse, f64>,
    /// Pore pressures of flowing water.
    pub(super) pores: Option<&'a PoreField>,
}

impl Plan<'_> {
    /// Both ends of all sides on which something holds.
    pub(super) fn where_holds(&self, wanted: impl Fn(&LineUse, &Holds) -> bool) -> Vec<[Point; 2]> {
        let found = self.holds.iter().filter(|(w, h)| wanted(w, h));
        found.map(|(w, _)| self.map.walked_points(*w)).collect()
    }

    /// Heights of level lines on which something holds, with the length at each: the longest first, then the highest.
    pub(super) fn levels(&self, wanted: impl Fn(&LineUse, &Holds) -> bool) -> Vec<(f64, f64)> {
        let mut levels: Vec<(f64, f64)> = Vec::new();
        for [a, b] in self.where_holds(wanted) {
            if a[1] != b[1] {
                continue;
            }
            let long = length(between(a, b));
            match levels.iter_mut().find(|l| l.0 == a[1]) {
                Some(level) => level.1 += long,
                None => levels.push((a[1], long)),
            }
        }
        levels.sort_by(|a, b| b.1.total_cmp(&a.1).then(b.0.total_cmp(&a.0)));
        levels
    }

    /// Whether the soil of a side has neither cohesion nor a gradient of it.
    pub(super) fn is_bare(&self, description: &Description, walk: &LineUse) -> bool {
        let Occupant::Soil { region, .. } = self.map.left_of(*walk) else { return false };
        let soil = &description.soils[description.soil_of(region)];
        soil.cohesion_kpa == 0.0 && soil.cohesion_gradient_kpa_per_m == 0.0
    }
}
