//! What is needed to read a log: its topics, and where plate and sensor are on the arm.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use soilctl_motion::{Look as Seen, look as look_at};

use crate::ProcessError;
use crate::log::LogSettings;
use crate::robot::Robot;

/// Link at the plate's lower edge, unless told otherwise.
const PLATE: &str = "plate_tip";
/// Once all is there that is needed, so many more messages are looked at for a topic with the usual name.
const PATIENCE: u32 = 5000;

/// What is needed to read a log.
#[derive(Debug)]
pub(crate) struct Look {
    pub(crate) joint_topics: Vec<String>,
    pub(crate) wrench_topic: String,
    pub(crate) robot: Robot,
}

/// Looks until all that is needed was seen, or to the end.
///
/// # Errors
/// [`ProcessError::Log`] if the file cannot be read or is no log, [`ProcessError::Missing`], [`ProcessError::Topic`],
/// [`ProcessError::Joints`], [`ProcessError::Urdf`] or [`ProcessError::NoFrame`] if something is missing,
/// [`ProcessError::Stopped`].
pub(crate) fn look(path: &Path, settings: &LogSettings, stop: &AtomicBool) -> Result<Look, ProcessError> {
    let (mut patience, mut ready) = (PATIENCE, false);
    let seen = look_at(path, stop, &mut |seen, new| {
        if new {
            ready = taken(seen, settings).is_ok();
        }
        patience -= u32::from(ready && patience > 0);
        let usual = seen.has_usual_joints() || settings.joint_topic.is_some();
        ready && (usual || patience == 0)
    })?;
    taken(&seen, settings)
}

fn taken(seen: &Seen, settings: &LogSettings) -> Result<Look, ProcessError> {
    let wrench_topic = seen.wrench_topic(settings.wrench_topic.as_deref())?;
    let urdf = seen.urdf(settings.urdf.as_deref())?;
    let plate = settings.plate_frame.as_deref().unwrap_or(PLATE);
    let sensor = match (&settings.sensor_frame, seen.frame(&wrench_topic)) {
        (Some(given), _) => given.as_str(),
        (None, "") => "ft_sensor",
        (None, named) => named,
    };
    let robot = Robot::from_urdf(urdf, plate, sensor)?;
    let joint_topics = seen.joint_topics(settings.joint_topic.as_deref(), robot.joint_names())?;
    Ok(Look { joint_topics, wrench_topic, robot })
}
