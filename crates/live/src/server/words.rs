use soilctl_controller::Refusal;
use soilctl_session::messages::{ControllerStep, word};

use crate::links::Snapshot;
use crate::protocol::{FaultState, LedState, Memory, StateMessage, seconds};

/// The state in a snapshot.
pub(super) fn message(snapshot: &Snapshot) -> StateMessage {
    let Snapshot { sensed, commands, outputs, .. } = snapshot;
    let memory = Memory {
        homed: snapshot.homed,
        waiting: snapshot.waiting,
        fault: snapshot.fault.map(|fault| FaultState {
            kind: word(&fault.fault),
            index: fault.index,
            value: fault.value,
            limit: fault.limit,
            tick: fault.tick,
        }),
        stroke_radius_m: snapshot.stroke_radius_m,
    };
    let step = ControllerStep::new(0, sensed, commands, outputs);
    let state = StateMessage::new(&step, &memory);
    StateMessage {
        paused: snapshot.paused,
        safe_force_n: snapshot.safe_force_n,
        led: snapshot.led.map(|led| LedState {
            hand: led.hand,
            x_m: led.target.x_m,
            y_m: led.target.y_m,
            z_m: led.target.z_m,
            tool_angle_deg: led.target.tool_angle_rad.to_degrees(),
            limit: word(&led.limit),
            load: led.load,
        }),
        behind_s: seconds(snapshot.behind_ticks),
        ..state
    }
}

/// What to do about a refusal.
pub(super) const fn advice(refusal: Refusal) -> &'static str {
    match refusal {
        Refusal::Mode => "not in this mode; `enable` comes first, after a fault `reset`",
        Refusal::Busy => "a sequence or a motion runs; wait for its end, or `abort` it",
        Refusal::NotHomed => "the arm is not homed; `start homing` first",
        Refusal::RingFull => "too many motions wait; wait for some to end",
        Refusal::Value => "a number is out of its range, or the arm does not reach there",
        Refusal::NothingWaits => "no sequence waits for the soil",
        Refusal::OtherHand => "another hand leads the plate; wait until it lets go, or `abort`",
        Refusal::EmergencyStop => "the emergency stop is pressed; `release_stop` first",
    }
}
