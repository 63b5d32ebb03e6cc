use serde::{Deserialize, Serialize};
use soilctl_strokes::StrokeRow;

use crate::{Covariate, EffectsError, Reference};

/// A factor on the force that goes with one recorded condition or two and has no name: what a diagnosis offers where no effect of the catalogue explains
/// the strokes. ln of the factor is given at the points of a grid, linear between them (bilinear over two conditions), and beyond the grid what it
/// is at its edge; a stroke without the condition is left alone.
///
/// It tells what these strokes did and no more: without a law behind it, it says nothing of conditions that they did not have.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EmpiricalTerm {
    /// The conditions, one or two.
    pub over: Vec<Covariate>,
    /// Values of each condition, ascending, in the unit of its column; of `batch` its place in the reference's `batches`, from 0.
    pub at: Vec<Vec<f64>>,
    /// Change of ln force at each point of the grid, those of the last condition one after the other.
    pub ln_force: Vec<f64>,
    /// Standard deviation of each.
    pub sd: Vec<f64>,
    /// ln Bayes factor over the explanation without it; 0 if written by hand.
    #[serde(default)]
    pub log_bayes_factor: f64,
}

/// Largest change of ln force that a term may have: a factor of 20.
const MOST: f64 = 3.0;

/// Part of the range of a grid by which a stroke may lie beyond it and still count as within.
const MARGIN: f64 = 0.02;

impl EmpiricalTerm {
    /// Checks it; `file` stands for the model file in messages.
    ///
    /// # Errors
    /// [`EffectsError::BadFile`] with what is wrong and what is allowed.
    pub fn check(&self, file: &str) -> Result<(), EffectsError> {
        let bad = |problem: &str| {
            Err(EffectsError::BadFile { file: file.into(), problem: format!("an empirical term {problem}") })
        };
        match self.over.as_slice() {
            [_] => {}
            [a, b] if a != b => {}
            _ => return bad("is over one condition or two different ones"),
        }
        let ascends = |values: &Vec<f64>| {
            !values.is_empty()
                && values.iter().all(|value| value.is_finite())
                && values.windows(2).all(|pair| pair[0] < pair[1])
        };
        if self.at.len() != self.over.len() || !self.at.iter().all(ascends) {
            return bad("has in `at` the values of each condition, finite and ascending");
        }
        let points = self.at.iter().map(Vec::len).product::<usize>();
        if self.ln_force.len() != points || self.sd.len() != points {
            return bad(&format!("has {points} points, and so many numbers in `ln_force` and `sd`"));
        }
        if self.ln_force.iter().any(|value| !(-MOST..=MOST).contains(value)) {
            return bad(&format!("has in `ln_force` numbers from {} to {MOST}", -MOST));
        }
        if self.sd.iter().any(|sd| !sd.is_finite() || *sd < 0.0) {
            return bad("has in `sd` finite numbers from 0");
        }
        Ok(())
    }

    /// Change of ln force of a stroke; 0 if one of the conditions is not recorded. Batches have their places in `reference`.
    #[must_use]
    pub fn ln_factor(&self, row: &StrokeRow, reference: &Reference) -> f64 {
        self.at_values(&|condition| condition.recorded(row, reference))
    }

    /// Whether a stroke has all conditions, within the grid.
    #[must_use]
    pub fn is_told(&self, row: &StrokeRow, reference: &Reference) -> bool {
        let within = |(condition, at): (&Covariate, &Vec<f64>)| {
            let ends = at.first().zip(at.last());
            let value = condition.recorded(row, reference);
            value.zip(ends).is_some_and(|(value, (low, high))| {
                // Readings of one condition scatter.
                let margin = MARGIN * (high - low);
                (low - margin..=high + margin).contains(&value)
            })
        };
        self.over.iter().zip(&self.at).all(within)
    }

    /// Change of ln force where the conditions have these values; 0 if one of them has none.
    #[must_use]
    pub fn at_values(&self, value: &dyn Fn(Covariate) -> Option<f64>) -> f64 {
        let places: Option<Vec<(usize, f64)>> = self
            .over
            .iter()
            .zip(&self.at)
            .map(|(condition, at)| Some(place(at, value(*condition)?)))
            .collect();
        match places.as_deref() {
            Some(&[(i, share)]) => between(&self.ln_force, i, share),
            Some(&[(i, share), (j, other)]) => {
                let width = self.at[1].len();
                let lines: Vec<f64> =
                    self.ln_force.chunks(width).map(|line| between(line, j, other)).collect();
                between(&lines, i, share)
            }
            _ => 0.0,
        }
    }
}

/// The interval of ascending values in which a value lies, and the share of it that lies below; held at the ends.
fn place(at: &[f64], value: f64) -> (usize, f64) {
    let after = at.partition_point(|known| *known <= value);
    if after == 0 || after == at.len() {
        return (after.saturating_sub(1), 0.0);
    }
    (after - 1, (value - at[after - 1]) / (at[after] - at[after - 1]))
}

fn between(values: &[f64], from: usize, share: f64) -> f64 {
    match (values.get(from), values.get(from + 1)) {
        (Some(a), Some(b)) => a + share * (b - a),
        (Some(a), None) => *a,
        (None, _) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    fn term(over: &[Covariate], at: &[&[f64]], ln_force: &[f64]) -> EmpiricalTerm {
        EmpiricalTerm {
            over: over.to_vec(),
            at: at.iter().map(|values| values.to_vec()).collect(),
            ln_force: ln_force.to_vec(),
            sd: vec![0.01; ln_force.len()],
            log_bayes_factor: 0.0,
        }
    }

    #[test]
    fn linear_between_points_and_held_beyond() {
        let bump = term(&[Covariate::ToolAngle], &[&[70.0, 80.0, 100.0]], &[0.0, 0.2, -0.2]);
        bump.check("t").unwrap();
        let at = |alpha: f64| bump.at_values(&|_| Some(alpha));
        for (alpha, expected) in
            [(60.0, 0.0), (75.0, 0.1), (80.0, 0.2), (90.0, 0.0), (100.0, -0.2), (130.0, -0.2)]
        {
            assert!((at(alpha) - expected).abs() < 1e-12, "{alpha}");
        }
        assert_eq!(bump.at_values(&|_| None), 0.0);
        let row = |alpha_deg| StrokeRow { alpha_deg, ..StrokeRow::default() };
        let reference = Reference::of(&[row(80.0)]).unwrap();
        assert_eq!(
            [69.5, 100.5, 69.0, 110.0].map(|a| bump.is_told(&row(a), &reference)),
            [true, true, false, false]
        );
    }

    /// A product of two conditions is bilinear: four corners are all of it.
    #[test]
    fn a_product_is_exact_by_its_corners() {
        let product = |x: f64, y: f64| 0.1 * (x - 80.0) * (y - 0.03) + 0.02;
        let (xs, ys) = ([70.0, 100.0], [0.02, 0.05]);
        let corners: Vec<f64> = xs.iter().flat_map(|x| ys.map(|y| product(*x, y))).collect();
        let of = term(&[Covariate::ToolAngle, Covariate::Depth], &[&xs, &ys], &corners);
        of.check("t").unwrap();
        for (x, y) in [(70.0, 0.02), (77.0, 0.031), (95.0, 0.044), (100.0, 0.05)] {
            let found = of.at_values(&|c| Some(if c == Covariate::Depth { y } else { x }));
            assert!((found - product(x, y)).abs() < 1e-12, "{x} {y}");
        }
    }

    #[test]
    fn a_batch_is_found_by_its_name_and_columns_by_theirs() {
        let text = r#"{"over":["batch"],"at":[[0,1]],"ln_force":[0.1,0.3],"sd":[0.0,0.0]}"#;
        let term: EmpiricalTerm = serde_json::from_str(text).unwrap();
        let row =
            |name: &str| StrokeRow { batch: Some(name.into()), alpha_deg: 90.0, ..StrokeRow::default() };
        let mut reference = Reference::of(&[row("a"), row("b")]).unwrap();
        reference.batches = vec!["a".into(), "b".into()];
        assert_eq!([("a"), ("b"), ("c")].map(|name| term.ln_factor(&row(name), &reference)), [0.1, 0.3, 0.0]);
        assert_eq!(serde_json::to_value(&term).unwrap()["over"][0], "batch");
        assert!(serde_json::from_str::<EmpiricalTerm>(&text.replace("batch", "colour")).is_err());
    }

    #[test]
    fn what_is_no_term_is_refused_in_words() {
        let angle = Covariate::ToolAngle;
        for (wrong, word) in [
            (term(&[], &[], &[0.0]), "one condition or two"),
            (term(&[angle, angle], &[&[1.0], &[1.0]], &[0.0]), "two different"),
            (term(&[angle], &[&[2.0, 1.0]], &[0.0, 0.0]), "ascending"),
            (term(&[angle], &[&[1.0, 2.0]], &[0.0]), "2 points"),
            (term(&[angle], &[&[1.0]], &[f64::NAN]), "from -3 to 3"),
        ] {
            let message = wrong.check("m.json").unwrap_err().to_string();
            assert!(message.contains("m.json") && message.contains(word), "{message}");
        }
    }
}
