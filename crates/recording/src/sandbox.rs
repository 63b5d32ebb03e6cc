//! The box and its sand.

use soilctl_campaign::Plan;
use soilctl_plant::PlantParams;

use crate::rows::{single, texts};
use crate::rrd::{Column, Component, Values};

/// Where it hangs, in the base frame.
pub(crate) const ENTITY: &str = "/world/base_link/sandbox";
const SAND: u32 = 0xc29b_5cff;
const GLASS: u32 = 0x8090_a0ff;

/// The box of the log's plan, or of the default plant where there is none or it cannot be read without the files that it
/// names; `surface_z_m` is the level of the raked sand.
pub(crate) fn boxes(plan: &str, surface_z_m: f64) -> Vec<Column> {
    const CENTRES: Component = Component::new("Boxes3D", "centers", "Translation3D");
    const SIZES: Component = Component::new("Boxes3D", "half_sizes", "HalfSize3D");
    const COLOURS: Component = Component::new("Boxes3D", "colors", "Color");
    const LABELS: Component = Component::new("Boxes3D", "labels", "Text");
    const SHOWN: Component = Component::new("Boxes3D", "show_labels", "ShowLabels");
    let plan = Plan::from_record(plan);
    let thesis = PlantParams::thesis();
    let sandbox = plan.as_ref().map_or(thesis.config(), |plan| plan.plant().config()).sandbox;
    let [from, sand, glass] = [sandbox.floor_z_m, surface_z_m, sandbox.top_z_m];
    let spans = [[from, sand], [from, glass]].map(|z_m| [sandbox.x_m, sandbox.y_m, z_m]);
    let of = |part: fn([f64; 2]) -> f64| Values::Vectors(spans.map(|span| single(span.map(part))).to_vec());
    vec![
        Column::row(CENTRES, of(|[low, high]| 0.5 * (low + high))),
        Column::row(SIZES, of(|[low, high]| 0.5 * (high - low))),
        Column::row(COLOURS, Values::Colours(vec![SAND, GLASS])),
        Column::row(LABELS, texts(["raked sand", "box"])),
        Column::row(SHOWN, Values::Flags(vec![false])),
    ]
}
