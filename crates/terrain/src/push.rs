use crate::error::{TerrainError, within};
use crate::field::HeightField;

/// Way of a plate over the box: a rectangle as wide as the plate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sweep {
    /// Middle of the plate's lower edge at the begin, in m.
    pub from_m: [f64; 2],
    /// The same at the end.
    pub to_m: [f64; 2],
    /// Width of the plate across its way in m, above 0.
    pub width_m: f64,
    /// Height of the lower edge in m.
    pub bottom_m: f64,
    /// The soil is left within this length ahead of the end, in m, above 0.
    pub ahead_m: f64,
}

/// Points a cell and direction that stand for the area around them.
const POINTS: f64 = 4.0;
/// The most points along a side, so that a sweep has an end.
const MOST_POINTS: usize = 4096;

impl HeightField {
    /// Pours a volume (m3, 0 to 1e6) evenly over a disc around a place; radius and place in m.
    ///
    /// # Errors
    /// [`TerrainError::OutOfRange`], [`TerrainError::Outside`] if the disc holds no cell's centre.
    pub fn pour(&mut self, place_m: [f64; 2], radius_m: f64, volume_m3: f64) -> Result<(), TerrainError> {
        within("radius", radius_m, "m", [0.0, 1e6], "0 to 1e6 m")?;
        within("volume", volume_m3, "m3", [0.0, 1e6], "0 to 1e6 m3")?;
        let (columns, cell_m) = (self.columns(), self.cell_m());
        #[allow(clippy::cast_precision_loss, reason = "at most 2^24 cells")]
        let inside: Vec<usize> = (0..self.heights_m.len())
            .filter(|k| {
                let centre = [(k % columns) as f64 + 0.5, (k / columns) as f64 + 0.5];
                libm::hypot(centre[0] * cell_m - place_m[0], centre[1] * cell_m - place_m[1]) <= radius_m
            })
            .collect();
        if inside.is_empty() {
            return Err(self.outside("the disc"));
        }
        #[allow(clippy::cast_precision_loss, reason = "at most 2^24 cells")]
        let rise = volume_m3 / (inside.len() as f64 * cell_m * cell_m);
        for cell in inside {
            self.heights_m[cell] += rise;
        }
        Ok(())
    }

    /// Moves what lies above a plate's lower edge along its way to the ground ahead of it; returns the volume in m3.
    ///
    /// What the rectangle ahead has outside the box falls to the part inside, so nothing is lost. A way that is outside
    /// altogether moves nothing.
    ///
    /// # Errors
    /// [`TerrainError::OutOfRange`] of a number that is not finite or not above 0 where it must be.
    pub fn push(&mut self, sweep: &Sweep) -> Result<f64, TerrainError> {
        for place in [sweep.from_m, sweep.to_m] {
            for value in place {
                within("place of the plate", value, "m", [-1e6, 1e6], "-1e6 to 1e6 m")?;
            }
        }
        within("width of the plate", sweep.width_m, "m", [1e-6, 1e6], "1e-6 to 1e6 m")?;
        within("length ahead", sweep.ahead_m, "m", [1e-6, 1e6], "1e-6 to 1e6 m")?;
        within("height of the lower edge", sweep.bottom_m, "m", [-1e6, 1e6], "-1e6 to 1e6 m")?;
        let way = [sweep.to_m[0] - sweep.from_m[0], sweep.to_m[1] - sweep.from_m[1]];
        let length = libm::hypot(way[0], way[1]);
        if length == 0.0 {
            return Ok(0.0);
        }
        let ahead = [way[0] / length, way[1] / length];
        let from = self.points(sweep.from_m, ahead, length, sweep.width_m);
        let to = self.points(sweep.to_m, ahead, sweep.ahead_m, sweep.width_m);
        if to.cells.is_empty() {
            return Ok(0.0);
        }
        let cell_area = self.cell_m() * self.cell_m();
        let mut taken_m3 = 0.0;
        for cell in from.cells {
            let above = self.heights_m[cell] - sweep.bottom_m;
            // A point's share of its cell, and never more than there is.
            let cut = (above * (from.area_m2 / cell_area).min(1.0)).max(0.0);
            self.heights_m[cell] -= cut;
            taken_m3 += cut * cell_area;
        }
        #[allow(clippy::cast_precision_loss, reason = "at most 2^24 points")]
        let rise = taken_m3 / (to.cells.len() as f64 * cell_area);
        for cell in to.cells {
            self.heights_m[cell] += rise;
        }
        Ok(taken_m3)
    }

    /// Mean height in m over a rectangle that begins at `from_m`, is `length_m` long along `to_m - from_m` and `width_m`
    /// wide; `None` if nothing of it is inside.
    #[must_use]
    pub fn mean_height_m(
        &self,
        from_m: [f64; 2],
        ahead: [f64; 2],
        length_m: f64,
        width_m: f64,
    ) -> Option<f64> {
        let size = libm::hypot(ahead[0], ahead[1]);
        let usable = size.is_finite() && size > 0.0 && length_m > 0.0 && width_m > 0.0;
        if !usable || !(length_m * width_m).is_finite() {
            return None;
        }
        let points = self.points(from_m, [ahead[0] / size, ahead[1] / size], length_m, width_m);
        let sum: f64 = points.cells.iter().map(|cell| self.heights_m[*cell]).sum();
        #[allow(clippy::cast_precision_loss, reason = "at most 2^24 points")]
        let count = points.cells.len() as f64;
        (count > 0.0).then(|| sum / count)
    }

    /// Even points over a rectangle: the cells that hold them (those inside), and the area of one.
    fn points(&self, from_m: [f64; 2], ahead: [f64; 2], length_m: f64, width_m: f64) -> Points {
        let count = |side: f64| {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "limited")]
            let points = (side / self.cell_m() * POINTS).ceil() as usize;
            points.clamp(1, MOST_POINTS)
        };
        let (long, wide) = (count(length_m), count(width_m));
        #[allow(clippy::cast_precision_loss, reason = "small numbers")]
        let (step, across) = (length_m / long as f64, width_m / wide as f64);
        let mut cells = Vec::with_capacity(long * wide);
        for a in 0..long {
            for b in 0..wide {
                #[allow(clippy::cast_precision_loss, reason = "small numbers")]
                let (u, v) = ((a as f64 + 0.5) * step, (b as f64 + 0.5) * across - 0.5 * width_m);
                cells.extend(self.cell_of([
                    from_m[0] + u * ahead[0] - v * ahead[1],
                    from_m[1] + u * ahead[1] + v * ahead[0],
                ]));
            }
        }
        Points { cells, area_m2: step * across }
    }

    fn outside(&self, what: &'static str) -> TerrainError {
        let [x_m, y_m] = self.size_m();
        TerrainError::Outside { what, x_m, y_m }
    }
}

struct Points {
    cells: Vec<usize>,
    area_m2: f64,
}
