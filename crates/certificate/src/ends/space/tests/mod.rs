#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod altered;
mod balanced;
mod exact;
mod known;
mod linear;
mod shown;
mod small;

use small::Small;
