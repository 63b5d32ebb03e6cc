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
mod verify;
mod wheel;
mod workspace;

use std::process::ExitCode;

use crate::tasks::Task;
use crate::verify::Part;
use crate::workspace::Workspace;

fn main() -> ExitCode {
    let arguments: Vec<String> =
        std::env::args_os().skip(1).map(|a| a.to_string_lossy().into_owned()).collect();
    let task = match arguments.as_slice() {
        [word] if matches!(word.as_str(), "help" | "-h" | "--help") => {
            eprintln!("{}", tasks::usage());
            return ExitCode::SUCCESS;
        }
        [] => Err("a task is missing".to_owned()),
        [word, rest @ ..] => task(word, rest),
    };
    let (task, parts) = match task {
        Ok(task) => task,
        Err(problem) => {
            eprintln!("xtask: {problem}\n\n{}", tasks::usage());
            return ExitCode::from(2);
        }
    };
    match Workspace::find().and_then(|workspace| task.run(&workspace, &parts)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("\nxtask {}: {problem}", task.word());
            ExitCode::FAILURE
        }
    }
}

/// The task of a name, and the parts of `verify`; no other task takes further words.
fn task(word: &str, rest: &[String]) -> Result<(Task, Vec<Part>), String> {
    let task = Task::from_word(word).ok_or_else(|| format!("there is no task {word:?}"))?;
    match task {
        Task::Verify => Ok((task, Part::from_words(rest)?)),
        Task::Setup | Task::Test | Task::Lint | Task::Rows | Task::Pictures if rest.is_empty() => {
            Ok((task, Vec::new()))
        }
        Task::Setup | Task::Test | Task::Lint | Task::Rows | Task::Pictures => {
            Err(format!("{word} takes no further arguments, but got {}", rest.join(" ")))
        }
    }
}
