use std::io::Write;
use std::path::Path;
use std::time::{Duration, Instant};

use soilctl_live::protocol::{COMMANDS, Command, Event, ServerMessage, parse_command};
use soilctl_live::{Client, Commander, LiveError};

use super::board::{Board, Waited};
use super::panel::{Screen, event_words, panel, summary};
use super::{Args, Source};
use crate::error::CliError;
use crate::output::Output;
use crate::verbs::Outcome;

/// How long an answer may take.
const ANSWER: Duration = Duration::from_secs(30);
/// How long `wait` waits if it is not told.
const WAIT_S: f64 = 600.0;
/// Between two pictures.
const PICTURE: Duration = Duration::from_millis(100);
/// Commands of the console itself.
const WORDS: [&str; 6] = ["help", "state", "wait", "watch", "sleep", "quit"];

pub(super) fn run(args: &Args, socket: &Path, output: &mut Output) -> Result<Outcome, CliError> {
    let mut client = Client::connect(socket)?;
    let commander = client.commander()?;
    let json = output.is_json();
    if args.watch {
        return watch_all(&mut client, json, output);
    }
    let mut source = Source::of(args, &WORDS)?;
    let hello = client.hello().clone();
    if json {
        output.raw(line(&ServerMessage::Hello(hello))?.as_bytes())?;
    } else {
        let pace = if hello.real_time { "in real time" } else { "as fast as possible" };
        output.note(&format!("{}, {pace}; `help` lists the commands", hello.program));
    }
    let mut print: Box<dyn FnMut(String) + Send> = match &mut source {
        Source::Prompt(prompt) => Box::new(prompt.printer()?),
        Source::Lines(_) => Box::new(|text| {
            // Whoever reads may go away.
            let _ = std::io::stdout().lock().write_all(text.as_bytes());
        }),
    };
    let board = Board::default();
    let theirs = board.clone();
    // It ends with the session, or with the program.
    std::thread::spawn(move || {
        let reason = listen(&mut client, &theirs, json, &mut print);
        theirs.close(reason.to_string());
    });
    let mut console = Console { commander, board, json, since: 0 };
    while let Some(text) = source.next()? {
        match console.obey(&text, output) {
            Ok(true) => {}
            Ok(false) => break,
            Err(Failed::Said(problem)) => {
                output.problem(&problem);
                if !source.is_prompt() {
                    return Ok(Outcome::Negative);
                }
            }
            Err(Failed::Error(error)) => return Err(*error),
        }
    }
    Ok(Outcome::Done)
}

/// Notes and prints what the session says, until it says no more.
fn listen(
    client: &mut Client,
    board: &Board,
    json: bool,
    print: &mut (dyn FnMut(String) + Send),
) -> LiveError {
    loop {
        match client.next(Duration::from_secs(3600)) {
            Ok(None) => {}
            Ok(Some(message)) => {
                let words = match &message {
                    ServerMessage::State(_) => None,
                    _ if json => line(&message).ok(),
                    ServerMessage::Event(event) => Some(event_words(event) + "\n"),
                    ServerMessage::End { reason } => Some(format!("the session has ended: {reason}\n")),
                    _ => None,
                };
                // Before anybody who waits can go on and print more.
                if let Some(words) = words {
                    print(words);
                }
                board.note(&message);
            }
            Err(error) => return error,
        }
    }
}

fn line(message: &ServerMessage) -> Result<String, CliError> {
    Ok(serde_json::to_string(message)? + "\n")
}

/// Why a line was not carried out.
enum Failed {
    /// A person may try again.
    Said(String),
    /// Nothing works any more.
    Error(Box<CliError>),
}

impl<E: Into<CliError>> From<E> for Failed {
    fn from(error: E) -> Self {
        Self::Error(Box::new(error.into()))
    }
}

struct Console {
    commander: Commander,
    board: Board,
    json: bool,
    /// Events before the last command.
    since: u64,
}

impl Console {
    /// Carries out a line; says whether to go on.
    fn obey(&mut self, text: &str, output: &mut Output) -> Result<bool, Failed> {
        let words: Vec<_> = text.split_whitespace().collect();
        match words.as_slice() {
            ["quit" | "exit"] => return Ok(false),
            ["help"] => output.raw(help().as_bytes())?,
            ["state"] => self.state(output)?,
            ["sleep", seconds] => std::thread::sleep(Duration::from_secs_f64(time(seconds)?)),
            ["watch"] => self.watch(10.0, output)?,
            ["watch", seconds] => self.watch(time(seconds)?, output)?,
            ["wait", kind] => self.wait(kind, WAIT_S)?,
            ["wait", kind, seconds] => self.wait(kind, time(seconds)?)?,
            _ => self.command(parse_command(text).map_err(Failed::Said)?)?,
        }
        Ok(true)
    }

    fn command(&mut self, command: Command) -> Result<(), Failed> {
        self.since = self.board.content().event_count;
        let id = self.commander.send(command)?;
        match self.board.answer(id, ANSWER) {
            Waited::Found(Ok(_)) => Ok(()),
            Waited::Found(Err(message)) => Err(Failed::Said(message)),
            Waited::Ended(reason) => Err(Failed::Said(format!("the session has ended: {reason}"))),
            Waited::TimedOut => Err(Failed::Said("the session does not answer".to_owned())),
        }
    }

    /// Waits for an event since the last command. A fault or a sequence that failed ends it too.
    fn wait(&self, kind: &str, seconds: f64) -> Result<(), Failed> {
        let since = self.since;
        let waited = self.board.wait(Duration::from_secs_f64(seconds), |content| {
            let new = usize::try_from(content.event_count - since).unwrap_or(usize::MAX);
            let skip = content.events.len().saturating_sub(new);
            let mut new = content.events.iter().skip(skip);
            new.find(|event| event.kind.starts_with(kind) || is_failure(event)).cloned()
        });
        match waited {
            Waited::Found(event) if event.kind.starts_with(kind) => Ok(()),
            Waited::Found(event) => {
                Err(Failed::Said(format!("waited for {kind}, but: {}", event_words(&event))))
            }
            Waited::Ended(reason) => Err(Failed::Said(format!("the session has ended: {reason}"))),
            Waited::TimedOut => Err(Failed::Said(format!("there was no {kind} within {seconds} s"))),
        }
    }

    /// Prints a state that is not older than the question.
    fn state(&self, output: &mut Output) -> Result<(), Failed> {
        let before = self.board.content().states;
        let state = self.board.wait(Duration::from_secs(5), |content| {
            content.state.clone().filter(|_| content.states > before)
        });
        let state = match state {
            Waited::Found(state) => state,
            Waited::Ended(reason) => return Err(Failed::Said(format!("the session has ended: {reason}"))),
            Waited::TimedOut => return Err(Failed::Said("there is no state yet".to_owned())),
        };
        let text = if self.json {
            line(&ServerMessage::State(Box::new(state)))?
        } else {
            panel(&state, &self.board.content().events)
        };
        Ok(output.raw(text.as_bytes())?)
    }

    fn watch(&self, seconds: f64, output: &mut Output) -> Result<(), Failed> {
        let (mut screen, begin) = (Screen::new(), Instant::now());
        let mut shown = 0;
        while begin.elapsed().as_secs_f64() < seconds {
            let text = {
                let content = self.board.content();
                if content.ended.is_some() {
                    break;
                }
                let fresh = content.state.as_ref().filter(|_| content.states > shown);
                let text = fresh.map(|state| panel(state, &content.events));
                shown = content.states;
                text
            };
            if let Some(text) = text {
                output.raw(screen.draw(&text).as_bytes())?;
            }
            std::thread::sleep(PICTURE);
        }
        Ok(())
    }
}

fn is_failure(event: &Event) -> bool {
    event.kind.starts_with("fault/") || event.kind.starts_with("sequence_failed/")
}

fn time(text: &str) -> Result<f64, Failed> {
    match text.parse::<f64>() {
        Ok(seconds) if seconds > 0.0 && seconds <= 86_400.0 => Ok(seconds),
        _ => Err(Failed::Said(format!("the time is {text}; it must be above 0 and at most 86400 s"))),
    }
}

/// Panels until the session ends; lines of JSON, or lines of text where there is no terminal.
fn watch_all(client: &mut Client, json: bool, output: &mut Output) -> Result<Outcome, CliError> {
    let (mut screen, board) = (Screen::new(), Board::default());
    let mut drawn = Instant::now();
    let terminal = std::io::IsTerminal::is_terminal(&std::io::stdout());
    loop {
        let message = match client.next(PICTURE) {
            Ok(None) => continue,
            Ok(Some(message)) => message,
            Err(error) => return Err(error.into()),
        };
        board.note(&message);
        if json {
            output.raw(line(&message)?.as_bytes())?;
        }
        match &message {
            ServerMessage::End { reason } => {
                output.note(&format!("the session has ended: {reason}"));
                return Ok(Outcome::Done);
            }
            ServerMessage::Event(event) if !json && !terminal => {
                output.raw((event_words(event) + "\n").as_bytes())?;
            }
            ServerMessage::State(state) if !json && drawn.elapsed() >= PICTURE => {
                let text = if terminal {
                    screen.draw(&panel(state, &board.content().events))
                } else {
                    summary(state) + "\n"
                };
                output.raw(text.as_bytes())?;
                drawn = Instant::now();
            }
            _ => {}
        }
    }
}

fn help() -> String {
    let mut text = String::from("commands of the session:\n");
    for known in &COMMANDS {
        let keys: String = known.keys.iter().map(|key| format!(" {}", key.to_uppercase())).collect();
        text += &format!("  {}{keys}: {}\n", known.name, known.help);
    }
    text + "commands of the console:\n  \
        state: joints, plate, forces, state, events\n  \
        watch [SECONDS]: the same, again and again; 10 s if not told\n  \
        wait EVENT [SECONDS]: until an event that begins so, as in wait sequence_succeeded/homing\n  \
        sleep SECONDS: do nothing, in wall time\n  \
        quit: leave; the session goes on\n"
}
