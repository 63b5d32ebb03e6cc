//! The server's thread: operators on a local socket. It may be as slow as it likes; the servo does not wait for it.

mod connection;
mod words;

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

use soilctl_session::messages::{EventMessage, word};

use connection::Connection;
use words::{advice, message};

use crate::links::{Answer, Ask, REQUESTS, ServerEnds, Snapshot, What};
use crate::local::Listener;
use crate::protocol::{
    ClientMessage, Command, Configuration, Dropped, Event, Hello, PROTOCOL_VERSION, Problem, ServerMessage,
};

/// How long the server sleeps between two rounds.
const NAP: Duration = Duration::from_millis(3);
/// Time between two states.
const STATE_INTERVAL: Duration = Duration::from_millis(32);
/// Time between two states when nothing changes.
const IDLE_INTERVAL: Duration = Duration::from_secs(1);
/// Most clients at a time.
const MOST_CLIENTS: usize = 64;
/// Commands of one client that may wait for their answers, so that there is room for those of others.
const MOST_PENDING: usize = 8;
/// How long clients have at the end to take what is left.
const FAREWELL: Duration = Duration::from_millis(300);

/// Serves operators.
pub(crate) struct Server {
    listener: Listener,
    path: PathBuf,
    hello: Hello,
    configuration: Configuration,
    ends: ServerEnds,
    clients: BTreeMap<u64, Connection>,
    /// Client and id of each question that is not answered yet, by token.
    pending: BTreeMap<u64, (u64, u64)>,
    next_client: u64,
    next_token: u64,
    latest: Option<Snapshot>,
    fresh: bool,
    sent: Instant,
    report: ServerReport,
}

/// What a server leaves behind.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct ServerReport {
    pub(crate) clients: u64,
    pub(crate) messages_dropped: u64,
    pub(crate) lines_refused: u64,
}

impl Server {
    pub(crate) fn new(
        listener: Listener,
        path: PathBuf,
        hello: Hello,
        configuration: Configuration,
        ends: ServerEnds,
    ) -> Self {
        Self {
            listener,
            path,
            hello,
            configuration,
            ends,
            clients: BTreeMap::new(),
            pending: BTreeMap::new(),
            next_client: 0,
            next_token: 0,
            latest: None,
            fresh: false,
            sent: Instant::now(),
            report: ServerReport::default(),
        }
    }

    /// Serves until the servo has ended; `reason` then says why.
    pub(crate) fn run(mut self, reason: impl Fn() -> String) -> ServerReport {
        loop {
            let ended = self.ends.shared.ended.load(Ordering::Acquire);
            self.ends.shared.heartbeat.fetch_add(1, Ordering::Relaxed);
            self.accept();
            self.listen();
            self.tell();
            if ended {
                break;
            }
            std::thread::sleep(NAP);
        }
        self.show(Instant::now());
        let end = ServerMessage::End { reason: reason() };
        self.clients.values_mut().for_each(|client| client.outbox.push(&end));
        let last = Instant::now();
        while last.elapsed() < FAREWELL && self.clients.values().any(|client| !client.outbox.is_empty()) {
            self.flush();
            std::thread::sleep(NAP);
        }
        for client in std::mem::take(&mut self.clients).into_values() {
            self.report.messages_dropped += client.outbox.dropped();
        }
        // A path that was moved away by somebody is not ours any more.
        let _ = std::fs::remove_file(&self.path);
        self.report
    }

    fn accept(&mut self) {
        while let Some(stream) = self.listener.poll() {
            if self.clients.len() >= MOST_CLIENTS {
                continue;
            }
            let Ok(mut client) = Connection::new(stream) else { continue };
            client.outbox.push(&ServerMessage::Hello(self.hello.clone()));
            self.clients.insert(self.next_client, client);
            self.next_client += 1;
            self.report.clients += 1;
            // It sees how things are at once.
            self.fresh = self.latest.is_some();
        }
    }

    fn listen(&mut self) {
        let now = Instant::now();
        for (number, mut client) in std::mem::take(&mut self.clients) {
            let open = client.read(now, &mut |client, read| match read {
                Ok(message) => self.obey(number, client, message),
                Err((id, problem, message)) => {
                    self.report.lines_refused += 1;
                    client.outbox.push(&ServerMessage::Error { id, problem, message });
                }
            });
            if open {
                self.clients.insert(number, client);
            } else {
                self.report.messages_dropped += client.outbox.dropped();
            }
        }
    }

    fn obey(&mut self, number: u64, client: &mut Connection, message: ClientMessage) {
        let (id, command) = match message {
            ClientMessage::Hello { protocol } => {
                if protocol != PROTOCOL_VERSION {
                    let message = format!("this session speaks protocol {PROTOCOL_VERSION}, not {protocol}");
                    client.outbox.push(&ServerMessage::Error {
                        id: None,
                        problem: Problem::Protocol,
                        message,
                    });
                    client.hang_up();
                }
                return;
            }
            ClientMessage::Describe {} => {
                let configuration = Box::new(self.configuration.clone());
                client.outbox.push(&ServerMessage::Configuration(configuration));
                return;
            }
            ClientMessage::Command { id, command } => (id, command),
        };
        let shared = &self.ends.shared;
        let ack = ServerMessage::Ack { id, tick: shared.tick.load(Ordering::Relaxed) };
        let error = |problem, message| ServerMessage::Error { id: Some(id), problem, message };
        let answer = match (&command, command.request()) {
            (_, Err(message)) => {
                self.report.lines_refused += 1;
                error(Problem::Value, message)
            }
            (_, Ok(Some(request))) => match self.ask(number, id, What::Request(request)) {
                true => return,
                false => error(
                    Problem::Unavailable,
                    "too many commands wait for their answers; wait for some".to_owned(),
                ),
            },
            (Command::EmergencyStop, _) => {
                shared.emergency_stop.store(true, Ordering::Release);
                ack
            }
            (Command::ReleaseStop, _) => {
                shared.emergency_stop.store(false, Ordering::Release);
                ack
            }
            (Command::End, _) => {
                shared.stop.store(true, Ordering::Release);
                ack
            }
            (Command::Advance { seconds }, _) if self.hello.simulated && !self.hello.real_time => {
                match crate::protocol::ticks(*seconds) {
                    Ok(ticks) if self.ask(number, id, What::Advance(ticks)) => return,
                    Ok(_) => error(
                        Problem::Unavailable,
                        "too many commands wait for their answers; wait for some".to_owned(),
                    ),
                    Err(message) => error(Problem::Value, message),
                }
            }
            _ => {
                let reason =
                    "time goes on by itself here; `advance` is for simulated runs that are not in real time";
                error(Problem::Unavailable, reason.to_owned())
            }
        };
        client.outbox.push(&answer);
    }

    /// Asks the servo, if it can take one more question.
    fn ask(&mut self, client: u64, id: u64, what: What) -> bool {
        let token = self.next_token;
        let own = self.pending.values().filter(|(of, _)| *of == client).count();
        if own >= MOST_PENDING
            || self.pending.len() >= REQUESTS
            || self.ends.asks.push(Ask { token, what }).is_err()
        {
            return false;
        }
        self.next_token += 1;
        self.pending.insert(token, (client, id));
        true
    }

    /// Hands on what the servo says.
    fn tell(&mut self) {
        // Events before the answer that follows them: a client that has its answer knows what it led to.
        while let Ok((tick, event)) = self.ends.events.pop() {
            let event = ServerMessage::Event(Event::new(tick, &EventMessage::from(&event)));
            self.clients.values_mut().for_each(|client| client.outbox.push(&event));
        }
        while let Ok(answer) = self.ends.answers.pop() {
            self.answer(answer);
        }
        while let Ok(snapshot) = self.ends.states.pop() {
            self.latest = Some(snapshot);
            self.fresh = true;
        }
        let now = Instant::now();
        let interval = if self.fresh { STATE_INTERVAL } else { IDLE_INTERVAL };
        if now.duration_since(self.sent) >= interval {
            self.show(now);
        }
        self.flush();
    }

    fn answer(&mut self, answer: Answer) {
        let Some((number, id)) = self.pending.remove(&answer.token) else { return };
        let Some(client) = self.clients.get_mut(&number) else { return };
        client.outbox.push(&match answer.refused {
            None => ServerMessage::Ack { id, tick: answer.tick },
            Some(refusal) => ServerMessage::Error {
                id: Some(id),
                problem: Problem::Refused,
                message: format!("refused ({}): {}", word(&refusal), advice(refusal)),
            },
        });
    }

    fn show(&mut self, now: Instant) {
        let Some(snapshot) = &self.latest else { return };
        let mut state = message(snapshot);
        let shared = &self.ends.shared;
        let dropped = Dropped {
            log_steps: shared.log_dropped.load(Ordering::Relaxed),
            states: shared.states_dropped.load(Ordering::Relaxed),
            events: shared.events_dropped.load(Ordering::Relaxed),
            messages: 0,
        };
        for client in self.clients.values_mut() {
            if client.outbox.is_crowded() {
                // Room is kept for events and answers; the next state is as good.
                client.outbox.skip();
                continue;
            }
            state.dropped = Dropped { messages: client.outbox.dropped(), ..dropped };
            client.outbox.push(&ServerMessage::State(Box::new(state.clone())));
        }
        self.sent = now;
        self.fresh = false;
    }

    fn flush(&mut self) {
        let report = &mut self.report;
        self.clients.retain(|_, client| {
            let open = client.write();
            if !open {
                report.messages_dropped += client.outbox.dropped();
            }
            open
        });
    }
}
