use super::StressFunction;
use crate::CertificateError;
use crate::interval::{Interval, angle};
use crate::mesh::Side;
use crate::problem::Stress;
use crate::tiling::after;

impl StressFunction<'_> {
    /// Checks that the traction on a face edge is one that the face can bear; it is linear along the edge, and so is the pore
    /// pressure. Without friction and adhesion there is no shear traction by construction.
    pub(super) fn check_face(
        &self,
        side: Side,
        part: &[Stress; 3],
        delta_deg: f64,
        adhesion: f64,
    ) -> Result<(), CertificateError> {
        let corners = self.tiling.corners(side.triangle);
        let [start, end] = [1, 2].map(|i| corners[after(side.corner, i)]);
        let t = end - start;
        for (node, (stress, p)) in part.iter().zip([start, end]).enumerate() {
            let effective = stress.with_mean(self.limit(side.triangle, p).pore_pressure);
            // Times the square of the edge's length.
            let normal = effective.between(t.turned(), t.turned());
            let shear = stress.between(t, t.turned());
            let spares = if delta_deg == 0.0 && adhesion == 0.0 {
                [-normal; 2]
            } else {
                let hold = self.divisor.part(Interval::point(adhesion)) * t.square()
                    - angle(delta_deg).tan() * normal;
                [hold - shear, hold + shear]
            };
            if let Some(spare) = spares.into_iter().find(|s| !s.is_at_least_zero()) {
                return Err(CertificateError::NotProven {
                    quantity: "grip of the face to spare, times the square of the edge's length,",
                    place: format!("{side}, {}", ["its start", "its end"][node]),
                    low: spare.lo(),
                    unit: "force",
                });
            }
        }
        Ok(())
    }
}
