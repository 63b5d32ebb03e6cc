//! `soilctl run FILE --socket PATH`: hosts a live session.

mod answer;

use soilctl_app::Outcome;
use soilctl_app::request::finite;
use std::fs::File;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use signal_hook::consts::{SIGINT, SIGTERM};
use soilctl_campaign::Plan;
use soilctl_controller::{State, TICK_RATE_HZ};
use soilctl_live::driver::SocketDriver;
use soilctl_live::{Host, Rig, Session};

pub(crate) use answer::RunAnswer;

use crate::error::CliError;
use crate::output::Output;

/// How long a driver may take for an answer in a session that is not in real time, in ms.
const SIMULATED_TIMEOUT_MS: u32 = 1000;
/// The same in real time: most of a tick.
const REAL_TIME_TIMEOUT_MS: u32 = 2;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Operators connect to the socket: `soilctl console --connect PATH`. Without --real-time, simulated time goes as \
    fast as it can, and without --seconds it stands still while nothing is to be done. Ctrl-C, a SIGTERM and the command \
    `end` bring the arm to the safe state and close the log. Exit codes: 1 the session ended in a fault; 3 the log is not \
    complete, or the driver went away."
)]
pub(crate) struct Args {
    /// A campaign plan (.toml): arm, controller, plant, soil, strokes
    file: PathBuf,

    /// Keep to the wall clock, 500 ticks a second
    #[arg(long)]
    real_time: bool,

    /// Unix socket for operators, to be made
    #[arg(long, value_name = "PATH")]
    socket: PathBuf,

    /// Unix socket of a driver of your own, in place of the simulated arm
    #[arg(long, value_name = "SOCKET")]
    driver: Option<PathBuf>,

    /// How long the driver may take for a tick (ms); default: 2 in real time, else 1000
    #[arg(long, value_name = "MS", requires = "driver", value_parser = clap::value_parser!(u32).range(1..=10_000))]
    driver_timeout: Option<u32>,

    /// Unix socket for a device that leads the plate by hand, to be made (docs/dig.md)
    #[arg(long, value_name = "PATH", requires = "real_time")]
    device: Option<PathBuf>,

    /// The log to write (.mcap); a file that is there is not touched
    #[arg(long, value_name = "PATH", default_value = "run.mcap")]
    log: PathBuf,

    /// End after so long (s), in the session's time
    #[arg(long, value_name = "N", value_parser = finite, allow_negative_numbers = true)]
    seconds: Option<f64>,

    /// Seed of noise and scatter, in place of the plan's
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let plan = Plan::read(&args.file)?;
    let session = session(args, &plan)?;
    let log = create(&args.log)?;
    let signalled = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        // The second one is for whoever cannot wait.
        signal_hook::flag::register_conditional_shutdown(signal, 130, Arc::clone(&signalled))?;
        signal_hook::flag::register(signal, Arc::clone(&signalled))?;
    }
    let host = Host::start(session, &args.socket, Some(log)).inspect_err(|_| {
        // A log in which nothing stands is none.
        if args.log.metadata().is_ok_and(|file| file.is_file() && file.len() == 0) {
            let _ = std::fs::remove_file(&args.log);
        }
    })?;
    output.note(&format!(
        "operators: soilctl console --connect {}; log: {}; Ctrl-C ends",
        args.socket.display(),
        args.log.display()
    ));
    let stopper = host.stopper();
    let spinner = output.spinner("");
    while !stopper.has_ended() {
        if signalled.load(Ordering::Relaxed) {
            stopper.stop();
        }
        #[allow(clippy::cast_precision_loss, reason = "to be looked at")]
        spinner.set_message(format!("{:.1} s", stopper.tick() as f64 / TICK_RATE_HZ));
        std::thread::sleep(Duration::from_millis(20));
    }
    spinner.finish_and_clear();
    let report = host.wait()?;
    if report.timing.is_some_and(|timing| !timing.fifo || !timing.locked) {
        output.note(
            "warning: the system did not permit SCHED_FIFO and locked memory to this user; ticks may come later than \
             they could",
        );
    }
    let answer = RunAnswer::new(&report, &args.log);
    answer.problems().iter().for_each(|problem| output.note(&format!("warning: {problem}")));
    output.answer(&answer)?;
    Ok(if !answer.problems().is_empty() {
        Outcome::Partial
    } else if answer.ended_in_fault() {
        Outcome::Negative
    } else {
        Outcome::Done
    })
}

fn session(args: &Args, plan: &Plan) -> Result<Session, CliError> {
    let most_ticks = args.seconds.map(ticks).transpose()?;
    let seed = args.seed.unwrap_or(plan.file().seed);
    let mut setup = plan.setup(seed)?;
    let params = setup.params()?;
    let (rig, state) = match &args.driver {
        None => (Rig::Plant(Box::new(plan.simulated_plant(seed, 0)?)), plan.first_state(&params)),
        Some(socket) => {
            let default = if args.real_time { REAL_TIME_TIMEOUT_MS } else { SIMULATED_TIMEOUT_MS };
            let timeout = Duration::from_millis(args.driver_timeout.unwrap_or(default).into());
            setup.model = "driver".to_owned();
            // Where a real arm's encoders stand, only its stops can tell.
            (Rig::Driver(Box::new(SocketDriver::connect(socket, timeout)?)), State::new(&params))
        }
    };
    Ok(Session { rig, setup, state, real_time: args.real_time, most_ticks, device: args.device.clone() })
}

fn ticks(seconds: f64) -> Result<u64, CliError> {
    // A month.
    if !(seconds > 0.0 && seconds <= 2_678_400.0) {
        return Err(CliError::Usage(format!(
            "--seconds is {seconds}; it must be above 0 and at most 2678400 s"
        )));
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in range")]
    Ok((seconds * TICK_RATE_HZ).round().max(1.0) as u64)
}

/// A record of a run is never overwritten.
fn create(path: &std::path::Path) -> Result<File, CliError> {
    if path.metadata().is_ok_and(|found| found.is_file()) {
        return Err(CliError::Usage(format!(
            "--log is {}, which exists; give another name, or move the old log",
            path.display()
        )));
    }
    File::create(path).map_err(|problem| CliError::File { path: path.display().to_string(), problem })
}
