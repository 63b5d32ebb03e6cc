//! The stroke of `shear` in words.

use soilctl_app::shear::StrokeAnswer;
use soilctl_app::text::{columns, number, stress};

use super::cells::{angle_cell, header, stress_cells};

pub(super) fn stroke_text(stroke: &StrokeAnswer) -> String {
    let inputs = &stroke.inputs;
    let with = match inputs.phi_deg {
        Some(phi) => format!("stresses for phi {} deg", number(phi)),
        None => "angle and stress consistent".into(),
    };
    let mut text = format!(
        "stroke: {} N on a plate {} m deep, {} m wide, at {} deg; delta {} deg, {} kg/m3; {with}\n",
        number(inputs.force_n),
        number(inputs.depth_m),
        number(inputs.width_m),
        number(inputs.alpha_deg),
        number(inputs.delta_deg),
        number(inputs.density_kg_m3),
    );
    let names = ["of depth", "sigma_L psi", "kPa", "phi deg ", "sigma_U psi", "kPa", "phi deg ", "curve"];
    let mut rows = vec![header(&names)];
    rows.extend(stroke.points.iter().map(|point| {
        let [low_psi, low_kpa] = stress_cells(point.low_stress_pa);
        let [high_psi, high_kpa] = stress_cells(point.high_stress_pa);
        let low = angle_cell(Some((point.friction_at_low_stress_deg, point.low_extrapolated)));
        let high = angle_cell(Some((point.friction_at_high_stress_deg, point.high_extrapolated)));
        let of_depth = number(point.point_fraction);
        vec![of_depth, low_psi, low_kpa, low, high_psi, high_kpa, high, point.curve.clone()]
    }));
    text += &columns(&rows);
    if let Some([first, ..]) = stroke.carried.as_deref() {
        text += &format!("\nused at {} ({})\n", stress(first.used_stress_pa), first.curve);
        text += &carried_text(stroke);
    }
    text
}

fn carried_text(stroke: &StrokeAnswer) -> String {
    let mut rows = vec![header(&["of depth", "from", "psi", "kPa", "shift deg "])];
    rows.extend(stroke.carried.iter().flatten().map(|shift| {
        let [psi, kpa] = stress_cells(shift.measured_stress_pa);
        let mark = if shift.measured_extrapolated || shift.used_extrapolated { "*" } else { " " };
        let degrees = format!("{:+.1}{mark}", shift.shift_deg);
        vec![number(shift.point_fraction), shift.from.clone(), psi, kpa, degrees]
    }));
    columns(&rows)
}
