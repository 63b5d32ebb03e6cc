//! `soilctl convert FILE --out FILE`: a problem file of a drawing, or a drawing of a problem file.

use soilctl_app::convert::{self, Answer, Request};
use soilctl_app::text::{columns, number};
use soilctl_app::{Answer as _, Outcome};

use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Drawings are DXF (text), GeoJSON with metres for degrees, or CSV with the columns layer, x_m, y_m; AGS 4 has boreholes, of which a section is \
    made. Areas become soils, named after their layers. Exit codes: 0 all is there, 3 strengths are to be put in or lines were left out. Docs: docs/problem-file.md."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = convert::run(&args.request, output)?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

impl Words for Answer {
    fn text(&self) -> String {
        let [[left, right], [low, high]] = self.extent_m.map(|range| range.map(number));
        let mut text = format!("x {left} to {right} m, y {low} to {high} m (drawn in {})\n", self.unit);
        let mut rows = vec![["soil", "areas", "m2", "strength"].map(String::from).to_vec()];
        for soil in &self.soils {
            let strength = if soil.has_strength { "given" } else { "to be put in" };
            let area = number(soil.area_m2);
            rows.push(vec![soil.name.clone(), soil.areas.to_string(), area, strength.to_owned()]);
        }
        text += &columns(&rows);
        text += if self.has_water { "with a water table\n" } else { "without water\n" };
        if self.joined > 0 {
            text += &format!("{} corners were moved onto others, or put into edges\n", self.joined);
        }
        for it in &self.left_out {
            text += &format!("left out: {} {} on layer {}: {}\n", it.count, it.what, it.layer, it.why);
        }
        for note in &self.notes {
            text += &format!("note: {note}\n");
        }
        text
    }
}
