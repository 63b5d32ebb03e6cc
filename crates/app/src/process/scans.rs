//! Clouds of points in a recording of arm and scans: where the ground broke ahead of its strokes, as [`heights`](crate::heights) reads it.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::ControlFlow;
use std::sync::atomic::AtomicBool;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_bag::BagError;
use soilctl_heights::{Cloud, Clouds, HeightsError, clouds, read_clouds};
use soilctl_motion::{Motion, Settings, motion};
use soilctl_process::foreign::Contact;
use soilctl_process::log::LogSettings;
use soilctl_process::table::StrokeRecord;

use super::inputs::{Inputs, Log};
use crate::heights;

/// What the scans before and after a stroke say.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Scan {
    /// Name of the stroke.
    pub stroke_id: String,
    /// When the cloud before it was taken (s on the log's clock); null if there is none in which the plate is out of the ground.
    pub before_s: Option<f64>,
    /// When the one after it was taken; null likewise.
    pub after_s: Option<f64>,
    /// Distance along the surface from the plate's face to where the ground broke (m); null if that cannot be said.
    pub break_distance_m: Option<f64>,
    /// Its standard deviation and resolution together (m).
    pub break_distance_sd_m: Option<f64>,
    /// Why there is no distance; null if there is one.
    pub reason: Option<String>,
    /// What to keep in mind about the maps.
    pub warnings: Vec<String>,
}

/// A stroke, and when it began and ended on the log's clock.
pub(super) struct Pushed<'a> {
    pub(super) record: &'a mut StrokeRecord,
    pub(super) window_s: [f64; 2],
}

/// Looks for scans around the strokes of a log, writes distances into their rows, and says what was found; nothing if the recording has no clouds.
///
/// # Errors
/// Why there are clouds that cannot be used, in words.
pub(super) fn read(
    strokes: &mut [Pushed<'_>],
    contacts: &[Contact],
    log: &Log,
    inputs: &Inputs,
    stop: &AtomicBool,
) -> Result<Vec<Scan>, String> {
    let topic = inputs.scan_topic.as_deref();
    let found = match clouds(&log.path, topic) {
        Ok(Some(found)) => found,
        Ok(None) => return Ok(Vec::new()),
        Err(HeightsError::Bag(problem @ BagError::Topic { .. })) if topic.is_none() => {
            return Err(format!("clouds of points are not used: {problem}; name one by --scan-topic"));
        }
        Err(problem) => return Err(format!("clouds of points are not used: {problem}")),
    };
    let arm = motion(&log.path, &of_arm(&inputs.settings), stop)
        .map_err(|problem| format!("clouds on {} are not used: {problem}", found.topic))?;
    let times: Vec<f64> = found.taken.iter().map(|taken| arm.columns.clock.seconds(taken.time_ns)).collect();
    let edges = edges_m(&arm, times.iter().copied());
    let taken = times.into_iter().zip(edges).zip(&found.taken);
    let taken: Vec<Shot> =
        taken.map(|((t_s, edge_m), taken)| Shot { t_s, edge_m, logged_ns: taken.logged_ns }).collect();
    let mut asked: Vec<Asked<'_>> = strokes
        .iter_mut()
        .map(|stroke| {
            let [from_s, to_s] = stroke.window_s;
            let ended = contacts.iter().map(|contact| contact.to_s).filter(|t_s| *t_s <= from_s);
            let begun = contacts.iter().map(|contact| contact.from_s).filter(|t_s| *t_s >= to_s);
            let seen = Seen {
                arm: &arm,
                taken: &taken,
                since_s: ended.fold(f64::NEG_INFINITY, f64::max),
                until_s: begun.fold(f64::INFINITY, f64::min),
            };
            let around = seen.around(stroke.window_s, stroke.record.row.depth_m);
            Asked::new(&mut *stroke.record, around)
        })
        .collect();
    let request = heights::Request {
        before: log.path.clone(),
        after: log.path.clone(),
        topic: Some(found.topic.clone()),
        ..heights::Request::default()
    };
    answer(&mut asked, &request, &arm, &found);
    Ok(asked.into_iter().map(|asked| asked.scan).collect())
}

/// Reads the clouds that strokes ask for, once, and answers each stroke when both of its clouds are there; none is kept longer than strokes need it.
fn answer(asked: &mut [Asked<'_>], request: &heights::Request, arm: &Motion, found: &Clouds) {
    let wanted: BTreeSet<u64> = asked.iter().filter_map(|asked| asked.clouds_ns).flatten().collect();
    let mut kept: BTreeMap<u64, Result<Cloud, String>> = BTreeMap::new();
    let done = read_clouds(&request.before, &found.topic, &wanted, &mut |logged_ns, cloud| {
        let cloud = heights::into_root(arm, cloud).map_err(|problem| problem.to_string());
        kept.insert(logged_ns, cloud);
        for asked in &mut *asked {
            if let Some([before, after]) = asked.clouds_ns
                && let (Some(before), Some(after)) = (kept.get(&before), kept.get(&after))
            {
                asked.answer([before, after], request, arm, &found.notes);
            }
        }
        kept.retain(|kept, _| asked.iter().any(|asked| asked.clouds_ns.is_some_and(|ns| ns.contains(kept))));
        let is_done = asked.iter().all(|asked| asked.clouds_ns.is_none());
        if is_done { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let why =
        done.map_or_else(|problem| problem.to_string(), |()| "they are not in the recording any more".into());
    for asked in asked.iter_mut().filter(|asked| asked.clouds_ns.is_some()) {
        asked.scan.reason = Some(format!("its clouds were found and could not be read again: {why}"));
    }
}

/// The arm as `process` reads it.
fn of_arm(settings: &LogSettings) -> Settings {
    Settings {
        urdf: settings.urdf.clone(),
        joint_topic: settings.joint_topic.clone(),
        end_link: settings.plate_frame.clone(),
        ..Settings::default()
    }
}

/// A cloud: when it was taken on the log's clock and logged, and the height of the plate's lower edge then.
#[derive(Clone, Copy)]
struct Shot {
    t_s: f64,
    edge_m: Option<f64>,
    logged_ns: u64,
}

/// Height of the plate's lower edge at times.
fn edges_m(arm: &Motion, times_s: impl IntoIterator<Item = f64>) -> Vec<Option<f64>> {
    let mut heights = Vec::new();
    arm.states(times_s, &mut |state| heights.push(state.tip_m.map(|tip| tip[2])));
    heights
}

/// What may be looked at for a stroke: clouds after the contact before it, and before the one after it.
struct Seen<'a> {
    arm: &'a Motion,
    taken: &'a [Shot],
    since_s: f64,
    until_s: f64,
}

impl Seen<'_> {
    /// The last cloud before a stroke and the first after it in which the plate's edge is at the surface or above.
    fn around(&self, [from_s, to_s]: [f64; 2], depth_m: f64) -> [Option<Shot>; 2] {
        let during = self.arm.times_s(0.0).into_iter().filter(|t_s| (from_s..=to_s).contains(t_s));
        let lowest = edges_m(self.arm, during).into_iter().flatten().fold(f64::INFINITY, f64::min);
        let is_out = |shot: &&Shot| shot.edge_m.is_some_and(|edge| edge >= lowest + depth_m);
        let mut out = self.taken.iter().filter(is_out);
        let before = out.clone().rfind(|shot| (self.since_s..from_s).contains(&shot.t_s));
        let after = out.find(|shot| shot.t_s > to_s && shot.t_s < self.until_s);
        [before.copied(), after.copied()]
    }
}

/// A stroke, and what is found out about it.
struct Asked<'a> {
    record: &'a mut StrokeRecord,
    scan: Scan,
    /// When the clouds before and after it were logged, until they are read; `None` if there are not two.
    clouds_ns: Option<[u64; 2]>,
}

impl<'a> Asked<'a> {
    fn new(record: &'a mut StrokeRecord, [before, after]: [Option<Shot>; 2]) -> Self {
        let reason = match (before, after) {
            (None, _) => Some("no cloud since the contact before it has the plate out of the ground"),
            (_, None) => Some("no cloud until the next contact has the plate out of the ground"),
            (Some(_), Some(_)) => None,
        };
        let scan = Scan {
            stroke_id: record.row.stroke_id.clone().unwrap_or_default(),
            before_s: before.map(|shot| shot.t_s),
            after_s: after.map(|shot| shot.t_s),
            break_distance_m: None,
            break_distance_sd_m: None,
            reason: reason.map(str::to_owned),
            warnings: Vec::new(),
        };
        let clouds_ns = before.zip(after).map(|(before, after)| [before.logged_ns, after.logged_ns]);
        Self { record, scan, clouds_ns }
    }

    fn answer(
        &mut self,
        clouds: [&Result<Cloud, String>; 2],
        request: &heights::Request,
        arm: &Motion,
        notes: &[String],
    ) {
        self.clouds_ns = None;
        let clouds = match clouds {
            [Ok(before), Ok(after)] => [before.clone(), after.clone()],
            [Err(problem), _] | [_, Err(problem)] => {
                self.scan.reason = Some(problem.clone());
                return;
            }
        };
        let (row, scan) = (&mut self.record.row, &mut self.scan);
        match heights::of_stroke(request, arm, clouds, row.width_m, row.depth_m) {
            Ok(answer) => {
                let broke = answer.ground_break.as_ref();
                row.break_distance_m = broke.map(|broke| broke.distance_m);
                row.break_distance_sd_m = broke.map(|broke| broke.table_sd_m);
                (scan.break_distance_m, scan.break_distance_sd_m) =
                    (row.break_distance_m, row.break_distance_sd_m);
                scan.reason = answer.no_break_because;
                scan.warnings = notes.iter().cloned().chain(answer.warnings).collect();
            }
            Err(problem) => scan.reason = Some(problem.to_string()),
        }
    }
}
