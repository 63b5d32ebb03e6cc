//! What the verbs that bound collapse loads share: files to write of a solution, and words for levels and results.

use std::path::{Path, PathBuf};

use soilctl_app::files::{can_be_written, save};
use soilctl_app::limits::{Fields, LevelAnswer, ResultsAnswer, SolveAnswer};
use soilctl_app::text::{columns, line_force_unit, moment_unit, number, number_or_dash};
use soilctl_app::{AppError, Outcome};
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

    /// Writes the solution for ParaView (.vtu): velocities, stresses, dissipation, soil; what bars and beams bear in
    /// NAME.members.vtu, and for a plate with ends, blocks and stresses in space in NAME.blocks.vtu and NAME.end.vtu
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
        for path in [&self.plot, &self.vtu, &self.mesh, &self.report].into_iter().flatten() {
            can_be_written(path)?;
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

    /// Writes the files that were asked for, all that can be written whatever becomes of others.
    pub(crate) fn write(
        &self,
        fields: &Fields,
        page: impl FnOnce() -> Result<HtmlReport, PageError>,
        output: &Output,
    ) -> Written {
        let mut written = Written::default();
        if let Some(path) = &self.plot {
            let saved = limits::save(path, self.plot_kind, fields, output.command());
            written.add(saved.map(|()| vec![named(path)]));
        }
        if let Some(path) = &self.vtu {
            written
                .add(fields.vtu().and_then(|text| save(path, text.as_bytes())).map(|()| vec![named(path)]));
            match fields.further_vtu() {
                Ok(documents) => {
                    for (word, text) in documents {
                        let path = path.with_extension(format!("{word}.vtu"));
                        written.add(save(&path, text.as_bytes()).map(|()| vec![named(&path)]));
                    }
                }
                Err(problem) => written.problems.push(problem.into()),
            }
        }
        if let Some(path) = &self.mesh {
            written
                .add(fields.msh().and_then(|text| save(path, text.as_bytes())).map(|()| vec![named(path)]));
        }
        if self.report.is_some() || self.figures.figures.is_some() {
            let page = page().map_err(CliError::from);
            written.add(
                page.and_then(|mut page| {
                    pages::write(&mut page, self.report.as_deref(), &self.figures, output)
                }),
            );
        }
        written
    }
}

fn named(path: &Path) -> String {
    path.display().to_string()
}

/// What became of files beside an answer, which is given in any case.
#[derive(Debug, Default)]
pub(crate) struct Written {
    /// Names of those that were written, as they were given, a page and its figures last.
    pub(crate) files: Vec<String>,
    problems: Vec<CliError>,
}

impl Written {
    fn add<E: Into<CliError>>(&mut self, files: Result<Vec<String>, E>) {
        match files {
            Ok(files) => self.files.extend(files),
            Err(problem) => self.problems.push(problem.into()),
        }
    }

    /// Also what is wrong with the solution, or with the file for it.
    pub(crate) fn with_solution(mut self, problem: Option<AppError>) -> Self {
        self.problems.splice(0..0, problem.map(CliError::from));
        self
    }

    /// How the verb ends once its answer is out.
    ///
    /// # Errors
    /// The last file that could not be written; the others are told of before.
    pub(crate) fn end(mut self, outcome: Outcome, output: &Output) -> Result<Outcome, CliError> {
        let last = self.problems.pop();
        self.problems.iter().for_each(|problem| output.problem(&problem.to_string()));
        last.map_or(Ok(outcome), Err)
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
    let unit = &results.length_unit;
    let force = line_force_unit(&results.stress_unit, unit);
    let mut text = String::new();
    for s in &results.moving_ground {
        let [a, b] = [s.from[0], s.to[0]].map(|x| number(rounded(x)));
        text += &format!("moving ground  x = {a} to {b} {unit}\n");
    }
    if !results.contacts.is_empty() {
        let header =
            ["face".to_owned(), format!("pressure, {force}"), "shear".into(), format!("centre, {unit}")];
        let mut rows = vec![header.to_vec()];
        for c in &results.contacts {
            let forces = [c.normal_force, c.shear_force].map(|f| number(rounded(f)));
            let centre = c.centre.map_or_else(|| "-".into(), |x| number(rounded(x)));
            rows.push([&[c.face.clone()][..], &forces, &[centre]].concat());
        }
        text += &columns(&rows);
    }
    if !results.members.is_empty() {
        let header = [
            "member".to_owned(),
            format!("bears, {force}"),
            "greatest tension".into(),
            "used, %".into(),
            "yields".into(),
        ];
        let mut rows = vec![header.to_vec()];
        for m in &results.members {
            let known = |x: Option<f64>| x.map_or_else(|| "-".into(), |x| number(rounded(x)));
            rows.push(vec![
                m.name.clone(),
                number(rounded(m.tensile_strength)),
                known(m.greatest_tension),
                known(m.utilisation.map(|used| 100.0 * used)),
                m.yields().to_owned(),
            ]);
        }
        text += &columns(&rows);
        text += &beams(results);
    }
    for file in &results.files {
        text += &format!("written: {file}\n");
    }
    text
}

/// How beams bend.
fn beams(results: &ResultsAnswer) -> String {
    let bent: Vec<_> = results.members.iter().filter_map(|m| Some((m, m.bending.as_ref()?))).collect();
    if bent.is_empty() {
        return String::new();
    }
    let unit = moment_unit(&results.stress_unit, &results.length_unit);
    let header = [
        "beam".to_owned(),
        format!("bears, {unit}"),
        "moment".into(),
        format!("at, {}", results.length_unit),
        "shear".into(),
        "hinges at".into(),
    ];
    let mut rows = vec![header.to_vec()];
    for (member, bending) in bent {
        let known = |x: Option<f64>| x.map_or_else(|| "-".into(), |x| number(rounded(x)));
        let hinges: Vec<String> = bending.hinges.iter().map(|[at, _]| number(rounded(*at))).collect();
        rows.push(vec![
            member.name.clone(),
            number(rounded(bending.moment_strength)),
            known(bending.greatest_moment),
            known(bending.greatest_moment_at),
            known(bending.greatest_shear),
            if hinges.is_empty() { "-".to_owned() } else { hinges.join(" ") },
        ]);
    }
    columns(&rows)
}

/// Four digits: these numbers are not proven.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
