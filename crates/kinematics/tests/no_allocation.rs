//! The functions of the control loop use no heap.
// An allocator that counts cannot be written without it; this is the only place.
#![allow(unsafe_code)]

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::hint::black_box;

use soilctl_kinematics::{
    Arm, Compliance, CylindricalStiffness, JointAngles, JointTorques, JointVelocities, TaskPose,
    TaskVelocity, Wrist,
};

struct Counting;

thread_local! {
    static COUNT: Cell<u64> = const { Cell::new(0) };
}

unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn one_tick_of_everything_and_its_errors() {
    let arm = Arm::thesis();
    let springs = CylindricalStiffness::diagonal([1000.0, 500.0, 2000.0, 1.0, 1.0]);
    let elbow = Compliance::of_elbow(260.0).unwrap();
    // Good, out of reach, out of limits, singular, not a number.
    let poses = [(0.43, -0.33), (3.0, 0.0), (-0.4, -0.33), (0.0, 0.0), (f64::NAN, 0.0)];
    let before = COUNT.with(Cell::get);
    for (x_m, z_m) in poses {
        let pose = TaskPose { x_m, y_m: 0.02, z_m, n1_rad: 3.2, n2_rad: 0.01 };
        let _ = black_box(arm.inverse(black_box(&pose)));
        let joints = arm.inverse(&pose).unwrap_or(JointAngles([x_m; 5]));
        let _ = black_box(arm.forward(&joints));
        let _ = black_box(arm.frames(&joints));
        let _ = black_box(arm.gravity_torques(&joints));
        let _ = black_box(arm.inverse_velocity(&joints, &TaskVelocity([0.01, 0.0, x_m, 0.0, 0.0])));
        let _ = black_box(arm.tip_force(&joints, &JointTorques([1.0, 2.0, 3.0, 0.0, x_m])));
        let _ = black_box(arm.compensate_flexion(&joints, [1.0, 2.0, x_m], &elbow));
        let _ = black_box(arm.transmission().motor_angles(&joints));
        let _ = black_box(arm.transmission().motor_velocities(&JointVelocities([x_m; 5])));
        let _ = black_box(arm.transmission().motor_torques(&JointTorques([x_m; 5])));
        if let (Ok(jacobian), Ok(k)) = (arm.jacobian(&joints), springs.to_cartesian(joints.0[0])) {
            let _ = black_box(k.joint_torques(&jacobian, &TaskVelocity([0.001; 5]), Wrist::Locked));
        }
    }
    assert_eq!(COUNT.with(Cell::get), before);
    let list = black_box(vec![1.0]);
    assert!(COUNT.with(Cell::get) > before, "{list:?}");
}
