//! Requests as a name and numbers, so that any reader of ROS messages understands them. The numbers keep their bits.

use soilctl_controller::{HandTarget, Request, StrokeSpec, Trajectory, Tunable};
use soilctl_kinematics::{JointAngles, JointVelocities, TaskPose};

use super::words::{variant, word};

/// Name and numbers; no request is an empty name.
pub(super) fn encode(request: Option<&Request>) -> (String, Vec<f64>) {
    let Some(request) = request else { return (String::new(), Vec::new()) };
    let plain = |name: &str| (name.to_owned(), Vec::new());
    match *request {
        Request::Enable => plain("enable"),
        Request::Disable => plain("disable"),
        Request::Reset => plain("reset"),
        Request::Start(sequence) => (format!("start/{}", word(&sequence)), Vec::new()),
        Request::Abort => plain("abort"),
        Request::Push(trajectory) => {
            let (name, numbers) = push(&trajectory);
            (format!("push/{name}"), numbers)
        }
        Request::Continue => plain("continue"),
        Request::Store(on) => ("store".to_owned(), vec![flag(on)]),
        Request::BiasForce => plain("bias_force"),
        Request::Stroke(spec) => {
            let StrokeSpec { batch, radius_m, base_rad, tool_angle_rad, depth_m, delta_rad } = spec;
            let numbers = vec![f64::from(batch), radius_m, base_rad, tool_angle_rad, depth_m, delta_rad];
            ("stroke".to_owned(), numbers)
        }
        Request::PlanIndex(index) => ("plan_index".to_owned(), vec![f64::from(index)]),
        Request::Tune(Tunable::SpeedScale(value)) => ("tune/speed_scale".to_owned(), vec![value]),
        Request::Tune(Tunable::LeadRate(value)) => ("tune/lead_rate".to_owned(), vec![value]),
        Request::Tune(Tunable::Accommodate(on)) => ("tune/accommodate".to_owned(), vec![flag(on)]),
        Request::Tune(Tunable::Law(law)) => (format!("tune/law/{}", word(&law)), Vec::new()),
    }
}

fn push(trajectory: &Trajectory) -> (String, Vec<f64>) {
    let kind = word(&trajectory.kind());
    match *trajectory {
        Trajectory::Hold { ticks } => (kind, ticks.map(f64::from).into_iter().collect()),
        Trajectory::JointMove { target } => (kind, target.0.to_vec()),
        Trajectory::CartesianMove { target: TaskPose { x_m, y_m, z_m, n1_rad, n2_rad } } => {
            (kind, vec![x_m, y_m, z_m, n1_rad, n2_rad])
        }
        Trajectory::JointTouch { joint } => (format!("{kind}/{}", word(&joint)), Vec::new()),
        Trajectory::CartesianTouch { direction: [x, y, z], travel_m } => (kind, vec![x, y, z, travel_m]),
        Trajectory::Insert { depth_m } => (kind, vec![depth_m]),
        Trajectory::Stroke { law, delta_rad } => (format!("{kind}/{}", word(&law)), vec![delta_rad]),
        Trajectory::JointVelocity { rates, ticks } => {
            (kind, rates.0.into_iter().chain(ticks.map(f64::from)).collect())
        }
        Trajectory::Follow { hand, target: HandTarget { x_m, y_m, z_m, tool_angle_rad } } => {
            (kind, vec![f64::from(hand), x_m, y_m, z_m, tool_angle_rad])
        }
    }
}

/// The request of this name and these numbers.
///
/// # Errors
/// In words, if there is no such request.
pub(super) fn decode(name: &str, numbers: &[f64]) -> Result<Option<Request>, String> {
    if name.is_empty() && numbers.is_empty() {
        return Ok(None);
    }
    let mut parts = name.splitn(3, '/');
    let parts = [parts.next(), parts.next(), parts.next()];
    let request = match (parts, numbers) {
        ([Some("enable"), None, _], []) => Some(Request::Enable),
        ([Some("disable"), None, _], []) => Some(Request::Disable),
        ([Some("reset"), None, _], []) => Some(Request::Reset),
        ([Some("abort"), None, _], []) => Some(Request::Abort),
        ([Some("continue"), None, _], []) => Some(Request::Continue),
        ([Some("bias_force"), None, _], []) => Some(Request::BiasForce),
        ([Some("start"), Some(sequence), None], []) => variant(sequence).map(Request::Start),
        ([Some("push"), Some(kind), detail], numbers) => pushed(kind, detail, numbers).map(Request::Push),
        ([Some("store"), None, _], &[on]) => flagged(on).map(Request::Store),
        ([Some("stroke"), None, _], &[batch, radius_m, base_rad, tool_angle_rad, depth_m, delta_rad]) => {
            short(batch).map(|batch| {
                Request::Stroke(StrokeSpec { batch, radius_m, base_rad, tool_angle_rad, depth_m, delta_rad })
            })
        }
        ([Some("plan_index"), None, _], &[index]) => short(index).map(Request::PlanIndex),
        ([Some("tune"), Some("speed_scale"), None], &[value]) => {
            Some(Request::Tune(Tunable::SpeedScale(value)))
        }
        ([Some("tune"), Some("lead_rate"), None], &[value]) => Some(Request::Tune(Tunable::LeadRate(value))),
        ([Some("tune"), Some("accommodate"), None], &[on]) => {
            flagged(on).map(|on| Request::Tune(Tunable::Accommodate(on)))
        }
        ([Some("tune"), Some("law"), Some(law)], []) => {
            variant(law).map(|law| Request::Tune(Tunable::Law(law)))
        }
        _ => None,
    };
    match request {
        Some(request) => Ok(Some(request)),
        None => Err(format!("there is no request `{name}` with the numbers {numbers:?}")),
    }
}

fn pushed(kind: &str, detail: Option<&str>, numbers: &[f64]) -> Option<Trajectory> {
    Some(match (kind, detail, numbers) {
        ("hold", None, []) => Trajectory::Hold { ticks: None },
        ("hold", None, &[ticks]) => Trajectory::Hold { ticks: Some(whole(ticks)?) },
        ("joint_move", None, &[a, b, c, d, e]) => {
            Trajectory::JointMove { target: JointAngles([a, b, c, d, e]) }
        }
        ("cartesian_move", None, &[x_m, y_m, z_m, n1_rad, n2_rad]) => {
            Trajectory::CartesianMove { target: TaskPose { x_m, y_m, z_m, n1_rad, n2_rad } }
        }
        ("joint_touch", Some(joint), []) => Trajectory::JointTouch { joint: variant(joint)? },
        ("cartesian_touch", None, &[x, y, z, travel_m]) => {
            Trajectory::CartesianTouch { direction: [x, y, z], travel_m }
        }
        ("insert", None, &[depth_m]) => Trajectory::Insert { depth_m },
        ("stroke", Some(law), &[delta_rad]) => Trajectory::Stroke { law: variant(law)?, delta_rad },
        ("joint_velocity", None, &[a, b, c, d, e]) => {
            Trajectory::JointVelocity { rates: JointVelocities([a, b, c, d, e]), ticks: None }
        }
        ("joint_velocity", None, &[a, b, c, d, e, ticks]) => {
            Trajectory::JointVelocity { rates: JointVelocities([a, b, c, d, e]), ticks: Some(whole(ticks)?) }
        }
        ("follow", None, &[hand, x_m, y_m, z_m, tool_angle_rad]) => {
            Trajectory::Follow { hand: whole(hand)?, target: HandTarget { x_m, y_m, z_m, tool_angle_rad } }
        }
        _ => return None,
    })
}

fn flag(on: bool) -> f64 {
    if on { 1.0 } else { 0.0 }
}

fn flagged(value: f64) -> Option<bool> {
    [false, true].into_iter().find(|&on| flag(on).to_bits() == value.to_bits())
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked by the way back")]
fn whole(value: f64) -> Option<u32> {
    let number = value as u32;
    (f64::from(number).to_bits() == value.to_bits()).then_some(number)
}

fn short(value: f64) -> Option<u16> {
    u16::try_from(whole(value)?).ok()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use soilctl_controller::{SequenceId, StrokeLaw};
    use soilctl_kinematics::Joint;

    use super::*;

    /// Any float64 bits, since what an operator's side sends may be anything.
    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![any::<u64>().prop_map(f64::from_bits), -2.0..2.0, Just(-0.0)]
    }

    fn law() -> impl Strategy<Value = StrokeLaw> {
        prop_oneof![Just(StrokeLaw::Force), Just(StrokeLaw::Position)]
    }

    fn five() -> impl Strategy<Value = [f64; 5]> {
        prop::array::uniform5(number())
    }

    fn trajectory() -> impl Strategy<Value = Trajectory> {
        let ticks = || prop::option::of(any::<u32>());
        prop_oneof![
            ticks().prop_map(|ticks| Trajectory::Hold { ticks }),
            five().prop_map(|q| Trajectory::JointMove { target: JointAngles(q) }),
            five().prop_map(|[x_m, y_m, z_m, n1_rad, n2_rad]| {
                Trajectory::CartesianMove { target: TaskPose { x_m, y_m, z_m, n1_rad, n2_rad } }
            }),
            prop::sample::select(Joint::ALL.to_vec()).prop_map(|joint| Trajectory::JointTouch { joint }),
            (prop::array::uniform3(number()), number())
                .prop_map(|(direction, travel_m)| Trajectory::CartesianTouch { direction, travel_m }),
            number().prop_map(|depth_m| Trajectory::Insert { depth_m }),
            (law(), number()).prop_map(|(law, delta_rad)| Trajectory::Stroke { law, delta_rad }),
            (five(), ticks()).prop_map(|(rates, ticks)| Trajectory::JointVelocity {
                rates: JointVelocities(rates),
                ticks
            }),
            (any::<u32>(), prop::array::uniform4(number())).prop_map(
                |(hand, [x_m, y_m, z_m, tool_angle_rad])| {
                    Trajectory::Follow { hand, target: HandTarget { x_m, y_m, z_m, tool_angle_rad } }
                }
            ),
        ]
    }

    fn any_request() -> impl Strategy<Value = Request> {
        let plain = [
            Request::Enable,
            Request::Disable,
            Request::Reset,
            Request::Abort,
            Request::Continue,
            Request::BiasForce,
        ];
        prop_oneof![
            2 => prop::sample::select(plain.to_vec()),
            1 => prop::sample::select(SequenceId::ALL.to_vec()).prop_map(Request::Start),
            8 => trajectory().prop_map(Request::Push),
            1 => any::<bool>().prop_map(Request::Store),
            2 => (any::<u16>(), five()).prop_map(|(batch, [a, b, c, d, e])| Request::Stroke(StrokeSpec {
                batch, radius_m: a, base_rad: b, tool_angle_rad: c, depth_m: d, delta_rad: e,
            })),
            1 => any::<u16>().prop_map(Request::PlanIndex),
            1 => number().prop_map(|value| Request::Tune(Tunable::SpeedScale(value))),
            1 => number().prop_map(|value| Request::Tune(Tunable::LeadRate(value))),
            1 => any::<bool>().prop_map(|on| Request::Tune(Tunable::Accommodate(on))),
            1 => law().prop_map(|law| Request::Tune(Tunable::Law(law))),
        ]
    }

    proptest! {
        #[test]
        fn requests_keep_every_bit(request in any_request()) {
            let (name, numbers) = encode(Some(&request));
            let back = decode(&name, &numbers).unwrap();
            // NaN is not equal to itself, so compare what is written of the two.
            let (name_again, numbers_again) = encode(back.as_ref());
            prop_assert_eq!(format!("{request:?}"), format!("{:?}", back.unwrap()));
            prop_assert_eq!(name, name_again);
            let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
            prop_assert_eq!(bits(&numbers), bits(&numbers_again));
        }

        #[test]
        fn other_names_and_numbers_are_refused_or_stay_what_they_are(
            name in "[a-z_/]{0,24}|push/hold|store|plan_index|stroke", numbers in prop::collection::vec(number(), 0..8),
        ) {
            if let Ok(request) = decode(&name, &numbers) {
                let (same, _) = encode(request.as_ref());
                prop_assert_eq!(same, name);
            }
        }
    }
}
