//! Running the program.
#![allow(dead_code, reason = "no test file uses all of it")]
#![allow(clippy::expect_used, reason = "helpers of tests")]

pub(crate) mod shear;

use std::process::{Command, Output};

use serde_json::Value;

pub(crate) fn soilctl(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_soilctl")).args(args).output().expect("it runs")
}

/// Runs with `--format json`; stdout must be exactly one document and stderr empty.
pub(crate) fn json(args: &[&str]) -> (i32, Value) {
    let done = soilctl(&[args, &["--format", "json"]].concat());
    let stderr = String::from_utf8_lossy(&done.stderr);
    assert!(stderr.is_empty(), "{args:?} wrote to stderr: {stderr}");
    let answer = serde_json::from_slice(&done.stdout).expect("stdout is one JSON document");
    (done.status.code().expect("no signal"), answer)
}

/// Runs quietly, whatever the exit code: the one document on stdout.
pub(crate) fn quiet_json(args: &[&str]) -> Value {
    let words = [args, &["--quiet", "--format", "json"]].concat();
    let done = soilctl(&words);
    serde_json::from_slice(&done.stdout)
        .unwrap_or_else(|problem| panic!("{words:?}: {problem}: {}", String::from_utf8_lossy(&done.stderr)))
}

/// Runs what must be refused with exit code 2: the message.
pub(crate) fn refused(args: &[&str]) -> String {
    let done = soilctl(args);
    assert_eq!(done.status.code(), Some(2), "{args:?}");
    assert!(done.stdout.is_empty(), "{args:?} wrote an answer");
    String::from_utf8(done.stderr).expect("UTF-8")
}
