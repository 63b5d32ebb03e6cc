//! `soilctl bound`: proven bounds on the force of an embedded plate.

use soilctl_app::bound::{self, Answer, EndAnswer, Request, WidthAnswer};
use soilctl_app::text::{columns, number, number_or_dash};
use soilctl_app::{Answer as _, Outcome};

use super::limits::{Show, level_table, results_text};
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Both bounds are proven with interval arithmetic; the true force of the rigid-plastic soil with \
    associated flow lies between them. Coefficients are net and per slant length, K = 2 F / (gamma L^2 w). A plate that has a \
    width has ends: a stress field in space about them bounds its force from below (upright plates on level ground, weight \
    alone; otherwise one in plane strain), blocks in space from above, and the gap asked for is that of plane strain. Exit code 3: the budget ended before the gap was reached. Ctrl-C or SIGTERM ends the run with the best bounds so far."
)]
pub(crate) struct Args {
    #[command(flatten)]
    request: Request,

    #[command(flatten)]
    show: Show,
}

pub(crate) fn run(args: &Args, output: &mut Output) -> Result<Outcome, CliError> {
    args.show.check()?;
    let mut found = bound::run(&args.request, output)?;
    let mut written = args.show.write(&found.fields, || soilctl_pages::bound::page(&found), output);
    found.answer.results.files = std::mem::take(&mut written.files);
    output.answer(&found.answer)?;
    written.with_solution(found.unsaved).end(found.answer.outcome(), output)
}

/// The bracket over the width.
fn over_width(rows: &[WidthAnswer]) -> String {
    let mut cells = vec![["width/depth", "lower", "upper", "gap, %"].map(str::to_owned).to_vec()];
    for row in rows {
        let ratio = row.width_ratio.map_or_else(|| "no ends".to_owned(), number);
        cells.push(vec![ratio, number(row.lower), number(row.upper), format!("{:.1}", 100.0 * row.gap)]);
    }
    columns(&cells)
}

/// What became of the stress field about the ends.
fn end_text(end: &EndAnswer) -> String {
    match (&end.why_none, end.lower) {
        (Some(why), _) => format!("no stress field in space about the ends: {why}\n"),
        (None, lower) => format!(
            "stress field about an end: {} tetrahedra, {:.1} s, lower {}\n",
            end.tetrahedra,
            end.seconds,
            number_or_dash(lower)
        ),
    }
}

impl Words for Answer {
    fn text(&self) -> String {
        let mut text = format!(
            "net coefficient per slant length, 2 F / (gamma L^2 w):\nlower  {}\nupper  {}\ngap    {} %\n",
            number(self.lower),
            number(self.upper),
            number(100.0 * self.gap)
        );
        if let (Some(lower), Some(upper)) = (self.force_lower_n, self.force_upper_n) {
            text += &format!("force  {} to {} N\n", number(lower), number(upper));
        }
        text += &format!("both bounds are proven; {:.1} s, {}\n\n", self.seconds, self.ended);
        if let Some(ratio) = self.width_ratio {
            text += &format!(
                "per width of a plate {} times as wide as deep; lower by {}, upper by {}\n",
                number(ratio),
                self.lower_proof.words(),
                self.upper_proof.words(),
            );
            if let Some(end) = &self.end {
                text += &end_text(end);
            }
            text += &format!("\n{}\n", over_width(&self.over_width));
        }
        text += &level_table(&self.levels);
        text += "\n";
        text + &results_text(&self.results)
    }
}
