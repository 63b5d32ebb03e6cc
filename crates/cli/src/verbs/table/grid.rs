//! The nodes of a table.

use std::str::FromStr;

use clap::ValueEnum;

/// Grids by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum Grid {
    /// The 287 sets of the thesis, Appendix C
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

/// Most nodes along one axis.
const MAX_NODES: f64 = 10_000.0;

/// Evenly spaced nodes in degrees, both ends included.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Nodes(pub(super) Vec<f64>);

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
        let count = steps.round() as usize;
        // From both ends, so that the last node is exactly TO.
        let node = |i: usize| if i == count { to } else { from + step * i as f64 };
        Ok(Self((0..=count).map(node).collect()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ends_are_nodes() {
        assert_eq!("70:85:5".parse(), Ok(Nodes(vec![70.0, 75.0, 80.0, 85.0])));
        let fine: Nodes = "25:26:0.1".parse().unwrap();
        assert_eq!((fine.0.len(), fine.0[10]), (11, 26.0));
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
