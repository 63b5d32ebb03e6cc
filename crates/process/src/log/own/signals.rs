//! What a log of ours tells of a stroke beside its failure: free air, touch, insertion, motors against sensor, both encoders.

use soilctl_kinematics::{Arm, JointAngles, JointTorques};
use soilctl_stats::median;

use super::joints::mean_gap;
use super::sample::{Phase, Sample, tip_and_sensor};
use super::stroke::Logged;
use crate::ProcessError;

/// Over this time in s before failure readings are averaged, as those of the stroke table are.
pub(super) const BEFORE_S: f64 = 0.5;
/// Least way in m over which an insertion has a mean force.
const LEAST_WAY_M: f64 = 0.002;
/// Joints of the two loops: play and stretch of the others do not move the edge along the stroke.
const SHOULDER: usize = 1;
const ELBOW: usize = 2;

/// In-plane force of the plate by the motors' torques in N, along the travel and upwards; `None` where the arm is singular.
pub(super) fn by_motors_n(arm: &Arm, sample: &Sample, direction: [f64; 2]) -> Option<[f64; 2]> {
    let joints = JointAngles(sample.external);
    let weight = arm.gravity_torques(&joints).ok()?;
    let torques = JointTorques(std::array::from_fn(|i| sample.torques[i] - weight.0[i]));
    let [x, y, z] = arm.tip_force(&joints, &torques).ok()?;
    Some([x * direction[0] + y * direction[1], z])
}

/// Inclination of the motors' force minus that of the sensor's in deg, median over the time before failure. `read_n` is the sensor's
/// force by sample, along the travel and upwards, as that of the plate on the soil.
pub(super) fn motor_angle_deg(
    arm: &Arm,
    near: &[Sample],
    read_n: &[[f64; 2]],
    direction: [f64; 2],
) -> Option<f64> {
    let angle = |[along, up]: [f64; 2]| up.atan2(along).to_degrees();
    let differences = near.iter().zip(read_n).filter_map(|(sample, read)| {
        let difference = angle(by_motors_n(arm, sample, direction)?) - angle(*read);
        // Angles differ by less than half a turn.
        let turned = (difference + 180.0).rem_euclid(360.0) - 180.0;
        turned.is_finite().then_some(turned)
    });
    let mut differences: Vec<f64> = differences.collect();
    (differences.len() >= 3).then(|| median(&mut differences))
}

/// Motor minus external angle of shoulder and elbow before failure, above that in free air before the stroke, in deg.
pub(super) fn loops_deg(logged: &Logged, near: &[Sample]) -> Option<[f64; 2]> {
    let air = mean_gap(logged.approach.iter().filter(|sample| sample.phase == Phase::Bias))?;
    let taut = mean_gap(near.iter())?;
    Some([SHOULDER, ELBOW].map(|joint| (air[joint] - taut[joint]).to_degrees()))
}

/// Work of the force along the plate over the way of the insertion, over that way, in N; `None` of an insertion that was not logged or
/// does not go down.
pub(super) fn insertion_force_n(
    arm: &Arm,
    approach: &[Sample],
    tare: &[f64; 6],
) -> Result<Option<f64>, ProcessError> {
    let (mut work_j, mut way_m) = (0.0, 0.0);
    let mut last: Option<f64> = None;
    for sample in approach.iter().filter(|sample| sample.phase == Phase::Insert) {
        // The motors' readings are fine enough for work; their free play is taken up by the arm's weight.
        let height_m = tip_and_sensor(arm, &sample.motor)?.0.origin_m[2];
        if let Some(before_m) = last {
            let down_m = before_m - height_m;
            // The sensor's x axis points down along the plate, and soil presses upwards.
            work_j -= (sample.wrench[0] - tare[0]) * down_m;
            way_m += down_m;
        }
        last = Some(height_m);
    }
    Ok((way_m >= LEAST_WAY_M).then(|| work_j / way_m))
}
