//! The estimate in words.

use soilctl_estimator::Estimate;

use super::answer::{Disagreement, EstimateAnswer};
use crate::output::Answer;
use crate::text::{columns, number};

/// Pairs in conflict that are named; the JSON answer has all.
const MOST_PAIRS: usize = 6;

/// Names of the search limits that the region touches.
pub(super) fn limits(estimate: &Estimate) -> Vec<&'static str> {
    let l = estimate.limits;
    [
        (l.phi_low, "least friction angle searched"),
        (l.phi_high, "greatest friction angle searched"),
        (l.density_low, "least density searched"),
        (l.density_high, "greatest density searched"),
    ]
    .into_iter()
    .filter_map(|(touched, name)| touched.then_some(name))
    .collect()
}

/// Result in a sentence or two.
pub(super) fn verdict(answer: &EstimateAnswer) -> String {
    let delta = format!("delta {} to {} deg", number(answer.delta_deg[0]), number(answer.delta_deg[1]));
    if let Some(exact) = &answer.exact {
        return match exact.best.as_ref().and_then(|best| Some((best, best.ellipse_centre?))) {
            Some((best, [phi, density])) => format!(
                "Taken as exact, the contours come closest at phi {phi:.2} deg, density {density:.0} kg/m3 and delta \
                 {:.2} deg.",
                best.delta_deg
            ),
            None => {
                "Taken as exact, no two contours cross: no soil in range explains two of the measurements."
                    .into()
            }
        };
    }
    match (answer.phi_deg, answer.density_kg_m3) {
        (Some(phi), Some(density)) => format!(
            "The measurements agree under model {}: phi lies between {:.1} and {:.1} deg and the density between \
             {:.0} and {:.0} kg/m3, for {delta}.",
            answer.model, phi[0], phi[1], density[0], density[1]
        ),
        _ => {
            let mut text =
                format!("No soil explains all measurements under model {} with {delta}", answer.model);
            if let Some([low, high]) = answer.density_known_kg_m3 {
                text += &format!(" and density {low:.0} to {high:.0} kg/m3");
            }
            text += ".";
            if let Some(d) = &answer.disagreement {
                text += &disagreement(d);
            }
            text
        }
    }
}

fn disagreement(d: &Disagreement) -> String {
    let mut text = String::new();
    if !d.alone.is_empty() {
        text += &format!(" Not even alone: {}.", d.alone.join("; "));
    }
    if !d.pairs.is_empty() {
        let pairs: Vec<_> = d.pairs.iter().map(|[a, b]| format!("{a} with {b}")).collect();
        let more = pairs.len().saturating_sub(MOST_PAIRS);
        let rest = if more > 0 { format!(", and {more} more pairs") } else { String::new() };
        text += &format!(" In conflict: {}{rest}.", pairs[..pairs.len() - more].join("; "));
    }
    if !d.culprits.is_empty() {
        text += &format!(" The others agree without {}.", d.culprits.join(", or without "));
    }
    text += &match d.uncertainty_factor {
        Some(factor) => format!(" All would agree if the uncertainties were {factor:.2} times as large."),
        None => " Not even ten times the uncertainty makes them agree.".into(),
    };
    text
}

/// What the numbers call for.
pub(super) fn warnings(answer: &EstimateAnswer) -> Vec<String> {
    let mut warnings = Vec::new();
    if !answer.cut_by.is_empty() {
        warnings.push(format!(
            "the region touches the {}; its true extent there may be larger",
            answer.cut_by.join(" and the ")
        ));
    }
    if answer.consistent {
        warnings.push(
            "phi is that of the small stresses under the plate; at larger stresses it is several degrees lower, so \
             do not carry it to foundations or walls without a test at their stress"
                .into(),
        );
    }
    warnings
}

impl Answer for EstimateAnswer {
    const SCHEMA: &'static str = "soilctl.estimate/1";

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
            text += "\n";
            text += &columns(&rows);
        }
        text += "\n";
        let mut rows = vec![["measurement", "strokes", "force (N)", "from", "to"].map(String::from).to_vec()];
        for m in &self.measurements {
            let force = |x: f64| format!("{x:.3}");
            let cells = [force(m.force_n), force(m.force_low_n), force(m.force_high_n)];
            rows.push([m.label.clone(), m.strokes.to_string()].into_iter().chain(cells).collect());
        }
        text += &columns(&rows);
        if let Some(next) = &self.next_strokes {
            text += "\nnext strokes, the best first\n";
            let heading = [
                "alpha (deg)",
                "depth (mm)",
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

/// Ends that differ by more than 0.05 deg or 0.5 % in density, each with the number of starts that led there.
pub(crate) fn distinct(minima: &[super::answer::Minimum]) -> Vec<(&super::answer::Minimum, usize)> {
    let mut kept: Vec<(&super::answer::Minimum, usize)> = Vec::new();
    for m in minima {
        let same = |k: &super::answer::Minimum| {
            k.optimiser == m.optimiser
                && (k.end.phi_deg - m.end.phi_deg).abs() < 0.05
                && (k.end.density_kg_m3 / m.end.density_kg_m3 - 1.0).abs() < 0.005
        };
        match kept.iter_mut().find(|(k, _)| same(k)) {
            Some((_, count)) => *count += 1,
            None => kept.push((m, 1)),
        }
    }
    kept
}
