//! `soilctl arm`: what the arm and its controller's settings are like, without moving anything.

use std::path::PathBuf;

use clap::Subcommand;
use soilctl_app::Outcome;
use soilctl_app::arm::{skewing, urdf};
use soilctl_app::text::columns;
use soilctl_figure::Size;
use soilctl_pages::save_figure;

use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Without --arm the arm is that of the thesis, without --controller the settings are those that soilctl brings \
    along."
)]
pub(crate) struct Args {
    #[command(subcommand)]
    action: Action,
}

#[derive(Debug, Subcommand)]
enum Action {
    /// By how much joint springs turn the plate's force away from where the plate is to go, and Cartesian springs do not
    Skewing {
        #[command(flatten)]
        request: skewing::Request,

        /// Draws a figure (.svg, .png) or writes its data (.csv)
        #[arg(long, value_name = "FILE")]
        plot: Option<PathBuf>,
    },
    /// Prints the arm as a URDF, for viewers and ROS tools
    Urdf(urdf::Request),
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    match &args.action {
        Action::Skewing { request, plot } => {
            let found = skewing::run(request, output)?;
            if let Some(path) = plot {
                save_figure(&soilctl_pages::arm::skewing(&found)?, path, Size::default())?;
            }
            output.answer(&found.answer)?;
        }
        Action::Urdf(request) => output.answer(&urdf::run(request, output)?)?,
    }
    Ok(Outcome::Done)
}

impl Words for urdf::Answer {
    fn text(&self) -> String {
        self.urdf.clone()
    }
}

impl Words for skewing::Answer {
    fn text(&self) -> String {
        let head = ["radius m", "error deg", "PID deg", "stiffness deg"].map(String::from).to_vec();
        let rows = self.rows.iter().map(|row| {
            vec![
                format!("{:.4}", row.radius_m),
                format!("{:.0}", row.error_deg),
                format!("{:.1}", row.pid_deg),
                format!("{:.0e}", row.stiffness_deg.abs()),
            ]
        });
        let table = columns(&std::iter::once(head).chain(rows).collect::<Vec<_>>());
        format!(
            "From the tip's error to the force that answers it; errors point outwards (0 deg) to upwards (90 deg).\n\n{table}\n\
             all around: up to {:.1} deg under the joint PID, {:.0e} deg under Cartesian stiffness\n",
            self.worst_pid_deg, self.worst_stiffness_deg
        )
    }
}
