use std::path::PathBuf;

use rustyline::completion::Completer;
use rustyline::error::ReadlineError;
use rustyline::highlight::Highlighter;
use rustyline::hint::Hinter;
use rustyline::history::DefaultHistory;
use rustyline::validate::Validator;
use rustyline::{Context, Editor, Helper};
use soilctl_live::protocol::COMMANDS;

use crate::error::CliError;

/// The prompt of a person: completion, and a history that outlives the program.
pub(super) struct Prompt {
    editor: Editor<Words, DefaultHistory>,
    history: Option<PathBuf>,
}

impl Prompt {
    /// `words` are completed beside the commands of the protocol.
    pub(super) fn new(words: &'static [&'static str]) -> Result<Self, CliError> {
        let mut editor = Editor::new().map_err(failed)?;
        editor.set_helper(Some(Words { own: words }));
        let history = history();
        if let Some(path) = &history {
            // The first time there is none.
            let _ = editor.load_history(path);
        }
        Ok(Self { editor, history })
    }

    /// Prints lines above the prompt, from any thread.
    pub(super) fn printer(&mut self) -> Result<impl FnMut(String) + Send + use<>, CliError> {
        use rustyline::ExternalPrinter;
        let mut printer = self.editor.create_external_printer().map_err(failed)?;
        Ok(move |text| {
            let _ = printer.print(text);
        })
    }

    /// The next line; none after Ctrl-C or Ctrl-D.
    pub(super) fn read(&mut self) -> Result<Option<String>, CliError> {
        match self.editor.readline("soilctl> ") {
            Ok(line) => {
                let _ = self.editor.add_history_entry(&line);
                if let Some(path) = &self.history {
                    let _ = path.parent().map(std::fs::create_dir_all);
                    let _ = self.editor.save_history(path);
                }
                Ok(Some(line))
            }
            Err(ReadlineError::Eof | ReadlineError::Interrupted) => Ok(None),
            Err(error) => Err(failed(error)),
        }
    }
}

fn failed(error: ReadlineError) -> CliError {
    match error {
        ReadlineError::Io(error) => CliError::Stdout(error),
        other => CliError::Usage(format!("the terminal cannot be used: {other}; give --script or a pipe")),
    }
}

fn history() -> Option<PathBuf> {
    let state = std::env::var_os("XDG_STATE_HOME").filter(|path| !path.is_empty()).map(PathBuf::from);
    let state = state.or_else(|| Some(PathBuf::from(std::env::var_os("HOME")?).join(".local/state")))?;
    Some(state.join("soilctl/console_history"))
}

/// Completes names of commands, and behind them what may stand there.
struct Words {
    own: &'static [&'static str],
}

impl Completer for Words {
    type Candidate = String;

    fn complete(&self, line: &str, at: usize, _: &Context<'_>) -> rustyline::Result<(usize, Vec<String>)> {
        Ok(complete(self.own, line.get(..at).unwrap_or_default()))
    }
}

/// Where the last word of `line` begins, and what it may become.
fn complete(own: &[&str], line: &str) -> (usize, Vec<String>) {
    let begin = line.rfind(' ').map_or(0, |space| space + 1);
    let word = line.get(begin..).unwrap_or_default();
    let mut found: Vec<String> = match line.split_whitespace().next() {
        Some(name) if begin > 0 => {
            let known = COMMANDS.iter().find(|known| known.name == name);
            let keys = known.iter().flat_map(|known| known.keys).map(|key| format!("{key}="));
            let choices = known.iter().flat_map(|known| known.choices).map(|&choice| choice.to_owned());
            choices.chain(keys).collect()
        }
        _ => own
            .iter()
            .map(|&name| name.to_owned())
            .chain(COMMANDS.map(|known| known.name.to_owned()))
            .collect(),
    };
    found.retain(|candidate| candidate.starts_with(word));
    (begin, found)
}

impl Hinter for Words {
    type Hint = String;
}

impl Highlighter for Words {}
impl Validator for Words {}
impl Helper for Words {}

#[cfg(test)]
mod tests {
    use super::complete;

    #[test]
    fn names_and_what_follows_them() {
        let words = |line| complete(&["wait", "watch"], line);
        assert_eq!(words("wa"), (0, vec!["wait".to_owned(), "watch".to_owned()]));
        assert_eq!(words("start h"), (6, vec!["homing".to_owned()]));
        assert_eq!(words("stroke 0.4 de"), (11, vec!["depth_m=".to_owned(), "delta_deg=".to_owned()]));
        assert_eq!(words("nothing h"), (8, vec![]));
        assert!(words("").1.len() > 20);
    }
}
