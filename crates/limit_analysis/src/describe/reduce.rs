//! The same problem with weaker soil.

use super::input::Description;
use super::parts::Profile;

/// What parts of strength are divided by.
#[derive(Debug, Clone, Copy)]
pub(super) struct Divisors {
    /// Tangents of friction angles, of soils and of faces.
    pub(super) friction: f64,
    /// Cohesion and tension of soils with friction, and adhesion of faces with friction.
    pub(super) cohesion: f64,
    /// Those of soils and faces without friction.
    pub(super) undrained: f64,
    /// What soil hands to bars: of the bond it is the soil that yields.
    pub(super) pullout: f64,
}

impl Divisors {
    /// Divides the tangent of an angle.
    fn turn(self, deg: &mut f64) {
        if self.friction != 1.0 {
            *deg = (deg.to_radians().tan() / self.friction).atan().to_degrees();
        }
    }

    /// What divides cohesion beside a friction angle.
    fn beside(self, deg: f64) -> f64 {
        if deg > 0.0 { self.cohesion } else { self.undrained }
    }

    fn face(self, delta_deg: &mut f64, adhesion_kpa: &mut f64) {
        *adhesion_kpa /= self.beside(*delta_deg);
        self.turn(delta_deg);
    }
}

impl Description {
    /// The problem with cohesion, adhesion, tension, pullout resistances and the tangents of all friction angles divided by a factor.
    #[must_use]
    pub fn reduced(&self, factor: f64) -> Self {
        let mut weaker = self.clone();
        let by = Divisors { friction: factor, cohesion: factor, undrained: factor, pullout: factor };
        weaker.weaken(by);
        weaker
    }

    /// Divides the strength of all soils and faces, and what bars have from it.
    pub(super) fn weaken(&mut self, by: Divisors) {
        for soil in &mut self.soils {
            let divisor = by.beside(soil.phi_deg.unwrap_or(f64::INFINITY));
            soil.cohesion_kpa /= divisor;
            soil.cohesion_gradient_kpa_per_m /= divisor;
            soil.tension_kpa = soil.tension_kpa.map(|t| t / divisor);
            if let Some(phi_deg) = &mut soil.phi_deg {
                by.turn(phi_deg);
                soil.dilation_deg = soil.dilation_deg.map(|dilation_deg| dilation_deg.min(*phi_deg));
            }
            if soil.strength.is_some() && by.friction != 1.0 {
                soil.strength_factor = Some(soil.strength_factor.unwrap_or(1.0) / by.friction);
            }
        }
        for plate in &mut self.plates {
            by.face(&mut plate.delta_deg, &mut plate.adhesion_kpa);
            for face in [&mut plate.left, &mut plate.right].into_iter().flatten() {
                by.face(&mut face.delta_deg, &mut face.adhesion_kpa);
            }
        }
        for structure in &mut self.structures {
            by.face(&mut structure.delta_deg, &mut structure.adhesion_kpa);
        }
        for pullout in self.members.iter_mut().filter_map(|member| member.pullout_kn_per_m2.as_mut()) {
            *pullout = match *pullout {
                Profile::Uniform(value) => Profile::Uniform(value / by.pullout),
                Profile::Linear(ends) => Profile::Linear(ends.map(|value| value / by.pullout)),
            };
        }
        let of_plates = self.plates.iter_mut().flat_map(|p| &mut p.in_soil);
        for face in of_plates.chain(self.structures.iter_mut().flat_map(|s| &mut s.in_soil)) {
            by.face(&mut face.delta_deg, &mut face.adhesion_kpa);
        }
    }
}
