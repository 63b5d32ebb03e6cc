//! The rigid bodies: five links, joint stops, the plate and the box of sand. The only file that names Rapier.
//!
//! The links form one multibody in reduced coordinates, so that joints cannot drift apart. One call of `step` is one
//! semi-implicit Euler step; the substep is chosen by `tests/substeps.rs`.

use rapier3d_f64::prelude::*;
use soilctl_kinematics::{Arm, Frame, JointAngles};

use crate::PlantError;
use crate::config::{BodiesConfig, BoxConfig};

/// A force on the hand at a point, both in base coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct PointForce {
    /// N.
    pub(crate) force_n: [f64; 3],
    /// m.
    pub(crate) point_m: [f64; 3],
}

/// Way in rad from a stop within which Rapier is told of it: more than a joint turns in a substep.
const NEAR_A_STOP_RAD: f64 = 0.2;

/// The bodies and their state.
pub(crate) struct Bodies {
    world: PhysicsWorld,
    links: [RigidBodyHandle; 5],
    multibody: MultibodyIndex,
    plate: ColliderHandle,
    /// Stops of the joints in rad.
    stops_rad: [[f64; 2]; 5],
    dt_s: f64,
}

impl Bodies {
    /// The arm at rest at `joints`, in the box if there is one.
    pub(crate) fn new(
        arm: &Arm,
        config: &BodiesConfig,
        sandbox: Option<&BoxConfig>,
        dt_s: f64,
        joints: &JointAngles,
    ) -> Result<Self, PlantError> {
        let mut world = PhysicsWorld::new();
        world.gravity = Vector::new(0.0, 0.0, -arm.config().gravity_m_s2);
        world.integration_parameters.dt = dt_s;
        world.integration_parameters.num_solver_iterations = config.solver_iterations;
        // One manifold a pair, computed afresh: its impulses are the wall's force on the plate.
        world.integration_parameters.contact_clustering = false;
        world.integration_parameters.contact_recycling = false;
        world.integration_parameters.max_ccd_substeps = 0;
        let bad = || PlantError::Bodies { problem: "the links do not form a chain" };

        let mut parent = world.insert_body(RigidBodyBuilder::fixed());
        let (lengths, bodies) = (&arm.config().links, arm.link_bodies());
        let offsets = [0.0, lengths.base_height_m, lengths.upper_arm_m, lengths.forearm_m, lengths.twist_m];
        let axes = [Vector::Z, Vector::Y, Vector::Y, Vector::Z, Vector::Y];
        let mut links = [parent; 5];
        let mut index = None;
        for i in 0..5 {
            let body = &bodies[i];
            let inertia = Vector::new(body.across_kg_m2, body.across_kg_m2, body.along_kg_m2);
            let mass = MassProperties::new(Vector::new(0.0, 0.0, body.centre_m), body.mass_kg, inertia);
            let link = world
                .insert_body(RigidBodyBuilder::dynamic().additional_mass_properties(mass).can_sleep(false));
            let joint = RevoluteJointBuilder::new(axes[i])
                .local_anchor1(Vector::new(0.0, 0.0, offsets[i]))
                .limits([arm.lower_limits().0[i], arm.upper_limits().0[i]])
                .contacts_enabled(false);
            let handle = world.insert_multibody_joint(parent, link, joint).ok_or_else(bad)?;
            index = world.multibody_joints.rigid_body_link(link).map(|link| link.multibody);
            let _ = handle;
            links[i] = link;
            parent = link;
        }
        let multibody = index.ok_or_else(bad)?;
        let shape = &arm.config().plate;
        let plate =
            ColliderBuilder::cuboid(0.5 * shape.thickness_m, 0.5 * shape.width_m, 0.5 * shape.height_m)
                .translation(Vector::new(0.0, 0.0, lengths.hand_m - 0.5 * shape.height_m))
                .density(0.0)
                .friction(config.wall_friction);
        let plate = world.insert_collider(plate, Some(links[4]));
        if let Some(sandbox) = sandbox {
            insert_box(&mut world, sandbox, config.wall_friction);
        }

        let stops_rad = std::array::from_fn(|i| [arm.lower_limits().0[i], arm.upper_limits().0[i]]);
        let mut bodies = Self { world, links, multibody, plate, stops_rad, dt_s };
        // Rapier knows which links hang together, and their coordinates, after a first pass without time.
        bodies.world.integration_parameters.dt = 0.0;
        bodies.world.step();
        bodies.world.integration_parameters.dt = dt_s;
        let mb = bodies.world.multibody_joints.get_multibody_mut(multibody).ok_or_else(bad)?;
        if mb.ndofs() != 5 {
            return Err(bad());
        }
        mb.damping_mut().as_mut_slice().copy_from_slice(&config.joint_damping_nms_per_rad);
        mb.armature_mut().as_mut_slice().copy_from_slice(&config.joint_armature_kg_m2);
        bodies.place(joints)?;
        Ok(bodies)
    }

    /// Moves the arm to these joints, at rest.
    fn place(&mut self, joints: &JointAngles) -> Result<(), PlantError> {
        let now = self.joints();
        let world = &mut self.world;
        let bad = PlantError::Bodies { problem: "the chain is gone" };
        let mb = world.multibody_joints.get_multibody_mut(self.multibody).ok_or(bad)?;
        let way: [f64; 5] = std::array::from_fn(|i| joints.0[i] - now[i]);
        mb.apply_displacements(&way);
        mb.generalized_velocity_mut().fill(0.0);
        mb.forward_kinematics(&world.bodies, false);
        mb.update_rigid_bodies(&mut world.bodies, true);
        Ok(())
    }

    /// Joint angles in rad.
    pub(crate) fn joints(&self) -> [f64; 5] {
        let mut angles = [0.0; 5];
        if let Some(mb) = self.world.multibody_joints.get_multibody(self.multibody) {
            for (angle, link) in angles.iter_mut().zip(mb.links().skip(1)) {
                *angle = link.joint().coords()[3];
            }
        }
        angles
    }

    /// Joint speeds in rad/s.
    pub(crate) fn rates(&self) -> [f64; 5] {
        let mut rates = [0.0; 5];
        if let Some(mb) = self.world.multibody_joints.get_multibody(self.multibody) {
            for (rate, value) in rates.iter_mut().zip(mb.generalized_velocity().iter()) {
                *rate = *value;
            }
        }
        rates
    }

    /// One step of `dt_s` under joint torques in N m and forces on the hand.
    pub(crate) fn step(&mut self, torques_nm: &[f64; 5], loads: &[PointForce]) {
        let axes: [Vector; 5] = std::array::from_fn(|i| {
            let rotation = self.world.bodies[self.links[i]].position().rotation;
            rotation * if i == 0 || i == 3 { Vector::Z } else { Vector::Y }
        });
        for i in 0..5 {
            let mut torque = axes[i] * torques_nm[i];
            if i < 4 {
                torque -= axes[i + 1] * torques_nm[i + 1];
            }
            let body = &mut self.world.bodies[self.links[i]];
            body.reset_torques(false);
            body.reset_forces(false);
            body.add_torque(torque, false);
        }
        let hand = &mut self.world.bodies[self.links[4]];
        for load in loads {
            hand.add_force_at_point(load.force_n.into(), load.point_m.into(), false);
        }
        self.look_for_stops();
        self.world.step();
    }

    /// Away from the stops Rapier need not know of them: a constraint that does nothing takes time in every step, and leaves the same bits.
    fn look_for_stops(&mut self) {
        if let Some(mb) = self.world.multibody_joints.get_multibody_mut(self.multibody) {
            for ([low, high], link) in self.stops_rad.iter().zip(mb.links_mut().skip(1)) {
                let angle = link.joint.coords()[3];
                let free = angle > low + NEAR_A_STOP_RAD && angle < high - NEAR_A_STOP_RAD;
                link.joint.data.limit_axes.set(JointAxesMask::ANG_X, !free);
            }
        }
    }

    /// Frame of the hand: origin at the wrist, z along the hand.
    pub(crate) fn hand(&self) -> Frame {
        let pose = self.world.bodies[self.links[4]].position();
        let axes = [Vector::X, Vector::Y, Vector::Z].map(|axis| pose.rotation * axis);
        Frame {
            rotation: std::array::from_fn(|row| std::array::from_fn(|column| axes[column][row])),
            origin_m: pose.translation.into(),
        }
    }

    /// Velocity in m/s of a point of the hand, both in base coordinates.
    pub(crate) fn hand_velocity(&self, point_m: [f64; 3]) -> [f64; 3] {
        self.world.bodies[self.links[4]].velocity_at_point(point_m.into()).into()
    }

    /// What the box pressed on the plate in the last step.
    pub(crate) fn wall_forces(&self) -> impl Iterator<Item = PointForce> + '_ {
        self.world
            .narrow_phase
            .contact_pairs_with(self.plate)
            .filter_map(|pair| match &pair.contacts {
                PairContacts::Rigid(rigid) => Some((pair.collider1 == self.plate, rigid)),
                PairContacts::Soft { .. } => None,
            })
            .flat_map(move |(plate_first, rigid)| {
                rigid.manifolds.iter().flat_map(move |manifold| {
                    let normal = manifold.data.normal;
                    let pose = self.world.colliders[self.plate].position();
                    manifold.points.iter().filter(|point| point.data.impulse != 0.0).map(move |point| {
                        let (local, sign) =
                            if plate_first { (point.local_p1, -1.0) } else { (point.local_p2, 1.0) };
                        PointForce {
                            force_n: (normal * (sign * point.data.impulse / self.dt_s)).into(),
                            point_m: (*pose * local).into(),
                        }
                    })
                })
            })
    }

    /// Kinetic energy of the links in J, without rotors.
    pub(crate) fn kinetic_energy_j(&self) -> f64 {
        self.links.iter().map(|&link| self.world.bodies[link].kinetic_energy()).sum()
    }
}

/// Five slabs: floor and walls.
fn insert_box(world: &mut PhysicsWorld, sandbox: &BoxConfig, friction: f64) {
    const HALF_M: f64 = 0.01;
    let [x_low, x_high] = sandbox.x_m;
    let [y_low, y_high] = sandbox.y_m;
    let (floor, top) = (sandbox.floor_z_m, sandbox.top_z_m);
    let (x, y, z) = (0.5 * (x_low + x_high), 0.5 * (y_low + y_high), 0.5 * (floor + top));
    let half = [0.5 * (x_high - x_low), 0.5 * (y_high - y_low), 0.5 * (top - floor)];
    let slabs = [
        ([x_high + HALF_M, y, z], [HALF_M, half[1], half[2]]),
        ([x_low - HALF_M, y, z], [HALF_M, half[1], half[2]]),
        ([x, y_high + HALF_M, z], [half[0], HALF_M, half[2]]),
        ([x, y_low - HALF_M, z], [half[0], HALF_M, half[2]]),
        ([x, y, floor - HALF_M], [half[0], half[1], HALF_M]),
    ];
    for (centre, [a, b, c]) in slabs {
        let slab = ColliderBuilder::cuboid(a, b, c).translation(centre.into()).friction(friction);
        world.insert_collider(slab, None);
    }
}
