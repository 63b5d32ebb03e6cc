/// Heights of the soil's surface on a grid of square cells, in the base frame.
///
/// What is dug in one place is heaped in another, so that the volume stays the same but for rounding.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Surface {
    origin_m: [f64; 2],
    cell_m: f64,
    count: [usize; 2],
    height_m: Vec<f64>,
}

/// A rectangle seen from above: from a middle, half a width to both sides, and from one distance ahead to another.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Strip {
    pub(crate) middle_m: [f64; 2],
    /// Unit vector ahead.
    pub(crate) ahead: [f64; 2],
    pub(crate) half_width_m: f64,
    /// Nearest and farthest distance ahead in m.
    pub(crate) along_m: [f64; 2],
}

/// Points of a strip across and along.
const ACROSS: usize = 32;
const ALONG: usize = 16;

impl Surface {
    /// A level surface between walls across x and y.
    pub(crate) fn level([x_low, x_high]: [f64; 2], [y_low, y_high]: [f64; 2], cell_m: f64, z_m: f64) -> Self {
        let cells = |low: f64, high: f64| {
            let count = ((high - low) / cell_m).ceil().clamp(1.0, 1e4);
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to 1e4")]
            let count = count as usize;
            count
        };
        let count = [cells(x_low, x_high), cells(y_low, y_high)];
        Self { origin_m: [x_low, y_low], cell_m, count, height_m: vec![z_m; count[0] * count[1]] }
    }

    /// Level again, at this height.
    pub(crate) fn rake(&mut self, z_m: f64) {
        self.height_m.fill(z_m);
    }

    /// Volume of soil above the height 0 in m3; differences are what matters.
    pub(crate) fn volume_m3(&self) -> f64 {
        self.height_m.iter().sum::<f64>() * self.cell_m * self.cell_m
    }

    /// Mean height in a strip in m; at the walls the nearest cell counts.
    pub(crate) fn mean_height_m(&self, strip: &Strip) -> f64 {
        let mut sum = 0.0;
        strip.points(|point| sum += self.height_m[self.cell(point)]);
        #[allow(clippy::cast_precision_loss, reason = "small integers")]
        let count = (ACROSS * ALONG) as f64;
        sum / count
    }

    /// Moves a volume in m3 out of one strip into another; no cell is dug below `floor_m`. Says how much was moved.
    pub(crate) fn shift(&mut self, from: &Strip, to: &Strip, volume_m3: f64, floor_m: f64) -> f64 {
        #[allow(clippy::cast_precision_loss, reason = "small integers")]
        let count = (ACROSS * ALONG) as f64;
        let step_m = volume_m3 / (self.cell_m * self.cell_m) / count;
        let mut dug_m = 0.0;
        from.points(|point| {
            let cell = self.cell(point);
            let way_m = step_m.min(self.height_m[cell] - floor_m).max(0.0);
            self.height_m[cell] -= way_m;
            dug_m += way_m;
        });
        to.points(|point| {
            let cell = self.cell(point);
            self.height_m[cell] += dug_m / count;
        });
        dug_m * self.cell_m * self.cell_m
    }

    fn cell(&self, point_m: [f64; 2]) -> usize {
        let index: [usize; 2] = std::array::from_fn(|axis| {
            let at = ((point_m[axis] - self.origin_m[axis]) / self.cell_m).floor();
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "saturates; NaN gives 0"
            )]
            let at = at.max(0.0) as usize;
            at.min(self.count[axis] - 1)
        });
        index[0] * self.count[1] + index[1]
    }
}

impl Strip {
    fn points(&self, mut visit: impl FnMut([f64; 2])) {
        #[allow(clippy::cast_precision_loss, reason = "small integers")]
        let share = |i: usize, count: usize| (i as f64 + 0.5) / count as f64;
        let [near, far] = self.along_m;
        for i in 0..ALONG {
            let along = near + share(i, ALONG) * (far - near);
            for k in 0..ACROSS {
                let across = (2.0 * share(k, ACROSS) - 1.0) * self.half_width_m;
                visit([
                    self.middle_m[0] + along * self.ahead[0] - across * self.ahead[1],
                    self.middle_m[1] + along * self.ahead[1] + across * self.ahead[0],
                ]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn volume_is_kept(
            x in 0.0..0.6_f64, y in -0.3..0.3_f64, turn in 0.0..6.3_f64, volume in 0.0..1e-4_f64,
        ) {
            let mut surface = Surface::level([0.0, 0.6], [-0.3, 0.3], 0.01, -0.33);
            let before = surface.volume_m3();
            let strip = |near, far| Strip {
                middle_m: [x, y],
                ahead: [libm::cos(turn), libm::sin(turn)],
                half_width_m: 0.06,
                along_m: [near, far],
            };
            let moved = surface.shift(&strip(-0.02, 0.0), &strip(0.0, 0.06), volume, -0.36);
            prop_assert!(moved <= volume * (1.0 + 1e-12));
            prop_assert!((surface.volume_m3() - before).abs() < 1e-12);
            prop_assert!(surface.height_m.iter().all(|z| *z >= -0.36));
        }
    }

    #[test]
    fn a_heap_stands_where_it_was_put() {
        let mut surface = Surface::level([0.0, 0.6], [-0.3, 0.3], 0.01, 0.0);
        let strip = |near, far| Strip {
            middle_m: [0.3, 0.0],
            ahead: [-1.0, 0.0],
            half_width_m: 0.06,
            along_m: [near, far],
        };
        // 0.12 m x 0.06 m x 5 mm.
        surface.shift(&strip(-0.06, 0.0), &strip(0.0, 0.06), 3.6e-5, -1.0);
        assert!((surface.mean_height_m(&strip(0.0, 0.06)) - 0.005).abs() < 0.002);
        assert!((surface.mean_height_m(&strip(-0.06, 0.0)) + 0.005).abs() < 0.002);
        assert_eq!(surface.mean_height_m(&strip(0.1, 0.2)), 0.0);
    }
}
