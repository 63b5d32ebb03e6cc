//! What there is on this machine that soilctl can use.

use std::path::PathBuf;
use std::process::{Command, Stdio};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::{AppError, Watch};

/// Tells what is there: browser, viewer, Python package, real-time rights.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
pub struct Request {}

/// What is there, and what for.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Answer {
    /// The program that answers.
    pub program: Option<PathBuf>,
    /// Processors that work is shared out to.
    pub processors: usize,
    /// What was looked for, in order.
    pub checks: Vec<Check>,
}

/// Something that was looked for. Nothing of it is needed for predictions, bounds, estimates and diagnoses.
#[derive(Debug, Serialize, JsonSchema)]
pub struct Check {
    /// What.
    pub what: What,
    /// Whether it is there.
    pub found: bool,
    /// Where it is, or how to get it.
    pub detail: String,
    /// What it is needed for.
    pub needed_for: &'static str,
}

/// What is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum What {
    /// A way to open pages in a browser.
    Browser,
    /// Rerun's viewer.
    Viewer,
    /// The Python package `soilctl`.
    PythonPackage,
    /// The right to run threads in real time.
    RealTime,
}

impl crate::Answer for Answer {
    const SCHEMA: &'static str = "soilctl.doctor/1";
}

/// Looks around; nothing is changed.
///
/// # Errors
/// None: what is not there is an answer.
pub fn run(_request: &Request, _watch: &dyn Watch) -> Result<Answer, AppError> {
    Ok(Answer {
        program: std::env::current_exe().ok(),
        processors: std::thread::available_parallelism().map_or(1, usize::from),
        checks: vec![browser(), viewer(), python_package(), real_time()],
    })
}

/// The programs that open a page, one of which is enough.
const OPENERS: &[&str] = if cfg!(target_os = "macos") {
    &["open"]
} else if cfg!(windows) {
    &["explorer"]
} else {
    &["xdg-open", "gio", "gnome-open", "kde-open", "wslview"]
};

fn browser() -> Check {
    let opener = OPENERS.iter().find_map(|name| on_path(name));
    Check {
        what: What::Browser,
        found: opener.is_some(),
        detail: opener.map_or_else(
            || format!("none of {} is on the path; open the written pages by hand", OPENERS.join(", ")),
            |path| path.display().to_string(),
        ),
        needed_for: "--open of report, demo and monitor",
    }
}

fn viewer() -> Check {
    let rerun = on_path("rerun");
    Check {
        what: What::Viewer,
        found: rerun.is_some(),
        detail: rerun.map_or_else(
            || "rerun is not on the path; pip install rerun-sdk".to_owned(),
            |path| path.display().to_string(),
        ),
        needed_for: "view, which else writes the recording only",
    }
}

fn python_package() -> Check {
    let python = ["python3", "python"].into_iter().find_map(on_path);
    let version = python.as_ref().and_then(|python| {
        let mut asked = Command::new(python);
        asked.args(["-c", "import soilctl; print(soilctl.__version__)"]).stdin(Stdio::null());
        let answer = asked.output().ok().filter(|answer| answer.status.success())?;
        Some(String::from_utf8_lossy(&answer.stdout).trim().to_owned())
    });
    let detail = match (&version, &python) {
        (Some(version), Some(python)) => format!("{version}, of {}", python.display()),
        (_, Some(python)) => format!("{} cannot import soilctl; install the wheel there", python.display()),
        (_, None) => "there is no Python on the path".to_owned(),
    };
    Check {
        what: What::PythonPackage,
        found: version.is_some(),
        detail,
        needed_for: "notebooks and scripts in Python",
    }
}

fn real_time() -> Check {
    let may = soilctl_live::may_run_in_real_time();
    Check {
        what: What::RealTime,
        found: may,
        detail: if may {
            "threads may have real-time priority".to_owned()
        } else {
            "no right to real-time priority; on Linux root has it, and users whom /etc/security/limits.conf gives rtprio".to_owned()
        },
        needed_for: "run --real-time on a real arm; without it ticks come late more often, which is counted",
    }
}

/// Where a program is that the shell would start.
fn on_path(name: &str) -> Option<PathBuf> {
    let file = format!("{name}{}", std::env::consts::EXE_SUFFIX);
    std::env::split_paths(&std::env::var_os("PATH")?)
        .map(|folder| folder.join(&file))
        .find(|path| path.is_file())
}
