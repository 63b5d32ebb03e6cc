use super::profile::ticks_for;
use super::{Active, Setpoint, View};
use crate::laws::accommodation_speed;
use crate::{Finish, TICK_S};
use soilctl_kinematics::TaskPose;

/// A plate flatter than this is not pushed in along itself.
const LEAST_SINE: f64 = 0.3;

impl Active {
    pub(super) fn plan_insert(&mut self, view: View<'_>, depth_m: f64) -> Result<(), Finish> {
        let way = self.insert_way(depth_m).ok_or(Finish::Unreachable)?;
        let end = self.insert_pose(way);
        view.params.arm().inverse(&end).map_err(|_| Finish::Unreachable)?;
        let speed = view.params.config().insert.speed_m_s * view.tuning.speed_scale;
        // The setting is the mean speed; the profile wants the peak.
        self.duration_ticks = ticks_for(way, 1.875 * speed);
        Ok(())
    }

    /// Way along the plate for a vertical depth.
    fn insert_way(&self, depth_m: f64) -> Option<f64> {
        let down = -libm::cos(self.from_pose.n1_rad);
        (down >= LEAST_SINE && depth_m > 0.0).then(|| depth_m / down)
    }

    /// Eq. 5.3, integrated: across the plate by the accommodation's offset, along it by `way_m` and what the offset takes
    /// of the depth.
    fn insert_pose(&self, way_m: f64) -> TaskPose {
        let from = &self.from_pose;
        let (sin, cos) = libm::sincos(from.n1_rad);
        let way_m = way_m - self.offset_m * sin / cos.min(-LEAST_SINE);
        // Along the hand (sin n1, cos n1); across it (cos theta', -sin theta') with theta' = n1 - pi.
        let r = way_m * sin - self.offset_m * cos;
        let z = way_m * cos + self.offset_m * sin;
        let radius = libm::hypot(from.x_m, from.y_m);
        let (c, s) = if radius > 0.0 { (from.x_m / radius, from.y_m / radius) } else { (1.0, 0.0) };
        TaskPose { x_m: from.x_m + r * c, y_m: from.y_m + r * s, z_m: from.z_m + z, ..*from }
    }

    pub(super) fn insert(&mut self, view: View<'_>, depth_m: f64) -> (Setpoint, Option<Finish>) {
        let settings = &view.params.config().insert;
        if view.tuning.accommodate {
            let speed = accommodation_speed(
                view.est.normal_force_n,
                settings.dead_zone_n,
                settings.gain_m_s_per_n,
                settings.max_lateral_speed_m_s,
            );
            let most = settings.max_lateral_offset_m;
            self.offset_m = (self.offset_m + speed * TICK_S).max(-most).min(most);
        }
        let Some(way) = self.insert_way(depth_m) else {
            return (Setpoint::still(self.from_joints), Some(Finish::Unreachable));
        };
        let (share, _) = self.progress();
        let pose = self.insert_pose(share * way);
        // The soil's resistance leaves the plate short of its depth until the integral has found it.
        let short = view.est.pose.z_m - pose.z_m > settings.depth_tolerance_m;
        let waited = self.ticks >= self.duration_ticks.saturating_add(settings.settle_ticks);
        let finish = self.arrived().filter(|_| waited || !short);
        self.at_pose(view, &pose, finish)
    }
}
