//! `soilctl solve FILE`: proven bounds for a problem that is described in a file.

use std::path::Path;

use soilctl_app::solve::{self, Answer, Asked, Request, SeepageAnswer, check};
use soilctl_app::text::{columns, number, number_or_dash};
use soilctl_app::{Answer as _, Outcome};
use soilctl_pages::save_figure;

use super::limits::{Show, level_table, results_text};
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Both bounds are proven with interval arithmetic; the true value for rigid-plastic soil with \
    associated flow lies between them. What the file says is in docs/problem-file.md, examples are in data/problems. \
    Exit code 3: the budget ended before the gap was reached. Ctrl-C or SIGTERM ends the run with the best bounds so far."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    /// Only reads the file and says what it was understood to mean; --plot draws it (.svg, .png, .csv)
    #[arg(long)]
    check: bool,

    #[command(flatten)]
    show: Show,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let file = &args.request.file;
    if args.check {
        let found = check::run(&check::Request { file: file.clone() }, output)?;
        if let Some(path) = check_plot(args)? {
            let (figure, size) = soilctl_pages::solve::drawing(&found)?;
            save_figure(&figure, path, size)?;
        }
        output.answer(&found.answer)?;
        return Ok(Outcome::Done);
    }
    args.show.check()?;
    let mut found = solve::run(&args.request, output)?;
    let mut written = args.show.write(&found.fields, || soilctl_pages::solve::page(&found, file), output);
    found.answer.results.files = std::mem::take(&mut written.files);
    output.answer(&found.answer)?;
    written.with_solution(found.unsaved).end(found.answer.outcome(), output)
}

/// Where --check draws to; files that need a solution are refused.
fn check_plot(args: &Args) -> Result<Option<&Path>, CliError> {
    let unsolved = args.request.save.as_ref().map(|_| "--save").or_else(|| args.show.of_a_solution());
    match unsolved {
        Some(option) => Err(CliError::Usage(format!(
            "{option} needs a solution, and --check solves nothing; leave one of them out"
        ))),
        None => Ok(args.show.plot.as_deref()),
    }
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = self.title.as_ref().map_or_else(String::new, |t| format!("{t}\n"));
        text += &format!(
            "{}:\nlower  {}\nupper  {}\n",
            self.quantity.words(),
            number(self.lower),
            number(self.upper)
        );
        if let Some(gap) = self.gap {
            text += &format!("gap    {} %\n", number(100.0 * gap));
        }
        if self.quantity == Asked::ForceKnPerM && self.upper < 0.0 {
            let [least, most] = [number(-self.upper), number(-self.lower)];
            text += &format!("the soil pushes the structure on, with {least} to {most} kN/m\n");
        }
        if let Some(seepage) = &self.seepage {
            text += &format!(
                "for pore pressures within {} kPa of the flow: see --check\n",
                number(seepage.kept_within_kpa)
            );
        }
        if let Some(governing) = &self.governing {
            return text + &cases_text(self, governing) + &results_text(&self.results);
        }
        text += &format!("both bounds are proven; {:.1} s, {}\n\n", self.seconds, self.ended);
        if self.trials.is_empty() {
            return text + &level_table(&self.levels) + "\n" + &results_text(&self.results);
        }
        let mut rows = vec![["strength over", "times all that acts", ""].map(str::to_owned).to_vec()];
        let known = |x: Option<f64>| x.map_or_else(|| "?".to_owned(), number);
        for t in &self.trials {
            rows.push(vec![number(t.factor), known(t.borne_lower), known(t.borne_upper)]);
        }
        text + &columns(&rows) + "\n" + &results_text(&self.results)
    }
}

/// How ground water flows.
fn seepage_text(seepage: &SeepageAnswer) -> String {
    let unit = if seepage.in_m2_per_s { "m3/s per m" } else { "over permeability, m" };
    let mut rows = vec![vec!["head".to_owned(), "m".into(), format!("flows in, {unit}")]];
    for head in &seepage.heads {
        let name = head.name.clone().unwrap_or_else(|| "-".into());
        rows.push(vec![name, number(head.head_m), number(head.inflow)]);
    }
    rows.push(vec!["out in air".into(), "-".into(), number(-seepage.out_in_air)]);
    let mut text = format!("\n{}", columns(&rows));
    if let (Some(gradient), Some([x, y])) = (seepage.exit_gradient, seepage.exit_at_m) {
        text += &format!(
            "greatest gradient where water comes out: {}, at ({}, {})\n",
            number(gradient),
            number(x),
            number(y)
        );
    }
    text + &format!(
        "pore pressures up to {} kPa, linear in {} triangles: within {} kPa of a flow on smaller ones, and that within {} kPa\n",
        number(seepage.greatest_kpa),
        seepage.triangles,
        number(seepage.kept_within_kpa),
        number(seepage.found_within_kpa)
    )
}

/// All cases as a table, and which governs.
fn cases_text(answer: &Answer, governing: &str) -> String {
    let header = ["lower", "upper", "gap %", "one or more", "case"].map(str::to_owned);
    let mut rows = vec![header.to_vec()];
    for case in &answer.cases {
        let enough = match case.enough {
            Some(true) => "yes",
            Some(false) => "no",
            None => "-",
        };
        rows.push(vec![
            number_or_dash(case.lower),
            number_or_dash(case.upper),
            number_or_dash(case.gap.map(|gap| 100.0 * gap)),
            enough.to_owned(),
            case.name.clone(),
        ]);
    }
    let proven = if answer.certified {
        "all bounds are proven"
    } else {
        "bounds that are told are proven; some cases have none"
    };
    let table = columns(&rows);
    format!("least of all cases; {proven}; {:.1} s\n\n{table}\n{governing}:\n", answer.seconds)
}

impl Words for check::Answer {
    fn text(&self) -> String {
        let mut text = self.title.as_ref().map_or_else(String::new, |t| format!("{t}\n"));
        let [long, stress] = [number(self.length_m), number(self.stress_kpa)];
        text += &format!("asked for: {}\nunits: {long} m, {stress} kPa\n\n", self.quantity.words());
        let header = ["soil", "area m2", "phi deg", "cohesion kPa", "weight kN/m3", "pore pressure kPa"];
        let mut rows = vec![header.map(str::to_owned).to_vec()];
        let span = |[low, high]: [f64; 2]| {
            if low == high { number(low) } else { format!("{} to {}", number(low), number(high)) }
        };
        for r in &self.regions {
            let [c, u] = [r.cohesion_kpa, r.pore_pressure_kpa].map(span);
            let soil = r.soil.clone();
            rows.push(vec![soil, number(r.area_m2), number(r.phi_deg), c, number(r.unit_weight_kn_m3), u]);
        }
        text += &columns(&rows);
        if !self.members.is_empty() {
            let header = [
                "member",
                "length m",
                "tension kN/m",
                "compression kN/m",
                "moment kNm/m",
                "bond",
                "pullout kN/m2",
                "attached",
            ]
            .map(str::to_owned);
            let mut rows = vec![header.to_vec()];
            for m in &self.members {
                let attached = match m.attached {
                    [false, false] => "-",
                    [true, false] => "start",
                    [false, true] => "end",
                    [true, true] => "start, end",
                };
                let numbers = [m.length_m, m.tensile_kn_per_m, m.compressive_kn_per_m].map(number);
                let bond = if m.pullout_kn_per_m2.is_some() { "-".to_owned() } else { number(m.bond_factor) };
                let pullout = match m.pullout_kn_per_m2 {
                    None => "-".to_owned(),
                    Some(_) if m.free_length_m > 0.0 => {
                        format!(
                            "{} from {} m",
                            m.pullout_kn_per_m2.map_or_else(String::new, span),
                            number(m.free_length_m)
                        )
                    }
                    Some(ends) => span(ends),
                };
                let rest = [number_or_dash(m.moment_knm_per_m), bond, pullout, attached.to_owned()];
                rows.push([&[m.name.clone()][..], &numbers, &rest].concat());
            }
            text += "\n";
            text += &columns(&rows);
        }
        if let Some(seepage) = &self.seepage {
            text += &seepage_text(seepage);
        }
        for case in &self.cases {
            text += &format!("\ncase {}", case.name);
            for (name, factor) in &case.factors {
                text += &format!("; factor on {name} {}", number(*factor));
            }
        }
        text += if self.cases.is_empty() { "\n" } else { "\n\n" };
        let mut rows = vec![["boundary", "length m"].map(str::to_owned).to_vec()];
        rows.extend(self.boundaries.iter().map(|b| vec![b.kind.name().to_owned(), number(b.length_m)]));
        text + &columns(&rows)
    }
}
