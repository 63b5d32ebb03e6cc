//! What never changes in a recording: its layout, and how curves and arrows are drawn.

use std::io::Write;

use crate::layout::layout;
use crate::rows;
use crate::rrd::{WriteError, Writer};

/// Colours that stay apart for everybody (Okabe and Ito), red, green, blue, opacity.
const BLUE: u32 = 0x0072_b2ff;
const ORANGE: u32 = 0xe69f_00ff;
const GREEN: u32 = 0x009e_73ff;
const RED: u32 = 0xd55e_00ff;
const PINK: u32 = 0xcc79_a7ff;

const JOINTS: [(&str, u32); 5] =
    [("base", BLUE), ("shoulder", ORANGE), ("elbow", GREEN), ("twist", RED), ("wrist", PINK)];
/// Entities of curves: names in the order of their values.
const CURVES: [(&str, &[(&str, u32)]); 9] = [
    ("/force/plate", &[("r", BLUE), ("t", GREEN), ("z", ORANGE)]),
    ("/force/truth", &[("true r", 0x0072_b280), ("true t", 0x009e_7380), ("true z", 0xe69f_0080)]),
    ("/force/limit", &[("true limit", RED), ("true limit at this friction", PINK)]),
    ("/force_sensor", &[("x", BLUE), ("y", GREEN), ("z", ORANGE)]),
    ("/friction_angle", &[("friction angle", BLUE), ("set-point", ORANGE)]),
    ("/displacement", &[("displacement", BLUE), ("lead", ORANGE)]),
    ("/height", &[("height of the plate's edge", BLUE)]),
    ("/joints/position", &JOINTS),
    ("/joints/torque", &JOINTS),
];
pub(crate) const TRUE_DEPTH: (&str, &[(&str, u32)]) = ("/height/true_depth", &[("true depth", ORANGE)]);
/// Entities of arrows: label, colour, radius in m.
const ARROWS: [(&str, &str, u32, f32); 4] = [
    ("/world/force/sensor", "force sensor, bias included", PINK, 0.002),
    ("/world/force/plate", "force on the plate", BLUE, 0.0035),
    ("/world/force/truth", "true force on the plate", GREEN, 0.002),
    ("/world/lead", "lead", ORANGE, 0.003),
];

/// Of another program's recording; `joints` with whether they slide, and the radius of bones in m.
pub(crate) fn foreign_styles<W: Write>(
    writer: &mut Writer<W>,
    name: &str,
    joints: &[(String, bool)],
    radius_m: f32,
) -> Result<(), WriteError> {
    const ALL: [u32; 5] = [BLUE, ORANGE, GREEN, RED, PINK];
    writer.layout(&layout(false))?;
    writer.fixed("/__properties", &rows::name(name))?;
    writer.fixed("/world", &rows::axes())?;
    for entity in ["/force_sensor", "/torque_sensor", "/end_point"] {
        writer.fixed(entity, &rows::curve_style(&[("x", BLUE), ("y", GREEN), ("z", ORANGE)]))?;
    }
    for (entity, slide) in [("/joints/turning", false), ("/joints/sliding", true)] {
        let names = joints.iter().filter(|(_, slides)| *slides == slide).map(|(name, _)| name.as_str());
        let names: Vec<(&str, u32)> = names.zip(ALL.into_iter().cycle()).collect();
        if !names.is_empty() {
            writer.fixed(entity, &rows::curve_style(&names))?;
        }
    }
    writer.fixed("/world/force", &rows::arrow_style("force as read, bias included", BLUE, 0.6 * radius_m))?;
    writer.fixed("/world/bones", &rows::bone_style(radius_m))
}

/// Writes all of it; `name` is that of the recording.
pub(crate) fn styles<W: Write>(writer: &mut Writer<W>, name: &str) -> Result<(), WriteError> {
    writer.layout(&layout(true))?;
    writer.fixed("/__properties", &rows::name(name))?;
    writer.fixed("/world", &rows::axes())?;
    for (entity, names) in CURVES.iter().chain([&TRUE_DEPTH]) {
        writer.fixed(entity, &rows::curve_style(names))?;
    }
    for (entity, label, colour, radius_m) in ARROWS {
        writer.fixed(entity, &rows::arrow_style(label, colour, radius_m))?;
    }
    Ok(())
}
