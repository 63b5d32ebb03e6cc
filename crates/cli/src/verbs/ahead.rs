//! `soilctl ahead LOG...`: whether something is buried ahead of strokes.

use std::path::PathBuf;

use soilctl_app::ahead::{self, AlarmAnswer, Answer, Request};
use soilctl_app::files::can_be_written;
use soilctl_app::text::{columns, number};
use soilctl_app::{Answer as _, Outcome};
use soilctl_pages::ahead as pages;

use super::pages::PageFiles;
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Strokes should go on for two depths of the plate and more after the soil has failed. Example: soilctl ahead field --reference proving_ground --plot ahead.svg. \
    Exit code 3: some strokes cannot be judged, or logs are damaged. Docs: docs/how/obstacles.md."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    /// Draws the forces over what the soil explains (.svg, .png) or writes their data (.csv)
    #[arg(long, value_name = "FILE", help_heading = "Figures and files")]
    plot: Option<PathBuf>,

    #[command(flatten)]
    files: PageFiles,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    if let Some(path) = &args.plot {
        can_be_written(path)?;
    }
    let answer = ahead::run(&args.request, output)?;
    output.answer(&answer)?;
    if let Some(path) = &args.plot {
        pages::save(&answer, path)?;
    }
    args.files.write(|| pages::page(&answer), output)?;
    Ok(answer.outcome())
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = format!("{}\n\n", self.verdict);
        let header = [
            "stroke",
            "depth mm",
            "watched mm",
            "compared",
            "verdict",
            "at mm",
            "ratio",
            "ahead mm",
            "top mm",
        ];
        let mut rows = vec![header.map(str::to_owned).to_vec()];
        let mm = |m: f64| format!("{:.1}", 1e3 * m);
        for stroke in &self.strokes {
            let dash = || "-".to_owned();
            let alarm = stroke.alarm.as_ref();
            rows.push(vec![
                stroke.stroke_id.clone(),
                mm(stroke.depth_m),
                stroke.looks.last().map_or_else(dash, |look| mm(look.way_m)),
                stroke.references.to_string(),
                stroke.verdict.name().to_owned(),
                alarm.map_or_else(dash, |alarm| mm(alarm.way_m)),
                alarm.map_or_else(dash, |alarm| {
                    let [low, high] = alarm.ratio_range;
                    format!("{:.2} ({low:.2} to {high:.2})", alarm.ratio)
                }),
                alarm.map_or_else(dash, ahead),
                alarm
                    .and_then(|alarm| alarm.last_region.as_ref()?.top_m)
                    .map_or_else(dash, |[from, to]| format!("{:.0} to {:.0}", 1e3 * from, 1e3 * to)),
            ]);
        }
        text += &columns(&rows);
        for stroke in &self.strokes {
            if let Some(reason) = &stroke.reason {
                text += &format!("{} is not judged: {reason}\n", stroke.stroke_id);
            }
        }
        for problem in &self.problems {
            text += &format!("problem: {problem}\n");
        }
        let [from, to] = self.phi_deg.map(number);
        text += &format!(
            "false alarms: {} % of strokes with nothing ahead; regions: {} % of blocks, friction angle {from} to {to} deg\n",
            number(100.0 * self.false_alarms),
            number(100.0 * self.confidence)
        );
        for note in &self.notes {
            text += &format!("note: {note}\n");
        }
        text
    }
}

/// Distances still ahead at the last look.
fn ahead(alarm: &AlarmAnswer) -> String {
    let Some(region) = &alarm.last_region else { return "-".to_owned() };
    match region.ahead_m {
        None => "no block".to_owned(),
        Some([from, to]) => {
            let more = if region.is_open { " and more" } else { "" };
            format!("{:.0} to {:.0}{more}", 1e3 * from, 1e3 * to)
        }
    }
}
