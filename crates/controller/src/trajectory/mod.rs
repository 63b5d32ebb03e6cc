//! Trajectories: what the arm shall do, one tick after the other. Each has a beginning (`Active::start`), a tick
//! (`Active::update`) and an end (a [`Finish`]).

mod follow;
mod insert;
mod moves;
mod profile;
mod ring;
mod stroke;
mod touch;

use serde::{Deserialize, Serialize};
use soilctl_kinematics::{Joint, JointAngles, JointVelocities, TaskPose};

use crate::config::StrokeLaw;
use crate::estimate::Estimate;
use crate::{Finish, Params, Tuning};

pub use follow::{HandLimit, HandRun, HandTarget};
pub use ring::{RING_SIZE, Ring};
pub use stroke::StrokeRun;

/// A motion with its numbers. SI units, radians, base frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Trajectory {
    /// Keeps the wanted posture, for some ticks or until something else is to be done.
    Hold {
        /// Ticks, or without end.
        ticks: Option<u32>,
    },
    /// All joints to `target`, minimum jerk, all arriving at once.
    JointMove {
        /// Where to; inside the limits.
        target: JointAngles,
    },
    /// Along a straight line to `target`, minimum jerk; both ends must be reachable.
    CartesianMove {
        /// Where to.
        target: TaskPose,
    },
    /// One joint slowly towards its home stop, until it no longer follows.
    JointTouch {
        /// Which joint.
        joint: Joint,
    },
    /// The tip along a straight line until the force against the motion means contact.
    CartesianTouch {
        /// Direction along x, y, z; a unit vector.
        direction: [f64; 3],
        /// Longest way in m.
        travel_m: f64,
    },
    /// The plate along itself into the soil, giving way to lateral forces (eqs 5.1 to 5.3).
    Insert {
        /// Vertical way of the lower edge in m.
        depth_m: f64,
    },
    /// The plate towards the base with a growing lead, until the soil has failed or a limit is reached.
    Stroke {
        /// What turns the lead.
        law: StrokeLaw,
        /// Wanted angle of the force to the plate's normal in rad.
        delta_rad: f64,
    },
    /// Joint speeds, for some ticks or until something else is to be done.
    JointVelocity {
        /// The speeds.
        rates: JointVelocities,
        /// Ticks, or without end.
        ticks: Option<u32>,
    },
    /// The edge after a hand, as fast and as hard as the settings allow, for as long as the hand goes on to say where it is.
    Follow {
        /// Whose; another one is refused meanwhile.
        hand: u32,
        /// Where it is.
        target: HandTarget,
    },
}

/// Which law makes torques of a set-point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Law {
    /// Joint PID, eq. 3.1.
    #[default]
    Joint,
    /// Stiffness at the tip, eq. 3.2.
    Stiffness,
    /// Joint velocity.
    Velocity,
}

/// What a trajectory wants in one tick.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Setpoint {
    /// How to get it.
    pub law: Law,
    /// Wanted joint angles.
    pub joints: JointAngles,
    /// Wanted joint speeds.
    pub rates: JointVelocities,
    /// Wanted position of the tip in m, for [`Law::Stiffness`].
    pub position_m: [f64; 3],
    /// Whether the integral of [`Law::Joint`] rests and fades. Where nothing presses on the plate it would act on free play, and hunt through it.
    pub rests: bool,
}

impl Setpoint {
    /// Stay at these angles.
    pub(crate) fn still(joints: JointAngles) -> Self {
        Self { joints, ..Self::default() }
    }
}

/// The active trajectory and what it remembers.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Active {
    /// What it is.
    pub trajectory: Trajectory,
    /// Ticks since its beginning.
    pub ticks: u32,
    /// Ticks that it takes, if that is known.
    pub duration_ticks: u32,
    /// Wanted joints at the beginning.
    pub from_joints: JointAngles,
    /// Pose at the beginning.
    pub from_pose: TaskPose,
    /// Ticks for which there was contact.
    pub contact_ticks: u32,
    /// Where the tip was in m (x, y, z) when a touch felt almost nothing last.
    pub onset_m: [f64; 3],
    /// Lateral offset of the accommodation in m; of a joint touch, its way in rad.
    pub offset_m: f64,
    /// What a stroke remembers.
    pub stroke: StrokeRun,
    /// What following a hand remembers.
    pub hand: HandRun,
}

/// What a trajectory sees.
#[derive(Clone, Copy)]
pub(crate) struct View<'a> {
    pub(crate) params: &'a Params,
    pub(crate) est: &'a Estimate,
    pub(crate) tuning: &'a Tuning,
    /// Ticks for which a joint's torque has been at its limit.
    pub(crate) saturated_ticks: u32,
    /// Largest share of its limit that a torque or a tracking error takes.
    pub(crate) strain: f64,
}

/// Out-of-plane angle in rad below which a hand counts as level.
const LEVEL_RAD: f64 = 0.01;

/// Near a straight wrist the twist joint would turn far to keep up a lean that is only the encoders' resolution.
fn levelled(pose: TaskPose) -> TaskPose {
    TaskPose { n2_rad: if pose.n2_rad.abs() < LEVEL_RAD { 0.0 } else { pose.n2_rad }, ..pose }
}

impl Active {
    /// Begins `trajectory` at the wanted joints `from`.
    ///
    /// # Errors
    /// [`Finish::Unreachable`] if the arm cannot go there.
    pub(crate) fn start(trajectory: Trajectory, view: View<'_>, from: JointAngles) -> Result<Self, Finish> {
        let trajectory = match trajectory {
            Trajectory::CartesianMove { target } => Trajectory::CartesianMove { target: levelled(target) },
            other => other,
        };
        let mut active = Self {
            trajectory,
            ticks: 0,
            duration_ticks: 0,
            from_joints: from,
            from_pose: TaskPose::default(),
            contact_ticks: 0,
            onset_m: view.est.pose.position_m(),
            offset_m: 0.0,
            stroke: StrokeRun::default(),
            hand: HandRun::default(),
        };
        if view.est.homed {
            active.from_pose = levelled(view.params.arm().forward(&from).map_err(|_| Finish::Unreachable)?);
        }
        match trajectory {
            Trajectory::Hold { ticks } | Trajectory::JointVelocity { ticks, .. } => {
                active.duration_ticks = ticks.unwrap_or(0);
            }
            Trajectory::JointMove { target } => active.plan_joint_move(view, &target)?,
            Trajectory::CartesianMove { target } => active.plan_cartesian_move(view, &target)?,
            Trajectory::JointTouch { .. } => {}
            Trajectory::CartesianTouch { direction, travel_m } => {
                active.plan_cartesian_touch(view, direction, travel_m)?;
            }
            Trajectory::Insert { depth_m } => active.plan_insert(view, depth_m)?,
            Trajectory::Stroke { delta_rad, .. } => active.plan_stroke(view, delta_rad)?,
            Trajectory::Follow { .. } => active.plan_follow(view)?,
        }
        Ok(active)
    }

    /// One tick: what is wanted now, and whether this was the last tick.
    pub(crate) fn update(&mut self, view: View<'_>) -> (Setpoint, Option<Finish>) {
        self.ticks = self.ticks.saturating_add(1);
        match self.trajectory {
            Trajectory::Hold { ticks } => {
                let rests = self.hand.holds && !self.hand.is_pressed(view);
                (Setpoint { rests, ..Setpoint::still(self.from_joints) }, self.finite(ticks))
            }
            Trajectory::JointVelocity { rates, ticks } => {
                let joints = view.est.motor;
                (Setpoint { law: Law::Velocity, joints, rates, ..Setpoint::default() }, self.finite(ticks))
            }
            Trajectory::JointMove { target } => self.joint_move(&target),
            Trajectory::CartesianMove { target } => self.cartesian_move(view, &target),
            Trajectory::JointTouch { joint } => self.joint_touch(view, joint),
            Trajectory::CartesianTouch { direction, travel_m } => {
                self.cartesian_touch(view, direction, travel_m)
            }
            Trajectory::Insert { depth_m } => self.insert(view, depth_m),
            Trajectory::Stroke { law, .. } => self.do_stroke(view, law),
            Trajectory::Follow { target, .. } => self.follow(view, &target),
        }
    }

    fn finite(&self, ticks: Option<u32>) -> Option<Finish> {
        ticks.filter(|&ticks| self.ticks >= ticks).map(|_| Finish::Completed)
    }
}
