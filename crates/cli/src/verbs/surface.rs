//! `soilctl surface`: what the crack ahead of the plate says.

use soilctl_app::surface::{self, Answer, Request};
use soilctl_app::text::{columns, range};
use soilctl_app::{Answer as _, Outcome};
use soilctl_pages::surface::page;

use super::pages::PageFiles;
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "The columns break_distance_m and break_distance_sd_m hold the distance along the surface from the plate's face to where the ground broke. \
    Example: soilctl surface strokes.csv --delta 23 --report surface.html. Exit codes: 0 surface and forces agree by some model, 1 by none. \
    Docs: docs/how/crack.md."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    files: PageFiles,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = surface::run(&args.request, output)?;
    args.files.write(|| page(&answer), output)?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = format!("{}\n\n", self.verdict);
        let mut rows = vec![
            ["model of the surface", "phi (deg)", "with forces", "density (kg/m3)"]
                .map(String::from)
                .to_vec(),
        ];
        for said in &self.models {
            rows.push(vec![
                said.surface.name().into(),
                range(said.phi_deg, 2),
                range(said.phi_both_deg, 2),
                range(said.density_both_kg_m3, 0),
            ]);
        }
        text += &columns(&rows);
        text += "\nbreak distances (mm), and what models predict\n";
        let mut heading = vec!["stroke".to_owned(), "measured".into(), "sd".into()];
        heading.extend(self.models.iter().map(|said| said.surface.name().to_owned()));
        let mut rows = vec![heading];
        for stroke in &self.strokes {
            let mm = |m: f64| format!("{:.1}", 1e3 * m);
            let mut row = vec![stroke.label.clone(), mm(stroke.distance_m), mm(stroke.sd_m)];
            row.extend(stroke.predicted_m.iter().map(|p| range(p.map(|p| p.map(|m| 1e3 * m)), 1)));
            rows.push(row);
        }
        text += &columns(&rows);
        for warning in &self.warnings {
            text += &format!("\nnote: {warning}\n");
        }
        text
    }
}
