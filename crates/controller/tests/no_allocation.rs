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
    /// From now on an allocation ends the program.
    static FORBIDDEN: Cell<bool> = const { Cell::new(false) };
}

unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        if FORBIDDEN.with(Cell::get) {
            std::process::abort();
        }
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
    let index = steps(100_000);
    assert!(index >= 2, "{index}");
    let before = COUNT.with(Cell::get);
    let list = black_box(vec![1.0]);
    assert!(COUNT.with(Cell::get) > before, "{list:?}");
}

/// The same for 10^6 steps.
#[test]
#[ignore = "minutes in debug; run with --release -- --ignored"]
fn a_million_steps() {
    let index = steps(1_000_000);
    assert!(index >= 20, "{index}");
}

/// Runs the campaign; an allocation in a step aborts. Says at which stroke it is in the end.
fn steps(ticks: u32) -> u16 {
    let plan = StrokePlan::from_toml(include_str!("../../../data/plans/table_6_2.toml"), "plan").unwrap();
    let params = Params::from_toml(Arm::thesis(), soilctl_controller::DEFAULT, "default", plan).unwrap();
    let pose = TaskPose::digging(0.4, 0.0, -0.2, 1.4).unwrap();
    let start = params.arm().inverse(&pose).unwrap();
    let mut rig = Rig::homed(params, start);
    rig.plant.soil = Some(Soil::new());
    for n in 0..ticks {
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
        FORBIDDEN.with(|forbidden| forbidden.set(true));
        let outputs = step(&rig.params, &mut rig.state, &sensed, &commands);
        FORBIDDEN.with(|forbidden| forbidden.set(false));
        rig.plant.act(&outputs);
    }
    rig.state.machine.index
}
