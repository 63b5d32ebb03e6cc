//! Where the plate was, as the arm in the same recording tells, and clouds of a camera on it.

use std::sync::atomic::AtomicBool;

use soilctl_heights::{Cloud, HeightMap, Plate, cloud, is_recording, of_cloud};
use soilctl_motion::{Motion, Settings, State, motion};

use super::{Request, Scans, in_order, readings};
use crate::{AppError, files};

/// Part of the greatest depth from which on the plate is in its stroke, and not on its way in or out.
const DEEP: f64 = 0.9;
/// The least depth that is a stroke, in m.
const LEAST_DEPTH_M: f64 = 1e-3;
/// The least way that says where the plate went, in m.
const LEAST_WAY_M: f64 = 1e-3;

/// The arm in the recording that both maps come from.
pub(super) fn arm(request: &Request, stop: &AtomicBool) -> Result<Motion, AppError> {
    if !is_recording(&request.before) || request.before != request.after {
        return Err(AppError::Request(
            "the plate's place is not known: give --plate-x, --plate-y and --heading, or one recording of arm and scans as both maps".into(),
        ));
    }
    let settings = Settings {
        urdf: request.urdf.as_deref().map(files::read_text).transpose()?,
        joint_topic: request.joint_topic.clone(),
        end_link: request.plate_frame.clone(),
        ..Settings::default()
    };
    Ok(motion(&request.before, &settings, stop)?)
}

/// Maps of the clouds before and after, in the root frame of the arm, and the plate where its stroke ended between them.
pub(super) fn scans(
    request: &Request,
    arm: &Motion,
    width_m: f64,
    depth_m: Option<f64>,
) -> Result<Scans, AppError> {
    let (before, after) = (&request.before, &request.after);
    // Around the plate is not known yet.
    let [first, second] = readings(request, [0.0; 2], width_m);
    let topic = request.topic.as_deref();
    let clouds = [cloud(before, topic, first.moment)?, cloud(after, topic, second.moment)?];
    in_order(request, clouds[0].time_ns, clouds[1].time_ns)?;
    let [one, two] = clouds;
    of_clouds(request, arm, [into_root(arm, one)?, into_root(arm, two)?], width_m, depth_m)
}

/// The same of clouds that were read, and are in the root frame of the arm.
pub(super) fn of_clouds(
    request: &Request,
    arm: &Motion,
    clouds: [Cloud; 2],
    width_m: f64,
    depth_m: Option<f64>,
) -> Result<Scans, AppError> {
    let [from_s, to_s] = [0, 1].map(|i| arm.columns.clock.seconds(clouds[i].time_ns));
    let between: Vec<f64> =
        arm.times_s(0.0).into_iter().filter(|t_s| (from_s..=to_s).contains(t_s)).collect();
    let mut states = Vec::new();
    arm.states(between, &mut |state| states.push(state));
    let lowest = states.iter().filter_map(|state| state.tip_m).min_by(|a, b| a[2].total_cmp(&b[2]));
    let lowest = lowest.ok_or_else(|| {
        AppError::Request(format!(
            "the arm was not heard between the clouds at {from_s:.2} and {to_s:.2} s; name others by --before-at and --after-at"
        ))
    })?;
    let [first, second] = readings(request, [lowest[0], lowest[1]], width_m);
    let name = request.before.display().to_string();
    let [one, two] = clouds;
    let (before, of_before) = of_cloud(&name, one, &first, None)?;
    let (after, of_after) = of_cloud(&name, two, &second, Some(before.grid()))?;
    let (plate, deep_m) = plate(request, arm, &states, &before, width_m)?;
    let notes = vec![format!(
        "by the arm, the plate's face was at x = {:.4} m, y = {:.4} m in the frame of its root as the stroke ended, {:.1} mm deep, and went to {:.1} deg",
        plate.at_m[0],
        plate.at_m[1],
        1e3 * deep_m,
        plate.heading_deg
    )];
    let depth_m = depth_m.or(Some(deep_m));
    Ok(Scans { before, after, sources: [of_before, of_after], plate, depth_m, notes })
}

/// A cloud of a link's frame in that of the root, as the arm stood when it was taken.
///
/// # Errors
/// [`AppError::Request`] if its frame is no link, or its joints were not heard.
pub(crate) fn into_root(arm: &Motion, mut cloud: Cloud) -> Result<Cloud, AppError> {
    if cloud.frame.is_empty() {
        return Ok(cloud);
    }
    let t_s = arm.columns.clock.seconds(cloud.time_ns);
    let mut pose = None;
    arm.states([t_s], &mut |state| {
        // A joint that was not heard would be taken for 0.
        let is_heard = |name: &String| {
            let place = arm.joints.iter().position(|joint| joint == name);
            place.and_then(|place| state.positions.get(place)).is_some_and(|position| position.is_finite())
        };
        let chain = arm.urdf.chain(&cloud.frame);
        let heard = chain.is_ok_and(|chain| chain.joint_names().iter().all(is_heard));
        let link = arm.urdf.link_index(&cloud.frame).filter(|_| heard);
        pose = link.and_then(|link| arm.link_poses(&state.positions).get(link).copied().flatten());
    });
    let Some(pose) = pose.map(|pose| pose.to_homogeneous()) else {
        return Err(AppError::Request(format!(
            "clouds are in the frame {}, which is no link of the URDF, or its joints were not heard before the cloud; transform them into that of the arm's root",
            cloud.frame
        )));
    };
    for point in &mut cloud.points {
        let [x, y, z] = *point;
        *point = [0, 1, 2].map(|i| pose[(i, 0)] * x + pose[(i, 1)] * y + pose[(i, 2)] * z + pose[(i, 3)]);
    }
    // The root of the arm is the frame from here on.
    cloud.frame.clear();
    Ok(cloud)
}

/// The plate as it left its depth for the last time, and that depth.
fn plate(
    request: &Request,
    arm: &Motion,
    states: &[State],
    before: &HeightMap,
    width_m: f64,
) -> Result<(Plate, f64), AppError> {
    let depths: Vec<(f64, [f64; 3], &State)> = states
        .iter()
        .filter_map(|state| {
            let tip = state.tip_m?;
            Some((before.height_m([tip[0], tip[1]])? - tip[2], tip, state))
        })
        .collect();
    let most = depths.iter().map(|(depth, _, _)| *depth).fold(f64::NEG_INFINITY, f64::max);
    if depths.is_empty() {
        return Err(AppError::Request(
            "the ground was not seen where the plate was between the clouds".into(),
        ));
    }
    let deep = || depths.iter().filter(|(depth, _, _)| *depth >= DEEP * most);
    let (Some((_, begin, _)), Some((depth, edge, end)), true) =
        (deep().next(), deep().next_back(), most >= LEAST_DEPTH_M)
    else {
        return Err(AppError::Request(format!(
            "link {} was never below the ground between the clouds (depth {:.1} mm at most); name the link at the plate's lower edge by --plate-frame, or other clouds",
            arm.end_link,
            1e3 * most
        )));
    };
    let way = [edge[0] - begin[0], edge[1] - begin[1]];
    let heading_deg = match request.heading_deg {
        Some(heading) => heading,
        None if libm::hypot(way[0], way[1]) >= LEAST_WAY_M => libm::atan2(way[1], way[0]).to_degrees(),
        None => {
            return Err(AppError::Request(
                "the plate moved less than 1 mm at its depth, so it is not known where it pushed to; give --heading".into(),
            ));
        }
    };
    // Its z axis leads down along the plate, so the surface is met back along it.
    let poses = arm.link_poses(&end.positions);
    let pose = arm.urdf.link_index(&arm.end_link).and_then(|link| poses.get(link).copied().flatten());
    let down = pose.map(|pose| pose.to_homogeneous()).map(|m| [m[(0, 2)], m[(1, 2)], m[(2, 2)]]);
    let Some([x, y, z]) = down.filter(|[_, _, z]| *z < -0.1) else {
        return Err(AppError::Request(format!(
            "the z axis of link {} does not point down; it must lead down along the plate, to its lower edge",
            arm.end_link
        )));
    };
    let back = depth / z;
    let at_m = [edge[0] + back * x, edge[1] + back * y];
    let plate = Plate { at_m, sd_m: 0.0, heading_deg, width_m };
    plate.check()?;
    Ok((plate, *depth))
}
