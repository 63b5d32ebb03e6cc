//! What was done with a table, in words.

use std::collections::BTreeMap;

use soilctl_app::table::{
    Answer, BracketCell, BracketFindings, BuiltBounds, Gaps, Head, Plan, TableCell, Violation,
};
use soilctl_app::text::{columns, duration, number};
use soilctl_earth_pressure::table::CellStatus;

use crate::output::Words;

/// Findings of one kind listed in words.
const LISTED: usize = 20;

impl Words for Answer {
    fn text(&self) -> String {
        match self {
            Self::Show { table, cells } => head_text(table) + &show_text(table, cells),
            Self::Build { table, file, first_refusal } => {
                let refusal = first_refusal.as_ref().map(|text| format!("first empty node: {text}\n"));
                head_text(table) + &format!("written to {file}\n") + &refusal.unwrap_or_default()
            }
            Self::Check { table, violations, empty_nodes, brackets, .. } => {
                let findings = brackets.as_ref().map_or_else(String::new, findings_text);
                head_text(table) + &findings + &check_text(violations, empty_nodes)
            }
            Self::ShowBrackets { table, gaps, cells } => {
                head_text(table) + &known_gaps(gaps.as_ref()) + &brackets_text(cells)
            }
            Self::BuildBounds(built) => built_text(built),
            Self::Plan(plan) => plan_text(plan),
            Self::Merge { table, gaps, file } => {
                head_text(table) + &known_gaps(gaps.as_ref()) + &format!("written to {file}\n")
            }
        }
    }
}

fn head_text(table: &Head) -> String {
    format!(
        "{} ({})\n{}\nnodes: {} (alpha {}, phi {}, delta {}), filled: {}, of these interpolated: {}\n",
        table.name,
        table.quantity,
        table.source,
        table.nodes,
        table.alpha_deg.len(),
        table.phi_deg.len(),
        table.delta_deg.len(),
        table.filled,
        table.interpolated,
    )
}

fn known_gaps(gaps: Option<&Gaps>) -> String {
    gaps.map_or_else(String::new, gaps_text)
}

fn gaps_text(gaps: &Gaps) -> String {
    format!(
        "gap: mean {} %, widest {} % at {}; above {} %: {} (ran out of {} elements), not proven: {}\n",
        number(100.0 * gaps.mean),
        number(100.0 * gaps.widest),
        in_words(gaps.widest_at),
        number(100.0 * gaps.max_gap),
        gaps.over_max_gap,
        gaps.max_elements,
        gaps.uncertified,
    )
}

/// One block for each tool angle, friction angles down and interface friction angles across.
fn show_text(table: &Head, cells: &[TableCell]) -> String {
    let interpolated = CellStatus::Interpolated.word();
    let mut text = String::from("k_net per slant length; * marks an interpolated cell\n");
    let mut cells = cells.iter().peekable();
    for alpha in &table.alpha_deg {
        text += &format!("\nalpha {} deg\n", number(*alpha));
        let deltas = table.delta_deg.iter().map(|delta| format!("delta {}", number(*delta)));
        let mut rows: Vec<Vec<String>> = vec![std::iter::once("phi".to_owned()).chain(deltas).collect()];
        for phi in &table.phi_deg {
            let mut row = vec![number(*phi)];
            for delta in &table.delta_deg {
                let here = |cell: &&TableCell| {
                    [cell.alpha_deg, cell.phi_deg, cell.delta_deg] == [*alpha, *phi, *delta]
                };
                row.push(match cells.next_if(here) {
                    Some(cell) if cell.status == interpolated => number(cell.k_net) + "*",
                    // A space below the mark, so that digits stay aligned.
                    Some(cell) => number(cell.k_net) + " ",
                    None => "- ".into(),
                });
            }
            rows.push(row);
        }
        text += &columns(&rows);
    }
    text
}

fn brackets_text(cells: &[BracketCell]) -> String {
    let header = ["alpha", "phi", "delta", "lower", "upper", "gap %"].map(str::to_owned).to_vec();
    let rows = cells.iter().map(|cell| {
        [cell.alpha_deg, cell.phi_deg, cell.delta_deg, cell.lower, cell.upper, 100.0 * cell.gap]
            .map(number)
            .to_vec()
    });
    let rows: Vec<_> = std::iter::once(header).chain(rows).collect();
    format!("bounds on k_net per slant length\n{}", columns(&rows))
}

fn check_text(violations: &[Violation], empty_nodes: &[[f64; 3]]) -> String {
    let mut text = format!("empty nodes with delta up to phi: {}\n", empty_nodes.len());
    for at in empty_nodes.iter().take(LISTED) {
        text += &format!("  {}\n", in_words(*at));
    }
    text += &format!("places where k_net does not grow: {}\n", violations.len());
    for v in violations.iter().take(LISTED) {
        let (from, to) = (in_words(v.from), in_words(v.to));
        text += &format!(
            "  along {}: {} at {from}, then {} at {to}\n",
            v.along,
            number(v.k_from),
            number(v.k_to)
        );
    }
    if violations.len().max(empty_nodes.len()) > LISTED {
        text += &format!("(the first {LISTED} of each; --format json lists all)\n");
    }
    text
}

fn findings_text(findings: &BracketFindings) -> String {
    let mut text = known_gaps(findings.gaps.as_ref());
    text += &format!("lower bound above upper bound: {}\n", findings.crossed.len());
    for node in findings.crossed.iter().take(LISTED) {
        text += &format!("  {}\n", in_words(*node));
    }
    for c in &findings.contradicted {
        let (bound, proven) = (number(c.bound), number(c.proven));
        text += &format!("{} says {bound} at {}, but {proven} is proven\n", c.table, in_words(c.node));
    }
    text
}

fn built_text(built: &BuiltBounds) -> String {
    let mut text = head_text(&built.table) + &known_gaps(built.gaps.as_ref());
    let mut reasons: BTreeMap<&str, usize> = BTreeMap::new();
    for empty in &built.empty {
        *reasons.entry(&empty.reason).or_default() += 1;
    }
    for (reason, count) in reasons {
        text += &format!("empty: {count}, since {reason}\n");
    }
    text + &if built.finished {
        format!("written to {}\n", built.file)
    } else {
        let done = built.table.filled + built.empty.len();
        format!(
            "stopped with {done} cases done, of {} asked for; nothing is lost: {} holds them, and the same command \
             goes on from there\n",
            built.cases, built.file
        )
    }
}

fn plan_text(plan: &Plan) -> String {
    let basis = match plan.measured {
        0 => "times measured on one machine; yours may take half or twice as long".to_owned(),
        n => format!("the {n} cases solved so far"),
    };
    format!(
        "cases: {}, done: {}\nestimate: {} s a case, {} in all with {} at a time\nby {basis}\n",
        plan.cases,
        plan.done,
        number((10.0 * plan.seconds_per_case).round() / 10.0),
        duration(plan.seconds),
        plan.threads,
    )
}

fn in_words([alpha, phi, delta]: [f64; 3]) -> String {
    format!("alpha {}, phi {}, delta {}", number(alpha), number(phi), number(delta))
}
