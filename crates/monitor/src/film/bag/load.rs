use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_motion::{Motion, Settings, State, motion};

use super::track::{Moment, Track};
use crate::MonitorError;
use crate::arm::ArmMessage;
use crate::meshes::packed;

/// Moments at which the space that the arm takes is measured.
const MEASURED: usize = 200;

/// Reads a recording.
pub(in crate::film) fn load(path: &Path, settings: &Settings) -> Result<Track, MonitorError> {
    let refused =
        |problem| MonitorError::Bag { file: path.display().to_string(), problem: Box::new(problem) };
    let never = AtomicBool::new(false);
    let motion = motion(path, settings, &never).map_err(refused)?;
    let arm = ArmMessage::of(&motion.urdf, &motion.meshes);
    let space_m = space_m(&motion, &arm);
    let mut track = Track::new(&motion, arm, space_m, settings.surface_z_m);
    let times = motion.times_s(track.interval_s);
    motion.states(times, &mut |state| {
        if track.is_due(state.t_s) {
            track.push(moment(&state));
        }
    });
    track.meshes = motion.meshes.values().map(packed).collect();
    (track.damage, track.notes) = (motion.columns.damage, motion.notes);
    Ok(track)
}

#[allow(clippy::cast_possible_truncation, reason = "to be looked at")]
fn moment(state: &State) -> Moment {
    let small =
        |vector: Option<[f64; 3]>| vector.map_or([f32::NAN; 3], |vector| vector.map(|part| part as f32));
    Moment {
        t_s: state.t_s,
        positions: state.positions.iter().map(|position| *position as f32).collect(),
        tip_m: small(state.tip_m),
        force_n: small(state.force_n),
    }
}

/// Corners of the space that the arm takes, all links and shapes, at moments from the first to the last.
fn space_m(motion: &Motion, arm: &ArmMessage) -> [[f64; 3]; 2] {
    let times = motion.times_s(0.0);
    let step = times.len().div_ceil(MEASURED).max(1);
    let mut space = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    motion.states(times.iter().copied().step_by(step).chain(times.last().copied()), &mut |state| {
        arm.extend(&motion.link_poses(&state.positions), &mut space);
    });
    if space[0][0].is_finite() { space } else { [[0.0; 3]; 2] }
}
