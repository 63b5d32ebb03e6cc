//! From motor to joint: rotor, dry friction, free play, and the stretch of gears and cables.

use soilctl_kinematics::{Arm, JointAngles, KinematicsError};

use crate::config::DrivesConfig;

/// The rotors, in motor coordinates, and what their gears carry.
///
/// Behind the free play there is no inertia but the links', so that the gears' output is where stretch and links put it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Drives {
    config: DrivesConfig,
    half_play_rad: [f64; 5],
    to_motor: [[f64; 5]; 5],
    home: [f64; 5],
    /// Angles of the rotors in rad.
    pub(crate) angle_rad: [f64; 5],
    /// Their speeds in rad/s.
    pub(crate) rate_rad_s: [f64; 5],
    /// Torques that the gears carry in N m.
    pub(crate) load_nm: [f64; 5],
}

impl Drives {
    /// Rotors at rest in the middle of their free play.
    pub(crate) fn new(
        arm: &Arm,
        config: &DrivesConfig,
        joints: &JointAngles,
    ) -> Result<Self, KinematicsError> {
        let transmission = arm.transmission();
        Ok(Self {
            config: *config,
            half_play_rad: config.free_play_deg.map(|play| 0.5 * play.to_radians()),
            to_motor: transmission.joint_to_motor(),
            home: transmission.home().0,
            angle_rad: transmission.motor_angles(joints)?.0,
            rate_rad_s: [0.0; 5],
            load_nm: [0.0; 5],
        })
    }

    /// One step: the rotors move, and the joints feel the torques that are returned (N m).
    pub(crate) fn step(
        &mut self,
        motor_torques_nm: &[f64; 5],
        joints: &[f64; 5],
        rates: &[f64; 5],
        dt_s: f64,
    ) -> [f64; 5] {
        let links = self.in_motor_coordinates(&std::array::from_fn(|i| joints[i] - self.home[i]));
        let link_rates = self.in_motor_coordinates(rates);
        for i in 0..5 {
            self.load_nm[i] =
                self.gear_torque_nm(i, self.angle_rad[i] - links[i], self.rate_rad_s[i] - link_rates[i]);
            self.turn(i, motor_torques_nm[i], dt_s);
        }
        std::array::from_fn(|joint| {
            (0..5).map(|motor| self.to_motor[motor][joint] * self.load_nm[motor]).sum()
        })
    }

    /// Angles of the gears' outputs: behind the free play, before the stretch.
    pub(crate) fn outputs_rad(&self, joints: &[f64; 5]) -> [f64; 5] {
        let links = self.links_rad(joints);
        std::array::from_fn(|i| links[i] + self.load_nm[i] / self.config.stiffness_nm_per_rad[i])
    }

    /// Angles of the links in motor coordinates.
    pub(crate) fn links_rad(&self, joints: &[f64; 5]) -> [f64; 5] {
        self.in_motor_coordinates(&std::array::from_fn(|i| joints[i] - self.home[i]))
    }

    /// Kinetic energy of the rotors and energy of the stretch in J.
    pub(crate) fn energy_j(&self, joints: &[f64; 5]) -> f64 {
        let links = self.links_rad(joints);
        (0..5)
            .map(|i| {
                let stretch = self.stretch_rad(i, self.angle_rad[i] - links[i]);
                0.5 * self.config.rotor_inertia_kg_m2[i] * self.rate_rad_s[i] * self.rate_rad_s[i]
                    + 0.5 * self.config.stiffness_nm_per_rad[i] * stretch * stretch
            })
            .sum()
    }

    fn in_motor_coordinates(&self, joints: &[f64; 5]) -> [f64; 5] {
        self.to_motor.map(|row| row.iter().zip(joints).map(|(a, b)| a * b).sum())
    }

    /// What of a twist goes beyond the free play.
    fn stretch_rad(&self, i: usize, twist_rad: f64) -> f64 {
        let half = self.half_play_rad[i];
        if twist_rad > half {
            twist_rad - half
        } else if twist_rad < -half {
            twist_rad + half
        } else {
            0.0
        }
    }

    /// Teeth press but do not pull.
    fn gear_torque_nm(&self, i: usize, twist_rad: f64, twist_rate_rad_s: f64) -> f64 {
        let stretch = self.stretch_rad(i, twist_rad);
        let torque = self.config.stiffness_nm_per_rad[i] * stretch
            + self.config.damping_nms_per_rad[i] * twist_rate_rad_s;
        if stretch > 0.0 {
            torque.max(0.0)
        } else if stretch < 0.0 {
            torque.min(0.0)
        } else {
            0.0
        }
    }

    /// Dry friction at the rotor's speed over that at high speed.
    fn stribeck(&self, i: usize) -> f64 {
        let excess = self.config.breakaway - 1.0;
        if excess == 0.0 {
            return 1.0;
        }
        let speed = self.rate_rad_s[i] / self.config.stribeck_rad_s;
        1.0 + excess * libm::exp(-speed * speed)
    }

    /// Dry friction takes away what it can and no more, so that a rotor sticks.
    fn turn(&mut self, i: usize, torque_nm: f64, dt_s: f64) {
        let (config, load) = (&self.config, self.load_nm[i]);
        let per_torque = dt_s / config.rotor_inertia_kg_m2[i];
        let free = (self.rate_rad_s[i] + per_torque * (torque_nm - load))
            / (1.0 + per_torque * config.viscous_nms_per_rad[i]);
        let dry = config.friction_nm[i] * self.stribeck(i);
        let most = per_torque * (dry + config.load_friction[i] * load.abs());
        self.rate_rad_s[i] = if free > most {
            free - most
        } else if free < -most {
            free + most
        } else {
            0.0
        };
        self.angle_rad[i] += self.rate_rad_s[i] * dt_s;
    }
}
