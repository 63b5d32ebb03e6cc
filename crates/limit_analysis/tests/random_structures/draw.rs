//! Numbers that look random and are always the same for the same seed.

const STEP: u64 = 0x9e37_79b9_7f4a_7c15;

/// What draws them.
pub(crate) struct Draw(u64);

impl Draw {
    pub(crate) fn new(seed: u64) -> Self {
        let mut first = Self(seed);
        Self((first.part() * (1_u64 << 53) as f64) as u64)
    }

    /// From 0 to 1: splitmix64 (Steele, Lea & Flood 2014), whose sequences of seeds that follow each other have nothing in common.
    fn part(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(STEP);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.part()
    }

    pub(crate) fn chance(&mut self, of_one: f64) -> bool {
        self.part() < of_one
    }

    /// From 0 to below `count`.
    pub(crate) fn index(&mut self, count: usize) -> usize {
        ((self.part() * count as f64) as usize).min(count - 1)
    }
}
