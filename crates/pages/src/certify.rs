//! The page of a saved solution.

use soilctl_app::certify::{Answer, Certified, Checked};
use soilctl_app::limits::{Fields, ResultsAnswer};
use soilctl_app::text::number_or_dash;
use soilctl_figure::{CalloutKind, HtmlReport};

use crate::PageError;
use crate::limits::{self, PageContent, bounds_table};
use crate::problem::Scene;

/// The page of a saved solution, with its fields.
///
/// # Errors
/// [`PageError`] if a figure cannot be drawn.
pub fn page(found: &Certified, fields: &Fields) -> Result<HtmlReport, PageError> {
    let scene = Scene::of_statement(fields.statement()?, &fields.units, &fields.title, 0.0);
    limits::page(fields, &scene, content(&found.answer)?, &ResultsAnswer::new(fields)?)
}

fn content(answer: &Answer) -> Result<PageContent, PageError> {
    let mut bounds = bounds_table();
    let row = |of: fn(&Checked) -> Option<f64>| {
        [&answer.lower, &answer.upper].map(|c| number_or_dash(c.as_ref().and_then(of)))
    };
    let ([lower, upper], [claimed_lower, claimed_upper]) = (row(|c| c.proven), row(|c| Some(c.claimed)));
    bounds.row(["Proven".to_owned(), lower, upper])?;
    bounds.row(["Claimed".to_owned(), claimed_lower, claimed_upper])?;
    let verdict = if answer.certified {
        (
            CalloutKind::Good,
            "Every claim is proven",
            "Each field was read from the file and checked anew with interval arithmetic.".to_owned(),
        )
    } else {
        let lines = [("lower bound", &answer.lower), ("upper bound", &answer.upper)]
            .map(|(name, c)| c.as_ref().filter(|c| !c.confirmed).map(|c| c.line(name).trim().to_owned()));
        (
            CalloutKind::Bad,
            "Not every claim is proven",
            lines.into_iter().flatten().collect::<Vec<_>>().join("; "),
        )
    };
    Ok(PageContent {
        kind: "Saved solution",
        subtitle: answer
            .description
            .as_ref()
            .map_or_else(String::new, |title| format!("The file calls it “{title}”, which nothing proves.")),
        verdict: (verdict.0, verdict.1.to_owned(), verdict.2),
        bounds,
        inputs: Vec::new(),
        given: answer.statement.iter().map(|said| (said.of, said.says.clone())).collect(),
        steps: None,
    })
}
