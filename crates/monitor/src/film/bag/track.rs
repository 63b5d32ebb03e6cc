use std::sync::Arc;

use soilctl_live::protocol::{Hello, PROTOCOL_VERSION, SafeForce};
use soilctl_motion::Motion;

use crate::arm::ArmMessage;
use crate::film::{Reel, curve, halve, overview};
use crate::messages::{History, LogMessage, PageMessage, PoseMessage, SceneMessage, text};

/// States that are kept. When there are more, every second one goes, so that memory stays bounded.
const MOST_MOMENTS: usize = 1 << 18;
/// Time between two states in s, to begin with.
const INTERVAL_S: f64 = 0.03;

/// A state in little memory.
#[derive(Debug, Clone)]
pub(super) struct Moment {
    pub(super) t_s: f64,
    /// Of the joints in the order of their names, in rad or m; NaN, or nothing at the end, where none was heard.
    pub(super) positions: Box<[f32]>,
    /// Where the end link is in the root frame in m; NaN if joints are missing.
    pub(super) tip_m: [f32; 3],
    /// The force in the root frame in N; NaN without.
    pub(super) force_n: [f32; 3],
}

impl Moment {
    /// Size of the force.
    fn size_n(&self) -> f32 {
        self.force_n.iter().map(|part| part * part).sum::<f32>().sqrt()
    }
}

/// A bag, ready to be played.
#[derive(Debug)]
pub(crate) struct Track {
    urdf: String,
    arm: ArmMessage,
    space_m: [[f64; 3]; 2],
    /// Meshes as pages take them, by their numbers.
    pub(super) meshes: Vec<Arc<[u8]>>,
    end_link: String,
    /// Names of the joints in the order of the URDF.
    joints: Vec<String>,
    ground_z_m: Option<f64>,
    has_force: bool,
    pub(super) moments: Vec<Moment>,
    pub(super) interval_s: f64,
    /// What is wrong with the file.
    pub(super) damage: Vec<String>,
    /// What was odd, or could not be used.
    pub(super) notes: Vec<String>,
}

impl Track {
    pub(super) fn new(
        motion: &Motion,
        arm: ArmMessage,
        space_m: [[f64; 3]; 2],
        ground_z_m: Option<f64>,
    ) -> Self {
        Self {
            urdf: motion.text.clone(),
            arm,
            space_m,
            end_link: motion.end_link.clone(),
            joints: motion.joints.clone(),
            ground_z_m,
            has_force: !motion.columns.wrenches.t_s.is_empty(),
            ..Self::empty()
        }
    }

    fn empty() -> Self {
        Self {
            urdf: String::new(),
            arm: ArmMessage::default(),
            space_m: [[0.0; 3]; 2],
            meshes: Vec::new(),
            end_link: String::new(),
            joints: Vec::new(),
            ground_z_m: None,
            has_force: false,
            moments: Vec::new(),
            interval_s: INTERVAL_S,
            damage: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// Whether a state at this time is one that is kept.
    pub(super) fn is_due(&self, t_s: f64) -> bool {
        // Steps such as 0.01 s are no floating-point numbers.
        self.moments.last().is_none_or(|last| t_s >= last.t_s + self.interval_s - 1e-6)
    }

    pub(super) fn push(&mut self, moment: Moment) {
        if self.moments.len() >= MOST_MOMENTS {
            halve(&mut self.moments);
            self.interval_s *= 2.0;
        }
        self.moments.push(moment);
    }

    fn time_s(&self, number: usize) -> f64 {
        self.moments.get(number).or(self.moments.last()).map_or(0.0, |moment| moment.t_s)
    }

    /// What a page draws.
    fn pose(&self, number: usize) -> Option<PoseMessage<'_>> {
        let moment = self.moments.get(number)?;
        let some = |vector: [f32; 3]| vector[0].is_finite().then_some(vector);
        Some(PoseMessage {
            tick: number,
            time_s: moment.t_s,
            positions: &moment.positions,
            tip_m: some(moment.tip_m),
            force_n: some(moment.force_n),
        })
    }

    /// What was odd, or could not be used.
    pub(crate) fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Meshes by their numbers.
    pub(crate) fn meshes(&self) -> &[Arc<[u8]>] {
        &self.meshes
    }

    /// What is wrong with the file.
    pub(crate) fn damage(&self) -> &[String] {
        &self.damage
    }

    /// Adds a state to curves.
    fn curve(&self, number: usize, history: &mut History) {
        let Some(moment) = self.moments.get(number) else { return };
        let some = |value: f32| value.is_finite().then_some(value);
        history.time_s.push(moment.t_s);
        history.force_n.push(some(moment.size_n()));
        history.z_m.push(some(moment.tip_m[2]));
        history.positions.push(moment.positions.iter().copied().map(some).collect());
    }

    pub(crate) fn hello(&self) -> Hello {
        Hello {
            protocol: PROTOCOL_VERSION,
            program: String::new(),
            real_time: false,
            simulated: false,
            tick_s: self.interval_s,
            strokes: 0,
            safe_force: SafeForce { angle_deg: Vec::new(), force_n: Vec::new() },
        }
    }

    pub(crate) fn scene(&self, name: &str) -> SceneMessage {
        let mut tip_box_m = [[0.0_f32; 3]; 2];
        let tips = self.moments.iter().map(|moment| moment.tip_m).filter(|tip| tip[0].is_finite());
        for tip in tips {
            for (axis, place) in tip.iter().enumerate() {
                tip_box_m[0][axis] = tip_box_m[0][axis].min(*place);
                tip_box_m[1][axis] = tip_box_m[1][axis].max(*place);
            }
        }
        SceneMessage {
            name: name.to_owned(),
            live: false,
            commands: false,
            words: Vec::new(),
            urdf: self.urdf.clone(),
            arm: self.arm.clone(),
            space_m: Some(self.space_m),
            tip_link: self.end_link.clone(),
            plate: None,
            sandbox: None,
            soil: String::new(),
            joints: self.joints.clone(),
            ground_z_m: self.ground_z_m,
            tip_box_m: Some(tip_box_m),
            has_force: self.has_force,
            hand: None,
        }
    }

    pub(crate) fn message(&self) -> LogMessage {
        LogMessage {
            from_s: self.time_s(0),
            to_s: self.time_s(usize::MAX),
            state_s: self.interval_s,
            strokes: Vec::new(),
            events: Vec::new(),
            events_left_out: 0,
            overview_n: overview(self.moments.iter().map(|moment| moment.size_n().max(0.0))),
            damage: self.damage.clone(),
            notes: self.notes.clone(),
        }
    }
}

impl Reel for Arc<Track> {
    fn place_s(&self, time_s: f64) -> usize {
        self.moments.partition_point(|moment| moment.t_s <= time_s + 1e-9).saturating_sub(1)
    }

    fn time_s(&self, number: usize) -> f64 {
        Track::time_s(self, number)
    }

    fn tell(&mut self, seen: Option<usize>, place: usize, tell: &mut dyn FnMut(String)) {
        let mut history = History { replace: seen.is_none(), ..History::default() };
        curve(seen, place).for_each(|number| self.curve(number, &mut history));
        tell(text(&PageMessage::History(history)));
        if let Some(pose) = self.pose(place) {
            tell(text(&PageMessage::Pose(pose)));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_log_stays_small_and_whole() {
        let mut track = Track::empty();
        let count = MOST_MOMENTS * 3;
        for number in 0..count {
            #[allow(clippy::cast_precision_loss, reason = "small")]
            let t_s = 0.03 * number as f64;
            if track.is_due(t_s) {
                let nowhere = [f32::NAN; 3];
                track.push(Moment { t_s, positions: [].into(), tip_m: nowhere, force_n: nowhere });
            }
        }
        let kept = track.moments.len();
        assert!(kept <= MOST_MOMENTS && kept > MOST_MOMENTS / 2, "{kept}");
        let gaps = track.moments.windows(2).map(|pair| pair[1].t_s - pair[0].t_s);
        assert!(gaps.fold(0.0, f64::max) < 0.1201);
        let track = Arc::new(track);
        let last = track.pose(track.place_s(1e9)).map(|pose| pose.time_s);
        assert_eq!((track.time_s(0), last), (0.0, Some(track.time_s(usize::MAX))));
        assert!(track.pose(kept).is_none());
    }
}
