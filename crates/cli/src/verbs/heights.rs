//! `soilctl heights`: what height maps before and after a stroke say.

use soilctl_app::heights::{self, Answer, Request, VolumeAnswer};
use soilctl_app::text::columns;
use soilctl_app::{Answer as _, Outcome};
use soilctl_pages::heights::page;

use super::pages::PageFiles;
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Example: soilctl heights before.tif after.tif --plate-x 0.42 --plate-y 0.3 --heading 0 --strokes strokes.csv --stroke 7 --out with_crack.csv, \
    then soilctl surface with_crack.csv --delta 23. Exit codes: 0 it can be said where the ground broke, 1 it cannot. Docs: docs/how/scan.md."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    files: PageFiles,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = heights::run(&args.request, output)?;
    args.files.write(|| page(&answer), output)?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = format!("{}\n\n", self.verdict);
        let mm = |m: f64| format!("{:.2}", 1e3 * m);
        let mut rows = vec![["", "volume (l)", "sd", "at most (mm)", "cells"].map(String::from).to_vec()];
        let volume = |name: &str, of: &VolumeAnswer| {
            let litres = |m3: f64| format!("{:.4}", 1e3 * m3);
            vec![name.to_owned(), litres(of.volume_m3), litres(of.sd_m3), mm(of.most_m), of.cells.to_string()]
        };
        rows.push(volume("heap", &self.heap));
        rows.push(volume("furrow", &self.furrow));
        text += &columns(&rows);
        let shift = &self.shift;
        text += &format!(
            "\nnoise of a cell {} mm, of the profile {} mm over {} lines; the second map lies {} mm higher at the plate, tilted by {:.2} and {:.2} deg, and {} and {} mm \
             to the side\n",
            mm(self.noise_m),
            mm(self.profile.noise_m),
            self.profile.lines,
            mm(shift.up_m),
            shift.tilt_deg[0],
            shift.tilt_deg[1],
            mm(shift.sideways_m[0]),
            mm(shift.sideways_m[1])
        );
        if let Some(written) = &self.written {
            text += &format!("wrote {written}\n");
        }
        for warning in &self.warnings {
            text += &format!("\nnote: {warning}\n");
        }
        text
    }
}
