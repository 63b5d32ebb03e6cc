//! `soilctl bound`: proven bounds on the force of an embedded plate.

use soilctl_app::bound::{self, Answer, Request};
use soilctl_app::text::number;
use soilctl_app::{Answer as _, Outcome};

use super::limits::{Show, level_table, results_text};
use crate::error::CliError;
use crate::output::{Output, Words};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Both bounds are proven with interval arithmetic; the true force of the rigid-plastic soil with \
    associated flow lies between them. Coefficients are net and per slant length, K = 2 F / (gamma L^2 w). Exit code 3: \
    the budget ended before the gap was reached. Ctrl-C or SIGTERM ends the run with the best bounds so far."
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
    found.answer.results.files =
        args.show.write(&found.fields, || soilctl_pages::bound::page(&found), output)?;
    output.answer(&found.answer)?;
    Ok(found.answer.outcome())
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
        text += &level_table(&self.levels);
        text += "\n";
        text + &results_text(&self.results)
    }
}
