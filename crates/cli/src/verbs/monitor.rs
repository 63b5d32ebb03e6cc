//! `soilctl monitor`: a page that shows a live session or a log in 3-D.

use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::atomic::Ordering;
use std::time::Duration;

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_app::Outcome;
use soilctl_app::request::finite;
use soilctl_monitor::{Monitor, Settings, Source};

use super::serve;
use crate::bag_args::BagArgs;
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Prints the page's address, serves it, and ends at Ctrl-C. Nobody beyond this machine reaches it unless --listen \
    says so. With --commands the address carries a token; whoever has it may do to the arm what `soilctl console` does. \
    Of a recording of another program the joint states move the arm of the URDF in it, or of --urdf. Exit code 3: the log is \
    damaged, and what can be read is played. docs/monitor.md tells keys, messages and limits."
)]
pub(crate) struct Args {
    /// Socket of a running session
    #[arg(long, value_name = "PATH", required_unless_present = "play", conflicts_with = "play")]
    connect: Option<PathBuf>,

    /// A log to play (.mcap), or a recording of any program (.mcap, .db3, .bag, or the folder of a bag)
    #[arg(long, value_name = "LOG")]
    play: Option<PathBuf>,

    /// Where a played log begins (s)
    #[arg(long, value_name = "S", default_value_t = 0.0, value_parser = finite, requires = "play")]
    from: f64,

    #[command(flatten)]
    bag: BagArgs,

    /// Where to listen; port 0 takes any free one
    #[arg(long, value_name = "ADDRESS:PORT", default_value = "127.0.0.1:8470")]
    listen: SocketAddr,

    /// A further host name by which the page may be opened; addresses and localhost need none
    #[arg(long, value_name = "NAME")]
    host: Vec<String>,

    /// Let pages that know the token operate the session
    #[arg(long, requires = "connect", conflicts_with = "play")]
    commands: bool,

    /// Open the page in the browser
    #[arg(long)]
    open: bool,
}

/// Where a monitor serves.
#[derive(Debug, Serialize, JsonSchema)]
pub(crate) struct MonitorAnswer {
    /// Address of the page, with the token if commands are on.
    url: String,
    /// Where it listens.
    listen: String,
    /// Whether pages that know the token may send commands.
    commands: bool,
    /// What is wrong with the log that is played; it is left out.
    damage: Vec<String>,
    /// What was odd about another program's recording, or could not be used, such as meshes that are not at hand.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    notes: Vec<String>,
}

impl soilctl_app::Answer for MonitorAnswer {
    const SCHEMA: &'static str = "soilctl.monitor/1";
}

impl Words for MonitorAnswer {
    fn text(&self) -> String {
        format!("{}\n", self.url)
    }
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let source = match (&args.connect, &args.play) {
        (Some(socket), _) => Source::Session(socket.clone()),
        (None, Some(log)) => Source::Log { path: log.clone(), from_s: args.from, bag: args.bag.settings()? },
        (None, None) => return Err(CliError::Usage("give --connect or --play".to_owned())),
    };
    let signalled = serve::signalled()?;
    let notes = output.notes();
    let settings = Settings {
        listen: args.listen,
        hosts: args.host.clone(),
        commands: args.commands,
        note: Box::new(move |text| notes.note(text)),
    };
    let spinner = output.spinner(if args.play.is_some() { "reading the log" } else { "connecting" });
    let monitor = Monitor::start(source, settings);
    spinner.finish_and_clear();
    let monitor = monitor?;
    let address = monitor.address();
    if !address.ip().is_loopback() {
        let port = address.port();
        output.note(&format!(
            "warning: everybody who reaches port {port} of this machine can see the page, at the machine's address instead of this one's"
        ));
    }
    let damage = monitor.damage().to_vec();
    for what in &damage {
        output.note(&format!("damaged: {what}"));
    }
    let notes = monitor.notes().to_vec();
    for note in &notes {
        output.note(note);
    }
    let outcome = if damage.is_empty() { Outcome::Done } else { Outcome::Partial };
    let answer = MonitorAnswer {
        url: monitor.url(),
        listen: address.to_string(),
        commands: args.commands,
        damage,
        notes,
    };
    output.answer(&answer)?;
    output.note("Ctrl-C ends");
    // Kept as long as the monitor.
    let opened = args.open.then(|| serve::open_page(&answer.url, args.commands));
    if matches!(opened, Some(Err(_))) {
        output.note("no browser could be started; open the address by hand");
    }
    while !signalled.load(Ordering::Relaxed) {
        std::thread::sleep(Duration::from_millis(50));
    }
    let counts = monitor.stop();
    output.note(&format!(
        "pages: {}, refused: {}, messages left out for slow pages: {}",
        counts.pages, counts.refused, counts.dropped
    ));
    Ok(outcome)
}
