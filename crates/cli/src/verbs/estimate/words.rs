//! The estimate in words.

use soilctl_app::estimate::{Answer, UnknownsAnswer, distinct};
use soilctl_app::text::{columns, number, range};

use crate::output::Words;

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = format!("{}\n", self.verdict);
        if let (Some(phi), Some(density)) = (self.phi_deg, self.density_kg_m3) {
            let ranges = [("phi (deg)", phi, 2), ("density (kg/m3)", density, 0)];
            let mut rows = vec![["", "from", "to", "centre", "best"].map(String::from).to_vec()];
            for (name, [low, high], digits) in ranges {
                let pick = |p: f64, d: f64| if digits == 2 { p } else { d };
                let cell = |x: Option<f64>| x.map_or_else(|| "-".into(), |x| format!("{x:.digits$}"));
                let centre = self.centre.map(|c| pick(c.phi_deg, c.density_kg_m3));
                let best = self.best_estimate.map(|b| pick(b.phi_deg, b.density_kg_m3));
                rows.push(vec![name.into(), cell(Some(low)), cell(Some(high)), cell(centre), cell(best)]);
            }
            if let Some([low, high]) = self.friction_law.as_ref().and_then(|law| law.slope_deg_per_decade) {
                let best = self.best_estimate.and_then(|b| b.slope_deg_per_decade);
                let best = best.map_or_else(|| "-".into(), |b| format!("{b:.2}"));
                let name = "fall of phi (deg/decade)".to_owned();
                rows.push(vec![name, format!("{low:.2}"), format!("{high:.2}"), "-".into(), best]);
            }
            text += "\n";
            text += &columns(&rows);
        }
        if let Some(unknowns) = &self.unknowns {
            text += "\n";
            text += &all(unknowns);
            text += &costs(self, unknowns);
        }
        if let Some([low, high]) = self.end_factor {
            text += &format!(
                "end factor {low:.2} to {high:.2}: the part of what ends add at most that they do add\n"
            );
        }
        text += "\n";
        text += &bands(self);
        if let Some(next) = &self.next_strokes {
            text += "\nnext strokes, the best first\n";
            let heading = [
                "alpha (deg)",
                "depth (mm)",
                "width (mm)",
                "area left",
                "phi width",
                "density width",
                "force (N)",
                "model",
            ];
            let mut rows = vec![heading.map(String::from).to_vec()];
            for n in next.iter().take(10) {
                rows.push(vec![
                    number(n.alpha_deg),
                    format!("{:.1}", 1e3 * n.depth_m),
                    format!("{:.0}", 1e3 * n.width_m),
                    format!("{:.0} %", 100.0 * n.area_left),
                    format!("{:.2}", n.phi_width_deg),
                    format!("{:.0}", n.density_width_kg_m3),
                    format!("{:.2}", n.force_n),
                    n.model.into(),
                ]);
            }
            text += &columns(&rows);
        }
        if let Some(minima) = &self.optimisers {
            text += "\nlocal optimisers (distinct ends)\n";
            let mut rows = vec![
                ["optimiser", "phi (deg)", "density", "delta (deg)", "misfit", "in region"]
                    .map(String::from)
                    .to_vec(),
            ];
            rows.extend(distinct(minima).into_iter().map(|(m, count)| {
                let [optimiser, rest @ ..] = m.cells();
                std::iter::once(format!("{optimiser} x{count}")).chain(rest).collect()
            }));
            text += &columns(&rows);
        }
        for warning in &self.warnings {
            text += &format!("\nnote: {warning}\n");
        }
        text
    }
}

/// All unknowns: what was known, and what is left.
fn all(unknowns: &UnknownsAnswer) -> String {
    let mut rows = vec![["unknown", "known from", "to", "left from", "to"].map(String::from).to_vec()];
    for unknown in &unknowns.quantities {
        let (name, unit, digits) = unknown.name.in_words();
        // What is nought is not minus nought.
        let cell = |x: f64| format!("{:.digits$}", if x.abs() < 1e-9 { 0.0 } else { x });
        let left = unknown.range.map_or_else(|| ["-".to_owned(), "-".to_owned()], |range| range.map(cell));
        rows.push(
            [format!("{name} ({unit})")].into_iter().chain(unknown.known.map(cell)).chain(left).collect(),
        );
    }
    columns(&rows)
}

/// What each unknown costs in width of friction angle and density.
fn costs(answer: &Answer, unknowns: &UnknownsAnswer) -> String {
    let Some(costs) = &unknowns.costs else { return String::new() };
    let mut rows = vec![
        ["if it were known", "at", "phi width (deg)", "density width (kg/m3)"].map(String::from).to_vec(),
    ];
    let width = |range: Option<[f64; 2]>| range.map(|[low, high]| high - low);
    let cell = |x: Option<f64>, digits: usize| x.map_or_else(|| "-".into(), |x| format!("{x:.digits$}"));
    let widths = |phi: Option<f64>, density: Option<f64>| [cell(phi, 2), cell(density, 0)];
    let now = widths(width(answer.phi_deg), width(answer.density_kg_m3));
    rows.push(["nothing of it".into(), "-".into()].into_iter().chain(now).collect());
    for cost in costs {
        let (name, unit, digits) = cost.name.in_words();
        let value = format!("{:.digits$} {unit}", if cost.value.abs() < 1e-9 { 0.0 } else { cost.value });
        rows.push(
            [name.into(), value]
                .into_iter()
                .chain(widths(cost.phi_width_deg, cost.density_width_kg_m3))
                .collect(),
        );
    }
    format!("\n{}", columns(&rows))
}

/// The measurements with their bands, and how these came about.
fn bands(answer: &Answer) -> String {
    let mut heading = vec!["measurement", "strokes", "force (N)", "from", "to"];
    let is_pooled = answer.confidence.is_some();
    if is_pooled {
        heading.extend(["scatter", "stated", "of mean", "in common"]);
    }
    let is_law = answer.friction_law.is_some();
    if is_law {
        heading.push("slip stress (Pa)");
    }
    let mut rows = vec![heading.into_iter().map(String::from).collect::<Vec<_>>()];
    let percent = |share: Option<f64>| share.map_or_else(|| "-".into(), |x| format!("{:.1} %", 100.0 * x));
    for m in &answer.measurements {
        let force = |x: f64| format!("{x:.3}");
        let cells = [force(m.force_n), force(m.force_low_n), force(m.force_high_n)];
        let mut row: Vec<String> =
            [m.label.clone(), m.strokes.to_string()].into_iter().chain(cells).collect();
        if let Some(p) = &m.pooled {
            row.extend(p.shares().map(percent));
        }
        if is_law {
            row.push(range(m.slip_stress_pa, 0));
        }
        rows.push(row);
    }
    let mut text = columns(&rows);
    for out in &answer.left_out {
        let name = out.stroke_id.clone().unwrap_or_else(|| format!("line {}", out.line));
        text += &format!("left out: {name}, for {}\n", out.reason);
    }
    if let (Some(all), Some(each)) = (answer.confidence, answer.confidence_each) {
        text += &format!(
            "bands hold their true forces with {} % together, {:.2} % each; deviations of one stroke by its scatter and as stated, of \
             the mean, and in common\n",
            number(100.0 * all),
            100.0 * each
        );
    }
    text
}
