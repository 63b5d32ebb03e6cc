use soilctl_live::protocol::{Dropped, FaultState, Pose, StateMessage};

/// A state in little memory: single precision, and words by number.
#[derive(Debug, Clone)]
pub(super) struct Sample {
    tick: u64,
    joints_deg: [f32; 5],
    /// Where the joints are: of the log's truth if it has any, else the same.
    true_deg: [f32; 5],
    rates_deg_s: [f32; 5],
    desired_deg: [f32; 5],
    torques_nm: [f32; 5],
    /// NaN stands for none.
    plate: [f32; 5],
    force_rtz_n: [f32; 3],
    stroke: [f32; 5],
    storage_segment: u32,
    words: [u16; 3],
    /// Number of the fault from 1, or 0.
    fault: u16,
    sequence_step: u8,
    homed: bool,
    waiting: bool,
    storing: bool,
}

/// The words of states, in the order in which they came up.
#[derive(Debug, Default)]
pub(super) struct Words {
    words: Vec<String>,
    faults: Vec<FaultState>,
}

impl Words {
    fn number(&mut self, word: &str) -> u16 {
        let place = self.words.iter().position(|known| known == word).unwrap_or_else(|| {
            self.words.push(word.to_owned());
            self.words.len() - 1
        });
        u16::try_from(place).unwrap_or(u16::MAX)
    }

    fn fault_number(&mut self, fault: Option<&FaultState>) -> u16 {
        let Some(fault) = fault else { return 0 };
        if self.faults.last() != Some(fault) {
            self.faults.push(fault.clone());
        }
        u16::try_from(self.faults.len()).unwrap_or(u16::MAX)
    }

    fn word(&self, number: u16) -> String {
        self.words.get(usize::from(number)).cloned().unwrap_or_default()
    }
}

#[allow(clippy::cast_possible_truncation, reason = "to be looked at")]
fn small<const N: usize>(numbers: [f64; N]) -> [f32; N] {
    numbers.map(|number| number as f32)
}

impl Sample {
    pub(super) fn new(state: &StateMessage, true_deg: [f64; 5], words: &mut Words) -> Self {
        let or_nan = |value: Option<f64>| value.unwrap_or(f64::NAN);
        Self {
            tick: state.tick,
            joints_deg: small(state.joints_deg),
            true_deg: small(true_deg),
            rates_deg_s: small(state.joint_rates_deg_s),
            desired_deg: small(state.desired_joints_deg),
            torques_nm: small(state.joint_torques_nm),
            plate: state.plate.map_or([f32::NAN; 5], |plate| {
                small([plate.x_m, plate.y_m, plate.z_m, plate.tool_angle_deg, plate.lean_deg])
            }),
            force_rtz_n: small(state.force_rtz_n),
            stroke: small([
                or_nan(state.friction_angle_deg),
                or_nan(state.friction_setpoint_deg),
                or_nan(state.displacement_m),
                or_nan(state.lead_m),
                or_nan(state.lead_inclination_deg),
            ]),
            storage_segment: state.storage_segment,
            words: [
                words.number(&state.mode),
                words.number(state.sequence.as_deref().unwrap_or_default()),
                words.number(state.trajectory.as_deref().unwrap_or_default()),
            ],
            fault: words.fault_number(state.fault.as_ref()),
            sequence_step: state.sequence_step,
            homed: state.homed,
            waiting: state.waiting,
            storing: state.storing,
        }
    }

    pub(super) fn state(&self, words: &Words) -> StateMessage {
        let wide = |numbers: [f32; 5]| numbers.map(f64::from);
        let some = |value: f64| value.is_finite().then_some(value);
        let [mode, sequence, trajectory] = self.words.map(|number| words.word(number));
        let name = |word: String| (!word.is_empty()).then_some(word);
        let [x_m, y_m, z_m, tool_angle_deg, lean_deg] = wide(self.plate);
        let [friction, setpoint, displacement, lead, inclination] = wide(self.stroke).map(some);
        StateMessage {
            tick: self.tick,
            time_s: self.time_s(),
            mode,
            homed: self.homed,
            paused: false,
            waiting: self.waiting,
            sequence: name(sequence),
            sequence_step: self.sequence_step,
            trajectory: name(trajectory),
            joints_deg: wide(self.joints_deg),
            joint_rates_deg_s: wide(self.rates_deg_s),
            desired_joints_deg: wide(self.desired_deg),
            joint_torques_nm: wide(self.torques_nm),
            plate: some(x_m).map(|x_m| Pose { x_m, y_m, z_m, tool_angle_deg, lean_deg }),
            force_rtz_n: self.force_rtz_n.map(f64::from),
            friction_angle_deg: friction,
            friction_setpoint_deg: setpoint,
            displacement_m: displacement,
            lead_m: lead,
            lead_inclination_deg: inclination,
            safe_force_n: None,
            fault: usize::from(self.fault)
                .checked_sub(1)
                .and_then(|number| words.faults.get(number))
                .cloned(),
            storing: self.storing,
            storage_segment: self.storage_segment,
            led: None,
            behind_s: 0.0,
            dropped: Dropped::default(),
        }
    }

    #[allow(clippy::cast_precision_loss, reason = "exact for longer than any log")]
    pub(super) fn time_s(&self) -> f64 {
        self.tick as f64 * soilctl_controller::TICK_S
    }

    pub(super) fn true_deg(&self) -> [f64; 5] {
        self.true_deg.map(f64::from)
    }

    pub(super) const fn homed(&self) -> bool {
        self.homed
    }

    pub(super) const fn waiting(&self) -> bool {
        self.waiting
    }

    pub(super) fn force_n(&self) -> f32 {
        self.force_rtz_n.iter().map(|part| part * part).sum::<f32>().sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_comes_back_but_for_single_precision() {
        let mut words = Words::default();
        let fault = FaultState { kind: "tip_force".to_owned(), index: 0, value: 41.5, limit: 40.0, tick: 16 };
        let state = StateMessage {
            tick: 16,
            time_s: 0.032,
            mode: "fault".to_owned(),
            homed: true,
            sequence: Some("campaign".to_owned()),
            sequence_step: 3,
            joints_deg: [1.5, 2.25, -3.0, 0.0, 90.0],
            plate: Some(Pose { x_m: 0.5, y_m: -0.25, z_m: -0.375, tool_angle_deg: 80.0, lean_deg: 0.0 }),
            friction_angle_deg: Some(23.5),
            fault: Some(fault),
            ..StateMessage::default()
        };
        let still =
            StateMessage { tick: 32, time_s: 0.064, mode: "off".to_owned(), ..StateMessage::default() };
        for state in [state, still] {
            assert_eq!(Sample::new(&state, state.joints_deg, &mut words).state(&words), state);
        }
    }
}
