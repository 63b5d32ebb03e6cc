use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use std::sync::atomic::AtomicBool;

use nalgebra::{Isometry3, Vector3};
use soilctl_mesh::{Mesh, Sought};
use soilctl_robot::{Chain, Urdf};

use crate::look::{listed, look_through};
use crate::{Columns, Look, MotionError, Wanted, columns, meshes};

/// Link at the plate's lower edge in URDFs of this program.
const PLATE: &str = "plate_tip";
/// A wrench belongs to joints that are not further away in time, in s.
const MOST_GAP_S: f64 = 0.25;

/// What is to be taken of a recording, where it does not say so itself.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Settings {
    /// Text of the URDF; without it the one in the recording.
    pub urdf: Option<String>,
    /// Topic of the joint states; without it `/joint_states`, or those that name the arm's joints.
    pub joint_topic: Option<String>,
    /// Topic of the wrenches; without it `/wrench`, or the only one; there may be none.
    pub wrench_topic: Option<String>,
    /// The link whose origin is the end-point; without it `plate_tip`, or the link behind most joints.
    pub end_link: Option<String>,
    /// Link of the wrenches; without it the frame that their headers name.
    pub sensor_link: Option<String>,
    /// Where the files of meshes are looked for.
    pub meshes: Sought,
    /// Height of the ground in the URDF's root frame in m, for those who draw it.
    pub surface_z_m: Option<f64>,
}

/// A recording of an arm that moves.
#[derive(Debug)]
pub struct Motion {
    /// Text of the URDF.
    pub text: String,
    /// The arm.
    pub urdf: Urdf,
    /// The link whose origin is the end-point.
    pub end_link: String,
    /// Joints that messages name, in the order of the URDF; [`Columns::joints`] has them in the same order.
    pub joints: Vec<String>,
    /// Joints and wrenches on one clock.
    pub columns: Columns,
    /// Meshes of the URDF that are at hand, by their names in it.
    pub meshes: BTreeMap<String, Mesh>,
    /// What could not be used, and what was odd, in sentences.
    pub notes: Vec<String>,
    end: Placed,
    sensor: Placed,
}

/// A chain, and where each of its joints is found among those of the columns.
#[derive(Debug)]
struct Placed {
    chain: Chain,
    places: Vec<usize>,
}

/// The arm at a time, in the root frame of the URDF.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// Time in s.
    pub t_s: f64,
    /// Of each of [`Motion::joints`] in rad or m, as last heard; NaN before the first.
    pub positions: Vec<f64>,
    /// Where the end-point is in m; `None` as long as a joint that moves it was not heard.
    pub tip_m: Option<[f64; 3]>,
    /// The wrench of that time in the sensor's frame, in N and N m.
    pub wrench: Option<[f64; 6]>,
    /// Its force in N.
    pub force_n: Option<[f64; 3]>,
}

/// Reads the whole recording, twice.
///
/// # Errors
/// A [`MotionError`] if it cannot be read, has no joint states or URDF, or if joints that move the end-point or the sensor are not in it.
pub fn motion(path: &Path, settings: &Settings, stop: &AtomicBool) -> Result<Motion, MotionError> {
    let look = look_through(path, stop, &mut |_| {})?.some()?;
    let wrench_topic = match look.wrench_topic(settings.wrench_topic.as_deref()) {
        Err(problem) if settings.wrench_topic.is_some() => return Err(problem),
        other => other.ok(),
    };
    let text = look.urdf(settings.urdf.as_deref())?.to_owned();
    let urdf = Urdf::parse(&text)?;
    let end_link = settings.end_link.clone().unwrap_or_else(|| urdf.end_link(PLATE).to_owned());
    let (end, mut notes) = (urdf.chain(&end_link)?, Vec::new());
    let frame = wrench_topic.as_deref().map_or("", |topic| look.frame(topic));
    let sensor_link = match &settings.sensor_link {
        Some(given) => given,
        None if frame.is_empty() || urdf.link_index(frame).is_some() => frame,
        None => {
            notes.push(format!(
                "the wrenches are in the frame {frame}, which is no link of the URDF; they are drawn as if in {end_link}; give \
                 --sensor-frame"
            ));
            ""
        }
    };
    let sensor = urdf.chain(if sensor_link.is_empty() { &end_link } else { sensor_link })?;
    let needed: BTreeSet<&String> = end.joint_names().iter().chain(sensor.joint_names()).collect();
    let needed: Vec<String> = needed.into_iter().cloned().collect();
    let (joint_topics, joints) = topics_and_joints(&look, settings, &urdf, &needed)?;
    let wanted =
        Wanted { joint_topics: &joint_topics, wrench_topic: wrench_topic.as_deref(), joints: &joints };
    let columns = columns(path, &wanted, stop)?;
    let heard = |name: &String| {
        let place = joints.iter().position(|joint| joint == name);
        place.and_then(|place| columns.joints.get(place)).is_some_and(|series| !series.t_s.is_empty())
    };
    let missing: Vec<&str> = needed.iter().filter(|name| !heard(name)).map(String::as_str).collect();
    if !missing.is_empty() || !joints.iter().any(heard) {
        return Err(MotionError::Joints {
            topic: joint_topics.join(", "),
            missing: listed(missing.into_iter()),
            named: listed(columns.named.iter()),
        });
    }
    let placed = |chain: Chain| {
        let place = |name: &String| joints.iter().position(|joint| joint == name).unwrap_or(usize::MAX);
        Placed { places: chain.joint_names().iter().map(place).collect(), chain }
    };
    let (end, sensor) = (placed(end), placed(sensor));
    let (meshes, of_meshes) = meshes(&urdf, &settings.meshes);
    notes.extend(of_meshes);
    notes.extend(urdf.notes().iter().cloned());
    notes.extend(columns.troubles.iter().map(ToString::to_string));
    Ok(Motion { text, urdf, end_link, joints, columns, meshes, notes, end, sensor })
}

/// Topics of joint states that name the joints which are needed, and those that name others of the arm; and all these joints.
fn topics_and_joints(
    look: &Look,
    settings: &Settings,
    urdf: &Urdf,
    needed: &[String],
) -> Result<(Vec<String>, Vec<String>), MotionError> {
    let asked = settings.joint_topic.as_deref();
    let topics = look.joint_topics(asked, needed)?;
    let moving = urdf.joints().iter().filter(|joint| joint.kind.has_position() && joint.mimic.is_none());
    let moving: Vec<&String> = moving.map(|joint| &joint.name).collect();
    let of_arm: BTreeSet<&str> = moving.iter().map(|name| name.as_str()).collect();
    let (more, found) = look.cover(topics.clone(), &|name| of_arm.contains(name));
    let joints = moving.into_iter().filter(|name| found.contains(*name)).cloned().collect();
    Ok((if asked.is_some() { topics } else { more }, joints))
}

impl Placed {
    fn pose(&self, positions: &[f64]) -> Option<Isometry3<f64>> {
        let own: Option<Vec<f64>> = self.places.iter().map(|place| positions.get(*place).copied()).collect();
        self.chain.pose(&own?)
    }
}

impl Motion {
    /// Times at which a joint was heard, rising, each once, at least `apart_s` apart.
    #[must_use]
    pub fn times_s(&self, apart_s: f64) -> Vec<f64> {
        let mut times: Vec<f64> =
            self.columns.joints.iter().flat_map(|series| series.t_s.iter().copied()).collect();
        times.sort_by(f64::total_cmp);
        let mut last = f64::NEG_INFINITY;
        times.retain(|t_s| {
            // Steps such as 0.01 s are no floating-point numbers.
            let due = *t_s > last && *t_s >= last + apart_s - 1e-6;
            if due {
                last = *t_s;
            }
            due
        });
        times
    }

    /// Shows the arm at times that rise.
    pub fn states(&self, times_s: impl IntoIterator<Item = f64>, show: &mut dyn FnMut(State)) {
        let mut places = vec![0_usize; self.joints.len()];
        let mut wrench_place = 0;
        for t_s in times_s {
            let heard = self.columns.joints.iter().zip(&mut places).map(|(series, place)| {
                *place = after(&series.t_s, *place, t_s);
                place.checked_sub(1).and_then(|last| series.values.get(last)).copied().unwrap_or(f64::NAN)
            });
            let positions: Vec<f64> = heard.collect();
            let wrenches = &self.columns.wrenches;
            wrench_place = after(&wrenches.t_s, wrench_place, t_s);
            let near = [wrench_place.checked_sub(1), Some(wrench_place)].into_iter().flatten();
            let near = near.filter_map(|place| {
                let apart_s = (wrenches.t_s.get(place)? - t_s).abs();
                (apart_s <= MOST_GAP_S).then_some((apart_s, *wrenches.values.get(place)?))
            });
            let wrench = near.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, wrench)| wrench);
            let tip_m = self.end.pose(&positions).map(|pose| pose.translation.vector.into());
            let force_n = self
                .sensor
                .pose(&positions)
                .zip(wrench)
                .map(|(pose, [x, y, z, ..])| (pose.rotation * Vector3::new(x, y, z)).into());
            show(State { t_s, positions, tip_m, wrench, force_n });
        }
    }

    /// From the frame of each link to that of the root, at positions of [`Motion::joints`]; joints that are not finite or not among
    /// them are at 0.
    #[must_use]
    pub fn link_poses(&self, positions: &[f64]) -> Vec<Option<Isometry3<f64>>> {
        self.urdf.link_poses(&|name| {
            let place = self.joints.iter().position(|joint| joint == name)?;
            positions.get(place).copied().filter(|position| position.is_finite())
        })
    }
}

/// The first of rising times after `t_s`, from a place on.
fn after(times_s: &[f64], mut place: usize, t_s: f64) -> usize {
    while times_s.get(place).is_some_and(|known| *known <= t_s) {
        place += 1;
    }
    place
}
