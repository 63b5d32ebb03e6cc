//! One clock for a campaign of many logs.

use super::StrokeRecord;

/// Puts the times of the strokes, given log by log, on one clock.
///
/// Logs of one arm on one clock never overlap. Where they do, each counts from its own beginning: the order of the logs is then
/// that of the campaign, and each log goes on where the one before it ended. How long the preparations between them took,
/// such logs do not say. `failure_time_s` stays on the clock of the log.
pub fn put_on_one_clock(strokes: &mut [StrokeRecord]) {
    let mut logs: Vec<&mut [StrokeRecord]> =
        strokes.chunk_by_mut(|a, b| a.failure.log == b.failure.log).collect();
    let mut spans: Vec<(f64, f64)> = logs.iter().filter_map(|log| span(log)).collect();
    spans.sort_by(|a, b| a.0.total_cmp(&b.0));
    if spans.windows(2).all(|pair| pair[0].1 <= pair[1].0) {
        return;
    }
    let first_s = spans[0].0;
    let mut elapsed_s = 0.0;
    for log in &mut logs {
        let Some((_, end_s)) = span(log) else { continue };
        for time_s in log.iter_mut().filter_map(|stroke| stroke.row.time_s.as_mut()) {
            *time_s += elapsed_s;
        }
        elapsed_s += end_s - first_s;
    }
}

/// First and last time in s that strokes of a log state; `None` if none does.
fn span(log: &[StrokeRecord]) -> Option<(f64, f64)> {
    let of = |stroke: &StrokeRecord| {
        let time_s = stroke.row.time_s;
        [time_s, time_s.and(stroke.failure.failure_time_s)]
    };
    let times = || log.iter().flat_map(of).flatten();
    let first = times().reduce(f64::min)?;
    Some((first, times().fold(first, f64::max)))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strokes(logs: &[(&str, &[f64])]) -> Vec<StrokeRecord> {
        let stroke = |log: &str, time_s: f64| {
            let mut stroke = StrokeRecord::default();
            stroke.failure.log = log.into();
            stroke.row.time_s = Some(time_s);
            stroke.failure.failure_time_s = Some(time_s + 10.0);
            stroke
        };
        logs.iter().flat_map(|(log, times)| times.iter().map(|t| stroke(log, *t))).collect()
    }

    fn times(mut strokes: Vec<StrokeRecord>) -> Vec<f64> {
        put_on_one_clock(&mut strokes);
        strokes.iter().filter_map(|stroke| stroke.row.time_s).collect()
    }

    #[test]
    fn logs_that_each_begin_at_zero_follow_one_another() {
        let found = times(strokes(&[("a", &[24.0, 72.0]), ("b", &[22.0, 70.0]), ("c", &[24.0])]));
        // The earliest reading, 22 s, is where every clock begins.
        assert_eq!(found, [24.0, 72.0, 82.0, 130.0, 142.0]);
        let found = times(strokes(&[("a", &[5000.0]), ("b", &[5000.0])]));
        assert_eq!(found, [5000.0, 5010.0]);
    }

    #[test]
    fn one_clock_is_left_as_it_is_whatever_the_order_of_the_files() {
        let found = times(strokes(&[("a", &[5000.0, 5100.0]), ("b", &[1000.0, 1100.0])]));
        assert_eq!(found, [5000.0, 5100.0, 1000.0, 1100.0]);
        assert_eq!(times(strokes(&[("a", &[3.0, 1.0])])), [3.0, 1.0]);
    }
}
