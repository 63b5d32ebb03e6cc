//! A pose uses no heap, whether it is found or not.
// An allocator that counts cannot be written without it.
#![allow(unsafe_code, clippy::unwrap_used)]

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::hint::black_box;

use soilctl_robot::Urdf;

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
fn poses_use_no_heap() {
    let chain = Urdf::parse(&common::row(8, "revolute")).unwrap().chain("l7").unwrap();
    let before = COUNT.with(Cell::get);
    for angle in [0.0, 0.3, f64::NAN] {
        black_box(chain.pose(black_box(&[angle; 7])));
        black_box(chain.pose(black_box(&[angle; 6])));
    }
    assert_eq!(COUNT.with(Cell::get), before);
    let list = black_box(vec![1.0]);
    assert!(COUNT.with(Cell::get) > before, "{list:?}");
}
