//! No input makes the controller panic or send a number that is none.
#![allow(clippy::unwrap_used)]

mod common;

use common::Rig;
use proptest::prelude::*;
use soilctl_controller::{
    Commands, HandTarget, Outputs, Params, Request, Sensed, SequenceId, State, StrokeLaw, StrokeSpec,
    Trajectory, Tunable, step,
};
use soilctl_kinematics::{JointAngles, JointVelocities, TaskPose};

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => -2.0..2.0,
        1 => any::<u64>().prop_map(f64::from_bits),
        1 => prop::sample::select(vec![f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, -0.0, 1e-310]),
    ]
}

fn trajectory() -> impl Strategy<Value = Trajectory> {
    prop_oneof![
        prop::option::of(any::<u32>()).prop_map(|ticks| Trajectory::Hold { ticks }),
        prop::array::uniform5(number()).prop_map(|q| Trajectory::JointMove { target: JointAngles(q) }),
        prop::array::uniform5(number()).prop_map(|[x_m, y_m, z_m, n1_rad, n2_rad]| {
            Trajectory::CartesianMove { target: TaskPose { x_m, y_m, z_m, n1_rad, n2_rad } }
        }),
        Just(Trajectory::JointTouch { joint: soilctl_kinematics::Joint::Elbow }),
        (prop::array::uniform3(number()), number())
            .prop_map(|(direction, travel_m)| Trajectory::CartesianTouch { direction, travel_m }),
        number().prop_map(|depth_m| Trajectory::Insert { depth_m }),
        (number(), any::<bool>()).prop_map(|(delta_rad, force)| Trajectory::Stroke {
            law: if force { StrokeLaw::Force } else { StrokeLaw::Position },
            delta_rad,
        }),
        (prop::array::uniform5(number()), prop::option::of(any::<u32>()))
            .prop_map(|(rates, ticks)| Trajectory::JointVelocity { rates: JointVelocities(rates), ticks }),
        (0_u32..3, prop::array::uniform4(number())).prop_map(|(hand, [x_m, y_m, z_m, tool_angle_rad])| {
            Trajectory::Follow { hand, target: HandTarget { x_m, y_m, z_m, tool_angle_rad } }
        }),
    ]
}

fn request() -> impl Strategy<Value = Request> {
    prop_oneof![
        4 => Just(Request::Enable),
        1 => Just(Request::Disable),
        2 => Just(Request::Reset),
        2 => prop::sample::select(SequenceId::ALL.to_vec()).prop_map(Request::Start),
        1 => Just(Request::Abort),
        4 => trajectory().prop_map(Request::Push),
        1 => Just(Request::Continue),
        1 => any::<bool>().prop_map(Request::Store),
        1 => Just(Request::BiasForce),
        1 => prop::array::uniform5(number()).prop_map(|[a, b, c, d, e]| Request::Stroke(StrokeSpec {
            batch: 3, radius_m: a, base_rad: b, tool_angle_rad: c, depth_m: d, delta_rad: e,
        })),
        1 => any::<u16>().prop_map(Request::PlanIndex),
        1 => number().prop_map(|value| Request::Tune(Tunable::SpeedScale(value))),
        1 => number().prop_map(|value| Request::Tune(Tunable::LeadRate(value))),
    ]
}

/// A spoilt field of the reading: which, where, and with what.
fn spoil(sensed: &mut Sensed, (field, place, value): (u8, usize, f64), counts: i32) {
    match field {
        0 => sensed.wrench[place % 6] = value,
        1 => sensed.amplifier_current_a[place % 5] = value,
        2 => sensed.amplifier_voltage_v[place % 5] = value,
        3 => sensed.motor_counts[place % 5] = counts,
        4 => sensed.external_counts[place % 5] = counts,
        5 => sensed.tick = value.to_bits(),
        _ => {}
    }
}

fn all_finite(outputs: &Outputs, state: &State) -> bool {
    let seen = &outputs.telemetry;
    // serde_json writes numbers that are none as null, and null is no number when read.
    serde_json::from_str::<State>(&serde_json::to_string(state).unwrap()).is_ok()
        && outputs.motor_torques.0.iter().chain(&outputs.motor_currents_a).all(|x| x.is_finite())
        && seen
            .joint_torques
            .0
            .iter()
            .chain(&seen.force_rtz_n)
            .chain(&seen.motor_joints.0)
            .all(|x| x.is_finite())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn nothing_panics_and_outputs_are_numbers(
        homed in any::<bool>(),
        script in prop::collection::vec(
            (prop::option::of(request()), prop::option::weighted(0.2, (0_u8..8, 0_usize..6, number())), any::<i32>(), 1_usize..40),
            1..30,
        ),
    ) {
        let params = Params::thesis();
        let pose = TaskPose::digging(0.4318, 0.0, -0.25, 1.5).unwrap();
        let start = params.arm().inverse(&pose).unwrap();
        let mut rig = if homed { Rig::homed(params, start) } else { Rig::new(params, start.0) };
        for (request, spoilt, counts, ticks) in script {
            for n in 0..ticks {
                let (mut sensed, mut commands) = (rig.plant.sense(), rig.commands());
                if n == 0 {
                    commands.request = request;
                    if let Some(spoilt) = spoilt {
                        spoil(&mut sensed, spoilt, counts);
                    }
                }
                let outputs = rig.tick_with(&sensed, &commands);
                prop_assert!(all_finite(&outputs, &rig.state), "{:?}", outputs);
            }
        }
    }

    #[test]
    fn readings_of_any_kind(
        readings in prop::collection::vec(
            (any::<[i32; 5]>(), any::<[i32; 5]>(), prop::array::uniform6(number()), prop::array::uniform5(number()), any::<u64>()),
            1..20,
        ),
    ) {
        let params = Params::thesis();
        let mut state = State::new(&params);
        for (i, (motor_counts, external_counts, wrench, current, tick)) in readings.into_iter().enumerate() {
            let sensed = Sensed {
                tick, motor_counts, external_counts, wrench, amplifier_current_a: current, ..Sensed::default()
            };
            let request = Some(if i % 2 == 0 { Request::Reset } else { Request::Enable });
            let outputs = step(&params, &mut state, &sensed, &Commands { request, ..Commands::default() });
            prop_assert!(all_finite(&outputs, &state));
        }
    }
}
