//! Whether something is buried ahead of strokes, by their force.

mod answer;
mod request;
mod strokes;
mod words;

pub use answer::{AlarmAnswer, Answer, LookAnswer, PlaceAnswer, RegionAnswer, StrokeAnswer, Verdict};
pub use request::Request;
use soilctl_process::ProcessError;
use soilctl_process::ahead::{Course, Expected, Judged, Ratios, Test, region};
use strokes::Stroke;

use crate::{AppError, Watch};

/// Tool angles further from upright than this, in deg, are none that the bounds were made for.
const UPRIGHT_DEG: f64 = 5.0;

/// Judges the strokes of logs.
///
/// # Errors
/// [`AppError`] if the request makes no sense, no log has a stroke, or a file cannot be written.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    crate::request::check(request)?;
    let ratios = Ratios::shipped();
    let phi_deg = match request.phi_deg.as_slice() {
        [] => ratios.phi_deg(),
        &[from, to] if from <= to => [from, to],
        &[one] => [one, one],
        other => {
            let given: Vec<String> = other.iter().map(|phi| crate::text::number(*phi)).collect();
            return Err(AppError::Request(format!(
                "--phi is {}; give the least and then the greatest friction angle in deg, as 36,40",
                given.join(",")
            )));
        }
    };
    let [least, most] = ratios.phi_deg();
    if let Some(phi) = phi_deg.into_iter().find(|phi| !(least..=most).contains(phi)) {
        return Err(AppError::OutOfRange {
            key: "--phi".into(),
            value: crate::text::number(phi),
            allowed: format!("from {least} to {most} deg, for which there are bounds"),
        });
    }
    if let Some(path) = &request.table {
        crate::files::can_be_written(path)?;
        crate::files::table_form(path)?;
    }
    let read = strokes::read(request, watch)?;
    if !read.strokes.iter().any(|stroke| !stroke.is_reference) {
        let first = read.problems.first().cloned().unwrap_or_default();
        return Err(AppError::Request(
            format!("the logs hold no stroke to judge. {first}").trim_end().to_owned(),
        ));
    }
    let test = Test { false_alarms: request.false_alarms, left_out: 1.0 - request.confidence };
    let judged = judge(&read.strokes, &test, !request.reference.is_empty());
    let mut answers = Vec::new();
    for (stroke, judged) in read.strokes.iter().zip(judged) {
        if !stroke.is_reference {
            answers.push(answer_of(stroke, judged, &ratios, phi_deg)?);
        }
    }
    let count = |verdict| answers.iter().filter(|stroke| stroke.verdict == verdict).count();
    let references = read.strokes.iter().filter(|stroke| stroke.is_reference).count();
    let mut answer = Answer {
        verdict: String::new(),
        alarms: count(Verdict::Alarm),
        quiet: count(Verdict::Quiet),
        not_judged: count(Verdict::NotJudged),
        false_alarms: request.false_alarms,
        confidence: request.confidence,
        references: (!request.reference.is_empty()).then_some(references),
        phi_deg,
        strokes: answers,
        problems: read.problems,
        notes: Vec::new(),
    };
    answer.verdict = words::verdict(&answer);
    answer.notes = words::notes(&answer);
    if let Some(path) = &request.table {
        answer.write_table(path)?;
    }
    Ok(answer)
}

/// What becomes of a stroke: judged, or why not.
type Outcome = Result<Judged, ProcessError>;

/// All strokes, in their order; references are not judged themselves.
///
/// Without references each stroke is compared with the others of its kind. One that stands out among all of them, as in fewer campaigns than the
/// probability of a false alarm any would by chance, counts for no other any more, and so on until none more does: else what one comes near would hide
/// what others do.
fn judge(strokes: &[Stroke], test: &Test, has_references: bool) -> Vec<Outcome> {
    let mut left_out = vec![false; strokes.len()];
    if !has_references {
        let strict = Test { false_alarms: test.false_alarms / strokes.len().max(1) as f64, ..*test };
        loop {
            let outcomes = outcomes(strokes, &strict, &left_out, false);
            let stand_out = outcomes.iter().enumerate().filter(|(place, _)| !left_out[*place]).filter_map(
                |(place, outcome)| match outcome {
                    Ok(judged) => judged.alarm.map(|_| (place, judged.strength())),
                    // Less than a limit by so much is as odd as more.
                    Err(ProcessError::Unlike { ratio, limit }) => Some((place, ratio.ln() / limit.ln())),
                    Err(_) => None,
                },
            );
            match stand_out.max_by(|a, b| a.1.total_cmp(&b.1)) {
                Some((place, _)) => left_out[place] = true,
                None => break,
            }
        }
    }
    outcomes(strokes, test, &left_out, has_references)
}

/// Each stroke compared with the others of its kind that are not left out.
fn outcomes(strokes: &[Stroke], test: &Test, left_out: &[bool], has_references: bool) -> Vec<Outcome> {
    let of = |place: usize, stroke: &Stroke| {
        let compares = |(other, with): &(usize, &Stroke)| {
            *other != place
                && with.kind == stroke.kind
                && !left_out[*other]
                && with.is_reference == has_references
        };
        let others = strokes.iter().enumerate().filter(compares);
        let others: Vec<&Course> = others.filter_map(|(_, with)| with.course.as_ref()).collect();
        let course = stroke.course.as_ref().filter(|_| !stroke.is_reference).ok_or(ProcessError::TooFew {
            what: "places at which the force says something",
            found: 0,
            least: 1,
        })?;
        Expected::of(&others)?.judge(course, test)
    };
    strokes.iter().enumerate().map(|(place, stroke)| of(place, stroke)).collect()
}

fn answer_of(
    stroke: &Stroke,
    outcome: Outcome,
    ratios: &Ratios,
    phi_deg: [f64; 2],
) -> Result<StrokeAnswer, AppError> {
    let mut answer = StrokeAnswer {
        stroke_id: stroke.id.clone(),
        start_s: stroke.start_s,
        alpha_deg: stroke.alpha_deg,
        depth_m: stroke.depth_m,
        verdict: Verdict::NotJudged,
        reason: None,
        references: 0,
        looks_planned: 0,
        alarm: None,
        looks: Vec::new(),
    };
    let judged = match outcome {
        Ok(judged) => judged,
        Err(problem) => return Ok(StrokeAnswer { reason: Some(problem.to_string()), ..answer }),
    };
    answer.verdict = if judged.alarm.is_some() { Verdict::Alarm } else { Verdict::Quiet };
    (answer.references, answer.looks_planned) = (judged.references, judged.planned);
    answer.looks = judged.looks.iter().map(LookAnswer::from).collect();
    if let Some(alarm) = judged.alarm
        && let Some(look) = judged.looks.get(alarm.look)
    {
        let is_upright = (stroke.alpha_deg - 90.0).abs() <= UPRIGHT_DEG;
        let seen = |up_to: usize| {
            let found = is_upright.then(|| region(&judged, up_to, ratios, phi_deg)).transpose()?;
            Ok::<_, AppError>(found.as_ref().map(RegionAnswer::from))
        };
        let last = judged.looks.len() - 1;
        answer.alarm = Some(AlarmAnswer {
            way_m: look.way_m,
            time_s: look.time_s,
            ratio: look.ratio,
            ratio_range: [look.ratio / look.factor, look.ratio * look.factor],
            from_the_beginning: alarm.from_the_beginning,
            region: seen(alarm.look)?,
            last_way_m: judged.looks.get(last).map_or(look.way_m, |look| look.way_m),
            last_region: seen(last)?,
        });
    }
    Ok(answer)
}
