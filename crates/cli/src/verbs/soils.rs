//! `soilctl soils [NAME]`: soils of the Moon and Mars with strength and density as published.

use soilctl_app::soils::{self, Answer, Request, Soil};
use soilctl_app::text::{columns, number};
use soilctl_app::{Answer as _, Outcome};

use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Friction and cohesion are ranges as published, of one straight line of strength, with what they are from. `soilctl soils NAME --format json` \
    is a REGION of `soilctl stability`. Docs: docs/stability.md."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = soils::run(&args.request, output)?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

fn range([low, high]: [f64; 2]) -> String {
    if low == high { number(low) } else { format!("{} to {}", number(low), number(high)) }
}

impl Words for Answer {
    fn text(&self) -> String {
        if let [soil] = &self.soils[..] {
            return alone(soil);
        }
        let head = ["name", "phi (deg)", "cohesion (Pa)", "density (kg/m3)", "what it is"];
        let mut rows = vec![head.map(String::from).to_vec()];
        for soil in &self.soils {
            rows.push(vec![
                soil.name.clone(),
                range(soil.phi_deg),
                range(soil.cohesion_pa),
                range(soil.density_kg_m3),
                soil.title.clone(),
            ]);
        }
        columns(&rows) + "\nsources and notes: soilctl soils NAME\n"
    }
}

fn alone(soil: &Soil) -> String {
    let stress = soil.stress_pa.map_or_else(|| "not published".into(), |stress| range(stress) + " Pa");
    let lines = [
        ("friction angle", range(soil.phi_deg) + " deg"),
        ("cohesion", range(soil.cohesion_pa) + " Pa"),
        ("density", range(soil.density_kg_m3) + " kg/m3"),
        ("gravity", number(soil.gravity_m_s2) + " m/s2"),
        ("stress of tests", stress),
        ("method", soil.method.clone()),
        ("source", soil.source.clone()),
        ("note", soil.note.clone()),
    ];
    let lines = lines.iter().filter(|(_, value)| !value.is_empty());
    let text: String = lines.map(|(what, value)| format!("  {what:<16}{value}\n")).collect();
    format!("{}: {}\n{text}", soil.name, soil.title)
}
