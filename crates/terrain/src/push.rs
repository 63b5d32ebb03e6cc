use crate::error::{TerrainError, within};
use crate::field::HeightField;
use crate::overlap::Rectangle;

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
    /// From each cell goes what the rectangle of the way covers of it. A plate that comes through a cell in several sweeps
    /// finds what the earlier ones have left beside their ways, until [`HeightField::lift`] ends the stroke; so many short
    /// sweeps take as much as one long one. What the rectangle ahead has outside the box falls to the part inside, so
    /// nothing is lost. A way that is outside altogether moves nothing.
    ///
    /// # Errors
    /// [`TerrainError::OutOfRange`] of a number that is not finite or not above 0 where it must be.
    pub fn push(&mut self, sweep: &Sweep) -> Result<f64, TerrainError> {
        self.push_past(sweep, 0.0)
    }

    /// The same, but a share of what is moved (0 to 1) runs past the plate and is left as a windrow on either side of the place where it is,
    /// half as wide as the length ahead. What a side has outside the box stays ahead.
    ///
    /// # Errors
    /// As of [`HeightField::push`], and [`TerrainError::OutOfRange`] of the share.
    pub fn push_past(&mut self, sweep: &Sweep, share_past: f64) -> Result<f64, TerrainError> {
        within("share that runs past the plate", share_past, "", [0.0, 1.0], "0 to 1")?;
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
        let (width_m, ahead_m) = (sweep.width_m, sweep.ahead_m);
        let from = self.covered(&Rectangle { from_m: sweep.from_m, ahead, length_m: length, width_m });
        let to = self.covered(&Rectangle { from_m: sweep.to_m, ahead, length_m: ahead_m, width_m });
        let room: f64 = to.iter().map(|(_, share)| share).sum();
        if room == 0.0 {
            return Ok(0.0);
        }
        let cell_area = self.cell_m() * self.cell_m();
        let mut taken_m3 = 0.0;
        for (cell, share) in from {
            let above = (self.heights_m[cell] - sweep.bottom_m).max(0.0);
            let untouched = 1.0 - self.swept[cell];
            let cut = if share < untouched { above * (share / untouched) } else { above };
            self.swept[cell] = (self.swept[cell] + share).min(1.0);
            self.heights_m[cell] -= cut;
            taken_m3 += cut * cell_area;
        }
        let mut left_m3 = taken_m3;
        if share_past > 0.0 {
            let (strip_m, past_m3) = (0.5 * ahead_m, 0.5 * share_past * taken_m3);
            for side in [-0.5, 0.5] {
                let off = side * (width_m + strip_m);
                let from_m = [sweep.to_m[0] - off * ahead[1], sweep.to_m[1] + off * ahead[0]];
                let strip = Rectangle { from_m, ahead, length_m: strip_m, width_m: strip_m };
                if self.lay(&self.covered(&strip), past_m3) {
                    left_m3 -= past_m3;
                }
            }
        }
        self.lay(&to, left_m3);
        Ok(taken_m3)
    }

    /// Lays a volume (m3) over cells in proportion to their shares; says whether there is room.
    fn lay(&mut self, cells: &[(usize, f64)], volume_m3: f64) -> bool {
        let room: f64 = cells.iter().map(|(_, share)| share).sum();
        if room > 0.0 {
            let height_m = volume_m3 / (self.cell_m() * self.cell_m());
            for (cell, share) in cells {
                self.heights_m[*cell] += height_m * (share / room);
            }
        }
        room > 0.0
    }

    /// The plate has left the ground: what it sweeps next, it sweeps anew.
    pub fn lift(&mut self) {
        self.swept.fill(0.0);
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
        let ahead = [ahead[0] / size, ahead[1] / size];
        let covered = self.covered(&Rectangle { from_m, ahead, length_m, width_m });
        let (sum, shares) = covered.iter().fold((0.0, 0.0), |(sum, shares), (cell, share)| {
            (sum + share * self.heights_m[*cell], shares + share)
        });
        (shares > 0.0).then(|| sum / shares)
    }

    fn outside(&self, what: &'static str) -> TerrainError {
        let [x_m, y_m] = self.size_m();
        TerrainError::Outside { what, x_m, y_m }
    }
}
