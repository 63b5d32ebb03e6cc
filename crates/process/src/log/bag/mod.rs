//! Bags of any program: joint states and wrenches.

mod contents;
mod reader;

use std::collections::{BTreeSet, VecDeque};
use std::path::Path;

use soilctl_session::read::{Early, RawMessage, scan};

pub use self::contents::BagContents;
pub(super) use self::reader::read_wrench;
pub use self::reader::{BagMessage, BagReader, JOINT_STATE, WRENCH};
use super::cut::Cutter;
use super::{Candidate, LogSettings};
use crate::{Aligner, ProcessError, Robot};

/// Messages may come so late, by their stamps, in s.
const WAIT_S: f64 = 0.5;

/// Joins the two topics of a bag.
pub(super) struct Bag {
    settings: LogSettings,
    urdf: Option<String>,
    reader: BagReader,
    /// Made with the first wrench, whose header may name its frame.
    aligner: Option<Aligner>,
    /// Joint states that came before the first wrench.
    early: VecDeque<(f64, Vec<(String, f64)>)>,
    cutter: Cutter,
    named: BTreeSet<String>,
}

impl Bag {
    /// Looks through the log once for its topics and, if need be, its URDF.
    pub(super) fn new(path: &Path, settings: &LogSettings) -> Result<Self, ProcessError> {
        let mut contents = BagContents::default();
        let scanned = scan(path, &mut |item| {
            contents.note(&item);
            let named = |name: &Option<String>| name.as_ref().is_none_or(|name| contents.has_topic(name));
            let has_urdf = settings.urdf.is_some() || contents.urdf().is_some();
            let both = contents.has_type(JOINT_STATE) && contents.has_type(WRENCH);
            if both && has_urdf && named(&settings.joint_topic) && named(&settings.wrench_topic) {
                // All is known; the rest comes in the second pass.
                return Err(Early::Enough);
            }
            Ok(())
        });
        if let Err(Early::Failed(error)) = scanned {
            return Err(error.into());
        }
        let joint_topic = contents.choose(settings.joint_topic.as_deref(), "/joint_states", JOINT_STATE)?;
        let wrench_topic = contents.choose(settings.wrench_topic.as_deref(), "/wrench", WRENCH)?;
        Ok(Self {
            settings: settings.clone(),
            urdf: settings.urdf.as_deref().or(contents.urdf()).map(str::to_owned),
            reader: BagReader::new(joint_topic, Some(wrench_topic)),
            aligner: None,
            early: VecDeque::new(),
            cutter: Cutter::new(settings),
            named: BTreeSet::new(),
        })
    }

    pub(super) fn message(
        &mut self,
        message: &RawMessage<'_>,
        found: &mut dyn FnMut(Candidate),
    ) -> Result<(), ProcessError> {
        match self.reader.read(message) {
            Some(BagMessage::Joints { t_s, names, positions }) => self.joints(t_s, names, positions),
            Some(BagMessage::Wrench { t_s, frame, wrench }) => {
                if self.aligner.is_none() {
                    self.begin(&frame)?;
                }
                if let Some(aligner) = &mut self.aligner {
                    aligner.wrench(t_s, wrench);
                }
                self.drain(false, found)?;
            }
            None => {}
        }
        Ok(())
    }

    fn joints(&mut self, t_s: f64, names: Vec<String>, positions: Vec<f64>) {
        for name in &names {
            if !self.named.contains(name) {
                self.named.insert(name.clone());
            }
        }
        match &mut self.aligner {
            Some(aligner) => aligner.joints(t_s, names.iter().map(String::as_str).zip(positions)),
            None => {
                self.early.push_back((t_s, names.into_iter().zip(positions).collect()));
                // Wrenches of so long ago could not be joined anyway.
                if self.early.len() > 100_000 {
                    self.early.pop_front();
                }
            }
        }
    }

    /// With the first wrench all is known that a robot is made of.
    fn begin(&mut self, frame: &str) -> Result<(), ProcessError> {
        let urdf = self.urdf.as_deref().ok_or(ProcessError::Missing {
            what: "--urdf",
            advice: "the log has neither a /robot_description nor a URDF attached; give the arm's URDF"
                .into(),
        })?;
        let plate = self.settings.plate_frame.as_deref().unwrap_or("plate_tip");
        let sensor = match (&self.settings.sensor_frame, frame) {
            (Some(given), _) => given.as_str(),
            (None, "") => "ft_sensor",
            (None, named) => named,
        };
        let robot = Robot::from_urdf(urdf, plate, sensor)?;
        for (what, value) in [("--surface-z", self.settings.surface_z_m), ("--width", self.settings.width_m)]
        {
            if value.is_none() {
                let advice = "a bag of another program does not say it; give it in m".into();
                return Err(ProcessError::Missing { what, advice });
            }
        }
        let mut aligner = Aligner::new(robot, WAIT_S);
        for (t_s, joints) in self.early.drain(..) {
            aligner.joints(t_s, joints.iter().map(|(name, value)| (name.as_str(), *value)));
        }
        self.aligner = Some(aligner);
        Ok(())
    }

    fn drain(&mut self, end: bool, found: &mut dyn FnMut(Candidate)) -> Result<(), ProcessError> {
        let Some(aligner) = &mut self.aligner else { return Ok(()) };
        while let Some(sample) = aligner.next(end)? {
            self.cutter.push(sample, found);
        }
        Ok(())
    }

    /// Ends the bag; what could not be used.
    pub(super) fn end(mut self, found: &mut dyn FnMut(Candidate)) -> Result<Vec<String>, ProcessError> {
        self.drain(true, found)?;
        self.cutter.end(found);
        let Some(aligner) = &self.aligner else {
            return Err(ProcessError::Log(format!(
                "no message on {} can be read as {WRENCH}",
                self.reader.wrench_topic().unwrap_or_default()
            )));
        };
        let missing = aligner.missing_joints();
        if !missing.is_empty() {
            return Err(ProcessError::Joints {
                topic: self.reader.joint_topic().to_owned(),
                missing: missing.join(", "),
                named: listed(self.named.iter().map(String::as_str)),
            });
        }
        let lost = aligner.lost();
        let count = |number: u64, what: &str| (number > 0).then(|| format!("{number} {what}"));
        Ok([
            count(lost.late, "messages came more than 0.5 s late by their stamps"),
            count(lost.gaps, "wrenches have no joint states close before and after"),
            count(lost.repeated, "messages repeat a stamp"),
            count(lost.unusable, "messages have a number that is not finite"),
            count(self.reader.malformed(), "messages cannot be read"),
        ]
        .into_iter()
        .flatten()
        .collect())
    }
}

fn listed<T: AsRef<str>>(names: impl Iterator<Item = T>) -> String {
    let names: Vec<String> = names.map(|name| name.as_ref().to_owned()).collect();
    if names.is_empty() { "none".into() } else { names.join(", ") }
}
