//! What a page is fed from.

use std::sync::Arc;
use std::time::Instant;

use soilctl_live::protocol::{ClientMessage, Problem, ServerMessage, parse_command, read_client_message};
use soilctl_web::is_same;

use crate::film::Player;
use crate::live::Operator;
use crate::messages::{PAGE_REQUESTS, PageMessage, PageRequest, text};

/// What feeds one page.
pub(crate) enum Feed {
    /// A session.
    Session(Operator),
    /// A log.
    Log(Box<Player>),
}

/// What a page may do.
#[derive(Debug, Default)]
pub(crate) struct Rights {
    /// The token that allows commands; none if they are off.
    pub(crate) token: Option<Arc<str>>,
    /// It knows the token.
    pub(crate) authorized: bool,
    /// Tokens that were wrong.
    pub(crate) wrong_tokens: u32,
}

impl Feed {
    /// What there is to tell now.
    pub(crate) fn poll(&mut self, now: Instant, tell: &mut dyn FnMut(String)) {
        match self {
            Self::Session(operator) => operator.poll(tell),
            Self::Log(player) => player.poll(now, tell),
        }
    }

    /// Carries out what a page asks; returns the answer, if there is one at once, and what is worth noting.
    pub(crate) fn obey(&mut self, line: &str, rights: &mut Rights) -> (Option<String>, Option<String>) {
        let kind = serde_json::from_str::<Kind>(line).map(|kind| kind.kind).unwrap_or_default();
        if PAGE_REQUESTS.contains(&kind.as_str()) {
            return match serde_json::from_str::<PageRequest>(line) {
                Ok(request) => self.page_request(&request, rights),
                Err(problem) => refuse(None, Problem::Malformed, &problem.to_string()),
            };
        }
        match read_client_message(line) {
            Err((id, problem, message)) => refuse(id, problem, &message),
            Ok(message) => match self {
                Self::Session(operator) => operator.obey(message, rights),
                Self::Log(_) => refuse(None, Problem::Unavailable, "a log takes no commands"),
            },
        }
    }

    fn page_request(
        &mut self,
        request: &PageRequest,
        rights: &mut Rights,
    ) -> (Option<String>, Option<String>) {
        if let PageRequest::Authorize { token } = request {
            return authorize(token, rights);
        }
        if let PageRequest::Line { id, text } = request {
            return match (parse_command(text), self) {
                (Err(problem), _) => refuse(Some(*id), Problem::Value, &problem),
                (Ok(command), Self::Session(operator)) => {
                    operator.obey(ClientMessage::Command { id: *id, command }, rights)
                }
                (Ok(_), Self::Log(_)) => refuse(Some(*id), Problem::Unavailable, "a log takes no commands"),
            };
        }
        if let PageRequest::ChooseSoil { id, soil } = request {
            return match self {
                Self::Session(operator) => operator.choose(*id, soil, rights),
                Self::Log(_) => refuse(Some(*id), Problem::Unavailable, "the soil of a log cannot be chosen"),
            };
        }
        let Self::Log(player) = self else {
            return refuse(
                None,
                Problem::Unavailable,
                "a live session cannot be played, paused or wound back",
            );
        };
        let now = Instant::now();
        player.hear(request.id());
        match request {
            PageRequest::Play { .. } => player.play(now),
            PageRequest::Pause { .. } => player.pause(),
            PageRequest::Step { count, .. } => player.step(*count),
            PageRequest::Seek { time_s, .. } => player.seek(*time_s),
            PageRequest::Speed { speed, .. } => {
                if let Err(problem) = player.set_speed(*speed, now) {
                    return refuse(None, Problem::Value, &problem);
                }
            }
            PageRequest::Authorize { .. } | PageRequest::Line { .. } | PageRequest::ChooseSoil { .. } => {}
        }
        (None, None)
    }
}

#[derive(serde::Deserialize)]
struct Kind {
    #[serde(rename = "type")]
    kind: String,
}

/// An error for the page, and the same for the notes.
pub(crate) fn refuse(id: Option<u64>, problem: Problem, message: &str) -> (Option<String>, Option<String>) {
    let error = ServerMessage::Error { id, problem, message: message.to_owned() };
    (Some(text(&error)), Some(message.to_owned()))
}

fn authorize(given: &str, rights: &mut Rights) -> (Option<String>, Option<String>) {
    match &rights.token {
        None => refuse(None, Problem::Unavailable, "commands are off; start the monitor with --commands"),
        Some(token) if is_same(token.as_bytes(), given.as_bytes()) => {
            rights.authorized = true;
            (Some(text(&PageMessage::Authorized)), None)
        }
        Some(_) => {
            rights.wrong_tokens += 1;
            refuse(None, Problem::Forbidden, "the token is wrong; open the address that the monitor printed")
        }
    }
}
