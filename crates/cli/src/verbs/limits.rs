//! What the verbs that bound collapse loads share: files to write of a solution, and words for levels and results.

use std::path::PathBuf;

use soilctl_app::files::save;
use soilctl_app::limits::{Fields, LevelAnswer, ResultsAnswer, SolveAnswer};
use soilctl_app::text::{columns, number, number_or_dash};
use soilctl_figure::HtmlReport;
use soilctl_pages::PageError;
use soilctl_pages::limits::{self, Kind};

use super::pages::{self, FigureFiles};
use crate::error::CliError;
use crate::output::Output;

/// Files to write beside the answer.
#[derive(Debug, clap::Args)]
pub(crate) struct Show {
    /// One HTML page with bounds, figures, and the failure mechanism in motion
    #[arg(long, value_name = "FILE", help_heading = "Figures and files")]
    report: Option<PathBuf>,

    #[command(flatten, next_help_heading = "Figures and files")]
    figures: FigureFiles,

    /// Draws a figure (.svg, .png, .html) or writes its data (.csv)
    #[arg(long, value_name = "FILE", help_heading = "Figures and files")]
    pub(crate) plot: Option<PathBuf>,

    /// What --plot draws
    #[arg(long, value_name = "KIND", value_enum, default_value_t = Kind::Velocity, requires = "plot",
          help_heading = "Figures and files")]
    plot_kind: Kind,

    /// Writes the solution for ParaView (.vtu): velocities, stresses, dissipation, soil; for a plate with ends, blocks and stresses in
    /// space too, in NAME.blocks.vtu and NAME.end.vtu
    #[arg(long, value_name = "FILE", help_heading = "Figures and files")]
    vtu: Option<PathBuf>,

    /// Writes the mesh of the upper bound for gmsh (.msh)
    #[arg(long, value_name = "FILE", help_heading = "Figures and files")]
    mesh: Option<PathBuf>,
}

impl Show {
    /// Refuses names of files before anything is solved.
    pub(crate) fn check(&self) -> Result<(), CliError> {
        if let Some(path) = &self.plot {
            limits::check(path, self.plot_kind)?;
        }
        for (option, path, ending) in [("vtu", &self.vtu, "vtu"), ("mesh", &self.mesh, "msh")] {
            if let Some(path) = path
                && path.extension().is_none_or(|e| e != ending)
            {
                let path = path.display();
                return Err(CliError::Usage(format!("--{option} is {path}; the name must end in .{ending}")));
            }
        }
        Ok(())
    }

    /// The first option given that shows a solution, other than --plot alone.
    pub(crate) fn of_a_solution(&self) -> Option<&'static str> {
        let given = [
            (self.report.is_some(), "--report"),
            (self.figures.figures.is_some(), "--figures"),
            (self.vtu.is_some(), "--vtu"),
            (self.mesh.is_some(), "--mesh"),
        ];
        given.into_iter().find_map(|(given, name)| given.then_some(name))
    }

    /// Whether any file is asked for.
    pub(crate) fn any(&self) -> bool {
        self.plot.is_some() || self.of_a_solution().is_some()
    }

    /// Writes the files that were asked for; their names as they were given, those of the page and its figures last.
    pub(crate) fn write(
        &self,
        fields: &Fields,
        page: impl FnOnce() -> Result<HtmlReport, PageError>,
        output: &Output,
    ) -> Result<Vec<String>, CliError> {
        if let Some(path) = &self.plot {
            limits::save(path, self.plot_kind, fields, output.command())?;
        }
        let mut in_space = Vec::new();
        if let Some(path) = &self.vtu {
            save(path, fields.vtu()?.as_bytes())?;
            for (word, text) in fields.vtu_in_space()? {
                let path = path.with_extension(format!("{word}.vtu"));
                save(&path, text.as_bytes())?;
                in_space.push(path);
            }
        }
        if let Some(path) = &self.mesh {
            save(path, fields.msh()?.as_bytes())?;
        }
        let written = [&self.plot, &self.vtu].into_iter().flatten().chain(&in_space).chain(&self.mesh);
        let mut files: Vec<String> = written.map(|path| path.display().to_string()).collect();
        if self.report.is_some() || self.figures.figures.is_some() {
            files.extend(pages::write(&mut page()?, self.report.as_deref(), &self.figures, output)?);
        }
        Ok(files)
    }
}

/// All levels as a table.
pub(crate) fn level_table(levels: &[LevelAnswer]) -> String {
    let header = ["elements", "upper", "s", "elements", "lower", "s"];
    let mut rows = vec![header.map(str::to_owned).to_vec()];
    for level in levels {
        let mut row = cells(&level.upper);
        row.extend(level.lower.as_ref().map_or_else(|| vec!["-".to_owned(); 3], cells));
        rows.push(row);
    }
    columns(&rows)
}

fn cells(solve: &SolveAnswer) -> Vec<String> {
    let seconds = solve.seconds + solve.proof_seconds;
    vec![solve.elements.to_string(), number_or_dash(solve.proven), format!("{seconds:.2}")]
}

/// What the fields show, in words.
pub(crate) fn results_text(results: &ResultsAnswer) -> String {
    let (unit, stress) = (&results.length_unit, &results.stress_unit);
    let mut text = String::new();
    for s in &results.moving_ground {
        let [a, b] = [s.from[0], s.to[0]].map(|x| number(rounded(x)));
        text += &format!("moving ground  x = {a} to {b} {unit}\n");
    }
    if !results.contacts.is_empty() {
        let header = [
            "face".to_owned(),
            format!("pressure, {stress} {unit}"),
            "shear".into(),
            format!("centre, {unit}"),
        ];
        let mut rows = vec![header.to_vec()];
        for c in &results.contacts {
            let forces = [c.normal_force, c.shear_force].map(|f| number(rounded(f)));
            let centre = c.centre.map_or_else(|| "-".into(), |x| number(rounded(x)));
            rows.push([&[c.face.clone()][..], &forces, &[centre]].concat());
        }
        text += &columns(&rows);
    }
    for file in &results.files {
        text += &format!("written: {file}\n");
    }
    text
}

/// Four digits: these numbers are not proven.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
