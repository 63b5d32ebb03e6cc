//! An arm of its own for comparison: recursive Newton-Euler dynamics of the five links, rotors and gears, written
//! without Rapier and without the plant's code.
#![allow(dead_code, unreachable_pub, clippy::unwrap_used)]

use soilctl_kinematics::{Arm, JointAngles, LinkBody};
use soilctl_plant::PlantParams;
use soilctl_plant::config::PlantConfig;

type V = [f64; 3];

fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn add(a: V, b: V) -> V {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn scale(a: V, s: f64) -> V {
    a.map(|x| x * s)
}

fn dot(a: V, b: V) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Turns a vector of a link into its parent's frame; joints 0 and 3 turn about z, the others about y.
fn to_parent(joint: usize, angle: f64, [x, y, z]: V) -> V {
    let (s, c) = angle.sin_cos();
    if joint == 0 || joint == 3 {
        [c * x - s * y, s * x + c * y, z]
    } else {
        [c * x + s * z, y, c * z - s * x]
    }
}

fn to_child(joint: usize, angle: f64, v: V) -> V {
    to_parent(joint, -angle, v)
}

#[derive(Clone)]
pub struct Reference {
    config: PlantConfig,
    bodies: [LinkBody; 5],
    offsets: [f64; 5],
    gravity: f64,
    home: [f64; 5],
    to_motor: [[f64; 5]; 5],
    pub q: [f64; 5],
    pub v: [f64; 5],
    pub rotor: [f64; 5],
    pub rotor_v: [f64; 5],
}

/// Rates of (q, v, rotor, rotor_v).
type Rates = [[f64; 5]; 4];

impl Reference {
    pub fn new(params: &PlantParams, joints: JointAngles) -> Self {
        let arm: &Arm = params.arm();
        let lengths = arm.config().links;
        Self {
            config: params.config().clone(),
            bodies: arm.link_bodies(),
            offsets: [0.0, lengths.base_height_m, lengths.upper_arm_m, lengths.forearm_m, lengths.twist_m],
            gravity: arm.config().gravity_m_s2,
            home: arm.transmission().home().0,
            to_motor: arm.transmission().joint_to_motor(),
            q: joints.0,
            v: [0.0; 5],
            rotor: arm.transmission().motor_angles(&joints).unwrap().0,
            rotor_v: [0.0; 5],
        }
    }

    /// Joint torques for a motion (Luh, Walker and Paul 1980); gravity is an acceleration of the base upwards.
    fn inverse_dynamics(&self, q: &[f64; 5], v: &[f64; 5], a: &[f64; 5], gravity: f64) -> [f64; 5] {
        let axis = |i: usize| if i == 0 || i == 3 { [0.0, 0.0, 1.0] } else { [0.0, 1.0, 0.0] };
        let (mut omega, mut alpha, mut acc) = ([0.0; 3], [0.0; 3], [0.0, 0.0, gravity]);
        let (mut force, mut moment) = ([[0.0; 3]; 5], [[0.0; 3]; 5]);
        for i in 0..5 {
            let arm = [0.0, 0.0, self.offsets[i]];
            acc = add(acc, add(cross(alpha, arm), cross(omega, cross(omega, arm))));
            (omega, alpha, acc) =
                (to_child(i, q[i], omega), to_child(i, q[i], alpha), to_child(i, q[i], acc));
            let rate = scale(axis(i), v[i]);
            alpha = add(alpha, add(scale(axis(i), a[i]), cross(omega, rate)));
            omega = add(omega, rate);
            let body = &self.bodies[i];
            let centre = [0.0, 0.0, body.centre_m];
            let acc_centre = add(acc, add(cross(alpha, centre), cross(omega, cross(omega, centre))));
            let inertia =
                |w: V| [body.across_kg_m2 * w[0], body.across_kg_m2 * w[1], body.along_kg_m2 * w[2]];
            force[i] = scale(acc_centre, body.mass_kg);
            moment[i] = add(add(inertia(alpha), cross(omega, inertia(omega))), cross(centre, force[i]));
        }
        let mut torques = [0.0; 5];
        for i in (0..5).rev() {
            torques[i] = dot(moment[i], axis(i)) + self.config.bodies.joint_armature_kg_m2[i] * a[i];
            if i > 0 {
                let (f, n) = (to_parent(i, q[i], force[i]), to_parent(i, q[i], moment[i]));
                let arm = [0.0, 0.0, self.offsets[i]];
                force[i - 1] = add(force[i - 1], f);
                moment[i - 1] = add(moment[i - 1], add(n, cross(arm, f)));
            }
        }
        torques
    }

    fn acceleration(&self, q: &[f64; 5], v: &[f64; 5], torques: &[f64; 5]) -> [f64; 5] {
        let bias = self.inverse_dynamics(q, v, &[0.0; 5], self.gravity);
        let mut m = [[0.0; 6]; 5];
        for k in 0..5 {
            let mut unit = [0.0; 5];
            unit[k] = 1.0;
            let column = self.inverse_dynamics(q, &[0.0; 5], &unit, 0.0);
            for i in 0..5 {
                m[i][k] = column[i];
            }
            m[k][5] = torques[k] - bias[k];
        }
        // Gauss-Jordan; the mass matrix is positive definite.
        for i in 0..5 {
            let pivot = m[i][i];
            for entry in &mut m[i] {
                *entry /= pivot;
            }
            for k in 0..5 {
                if k != i {
                    let factor = m[k][i];
                    let row = m[i];
                    for (entry, other) in m[k].iter_mut().zip(row) {
                        *entry -= factor * other;
                    }
                }
            }
        }
        m.map(|row| row[5])
    }

    fn motor(&self, joints: &[f64; 5]) -> [f64; 5] {
        self.to_motor.map(|row| (0..5).map(|i| row[i] * joints[i]).sum())
    }

    /// Torques of the gears, by motor.
    pub fn gears(&self, q: &[f64; 5], v: &[f64; 5], rotor: &[f64; 5], rotor_v: &[f64; 5]) -> [f64; 5] {
        let links = self.motor(&std::array::from_fn(|i| q[i] - self.home[i]));
        let link_rates = self.motor(v);
        let drives = &self.config.drives;
        std::array::from_fn(|i| {
            let half = 0.5 * drives.free_play_deg[i].to_radians();
            let twist = rotor[i] - links[i];
            let stretch = (twist.abs() - half).max(0.0) * twist.signum();
            if stretch == 0.0 {
                return 0.0;
            }
            let torque = drives.stiffness_nm_per_rad[i] * stretch
                + drives.damping_nms_per_rad[i] * (rotor_v[i] - link_rates[i]);
            if stretch * torque > 0.0 { torque } else { 0.0 }
        })
    }

    fn joint_torques(&self, gears: &[f64; 5], v: &[f64; 5]) -> [f64; 5] {
        std::array::from_fn(|joint| {
            (0..5).map(|i| self.to_motor[i][joint] * gears[i]).sum::<f64>()
                - self.config.bodies.joint_damping_nms_per_rad[joint] * v[joint]
        })
    }

    fn rates(&self, [q, v, rotor, rotor_v]: &Rates, motors: &[f64; 5]) -> Rates {
        let gears = self.gears(q, v, rotor, rotor_v);
        let drives = &self.config.drives;
        let rotor_a = std::array::from_fn(|i| {
            (motors[i] - gears[i] - drives.viscous_nms_per_rad[i] * rotor_v[i])
                / drives.rotor_inertia_kg_m2[i]
        });
        [*v, self.acceleration(q, v, &self.joint_torques(&gears, v)), *rotor_v, rotor_a]
    }

    /// One step of Runge and Kutta's fourth order; no dry friction.
    pub fn runge_kutta(&mut self, motors: &[f64; 5], h: f64) {
        let state = [self.q, self.v, self.rotor, self.rotor_v];
        let moved = |k: &Rates, h: f64| -> Rates {
            std::array::from_fn(|part| std::array::from_fn(|i| state[part][i] + h * k[part][i]))
        };
        let k1 = self.rates(&state, motors);
        let k2 = self.rates(&moved(&k1, 0.5 * h), motors);
        let k3 = self.rates(&moved(&k2, 0.5 * h), motors);
        let k4 = self.rates(&moved(&k3, h), motors);
        let next: Rates = std::array::from_fn(|part| {
            std::array::from_fn(|i| {
                let mean = (k1[part][i] + 2.0 * k2[part][i] + 2.0 * k3[part][i] + k4[part][i]) / 6.0;
                state[part][i] + h * mean
            })
        });
        [self.q, self.v, self.rotor, self.rotor_v] = next;
    }

    /// One small step with dry friction.
    pub fn small_step(&mut self, motors: &[f64; 5], h: f64) {
        let gears = self.gears(&self.q, &self.v, &self.rotor, &self.rotor_v);
        let a = self.acceleration(&self.q, &self.v, &self.joint_torques(&gears, &self.v));
        let drives = &self.config.drives;
        for i in 0..5 {
            let torque = motors[i] - gears[i] - drives.viscous_nms_per_rad[i] * self.rotor_v[i];
            let free = self.rotor_v[i] + h * torque / drives.rotor_inertia_kg_m2[i];
            let dry = drives.friction_nm[i] + drives.load_friction[i] * gears[i].abs();
            let most = h * dry / drives.rotor_inertia_kg_m2[i];
            self.rotor_v[i] = free.signum() * (free.abs() - most).max(0.0);
            self.rotor[i] += h * self.rotor_v[i];
            self.v[i] += h * a[i];
        }
        for i in 0..5 {
            self.q[i] += h * self.v[i];
        }
    }

    pub fn tip(&self, arm: &Arm) -> V {
        arm.forward(&JointAngles(self.q)).unwrap().position_m()
    }
}

pub fn distance(a: V, b: V) -> f64 {
    let d = add(a, scale(b, -1.0));
    dot(d, d).sqrt()
}
