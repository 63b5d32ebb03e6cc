//! The project's chores, run as `cargo xtask <task>`.
//!
//! `test` is the one test command: it needs nothing but Rust and a Debian-like system and sets up the rest
//! itself. Exit codes: 0 done, 1 a step failed (its name is in the message), 2 wrong usage.

mod apt;
mod browser;
mod chromium;
mod dist;
mod error;
mod fuzz;
mod python;
mod run;
mod rust;
mod rust_tests;
mod supply;
mod systems;
mod tasks;
mod verify;
mod wheel;
mod workspace;

use std::process::ExitCode;

use crate::tasks::Task;
use crate::workspace::Workspace;

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args_os().skip(1).map(|a| a.to_string_lossy().into_owned()).collect();
    let task = match words.as_slice() {
        [word] if matches!(word.as_str(), "help" | "-h" | "--help") => {
            eprintln!("{}", tasks::usage());
            return ExitCode::SUCCESS;
        }
        [] => Err("a task is missing".to_owned()),
        [word, further @ ..] => Task::from_words(word, further),
    };
    let task = match task {
        Ok(task) => task,
        Err(problem) => {
            eprintln!("xtask: {problem}\n\n{}", tasks::usage());
            return ExitCode::from(2);
        }
    };
    match Workspace::find().and_then(|workspace| task.run(&workspace)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("\nxtask {}: {problem}", words[0]);
            ExitCode::FAILURE
        }
    }
}
