//! `soilctl tool TOOL`: proven bounds on the force of a tool that need not be flat.

use std::path::PathBuf;

use soilctl_app::files::can_be_written;
use soilctl_app::text::{columns, number, number_or_dash};
use soilctl_app::tool::{self, Answer, EndsAnswer, ForcesAnswer, Request, TableAnswer, ToolAnswer};
use soilctl_app::{Answer as _, Outcome};

use super::limits::{Show, level_table, results_text};
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Forces are along the motion, per metre of width, of a tool without ends. With --width they are of the whole tool with its ends, and with side plates if its file has \
    them (side_plates = true, or side_plates_m with the corners of their outline). Coefficients are 2 F / (gamma L^2) with \
    the straight line from the tip to the surface as L. Both bounds are proven with interval arithmetic; the true force of the rigid-plastic \
    soil with associated flow lies between them. Tool files are in docs/files.md, examples in data/tools. Exit code 3: the budget ended before \
    the gap was reached. Ctrl-C or SIGTERM ends the run with the best bounds so far."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    show: Show,

    /// Draws the forces of --forces (.svg, .png, .html) or writes their data (.csv)
    #[arg(long, value_name = "FILE", requires = "forces", help_heading = "Figures and files")]
    forces_plot: Option<PathBuf>,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    args.show.check()?;
    args.forces_plot.as_deref().map_or(Ok(()), can_be_written)?;
    let mut found = tool::run(&args.request, output)?;
    let mut written = args.show.write(&found.solved.fields, || soilctl_pages::tool::page(&found), output);
    found.answer.results.files = std::mem::take(&mut written.files);
    output.answer(&found.answer)?;
    if let (Some(path), Some(forces)) = (&args.forces_plot, &found.answer.forces) {
        soilctl_pages::tool::save_forces(forces, path)?;
    }
    written.with_solution(found.solved.unsaved).end(found.answer.outcome(), output)
}

/// The tool in its place, in a few words.
pub(super) fn tool_text(tool: &ToolAnswer) -> String {
    let mut text = tool.title.as_ref().map_or_else(String::new, |title| format!("{title}\n"));
    let cover = if tool.cover_m > 0.0 {
        format!(", below {} m of soil", number(rounded(tool.cover_m)))
    } else {
        String::new()
    };
    text += &format!(
        "in the ground: {}, {} m deep{cover}; chord of {} m at {} deg\n",
        if tool.pieces.len() == 1 { "1 piece".to_owned() } else { format!("{} pieces", tool.pieces.len()) },
        number(rounded(tool.depth_m)),
        number(rounded(tool.chord_m)),
        number(rounded(tool.chord_alpha_deg)),
    );
    text
}

/// The pieces as a table.
fn pieces(tool: &ToolAnswer) -> String {
    let mut rows =
        vec![["piece", "from, m", "to, m", "alpha, deg", "delta, deg"].map(str::to_owned).to_vec()];
    for (index, piece) in tool.pieces.iter().enumerate() {
        let point = |[x, y]: [f64; 2]| format!("{} {}", number(rounded(x)), number(rounded(y)));
        rows.push(vec![
            (index + 1).to_string(),
            point(piece.from_m),
            point(piece.to_m),
            number(rounded(piece.alpha_deg)),
            number(piece.delta_deg),
        ]);
    }
    columns(&rows)
}

/// What is proven of the whole tool.
fn ends_text(ends: &EndsAnswer) -> String {
    let mut text = format!(
        "force of the tool, {} m wide, with {}:\nlower  {} N  ({})\nupper  {} N  ({})\n",
        number(ends.width_m),
        if ends.side_plates { "side plates" } else { "open ends" },
        number(ends.lower_n),
        ends.lower_proof.words(),
        number(ends.upper_n),
        ends.upper_proof.words(),
    );
    if let Some(front) = &ends.front {
        text += &format!(
            "the upper bound is that of a front at {} deg, {} m deep and {} m wide, that tool and side plates lie behind, with the soil between moving along\n",
            number(rounded(front.alpha_deg)),
            number(rounded(front.depth_m)),
            number(rounded(front.width_m)),
        );
    }
    text + &format!(
        "without ends: {} to {} N/m\n",
        number(ends.plane_lower_n_per_m),
        number(ends.plane_upper_n_per_m)
    )
}

/// Each direction, and what all of them say.
fn forces_text(forces: &ForcesAnswer) -> String {
    let header = ["direction, deg", "lower, N/m", "upper, N/m", "borne: ahead, N/m", "and upwards, N/m"];
    let mut rows = vec![header.map(str::to_owned).to_vec()];
    for one in &forces.directions {
        let [ahead, upwards] = [0, 1].map(|axis| one.force_n_per_m.map(|force| rounded(force[axis])));
        rows.push(vec![
            number(rounded(one.direction_deg)),
            number_or_dash(one.lower_n_per_m),
            number_or_dash(one.upper_n_per_m),
            number_or_dash(ahead),
            number_or_dash(upwards),
        ]);
    }
    let mut text = format!(
        "\nforces on the soil of a tool that does not turn (its own weight is one of them), by the direction in which it would move\n{}",
        columns(&rows)
    );
    text += "every force between those that are borne is borne; none is whose part along a direction is above its upper bound\n";
    if forces.limit_n_per_m.is_none() {
        text += "the upper bounds do not close a polygon: in some directions nothing that is proven limits the force\n";
    }
    text
}

/// The rows of the table.
fn table_text(table: &TableAnswer) -> String {
    let header = ["phi, deg", "delta, deg", "lower, N/m", "upper, N/m", "coefficient", "to"];
    let mut rows = vec![header.map(str::to_owned).to_vec()];
    for row in &table.rows {
        rows.push(vec![
            number(row.phi_deg),
            number_or_dash(row.delta_deg),
            number_or_dash(row.lower_n_per_m),
            number_or_dash(row.upper_n_per_m),
            number_or_dash(row.coefficient_lower),
            number_or_dash(row.coefficient_upper),
        ]);
    }
    format!(
        "\n{}, {} of {} rows from before\n{}",
        table.file,
        table.kept_rows,
        table.rows.len(),
        columns(&rows)
    )
}

/// Four digits: lengths and angles for people.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = tool_text(&self.tool);
        text += &format!(
            "force along the motion, per metre of width{}:\nlower  {} N/m\nupper  {} N/m\n",
            if self.ends.is_some() { ", with ends" } else { "" },
            number(self.lower_n_per_m),
            number(self.upper_n_per_m)
        );
        if let Some(ends) = &self.ends {
            text += &ends_text(ends);
        }
        if let Some(gap) = self.gap {
            text += &format!("gap    {} %\n", number(100.0 * gap));
        }
        text += &format!(
            "coefficient, 2 F / (gamma L^2) with the chord as L: {} to {}\n",
            number(self.coefficient_lower),
            number(self.coefficient_upper)
        );
        if let (Some(lower), Some(upper)) = (self.slant_lower, self.slant_upper) {
            text += &format!(
                "as bound counts it, of the force inclined at delta: {} to {}\n",
                number(lower),
                number(upper)
            );
        }
        text += &format!("both bounds are proven; {:.1} s, {}\n\n", self.seconds, self.ended);
        text += &pieces(&self.tool);
        if let Some(forces) = &self.forces {
            text += &forces_text(forces);
        }
        if let Some(table) = &self.table {
            text += &table_text(table);
        }
        text += "\nlevels, in kN/m\n";
        text += &level_table(&self.levels);
        text += "\n";
        text + &results_text(&self.results)
    }
}
