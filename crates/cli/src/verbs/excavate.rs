//! `soilctl excavate`: a trench in passes at least cost to the motors.

use std::path::PathBuf;

use soilctl_app::excavate::{self, Answer, Becomes, Ended, Learned, Manner, Request};
use soilctl_app::text::{columns, range};
use soilctl_app::{Answer as _, Outcome};
use soilctl_figure::Size;
use soilctl_pages::excavate::{forces, page};
use soilctl_pages::save_figure;

use super::pages::PageFiles;
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "What is possible of the soil is told by --phi, --delta and --density, or by the estimate of --strokes; without them it is the soil \
    of the box. Examples: soilctl excavate --soil nevada_fine --dig; soilctl excavate --soil ticino_rained --phi 38,46 --delta 20,26 --density \
    1500,1700 --share 0.4 --dig --report trench.html; soilctl excavate --out trench, then soilctl simulate trench/plan.toml --out logs. Exit codes: \
    0 done, 3 the trench is not as deep as wanted. Docs: docs/how/dig-well.md."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    /// Draws the forces that the soil bears by their inclination (.svg, .png) or writes their data (.csv)
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,

    #[command(flatten)]
    files: PageFiles,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = excavate::run(&args.request, output)?;
    if let Some(path) = &args.plot {
        save_figure(&forces(&answer)?, path, Size::default())?;
    }
    args.files.write(|| page(&answer), output)?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = format!(
            "{}\n\nsoils that are possible: phi {} deg, delta {} deg, density {} kg/m3\n",
            self.verdict,
            range(Some(self.phi_deg), 1),
            range(Some(self.delta_deg), 1),
            range(Some(self.density_kg_m3), 0)
        );
        let [alpha_deg, depth_m] = self.at;
        text += &format!(
            "\nforces at {alpha_deg:.1} deg and {:.1} mm, by their inclination to the plate's normal\n\n",
            1e3 * depth_m
        );
        text += &columns(&force_rows(self));
        text +=
            "\ntool angles at that depth, in the strongest soil, with the heap that the stroke pushes\n\n";
        text += &columns(&angle_rows(self));
        if !self.passes.is_empty() {
            text += "\npasses as they are planned\n\n";
            let head = ["pass", "alpha (deg)", "depth (mm)", "force (N)", "torque (%)"];
            let mut rows = vec![head.map(String::from).to_vec()];
            for (i, pass) in (1..).zip(&self.passes) {
                rows.push(vec![
                    i.to_string(),
                    format!("{:.1}", pass.alpha_deg),
                    format!("{:.1}", 1e3 * pass.depth_m),
                    format!("{:.2}", pass.fails_n),
                    format!("{:.0}", 100.0 * pass.share),
                ]);
            }
            text += &columns(&rows);
        }
        for dug in &self.dug {
            text += &format!("\n{}: {}\n\n", manner(dug.manner), ended(dug.ended));
            text += &columns(&dug_rows(dug));
        }
        for file in &self.files {
            text += &format!("\nwritten: {file}\n");
        }
        for warning in &self.warnings {
            text += &format!("\nnote: {warning}\n");
        }
        text
    }
}

fn or_dash(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(|| "-".into(), |value| format!("{value:.digits$}"))
}

fn force_rows(answer: &Answer) -> Vec<Vec<String>> {
    let head = ["inclination (deg)", "plate", "bears (N)", "fails (N)", "torque (%)"];
    let mut rows = vec![head.map(String::from).to_vec()];
    for row in &answer.forces {
        let plate = match row.plate {
            Becomes::Sticks => "sticks",
            Becomes::Open => "sticks or slips",
            Becomes::SlipsUp => "slips up",
            Becomes::Dives => "dives",
        };
        rows.push(vec![
            format!("{:.1}", row.inclination_deg),
            plate.into(),
            or_dash(row.bears_n, 2),
            or_dash(row.fails_n, 2),
            or_dash(row.share.map(|share| 100.0 * share), 0),
        ]);
    }
    rows
}

fn angle_rows(answer: &Answer) -> Vec<Vec<String>> {
    let head = ["alpha (deg)", "bears (N)", "fails (N)", "torque (%)", "heat (A2)", "work (kJ/m3)"];
    let mut rows = vec![head.map(String::from).to_vec()];
    for row in &answer.angles {
        rows.push(vec![
            format!("{:.1}", row.alpha_deg),
            or_dash(row.bears_n, 2),
            format!("{:.2}", row.fails_n),
            format!("{:.1}", 100.0 * row.share),
            format!("{:.0}", row.heat_a2),
            format!("{:.2}", row.work_kj_m3),
        ]);
    }
    rows
}

fn dug_rows(dug: &soilctl_app::excavate::DugTrench) -> Vec<Vec<String>> {
    let head = [
        "pass",
        "alpha (deg)",
        "depth (mm)",
        "way (mm)",
        "force (N)",
        "planned (%)",
        "torque (%)",
        "work (J)",
        "heat (A2 s)",
        "phi (deg)",
        "taught",
    ];
    let mut rows = vec![head.map(String::from).to_vec()];
    for (i, pass) in (1..).zip(&dug.passes) {
        let learned = match pass.learned {
            Learned::Region => "yes",
            Learned::Contradicts => "contradicts",
            Learned::Known => "known",
            Learned::NoFailure => "no failure seen",
            Learned::Heap => "heap",
            Learned::OutsideModel => "outside model",
            Learned::NotAsked => "-",
        };
        rows.push(vec![
            i.to_string(),
            format!("{:.1}", pass.planned.alpha_deg),
            format!("{:.1}", 1e3 * pass.depth_m[0]),
            format!("{:.1}", 1e3 * pass.travel_m),
            format!("{:.2}", pass.peak_force_n),
            format!("{:.0}", 100.0 * pass.planned.share),
            format!("{:.0}, {:.0}", 100.0 * pass.peak_share[0], 100.0 * pass.peak_share[1]),
            format!("{:.2}", pass.work_j),
            format!("{:.0}", pass.heat_a2s),
            range(Some(pass.phi_deg), 1),
            learned.into(),
        ]);
    }
    rows
}

fn manner(manner: Manner) -> &'static str {
    match manner {
        Manner::Learning => "dug, replanned by what each pass taught",
        Manner::Planned => "dug as planned, without learning",
        Manner::Fixed => "the same passes at a fixed tool angle of 90 deg",
    }
}

fn ended(ended: Ended) -> &'static str {
    match ended {
        Ended::Complete => "as deep as wanted",
        Ended::TooStrong => "given up, since no pass keeps the share",
        Ended::StrokeFailed => "a stroke failed",
        Ended::TooManyPasses => "too many passes",
        Ended::Stopped => "broken off",
    }
}
