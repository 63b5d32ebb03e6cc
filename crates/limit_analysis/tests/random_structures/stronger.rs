//! The strengths of a problem, each of which can be made greater alone.
//!
//! What is stronger bears every stress that the weaker bears. So friction grows together with cohesion (with the cohesion kept, more friction
//! is less tension), and clay whose strength depends on direction gets all of it, or more shear strength on level and upright planes.

use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{MemberEntry, Profile, SoilEntry};

/// By how much a strength is made greater.
const MORE: f64 = 1.25;

/// What a strength is, and how to make it greater.
pub(crate) type Strength = (&'static str, Box<dyn Fn(&mut Description)>);

/// Strengths of soils, bars, sheets, beams and faces.
pub(crate) fn strengths(it: &Description) -> Vec<Strength> {
    let mut all: Vec<Strength> = Vec::new();
    for (i, soil) in it.soils.iter().enumerate() {
        all.push((law(soil), Box::new(move |it| scale(&mut it.soils[i]))));
        if soil.phi_deg.is_some() && soil.anisotropy.is_none() {
            all.push(("cohesion", Box::new(move |it| it.soils[i].cohesion_kpa *= MORE)));
        }
        if soil.anisotropy.is_some() {
            let more = move |it: &mut Description| {
                if let Some(ratios) = &mut it.soils[i].anisotropy {
                    ratios.shear *= MORE;
                }
            };
            all.push(("shear strength of anisotropic clay", Box::new(more)));
        }
        if soil.tension_kpa.is_some() {
            let more = move |it: &mut Description| {
                it.soils[i].tension_kpa = it.soils[i].tension_kpa.map(|t| MORE * t)
            };
            all.push(("tension of soil", Box::new(more)));
        }
    }
    for (i, member) in it.members.iter().enumerate() {
        let mut push = |name, more: fn(&mut MemberEntry)| {
            all.push((name, Box::new(move |it: &mut Description| more(&mut it.members[i]))));
        };
        push("tension of a member", |member| member.tensile_kn_per_m *= MORE);
        if member.compressive_kn_per_m > 0.0 {
            push("compression of a member", |member| member.compressive_kn_per_m *= MORE);
        }
        if member.bends() {
            push("moment of a beam", |beam| beam.moment_knm_per_m = beam.moment_knm_per_m.map(|m| MORE * m));
            push("shear force of a beam", |beam| beam.shear_kn_per_m = beam.shear_kn_per_m.map(|q| MORE * q));
        }
        match member.pullout_kn_per_m2 {
            None => push("bond of a sheet or beam", |sheet| {
                sheet.bond_factor = (MORE * sheet.bond_factor).min(1.0)
            }),
            Some(profile) if profile.ends() != [0.0; 2] => push("pullout of bars", |bars| {
                bars.pullout_kn_per_m2 =
                    bars.pullout_kn_per_m2.map(|grip| Profile::Linear(grip.ends().map(|g| MORE * g)));
            }),
            Some(_) => {}
        }
        if member.free_length_m > 0.0 {
            push("no free length", |bars| bars.free_length_m = 0.0);
        }
    }
    if !it.structures.is_empty() || !it.plates.is_empty() {
        all.push(("adhesion of faces", Box::new(|it| faces(it, MORE))));
    }
    all
}

/// By what law a soil is strong.
fn law(soil: &SoilEntry) -> &'static str {
    match (soil.strength.is_some(), soil.anisotropy.is_some(), soil.phi_deg) {
        (true, ..) => "curved strength",
        (false, true, _) => "strength of anisotropic clay",
        (false, false, Some(phi)) if phi > 0.0 => "friction and cohesion",
        (false, false, _) => "strength of clay",
    }
}

/// A soil whose strength is greater by the same part at every pressure.
fn scale(soil: &mut SoilEntry) {
    soil.cohesion_kpa *= MORE;
    soil.cohesion_gradient_kpa_per_m *= MORE;
    soil.phi_deg = soil.phi_deg.map(|phi| (MORE * phi.to_radians().tan()).atan().to_degrees());
    soil.strength_factor = soil.strength_factor.map(|factor| MORE * factor);
}

/// Faces with more adhesion.
fn faces(it: &mut Description, more: f64) {
    it.plates.iter_mut().for_each(|plate| plate.adhesion_kpa *= more);
    it.structures.iter_mut().for_each(|structure| structure.adhesion_kpa *= more);
}
