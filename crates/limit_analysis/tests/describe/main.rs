//! Problem descriptions: what becomes of them, judged by the checker's own rules, and what is refused.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod cases;
mod common;
mod ends;
mod files;
mod geometry;
mod random;
mod refusals;
mod seepage;
mod strength;
mod water;
mod weights;
