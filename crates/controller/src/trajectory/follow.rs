use serde::{Deserialize, Serialize};
use soilctl_kinematics::{JointAngles, JointVelocities, TaskPose};

use super::{Active, Setpoint, View};
use crate::config::Hand;
use crate::laws::hand::{approach, approach_speed, bounded_change, give_way, length};
use crate::{Finish, TICK_S};

/// Pitch of the hand in rad at the flattest and at the steepest tool angle: 135 and 45 deg.
const PITCH_RAD: [f64; 2] = [0.75 * std::f64::consts::PI, 1.25 * std::f64::consts::PI];
/// How far from the limits of the base angle the edge stays, in rad.
const BASE_MARGIN_RAD: f64 = 0.05;
/// A limit is shown for so many ticks after it was reached last, so that one at which the arm works is one event and not many.
const SHOWN_TICKS: u32 = 100;
/// Share of the force that is allowed from which on the plate counts as pressed, and below which no longer.
const PRESSED_SHARE: f64 = 0.1;
const FREE_SHARE: f64 = 0.06;
/// Lead in m below which it has no direction.
const LEAST_LEAD_M: f64 = 1e-4;
/// Below this speed in m/s an edge whose hand is gone is at rest.
const REST_M_S: f64 = 1e-3;
/// Longest time in ticks that coming to rest may take.
const REST_TICKS: u32 = 250;

/// Where a hand is: the middle of the plate's lower edge, base frame.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct HandTarget {
    /// Forwards, in m.
    pub x_m: f64,
    /// To the left, in m.
    pub y_m: f64,
    /// Up, in m.
    pub z_m: f64,
    /// Tool angle in rad.
    pub tool_angle_rad: f64,
}

impl HandTarget {
    /// Whether all of it are numbers. How large they are does not matter.
    #[must_use]
    pub fn is_finite(&self) -> bool {
        [self.x_m, self.y_m, self.z_m, self.tool_angle_rad].iter().all(|part| part.is_finite())
    }
}

/// What holds the arm back from where the hand is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum HandLimit {
    /// Nothing.
    #[default]
    None,
    /// It does not reach further, or is not allowed to.
    Reach,
    /// The soil pushes back as hard as the settings allow.
    Force,
    /// A motor or a joint turns as hard as the settings allow.
    Torque,
}

/// What following a hand remembers.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct HandRun {
    /// Wanted radius in m, base angle in rad and height in m of the edge.
    pub place: [f64; 3],
    /// Wanted pitch and out-of-plane angle of the hand in rad.
    pub pitch_rad: [f64; 2],
    /// Wanted velocity along the radius, the tangent and upwards in m/s.
    pub velocity_m_s: [f64; 3],
    /// Wanted rate of the pitch in rad/s.
    pub pitch_rate_rad_s: f64,
    /// Wanted joints of the tick before.
    pub joints: JointAngles,
    /// Ticks since the hand said where it is.
    pub silent_ticks: u32,
    /// What holds the arm back.
    pub limit: HandLimit,
    /// Ticks since it did so last.
    pub free_ticks: u32,
    /// The load as a share of what is allowed.
    pub load: f64,
    /// Whether the soil presses on the plate.
    pub pressed: bool,
    /// Whether this is the hold after a hand has let go.
    pub holds: bool,
}

/// A step of one tick: of the place along r, t, z in m, and of the pitch in rad.
#[derive(Clone, Copy)]
struct Step {
    way_m: [f64; 3],
    turn_rad: f64,
}

impl Active {
    pub(super) fn plan_follow(&mut self, view: View<'_>) -> Result<(), Finish> {
        let from = self.from_pose;
        let joints = view.params.arm().inverse(&from).map_err(|_| Finish::Unreachable)?;
        self.hand = HandRun {
            place: [libm::hypot(from.x_m, from.y_m), libm::atan2(from.y_m, from.x_m), from.z_m],
            pitch_rad: [from.n1_rad, from.n2_rad],
            joints,
            free_ticks: SHOWN_TICKS,
            ..HandRun::default()
        };
        Ok(())
    }

    /// The hand has said where it is: from now on it is followed there.
    pub(crate) fn lead_to(&mut self, trajectory: super::Trajectory) {
        self.trajectory = trajectory;
        self.hand.silent_ticks = 0;
    }

    /// The edge goes towards the hand, with bounded speed and acceleration, in coordinates of the base joint, in which everything that is
    /// allowed is a box. What pushes back slows it, stops it, and moves it back; where the arm does not reach it slides along the border.
    pub(super) fn follow(&mut self, view: View<'_>, target: &HandTarget) -> (Setpoint, Option<Finish>) {
        let (run, settings) = (&mut self.hand, &view.params.config().hand);
        run.silent_ticks = run.silent_ticks.saturating_add(1);
        let silent = run.silent_ticks > settings.lease_ticks;
        let mut limit = HandLimit::None;
        let (place, pitch_rad) = allowed(view, target, run, &mut limit);
        let radius = run.place[0];
        let way_m = [place[0] - radius, radius * (place[1] - run.place[1]), place[2] - run.place[2]];
        let scale = view.tuning.speed_scale;
        let (speed, acceleration) = (settings.speed_m_s * scale, settings.acceleration_m_s2);
        let towards = if silent { [0.0; 3] } else { approach(way_m, speed, acceleration) };
        let bounded = run.against_loads(view, settings, towards, speed, &mut limit);
        run.velocity_m_s = bounded_change(run.velocity_m_s, bounded, acceleration * TICK_S);
        run.turn_towards(settings, scale, if silent { run.pitch_rad[0] } else { pitch_rad });

        let joints = run.advance(view, &mut limit);
        run.note(limit);
        let rates = JointVelocities(std::array::from_fn(|i| (joints.0[i] - run.joints.0[i]) / TICK_S));
        run.joints = joints;
        let still = length(run.velocity_m_s) < REST_M_S && run.pitch_rate_rad_s.abs() < REST_M_S;
        let at_rest = still || run.silent_ticks > settings.lease_ticks.saturating_add(REST_TICKS);
        let finish = (silent && at_rest).then_some(Finish::LetGo);
        (Setpoint { joints, rates, rests: !run.pressed, ..Setpoint::default() }, finish)
    }
}

/// The part of a target that is allowed: radius, base angle and height, and the pitch.
fn allowed(view: View<'_>, target: &HandTarget, run: &HandRun, limit: &mut HandLimit) -> ([f64; 3], f64) {
    let (safety, margin) = (&view.params.config().safety, view.params.config().hand.margin_m);
    let mut within = |value: f64, [low, high]: [f64; 2], margin: f64| {
        let inside = value.max(low + margin).min(high - margin);
        if inside != value {
            *limit = HandLimit::Reach;
        }
        inside
    };
    let radius = libm::hypot(target.x_m, target.y_m);
    // On the base axis there is no base angle to go to.
    let base = if radius > 0.0 { libm::atan2(target.y_m, target.x_m) } else { run.place[1] };
    let place = [
        within(radius, safety.radius_m, margin),
        within(base, safety.base_deg.map(f64::to_radians), BASE_MARGIN_RAD),
        within(target.z_m, safety.height_m, margin),
    ];
    (place, within(1.5 * std::f64::consts::PI - target.tool_angle_rad, PITCH_RAD, 0.0))
}

impl HandRun {
    /// What is left of a velocity against the soil's force, and against torques and tracking errors. Those press against the soil too where
    /// it pushes back; where it does not, they stem from the wanted place's lead over the arm.
    fn against_loads(
        &mut self,
        view: View<'_>,
        settings: &Hand,
        towards: [f64; 3],
        speed: f64,
        limit: &mut HandLimit,
    ) -> [f64; 3] {
        let force = view.est.force_rtz_n;
        let force_n = length(force);
        let [by_force, by_torque] = [force_n / settings.force_n, view.strain / settings.torque_share];
        self.load = by_force.max(by_torque);
        let back = if self.is_pressed(view) { force } else { self.lead_m(view).map(|part| -part) };
        let size = length(back);
        if size <= LEAST_LEAD_M {
            return towards;
        }
        let (left, held) = give_way(towards, back.map(|part| part / size), self.load, speed);
        if held {
            *limit = if by_force >= by_torque { HandLimit::Force } else { HandLimit::Torque };
        }
        left
    }

    /// Whether the soil presses on the plate. Less than it takes to begin does not end it.
    pub(crate) fn is_pressed(&mut self, view: View<'_>) -> bool {
        let share = length(view.est.force_rtz_n) / view.params.config().hand.force_n;
        self.pressed = share >= if self.pressed { FREE_SHARE } else { PRESSED_SHARE };
        self.pressed
    }

    /// How far the wanted edge is ahead of the one by the motors, along r, t, z in m; none where that has no answer.
    fn lead_m(&self, view: View<'_>) -> [f64; 3] {
        let Ok(motor) = view.params.arm().forward(&view.est.motor) else { return [0.0; 3] };
        let [radius, base, z_m] = self.place;
        let (sin, cos) = libm::sincos(base);
        let [along, across] = [motor.x_m * cos + motor.y_m * sin, motor.y_m * cos - motor.x_m * sin];
        [radius - along, -across, z_m - motor.z_m]
    }

    /// Turns the plate. Against a load it turns slower, and not at all at the whole of it.
    fn turn_towards(&mut self, settings: &Hand, scale: f64, pitch_rad: f64) {
        let way = pitch_rad - self.pitch_rad[0];
        let most = settings.pitch_speed_deg_s.to_radians() * scale;
        let change = settings.pitch_acceleration_deg_s2.to_radians();
        let free = (2.0 * (1.0 - self.load)).clamp(0.0, 1.0);
        let wanted = approach_speed(way.abs(), most, change).copysign(way) * free;
        let step = (wanted - self.pitch_rate_rad_s).max(-change * TICK_S).min(change * TICK_S);
        self.pitch_rate_rad_s += step;
    }

    /// Goes on by a tick: all of the step, or what of it the arm can do. What it cannot do is at rest.
    fn advance(&mut self, view: View<'_>, limit: &mut HandLimit) -> JointAngles {
        let whole = Step {
            way_m: self.velocity_m_s.map(|part| part * TICK_S),
            turn_rad: self.pitch_rate_rad_s * TICK_S,
        };
        let [r, t, z] = whole.way_m;
        let ways = [[r, t, z], [0.0, t, z], [r, t, 0.0], [0.0, t, 0.0], [0.0; 3]];
        for (tried, way_m) in ways.into_iter().enumerate() {
            for turn_rad in [whole.turn_rad, 0.0] {
                let step = Step { way_m, turn_rad };
                let Some(joints) = self.joints_after(view, step) else { continue };
                if tried > 0 || turn_rad != whole.turn_rad {
                    *limit = HandLimit::Reach;
                }
                self.go(step);
                return joints;
            }
        }
        (self.velocity_m_s, self.pitch_rate_rad_s) = ([0.0; 3], 0.0);
        *limit = HandLimit::Reach;
        self.joints
    }

    fn pose_after(&self, step: Step) -> TaskPose {
        let [radius, base, z_m] = self.place;
        let radius_after = radius + step.way_m[0];
        let (sin, cos) = libm::sincos(base + step.way_m[1] / radius.max(1e-3));
        TaskPose {
            x_m: radius_after * cos,
            y_m: radius_after * sin,
            z_m: z_m + step.way_m[2],
            n1_rad: self.pitch_rad[0] + step.turn_rad,
            n2_rad: self.pitch_rad[1],
        }
    }

    /// The joints after a step; none where there are none, or where a joint would have to be faster than it can.
    fn joints_after(&self, view: View<'_>, step: Step) -> Option<JointAngles> {
        let joints = view.params.arm().inverse(&self.pose_after(step)).ok()?;
        let most = &view.params.arm().config().joints.all();
        let slow = (0..5)
            .all(|i| (joints.0[i] - self.joints.0[i]).abs() <= most[i].max_speed_deg_s.to_radians() * TICK_S);
        slow.then_some(joints)
    }

    fn go(&mut self, step: Step) {
        let radius = self.place[0];
        self.place[0] += step.way_m[0];
        self.place[1] += step.way_m[1] / radius.max(1e-3);
        self.place[2] += step.way_m[2];
        self.pitch_rad[0] += step.turn_rad;
        self.velocity_m_s = step.way_m.map(|part| part / TICK_S);
        self.pitch_rate_rad_s = step.turn_rad / TICK_S;
    }

    fn note(&mut self, limit: HandLimit) {
        if limit == HandLimit::None && self.free_ticks < SHOWN_TICKS {
            self.free_ticks += 1;
        } else {
            self.free_ticks = if limit == HandLimit::None { SHOWN_TICKS } else { 0 };
            self.limit = limit;
        }
    }
}
