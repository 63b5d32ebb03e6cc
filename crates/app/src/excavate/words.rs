//! The answer in a sentence or two.

use super::answer::{Answer, DugTrench, Ended, Manner};
use super::request::{Least, Request};
use crate::text::number;

/// What was found, in words.
pub(super) fn verdict(answer: &Answer, request: &Request) -> String {
    let mut words = plan(answer, request);
    for dug in &answer.dug {
        words += " ";
        words += &trench(dug, request);
    }
    if let Some(compared) = compared(answer) {
        words += " ";
        words += &compared;
    }
    words
}

fn plan(answer: &Answer, request: &Request) -> String {
    let percent = |share: f64| number((100.0 * share).round());
    match answer.passes.first() {
        None => format!(
            "No pass of {} mm keeps to {} % of the torque limits in every soil that is possible: allow a greater share, other tool angles or a shorter \
             trench, or learn more of the soil.",
            number(1e3 * answer.at[1]),
            percent(request.share)
        ),
        Some(first) => {
            let angles = answer.passes.iter().map(|pass| pass.alpha_deg);
            let (low, high) = angles.fold((f64::INFINITY, 0.0_f64), |(l, h), a| (l.min(a), h.max(a)));
            let at = if high - low < 0.5 {
                format!("{high:.0} deg")
            } else {
                format!("{low:.0} to {high:.0} deg")
            };
            let least = match answer.least {
                Least::Torque => "the least torque",
                Least::Heat => "the least heat",
                Least::Work => "the least work",
            };
            let whole = if answer.complete {
                format!("{} mm are dug in {}", number(1e3 * request.depth_m), passes(answer.passes.len()))
            } else {
                format!(
                    "after {} passes none keeps the share, and the trench is not as deep as wanted",
                    answer.passes.len()
                )
            };
            format!(
                "A tool angle of {at} takes {least}; {whole}, the first {:.1} mm deep, in every soil that is possible with at most {} % of the torque \
                 limits.",
                1e3 * first.depth_m,
                percent(request.share)
            )
        }
    }
}

fn trench(dug: &DugTrench, request: &Request) -> String {
    let how = match dug.manner {
        Manner::Learning => "Replanned by what passes taught",
        Manner::Planned => "Without learning",
        Manner::Fixed => "At a fixed 90 deg",
    };
    let what = match dug.ended {
        Ended::Complete => "dug",
        Ended::TooStrong => "given up, since no pass keeps the share in all soils that are possible,",
        Ended::StrokeFailed => "ended by a stroke that failed",
        Ended::TooManyPasses => "not done in as many passes as there may be",
        Ended::Stopped => "broken off",
    };
    format!(
        "{how}: {:.1} of {:.1} mm {what} in {}, at most {:.0} % of a torque limit, {:.2} J of work, {:.0} A2 s.",
        1e3 * dug.depth_m,
        1e3 * request.depth_m,
        passes(dug.passes.len()),
        100.0 * dug.peak_share,
        dug.work_j,
        dug.heat_a2s
    )
}

fn passes(count: usize) -> String {
    format!("{count} {}", if count == 1 { "pass" } else { "passes" })
}

/// Chosen tool angles against the fixed one, where both made the trench.
fn compared(answer: &Answer) -> Option<String> {
    let of = |manner| answer.dug.iter().find(|dug| dug.manner == manner && dug.ended == Ended::Complete);
    let (chosen, fixed) = (of(Manner::Planned)?, of(Manner::Fixed)?);
    let change = |a: f64, b: f64| 100.0 * (a / b - 1.0);
    Some(format!(
        "Against the fixed angle: peak torque {:+.0} %, work for a volume {:+.0} %, heat for a volume {:+.0} %.",
        change(chosen.peak_share, fixed.peak_share),
        change(chosen.work_kj_m3?, fixed.work_kj_m3?),
        change(chosen.heat_a2s_per_l?, fixed.heat_a2s_per_l?)
    ))
}
