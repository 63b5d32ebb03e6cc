//! A step uses no heap, whatever it does.
// An allocator that counts cannot be written without it; this is the only place.
#![allow(unsafe_code, clippy::unwrap_used)]

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::hint::black_box;

use common::{Rig, Soil};
use soilctl_controller::{Params, Request, SequenceId, StrokePlan, step};
use soilctl_kinematics::{Arm, TaskPose};

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

/// 100 000 steps of the campaign of table 6.2, with a fault and its reset in between.
#[test]
fn a_hundred_thousand_steps() {
    let plan =
        StrokePlan::from_toml(include_str!("../../../data/controller/table_6_2.toml"), "plan").unwrap();
    let params = Params::from_toml(Arm::thesis(), soilctl_controller::DEFAULT, "default", plan).unwrap();
    let pose = TaskPose::digging(0.4, 0.0, -0.2, 1.4).unwrap();
    let start = params.arm().inverse(&pose).unwrap();
    let mut rig = Rig::homed(params, start);
    rig.plant.soil = Some(Soil::new());
    let mut spent = 0;
    for n in 0..100_000 {
        let (mut sensed, mut commands) = (rig.plant.sense(), rig.commands());
        commands.request = match n {
            0 | 50_003 => Some(Request::Start(SequenceId::Campaign)),
            50_001 => Some(Request::Reset),
            50_002 => Some(Request::Enable),
            _ => rig.state.machine.waits().then_some(Request::Continue),
        };
        if n == 50_000 {
            sensed.wrench[0] = f64::NAN;
        }
        let before = COUNT.with(Cell::get);
        let outputs = step(&rig.params, &mut rig.state, &sensed, &commands);
        spent += COUNT.with(Cell::get) - before;
        rig.plant.act(&outputs);
    }
    assert_eq!(spent, 0);
    assert!(rig.state.machine.index >= 2, "{:?} {:?}", rig.state.machine, rig.state.fault);
    let before = COUNT.with(Cell::get);
    let list = black_box(vec![1.0]);
    assert!(COUNT.with(Cell::get) > before, "{list:?}");
}
