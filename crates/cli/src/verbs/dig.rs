//! `soilctl dig`: a page on which the plate of a simulated session is dragged through soil.

use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::atomic::Ordering;
use std::time::Duration;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_app::Outcome;
use soilctl_monitor::{Dig, DigSettings, Settings};

use super::serve;
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Prints the page's address, which carries a token, serves it, and ends at Ctrl-C. The session keeps to the wall clock. \
    Each soil that is chosen on the page begins a session with a log of its own, which `soilctl log`, `process` and `replay` read as any \
    other. Nobody beyond this machine reaches the page unless --listen says so. Exit codes: 2 no session could be begun; 3 a log is not \
    complete. docs/dig.md tells keys, limits and the frames of devices."
)]
pub(crate) struct Args {
    /// The soil that is dug first: ticino_rained, ticino_loose, nevada_fine, glass_beads, one of mars_drift, mars_crusty, mars_blocky,
    /// mars_pathfinder, or moon_0_15cm, under the gravity of the place
    #[arg(long, value_name = "NAME", default_value = "ticino_rained")]
    soil: String,

    /// The log to write (.mcap); a file that is there is not touched, the log gets a number then
    #[arg(long, value_name = "PATH", default_value = "dig.mcap")]
    log: PathBuf,

    /// Unix socket for operators, to be made [default: in a folder of its own]
    #[arg(long, value_name = "PATH")]
    socket: Option<PathBuf>,

    /// Unix socket for a device that leads the plate and feels its force 500 times a second, to be made
    #[arg(long, value_name = "PATH")]
    device: Option<PathBuf>,

    /// Seed of noise and scatter
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,

    /// Where to listen; port 0 takes any free one
    #[arg(long, value_name = "ADDRESS:PORT", default_value = "127.0.0.1:8470")]
    listen: SocketAddr,

    /// A further host name by which the page may be opened; addresses and localhost need none
    #[arg(long, value_name = "NAME")]
    host: Vec<String>,

    /// Open the page in the browser
    #[arg(long)]
    open: bool,
}

/// Where the page is served.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct DigAnswer {
    /// Address of the page, with the token.
    url: String,
    /// Where it listens.
    listen: String,
    /// Where operators connect.
    socket: String,
    /// Where a device may connect; null if nowhere.
    device: Option<String>,
}

impl soilctl_app::Answer for DigAnswer {
    const SCHEMA: &'static str = "soilctl.dig/1";
}

impl Words for DigAnswer {
    fn text(&self) -> String {
        format!("{}\n", self.url)
    }
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let signalled = serve::signalled()?;
    let notes = output.notes();
    let settings = Settings {
        listen: args.listen,
        hosts: args.host.clone(),
        commands: true,
        note: Box::new(move |text| notes.note(text)),
    };
    // Kept as long as the sessions.
    let folder = tempfile::Builder::new().prefix("soilctl-dig-").tempdir()?;
    let socket = args.socket.clone().unwrap_or_else(|| folder.path().join("live"));
    let dig = DigSettings {
        soil: args.soil.clone(),
        seed: args.seed,
        log: args.log.clone(),
        socket: socket.clone(),
        device: args.device.clone(),
    };
    let dig = Dig::start(dig, settings)?;
    let address = dig.address();
    if !address.ip().is_loopback() {
        let port = address.port();
        output.note(&format!(
            "warning: everybody who reaches port {port} of this machine can see the page, at the machine's address instead of this one's"
        ));
    }
    let answer = DigAnswer {
        url: dig.url(),
        listen: address.to_string(),
        socket: socket.display().to_string(),
        device: args.device.as_ref().map(|path| path.display().to_string()),
    };
    output.answer(&answer)?;
    output.note("Ctrl-C ends");
    let opened = args.open.then(|| serve::open_page(&answer.url, true));
    if matches!(opened, Some(Err(_))) {
        output.note("no browser could be started; open the address by hand");
    }
    while !signalled.load(Ordering::Relaxed) && !dig.is_over() {
        std::thread::sleep(Duration::from_millis(50));
    }
    let (dug, counts) = dig.stop();
    output.note(&format!(
        "pages: {}, refused: {}, messages left out for slow pages: {}",
        counts.pages, counts.refused, counts.dropped
    ));
    for session in &dug {
        output.note(&format!("{}: {}, {} steps", session.log.display(), session.soil, session.steps));
        session.problems.iter().for_each(|problem| output.note(&format!("warning: {problem}")));
    }
    let whole = dug.iter().all(|session| session.problems.is_empty());
    Ok(if whole { Outcome::Done } else { Outcome::Partial })
}
