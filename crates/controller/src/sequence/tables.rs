use soilctl_kinematics::Joint;

use super::{Action, Condition, Goto, Sequence, SequenceId, Step, Transition};

const fn on(when: Condition, go: Goto) -> Transition {
    Transition { when, go }
}

const fn step(name: &'static str, action: Action, next: &'static [Transition]) -> Step {
    Step { name, action, store: false, next }
}

const fn stored(name: &'static str, action: Action, next: &'static [Transition]) -> Step {
    Step { name, action, store: true, next }
}

use Condition::{
    Always, CallFailed, CallSucceeded, Contact, Continued, Done, Failed, NewSoil, NoLift, StrokeLeft,
};
use Goto::{Fail, Step as To, Succeed};

// From the hand inwards, so that the arm is folded when it swings.
const HOMING: &[Step] = &[
    step("wrist to its stop", Action::TouchStop(Joint::Wrist), &[on(Contact, To(1)), on(Done, Fail)]),
    step("twist to its stop", Action::TouchStop(Joint::Twist), &[on(Contact, To(2)), on(Done, Fail)]),
    step("elbow to its stop", Action::TouchStop(Joint::Elbow), &[on(Contact, To(3)), on(Done, Fail)]),
    step("shoulder to its stop", Action::TouchStop(Joint::Shoulder), &[on(Contact, To(4)), on(Done, Fail)]),
    step("base to its stop", Action::TouchStop(Joint::Base), &[on(Contact, To(5)), on(Done, Fail)]),
    step("reference the encoders", Action::SetHome, &[on(Done, To(6))]),
    step("park", Action::Park, &[on(Failed, Fail), on(Done, Succeed)]),
];

const WALL_SENSING: &[Step] = &[
    step("take the bias", Action::Bias, &[on(Done, To(1))]),
    step("remember the pose", Action::Remember, &[on(Always, To(2))]),
    step("to the wall at +x", Action::TouchWall(0), &[on(Contact, To(3)), on(Done, To(10))]),
    step("back", Action::Return, &[on(Failed, Fail), on(Done, To(4))]),
    step("to the wall at -x", Action::TouchWall(1), &[on(Contact, To(5)), on(Done, To(10))]),
    step("back", Action::Return, &[on(Failed, Fail), on(Done, To(6))]),
    step("to the wall at +y", Action::TouchWall(2), &[on(Contact, To(7)), on(Done, To(10))]),
    step("back", Action::Return, &[on(Failed, Fail), on(Done, To(8))]),
    step("to the wall at -y", Action::TouchWall(3), &[on(Contact, To(9)), on(Done, To(10))]),
    step("back", Action::Return, &[on(Failed, Fail), on(Done, Succeed)]),
    step("back without a wall", Action::Return, &[on(Done, Fail)]),
];

const INSERT_STROKE_PULLOUT: &[Step] = &[
    step("take the bias", Action::Bias, &[on(Done, To(1))]),
    step("down to the soil", Action::TouchSoil, &[on(Contact, To(2)), on(Done, To(5))]),
    stored("insert", Action::Insert, &[on(Failed, To(5)), on(Done, To(3))]),
    stored("stroke", Action::Stroke, &[on(Failed, To(5)), on(Done, To(4))]),
    step("pull out", Action::PullOut, &[on(Failed, Fail), on(Done, Succeed)]),
    step("pull out in vain", Action::PullOut, &[on(Done, Fail)]),
];

const CAMPAIGN: &[Step] = &[
    step("first stroke of the plan", Action::PlanFirst, &[on(StrokeLeft, To(1)), on(Always, Succeed)]),
    step("go to the stroke", Action::GoToStroke, &[on(Failed, Fail), on(Done, To(2))]),
    step(
        "make the stroke",
        Action::Call(SequenceId::InsertStrokePullout),
        &[on(CallSucceeded, To(3)), on(CallFailed, Fail)],
    ),
    step(
        "next stroke of the plan",
        Action::PlanNext,
        &[on(StrokeLeft, To(1)), on(NewSoil, To(4)), on(Always, Succeed)],
    ),
    step("wait for fresh soil", Action::Wait, &[on(Continued, To(1))]),
];

const FRICTION_SWEEP: &[Step] = &[
    step("first angle", Action::SweepFirst, &[on(StrokeLeft, To(1)), on(Always, Fail)]),
    step("go to the stroke", Action::GoToStroke, &[on(Failed, Fail), on(Done, To(2))]),
    step(
        "make the stroke",
        Action::Call(SequenceId::InsertStrokePullout),
        &[on(CallSucceeded, To(3)), on(CallFailed, Fail)],
    ),
    step("judge the stroke", Action::Wait, &[on(NoLift, Succeed), on(Always, To(4))]),
    step("next angle", Action::SweepNext, &[on(StrokeLeft, To(1)), on(NewSoil, To(5)), on(Always, Fail)]),
    step("wait for fresh soil", Action::Wait, &[on(Continued, To(1))]),
];

/// The table of a sequence.
#[must_use]
pub const fn table(id: SequenceId) -> Sequence {
    match id {
        SequenceId::Homing => Sequence { name: "homing", steps: HOMING },
        SequenceId::WallSensing => Sequence { name: "wall_sensing", steps: WALL_SENSING },
        SequenceId::InsertStrokePullout => {
            Sequence { name: "insert_stroke_pullout", steps: INSERT_STROKE_PULLOUT }
        }
        SequenceId::Campaign => Sequence { name: "campaign", steps: CAMPAIGN },
        SequenceId::FrictionSweep => Sequence { name: "friction_sweep", steps: FRICTION_SWEEP },
    }
}
