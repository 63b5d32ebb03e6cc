use crate::config::SafeForceTable;

/// Forces on the soil that make nothing slip (section 5.3.3): a largest size for each angle to the plate's normal.
///
/// The numbers come from a soil model; between them it interpolates, beyond the ends it keeps the last one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SafeForceSet {
    angle_rad: [f64; 32],
    force_n: [f64; 32],
    length: usize,
}

impl SafeForceSet {
    /// From a checked table.
    pub(crate) fn new(table: &SafeForceTable) -> Self {
        let mut set = Self { angle_rad: [0.0; 32], force_n: [0.0; 32], length: 0 };
        for (angle, force) in table.angle_deg.iter().zip(&table.force_n).take(32) {
            set.angle_rad[set.length] = angle.to_radians();
            set.force_n[set.length] = *force;
            set.length += 1;
        }
        set
    }

    /// Largest safe force in N at an angle to the plate's normal in rad (positive downwards); none without a table.
    #[must_use]
    pub fn largest_n(&self, angle_rad: f64) -> Option<f64> {
        let angles = self.angle_rad.get(..self.length)?;
        let forces = self.force_n.get(..self.length)?;
        let (first, last) = (angles.first()?, angles.last()?);
        if angle_rad <= *first {
            return forces.first().copied();
        }
        if angle_rad >= *last {
            return forces.last().copied();
        }
        angles.windows(2).zip(forces.windows(2)).find(|(angle, _)| angle_rad <= angle[1]).map(
            |(angle, force)| {
                force[0] + (angle_rad - angle[0]) / (angle[1] - angle[0]) * (force[1] - force[0])
            },
        )
    }
}
