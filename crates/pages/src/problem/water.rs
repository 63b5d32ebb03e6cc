//! The water table: a blue line with the inverted triangle that marks a free water level.

use soilctl_figure::{Figure, Paths};
use soilctl_limit_analysis::results::Point;

use super::WATER;
use super::place::{Scale, along, between, ring};
use crate::PageError;

/// Where on its longest piece the triangle stands.
const MARK: f64 = 0.12;

pub(super) fn add(figure: &mut Figure, table: &[Vec<Point>], scale: &Scale) -> Result<(), PageError> {
    if table.is_empty() {
        return Ok(());
    }
    let lines: Vec<_> = table.iter().map(|line| ring(line)).collect();
    figure.push(Paths::new("water table", lines).width(2.0).color(WATER))?;
    let steps =
        table.iter().flat_map(|line| line.windows(2)).filter_map(|step| <[Point; 2]>::try_from(step).ok());
    if let Some(longest) = steps.max_by(|a, b| along(*a).0.total_cmp(&along(*b).0)) {
        let [x, y] = between(longest, MARK);
        let px = |count: f64| scale.px(count);
        let triangle = [[x, y], [x + px(7.0), y + px(12.0)], [x - px(7.0), y + px(12.0)], [x, y]];
        let under = |down: f64, half: f64| [[x - px(half), y - px(down)], [x + px(half), y - px(down)]];
        let parts = vec![ring(&triangle), ring(&under(3.5, 5.0)), ring(&under(6.5, 2.5))];
        figure.push(Paths::new("", parts).width(1.5).color(WATER))?;
    }
    Ok(())
}
