#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::time::Instant;

use crate::examples::{rankine_field, wall};
use crate::prove_lower;

/// `cargo test --release -p soilctl-certificate -- --ignored --nocapture`
#[test]
#[ignore = "measures time"]
fn five_thousand_triangles() {
    let field = rankine_field(70, 3.0 * (1.0 - 1e-9));
    let start = Instant::now();
    let bound = prove_lower(&wall(), &field).unwrap();
    println!("{} triangles: {bound} in {:?}", field.mesh.triangles.len(), start.elapsed());
}
