//! The soils that are still consistent with what is known.

use soilctl_earth_pressure::Case;
use soilctl_estimator::Region;

use crate::DiggingError;

/// Slabs of friction angle into which a region is cut.
const SLABS: usize = 24;

/// Soils without cohesion: boxes of friction angle and density that hold all of them, and an interval of friction on the plate.
///
/// Resistance grows with all three, so that the strongest and the weakest soil of a box are corners of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Soils {
    /// Intervals of friction angle in deg and density in kg/m3.
    boxes: Vec<[[f64; 2]; 2]>,
    delta_deg: [f64; 2],
    gravity_m_s2: f64,
}

impl Soils {
    /// All soils with a friction angle (deg), an interface friction (deg) and a density (kg/m3) within these intervals.
    ///
    /// # Errors
    /// [`DiggingError::OutOfRange`] unless 1 <= phi <= 60 deg, 0 <= delta <= phi, 100 <= density <= 10 000 kg/m3, 0 < gravity <= 30 m/s2, and
    /// intervals are none that are turned about.
    pub fn within(
        phi_deg: [f64; 2],
        delta_deg: [f64; 2],
        density_kg_m3: [f64; 2],
        gravity_m_s2: f64,
    ) -> Result<Self, DiggingError> {
        interval("phi_deg", phi_deg, "deg", [1.0, 60.0])?;
        interval("delta_deg", delta_deg, "deg", [0.0, phi_deg[0]])?;
        interval("density_kg_m3", density_kg_m3, "kg/m3", [100.0, 1e4])?;
        interval("gravity_m_s2", [gravity_m_s2; 2], "m/s2", [f64::MIN_POSITIVE, 30.0])?;
        Ok(Self { boxes: vec![[phi_deg, density_kg_m3]], delta_deg, gravity_m_s2 })
    }

    /// The soils of a region of friction angle and density, as an estimate leaves it; `None` if it is empty.
    ///
    /// The region is enclosed by boxes, a slab of friction angle each.
    ///
    /// # Errors
    /// As [`Soils::within`].
    pub fn of_region(
        region: &Region,
        delta_deg: [f64; 2],
        gravity_m_s2: f64,
    ) -> Result<Option<Self>, DiggingError> {
        let Some(([low, high], _)) = region.bounds() else { return Ok(None) };
        let mut boxes = Vec::with_capacity(SLABS);
        for k in 0..SLABS {
            #[allow(clippy::cast_precision_loss, reason = "small integers")]
            let at = |k: usize| low + (high - low) * k as f64 / SLABS as f64;
            let slab = [at(k), at(k + 1)];
            let mut densities = [f64::INFINITY, f64::NEG_INFINITY];
            for ring in region.polygons().iter().flatten() {
                for (i, a) in ring.iter().enumerate() {
                    let b = ring[(i + 1) % ring.len()];
                    for density in clipped(*a, b, slab) {
                        densities = [densities[0].min(density), densities[1].max(density)];
                    }
                }
            }
            if densities[0] <= densities[1] {
                Self::within(slab, delta_deg, densities, gravity_m_s2)?;
                boxes.push([slab, densities]);
            }
        }
        Ok((!boxes.is_empty()).then_some(Self { boxes, delta_deg, gravity_m_s2 }))
    }

    /// Interval of the friction on the plate in deg.
    #[must_use]
    pub const fn delta_deg(&self) -> [f64; 2] {
        self.delta_deg
    }

    /// Gravity in m/s2.
    #[must_use]
    pub const fn gravity_m_s2(&self) -> f64 {
        self.gravity_m_s2
    }

    /// Ranges of friction angle in deg and density in kg/m3.
    #[must_use]
    pub fn ranges(&self) -> [[f64; 2]; 2] {
        let first = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        self.boxes.iter().fold(first, |ranges, one| {
            std::array::from_fn(|i| [ranges[i][0].min(one[i][0]), ranges[i][1].max(one[i][1])])
        })
    }

    /// Boxes of friction angle in deg and density in kg/m3.
    #[must_use]
    pub fn boxes(&self) -> &[[[f64; 2]; 2]] {
        &self.boxes
    }

    /// The weakest or the strongest corner of each box, as a case at a tool angle with forces inclined by `inclination_deg`, and its density.
    pub(crate) fn corners(
        &self,
        strongest: bool,
        tool_angle_deg: f64,
        inclination_deg: f64,
    ) -> impl Iterator<Item = (Case, f64)> + '_ {
        let corner = usize::from(strongest);
        self.boxes.iter().map(move |one| {
            (Case::level_deg(tool_angle_deg, one[0][corner], inclination_deg), one[1][corner])
        })
    }
}

/// Densities at which an edge enters and leaves a slab of friction angle.
fn clipped(a: [f64; 2], b: [f64; 2], slab: [f64; 2]) -> Vec<f64> {
    let (a, b) = if a[0] <= b[0] { (a, b) } else { (b, a) };
    if b[0] < slab[0] || a[0] > slab[1] {
        return Vec::new();
    }
    if a[0] == b[0] {
        return vec![a[1], b[1]];
    }
    let at = |phi: f64| a[1] + (phi - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
    vec![at(slab[0].max(a[0])), at(slab[1].min(b[0]))]
}

fn interval(
    key: &'static str,
    [low, high]: [f64; 2],
    unit: &'static str,
    [least, most]: [f64; 2],
) -> Result<(), DiggingError> {
    for (value, least) in [(low, least), (high, low)] {
        if !(value >= least && value <= most) {
            return Err(DiggingError::OutOfRange {
                key,
                value,
                unit,
                allowed: format!("from {least} to {most}"),
            });
        }
    }
    Ok(())
}
