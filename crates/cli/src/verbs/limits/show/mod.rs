//! What a user sees of a solution: figures, files for other programs, and results in the answer.

mod answer;
mod contact;
mod field;
mod frame;
mod mechanism;
mod page;
mod plot;
mod trails;

use std::path::{Path, PathBuf};

pub(crate) use answer::ResultsAnswer;
pub(crate) use page::{Told, bounds_table, proven};
use soilctl_certificate::{LowerField, Statement, UpperField};
use soilctl_limit_analysis::results::{FlowResults, StressResults, Units, write_vtu};

use crate::error::CliError;
use crate::output::Output;
use crate::verbs::pages::{self, FigureFiles};
use plot::Kind;

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

    /// Writes the solution for ParaView (.vtu): velocities, stresses, dissipation, soil
    #[arg(long, value_name = "FILE", help_heading = "Figures and files")]
    vtu: Option<PathBuf>,

    /// Writes the mesh of the upper bound for gmsh (.msh)
    #[arg(long, value_name = "FILE", help_heading = "Figures and files")]
    mesh: Option<PathBuf>,
}

/// A solution to look at.
pub(crate) struct Shown {
    pub(super) flow: Option<FlowResults>,
    pub(super) stress: Option<StressResults>,
    pub(super) units: Units,
    /// What the problem is, in a few words.
    pub(super) title: String,
}

impl Shown {
    /// From the fields of a solution, each with its statement; for a factor of safety these differ in strength.
    pub(crate) fn new(
        upper: Option<(&Statement, &UpperField)>,
        lower: Option<(&Statement, &LowerField)>,
        units: Units,
        title: String,
    ) -> Result<Self, CliError> {
        Ok(Self {
            flow: upper.map(|(statement, field)| FlowResults::new(statement, field)).transpose()?,
            stress: lower.map(|(statement, field)| StressResults::new(statement, field)).transpose()?,
            units,
            title,
        })
    }
}

impl Show {
    /// Refuses names of files before anything is solved.
    pub(crate) fn check(&self) -> Result<(), CliError> {
        if let Some(path) = &self.plot {
            plot::check(path, self.plot_kind)?;
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
        self.plot.is_some() || self.vtu.is_some() || self.mesh.is_some() || self.page()
    }

    /// Whether the page is asked for, or its figures.
    fn page(&self) -> bool {
        self.report.is_some() || self.figures.figures.is_some()
    }

    /// Writes the page and its figures if they are asked for, and adds their names to those of the results.
    pub(crate) fn report(
        &self,
        shown: &Shown,
        results: &mut ResultsAnswer,
        told: Told,
        output: &Output,
    ) -> Result<(), CliError> {
        if self.page() {
            let mut page = page::page(shown, told, results)?;
            results.add_files(pages::write(&mut page, self.report.as_deref(), &self.figures, output)?);
        }
        Ok(())
    }

    /// Writes the other files that were asked for; their names as they were given.
    pub(crate) fn write(&self, shown: &Shown, output: &Output) -> Result<Vec<String>, CliError> {
        let mut files = Vec::new();
        if let Some(path) = &self.plot {
            match plot::page(path, self.plot_kind, shown)? {
                Some(mut page) => {
                    pages::write(&mut page, Some(path), &FigureFiles::default(), output)?;
                }
                None => plot::plot(path, self.plot_kind, shown)?,
            }
            files.push(path);
        }
        if let Some(path) = &self.vtu {
            let text = write_vtu(shown.flow.as_ref(), shown.stress.as_ref(), &shown.units)?;
            save(path, text.as_bytes())?;
            files.push(path);
        }
        if let Some(path) = &self.mesh {
            let Some(flow) = &shown.flow else {
                return Err(CliError::Usage(
                    "--mesh writes the mesh of the upper bound, and there is none".into(),
                ));
            };
            save(path, flow.msh().as_bytes())?;
            files.push(path);
        }
        Ok(files.into_iter().map(|path| path.display().to_string()).collect())
    }
}

fn save(path: &Path, bytes: &[u8]) -> Result<(), CliError> {
    Ok(soilctl_app::files::save(path, bytes)?)
}
