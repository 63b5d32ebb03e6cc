//! The project's chores, run as `cargo xtask <task>`.
//!
//! `test` is the one test command: it needs nothing but Rust and a Debian-like system and sets up the rest
//! itself. Exit codes: 0 done, 1 a step failed (its name is in the message), 2 wrong usage.

mod apt;
mod chromium;
mod error;
mod python;
mod run;
mod tasks;
mod wheel;
mod workspace;

use std::process::ExitCode;

use crate::tasks::Task;
use crate::workspace::Workspace;

fn main() -> ExitCode {
    let arguments: Vec<String> =
        std::env::args_os().skip(1).map(|a| a.to_string_lossy().into_owned()).collect();
    let task = match arguments.as_slice() {
        [word] if matches!(word.as_str(), "help" | "-h" | "--help") => {
            eprintln!("{}", tasks::usage());
            return ExitCode::SUCCESS;
        }
        [word] => Task::from_word(word).ok_or_else(|| format!("there is no task {word:?}")),
        [] => Err("a task is missing".to_owned()),
        [_, rest @ ..] => Err(format!("a task takes no further arguments, but got {}", rest.join(" "))),
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
            eprintln!("\nxtask {}: {problem}", task.word());
            ExitCode::FAILURE
        }
    }
}
