use std::fs::File;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use soilctl_campaign::Plan;
use soilctl_live::{Host, Report, Rig, Session};

use super::{DigMessage, DigSettings, Dug, DugSession};
use crate::MonitorError;
use crate::live::Hub;
use crate::messages::text;

/// How long the thread sleeps between two looks.
const NAP: Duration = Duration::from_millis(20);
/// Most logs of one name.
const MOST_LOGS: u32 = 10_000;

/// Sessions, one after the other.
pub(super) struct Sessions {
    settings: DigSettings,
    hub: Arc<Hub>,
    stop: Arc<AtomicBool>,
    over: Arc<AtomicBool>,
    running: Option<Running>,
    message: DigMessage,
    dug: Vec<DugSession>,
}

struct Running {
    host: Host,
    soil: String,
    log: PathBuf,
}

impl Sessions {
    /// The first session runs when this returns.
    pub(super) fn begin(
        settings: DigSettings,
        hub: Arc<Hub>,
        stop: Arc<AtomicBool>,
        over: Arc<AtomicBool>,
    ) -> Result<Self, MonitorError> {
        let first = start(&settings, &settings.soil)?;
        let mut sessions = Self {
            settings,
            hub,
            stop,
            over,
            running: Some(first),
            message: DigMessage::new(),
            dug: Vec::new(),
        };
        sessions.tell("");
        Ok(sessions)
    }

    /// Until it shall stop, or a session has ended by itself.
    pub(super) fn run(mut self) -> Vec<DugSession> {
        while !self.stop.load(Ordering::Relaxed) {
            if let Some(soil) = self.hub.take_choice() {
                self.end_session();
                let begun = start(&self.settings, &soil);
                let problem = begun.as_ref().err().map(ToString::to_string).unwrap_or_default();
                self.running = begun.ok();
                self.tell(&problem);
            }
            if self.running.as_ref().is_some_and(|running| running.host.stopper().has_ended()) {
                break;
            }
            std::thread::sleep(NAP);
        }
        self.end_session();
        self.tell("");
        self.over.store(true, Ordering::Release);
        self.dug
    }

    /// Ends the session that runs; its log is closed then.
    fn end_session(&mut self) {
        let Some(Running { host, soil, log }) = self.running.take() else { return };
        host.stopper().stop();
        let (steps, problems) = match host.wait() {
            Ok(report) => outcome(&report),
            Err(error) => (0, vec![error.to_string()]),
        };
        self.message.dug.push(Dug {
            soil: soil.clone(),
            log: log.display().to_string(),
            steps,
            problems: problems.clone(),
        });
        self.dug.push(DugSession { soil, log, steps, problems });
    }

    /// Tells all pages which soil is dug, and into which log.
    fn tell(&mut self, problem: &str) {
        let running = self.running.as_ref();
        self.message.soil = running.map(|running| running.soil.clone()).unwrap_or_default();
        self.message.log = running.map(|running| running.log.display().to_string()).unwrap_or_default();
        problem.clone_into(&mut self.message.problem);
        self.hub.lock().set_dig(text(&self.message));
    }
}

fn start(settings: &DigSettings, soil: &str) -> Result<Running, MonitorError> {
    let plan = Plan::by_hand(soil, settings.seed)?;
    let setup = plan.setup(settings.seed)?;
    let state = plan.first_state(&setup.params()?);
    let rig = Rig::Plant(Box::new(plan.simulated_plant(settings.seed, 0)?));
    let (file, log) = create(&settings.log)?;
    let session =
        Session { rig, setup, state, real_time: true, most_ticks: None, device: settings.device.clone() };
    let host = Host::start(session, &settings.socket, Some(file)).inspect_err(|_| {
        // A log in which nothing stands is none.
        if log.metadata().is_ok_and(|file| file.len() == 0) {
            let _ = std::fs::remove_file(&log);
        }
    })?;
    Ok(Running { host, soil: soil.to_owned(), log })
}

/// A new file: of this name, or with the first number behind it that is free.
fn create(path: &Path) -> Result<(File, PathBuf), MonitorError> {
    let failed = |path: &Path, reason| MonitorError::File { path: path.display().to_string(), reason };
    let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let ending = path.extension().map(|ending| format!(".{}", ending.to_string_lossy())).unwrap_or_default();
    for number in 1..=MOST_LOGS {
        let name = if number == 1 {
            path.to_owned()
        } else {
            path.with_file_name(format!("{stem}-{number}{ending}"))
        };
        match File::create_new(&name) {
            Ok(file) => return Ok((file, name)),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(failed(&name, error)),
        }
    }
    Err(failed(path, ErrorKind::AlreadyExists.into()))
}

/// Steps in the log, and what went wrong.
fn outcome(report: &Report) -> (u64, Vec<String>) {
    let mut problems: Vec<String> = report.failed.iter().map(ToString::to_string).collect();
    let steps = match &report.log {
        Some(Ok(log)) => {
            if log.dropped_steps > 0 {
                problems
                    .push(format!("{} steps are not in the log: the disk was too slow", log.dropped_steps));
            }
            log.steps
        }
        Some(Err(error)) => {
            problems.push(error.to_string());
            0
        }
        None => 0,
    };
    (steps, problems)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    #[test]
    fn logs_are_never_overwritten() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("dig.mcap");
        let names: Vec<_> = (0..3).map(|_| create(&path).unwrap().1).collect();
        assert_eq!(names, ["dig.mcap", "dig-2.mcap", "dig-3.mcap"].map(|name| dir.path().join(name)));
        assert!(matches!(create(&dir.path().join("none/dig.mcap")), Err(MonitorError::File { .. })));
    }
}
