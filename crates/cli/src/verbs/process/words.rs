//! The answer for people.

use soilctl_app::process::{Answer, ContactKind, Found, FreeAir, Scan};
use soilctl_app::text::{columns, number};

use crate::output::Words;

impl Words for Answer {
    fn text(&self) -> String {
        text(self)
    }
}

fn text(answer: &Answer) -> String {
    let mut text = String::new();
    if !answer.strokes.is_empty() {
        let mut rows = vec![
            ["stroke", "alpha deg", "depth mm", "force N", "sd N", "failure", "found by", "flags"]
                .map(str::to_owned)
                .to_vec(),
        ];
        for stroke in &answer.strokes {
            rows.push(vec![
                stroke.name().to_owned(),
                number(stroke.row.alpha_deg),
                format!("{:.2}", stroke.row.depth_m * 1e3),
                format!("{:.3}", stroke.row.force_n),
                stroke.row.force_sd_n.map_or("-".into(), |sd| format!("{sd:.3}")),
                stroke.failure.failure.clone(),
                stroke.failure.method.clone(),
                stroke.failure.flags.clone(),
            ]);
        }
        text += &columns(&rows);
    }
    for log in &answer.logs {
        if let Some(found) = &log.found {
            text += &foreign(&log.log, found);
        }
        for scan in &log.scans {
            text += &scanned(scan);
        }
        if let Some(error) = &log.error {
            text += &format!("left out: {}: {error}\n", log.log);
        }
        for skipped in &log.skipped {
            let name = skipped.stroke_id.as_deref().unwrap_or(&log.log);
            text += &format!(
                "no force: {name}, {:.2} to {:.2} s: {}\n",
                skipped.from_s, skipped.to_s, skipped.reason
            );
        }
        for damage in &log.damage {
            text += &format!("damaged: {}: {damage}\n", log.log);
        }
        for unusable in &log.unusable {
            text += &format!("not used: {}: {unusable}\n", log.log);
        }
        if log.error.is_none() && log.strokes == 0 && log.skipped.is_empty() {
            text += &format!("no strokes: {}\n", log.log);
        }
    }
    text += &analysis(answer);
    for file in &answer.written {
        text += &format!("written: {file}\n");
    }
    text
}

/// What was found in a log of another program.
fn foreign(log: &str, found: &Found) -> String {
    let kinds = |kind: ContactKind| found.contacts.iter().filter(|contact| contact.kind == kind).count();
    let strokes = kinds(ContactKind::Stroke);
    let mut text =
        format!("{log}: {} contacts, {strokes} of them strokes with a failure force; ", found.contacts.len());
    text += &match &found.free_air {
        None => "no free air was found".to_owned(),
        Some(air) => free_air(air),
    };
    text += &format!("; times count from {} s\n", found.clock_origin_s);
    let others = found.contacts.iter().filter(|contact| contact.kind == ContactKind::NoStroke);
    for contact in others {
        let force = contact.highest_n.map_or(String::new(), |force| format!(", up to {force:.2} N"));
        text += &format!("contact: {:.2} to {:.2} s{force}\n", contact.from_s, contact.to_s);
    }
    text
}

/// What the scans around a stroke say.
fn scanned(scan: &Scan) -> String {
    let name = &scan.stroke_id;
    match (scan.break_distance_m.zip(scan.break_distance_sd_m), &scan.reason) {
        (Some((distance_m, sd_m)), _) => {
            let [before, after] =
                [scan.before_s, scan.after_s].map(|t_s| t_s.map_or("-".into(), |t_s| format!("{t_s:.2}")));
            format!(
                "scans: {name} broke the ground {:.1} ± {:.1} mm ahead (clouds at {before} and {after} s)\n",
                1e3 * distance_m,
                1e3 * sd_m
            )
        }
        (None, reason) => {
            format!("scans: {name}: not told where the ground broke: {}\n", reason.as_deref().unwrap_or("-"))
        }
    }
}

fn free_air(air: &FreeAir) -> String {
    let mut text = format!("{:.0} s of free air", air.seconds);
    if let Some(noise) = &air.noise {
        text += &format!(": noise {:.3} N", noise.force_n());
        text += &noise.corner_hz.map_or(" (white)".to_owned(), |hz| format!(" (up to {hz:.0} Hz)"));
    }
    let norm = |v: [f64; 3]| v.iter().map(|part| part * part).sum::<f64>().sqrt();
    text += &format!(", drift {:.2} mN/s", norm(air.drift_n_per_s) * 1e3);
    if air.has_one_posture() {
        text += ", one posture, so bias and weight cannot be told apart, only their sum in that posture";
    } else {
        text += &format!(", weight {:.2} ± {:.2} N", air.weight_n, air.weight_sd_n);
        text += &air.centre_m.map_or(String::new(), |[x, y, z]| {
            format!(" at {:.1}, {:.1}, {:.1} mm", x * 1e3, y * 1e3, z * 1e3)
        });
    }
    text
}

fn analysis(answer: &Answer) -> String {
    let found = &answer.analysis;
    let mut text = String::new();
    if let Some(friction) = &found.friction {
        text += &format!("interface friction: {:.2} ± {:.2} deg, ", friction.delta_deg, friction.sd_deg);
        text += &match (friction.above_deg, friction.below_deg) {
            (Some(above), Some(below)) => format!("between {above} and {below} deg\n"),
            (Some(above), None) => format!("above {above} deg, the highest set-point: sweep further up\n"),
            (None, Some(below)) => format!("below {below} deg, the lowest set-point: sweep further down\n"),
            (None, None) => "without a bracket\n".into(),
        };
    }
    if let Some(rubbing) = &found.rubbing {
        text += &format!(
            "rubbing: {:.2} deg, range {:.2} to {:.2} deg ({} peaks)\n",
            rubbing.peak_deg, rubbing.range_deg[0], rubbing.range_deg[1], rubbing.peaks
        );
    }
    for law in &found.depth_laws {
        let [low, high] = law.exponent_95;
        text += &format!(
            "depth law at {} deg: F ~ H^{:.3}, 95 % {low:.3} to {high:.3} ({} strokes)\n",
            number(law.alpha_deg),
            law.exponent,
            law.strokes
        );
    }
    if !found.groups.is_empty() {
        let mut rows = vec![
            ["alpha deg", "strokes", "mean N", "sd N", "variation %", "outliers", "matched phi deg"]
                .map(str::to_owned)
                .to_vec(),
        ];
        for group in &found.groups {
            let or_dash = |value: Option<f64>, digits: usize| {
                value.map_or("-".into(), |value| format!("{value:.digits$}"))
            };
            rows.push(vec![
                number(group.alpha_deg),
                group.strokes.to_string(),
                format!("{:.3}", group.mean_n),
                or_dash(group.sd_n, 3),
                or_dash(group.coefficient_of_variation.map(|v| v * 100.0), 1),
                group.outliers.join(" "),
                or_dash(group.matched_phi_deg, 2),
            ]);
        }
        text += &format!("at a slant length of {} mm:\n", number(found.slant_m * 1e3));
        text += &columns(&rows);
    }
    for (name, dependence) in [("radius", &found.radius), ("base angle", &found.base_angle)] {
        if let Some(d) = dependence {
            text += &format!("{name}: {}\n", d.verdict);
        }
    }
    text
}
