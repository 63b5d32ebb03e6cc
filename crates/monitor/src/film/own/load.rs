use std::collections::BTreeMap;
use std::path::Path;

use soilctl_live::protocol::{Configuration, Event, Hello, Memory, PROTOCOL_VERSION, StateMessage};
use soilctl_session::messages::{ControllerStep, JointState, decode};
use soilctl_session::read::{Item, scan};
use soilctl_session::{SessionError, topics};

use super::sample::Words;
use super::track::{MOST_EVENTS, Track};
use crate::MonitorError;
use crate::film::halve;
use crate::messages::StrokeSpan;
use crate::scene::{SURFACE_FOUND, Scene};
use crate::soil::Surface;

/// Steps between two states: some 31 a second.
const STATE_STEPS: u64 = 16;
/// Kept surfaces; when there are more, every second one goes.
const MOST_SURFACES: usize = 64;
/// States between two kept surfaces, to begin with.
const SURFACE_STATES: usize = 300;

/// Reads a log of ours; nothing if it has no step. What is damaged is left out and said.
pub(in crate::film) fn load(path: &Path) -> Result<Option<Track>, MonitorError> {
    let mut loader = Loader::default();
    let ending = scan::<Stop>(path, &mut |item| loader.item(item)).map_err(|Stop(error)| *error)?;
    let Some((mut track, _)) = loader.track.filter(|(track, _)| !track.samples.is_empty()) else {
        return Ok(None);
    };
    track.strokes = loader.strokes;
    track.damage = ending.damage;
    Ok(Some(track))
}

/// Ends a scan.
struct Stop(Box<MonitorError>);

impl From<SessionError> for Stop {
    fn from(error: SessionError) -> Self {
        Self(Box::new(error.into()))
    }
}

#[derive(Default)]
struct Loader {
    program: String,
    configuration: Option<Configuration>,
    track: Option<(Track, Surface)>,
    memory: Memory,
    strokes: Vec<StrokeSpan>,
    /// The joints as they are, as the log has them; empty if it does not.
    truth: Vec<u8>,
    steps: u64,
    spacing: usize,
    /// Whether the level is one that was touched.
    touched: bool,
}

impl Loader {
    fn item(&mut self, item: Item<'_>) -> Result<(), Stop> {
        match item {
            Item::Metadata { name: "soilctl.session", content } => {
                self.program = format!("soilctl {}", text(content, "program_version"));
            }
            Item::Metadata { name: "soilctl.configuration", content } => {
                self.configuration = Some(Configuration {
                    arm: text(content, "arm"),
                    controller: text(content, "controller"),
                    plan: text(content, "plan"),
                    model: String::new(),
                });
            }
            Item::Metadata { name: "soilctl.stroke", content } => self.strokes.push(StrokeSpan {
                number: text(content, "number"),
                start_s: text(content, "start_s").parse().unwrap_or(0.0),
                end_s: text(content, "end_s").parse().unwrap_or(0.0),
                finish: text(content, "finish"),
            }),
            Item::Message(message) if message.channel.topic == topics::TRUE_JOINTS => {
                self.truth.clear();
                self.truth.extend_from_slice(message.data);
            }
            Item::Message(message) if message.channel.topic == topics::STEP => {
                let step = decode::<ControllerStep>(message.data).map_err(|reason| {
                    let topic = topics::STEP.to_owned();
                    Stop::from(SessionError::Message { topic, number: self.steps, reason })
                })?;
                self.step(&step).map_err(|error| Stop(Box::new(error)))?;
            }
            _ => {}
        }
        Ok(())
    }

    fn step(&mut self, step: &ControllerStep) -> Result<(), MonitorError> {
        if self.track.is_none() {
            let Some(configuration) = &self.configuration else { return Ok(()) };
            self.track = Some(begin(configuration, &self.program)?);
            self.spacing = SURFACE_STATES;
        }
        let Some((track, surface)) = &mut self.track else { return Ok(()) };
        self.memory.step(step);
        // The sand is where the arm first touched it, rather than where the settings say.
        let found = step.events.iter().find(|event| event.kind == SURFACE_FOUND);
        if let Some(event) = found.filter(|event| event.value.is_finite() && !self.touched) {
            self.touched = true;
            track.scene.sandbox.surface_z_m = event.value;
            *surface = Surface::new(&track.scene)?;
            track.surfaces = vec![(0, surface.snapshot())];
        }
        for event in &step.events {
            if track.events.len() < MOST_EVENTS {
                track.events.push(Event::new(step.tick, event));
            } else {
                track.events_left_out += 1;
            }
        }
        let due = self.steps.is_multiple_of(STATE_STEPS);
        self.steps += 1;
        if !due {
            return Ok(());
        }
        let state = StateMessage::new(step, &self.memory);
        let number = self.steps / STATE_STEPS;
        if track.is_full() {
            track.thin();
        }
        let next = track.len();
        let last = track.surfaces.last().map_or(0, |(number, _)| *number);
        if surface.is_at_rest() && next >= last + self.spacing {
            track.surfaces.push((next, surface.snapshot()));
        }
        if track.surfaces.len() > MOST_SURFACES {
            halve(&mut track.surfaces);
            self.spacing *= 2;
        }
        let true_deg = true_joints_deg(&self.truth).unwrap_or(state.joints_deg);
        if track.push(number, &state, true_deg) {
            surface.follow(true_deg, None, state.homed, state.waiting);
        }
        Ok(())
    }
}

/// The joints in a message of the truth, in degrees.
fn true_joints_deg(data: &[u8]) -> Option<[f64; 5]> {
    let message = decode::<JointState>(data).ok()?;
    let joints = <[f64; 5]>::try_from(message.position).ok()?;
    joints.iter().all(|joint| joint.is_finite()).then(|| joints.map(f64::to_degrees))
}

fn begin(configuration: &Configuration, program: &str) -> Result<(Track, Surface), MonitorError> {
    let scene = Scene::new(configuration)?;
    let surface = Surface::new(&scene)?;
    let hello = Hello {
        protocol: PROTOCOL_VERSION,
        program: program.to_owned(),
        real_time: false,
        simulated: false,
        tick_s: soilctl_controller::TICK_S,
        strokes: scene.strokes,
        safe_force: scene.safe_force.clone(),
    };
    let track = Track {
        hello,
        scene,
        samples: Vec::new(),
        words: Words::default(),
        stride: 1,
        events: Vec::new(),
        events_left_out: 0,
        strokes: Vec::new(),
        damage: Vec::new(),
        surfaces: vec![(0, surface.snapshot())],
    };
    Ok((track, surface))
}

fn text(content: &BTreeMap<String, String>, key: &str) -> String {
    content.get(key).cloned().unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use soilctl_session::messages::EventMessage;

    use super::*;

    #[test]
    fn the_sand_is_where_the_arm_first_touched_it() {
        let read = |name: &str| {
            let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
            std::fs::read_to_string(data.join(name)).unwrap()
        };
        let configuration = Configuration {
            arm: read("arm/thesis.toml"),
            controller: read("controller/default.toml"),
            plan: read("plans/table_6_2.toml"),
            model: String::new(),
        };
        let mut loader = Loader { configuration: Some(configuration), ..Loader::default() };
        let mut level = |tick, found: Option<f64>| {
            let event =
                |value| EventMessage { kind: SURFACE_FOUND.to_owned(), value, ..EventMessage::default() };
            let events = found.map(event).into_iter().collect();
            loader.step(&ControllerStep { tick, events, ..ControllerStep::default() }).unwrap();
            let (track, surface) = loader.track.as_ref().unwrap();
            assert!(surface.heights().iter().all(|height| *height == 0), "raked, at its level");
            track.scene.sandbox.surface_z_m
        };
        let stated = level(1, None);
        assert_eq!(level(2, Some(f64::NAN)), stated);
        assert_eq!(level(3, Some(stated + 0.012)), stated + 0.012);
        // It is touched again in a furrow.
        assert_eq!(level(4, Some(stated - 0.02)), stated + 0.012);
        assert_eq!(level(5, None), stated + 0.012);
    }
}
