//! Forces while a plate is rubbed on sand-covered ground (section 5.4, figure 5-15).

use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use soilctl_bag::{Item, Readers, Reading, scan};

use super::LogSettings;
use crate::ProcessError;

/// What the sensor reads between plate and ground, its tare taken off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RubSample {
    /// Time from the first reading on in s.
    pub t_s: f64,
    /// Force across the plate, along the sensor's z axis, in N.
    pub normal_n: f64,
    /// Size of the force in the plate's plane in N.
    pub tangent_n: f64,
}

/// Without a given tare a log of rubbing begins in free air for so long, in s.
const AIR_S: f64 = 0.5;

/// All wrenches of a log as forces across and along the plate, in order of time.
///
/// # Errors
/// [`ProcessError::Log`] if the file can't be read or is no log, [`ProcessError::Topic`] without wrenches,
/// [`ProcessError::Missing`] if neither the settings nor the first half second give a tare, [`ProcessError::Stopped`].
pub fn read_wrenches(
    path: &Path,
    settings: &LogSettings,
    stop: &AtomicBool,
) -> Result<Vec<RubSample>, ProcessError> {
    let wanted = settings.wrench_topic.as_deref().unwrap_or("/wrench");
    let (mut readers, mut readings) = (Readers::new(), Vec::<(i64, [f64; 6])>::new());
    scan(path, &mut |item| {
        if stop.load(Ordering::Relaxed) {
            return Err(ProcessError::Stopped);
        }
        if let Item::Message(message) = item
            && message.channel.topic == wanted
            && let Some(Ok(Reading::Wrench { stamp_ns, wrench, .. })) = readers.read(&message)
            && wrench.iter().all(|part| part.is_finite())
        {
            let logged = i64::try_from(message.log_time_ns).unwrap_or(i64::MAX);
            readings.push((stamp_ns.unwrap_or(logged), wrench));
        }
        Ok(())
    })?;
    readings.sort_by_key(|reading| reading.0);
    let Some(&(origin, _)) = readings.first() else {
        let (wanted, known) = (wanted.to_owned(), "no wrenches there".to_owned());
        return Err(ProcessError::Topic { wanted, message_type: "geometry_msgs/msg/WrenchStamped", known });
    };
    let seconds = |ns: i64| ns.saturating_sub(origin) as f64 * 1e-9;
    let tare = match settings.tare {
        Some(tare) => tare,
        None => {
            let air: Vec<&[f64; 6]> =
                readings.iter().filter(|r| seconds(r.0) < AIR_S).map(|reading| &reading.1).collect();
            if air.len() < 5 {
                let advice = "the log does not begin with half a second of readings in free air".into();
                return Err(ProcessError::Missing { what: "--tare", advice });
            }
            std::array::from_fn(|i| air.iter().map(|wrench| wrench[i]).sum::<f64>() / air.len() as f64)
        }
    };
    let sample = |(ns, wrench): (i64, [f64; 6])| {
        let [x, y, z] = [0, 1, 2].map(|i| wrench[i] - tare[i]);
        RubSample { t_s: seconds(ns), normal_n: z, tangent_n: x.hypot(y) }
    };
    Ok(readings.into_iter().map(sample).collect())
}
