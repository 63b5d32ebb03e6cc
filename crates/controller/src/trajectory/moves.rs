use soilctl_kinematics::{JointAngles, JointVelocities, TaskPose};

use super::profile::{minimum_jerk, ticks_for};
use super::{Active, Setpoint, View};
use crate::{Finish, TICK_RATE_HZ};

impl Active {
    pub(super) fn plan_joint_move(&mut self, view: View<'_>, target: &JointAngles) -> Result<(), Finish> {
        view.params.arm().check_limits(target).map_err(|_| Finish::Unreachable)?;
        let way = (0..5).map(|i| (target.0[i] - self.from_joints.0[i]).abs()).fold(0.0, f64::max);
        let speed = view.params.config().moves.joint_speed_deg_s.to_radians() * view.tuning.speed_scale;
        self.duration_ticks = ticks_for(way, speed);
        Ok(())
    }

    pub(super) fn plan_cartesian_move(&mut self, view: View<'_>, target: &TaskPose) -> Result<(), Finish> {
        view.params.arm().inverse(target).map_err(|_| Finish::Unreachable)?;
        let (from, moves) = (&self.from_pose, &view.params.config().moves);
        let way =
            libm::hypot(libm::hypot(target.x_m - from.x_m, target.y_m - from.y_m), target.z_m - from.z_m);
        let turn = (target.n1_rad - from.n1_rad).abs().max((target.n2_rad - from.n2_rad).abs());
        let scale = view.tuning.speed_scale;
        let along = ticks_for(way, moves.tip_speed_m_s * scale);
        self.duration_ticks = along.max(ticks_for(turn, moves.pitch_speed_deg_s.to_radians() * scale));
        Ok(())
    }

    /// Share of the way and its rate in 1/s.
    pub(super) fn progress(&self) -> (f64, f64) {
        let duration = f64::from(self.duration_ticks.max(1));
        let (share, rate) = minimum_jerk(f64::from(self.ticks) / duration);
        (share, rate * TICK_RATE_HZ / duration)
    }

    pub(super) fn arrived(&self) -> Option<Finish> {
        (self.ticks >= self.duration_ticks).then_some(Finish::Completed)
    }

    pub(super) fn joint_move(&self, target: &JointAngles) -> (Setpoint, Option<Finish>) {
        let (share, rate) = self.progress();
        let way: [f64; 5] = std::array::from_fn(|i| target.0[i] - self.from_joints.0[i]);
        let joints = JointAngles(std::array::from_fn(|i| self.from_joints.0[i] + share * way[i]));
        let rates = JointVelocities(way.map(|way| rate * way));
        (Setpoint { joints, rates, ..Setpoint::default() }, self.arrived())
    }

    pub(super) fn cartesian_move(&self, view: View<'_>, target: &TaskPose) -> (Setpoint, Option<Finish>) {
        let (share, _) = self.progress();
        let from = &self.from_pose;
        let between = |a: f64, b: f64| a + share * (b - a);
        let pose = TaskPose {
            x_m: between(from.x_m, target.x_m),
            y_m: between(from.y_m, target.y_m),
            z_m: between(from.z_m, target.z_m),
            n1_rad: between(from.n1_rad, target.n1_rad),
            n2_rad: between(from.n2_rad, target.n2_rad),
        };
        self.at_pose(view, &pose, self.arrived())
    }

    /// The joints of a pose; where there are none the trajectory ends.
    pub(super) fn at_pose(
        &self,
        view: View<'_>,
        pose: &TaskPose,
        finish: Option<Finish>,
    ) -> (Setpoint, Option<Finish>) {
        match view.params.arm().inverse(pose) {
            Ok(joints) => (Setpoint::still(joints), finish),
            Err(_) => (Setpoint::still(view.est.motor), Some(Finish::Unreachable)),
        }
    }
}
