//! What monitor and page say to each other beside the operators' protocol (`docs/monitor.md`).

use serde::{Deserialize, Serialize};
use soilctl_live::protocol::{Event, StateMessage};

use crate::arm::ArmMessage;

/// A message as text. Numbers that are not finite become null.
pub(crate) fn text<T: Serialize>(message: &T) -> String {
    // Our messages have text keys only, so nothing can fail.
    serde_json::to_string(message).unwrap_or_default()
}

/// What the monitor adds to the messages of a session.
#[derive(Debug, Serialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub(crate) enum PageMessage<'a> {
    /// What does not move.
    Scene(Box<SceneMessage>),
    /// The log that is played, as a whole.
    Log(&'a LogMessage),
    /// Curves.
    History(History),
    /// Where the joints of a log of another program are.
    Pose(PoseMessage<'a>),
    /// Heights of a rectangle of the surface.
    Soil(Patch),
    /// Where the playback stands.
    Player(PlayerState),
    /// Whether the session is there.
    Link { connected: bool, message: String },
    /// The token was right.
    Authorized,
}

/// The arm, the box, and who shows them.
#[derive(Debug, Serialize)]
pub(crate) struct SceneMessage {
    /// Name of the socket or log.
    pub(crate) name: String,
    /// A live session, not a log.
    pub(crate) live: bool,
    /// Whether commands are on.
    pub(crate) commands: bool,
    /// Words that [`PageRequest::Line`] knows, and what they do.
    pub(crate) words: Vec<[&'static str; 2]>,
    pub(crate) urdf: String,
    /// What the URDF says, checked.
    pub(crate) arm: ArmMessage,
    /// The link whose origin is the end-point.
    pub(crate) tip_link: String,
    /// None of a log of another program, as is the box.
    pub(crate) plate: Option<PlateSize>,
    pub(crate) sandbox: Option<Sandbox>,
    /// Name of the soil for people, or empty.
    pub(crate) soil: String,
    /// Names of the joints in a [`PoseMessage`]; empty if there are none.
    pub(crate) joints: Vec<String>,
    /// Height of the ground, if it is known.
    pub(crate) ground_z_m: Option<f64>,
    /// Corners of the space in which the end-point and the base are, where there is no box.
    pub(crate) tip_box_m: Option<[[f32; 3]; 2]>,
    /// Corners of the space that all of the arm takes, where there is no box.
    pub(crate) space_m: Option<[[f64; 3]; 2]>,
    /// Whether forces are known.
    pub(crate) has_force: bool,
    /// How a hand may lead the plate; none of a log of another program.
    pub(crate) hand: Option<HandRange>,
}

/// How far, fast and hard the plate follows a hand.
#[derive(Debug, Clone, Copy, Serialize)]
pub(crate) struct HandRange {
    /// Where the edge may be.
    pub(crate) radius_m: [f64; 2],
    pub(crate) height_m: [f64; 2],
    pub(crate) base_deg: [f64; 2],
    pub(crate) speed_m_s: f64,
    /// Force of the soil at which the arm no longer pushes.
    pub(crate) force_n: f64,
    /// How long the arm goes on without word from the hand.
    pub(crate) lease_s: f64,
}

/// A state of a log of another program, in the root frame.
#[derive(Debug, Serialize)]
pub(crate) struct PoseMessage<'a> {
    /// Number of the state.
    pub(crate) tick: usize,
    pub(crate) time_s: f64,
    /// In the order of the scene's joints, in rad or m; null, or nothing at the end, where none was heard yet.
    pub(crate) positions: &'a [f32],
    pub(crate) tip_m: Option<[f32; 3]>,
    /// As the sensor reads it.
    pub(crate) force_n: Option<[f32; 3]>,
}

/// Size of the plate.
#[derive(Debug, Clone, Copy, Serialize)]
pub(crate) struct PlateSize {
    pub(crate) width_m: f64,
    pub(crate) height_m: f64,
    pub(crate) thickness_m: f64,
}

/// Inner faces of the box in the base frame, and its sand.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct Sandbox {
    pub(crate) x_m: [f64; 2],
    pub(crate) y_m: [f64; 2],
    pub(crate) floor_z_m: f64,
    pub(crate) top_z_m: f64,
    /// Level of the raked sand.
    pub(crate) surface_z_m: f64,
    pub(crate) cell_m: f64,
}

/// What a page is told about a log.
#[derive(Debug, Serialize)]
pub(crate) struct LogMessage {
    pub(crate) from_s: f64,
    pub(crate) to_s: f64,
    pub(crate) state_s: f64,
    pub(crate) strokes: Vec<StrokeSpan>,
    pub(crate) events: Vec<Event>,
    pub(crate) events_left_out: usize,
    /// Largest force in N in even parts of the log.
    pub(crate) overview_n: Vec<f32>,
    /// What is wrong with the file.
    pub(crate) damage: Vec<String>,
    /// What was odd about another program's recording, or could not be used.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) notes: Vec<String>,
}

/// A stroke in a log.
#[derive(Debug, Clone, Serialize)]
pub(crate) struct StrokeSpan {
    pub(crate) number: String,
    pub(crate) start_s: f64,
    pub(crate) end_s: f64,
    pub(crate) finish: String,
}

/// Curves, column by column.
#[derive(Debug, Default, Serialize)]
pub(crate) struct History {
    /// Whether it takes the place of the curves so far, or goes on from them.
    pub(crate) replace: bool,
    pub(crate) time_s: Vec<f64>,
    pub(crate) force_n: Vec<Option<f32>>,
    pub(crate) friction_angle_deg: Vec<Option<f32>>,
    pub(crate) friction_setpoint_deg: Vec<Option<f32>>,
    pub(crate) z_m: Vec<Option<f32>>,
    pub(crate) displacement_m: Vec<Option<f32>>,
    /// What the controller does: off, fault, idle or the kind of trajectory.
    pub(crate) machine: Vec<String>,
    /// Of a log of another program: the joints in rad or m, in the order of the scene's.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(crate) positions: Vec<Vec<Option<f32>>>,
}

impl History {
    /// Adds what a state shows.
    #[allow(clippy::cast_possible_truncation, reason = "for curves")]
    pub(crate) fn push(&mut self, state: &StateMessage) {
        let [r, t, z] = state.force_rtz_n;
        let single = |value: Option<f64>| value.map(|value| value as f32);
        self.time_s.push(state.time_s);
        self.force_n.push(Some((r * r + t * t + z * z).sqrt() as f32));
        self.friction_angle_deg.push(single(state.friction_angle_deg));
        self.friction_setpoint_deg.push(single(state.friction_setpoint_deg));
        self.z_m.push(single(state.plate.map(|plate| plate.z_m)));
        self.displacement_m.push(single(state.displacement_m));
        self.machine.push(match (state.mode.as_str(), &state.trajectory) {
            ("ready", Some(trajectory)) => trajectory.clone(),
            ("ready", None) => "idle".to_owned(),
            (mode, _) => mode.to_owned(),
        });
    }
}

/// A rectangle of the surface: cells from (`column`, `row`), row by row, heights above `surface_z_m` in units of 0.01 mm.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub(crate) struct Patch {
    pub(crate) grid: [usize; 2],
    pub(crate) column: usize,
    pub(crate) row: usize,
    pub(crate) columns: usize,
    pub(crate) heights: Vec<i32>,
}

/// Where a playback stands.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct PlayerState {
    pub(crate) time_s: f64,
    pub(crate) playing: bool,
    pub(crate) speed: f64,
    pub(crate) at_end: bool,
    /// `id` of the last request that it takes into account; 0 before the first.
    pub(crate) id: u64,
}

/// What a page asks of the monitor. Requests to a player may have an `id`, so that the page knows which of them a
/// [`PlayerState`] is about.
#[derive(Debug, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub(crate) enum PageRequest {
    /// May this page send commands?
    Authorize { token: String },
    /// A command as an operator types it.
    Line { id: u64, text: String },
    /// Which soil shall be dug next; where soils can be chosen.
    ChooseSoil { id: u64, soil: String },
    /// Go on.
    Play {
        #[serde(default)]
        id: u64,
    },
    /// Stand still.
    Pause {
        #[serde(default)]
        id: u64,
    },
    /// Go to a time.
    Seek {
        time_s: f64,
        #[serde(default)]
        id: u64,
    },
    /// So many states further, or back.
    Step {
        count: i32,
        #[serde(default)]
        id: u64,
    },
    /// How many times as fast as real time.
    Speed {
        speed: f64,
        #[serde(default)]
        id: u64,
    },
}

impl PageRequest {
    /// Its number; 0 if it has none.
    pub(crate) const fn id(&self) -> u64 {
        match self {
            Self::Authorize { .. } => 0,
            Self::Line { id, .. }
            | Self::ChooseSoil { id, .. }
            | Self::Play { id }
            | Self::Pause { id }
            | Self::Seek { id, .. }
            | Self::Step { id, .. }
            | Self::Speed { id, .. } => *id,
        }
    }
}

/// The kinds of [`PageRequest`], to tell them from the operators' messages.
pub(crate) const PAGE_REQUESTS: [&str; 8] =
    ["authorize", "line", "choose_soil", "play", "pause", "seek", "step", "speed"];
