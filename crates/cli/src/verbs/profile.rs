//! `soilctl profile`: whether the ground changes with depth.

use soilctl_app::profile::{self, Answer, Request};
use soilctl_app::text::{columns, number, range, yes};
use soilctl_app::{Answer as _, Outcome};
use soilctl_pages::profile::page;

use super::pages::PageFiles;
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Make the same strokes (tool angles, width) at two depths or more. Example: soilctl profile strokes.csv --delta 23 --report profile.html. \
    Exit codes: 0 some ground explains the strokes, 1 none does. Docs: docs/how/with-depth.md."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    files: PageFiles,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = profile::run(&args.request, output)?;
    args.files.write(|| page(&answer), output)?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = format!("{}\n\n", self.verdict);
        let heading = [
            "ground",
            "explains",
            "phi top (deg)",
            "phi bottom (deg)",
            "density top (kg/m3)",
            "density bottom",
            "step (mm)",
            "p",
        ];
        let mut rows = vec![heading.map(String::from).to_vec()];
        for one in &self.hypotheses {
            rows.push(vec![
                one.kind.name().into(),
                yes(one.consistent).into(),
                range(one.ranges.map(|r| r.phi_top_deg), 1),
                range(one.ranges.map(|r| r.phi_bottom_deg), 1),
                range(one.ranges.map(|r| r.density_top_kg_m3), 0),
                range(one.ranges.map(|r| r.density_bottom_kg_m3), 0),
                range(one.step_m.map(|step| step.map(|m| 1e3 * m)), 0),
                one.p.map_or_else(|| "-".into(), |p| format!("{p:.1e}")),
            ]);
        }
        text += &columns(&rows);
        text += "\nmeasurements: density times coefficient, the same at all depths in one soil for one tool angle\n";
        let mut rows = vec![
            ["stroke", "depth (mm)", "force (N)", "band (N)", "2F/(g w L2) (kg/m3)"]
                .map(String::from)
                .to_vec(),
        ];
        for stroke in &self.strokes {
            rows.push(vec![
                stroke.label.clone(),
                format!("{:.1}", 1e3 * stroke.depth_m),
                number((1e3 * stroke.force_n).round() / 1e3),
                range(Some(stroke.band_n), 2),
                range(Some(stroke.normalised_band_kg_m3), 0),
            ]);
        }
        text += &columns(&rows);
        for warning in &self.warnings {
            text += &format!("\nnote: {warning}\n");
        }
        text
    }
}
