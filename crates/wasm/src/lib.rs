//! The workbench's solver and checker as a module for browsers, where it runs in workers: messages in, messages out, as over the
//! connection of `soilctl workbench`. For other targets this crate is empty.
#![cfg(target_family = "wasm")]

use std::cell::RefCell;

use soilctl_workbench::Desk;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    /// The worker's own function, which hands a message to the page.
    #[wasm_bindgen(js_name = postMessage)]
    fn post(message: &str);
}

fn tell(message: String) {
    post(&message);
}

thread_local! {
    static DESK: RefCell<Desk> = RefCell::new(Desk::open(tell));
}

/// Greets the page.
#[wasm_bindgen]
pub fn open() {
    DESK.with_borrow(|_| ());
}

/// Does what a message asks for.
#[wasm_bindgen]
pub fn obey(message: &str) {
    DESK.with_borrow_mut(|desk| desk.obey(message));
}
