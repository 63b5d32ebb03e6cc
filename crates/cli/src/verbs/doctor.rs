//! `soilctl doctor`: what there is on this machine.

use soilctl_app::doctor::{self, Answer, Check, Request, What};
use soilctl_app::{Answer as _, Outcome};

use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(after_help = "Nothing of it is needed for predictions, bounds, estimates and diagnoses.")]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = doctor::run(&args.request, output)?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = String::new();
        if let Some(program) = &self.program {
            text += &format!("program: {}\n", program.display());
        }
        text += &format!("processors: {}\n", self.processors);
        for Check { what, found, detail, needed_for } in &self.checks {
            let what = match what {
                What::Browser => "browser",
                What::Viewer => "viewer",
                What::PythonPackage => "Python package",
                What::RealTime => "real time",
            };
            let found = if *found { "yes" } else { "no" };
            text += &format!("{what}: {found}, {detail} (for {needed_for})\n");
        }
        text
    }
}
