use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_controller::{HandTarget, Request, StrokeLaw, StrokeSpec, TICK_RATE_HZ, Trajectory, Tunable};
use soilctl_kinematics::{JointAngles, JointVelocities, TaskPose};
use soilctl_session::messages::variant;

/// What an operator may ask for. Angles in degrees, otherwise SI units; base frame. What the controller allows at the moment
/// is up to the controller, which refuses the rest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "name", rename_all = "snake_case", deny_unknown_fields)]
pub enum Command {
    /// Switches the amplifiers on; the arm holds where it is.
    Enable,
    /// Switches the amplifiers off.
    Disable,
    /// Leaves the safe state after a fault, to off.
    Reset,
    /// Starts a sequence.
    Start {
        /// `homing`, `wall_sensing`, `insert_stroke_pullout`, `campaign` or `friction_sweep`.
        sequence: String,
    },
    /// Ends sequence and motion; the arm holds where it is.
    Abort,
    /// The soil is prepared: a waiting sequence goes on. A simulated soil is prepared anew.
    Continue,
    /// Switches storage on or off.
    Store {
        /// On or off.
        on: bool,
    },
    /// Averages the force sensor's bias from now on; the plate must be in free air.
    Bias,
    /// Sets the stroke that `insert_stroke_pullout` makes.
    Stroke {
        /// Radius of the insertion from the base axis in m.
        radius_m: f64,
        /// Base angle.
        base_deg: f64,
        /// Tool angle.
        tool_angle_deg: f64,
        /// Vertical depth of the plate's lower edge in m.
        depth_m: f64,
        /// Wanted angle between force and plate normal.
        delta_deg: f64,
        /// Number of the soil's preparation.
        #[serde(default)]
        batch: u16,
    },
    /// The stroke of the plan, from 0, at which a campaign begins.
    PlanIndex {
        /// Its number.
        index: u16,
    },
    /// Sets a parameter until the session ends.
    Set {
        /// `speed_scale` (fraction of the settings' speed, 0.01 to 1), `lead_rate_m_s` (above 0, at most 0.1),
        /// `accommodate` (true or false) or `law` (`force` or `position`, of later strokes).
        parameter: String,
        /// The value.
        value: Value,
    },
    /// Moves all joints.
    MoveJoints {
        /// Where to.
        joints_deg: [f64; 5],
    },
    /// Moves the tip along a straight line, the hand level.
    MoveTip {
        /// Where to.
        x_m: f64,
        /// Where to.
        y_m: f64,
        /// Where to.
        z_m: f64,
        /// Tool angle at the end.
        tool_angle_deg: f64,
    },
    /// Moves the tip until it touches something.
    Touch {
        /// A unit vector.
        direction: [f64; 3],
        /// Longest way in m.
        travel_m: f64,
    },
    /// Pushes the plate into the soil.
    Insert {
        /// Vertical way in m.
        depth_m: f64,
    },
    /// Pulls the plate towards the base until the soil fails.
    Pull {
        /// Wanted angle between force and plate normal.
        delta_deg: f64,
        /// `force` or `position`.
        #[serde(default = "force")]
        law: String,
    },
    /// Turns joints at constant speeds.
    Velocity {
        /// Speeds in degrees a second.
        rates_deg_s: [f64; 5],
        /// For how long, in s; without it until something else is to be done.
        #[serde(default)]
        seconds: Option<f64>,
    },
    /// Leads the plate by hand: where the hand is now. Said again at least every `hand.lease_ticks` of the settings (0.2 s), else the arm
    /// stops. Numbers may be any: the arm goes as far, as fast and as hard as it may.
    Follow {
        /// Forwards, of the middle of the plate's lower edge.
        x_m: f64,
        /// To the left.
        y_m: f64,
        /// Up.
        z_m: f64,
        /// Tool angle.
        tool_angle_deg: f64,
        /// Whose hand it is, any number; while one leads, others are refused.
        #[serde(default)]
        hand: u32,
    },
    /// Holds the arm.
    Hold {
        /// For how long, in s.
        seconds: f64,
    },
    /// Presses the emergency stop; it stays pressed.
    EmergencyStop,
    /// Releases the emergency stop. The fault stays until `reset`.
    ReleaseStop,
    /// Lets simulated time go on while nothing is to be done. Only in simulated runs.
    Advance {
        /// For how long, in simulated s; above 0, at most 3600.
        seconds: f64,
    },
    /// Ends the session: the arm goes to the safe state and the log is closed.
    End,
}

/// Value of a parameter.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Value {
    /// On or off.
    Flag(bool),
    /// A number.
    Number(f64),
    /// A name.
    Name(String),
}

fn force() -> String {
    "force".to_owned()
}

impl Command {
    /// The controller's request behind the command; none for what the session itself does.
    ///
    /// # Errors
    /// In words, if a name or a number is not allowed.
    pub fn request(&self) -> Result<Option<Request>, String> {
        Ok(Some(match self {
            Self::Enable => Request::Enable,
            Self::Disable => Request::Disable,
            Self::Reset => Request::Reset,
            Self::Start { sequence } => Request::Start(variant(sequence).ok_or_else(|| {
                format!(
                    "there is no sequence `{sequence}`; use homing, wall_sensing, insert_stroke_pullout, campaign or \
                     friction_sweep"
                )
            })?),
            Self::Abort => Request::Abort,
            Self::Continue => Request::Continue,
            Self::Store { on } => Request::Store(*on),
            Self::Bias => Request::BiasForce,
            Self::Stroke { radius_m, base_deg, tool_angle_deg, depth_m, delta_deg, batch } => {
                Request::Stroke(StrokeSpec {
                    batch: *batch,
                    radius_m: *radius_m,
                    base_rad: base_deg.to_radians(),
                    tool_angle_rad: tool_angle_deg.to_radians(),
                    depth_m: *depth_m,
                    delta_rad: delta_deg.to_radians(),
                })
            }
            Self::PlanIndex { index } => Request::PlanIndex(*index),
            Self::Set { parameter, value } => Request::Tune(tunable(parameter, value)?),
            Self::EmergencyStop | Self::ReleaseStop | Self::End => return Ok(None),
            Self::Advance { seconds } => {
                ticks(*seconds)?;
                return Ok(None);
            }
            _ => Request::Push(self.trajectory()?),
        }))
    }

    fn trajectory(&self) -> Result<Trajectory, String> {
        Ok(match self {
            Self::MoveJoints { joints_deg } => {
                Trajectory::JointMove { target: JointAngles::from_degrees(*joints_deg) }
            }
            Self::MoveTip { x_m, y_m, z_m, tool_angle_deg } => Trajectory::CartesianMove {
                target: TaskPose {
                    x_m: *x_m,
                    y_m: *y_m,
                    z_m: *z_m,
                    n1_rad: (270.0 - tool_angle_deg).to_radians(),
                    n2_rad: 0.0,
                },
            },
            Self::Touch { direction, travel_m } => {
                Trajectory::CartesianTouch { direction: *direction, travel_m: *travel_m }
            }
            Self::Insert { depth_m } => Trajectory::Insert { depth_m: *depth_m },
            Self::Pull { delta_deg, law } => {
                Trajectory::Stroke { law: stroke_law(law)?, delta_rad: delta_deg.to_radians() }
            }
            Self::Velocity { rates_deg_s, seconds } => Trajectory::JointVelocity {
                rates: JointVelocities(rates_deg_s.map(f64::to_radians)),
                ticks: seconds.map(ticks).transpose()?,
            },
            Self::Follow { x_m, y_m, z_m, tool_angle_deg, hand } => Trajectory::Follow {
                hand: *hand,
                target: HandTarget {
                    x_m: *x_m,
                    y_m: *y_m,
                    z_m: *z_m,
                    tool_angle_rad: tool_angle_deg.to_radians(),
                },
            },
            Self::Hold { seconds } => Trajectory::Hold { ticks: Some(ticks(*seconds)?) },
            _ => return Err("this is no motion".to_owned()),
        })
    }
}

fn tunable(parameter: &str, value: &Value) -> Result<Tunable, String> {
    Ok(match (parameter, value) {
        ("speed_scale", Value::Number(scale)) => Tunable::SpeedScale(*scale),
        ("lead_rate_m_s", Value::Number(rate)) => Tunable::LeadRate(*rate),
        ("accommodate", Value::Flag(on)) => Tunable::Accommodate(*on),
        ("law", Value::Name(law)) => Tunable::Law(stroke_law(law)?),
        _ => {
            return Err(format!(
                "`{parameter}` cannot be set to {value:?}; use speed_scale or lead_rate_m_s with a number, accommodate \
                 with true or false, or law with force or position"
            ));
        }
    })
}

fn stroke_law(name: &str) -> Result<StrokeLaw, String> {
    variant(name).ok_or_else(|| format!("there is no law `{name}`; use force or position"))
}

/// Ticks of a time in s.
pub(crate) fn ticks(seconds: f64) -> Result<u32, String> {
    let ticks = seconds * TICK_RATE_HZ;
    if seconds > 0.0 && seconds <= 3600.0 {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in range")]
        return Ok((ticks.round() as u32).max(1));
    }
    Err(format!("the time is {seconds} s; it must be above 0 and at most 3600 s"))
}
