//! How ground water flows, as answers tell it.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_limit_analysis::Described;
use soilctl_limit_analysis::describe::FlowUnit;

/// A steady flow of ground water between given heads.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct SeepageAnswer {
    /// What flows in at each given head.
    pub heads: Vec<HeadAnswer>,
    /// What comes out of ground in air, in the unit of the others.
    pub out_in_air: f64,
    /// Whether flows are in m3/s for a metre of width. If not, they are that over the permeability, which is not given: m.
    pub in_m2_per_s: bool,
    /// Greatest loss of head over the way where water comes out; null if none does. At a sharp corner it grows without limit on
    /// finer triangles.
    pub exit_gradient: Option<f64>,
    /// Where that is in m.
    pub exit_at_m: Option<[f64; 2]>,
    /// Triangles with water in their pores, in each of which the pore pressure is linear.
    pub triangles: usize,
    /// Greatest pore pressure at their corners.
    pub greatest_kpa: f64,
    /// Greatest difference between the pore pressures for which bounds are proven and those of triangles a sixty-fourth as large.
    pub kept_within_kpa: f64,
    /// Greatest difference of these, at the corners of the large triangles, from those of triangles four times as large.
    pub found_within_kpa: f64,
}

/// What flows in at a given head.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct HeadAnswer {
    /// Name of the entry; null if it has none.
    pub name: Option<String>,
    /// The total head.
    pub head_m: f64,
    /// What flows into the soil; negative where it flows out.
    pub inflow: f64,
}

impl SeepageAnswer {
    /// That of a problem in which ground water flows.
    pub(super) fn of(described: &Described) -> Option<Self> {
        let flowed = described.flowed.as_ref()?;
        let head = |head: &soilctl_limit_analysis::describe::HeadFlow| HeadAnswer {
            name: head.name.clone(),
            head_m: head.head_m,
            inflow: head.inflow,
        };
        Some(Self {
            heads: flowed.heads.iter().map(head).collect(),
            out_in_air: flowed.seepage,
            in_m2_per_s: match flowed.unit {
                FlowUnit::M2PerS => true,
                FlowUnit::OverPermeability => false,
            },
            exit_gradient: flowed.exit_gradient.map(|(gradient, _)| gradient),
            exit_at_m: flowed.exit_gradient.map(|(_, at)| at),
            triangles: flowed.triangles,
            greatest_kpa: flowed.greatest_kpa,
            kept_within_kpa: flowed.kept_within_kpa,
            found_within_kpa: flowed.found_within_kpa,
        })
    }
}
