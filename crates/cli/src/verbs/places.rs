//! `soilctl places`: whether the soil is the same at several places.

use soilctl_app::places::{self, Answer, By, Request};
use soilctl_app::text::{columns, number, number_or_dash, range, yes};
use soilctl_app::{Answer as _, Outcome};
use soilctl_pages::places::page;

use super::pages::PageFiles;
use crate::error::CliError;
use crate::output::{Output, Words};

/// Pairs that are printed; the JSON answer has all.
const MOST_PAIRS: usize = 20;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Strokes of one kind (tool angle, depth, width) at every place tell differences best: their forces are compared, whatever the model. \
    Examples: soilctl places strokes.csv --delta 23 --report map.html; soilctl places strokes.csv --delta 23 --geojson map.geojson --origin-deg 48.15,11.57. \
    Exit codes: 0 done, 3 no soil explains the strokes of some place. Docs: docs/how/same-everywhere.md."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    files: PageFiles,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    let answer = places::run(&args.request, output)?;
    args.files.write(|| page(&answer), output)?;
    output.answer(&answer)?;
    Ok(answer.outcome())
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = format!("{}\n\n", self.verdict);
        let heading = ["place", "x (m)", "y (m)", "strokes", "phi (deg)", "density (kg/m3)", "group"];
        let mut rows = vec![heading.map(String::from).to_vec()];
        for place in &self.places {
            rows.push(vec![
                place.name.clone(),
                number_or_dash(place.x_m),
                number_or_dash(place.y_m),
                place.strokes.to_string(),
                range(place.phi_deg, 1),
                range(place.density_kg_m3, 0),
                place.group.map_or_else(|| "no soil".into(), |group| (group + 1).to_string()),
            ]);
        }
        text += &columns(&rows);
        text += "\n";
        text += &pairs(self);
        if let Some(between) = &self.between {
            let inside = between.cells.iter().filter(|cell| cell.inside).count();
            text += &format!(
                "\nbetween places: {} cells of {} m, {inside} of them among the places\n",
                between.cells.len(),
                number(between.cell_m)
            );
            for (order, [x, y]) in (1..).zip(&between.next_places) {
                text += &format!("next place {order}: x {} m, y {} m\n", number(*x), number(*y));
            }
        }
        for warning in &self.warnings {
            text += &format!("\nnote: {warning}\n");
        }
        text
    }
}

/// Pairs, the least alike first.
fn pairs(answer: &Answer) -> String {
    let mut sorted: Vec<_> = answer.pairs.iter().collect();
    sorted.sort_by(|a, b| b.differ.cmp(&a.differ).then(a.p.unwrap_or(1.0).total_cmp(&b.p.unwrap_or(1.0))));
    let heading = ["pair", "compared by", "force ratio", "tellable from", "p", "differ"];
    let mut rows = vec![heading.map(String::from).to_vec()];
    let or_dash = |value: Option<String>| value.unwrap_or_else(|| "-".into());
    for pair in sorted.iter().take(MOST_PAIRS) {
        rows.push(vec![
            pair.places.join(", "),
            match pair.by {
                By::Forces => format!("forces, {} kinds", pair.kinds),
                By::Sets => "sets".into(),
                By::Nothing => "nothing".into(),
            },
            or_dash(pair.force_ratio.map(|ratio| format!("{ratio:.3}"))),
            or_dash(pair.tellable_ratio.map(|ratio| format!("{ratio:.3}"))),
            or_dash(pair.p.map(|p| format!("{p:.2e}"))),
            yes(pair.differ).into(),
        ]);
    }
    let more = sorted.len().saturating_sub(MOST_PAIRS);
    let rest = if more > 0 { format!("and {more} more pairs\n") } else { String::new() };
    columns(&rows) + &rest
}
