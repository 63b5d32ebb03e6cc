//! The same problem with weaker soil.

use super::input::Description;

impl Description {
    /// The problem with cohesion, adhesion, tension and the tangents of all friction angles divided by a factor.
    #[must_use]
    pub fn reduced(&self, factor: f64) -> Self {
        let angle = |deg: &mut f64| *deg = (deg.to_radians().tan() / factor).atan().to_degrees();
        let mut weaker = self.clone();
        for s in &mut weaker.soils {
            angle(&mut s.phi_deg);
            s.cohesion_kpa /= factor;
            s.cohesion_gradient_kpa_per_m /= factor;
            s.tension_kpa = s.tension_kpa.map(|t| t / factor);
        }
        for p in &mut weaker.plates {
            angle(&mut p.delta_deg);
            p.adhesion_kpa /= factor;
            for face in [&mut p.left, &mut p.right].into_iter().flatten() {
                angle(&mut face.delta_deg);
                face.adhesion_kpa /= factor;
            }
        }
        let in_soil = weaker.plates.iter_mut().flat_map(|p| &mut p.in_soil);
        for face in in_soil.chain(weaker.structures.iter_mut().flat_map(|s| &mut s.in_soil)) {
            angle(&mut face.delta_deg);
            face.adhesion_kpa /= factor;
        }
        for s in &mut weaker.structures {
            angle(&mut s.delta_deg);
            s.adhesion_kpa /= factor;
        }
        weaker
    }
}
