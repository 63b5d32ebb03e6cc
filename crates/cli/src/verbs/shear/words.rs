//! The answer of `shear` in words.

use soilctl_app::shear::{Answer, PowerLaw, RawAnswer, SlopeFloor, SoilAnswer};
use soilctl_app::text::{columns, four_digits, stress};
use soilctl_soil::units::pa_to_psi;

use super::cells::{EXTRAPOLATED, angle_cell, header, stress_cells};
use super::stroke::stroke_text;
use crate::output::Words;

impl Words for Answer {
    fn text(&self) -> String {
        text(self)
    }
}

fn text(answer: &Answer) -> String {
    let mut text = String::new();
    if let Some(raw) = &answer.raw {
        text += &raw_text(raw);
        text += "\n";
    }
    for soil in &answer.soils {
        text += &soil_text(soil);
        text += "\n";
    }
    if text.contains(EXTRAPOLATED) {
        text += "* extrapolated: outside the stresses that the curve was fitted to\n";
    }
    for warning in &answer.warnings {
        text += &format!("warning: {warning}\n");
    }
    text.trim_end().to_owned() + "\n"
}

fn soil_text(soil: &SoilAnswer) -> String {
    let (first, last) = (soil.points.first(), soil.points.last());
    let range = match (first, last) {
        (Some(low), Some(high)) => {
            format!(" from {} to {}", stress(low.normal_stress_pa), stress(high.normal_stress_pa))
        }
        _ => String::new(),
    };
    let name = soil.soil.as_deref().unwrap_or("soil without a name");
    let mut text = format!("{name}: {} points{range}\n\n", soil.points.len());
    text += &points_text(soil);
    text += "\n";
    let mut line = |name: &str, words: String| text += &format!("{name:<17}{words}\n");
    line("power law", soil.power_law.as_ref().map_or_else(|| "-".into(), power_law_words));
    line("slope and floor", soil.slope_floor.as_ref().map_or_else(|| "-".into(), slope_floor_words));
    let constant = soil.constant.as_ref().map(|fit| {
        format!(
            "phi = {:.2} deg at every stress; {}",
            fit.friction_angle_deg,
            misfit(fit.rms_deg, fit.worst_residual_deg)
        )
    });
    line("constant", constant.unwrap_or_else(|| "-".into()));
    if let Some(best) = &soil.best {
        line("best", best.clone());
    }
    if !soil.at.is_empty() {
        text += "\n";
        text += &at_text(soil);
    }
    if let Some(stroke) = &soil.stroke {
        text += "\n";
        text += &stroke_text(stroke);
    }
    text
}

fn points_text(soil: &SoilAnswer) -> String {
    let mut rows = vec![header(&["psi", "kPa", "phi deg ", "power law ", "slope and floor "])];
    let outside = |range: Option<[f64; 2]>, stress_pa: f64| {
        range.is_some_and(|[low, high]| stress_pa < low * (1.0 - 1e-9) || stress_pa > high * (1.0 + 1e-9))
    };
    let range = soil.power_law.as_ref().map(|fit| fit.stress_range_pa);
    rows.extend(soil.points.iter().map(|point| {
        let [psi, kpa] = stress_cells(point.normal_stress_pa);
        let power = point.power_law_deg.map(|deg| (deg, outside(range, point.normal_stress_pa)));
        let floor = point.slope_floor_deg.map(|deg| (deg, false));
        vec![
            psi,
            kpa,
            angle_cell(Some((point.friction_angle_deg, false))),
            angle_cell(power),
            angle_cell(floor),
        ]
    }));
    columns(&rows)
}

fn misfit(rms_deg: f64, worst_deg: f64) -> String {
    format!("rms {rms_deg:.2}, worst {worst_deg:+.2} deg")
}

fn power_law_words(fit: &PowerLaw) -> String {
    let [low, high] = fit.stress_range_pa.map(|pa| four_digits(pa_to_psi(pa)));
    let mut words = format!(
        "phi = {:.3} deg (sigma / psi)^{:.4} from {low} to {high} psi; {}",
        fit.a_deg_at_1_psi,
        fit.b,
        misfit(fit.rms_deg, fit.worst_residual_deg)
    );
    if let (Some(a), Some(b)) = (fit.ln_a_standard_error, fit.b_standard_error) {
        words += &format!("; standard errors {:.1} % and {b:.4}", 100.0 * a);
    }
    words
}

fn slope_floor_words(fit: &SlopeFloor) -> String {
    format!(
        "phi = {:.2} deg from {} on{}, below it {:.2} deg more a decade; {}",
        fit.floor_deg,
        stress(fit.floor_stress_pa),
        if fit.floor_stress_settled { "" } else { " (not settled by these loads)" },
        fit.slope_deg_per_decade,
        misfit(fit.rms_deg, fit.worst_residual_deg)
    )
}

fn at_text(soil: &SoilAnswer) -> String {
    let mut rows = vec![header(&["psi", "kPa", "phi deg ", "s.e. deg", "curve"])];
    rows.extend(soil.at.iter().map(|at| {
        let [psi, kpa] = stress_cells(at.normal_stress_pa);
        let error = at.standard_error_deg.map_or_else(|| "-".into(), |error| format!("{error:.1}"));
        vec![psi, kpa, angle_cell(Some((at.friction_angle_deg, at.extrapolated))), error, at.curve.clone()]
    }));
    format!("friction angle at given stresses\n{}", columns(&rows))
}

fn raw_text(raw: &RawAnswer) -> String {
    let mut rows = vec![header(&["load kg", "psi", "kPa", "phi deg", "sd deg", "kept", "dropped"])];
    rows.extend(raw.loads.iter().map(|load| {
        let [psi, kpa] = stress_cells(load.normal_stress_pa);
        let deviation = load.standard_deviation_deg.map_or_else(|| "-".into(), |sd| format!("{sd:.2}"));
        let names = |names: &[String]| if names.is_empty() { "-".into() } else { names.join(" ") };
        let angle = format!("{:.2}", load.friction_angle_deg);
        vec![four_digits(load.load_kg), psi, kpa, angle, deviation, names(&load.kept), names(&load.dropped)]
    }));
    let machine = raw
        .machine_friction_n
        .map_or_else(|| "not taken off (no --loop)".into(), |force| format!("{force:.3} N taken off"));
    format!("{} runs; machine friction {machine}\n{}", raw.runs.len(), columns(&rows))
}
