#![allow(clippy::unwrap_used, reason = "helpers of tests")]
