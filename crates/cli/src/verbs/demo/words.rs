//! The answer of `demo` in words.

use soilctl_app::demo::Answer;
use soilctl_app::text::{columns, number, range, yes};

use crate::output::Words;

impl Words for Answer {
    fn text(&self) -> String {
        text(self)
    }
}

fn text(answer: &Answer) -> String {
    let count = answer.strokes;
    let mut text = format!(
        "{}, model {}, seed {}: {} of {} strokes made, {} with a failure force\n",
        answer.title, answer.model, answer.seed, count.made, count.asked, count.with_force
    );
    if !answer.complete {
        return text + "stopped before the end; the same command goes on\n";
    }
    // What a colleague would ask first.
    text = format!("{}\n\n{text}", answer.found);
    let truth = &answer.truth;
    let mut rows = vec![["", "estimate", "truth", "holds it"].map(String::from).to_vec()];
    if let Some(delta) = &answer.delta {
        rows.push(vec![
            "interface friction (deg)".into(),
            format!("{:.1} ± {:.1}", delta.delta_deg, delta.sd_deg),
            number(truth.delta_deg),
            if delta.determined { yes(delta.holds_truth).into() } else { "does not count".into() },
        ]);
    }
    for (name, region) in answer.regions() {
        rows.push(vec![
            format!("friction angle (deg), {name}"),
            range(region.phi_deg, 1),
            number(truth.phi_deg),
            yes(region.phi_holds_truth).into(),
        ]);
        rows.push(vec![
            format!("density (kg/m3), {name}"),
            range(region.density_kg_m3, 0),
            number(truth.density_kg_m3),
            yes(region.density_holds_truth).into(),
        ]);
    }
    text += &columns(&rows);
    if let Some(forces) = &answer.forces {
        text += &format!(
            "errors of {} failure forces: median {:.1} %, 95 % below {:.1} %, {:.0} % of them within 10 %\n",
            forces.compared,
            100.0 * forces.median_error,
            100.0 * forces.percentile_95_error,
            100.0 * forces.share_within_10_percent
        );
    }
    for problem in &answer.not_recovered {
        text += &format!("not recovered: {problem}\n");
    }
    if let Some(report) = &answer.files.report {
        text += &format!("report: {report}\n");
    }
    text
}
