//! Where a stroke begins, and how the arm goes on from there: the wrist stays, so that the plate turns with the forearm.

use soilctl_controller::{Params, StrokeSpec};
use soilctl_kinematics::{Joint, JointAngles};

use crate::DiggingError;

/// How much a plate sinks, in m for each m of way, while the controller keeps its height by position feedback: the angle of the lead follows slowly,
/// and the encoders' steps are coarse. A plate that leans ahead is lifted by the soil. Empirical, on the simulated arm, where single strokes sank
/// by up to 0.36: no bound.
pub(crate) fn sinks(tool_angle_deg: f64) -> f64 {
    (0.1 + 0.011 * (tool_angle_deg - 70.0)).clamp(0.1, 0.33)
}

/// Steps in which a stroke is followed.
const STEPS: usize = 8;
/// Newton steps for each of them, and the way in m that may be left.
const NEWTON: (usize, f64) = (20, 1e-9);

/// Postures along a stroke, from its full depth on.
#[derive(Debug, Clone, PartialEq)]
pub struct Way {
    /// Way of the plate towards the base in m, from 0 to the whole.
    pub travel_m: Vec<f64>,
    /// Joint angles there.
    pub joints: Vec<JointAngles>,
    /// Tool angles there in deg.
    pub tool_angle_deg: Vec<f64>,
}

/// Follows a stroke towards the base from its depth below a surface (m), sinking as much as a plate may: shoulder and elbow move the plate, base, twist and wrist stay.
///
/// # Errors
/// [`DiggingError::Kinematics`] if the arm does not reach the begin of the stroke or some place on its way within its limits,
/// [`DiggingError::WayEnds`] where shoulder and elbow alone cannot go on.
pub fn way(
    params: &Params,
    stroke: &StrokeSpec,
    surface_z_m: f64,
    length_m: f64,
) -> Result<Way, DiggingError> {
    let arm = params.arm();
    let start = stroke.pose(surface_z_m - stroke.depth_m);
    // Above the soil, where the plate comes from, too.
    arm.inverse(&stroke.pose(surface_z_m + params.config().site.transit_m))?;
    let mut joints = arm.inverse(&start)?;
    let (sin, cos) = libm::sincos(stroke.base_rad);
    let mut way = Way { travel_m: Vec::new(), joints: Vec::new(), tool_angle_deg: Vec::new() };
    let (shoulder, elbow) = (Joint::Shoulder.index(), Joint::Elbow.index());
    for step in 0..=STEPS {
        #[allow(clippy::cast_precision_loss, reason = "small integers")]
        let travel_m = length_m * step as f64 / STEPS as f64;
        let mut arrived = false;
        for _ in 0..NEWTON.0 {
            let pose = arm.forward(&joints)?;
            let radius_m = pose.x_m * cos + pose.y_m * sin;
            let [r, z] = [
                stroke.radius_m - travel_m - radius_m,
                start.z_m - sinks(stroke.tool_angle_rad.to_degrees()) * travel_m - pose.z_m,
            ];
            if r.abs() + z.abs() < NEWTON.1 {
                arrived = true;
                break;
            }
            let j = arm.jacobian(&joints)?.0;
            let out = |joint: usize| j[0][joint] * cos + j[1][joint] * sin;
            let [[a, b], [c, d]] = [[out(shoulder), out(elbow)], [j[2][shoulder], j[2][elbow]]];
            let size = a * d - b * c;
            // A step onto a singular place is no number, which the limits refuse.
            joints.0[shoulder] += (d * r - b * z) / size;
            joints.0[elbow] += (a * z - c * r) / size;
            arm.check_limits(&joints)?;
        }
        if !arrived {
            return Err(DiggingError::WayEnds { travel_m });
        }
        way.travel_m.push(travel_m);
        way.joints.push(joints);
        way.tool_angle_deg.push(arm.forward(&joints)?.tool_angle_rad().to_degrees());
    }
    Ok(way)
}
