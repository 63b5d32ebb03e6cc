//! The nodes of a table.

use std::str::FromStr;

use clap::ValueEnum;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::AppError;

/// Grids by name.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Grid {
    /// The 287 sets of the thesis, Appendix C
    #[default]
    AppendixC,
    /// Flatter and steeper tools, and any interface friction
    Wide,
}

impl Grid {
    /// Nodes of alpha, phi and delta in degrees.
    pub(super) fn axes(self) -> [Vec<f64>; 3] {
        let axis = |from: u32, to: u32, step: usize| (from..=to).step_by(step).map(f64::from).collect();
        match self {
            Self::AppendixC => [axis(70, 100, 5), axis(25, 50, 5), axis(0, 30, 5)],
            Self::Wide => [axis(30, 110, 10), axis(20, 55, 5), axis(0, 55, 5)],
        }
    }
}

/// Refuses nodes of which no table can be read: it needs two of phi and two of delta that have cases, which are those with delta up to phi.
pub(super) fn check_axes([_, phis, deltas]: &[Vec<f64>; 3]) -> Result<(), AppError> {
    let with_cases: [Vec<f64>; 2] = [
        phis.iter().copied().filter(|phi| deltas.iter().any(|delta| delta <= phi)).collect(),
        deltas.iter().copied().filter(|delta| phis.iter().any(|phi| delta <= phi)).collect(),
    ];
    for (option, nodes) in ["--phi", "--delta"].into_iter().zip(with_cases) {
        let found = match nodes[..] {
            [] => "no angle".to_owned(),
            [only] => format!("{only} deg alone"),
            _ => continue,
        };
        return Err(AppError::Request(format!(
            "of {option}, {found} has cases, since delta is never above phi; a table needs two angles along each axis: \
             begin --delta lower or go higher with --phi"
        )));
    }
    Ok(())
}

/// Most nodes along one axis.
const MAX_NODES: f64 = 10_000.0;

/// Evenly spaced nodes in degrees, both ends included; in text and JSON `FROM:TO:STEP`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Nodes {
    from: f64,
    to: f64,
    step: f64,
}

impl Nodes {
    pub(crate) fn values(&self) -> Vec<f64> {
        let Self { from, to, step } = self;
        let count = ((to - from) / step).round() as usize;
        // From both ends, so that the last node is exactly TO.
        let node = |i: usize| if i == count { *to } else { from + step * i as f64 };
        (0..=count).map(node).collect()
    }
}

impl FromStr for Nodes {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let bad = |problem: &str| format!("{problem}; it must be FROM:TO:STEP in degrees, such as 70:100:5");
        let numbers: Vec<f64> = text
            .split(':')
            .map(|part| part.trim().parse().ok().filter(|x: &f64| x.is_finite()))
            .collect::<Option<_>>()
            .ok_or_else(|| bad("a part is not a finite number"))?;
        let [from, to, step] = numbers[..] else { return Err(bad("it does not have three parts")) };
        if step <= 0.0 || to <= from {
            return Err(bad("FROM must be below TO and STEP above 0"));
        }
        let steps = (to - from) / step;
        if steps >= MAX_NODES {
            return Err(bad("it has more than 10000 nodes"));
        }
        if (steps - steps.round()).abs() > 1e-6 {
            return Err(bad("STEP does not lead from FROM to TO"));
        }
        Ok(Self { from, to, step })
    }
}

impl TryFrom<String> for Nodes {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        text.parse()
    }
}

impl From<Nodes> for String {
    fn from(Nodes { from, to, step }: Nodes) -> Self {
        format!("{from}:{to}:{step}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ends_are_nodes() {
        let values = |text: &str| text.parse::<Nodes>().unwrap().values();
        assert_eq!(values("70:85:5"), [70.0, 75.0, 80.0, 85.0]);
        assert_eq!((values("25:26:0.1").len(), values("25:26:0.1")[10]), (11, 26.0));
    }

    #[test]
    fn a_grid_with_cases_at_one_angle_is_refused() {
        let words = |phi: [f64; 2], delta: [f64; 2]| {
            let axes = [vec![80.0, 90.0], phi.to_vec(), delta.to_vec()];
            check_axes(&axes).map_or_else(|problem| problem.to_string(), |()| "taken".into())
        };
        assert_eq!(words([20.0, 25.0], [20.0, 25.0]), "taken");
        // Only 25 deg of friction reaches the rougher plates.
        assert!(words([20.0, 25.0], [25.0, 30.0]).contains("of --phi, 25 deg alone"));
        assert!(words([26.0, 29.0], [25.0, 30.0]).contains("of --delta, 25 deg alone"));
        assert!(words([20.0, 25.0], [30.0, 40.0]).contains("of --phi, no angle"));
    }

    #[test]
    fn what_is_no_range_is_refused() {
        for text in [
            "",
            "70",
            "70:100",
            "70:100:0",
            "100:70:5",
            "70:100:-5",
            "70:100:7",
            "a:b:c",
            "0:NaN:1",
            "0:1:1e-9",
        ] {
            assert!(text.parse::<Nodes>().unwrap_err().contains("FROM:TO:STEP"), "{text}");
        }
    }
}
