//! Running programs as named steps.

use std::ffi::OsStr;
use std::io::Write as _;
use std::process::{Command, Stdio};

use crate::error::XtaskError;

/// A program to run, with the name its failure is reported under.
pub(crate) struct Step {
    name: String,
    command: Command,
}

impl Step {
    /// A step that runs a program without input.
    pub(crate) fn new(name: &str, program: impl AsRef<OsStr>) -> Self {
        let mut command = Command::new(program);
        command.stdin(Stdio::null());
        Self { name: name.to_owned(), command }
    }

    /// The same with arguments.
    pub(crate) fn args<S: AsRef<OsStr>>(mut self, arguments: impl IntoIterator<Item = S>) -> Self {
        self.command.args(arguments);
        self
    }

    /// The same in a folder.
    pub(crate) fn dir(mut self, folder: &std::path::Path) -> Self {
        self.command.current_dir(folder);
        self
    }

    /// The same with an environment variable.
    pub(crate) fn env(mut self, key: &str, value: impl AsRef<OsStr>) -> Self {
        self.command.env(key, value);
        self
    }

    /// Runs it; what it prints goes where ours goes.
    pub(crate) fn run(mut self) -> Result<(), XtaskError> {
        self.announce();
        let status = self.command.status();
        let status = status.map_err(|problem| self.not_started(problem))?;
        self.check(status)
    }

    /// Runs it and returns what it prints on standard output.
    pub(crate) fn output(mut self) -> Result<String, XtaskError> {
        self.announce();
        let output = self.command.stderr(Stdio::inherit()).output();
        let output = output.map_err(|problem| self.not_started(problem))?;
        self.check(output.status)?;
        Ok(String::from_utf8_lossy(&output.stdout).into_owned())
    }

    /// Runs it and then prints all that it printed, for programs that run beside others.
    pub(crate) fn run_in_one_piece(mut self) -> Result<(), XtaskError> {
        let output = self.command.output();
        let output = output.map_err(|problem| self.not_started(problem))?;
        // Others wait meanwhile. Who cannot be told is no reason to stop.
        let mut printed = std::io::stdout().lock();
        eprintln!("== {}: {}", self.name, self.words());
        let _ = printed.write_all(&output.stdout).and_then(|()| printed.flush());
        eprint!("{}", String::from_utf8_lossy(&output.stderr));
        drop(printed);
        self.check(output.status)
    }

    /// Runs it and says whether it succeeded; what it prints goes where ours goes.
    pub(crate) fn attempt(mut self) -> Result<bool, XtaskError> {
        self.announce();
        let status = self.command.status();
        Ok(status.map_err(|problem| self.not_started(problem))?.success())
    }

    /// Whether it succeeds; prints nothing.
    pub(crate) fn succeeds(mut self) -> bool {
        self.command.stdout(Stdio::null()).stderr(Stdio::null());
        self.command.status().is_ok_and(|status| status.success())
    }

    fn announce(&self) {
        eprintln!("== {}: {}", self.name, self.words());
    }

    fn check(&self, status: std::process::ExitStatus) -> Result<(), XtaskError> {
        if status.success() {
            return Ok(());
        }
        Err(XtaskError::Failed { step: self.name.clone(), command: self.words(), status })
    }

    fn not_started(&self, problem: std::io::Error) -> XtaskError {
        XtaskError::NotStarted { step: self.name.clone(), command: self.words(), problem }
    }

    /// The command as one would type it; the program without its folder.
    fn words(&self) -> String {
        let program = std::path::Path::new(self.command.get_program());
        let short = program.file_name().unwrap_or(program.as_os_str());
        let words = std::iter::once(short).chain(self.command.get_args());
        words.map(|word| word.to_string_lossy()).collect::<Vec<_>>().join(" ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failing_step_is_an_error_with_its_name() {
        assert!(Step::new("yes", "true").run().is_ok());
        assert!(Step::new("no", "/bin/false").run().unwrap_err().to_string().contains("\"no\""));
        let missing = Step::new("gone", "no-such-program").args(["x"]).run().unwrap_err().to_string();
        assert!(missing.contains("\"gone\"") && missing.contains("no-such-program x"), "{missing}");
    }

    #[test]
    fn output_is_captured_and_input_is_empty() {
        assert_eq!(Step::new("echo", "echo").args(["a", "b"]).output().unwrap(), "a b\n");
        assert_eq!(Step::new("cat", "cat").output().unwrap(), "");
        assert!(Step::new("cat", "cat").run_in_one_piece().is_ok());
        assert!(Step::new("no", "false").run_in_one_piece().is_err());
        assert!(Step::new("env", "sh").args(["-c", "test $A = 1"]).env("A", "1").succeeds());
    }
}
