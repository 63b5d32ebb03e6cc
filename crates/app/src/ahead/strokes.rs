//! Strokes of logs as courses of force.

use std::collections::BTreeMap;
use std::path::PathBuf;

use soilctl_jobs::each;
use soilctl_process::ProcessError;
use soilctl_process::ahead::Course;
use soilctl_process::log::{Candidate, read_log};
use soilctl_process::meant_angles_deg;

use super::Request;
use crate::process::{Inputs, Log, Request as Logs};
use crate::{AppError, Interrupted, Watch};

/// Strokes of one tool angle are of one kind if the deepest is no more than this times as deep as the shallowest.
const DEPTHS_OF_A_KIND: f64 = 1.3;

/// A stroke.
pub(super) struct Stroke {
    pub(super) id: String,
    pub(super) start_s: f64,
    pub(super) alpha_deg: f64,
    pub(super) depth_m: f64,
    /// `None` if its force says nothing.
    pub(super) course: Option<Course>,
    /// Strokes of one kind can be compared.
    pub(super) kind: usize,
    pub(super) is_reference: bool,
}

/// What logs hold.
pub(super) struct Read {
    pub(super) strokes: Vec<Stroke>,
    pub(super) problems: Vec<String>,
    logs: usize,
}

/// All strokes of logs, those of references after the others.
pub(super) fn read(request: &Request, watch: &dyn Watch) -> Result<Read, AppError> {
    let mut found = Read { strokes: Vec::new(), problems: Vec::new(), logs: 0 };
    for (logs, is_reference) in [(&request.logs, false), (&request.reference, true)] {
        if !logs.is_empty() {
            read_part(request, logs.clone(), is_reference, watch, &mut found)?;
        }
    }
    assign_kinds(&mut found.strokes);
    Ok(found)
}

fn read_part(
    request: &Request,
    logs: Vec<PathBuf>,
    is_reference: bool,
    watch: &dyn Watch,
    found: &mut Read,
) -> Result<(), AppError> {
    let asked = Logs { logs, bag: request.bag.clone(), threads: request.threads, ..Logs::default() };
    let inputs = Inputs::of(&asked)?;
    let stop = watch.stop(Interrupted::LeavesNothing);
    watch.begin(inputs.logs.len() as u64, "logs");
    let places: Vec<usize> = (0..inputs.logs.len()).collect();
    let mut by_place: BTreeMap<usize, (Vec<Stroke>, Vec<String>)> = BTreeMap::new();
    let result = each(
        &places,
        inputs.threads,
        &stop,
        |place| {
            let log = &inputs.logs[*place];
            let (mut strokes, mut problems) = (Vec::new(), Vec::new());
            let summary = read_log(&log.path, &inputs.settings, &stop, &mut |candidate| match candidate {
                Candidate::Stroke(stroke) => {
                    let evaluated = &stroke.evaluated;
                    strokes.push(Stroke {
                        id: format!("{}-{}", log.name, strokes.len() + 1),
                        start_s: stroke.start_s,
                        alpha_deg: evaluated.row.alpha_deg,
                        depth_m: evaluated.row.depth_m,
                        course: Course::of(evaluated),
                        kind: 0,
                        is_reference,
                    });
                }
                Candidate::Rejected(nothing) if nothing.refused => {
                    problems.push(format!("{}: {}", log.path.display(), nothing.reason));
                }
                Candidate::Rejected(_) => {}
            });
            match summary {
                Ok(summary) => {
                    problems
                        .extend(summary.damage.iter().map(|what| format!("{}: {what}", log.path.display())));
                }
                Err(ProcessError::Stopped) => return Ok(None),
                Err(problem) => {
                    strokes.clear();
                    problems = vec![refusal(log, &problem)];
                }
            }
            Ok::<_, AppError>(Some((strokes, problems)))
        },
        |place, part| {
            watch.advance(1);
            by_place.insert(*place, part);
            Ok(())
        },
    );
    watch.end();
    result?;
    if by_place.len() < inputs.logs.len() {
        return Err(AppError::Request("the work was stopped before all logs were read".into()));
    }
    for (mut strokes, problems) in by_place.into_values() {
        // A log is taken for one preparation of the soil.
        let preparation = found.logs;
        found.logs += 1;
        for stroke in &mut strokes {
            stroke.course = stroke.course.take().map(|course| course.in_preparation(preparation));
        }
        found.strokes.extend(strokes);
        found.problems.extend(problems);
    }
    Ok(())
}

fn refusal(log: &Log, problem: &ProcessError) -> String {
    format!("{}: {problem}", log.path.display())
}

/// One kind for each tool angle that was meant, and depths that are near each other.
fn assign_kinds(strokes: &mut [Stroke]) {
    let meant = meant_angles_deg(&strokes.iter().map(|stroke| stroke.alpha_deg).collect::<Vec<_>>());
    let mut order: Vec<usize> = (0..strokes.len()).collect();
    order.sort_by(|a, b| {
        meant[*a].total_cmp(&meant[*b]).then(strokes[*a].depth_m.total_cmp(&strokes[*b].depth_m))
    });
    let (mut kind, mut first) = (0, None);
    for place in order {
        let (angle, depth_m) = (meant[place], strokes[place].depth_m);
        if let Some((of_angle, shallowest_m)) = first
            && (angle != of_angle || depth_m > DEPTHS_OF_A_KIND * shallowest_m)
        {
            kind += 1;
            first = None;
        }
        first.get_or_insert((angle, depth_m));
        strokes[place].kind = kind;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_are_of_one_angle_and_near_depths() {
        let stroke = |alpha_deg: f64, depth_m: f64| Stroke {
            id: String::new(),
            start_s: 0.0,
            alpha_deg,
            depth_m,
            course: None,
            kind: 0,
            is_reference: false,
        };
        let mut strokes = [
            stroke(90.02, 0.03),
            stroke(80.0, 0.03),
            stroke(89.98, 0.033),
            stroke(90.0, 0.05),
            stroke(90.0, 0.025),
        ];
        assign_kinds(&mut strokes);
        assert_eq!(strokes.map(|stroke| stroke.kind), [1, 0, 2, 3, 1]);
    }
}
