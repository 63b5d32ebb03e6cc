//! Random soils of every law of strength, and water in them.

use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{
    AnisotropyEntry, HeadEntry, Profile, RegionEntry, SoilEntry, StrengthLaw, Water,
};

use crate::draw::Draw;

/// Up to which stress curves are followed: fewer lines than without it, and less time.
const UP_TO_KPA: f64 = 50.0;

/// A soil of a law that is drawn.
pub(crate) fn soil(draw: &mut Draw, name: &str) -> SoilEntry {
    let plain = SoilEntry {
        name: name.into(),
        unit_weight_kn_m3: draw.between(16.0, 21.0),
        permeability_m_per_s: Some(10_f64.powf(draw.between(-7.0, -4.0))),
        ..SoilEntry::default()
    };
    let clay = SoilEntry { phi_deg: Some(0.0), cohesion_kpa: draw.between(10.0, 50.0), ..plain.clone() };
    let curved = |strength: StrengthLaw, draw: &mut Draw| SoilEntry {
        strength: Some(strength),
        strength_factor: Some(draw.between(0.7, 1.3)),
        ..plain.clone()
    };
    match draw.index(20) {
        0..=2 => clay,
        3 => SoilEntry {
            cohesion_gradient_kpa_per_m: draw.between(0.5, 4.0),
            cohesion_level_m: Some(5.0),
            ..clay
        },
        4..=6 => {
            let anisotropy =
                AnisotropyEntry { passive: draw.between(0.4, 1.1), shear: draw.between(0.5, 0.9) };
            SoilEntry { anisotropy: Some(anisotropy), ..clay }
        }
        7 => SoilEntry { tension_kpa: Some(0.3 * clay.cohesion_kpa), ..clay },
        8..=10 => {
            let [c, first, then] =
                [(4.0, 20.0), (0.5, 0.8), (0.1, 0.5)].map(|(low, high)| draw.between(low, high));
            let points_kpa = vec![[0.0, c], [30.0, c + 30.0 * first], [90.0, c + 30.0 * first + 60.0 * then]];
            curved(StrengthLaw::Points { points_kpa }, draw)
        }
        11 => curved(many_lines(draw), draw),
        _ => SoilEntry {
            phi_deg: Some(draw.between(8.0, 38.0)),
            cohesion_kpa: draw.between(1.0, 25.0),
            pore_pressure_ratio: if draw.chance(0.2) { draw.between(0.05, 0.3) } else { 0.0 },
            ..plain
        },
    }
}

/// A law that is followed by many straight lines, which takes long.
fn many_lines(draw: &mut Draw) -> StrengthLaw {
    let up_to_kpa = Some(UP_TO_KPA);
    match draw.index(3) {
        0 => {
            let [factor, exponent, tension_kpa] =
                [(1.0, 2.5), (0.7, 0.95), (1.0, 10.0)].map(|(low, high)| draw.between(low, high));
            StrengthLaw::Power { factor, exponent, tension_kpa, up_to_kpa }
        }
        1 => {
            let [phi_deg, slope_deg_per_decade] =
                [(30.0, 40.0), (1.0, 6.0)].map(|(low, high)| draw.between(low, high));
            StrengthLaw::FrictionLaw {
                phi_deg,
                slope_deg_per_decade,
                reference_kpa: 20.0,
                greatest_phi_deg: 50.0,
                up_to_kpa,
            }
        }
        _ => {
            let [ucs_mpa, gsi, mi] =
                [(0.5, 4.0), (15.0, 40.0), (5.0, 15.0)].map(|(low, high)| draw.between(low, high));
            StrengthLaw::HoekBrown { ucs_mpa, gsi, mi, disturbance: 0.5, up_to_kpa }
        }
    }
}

/// An area of a soil.
pub(crate) fn region(soil: &str, polygon: &[[f64; 2]]) -> RegionEntry {
    RegionEntry { name: None, soil: soil.into(), polygon: polygon.to_vec() }
}

/// Perhaps a water table between these levels at the left and the right.
pub(crate) fn water(draw: &mut Draw, it: &mut Description, left: [f64; 2], right: [f64; 2]) {
    if !draw.chance(0.35) || it.soils.iter().any(|soil| soil.pore_pressure_ratio > 0.0) {
        return;
    }
    let table = [left, right].map(|[x, low]| [x, low + draw.between(-1.5, 1.0)]);
    it.water = Some(Water::fresh(table.to_vec()));
}

/// Perhaps water that flows from the outline along one line to that along another, with these levels at most.
pub(crate) fn flow(draw: &mut Draw, it: &mut Description, lines: [&[[f64; 2]]; 2], levels: [f64; 2]) {
    if it.water.is_some() || !draw.chance(0.15) || it.soils.iter().any(|soil| soil.pore_pressure_ratio > 0.0)
    {
        return;
    }
    let weight = it.soils[0].unit_weight_kn_m3;
    it.soils.iter_mut().for_each(|soil| soil.unit_weight_kn_m3 = weight);
    it.heads = [0, 1]
        .map(|i| HeadEntry {
            name: None,
            line: lines[i].to_vec(),
            head_m: levels[i] - draw.between(0.0, 1.0),
        })
        .to_vec();
}

/// Perhaps a profile, perhaps one number.
pub(crate) fn profile(draw: &mut Draw, low: f64, high: f64) -> Profile {
    let [start, end] = [0, 1].map(|_| draw.between(low, high));
    if draw.chance(0.5) { Profile::Linear([start, end]) } else { Profile::Uniform(start) }
}
