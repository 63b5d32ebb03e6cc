//! `soilctl predict`: force and coefficients of a plate from a named model.

use std::path::{Path, PathBuf};

use soilctl_app::predict::{self, Answer, Request, StrokePrediction};
use soilctl_app::request::NumberOrColumn;
use soilctl_app::text::{columns, number, number_or_dash};
use soilctl_app::tool;
use soilctl_app::{Answer as _, Outcome};
use soilctl_pages::predict::{Kind, save};

use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Coefficients are per slant length, K = 2 F / (gamma L^2 w) with L = depth / sin(alpha); the net \
    one is passive minus active. Without --depth, --width and --density the force is null. \
    The models mckyes, perumpral, godwin-spoor, ovesen and blocks-3d know that soil fails beside the plate's ends as well, so they \
    take --depth and --width; blocks-3d is an upper bound. --tool answers what `soilctl tool` does, with its defaults.",
    mut_arg("alpha_deg", |alpha| alpha.required_unless_present("tool")),
    mut_arg("delta_deg", |delta| delta.required_unless_present("tool"))
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    /// A tool that is not flat, as a tool file: proven bounds on its force per metre of width, as `soilctl tool` has them; needs --density
    #[arg(long, value_name = "FILE", requires = "density_kg_m3", conflicts_with_all = ["strokes", "model", "model_table", "model_file", "width_m", "ends", "plot"])]
    tool: Option<PathBuf>,

    /// Draws a figure (.svg, .png) or writes its data (.csv)
    #[arg(long, value_name = "FILE", conflicts_with_all = ["strokes", "model_file"])]
    plot: Option<PathBuf>,

    /// What --plot draws
    #[arg(long, value_name = "KIND", value_enum, default_value_t = Kind::Surface, requires = "plot")]
    plot_kind: Kind,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    if let Some(file) = &args.tool {
        let answer = tool::run(&of_tool(&args.request, file)?, output)?.complete()?;
        output.answer(&answer)?;
        return Ok(answer.outcome());
    }
    let answer = predict::run(&args.request, output)?;
    if let Some(path) = &args.plot
        && let Some(case) = args.request.case()?
    {
        save(path, args.plot_kind, &case, output)?;
    }
    output.answer(&answer)?;
    Ok(Outcome::Done)
}

/// The same question about a tool.
fn of_tool(request: &Request, file: &Path) -> Result<tool::Request, CliError> {
    let number = |option: &str, given: Option<NumberOrColumn>| match given {
        Some(NumberOrColumn::Column) => Err(CliError::Usage(format!(
            "--{option} is the word column, which is of a stroke table; give a number with --tool"
        ))),
        Some(NumberOrColumn::Number(number)) => Ok(Some(number)),
        None => Ok(None),
    };
    let missing = |option: &str| CliError::Usage(format!("--tool needs --{option}"));
    let setting = tool::Setting {
        file: file.to_owned(),
        alpha_deg: request.alpha_deg,
        phi_deg: request.phi_deg.ok_or_else(|| missing("phi DEG"))?,
        delta_deg: number("delta", request.delta_deg)?,
        density_kg_m3: number("density", request.density_kg_m3)?.ok_or_else(|| missing("density KG/M3"))?,
        depth_m: request.depth_m,
        loads: request.loads,
        ..tool::Setting::default()
    };
    Ok(tool::Request { setting, ..tool::Request::default() })
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = format!("{}: {}\n", self.model, self.reference);
        match &self.strokes {
            Some(strokes) => text += &strokes_text(strokes),
            None => text += &coefficients_text(self),
        }
        if self.interpolation_margin > 0.0 {
            let per_cent = number(100.0 * self.interpolation_margin);
            text += &format!("interpolation may be off by up to {per_cent} %\n");
        }
        for note in &self.notes {
            text += &format!("note: {note}\n");
        }
        text
    }
}

fn coefficients_text(answer: &Answer) -> String {
    let mut text = String::new();
    let mut line = |key: &str, value: String, meaning: &str| {
        text += format!("{key:<12} {value:<12} {meaning}").trim_end();
        text += "\n";
    };
    let value = number_or_dash;
    line("k_passive", value(answer.k_passive), "");
    line("k_active", value(answer.k_active), "");
    line("k_net", value(answer.k_net), "passive minus active, per slant length: 2 F / (gamma L^2 w)");
    if answer.k_net_lower.is_some() {
        line("k_net_lower", value(answer.k_net_lower), "lower end of the bracket");
        line("k_net_upper", value(answer.k_net_upper), "upper end of the bracket");
    }
    if answer.width_ratio.is_some() {
        line(
            "width_ratio",
            value(answer.width_ratio),
            "width over depth; coefficients hold for this plate with its ends",
        );
    }
    line("k_net_depth", value(answer.k_net_depth), "the same per depth: 2 F / (gamma H^2 w)");
    if let Some(s) = &answer.sensitivity_percent_per_deg {
        for (key, change) in
            [("d_alpha", s.alpha), ("d_beta", s.beta), ("d_phi", s.phi), ("d_delta", s.delta)]
        {
            line(key, value(change), "% of k_net for one degree more");
        }
    }
    match answer.force_n {
        Some(force) => line("force_n", number(force), "N, with all loads"),
        None => line("force_n", "-".into(), "needs --depth, --width and --density"),
    }
    if let Some(law) = &answer.friction_law {
        let range = |[low, high]: [f64; 2]| format!("{} to {}", number(low), number(high));
        line("phi_deg", range(law.phi_deg), "deg, at the stress where the soil slips");
        line("slip_stress", range(law.slip_stress_pa), "Pa");
        line("force_n", range(law.force_n), "N, for all of these");
    }
    text
}

fn strokes_text(strokes: &[StrokePrediction]) -> String {
    let header = ["line", "stroke_id", "alpha_deg", "depth_m", "k_net", "force_n", "measured_n", "ratio"];
    let mut rows = vec![header.map(str::to_owned).to_vec()];
    rows.extend(strokes.iter().map(|stroke| {
        vec![
            stroke.line.to_string(),
            stroke.stroke_id.clone().unwrap_or_else(|| "-".into()),
            number(stroke.alpha_deg),
            number(stroke.depth_m),
            number(stroke.k_net),
            number_or_dash(stroke.force_n),
            number(stroke.measured_n),
            number_or_dash(stroke.ratio),
        ]
    }));
    columns(&rows)
}
