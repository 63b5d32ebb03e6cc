//! In real time the control thread allocates nothing for its log.
#![allow(unsafe_code, reason = "a counting allocator")]
#![allow(clippy::unwrap_used)]

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use common::{Digger, setup};
use soilctl_session::{Logger, Pace, StepRecord};

thread_local! {
    static COUNTED: Cell<bool> = const { Cell::new(false) };
    static ALLOCATIONS: Cell<u64> = const { Cell::new(0) };
}

/// Counts the allocations of threads that ask for it.
struct Counter;

fn count() {
    if COUNTED.get() {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
    }
}

// SAFETY: everything is handed on to the system's allocator as it came.
unsafe impl GlobalAlloc for Counter {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count();
        // SAFETY: as above.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        count();
        // SAFETY: as above.
        unsafe { System.dealloc(pointer, layout) }
    }

    unsafe fn realloc(&self, pointer: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count();
        // SAFETY: as above.
        unsafe { System.realloc(pointer, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counter = Counter;

#[test]
fn recording_allocates_nothing() {
    let setup = setup(1);
    let mut digger = Digger::new(&setup);
    let (logger, mut recorder) = Logger::start(std::io::sink(), &setup, Pace::RealTime).unwrap();
    // More than the ring holds, so that a full ring is part of it.
    for _ in 0..20_000 {
        let state = digger.rig.state;
        let StepRecord { sensed, commands, outputs, truth, .. } = digger.step(|_| {});
        COUNTED.set(true);
        recorder.before(&state);
        recorder.after(&sensed, &commands, &outputs, &state, truth);
        COUNTED.set(false);
    }
    assert_eq!(ALLOCATIONS.get(), 0);
    let counted = COUNTED.replace(true);
    drop(std::hint::black_box(Box::new(7)));
    COUNTED.set(counted);
    assert_eq!(ALLOCATIONS.get(), 2, "the counter counts");
    drop(recorder);
    logger.finish().unwrap();
}
