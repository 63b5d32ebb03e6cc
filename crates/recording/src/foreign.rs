//! A recording of another program: the arm of its URDF as it moves, the wrenches, and curves of both.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::BufWriter;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use nalgebra::Isometry3;
use soilctl_motion::{Motion, State, motion};
use soilctl_robot::JointKind;

use crate::rrd::{Column, WriteError, Writer};
use crate::shapes::{ground, shapes};
use crate::style::foreign_styles;
use crate::{Foreign, Recording, RecordingError, Settings, rows, unwritten};

/// Least time between two states of the arm in s.
const INTERVAL_S: f64 = 0.01;
/// Rows of links and bones in all; with more links there are fewer states.
const MOST_ROWS: usize = 4_000_000;
/// Links with shapes that are drawn.
const MOST_LINKS: usize = 1000;
/// The largest force is drawn with this share of the arm's size.
const ARROW: f64 = 0.3;
/// Radius of a bone as a share of the arm's size.
const BONE: f64 = 0.008;

/// Writes all of it.
pub(crate) fn write(log: &Path, settings: &Settings, out: &Path) -> Result<Recording, RecordingError> {
    let motion = motion(log, settings, &AtomicBool::new(false)).map_err(|problem| {
        RecordingError::Motion { file: log.display().to_string(), problem: Box::new(problem) }
    })?;
    let name = log.file_stem().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    let written = File::create(out)
        .map_err(WriteError::from)
        .and_then(|file| Writer::new(BufWriter::new(file), &id(&motion)))
        .and_then(|writer| Shown::new(&motion, writer).write(&name, settings));
    written.map_err(|error| unwritten(out, &error))
}

/// Two recordings are two in the viewer.
fn id(motion: &Motion) -> String {
    let wrenches = &motion.columns.wrenches;
    let first = wrenches.t_s.first().or(motion.columns.joints.iter().find_map(|series| series.t_s.first()));
    let first = first.copied().unwrap_or_default();
    let text = format!("{}{first}{}{}", motion.columns.clock.origin_s, motion.text, wrenches.t_s.len());
    format!("{:08x}-{:x}", crc32fast::hash(text.as_bytes()), motion.columns.bytes)
}

/// Shapes of a link by their names.
type Shapes = Vec<(String, Vec<Column>)>;

/// What is drawn of a motion.
struct Shown<'a> {
    motion: &'a Motion,
    writer: Writer<BufWriter<File>>,
    /// Links with shapes: place in the URDF, entity, and the shapes by name.
    links: Vec<(usize, String, Shapes)>,
    /// Ends of bones, where links have no shape: places in the URDF.
    bones: Vec<(usize, usize)>,
    slides: Vec<bool>,
}

impl<'a> Shown<'a> {
    fn new(motion: &'a Motion, writer: Writer<BufWriter<File>>) -> Self {
        let urdf = &motion.urdf;
        let mut entities = BTreeSet::new();
        let drawn = urdf.links().iter().enumerate().filter_map(|(place, link)| {
            let shapes = shapes(link, &motion.meshes);
            (!shapes.is_empty()).then_some((place, &link.name, shapes))
        });
        let links: Vec<(usize, String, Shapes)> = drawn
            .take(MOST_LINKS)
            .map(|(place, name, shapes)| (place, entity(name, place, &mut entities), shapes))
            .collect();
        let shaped: BTreeSet<usize> = links.iter().map(|(place, ..)| *place).collect();
        let bare = |joint: &&soilctl_robot::Joint| {
            joint.kind == JointKind::Prismatic || !shaped.contains(&joint.parent)
        };
        let bones = urdf.joints().iter().filter(bare).take(MOST_LINKS);
        let bones = bones.map(|joint| (joint.parent, joint.child)).collect();
        let kind =
            |name: &String| urdf.joints().iter().find(|joint| joint.name == *name).map(|joint| joint.kind);
        let slides = motion.joints.iter().map(|name| kind(name) == Some(JointKind::Prismatic)).collect();
        Self { motion, writer, links, bones, slides }
    }

    fn write(mut self, name: &str, settings: &Settings) -> Result<Recording, WriteError> {
        let motion = self.motion;
        let most = MOST_ROWS / (self.links.len() + self.bones.len() + 4);
        let mut times = motion.times_s(INTERVAL_S);
        let stride = times.len().div_ceil(most).max(1);
        times = times.into_iter().step_by(stride).collect();
        let size_m = self.size_m(&times);
        let joints: Vec<(String, bool)> =
            motion.joints.iter().cloned().zip(self.slides.iter().copied()).collect();
        #[allow(clippy::cast_possible_truncation, reason = "to be looked at")]
        foreign_styles(&mut self.writer, name, &joints, (BONE * size_m) as f32)?;
        if let Some(z_m) = settings.surface_z_m {
            self.writer.fixed("/world/ground", &ground(z_m, size_m))?;
        }
        for (_, entity, shapes) in &self.links {
            for (name, columns) in shapes {
                self.writer.fixed(&format!("{entity}/{name}"), columns)?;
            }
        }
        let mut failed = None;
        motion.states(times.iter().copied(), &mut |state| {
            if failed.is_none() {
                failed = self.state(&state).err();
            }
        });
        let m_per_n = self.m_per_n(size_m);
        let wrenches = &motion.columns.wrenches;
        motion.states(wrenches.t_s.iter().copied(), &mut |state| {
            if failed.is_none() {
                failed = self.wrench(&state, m_per_n).err();
            }
        });
        if let Some(error) = failed {
            return Err(error);
        }
        let about = self.about(name, m_per_n);
        self.writer.fixed("/about", &rows::page(&about))?;
        let ends = [times.first(), times.last()].map(|time| time.copied().unwrap_or_default());
        Ok(Recording {
            entities: self.writer.finish()?,
            steps: 0,
            span_s: ends,
            damage: motion.columns.damage.clone(),
            foreign: Some(Foreign {
                states: times.len(),
                clock_origin_s: motion.columns.clock.origin_s,
                notes: motion.notes.clone(),
            }),
        })
    }

    /// How large the arm is, over some states.
    fn size_m(&self, times: &[f64]) -> f64 {
        let (mut low, mut high) = ([0.0_f64; 3], [0.0_f64; 3]);
        let some = times.iter().copied().step_by(times.len().div_ceil(50).max(1));
        self.motion.states(some, &mut |state| {
            for pose in self.motion.link_poses(&state.positions).into_iter().flatten() {
                for axis in 0..3 {
                    low[axis] = low[axis].min(pose.translation.vector[axis]);
                    high[axis] = high[axis].max(pose.translation.vector[axis]);
                }
            }
        });
        (0..3).map(|axis| (high[axis] - low[axis]).powi(2)).sum::<f64>().sqrt().clamp(0.05, 1e6)
    }

    /// Length of the force's arrow in m a newton.
    fn m_per_n(&self, size_m: f64) -> f64 {
        let size = |wrench: &[f64; 6]| wrench[0].hypot(wrench[1]).hypot(wrench[2]);
        let most_n = self.motion.columns.wrenches.values.iter().map(size).fold(0.0, f64::max);
        if most_n > 0.0 && most_n.is_finite() { ARROW * size_m / most_n } else { 0.0 }
    }

    fn state(&mut self, state: &State) -> Result<(), WriteError> {
        let time_ns = ns(state.t_s);
        let poses = self.motion.link_poses(&state.positions);
        let pose = |place: usize| poses.get(place).copied().flatten();
        for (place, entity, _) in &self.links {
            if let Some(Isometry3 { rotation, translation }) = pose(*place) {
                let columns = rows::transform(translation.vector.into(), rotation.coords.into());
                self.writer.row(entity, time_ns, columns)?;
            }
        }
        let bone = |&(from, to): &(usize, usize)| {
            let [from, to] = [pose(from)?, pose(to)?].map(|pose| pose.translation.vector);
            Some((from.into(), (to - from).into()))
        };
        if !self.bones.is_empty() {
            let bones: Vec<([f64; 3], [f64; 3])> = self.bones.iter().filter_map(bone).collect();
            self.writer.row("/world/bones", time_ns, rows::bones(&bones))?;
        }
        for (entity, slide, factor) in
            [("/joints/turning", false, f64::to_degrees(1.0)), ("/joints/sliding", true, 1e3)]
        {
            let of_kind = state.positions.iter().zip(&self.slides).filter(|(_, slides)| **slides == slide);
            let values: Vec<f64> = of_kind.map(|(position, _)| position * factor).collect();
            if !values.is_empty() {
                self.writer.row(entity, time_ns, rows::curves(&values))?;
            }
        }
        let tip = state.tip_m.unwrap_or([f64::NAN; 3]);
        self.writer.row("/end_point", time_ns, rows::curves(&tip))
    }

    fn wrench(&mut self, state: &State, m_per_n: f64) -> Result<(), WriteError> {
        let time_ns = ns(state.t_s);
        let Some([fx, fy, fz, tx, ty, tz]) = state.wrench else { return Ok(()) };
        self.writer.row("/force_sensor", time_ns, rows::curves(&[fx, fy, fz]))?;
        self.writer.row("/torque_sensor", time_ns, rows::curves(&[tx, ty, tz]))?;
        let nothing = [f64::NAN; 3];
        let force = state.force_n.unwrap_or(nothing).map(|part| part * m_per_n);
        self.writer.row("/world/force", time_ns, rows::arrow(state.tip_m.unwrap_or(nothing), force))
    }

    fn about(&self, name: &str, m_per_n: f64) -> String {
        let motion = self.motion;
        let origin_s = motion.columns.clock.origin_s;
        let mut text = format!("# {name}\n\nTimes count from {origin_s} s of the stamps. ");
        if m_per_n > 0.0 {
            text += &format!(
                "The arrow is the force as the sensor reads it, without any tare, with {:.3} mm a newton, at the origin of {}. ",
                m_per_n * 1e3,
                motion.end_link
            );
        }
        text += "\n";
        for line in &motion.columns.damage {
            text += &format!("\n**Damaged:** {line}\n");
        }
        for line in &motion.notes {
            text += &format!("\n- {line}\n");
        }
        text
    }
}

/// The entity of a link: Rerun's paths have a meaning of their own for most signs.
fn entity(name: &str, place: usize, known: &mut BTreeSet<String>) -> String {
    const MOST_LETTERS: usize = 100;
    let plain =
        |letter: char| if letter.is_ascii_alphanumeric() || "_-.".contains(letter) { letter } else { '_' };
    let name: String = name.chars().take(MOST_LETTERS).map(plain).collect();
    let mut entity = format!("/world/links/{name}");
    if name.is_empty() || !known.insert(entity.clone()) {
        entity = format!("/world/links/{name}_{place}");
        known.insert(entity.clone());
    }
    entity
}

fn ns(t_s: f64) -> i64 {
    #[allow(clippy::cast_possible_truncation, reason = "saturates")]
    let ns = (t_s * 1e9).round() as i64;
    ns
}
