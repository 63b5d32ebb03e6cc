//! Packages of the system, installed by apt-get.

use crate::error::XtaskError;
use crate::run::Step;
use crate::workspace::on_path;

/// Installs packages; `what` names the thing that is missing.
pub(crate) fn install(step: &str, what: &str, packages: &[&str]) -> Result<(), XtaskError> {
    let by_hand = format!("install it by hand (Debian: `apt-get install {}`)", packages.join(" "));
    let missing = |why: &str| XtaskError::Missing {
        step: step.to_owned(),
        what: format!("{what} is missing and {why}"),
        remedy: by_hand.clone(),
    };
    if !on_path("apt-get") {
        return Err(missing("there is no apt-get"));
    }
    let root = is_root();
    if !root && !on_path("sudo") {
        return Err(missing("apt-get needs root, but there is no sudo"));
    }
    apt_get(step, root).args(["update"]).run()?;
    apt_get(step, root).args(["install", "--yes", "--no-install-recommends"]).args(packages).run()
}

/// Non-interactive apt-get that waits for another one to finish. `env` carries the setting through sudo.
fn apt_get(step: &str, root: bool) -> Step {
    let words = [
        "env",
        "DEBIAN_FRONTEND=noninteractive",
        "apt-get",
        "-o",
        "DPkg::Lock::Timeout=300",
        "-o",
        "Acquire::Retries=3",
    ];
    if root {
        Step::new(step, words[0]).args(&words[1..])
    } else {
        Step::new(step, "sudo").args(["-n"]).args(words)
    }
}

fn is_root() -> bool {
    Step::new("who am I", "sh").args(["-c", "test \"$(id -u)\" = 0"]).succeeds()
}
