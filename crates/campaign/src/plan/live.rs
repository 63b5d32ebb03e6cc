//! From a plan to what runs: the record of a session, the simulated plant, controller and plant together.

use soilctl_controller::{Params, State};
use soilctl_earth_pressure::{model, plane_model};
use soilctl_plant::{Ground, Plant, Simulation};
use soilctl_session::SessionSetup;

use crate::{CampaignError, Plan, seed};

impl Plan {
    /// What a log of this campaign begins with: arm, settings and the whole plan as TOML. `seed` is that of the campaign,
    /// or of the run.
    ///
    /// # Errors
    /// [`CampaignError::Session`] if the settings cannot be put into TOML.
    pub fn setup(&self, seed: u64) -> Result<SessionSetup, CampaignError> {
        let arm = self.params().arm().config();
        Ok(SessionSetup::new(arm, self.controller(), self.text(), seed, &self.file().model)?)
    }

    /// The simulated arm, parked, over freshly prepared soil. `seed` is that of the campaign; each batch has noise and
    /// scatter of its own, whatever ran before.
    ///
    /// # Errors
    /// [`CampaignError::Plant`] or [`CampaignError::Model`] if the soil and its force model do not go together.
    pub fn simulated_plant(&self, seed: u64, batch: usize) -> Result<Plant, CampaignError> {
        let plane_strain = plane_model(&self.file().model)?;
        let surface_z_m = self.controller().site.surface_z_m;
        let [soil_seed, sensor_seed] = seed::of_batch(seed, batch);
        let mut ground =
            Ground::new(self.plant(), self.soil(), plane_strain.as_ref(), surface_z_m, soil_seed)?;
        let end_factor = self.file().end_factor;
        if end_factor != 0.0 {
            ground = ground.with_ends(model("table")?.as_ref(), end_factor)?;
        }
        ground = ground.with_blocks(self.blocks_of(batch))?;
        ground.prepare();
        let park = soilctl_kinematics::JointAngles::from_degrees(self.controller().site.park_deg);
        Ok(Plant::new(self.plant().clone(), Some(ground), &park, sensor_seed)?)
    }

    /// Controller and simulated plant together, switched off, with referenced encoders unless the plan wants homing.
    ///
    /// `setup` is from [`Plan::setup`]: the controller runs with the parameters that the log holds.
    ///
    /// # Errors
    /// As [`Plan::simulated_plant`].
    pub fn simulation(
        &self,
        setup: &SessionSetup,
        seed: u64,
        batch: usize,
    ) -> Result<Simulation, CampaignError> {
        let plant = self.simulated_plant(seed, batch)?;
        let params = setup.params()?;
        let state = self.first_state(&params);
        let mut simulation = Simulation::new(params, plant);
        *simulation.state_mut() = state;
        Ok(simulation)
    }

    /// The controller's memory before the first step on the simulated plant.
    #[must_use]
    pub fn first_state(&self, params: &Params) -> State {
        let mut state = State::new(params);
        if !self.file().homing {
            let encoders = &self.plant().config().encoders;
            (state.homed, state.filters.offset_known) = (true, true);
            state.filters.motor_zero = encoders.motor_offset_counts;
            state.filters.external_zero = encoders.external_offset_counts;
        }
        state
    }
}
