//! What the change of the ground says of a stroke: where it rose ahead of the plate, and how much soil was moved.

mod edge;
mod lines;
mod volume;

use lines::Lines;

use crate::change::Change;
use crate::error::within;
use crate::{HeightMap, HeightsError};

pub use edge::NoBreak;
pub use volume::Volume;

/// Where the plate stood when the second map was taken, or when it was drawn out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plate {
    /// Middle of its face at the surface, in m, in the frame of the maps.
    pub at_m: [f64; 2],
    /// Standard deviation of that along the heading, in m; 0 or more.
    pub sd_m: f64,
    /// Where it pushed to, in deg counter-clockwise from the x axis.
    pub heading_deg: f64,
    /// Its width in m, above 0.
    pub width_m: f64,
}

impl Plate {
    /// # Errors
    /// [`HeightsError::OutOfRange`] for numbers outside of what their fields allow.
    pub fn check(&self) -> Result<(), HeightsError> {
        for x in self.at_m {
            within("place of the plate", x, "m", [-1e8, 1e8], "within 1e8 m of zero")?;
        }
        within("standard deviation of the plate's place", self.sd_m, "m", [0.0, 10.0], "0 to 10 m")?;
        within("heading", self.heading_deg, "deg", [-360.0, 360.0], "-360 to 360 deg")?;
        within("width of the plate", self.width_m, "m", [1e-4, 100.0], "0.0001 to 100 m")?;
        Ok(())
    }

    /// Unit vector along the heading.
    fn ahead(&self) -> [f64; 2] {
        let (sine, cosine) = libm::sincos(self.heading_deg.to_radians());
        [cosine, sine]
    }

    /// How far a place (m) is ahead of the face, and to the left of its middle, in m.
    #[must_use]
    pub fn seen_from(&self, place: [f64; 2]) -> [f64; 2] {
        let ([c, s], [x, y]) = (self.ahead(), [place[0] - self.at_m[0], place[1] - self.at_m[1]]);
        [c * x + s * y, c * y - s * x]
    }

    /// The place (m) so far ahead of the face and to the left of its middle.
    #[must_use]
    pub fn place(&self, [ahead, left]: [f64; 2]) -> [f64; 2] {
        let [c, s] = self.ahead();
        [self.at_m[0] + c * ahead - s * left, self.at_m[1] + s * ahead + c * left]
    }

    /// Whether a place is on the plate's line, with half its width more on either side.
    pub(crate) fn path(&self, place: [f64; 2]) -> bool {
        self.seen_from(place)[1].abs() <= self.width_m
    }
}

/// Where the ground broke.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Break {
    /// Distance from the plate's face along the surface, in m.
    pub distance_m: f64,
    /// Its standard deviation (m): noise, how ragged the edge is over the plate's width, and the plate's place.
    pub sd_m: f64,
    /// Half of the distance between neighbouring heights, in m: within it the edge may be anywhere, whatever the noise.
    pub resolution_m: f64,
    /// Where the edge is by each part of the plate's width, from right to left, in m; nothing where it does not show.
    pub parts_m: [Option<f64>; lines::PARTS],
    /// Where the ground rises once more farther ahead, in m.
    pub again_m: Option<f64>,
}

/// Change of height ahead of the plate's middle half.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// Horizontal distances ahead of the face, in m.
    pub ahead_m: Vec<f64>,
    /// Mean change of height (m) over the lines; nothing where less than half of them was seen.
    pub rise_m: Vec<Option<f64>>,
    /// Standard deviation (m) of such a mean where nothing happened.
    pub noise_m: f64,
    /// Lines over the plate's width.
    pub lines: usize,
}

/// What a stroke did to the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct Stroke {
    /// Where the ground broke, or why that cannot be said.
    pub broke: Result<Break, NoBreak>,
    /// Slope of the ground ahead of the plate before the stroke, in deg, positive where it rises.
    pub slope_deg: f64,
    /// What rose.
    pub heap: Volume,
    /// What sank.
    pub furrow: Volume,
    /// Heap over furrow, and its standard deviation; nothing without a furrow that stands out of the noise.
    pub swelling: Option<[f64; 2]>,
    /// Change of height ahead of the plate.
    pub profile: Profile,
    /// Cells that changed elsewhere, and are not counted.
    pub elsewhere: usize,
}

/// Reads a stroke out of a change. What rises or sinks counts if it stands out of the noise by `deviations` (1 to 10).
///
/// # Errors
/// [`HeightsError::OutOfRange`] for a plate or deviations that make no sense.
pub fn stroke(
    before: &HeightMap,
    change: &Change,
    plate: &Plate,
    deviations: f64,
) -> Result<Stroke, HeightsError> {
    plate.check()?;
    within("deviations", deviations, "", [1.0, 10.0], "from 1 to 10")?;
    let lines = Lines::new(change, plate);
    let profile = lines.profile();
    let edge = edge::find(&profile.rise_m, lines.noise, deviations, plate.width_m / lines.step_m);
    let reach = edge.as_ref().map_or(plate.width_m, |edge| edge.at * lines.step_m);
    let slope = slope(before, plate, reach);
    // Along the surface it is farther than on the map.
    let along = (1.0 + slope * slope).sqrt() * lines.step_m;
    let broke = edge.map(|edge| {
        let parts = lines.parts(deviations);
        let found: Vec<f64> = parts.iter().flatten().copied().collect();
        let spread =
            soilctl_stats::mean_and_sd(&found).map_or(0.0, |(_, sd)| sd / (found.len() as f64).sqrt());
        // A level that is off moves the foot of a gentle slope.
        let level = if edge.fall > 0.0 { change.shift.up_sd_m / edge.fall } else { 0.0 };
        let random = libm::sqrt(edge.sd * edge.sd + spread * spread + level * level);
        Break {
            distance_m: along * edge.at,
            sd_m: libm::hypot(along * random, plate.sd_m),
            resolution_m: 0.5 * along * (change.finest_m / lines.step_m),
            parts_m: parts.map(|part| part.map(|at| along * at)),
            again_m: edge.again.map(|at| along * at),
        }
    });
    let [heap, furrow, elsewhere] = volume::volumes(change, plate, deviations);
    let swelling = (furrow.m3 > 2.0 * furrow.sd_m3 && furrow.m3 > 0.0).then(|| {
        let ratio = heap.m3 / furrow.m3;
        [ratio, libm::hypot(heap.sd_m3, ratio * furrow.sd_m3) / furrow.m3]
    });
    Ok(Stroke {
        broke,
        slope_deg: libm::atan(slope).to_degrees(),
        heap,
        furrow,
        swelling,
        profile,
        elsewhere: elsewhere.cells,
    })
}

/// Slope of the ground ahead of the plate before the stroke, along the heading; 0 where it was not seen.
fn slope(before: &HeightMap, plate: &Plate, reach_m: f64) -> f64 {
    let grid = before.grid();
    let rows = before.heights_m().iter().enumerate().filter_map(|(cell, height)| {
        let [ahead, left] = plate.seen_from(grid.place(cell));
        let is_ahead = (0.0..=reach_m).contains(&ahead) && left.abs() <= 0.5 * plate.width_m;
        height.filter(|_| is_ahead).map(|height| ([1.0, ahead, left], height, 1.0))
    });
    soilctl_stats::least_squares(rows).map_or(0.0, |solved| solved.x[1])
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn ahead_and_left_are_those_of_the_heading() {
        let plate = Plate { at_m: [1.0, 2.0], sd_m: 0.0, heading_deg: 90.0, width_m: 0.1 };
        for (place, expected) in [([1.0, 2.5], [0.5, 0.0]), ([0.7, 2.0], [0.0, 0.3])] {
            let found = plate.seen_from(place);
            assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
            let back = plate.place(found);
            assert!(back.iter().zip(place).all(|(a, b)| (a - b).abs() < 1e-12), "{back:?}");
        }
    }
}
