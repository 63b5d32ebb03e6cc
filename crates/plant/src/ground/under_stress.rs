//! Limit forces in soil whose friction falls with the logarithm of stress.

use serde::{Deserialize, Serialize};
use soilctl_earth_pressure::{Case, ChenLiu, EarthPressureError, ForceModel, LoadFactors};
use soilctl_soil::{Angle, Interface, Soil};

use super::limit::{ANGLES, LimitCoefficients, SHARES, angle_deg, between, round, share, surrounding};
use crate::PlantError;
use crate::rules::Rules;

/// Widest step between friction angles whose coefficients are taken from the model, in degrees: between them coefficients are straight to
/// 0.3 %.
const STEP_DEG: f64 = 2.0;
/// By how many decades stresses may differ from those of an upright rough plate.
const AROUND_DECADES: f64 = 0.5;
/// Depths of the nodes along the plate, to 0.13 m: from this one, each greater by this factor. Friction is the same above the first and below
/// the last.
const FIRST_DEPTH_M: f64 = 2e-3;
const DEPTH_FACTOR: f64 = 1.2;
const DEPTHS: usize = 24;
/// Depths between which the law has to stay within what the model answers.
const TRIED_M: [f64; 2] = [0.005, 0.1];
/// Steps towards the friction at a stress that friction itself changes: each is nearer by a factor of three or more.
const STEPS: usize = 12;

/// Friction as a law of stress: `phi = phi_ref - slope log10(sigma / sigma_ref)`, sigma being the normal stress where the soil slips.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FrictionLaw {
    /// The slope in degrees a decade; 0 to 12.
    pub slope_deg_per_decade: f64,
    /// Normal stress in Pa at which the soil has its friction angle; 1 to 1e6.
    pub reference_stress_pa: f64,
}

impl FrictionLaw {
    pub(crate) fn check(&self, rules: &Rules<'_>) -> Result<(), PlantError> {
        rules.range(
            "friction_law.slope_deg_per_decade",
            self.slope_deg_per_decade,
            "deg/decade",
            0.0,
            12.0,
        )?;
        rules.range("friction_law.reference_stress_pa", self.reference_stress_pa, "Pa", 1.0, 1e6)
    }

    fn friction_deg(&self, soil: &Soil, stress_pa: f64) -> f64 {
        let decades = libm::log10(stress_pa / self.reference_stress_pa);
        soil.friction().degrees() - self.slope_deg_per_decade * decades
    }
}

/// Coefficients by depth, tool angle and share of the friction on the plate.
///
/// The plate is taken in layers. A layer at the depth s along it bears what the model says of a soil with one friction angle, that at
/// the stress there: with the pressure `p = gamma s K cos(delta)` on the plate, soil slips at `sigma = p (1 - sin phi)`, as ahead of a smooth
/// upright wall (Rankine). So there is a friction angle for each layer, and none for the stroke. Friction stays within what the model
/// answers, and is at least that on the plate. Heaps do not change it.
#[derive(Debug, Clone)]
pub(crate) struct UnderStress {
    /// Friction angles in degrees, growing evenly, and the coefficients of each.
    soils: Vec<(f64, LimitCoefficients)>,
    /// By depth, angle and share: which of these counts, as a place among them; between two they are mixed.
    places: Vec<Vec<[f64; SHARES]>>,
}

impl UnderStress {
    /// Errors are those of the model, and friction that it does not answer at depths that plates reach.
    pub(crate) fn new(
        law: &FrictionLaw,
        model: &dyn ForceModel,
        soil: &Soil,
        interface: &Interface,
        fraction: f64,
    ) -> Result<Self, EarthPressureError> {
        let soils = frictions_deg(law, model, soil, interface)?
            .into_iter()
            .map(|phi| Ok((phi, LimitCoefficients::new(model, &at(soil, phi)?, interface, fraction)?)))
            .collect::<Result<Vec<_>, EarthPressureError>>()?;
        let mut places = vec![vec![[0.0; SHARES]; ANGLES]; DEPTHS];
        for angle in 0..ANGLES {
            for k in 0..SHARES {
                let layers = Layers {
                    law,
                    soil,
                    phi_deg: soils.iter().map(|(phi, _)| *phi).collect(),
                    weights: soils.iter().map(|(_, limits)| limits.node(angle, k).weight).collect(),
                    cos_delta: libm::cos(share(k) * interface.friction().radians()),
                };
                for (of_depth, place) in places.iter_mut().zip(layers.places()) {
                    of_depth[angle][k] = round(place);
                }
            }
        }
        Ok(Self { soils, places })
    }

    /// The same for a plate with ends.
    pub(crate) fn with_ends(
        self,
        model: &dyn ForceModel,
        soil: &Soil,
        interface: &Interface,
        factor: f64,
    ) -> Result<Self, EarthPressureError> {
        let soils = self
            .soils
            .into_iter()
            .map(|(phi, limits)| Ok((phi, limits.with_ends(model, &at(soil, phi)?, interface, factor)?)))
            .collect::<Result<Vec<_>, EarthPressureError>>()?;
        Ok(Self { soils, ..self })
    }

    /// Factors at a tool angle in rad with a share (0 to 1) of the friction on the plate, for a depth and a width in m.
    pub(crate) fn at(&self, tool_angle_rad: f64, share: f64, depth_m: f64, width_m: f64) -> LoadFactors {
        let slant_m = (depth_m / libm::sin(tool_angle_rad)).max(FIRST_DEPTH_M);
        let (depth, deeper) = cell(libm::log(slant_m / FIRST_DEPTH_M) / libm::log(DEPTH_FACTOR), DEPTHS);
        let of = |depth: usize| surrounding(tool_angle_rad, share).mix(|row, k| self.places[depth][row][k]);
        let place = of(depth) + deeper * (of(depth + 1) - of(depth));
        let (soil, stronger) = cell(place, self.soils.len());
        let limits = |soil: usize| self.soils[soil].1.at(tool_angle_rad, share, depth_m / width_m);
        between(&limits(soil), &limits(soil + 1), stronger)
    }
}

/// One tool angle and one share of the friction on the plate.
struct Layers<'a> {
    law: &'a FrictionLaw,
    soil: &'a Soil,
    phi_deg: Vec<f64>,
    /// The model's coefficient at each friction angle.
    weights: Vec<f64>,
    cos_delta: f64,
}

impl Layers<'_> {
    /// For each depth of the nodes, the place among friction angles whose coefficient is that of all layers above together.
    fn places(&self) -> Vec<f64> {
        let mut found = Vec::with_capacity(DEPTHS);
        // Of coefficient times depth squared, and of what the last node had.
        let (mut sum, mut last) = (0.0, (0.0, 0.0));
        for node in 0..DEPTHS {
            let slant_m = FIRST_DEPTH_M * libm::pow(DEPTH_FACTOR, node as f64);
            let weight = self.weight(self.place_at(slant_m));
            let square = slant_m * slant_m;
            let mean = if node == 0 { weight } else { 0.5 * (weight + last.1) };
            sum += mean * (square - last.0);
            last = (square, weight);
            found.push(self.place_of(sum / square));
        }
        found
    }

    /// The friction at a depth along the plate, as a place.
    fn place_at(&self, slant_m: f64) -> f64 {
        let mut place = 0.5 * (self.phi_deg.len() - 1) as f64;
        for _ in 0..STEPS {
            let phi = self.law.friction_deg(self.soil, self.stress_pa(slant_m, place));
            let [first, last] = [self.phi_deg[0], self.phi_deg[self.phi_deg.len() - 1]];
            place = ((phi - first) / (last - first)).clamp(0.0, 1.0) * (self.phi_deg.len() - 1) as f64;
        }
        place
    }

    fn stress_pa(&self, slant_m: f64, place: f64) -> f64 {
        let pressure = self.soil.unit_weight_n_m3() * slant_m * self.weight(place) * self.cos_delta;
        let (cell, in_cell) = cell(place, self.phi_deg.len());
        let phi = self.phi_deg[cell] + in_cell * (self.phi_deg[cell + 1] - self.phi_deg[cell]);
        pressure * (1.0 - libm::sin(phi.to_radians()))
    }

    fn weight(&self, place: f64) -> f64 {
        let (cell, in_cell) = cell(place, self.weights.len());
        self.weights[cell] + in_cell * (self.weights[cell + 1] - self.weights[cell])
    }

    /// Where this coefficient is; coefficients grow with friction.
    fn place_of(&self, weight: f64) -> f64 {
        let above = self.weights.iter().position(|at| *at >= weight).unwrap_or(self.weights.len() - 1).max(1);
        let [low, high] = [self.weights[above - 1], self.weights[above]];
        (above - 1) as f64 + ((weight - low) / (high - low)).clamp(0.0, 1.0)
    }
}

/// Friction angles in degrees that the law may come to, evenly.
fn frictions_deg(
    law: &FrictionLaw,
    model: &dyn ForceModel,
    soil: &Soil,
    interface: &Interface,
) -> Result<Vec<f64>, EarthPressureError> {
    let range = model.valid_range().phi_deg;
    let least = range.0.max(interface.friction().degrees()).max(1.0);
    // Stresses by the coefficients of the reference.
    let upright_deg = angle_deg(ANGLES / 2);
    let case = Case::level_deg(upright_deg, soil.friction().degrees(), interface.friction().degrees());
    let upright = ChenLiu.predict(&case)?.net.weight;
    let pressure_per_m = soil.unit_weight_n_m3() * upright * libm::cos(interface.friction().radians());
    let stress_per_m = pressure_per_m * (1.0 - libm::sin(soil.friction().radians()));
    let at = |depth_m: f64| law.friction_deg(soil, stress_per_m * depth_m);
    for value in TRIED_M.map(at) {
        if !(least..=range.1).contains(&value) {
            return Err(EarthPressureError::OutsideModel {
                model: model.id(),
                quantity: "phi under the law of stress, 5 to 100 mm deep,",
                value,
                low: least,
                high: range.1,
                advice: "choose a smaller slope, a reference stress nearer to that of the strokes, or another model",
            });
        }
    }
    let deepest_m = FIRST_DEPTH_M * libm::pow(DEPTH_FACTOR, (DEPTHS - 1) as f64);
    let around_deg = AROUND_DECADES * law.slope_deg_per_decade + 0.01;
    let low = (at(deepest_m) - around_deg).max(least);
    let high = (at(FIRST_DEPTH_M) + around_deg).min(range.1);
    let steps = ((high - low) / STEP_DEG).ceil().max(1.0);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some tens of degrees")]
    let count = steps as usize;
    Ok((0..=count).map(|i| low + (high - low) * i as f64 / steps).collect())
}

/// The soil with another friction.
fn at(soil: &Soil, phi_deg: f64) -> Result<Soil, EarthPressureError> {
    Ok(Soil::new(Angle::from_degrees(phi_deg), soil.density_kg_m3())?.with_gravity(soil.gravity_m_s2())?)
}

/// The step of an even row of so many nodes in which a place lies, and how far in it; at its ends beyond them.
fn cell(place: f64, nodes: usize) -> (usize, f64) {
    let place = place.clamp(0.0, (nodes - 1) as f64);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to a small count")]
    let cell = (place as usize).min(nodes - 2);
    (cell, place - cell as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use soilctl_earth_pressure::model;

    const LAW: FrictionLaw = FrictionLaw { slope_deg_per_decade: 5.0, reference_stress_pa: 1000.0 };

    fn soil(phi_deg: f64, delta_deg: f64) -> (Soil, Interface) {
        (
            Soil::new(Angle::from_degrees(phi_deg), 1500.0).unwrap(),
            Interface::new(Angle::from_degrees(delta_deg), 0.0).unwrap(),
        )
    }

    /// Rankine's stresses beside a smooth upright plate, layer by layer: slip planes carry `gamma z (1 + sin phi)` ahead of it, and
    /// `gamma z (1 - sin phi)` behind, each with a friction of its own.
    fn rankine_n_per_m(soil: &Soil, depth_m: f64) -> f64 {
        const LAYERS: usize = 4000;
        let layer = depth_m / LAYERS as f64;
        let pressure = |z: f64, side: f64| {
            let vertical = soil.unit_weight_n_m3() * z;
            let mut sin = 0.5;
            for _ in 0..60 {
                let stress = vertical * (1.0 + side * sin);
                let decades = (stress / LAW.reference_stress_pa).log10();
                sin = (soil.friction().degrees() - LAW.slope_deg_per_decade * decades).to_radians().sin();
            }
            vertical * (1.0 + side * sin) / (1.0 - side * sin)
        };
        let at = |i: usize| (i as f64 + 0.5) * layer;
        (0..LAYERS).map(|i| layer * (pressure(at(i), 1.0) - pressure(at(i), -1.0))).sum()
    }

    #[test]
    fn smooth_plates_bear_rankines_stresses_in_layers() {
        let (soil, interface) = soil(38.0, 25.0);
        let chen = model("chen").unwrap();
        let found = UnderStress::new(&LAW, chen.as_ref(), &soil, &interface, 0.5).unwrap();
        for depth_m in [0.008, 0.012, 0.03, 0.08, 0.12] {
            let factors = found.at(std::f64::consts::FRAC_PI_2, 0.0, depth_m, 0.127);
            let force = 0.5 * soil.unit_weight_n_m3() * depth_m * depth_m * factors.weight;
            let wanted = rankine_n_per_m(&soil, depth_m);
            assert!((force / wanted - 1.0).abs() < 0.01, "{depth_m}: {force} {wanted}");
        }
    }

    #[test]
    fn without_a_slope_it_is_one_friction_angle() {
        let (soil, interface) = soil(38.0, 25.0);
        let chen = model("chen").unwrap();
        let flat = FrictionLaw { slope_deg_per_decade: 0.0, ..LAW };
        let found = UnderStress::new(&flat, chen.as_ref(), &soil, &interface, 0.5).unwrap();
        let plain = LimitCoefficients::new(chen.as_ref(), &soil, &interface, 0.5).unwrap();
        for (alpha, share, depth_m) in [(62.0, 1.0, 0.01), (90.0, 0.4, 0.03), (104.3, 0.0, 0.1)] {
            let alpha = f64::to_radians(alpha);
            let ratio = found.at(alpha, share, depth_m, 0.127).weight / plain.at(alpha, share, 0.2).weight;
            assert!((ratio - 1.0).abs() < 3e-3, "{ratio}");
        }
    }

    #[test]
    fn friction_beyond_the_model_is_refused() {
        let (soil, interface) = soil(48.0, 25.0);
        let steep = FrictionLaw { slope_deg_per_decade: 10.0, reference_stress_pa: 1e5 };
        let problem = UnderStress::new(&steep, model("chen").unwrap().as_ref(), &soil, &interface, 0.5);
        assert!(problem.unwrap_err().to_string().contains("law of stress"));
    }
}
