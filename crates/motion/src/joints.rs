//! Where the joints are at any time.

use soilctl_stats::median;

use crate::Series;

/// Joint states further apart than this, and than three usual intervals, are not interpolated, in s.
const MOST_GAP_S: f64 = 0.25;
/// A joint that moved by less than this across a gap stood still, in rad or m.
const STILL: f64 = 1e-5;

/// Median of the steps between times; 0 of fewer than two.
#[must_use]
pub fn usual_interval(t_s: &[f64]) -> f64 {
    let mut steps: Vec<f64> = t_s.windows(2).map(|pair| pair[1] - pair[0]).collect();
    median(&mut steps)
}

/// Positions of all joints at rising times.
#[derive(Debug, Clone)]
pub struct Joints<'a> {
    series: &'a [Series<f64>],
    most_gap_s: Vec<f64>,
    /// The last value of each at or before the present time.
    places: Vec<usize>,
    positions: Vec<f64>,
}

impl<'a> Joints<'a> {
    /// Of these joints, before the first time.
    #[must_use]
    pub fn new(series: &'a [Series<f64>]) -> Self {
        let most_gap_s = series.iter().map(|s| MOST_GAP_S.max(3.0 * usual_interval(&s.t_s))).collect();
        let (places, positions) = (vec![0; series.len()], vec![0.0; series.len()]);
        Self { series, most_gap_s, places, positions }
    }

    /// The same from a time on.
    #[must_use]
    pub fn starting(&self, t_s: f64) -> Self {
        let mut started = self.clone();
        for (place, series) in started.places.iter_mut().zip(self.series) {
            *place = series.t_s.partition_point(|known| *known <= t_s).saturating_sub(1);
        }
        started
    }

    /// Linear between neighbours; `None` before the first of any joint, after the last, or in a gap in which it moved. Times must
    /// not fall from call to call.
    pub fn at(&mut self, t_s: f64) -> Option<&[f64]> {
        for (number, series) in self.series.iter().enumerate() {
            let place = &mut self.places[number];
            while series.t_s.get(*place + 1).is_some_and(|next| *next <= t_s) {
                *place += 1;
            }
            let (before_s, before) = (*series.t_s.get(*place)?, series.values[*place]);
            if before_s > t_s {
                return None;
            }
            self.positions[number] = match series.t_s.get(*place + 1) {
                _ if before_s == t_s => before,
                // A few intervals beyond the last it will still be there.
                None if t_s - before_s < self.most_gap_s[number] / 3.0 => before,
                None => return None,
                Some(after_s) => {
                    let (step_s, after) = (after_s - before_s, series.values[*place + 1]);
                    if step_s > self.most_gap_s[number] && (after - before).abs() > STILL {
                        return None;
                    }
                    before + (t_s - before_s) / step_s * (after - before)
                }
            };
        }
        Some(&self.positions)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joints_are_interpolated_but_not_across_gaps_in_which_they_move() {
        let first = Series {
            t_s: vec![0.0, 0.05, 0.1, 0.15, 0.2, 1.2, 2.2],
            values: vec![0.0, 0.5, 1.0, 1.5, 2.0, 2.0, 3.0],
        };
        let second = Series { t_s: vec![0.05, 0.1, 0.15, 0.2, 0.3, 1.0, 2.0, 2.2], values: vec![1.0; 8] };
        let series = [first, second];
        let mut joints = Joints::new(&series);
        assert_eq!(joints.at(0.01), None);
        assert_eq!(joints.at(0.05), Some(&[0.5, 1.0][..]));
        assert_eq!(joints.at(0.1), Some(&[1.0, 1.0][..]));
        assert_eq!(joints.at(0.7), Some(&[2.0, 1.0][..]));
        assert_eq!(joints.at(1.7), None);
        assert_eq!(joints.at(2.2), Some(&[3.0, 1.0][..]));
        assert_eq!(joints.at(9.0), None);
        assert_eq!(joints.starting(0.1).at(0.12), Joints::new(&series).at(0.12));
        assert_eq!(joints.starting(-1.0).at(0.05), Some(&[0.5, 1.0][..]));
        assert_eq!(Joints::new(&[Series::default()]).at(0.0), None);
    }
}
