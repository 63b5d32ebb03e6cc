use soilctl_kinematics::{Joint, JointAngles, JointVelocities, TaskPose};

use super::profile::ticks_for;
use super::{Active, Setpoint, View};
use crate::{Finish, TICK_RATE_HZ, TICK_S};

/// How much further than its range a joint may be moved in search of its stop.
const BEYOND_RANGE_RAD: f64 = 0.2;

/// Share of the force that means contact below which there is none yet: what is touched begins where it was reached.
const ONSET: f64 = 0.2;

impl Active {
    /// Contact is a tracking error that lasts: the wanted angle goes on, the joint does not.
    pub(super) fn joint_touch(&mut self, view: View<'_>, joint: Joint) -> (Setpoint, Option<Finish>) {
        let (i, params) = (joint.index(), view.params);
        let (lower, upper) = (params.arm().lower_limits().0[i], params.arm().upper_limits().0[i]);
        let home = params.arm().transmission().home().0[i];
        let sign = if home - lower < upper - home { -1.0 } else { 1.0 };
        // A soft start, since the joint may hang in its backlash.
        let ramp = (f64::from(self.ticks) / (0.2 * TICK_RATE_HZ)).min(1.0);
        let speed = sign * ramp * params.touch_speed_rad_s[i];
        self.offset_m += speed * TICK_S;
        let mut joints = self.from_joints;
        joints.0[i] += self.offset_m;
        let mut rates = JointVelocities::default();
        rates.0[i] = speed;
        let contact = sign * (joints.0[i] - view.est.motor.0[i]) > params.touch_error_rad[i];
        let finish = if self.confirmed(view, contact) {
            Some(Finish::Contact)
        } else if self.offset_m.abs() > upper - lower + BEYOND_RANGE_RAD {
            Some(Finish::NoContact)
        } else {
            None
        };
        (Setpoint { joints, rates, ..Setpoint::default() }, finish)
    }

    pub(super) fn plan_cartesian_touch(
        &mut self,
        view: View<'_>,
        direction: [f64; 3],
        travel_m: f64,
    ) -> Result<(), Finish> {
        let end = along(&self.from_pose, direction, travel_m);
        let arm = view.params.arm();
        // Where the whole way cannot be reached it may still end at a contact, so only the beginning is checked.
        let first = along(&self.from_pose, direction, travel_m.min(0.001));
        arm.inverse(&first).map_err(|_| Finish::Unreachable)?;
        let speed = view.params.config().touch.tip_speed_m_s * view.tuning.speed_scale;
        self.duration_ticks = if end == self.from_pose { 1 } else { ticks_for(travel_m, speed) };
        Ok(())
    }

    /// Contact is a force against the motion that lasts.
    pub(super) fn cartesian_touch(
        &mut self,
        view: View<'_>,
        direction: [f64; 3],
        travel_m: f64,
    ) -> (Setpoint, Option<Finish>) {
        let force = view.est.force_xyz_n;
        let against = -(force[0] * direction[0] + force[1] * direction[1] + force[2] * direction[2]);
        let enough = view.params.config().touch.tip_force_n;
        let contact = against > enough;
        if against < ONSET * enough {
            self.onset_m = view.est.pose.position_m();
        }
        let speed = view.params.config().touch.tip_speed_m_s * view.tuning.speed_scale;
        let ramp_ticks = 0.2 * TICK_RATE_HZ;
        let ticks = f64::from(self.ticks);
        // Way of a motion that gains its speed evenly over the ramp.
        let way = if ticks < ramp_ticks {
            0.5 * speed * ticks * ticks / ramp_ticks * TICK_S
        } else {
            speed * (ticks - 0.5 * ramp_ticks) * TICK_S
        };
        let finish = if self.confirmed(view, contact) {
            Some(Finish::Contact)
        } else if way >= travel_m {
            Some(Finish::NoContact)
        } else {
            None
        };
        self.at_pose(view, &along(&self.from_pose, direction, way.min(travel_m)), finish)
    }

    fn confirmed(&mut self, view: View<'_>, contact: bool) -> bool {
        self.contact_ticks = if contact { self.contact_ticks + 1 } else { 0 };
        self.contact_ticks >= view.params.config().touch.confirm_ticks
    }

    /// The wanted joints of a held posture.
    pub(crate) fn hold_at(&mut self, joints: JointAngles) {
        self.from_joints = joints;
    }
}

fn along(pose: &TaskPose, direction: [f64; 3], way_m: f64) -> TaskPose {
    TaskPose {
        x_m: pose.x_m + direction[0] * way_m,
        y_m: pose.y_m + direction[1] * way_m,
        z_m: pose.z_m + direction[2] * way_m,
        ..*pose
    }
}
