//! A buried body, put ahead of a tool.

use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{Hold, RegionEntry, SoilEntry, StructureEntry};

use super::{BodyKind, Request};
use crate::AppError;
use crate::tool::{Placed, SOIL, meet};

/// The name of the body in descriptions.
const BODY: &str = "body";

/// Cohesion of a stone over what the weight of the soil is at the depth of its bottom: it does not break before the soil around it fails.
const STRONG: f64 = 100.0;

/// A block with level top and upright faces, in axes along and across the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Body {
    kind: BodyKind,
    near_m: f64,
    far_m: f64,
    top_m: f64,
    bottom_m: f64,
}

impl Body {
    /// The body of a request at one distance from the tip of the tool.
    pub(super) fn new(request: &Request, placed: &Placed, ahead_m: f64) -> Result<Self, AppError> {
        let near_m = placed.tip()[0] + ahead_m;
        let length = request.body_length_m.unwrap_or(request.body_height_m);
        let body = Self {
            kind: request.body,
            near_m,
            far_m: near_m + length,
            top_m: request.body_top_m,
            bottom_m: request.body_top_m + request.body_height_m,
        };
        if placed.lines().any(|line| body.meets(line)) {
            return Err(AppError::Request(format!(
                "{ahead_m} m ahead of its tip the body meets the tool; give a greater distance, or a body deeper than the tool"
            )));
        }
        Ok(body)
    }

    fn corners(&self) -> [[f64; 2]; 4] {
        let Self { near_m, far_m, top_m, bottom_m, .. } = *self;
        [[near_m, -bottom_m], [far_m, -bottom_m], [far_m, -top_m], [near_m, -top_m]]
    }

    fn meets(&self, line: [[f64; 2]; 2]) -> bool {
        let corners = self.corners();
        let inside = |[x, y]: [f64; 2]| {
            (self.near_m..=self.far_m).contains(&x) && (-self.bottom_m..=-self.top_m).contains(&y)
        };
        line.into_iter().any(inside) || (0..4).any(|i| meet(line, [corners[i], corners[(i + 1) % 4]]))
    }

    /// The problem of the tool with the body.
    pub(super) fn description(&self, request: &Request, placed: &Placed) -> Description {
        let size = placed.size_m();
        let [left, right, bottom] = placed.extents(request.setting.phi_deg, size);
        // As much soil around the body as around the tool.
        let around = 4.0 * size.max(self.bottom_m);
        let (right, bottom) = (right.max(self.far_m + around), bottom.min(-self.bottom_m - around));
        let region =
            |soil: &str, polygon: Vec<[f64; 2]>| RegionEntry { name: None, soil: soil.into(), polygon };
        let corners = self.corners();
        let hold = match self.kind {
            BodyKind::Fixed => Hold::Fixed,
            BodyKind::Stone => {
                let middle = 0.5 * (self.near_m + self.far_m);
                let [b, c, d, a] = corners;
                // The soil is cut through the middle of the stone, since a region has no holes.
                let behind = vec![
                    [left, bottom],
                    [middle, bottom],
                    [middle, b[1]],
                    b,
                    a,
                    [middle, a[1]],
                    [middle, 0.0],
                    [left, 0.0],
                ];
                let ahead = vec![
                    [right, 0.0],
                    [middle, 0.0],
                    [middle, d[1]],
                    d,
                    c,
                    [middle, c[1]],
                    [middle, bottom],
                    [right, bottom],
                ];
                let regions = vec![region(SOIL, behind), region(SOIL, ahead), region(BODY, corners.to_vec())];
                let mut description = placed.description(&request.setting, regions);
                description.soils.push(self.stone(request, placed));
                return description;
            }
        };
        let polygon = vec![[left, bottom], [right, bottom], [right, 0.0], [left, 0.0]];
        let mut description = placed.description(&request.setting, vec![region(SOIL, polygon)]);
        description.structures.push(StructureEntry {
            name: BODY.into(),
            polygon: corners.to_vec(),
            held: Some(hold),
            ..StructureEntry::default()
        });
        description
    }

    /// Cohesion of a stone; none of bodies at rest.
    pub(super) fn stone_cohesion_pa(&self, request: &Request, placed: &Placed) -> Option<f64> {
        let loads = &request.setting.loads;
        let stress_pa =
            1e3 * placed.unit_weight_kn_m3 * self.bottom_m + loads.surcharge_pa + loads.cohesion_pa;
        (self.kind == BodyKind::Stone).then_some(STRONG * stress_pa)
    }

    /// A stone is soil that is much stronger. Along its faces the soil is what fails.
    fn stone(&self, request: &Request, placed: &Placed) -> SoilEntry {
        SoilEntry {
            name: BODY.into(),
            phi_deg: Some(request.setting.phi_deg),
            cohesion_kpa: 1e-3 * self.stone_cohesion_pa(request, placed).unwrap_or(0.0),
            unit_weight_kn_m3: placed.across_surface(placed.unit_weight_kn_m3),
            ..SoilEntry::default()
        }
    }
}
