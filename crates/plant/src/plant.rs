use soilctl_controller::Sensed;
use soilctl_kinematics::{Frame, JointAngles, JointVelocities};

use crate::bodies::{Bodies, PointForce};
use crate::drives::Drives;
use crate::effects::Effects;
use crate::force_sensor::ForceSensor;
use crate::ground::Ground;
use crate::hardware::{Drive, Hardware};
use crate::noise::Noise;
use crate::truth::Truth;
use crate::{PlantError, PlantParams, sensors};

/// The simulated arm with its drives and sensors, and the ground it works in.
///
/// Deterministic: the same parameters, ground, seed and drives give the same bits.
pub struct Plant {
    params: PlantParams,
    bodies: Bodies,
    drives: Drives,
    sensor: ForceSensor,
    ground: Option<Ground>,
    effects: Box<dyn Effects>,
    noise: Noise,
    loads: Vec<PointForce>,
    tick: u64,
    truth: Truth,
}

impl Plant {
    /// An arm at rest at `joints`; without ground there is neither sand nor box.
    ///
    /// # Errors
    /// [`PlantError::Kinematics`] for a posture outside the limits, [`PlantError::Bodies`] for links that cannot be
    /// put together, [`PlantError::GravityDiffers`] for a soil on another planet than the arm's.
    pub fn new(
        params: PlantParams,
        ground: Option<Ground>,
        joints: &JointAngles,
        seed: u64,
    ) -> Result<Self, PlantError> {
        let (arm, config) = (params.arm(), params.config());
        arm.check_limits(joints)?;
        if let Some(ground) = &ground {
            let (soil_m_s2, arm_m_s2) = (ground.soil().gravity_m_s2(), arm.config().gravity_m_s2);
            if (soil_m_s2 - arm_m_s2).abs() > 1e-9 {
                return Err(PlantError::GravityDiffers { soil_m_s2, arm_m_s2 });
            }
        }
        let sandbox = ground.as_ref().map(|_| &config.sandbox);
        let bodies = Bodies::new(arm, &config.bodies, sandbox, params.substep_s(), joints)?;
        let drives = Drives::new(arm, &config.drives, joints)?;
        let shape = arm.config();
        let sensor = ForceSensor::new(&config.force_sensor, shape.sensor.before_tip_m, shape.plate.height_m);
        let mut plant = Self {
            bodies,
            drives,
            sensor,
            ground,
            effects: Box::new(crate::effects::None),
            noise: Noise::new(seed),
            loads: Vec::with_capacity(16),
            tick: 0,
            truth: Truth::default(),
            params,
        };
        plant.observe()?;
        Ok(plant)
    }

    /// From now on these effects change the soil and the readings.
    pub fn set_effects(&mut self, effects: Box<dyn Effects>) {
        self.effects = effects;
    }

    /// What no sensor tells, as of the last tick.
    #[must_use]
    pub const fn truth(&self) -> &Truth {
        &self.truth
    }

    /// The parameters.
    #[must_use]
    pub const fn params(&self) -> &PlantParams {
        &self.params
    }

    /// The ground, if there is any.
    #[must_use]
    pub const fn ground(&self) -> Option<&Ground> {
        self.ground.as_ref()
    }

    /// The ground, to prepare it anew.
    #[must_use]
    pub const fn ground_mut(&mut self) -> Option<&mut Ground> {
        self.ground.as_mut()
    }

    /// Energy of links, rotors and stretch in J; potential energy is zero at the height of the table.
    ///
    /// # Errors
    /// [`PlantError::Kinematics`] if the arm is lost.
    pub fn energy_j(&self) -> Result<f64, PlantError> {
        let joints = self.bodies.joints();
        let weight = self.params.arm().potential_energy_j(&JointAngles(joints))?;
        Ok(weight + self.bodies.kinetic_energy_j() + self.drives.energy_j(&joints))
    }

    fn substep(&mut self, torques_nm: &[f64; 5], dt_s: f64) {
        let (joints, rates) = (self.bodies.joints(), self.bodies.rates());
        let joint_torques = self.drives.step(torques_nm, &joints, &rates, dt_s);
        let hand = self.bodies.hand();
        let tip = self.tip(&hand);
        self.loads.clear();
        if let Some(ground) = &mut self.ground {
            let velocity = self.bodies.hand_velocity(tip);
            self.loads.push(ground.press(&hand, tip, velocity, dt_s));
        }
        self.bodies.step(&joint_torques, &self.loads);
        self.loads.extend(self.bodies.wall_forces());
        let config = self.params.arm().config();
        let mut frame = hand;
        frame.origin_m = hand.point_m([0.0, 0.0, config.links.hand_m - config.sensor.before_tip_m]);
        frame.rotation = hand.rotation.map(|[x, y, z]| [z, y, -x]);
        self.sensor.add(&frame, config.gravity_m_s2, &self.loads);
    }

    fn tip(&self, hand: &Frame) -> [f64; 3] {
        hand.point_m([0.0, 0.0, self.params.arm().config().links.hand_m])
    }

    /// Notes the truth of this tick.
    fn observe(&mut self) -> Result<(), PlantError> {
        let joints = self.bodies.joints();
        let diverged = |quantity| PlantError::Diverged { tick: self.tick, quantity };
        if !joints.iter().chain(&self.bodies.rates()).all(|value| value.is_finite()) {
            return Err(diverged("a joint"));
        }
        if !self.drives.angle_rad.iter().all(|value| value.is_finite()) {
            return Err(diverged("a rotor"));
        }
        let hand = self.bodies.hand();
        let tip = self.tip(&hand);
        if let Some(ground) = &mut self.ground {
            ground.survey(&hand, tip, self.tick, self.effects.as_mut());
        }
        self.truth = Truth {
            joints: JointAngles(joints),
            joint_rates: JointVelocities(self.bodies.rates()),
            tip_m: tip,
            wrench: self.sensor.load,
            soil: self.ground.as_ref().map(Ground::truth).unwrap_or_default(),
        };
        Ok(())
    }
}

impl Hardware for Plant {
    type Error = PlantError;

    fn exchange(&mut self, drive: &Drive) -> Result<Sensed, PlantError> {
        let torques = if drive.amplifiers_enabled { drive.motor_torques.0 } else { [0.0; 5] };
        let dt_s = self.params.substep_s();
        for _ in 0..self.params.config().bodies.substeps {
            self.substep(&torques, dt_s);
        }
        self.tick += 1;
        self.observe()?;
        let config = self.params.config();
        let joints = self.bodies.joints();
        #[allow(clippy::cast_possible_truncation, reason = "a sequence number wraps")]
        let sequence = self.tick as u32;
        let reading = self.sensor.read(&mut self.noise);
        let (amplifier_current_a, amplifier_voltage_v) =
            sensors::amplifiers(&config.amplifiers, &torques, &mut self.noise);
        let mut sensed = Sensed {
            tick: self.tick,
            motor_counts: sensors::motor_counts(&config.encoders, &self.drives),
            motor_sequence: sequence,
            external_counts: sensors::external_counts(&config.encoders, &self.drives, &joints),
            external_sequence: sequence,
            wrench: reading.wrench,
            wrench_sequence: sequence,
            wrench_overload: reading.overload,
            amplifier_current_a,
            amplifier_voltage_v,
            amplifier_sequence: sequence,
        };
        self.effects.sensed(&mut sensed);
        Ok(sensed)
    }
}
