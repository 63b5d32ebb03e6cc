use std::collections::VecDeque;
use std::path::Path;
use std::time::{Duration, Instant};

use soilctl_live::protocol::{Event, ServerMessage, StateMessage};
use soilctl_live::{Playback, Played};

use super::panel::{EVENTS, Screen, event_words, panel};
use super::{Args, Source};
use crate::error::CliError;
use crate::output::Output;
use crate::verbs::Outcome;

/// Commands of a playback.
const WORDS: [&str; 6] = ["help", "play", "seek", "step", "state", "quit"];
const HELP: &str = "  play [SECONDS] [SPEED]: go on, for so long, so many times as fast as real time\n  \
    seek SECONDS: go to a time\n  \
    step [N]: N states further, one if not told\n  \
    state: joints, plate, forces, state, events\n  \
    quit: leave\n";
/// Between two pictures.
const PICTURE: Duration = Duration::from_millis(100);

pub(super) fn run(args: &Args, log: &Path, output: &mut Output) -> Result<Outcome, CliError> {
    let playback = Playback::start(log, args.from)?;
    let json = output.is_json();
    let mut player =
        Player { playback, json, state: None, events: VecDeque::new(), quiet: false, damaged: false };
    if args.watch {
        player.play(f64::INFINITY, Some(args.speed), output)?;
        return Ok(player.outcome());
    }
    let mut source = Source::of(args, &WORDS)?;
    let mut obeyed = false;
    while let Some(text) = source.next()? {
        obeyed = true;
        match player.obey(&text, args.speed, output) {
            Ok(true) => {}
            Ok(false) => return Ok(player.outcome()),
            Err(CliError::Usage(problem)) if source.is_prompt() => output.problem(&problem),
            Err(CliError::Usage(problem)) => {
                output.problem(&problem);
                return Ok(Outcome::Negative);
            }
            Err(error) => return Err(error),
        }
    }
    if !obeyed && !source.is_prompt() {
        // Nobody asks for anything in particular: all events, and how it ended.
        player.play(f64::INFINITY, None, output)?;
        player.show(output)?;
    }
    Ok(player.outcome())
}

struct Player {
    playback: Playback,
    json: bool,
    state: Option<StateMessage>,
    events: VecDeque<Event>,
    /// Events are shown by the panels.
    quiet: bool,
    /// The log turned out to be.
    damaged: bool,
}

impl Player {
    const fn outcome(&self) -> Outcome {
        if self.damaged { Outcome::Partial } else { Outcome::Done }
    }

    fn obey(&mut self, text: &str, speed: f64, output: &mut Output) -> Result<bool, CliError> {
        let words: Vec<_> = text.split_whitespace().collect();
        match words.as_slice() {
            ["quit" | "exit"] => return Ok(false),
            ["help"] => output.raw(HELP.as_bytes())?,
            ["play"] => self.play(f64::INFINITY, Some(speed), output)?,
            ["play", seconds] => self.play(number(seconds)?, Some(speed), output)?,
            ["play", seconds, speed] => self.play(number(seconds)?, Some(number(speed)?), output)?,
            ["seek", seconds] => {
                self.playback.seek(number(seconds)?)?;
                self.events.clear();
                self.step(1, output)?;
            }
            ["step"] => self.step(1, output)?,
            ["step", count] => match count.parse() {
                Ok(count) => self.step(count, output)?,
                Err(_) => return Err(CliError::Usage(format!("step {count}: give a whole number"))),
            },
            ["state"] => self.show(output)?,
            _ => {
                return Err(CliError::Usage(format!(
                    "there is no command `{text}`; use {}",
                    WORDS.join(", ")
                )));
            }
        }
        Ok(true)
    }

    /// The next state; what happens on the way is told. None at the end of the log.
    fn next(&mut self, output: &mut Output) -> Result<Option<StateMessage>, CliError> {
        loop {
            match self.playback.next_item()? {
                None => return Ok(None),
                Some(Played::Damage(what)) => {
                    self.damaged = true;
                    output.note(&format!("damaged: {what}"));
                }
                Some(Played::State(state)) => {
                    self.state = Some((*state).clone());
                    return Ok(Some(*state));
                }
                Some(Played::Event(event)) => {
                    if self.json {
                        output.raw(line(&ServerMessage::Event(event.clone()))?.as_bytes())?;
                    } else if !self.quiet {
                        output.raw((event_words(&event) + "\n").as_bytes())?;
                    }
                    self.events.push_back(event);
                    if self.events.len() > EVENTS {
                        self.events.pop_front();
                    }
                }
            }
        }
    }

    fn step(&mut self, count: u32, output: &mut Output) -> Result<(), CliError> {
        for _ in 0..count {
            if self.next(output)?.is_none() {
                output.note("the log ends here");
                break;
            }
        }
        self.show(output)
    }

    /// Plays for a time of the log, at a speed or as fast as possible.
    fn play(&mut self, seconds: f64, speed: Option<f64>, output: &mut Output) -> Result<(), CliError> {
        let terminal = std::io::IsTerminal::is_terminal(&std::io::stdout()) && !self.json;
        let paced = speed.filter(|_| terminal);
        self.quiet = paced.is_some();
        let (mut screen, begin) = (Screen::new(), Instant::now());
        let mut drawn: Option<Instant> = None;
        let mut first_s = None;
        while let Some(state) = self.next(output)? {
            let first_s = *first_s.get_or_insert(state.time_s);
            if state.time_s - first_s > seconds {
                break;
            }
            if self.json {
                output.raw(line(&ServerMessage::State(Box::new(state)))?.as_bytes())?;
                continue;
            }
            let Some(speed) = paced else { continue };
            let due = Duration::try_from_secs_f64((state.time_s - first_s) / speed).unwrap_or_default();
            std::thread::sleep(due.saturating_sub(begin.elapsed()));
            if drawn.is_none_or(|drawn| drawn.elapsed() >= PICTURE) {
                output.raw(screen.draw(&panel(&state, &self.events)).as_bytes())?;
                drawn = Some(Instant::now());
            }
        }
        self.quiet = false;
        Ok(())
    }

    fn show(&self, output: &mut Output) -> Result<(), CliError> {
        let Some(state) = &self.state else {
            output.note("there is no step of the controller here");
            return Ok(());
        };
        let text = if self.json {
            line(&ServerMessage::State(Box::new(state.clone())))?
        } else if std::io::IsTerminal::is_terminal(&std::io::stdout()) {
            panel(state, &self.events)
        } else {
            panel(state, &VecDeque::new())
        };
        output.raw(text.as_bytes())
    }
}

fn line(message: &ServerMessage) -> Result<String, CliError> {
    Ok(serde_json::to_string(message)? + "\n")
}

fn number(text: &str) -> Result<f64, CliError> {
    match text.parse::<f64>() {
        Ok(value) if value >= 0.0 && value.is_finite() => Ok(value),
        _ => Err(CliError::Usage(format!("`{text}` is no number from 0 on"))),
    }
}
