use std::path::Path;

use soilctl_process::log::{BagContents, BagMessage, BagReader, JOINT_STATE, WRENCH};
use soilctl_process::{ProcessError, Robot};
use soilctl_session::SessionError;
use soilctl_session::read::{Item, scan};

use super::BagSettings;
use super::track::{Moment, Track};
use crate::MonitorError;

/// Link of the end-point in our own URDF.
const PLATE_TIP: &str = "plate_tip";
/// A wrench belongs to joints that are not further away in time, in s.
const MOST_GAP_S: f64 = 0.25;

/// Reads a bag; `contents` if they are known already.
pub(in crate::film) fn load(
    path: &Path,
    settings: &BagSettings,
    contents: Option<BagContents>,
) -> Result<Track, MonitorError> {
    let refused = |problem| MonitorError::Bag { file: path.display().to_string(), problem };
    let contents = match contents {
        Some(known) => known,
        None => {
            let mut found = BagContents::default();
            scan::<SessionError>(path, &mut |item| {
                found.note(&item);
                Ok(())
            })?;
            found
        }
    };
    let mut loader = Loader::new(settings, &contents).map_err(refused)?;
    let ending = scan::<SessionError>(path, &mut |item| {
        if let Item::Message(message) = item
            && let Some(message) = loader.reader.read(&message)
        {
            loader.message(message);
        }
        Ok(())
    })?;
    let mut track = loader.end().map_err(refused)?;
    track.damage.extend(ending.damage);
    Ok(track)
}

struct Loader {
    reader: BagReader,
    robot: Robot,
    track: Track,
    /// Position of each of the track's joints as last heard.
    known: Vec<f32>,
    /// Its stamp in s.
    heard_s: Vec<f64>,
    /// Of each of the robot's joints, its place among them.
    places: Vec<Option<usize>>,
    /// The last wrench and its time.
    wrench: Option<(f64, [f64; 6])>,
    framed: bool,
    late: u64,
    unusable: u64,
}

impl Loader {
    fn new(settings: &BagSettings, contents: &BagContents) -> Result<Self, ProcessError> {
        let joint_topic = contents.choose(settings.joint_topic.as_deref(), "/joint_states", JOINT_STATE)?;
        let wrench_topic = contents.choose(settings.wrench_topic.as_deref(), "/wrench", WRENCH);
        let wrench_topic = match wrench_topic {
            Err(problem) if settings.wrench_topic.is_some() => return Err(problem),
            other => other.ok(),
        };
        let urdf = settings.urdf.as_deref().or(contents.urdf()).ok_or(ProcessError::Missing {
            what: "--urdf",
            advice: "the log has neither a /robot_description nor a URDF attached; give the arm's URDF"
                .into(),
        })?;
        let end_link = match &settings.end_link {
            Some(given) => given.clone(),
            None => Robot::end_link(urdf, PLATE_TIP)?,
        };
        let sensor_link = settings.sensor_link.as_deref().unwrap_or(&end_link);
        let robot = Robot::from_urdf(urdf, &end_link, sensor_link)?;
        let track = Track::new(urdf.to_owned(), end_link, settings.surface_z_m, wrench_topic.is_some());
        Ok(Self {
            reader: BagReader::new(joint_topic, wrench_topic),
            places: vec![None; robot.joint_names().len()],
            robot,
            track,
            known: Vec::new(),
            heard_s: Vec::new(),
            wrench: None,
            framed: settings.sensor_link.is_some(),
            late: 0,
            unusable: 0,
        })
    }

    fn message(&mut self, message: BagMessage) {
        match message {
            BagMessage::Joints { t_s, names, positions } => self.joints(t_s, names, &positions),
            BagMessage::Wrench { t_s, frame, wrench } => {
                if !std::mem::replace(&mut self.framed, true) {
                    self.frame(&frame);
                }
                if wrench.iter().all(|part| part.is_finite()) {
                    self.wrench = Some((t_s, wrench));
                } else {
                    self.unusable += 1;
                }
            }
        }
    }

    /// The first wrench names its frame.
    fn frame(&mut self, frame: &str) {
        if frame.is_empty() {
            return;
        }
        match Robot::from_urdf(&self.track.urdf, &self.track.end_link, frame) {
            Ok(robot) => self.robot = robot,
            Err(_) => self.track.damage.push(format!(
                "the wrenches are in the frame {frame}, which is no link of the URDF; they are drawn as if in {}; give \
                 --sensor-frame",
                self.track.end_link
            )),
        }
        let joints = &self.track.joints;
        let place = |name: &String| joints.iter().position(|known| known == name);
        self.places = self.robot.joint_names().iter().map(place).collect();
    }

    fn joints(&mut self, t_s: f64, names: Vec<String>, positions: &[f64]) {
        for (name, position) in names.into_iter().zip(positions) {
            if !position.is_finite() {
                self.unusable += 1;
                continue;
            }
            let place = self.place(name);
            match (self.heard_s.get_mut(place), self.known.get_mut(place)) {
                (Some(heard_s), Some(known)) if t_s >= *heard_s => {
                    #[allow(clippy::cast_possible_truncation, reason = "to be looked at")]
                    let position = *position as f32;
                    (*heard_s, *known) = (t_s, position);
                }
                _ => self.late += 1,
            }
        }
        // Parts of a robot may tell of themselves, in messages of their own with one stamp.
        let again = self.track.moments.last().is_some_and(|last| last.t_s == t_s);
        if again {
            self.track.moments.pop();
        }
        if again || self.track.is_due(t_s) {
            let moment = self.moment(t_s);
            self.track.push(moment);
        }
    }

    /// Place of a joint among those that were heard of.
    fn place(&mut self, name: String) -> usize {
        if let Some(place) = self.track.joints.iter().position(|known| *known == name) {
            return place;
        }
        let place = self.known.len();
        let moving = self.robot.joint_names().iter().position(|known| *known == name);
        if let Some(moving) = moving.and_then(|number| self.places.get_mut(number)) {
            *moving = Some(place);
        }
        self.track.joints.push(name);
        self.known.push(f32::NAN);
        self.heard_s.push(f64::MIN);
        place
    }

    /// What is known at a time.
    fn moment(&self, t_s: f64) -> Moment {
        let wrench =
            self.wrench.filter(|(at_s, _)| (at_s - t_s).abs() <= MOST_GAP_S).map(|(_, wrench)| wrench);
        let joints: Option<Vec<f64>> = self
            .places
            .iter()
            .map(|place| self.known.get((*place)?).map(|value| f64::from(*value)).filter(|v| v.is_finite()))
            .collect();
        let sample =
            joints.and_then(|joints| self.robot.sample(t_s, &joints, wrench.unwrap_or_default()).ok());
        #[allow(clippy::cast_possible_truncation, reason = "to be looked at")]
        let small = |vector: [f64; 3]| vector.map(|part| part as f32);
        Moment {
            t_s,
            positions: self.known.as_slice().into(),
            tip_m: sample.map_or([f32::NAN; 3], |sample| small(sample.tip_m)),
            force_n: sample
                .filter(|_| wrench.is_some())
                .map_or([f32::NAN; 3], |sample| small(sample.force_n())),
        }
    }

    fn end(mut self) -> Result<Track, ProcessError> {
        if self.track.moments.is_empty() {
            let topic = self.reader.joint_topic();
            return Err(ProcessError::Log(format!("no message on {topic} gives the position of a joint")));
        }
        let names = self.robot.joint_names().iter().zip(&self.places);
        let missing: Vec<&str> =
            names.filter(|(_, place)| place.is_none()).map(|(name, _)| name.as_str()).collect();
        if !missing.is_empty() {
            return Err(ProcessError::Joints {
                topic: self.reader.joint_topic().to_owned(),
                missing: missing.join(", "),
                named: self.track.joints.join(", "),
            });
        }
        for (number, what) in [
            (self.late, "positions of joints come after later ones, by their stamps, and are left out"),
            (self.unusable, "positions or wrenches are not finite and are left out"),
            (self.reader.malformed(), "messages cannot be read"),
        ] {
            if number > 0 {
                self.track.damage.push(format!("{number} {what}"));
            }
        }
        Ok(self.track)
    }
}
