//! Batches that stand for a whole campaign.

use std::collections::BTreeMap;

use crate::data::Data;

impl Data {
    /// Numbers of batches that hold at least so many strokes and stand for the campaign: each in turn is the one with most strokes of kinds (tool angle
    /// and radius) that those before it lack, of these the one that is farthest from them in time. `None` if it takes all of them, or if
    /// batches are not numbered.
    #[must_use]
    pub fn sample(&self, strokes: usize) -> Option<Vec<usize>> {
        let mut left: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (i, row) in self.rows.iter().enumerate() {
            left.entry(row.batch.as_ref()?.parse().ok()?).or_default().push(i);
        }
        let (mut chosen, mut taken): (Vec<usize>, Vec<usize>) = (Vec::new(), Vec::new());
        while taken.len() < strokes {
            let worth = |number: usize, of: &[usize]| {
                let is_new = |i: &&usize| !self.kind(**i).iter().any(|of_kind| taken.contains(of_kind));
                let apart = chosen.iter().map(|other: &usize| number.abs_diff(*other)).min();
                (of.iter().filter(is_new).count(), apart, std::cmp::Reverse(number))
            };
            let next =
                left.iter().max_by_key(|(number, of)| worth(**number, of)).map(|(number, _)| *number)?;
            taken.extend(left.remove(&next)?);
            chosen.push(next);
        }
        chosen.sort_unstable();
        (!left.is_empty()).then_some(chosen)
    }

    /// Which strokes are of these batches.
    #[must_use]
    pub fn of_batches(&self, batches: &[usize]) -> Vec<bool> {
        let is_of = |batch: &String| batch.parse().is_ok_and(|number| batches.contains(&number));
        self.rows.iter().map(|row| row.batch.as_ref().is_some_and(is_of)).collect()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use soilctl_strokes::{Campaign, StrokeRow};

    use super::*;

    fn campaign(batches: &[(&str, [f64; 3])]) -> Data {
        let row = |batch: &str, alpha_deg: f64| StrokeRow {
            batch: Some(batch.to_owned()),
            alpha_deg,
            depth_m: 0.025,
            width_m: 0.1,
            force_n: 5.0,
            ..StrokeRow::default()
        };
        let rows = batches.iter().flat_map(|(batch, angles)| angles.map(|alpha| row(batch, alpha)));
        Data::new("t", rows.collect(), Campaign::default()).unwrap()
    }

    /// First what has other tool angles, then what is far away; as many as it takes.
    #[test]
    fn a_sample_has_all_kinds_and_goes_far() {
        let plain = [90.0; 3];
        let data = campaign(&[
            ("0", plain),
            ("1", plain),
            ("2", [90.0, 80.0, 80.0]),
            ("3", plain),
            ("4", [100.0; 3]),
            ("5", plain),
        ]);
        assert_eq!(data.sample(3), Some(vec![0]));
        assert_eq!(data.sample(4), Some(vec![0, 4]));
        assert_eq!(data.sample(9), Some(vec![0, 2, 4]));
        assert_eq!(data.sample(10), Some(vec![0, 1, 2, 4]));
        assert_eq!(data.sample(16), None);
        assert_eq!(data.sample(19), None);
        let of: Vec<usize> = data.of_batches(&[4, 0]).iter().map(|of| usize::from(*of)).collect();
        assert_eq!(of, [vec![1; 3], vec![0; 9], vec![1; 3], vec![0; 3]].concat());
        assert_eq!(campaign(&[("a", plain), ("1", plain)]).sample(3), None);
    }
}
