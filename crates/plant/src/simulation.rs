use soilctl_controller::{Commands, Mode, Outputs, Params, Request, Sensed, SequenceId, State, step};

use crate::hardware::{Drive, Hardware};
use crate::{Plant, PlantError, Truth};

/// One tick of a run, as a log stores it.
#[derive(Debug, Clone, Copy)]
pub struct Tick<'a> {
    /// What the hardware reported.
    pub sensed: &'a Sensed,
    /// What the operator's side wanted.
    pub commands: &'a Commands,
    /// What the controller answered.
    pub outputs: &'a Outputs,
    /// The controller's memory after the tick.
    pub state: &'a State,
    /// What no sensor tells: the true state in which `sensed` was read.
    pub truth: &'a Truth,
}

/// Controller and plant together, as fast as possible.
pub struct Simulation {
    params: Params,
    state: State,
    plant: Plant,
    drive: Drive,
    outputs: Outputs,
    heartbeat: u32,
}

impl Simulation {
    /// A controller that is off and a plant that waits.
    #[must_use]
    pub fn new(params: Params, plant: Plant) -> Self {
        let state = State::new(&params);
        Self { params, state, plant, drive: Drive::default(), outputs: Outputs::default(), heartbeat: 0 }
    }

    /// The controller's parameters.
    #[must_use]
    pub const fn params(&self) -> &Params {
        &self.params
    }

    /// The controller's memory.
    #[must_use]
    pub const fn state(&self) -> &State {
        &self.state
    }

    /// The controller's memory, to start from a homed arm or a key frame.
    #[must_use]
    pub const fn state_mut(&mut self) -> &mut State {
        &mut self.state
    }

    /// The plant.
    #[must_use]
    pub const fn plant(&self) -> &Plant {
        &self.plant
    }

    /// The plant, to prepare its soil.
    #[must_use]
    pub const fn plant_mut(&mut self) -> &mut Plant {
        &mut self.plant
    }

    /// Outputs of the last tick.
    #[must_use]
    pub const fn outputs(&self) -> &Outputs {
        &self.outputs
    }

    /// One tick: plant, then controller, then the observer.
    ///
    /// # Errors
    /// [`PlantError::Diverged`] if the simulated arm left all bounds.
    pub fn tick(
        &mut self,
        request: Option<Request>,
        observer: &mut dyn FnMut(Tick<'_>),
    ) -> Result<Outputs, PlantError> {
        self.heartbeat = self.heartbeat.wrapping_add(1);
        let commands = Commands { heartbeat: self.heartbeat, emergency_stop: false, request };
        self.tick_with(&commands, |_| {}, observer)
    }

    /// One tick with commands of one's own and readings that are spoilt before the controller sees them.
    ///
    /// # Errors
    /// As [`Simulation::tick`].
    pub fn tick_with(
        &mut self,
        commands: &Commands,
        spoil: impl FnOnce(&mut Sensed),
        observer: &mut dyn FnMut(Tick<'_>),
    ) -> Result<Outputs, PlantError> {
        let mut sensed = self.plant.exchange(&self.drive)?;
        spoil(&mut sensed);
        let outputs = step(&self.params, &mut self.state, &sensed, commands);
        self.drive = Drive::from(&outputs);
        self.outputs = outputs;
        observer(Tick {
            sensed: &sensed,
            commands,
            outputs: &outputs,
            state: &self.state,
            truth: self.plant.truth(),
        });
        Ok(outputs)
    }

    /// Ticks without a request.
    ///
    /// # Errors
    /// As [`Simulation::tick`].
    pub fn run(&mut self, ticks: u32, observer: &mut dyn FnMut(Tick<'_>)) -> Result<(), PlantError> {
        for _ in 0..ticks {
            self.tick(None, observer)?;
        }
        Ok(())
    }

    /// Starts a sequence and runs until it has ended, the arm is off, or `most_ticks` are over. Whenever the sequence waits
    /// for fresh soil, it is prepared. Says whether the sequence succeeded.
    ///
    /// # Errors
    /// As [`Simulation::tick`].
    pub fn run_sequence(
        &mut self,
        sequence: SequenceId,
        most_ticks: u32,
        observer: &mut dyn FnMut(Tick<'_>),
    ) -> Result<bool, PlantError> {
        use soilctl_controller::EventKind;
        let mut request = Some(Request::Start(sequence));
        for _ in 0..most_ticks {
            let outputs = self.tick(request.take(), observer)?;
            let is = |wanted: EventKind| outputs.events.as_slice().iter().any(|event| event.kind == wanted);
            if is(EventKind::SequenceSucceeded(sequence)) {
                return Ok(true);
            }
            if is(EventKind::SequenceFailed(sequence)) || outputs.mode != Mode::Ready {
                return Ok(false);
            }
            if self.state.machine.waits() {
                if let Some(ground) = self.plant.ground_mut() {
                    ground.prepare();
                }
                request = Some(Request::Continue);
            }
        }
        Ok(false)
    }
}
