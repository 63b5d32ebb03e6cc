//! Problem files.

use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{Case, SoilEntry};

use super::{edges, friction, stress, weight};
use crate::text::number;

/// Greatest length of a plate in m, and of the whole ground: longer ones are probably in mm.
const PLATE_M: f64 = 100.0;
const GROUND_M: f64 = 5000.0;
/// Greatest strength of a bar or sheet for each metre of width, kN/m: strong geogrids and rows of anchors bear less.
const MEMBER_KN_PER_M: f64 = 5000.0;
/// Greatest pullout resistance of a row of bars for each metre of bar, kN/m2: rows of grouted anchors in dense soil hold less.
const PULLOUT_KN_PER_M2: f64 = 500.0;
/// Sheets whose faces bear less than this share of the soil's strength are planes of weakness in it.
const PARTS: f64 = 0.5;
/// Greatest bending moment of a beam for each metre of width, kNm/m: the strongest combined walls bear less.
const MOMENT_KNM_PER_M: f64 = 1e4;
/// Least size of the ground in m.
const LEAST_GROUND_M: f64 = 0.02;
/// How much larger than a structure the ground usually is at most.
const RATIO: f64 = 2000.0;
/// Permeabilities from tight clay to gravel, m/s.
const PERMEABILITY: std::ops::RangeInclusive<f64> = 1e-12..=0.1;
/// Unit weights of water with what is dissolved in it, kN/m3.
const WATER: [f64; 2] = [9.0, 13.0];

/// What hardly anybody means, each once, in a file and in those of its cases that have no partial factors: these make unusual
/// values of usual ones.
pub(crate) fn notes(d: &Description, cases: &[Case]) -> Vec<String> {
    let mut all = of_one(d);
    let is_plain =
        |case: &&Case| case.factors.named().iter().all(|(_, factor)| factor.is_none_or(|f| f == 1.0));
    for note in cases.iter().filter(is_plain).flat_map(|case| of_one(&case.description)) {
        if !all.contains(&note) {
            all.push(note);
        }
    }
    all
}

/// Strength after Davis, which is no proof.
fn lessened(entry: &str, soil: &SoilEntry) -> Option<String> {
    let (dilation, phi, less) = (soil.dilation_deg?, soil.phi_deg?, soil.after_davis());
    (dilation < phi).then(|| {
        format!(
            "{entry}: dilation_deg is {}, so its strength is taken as phi {:.2} deg and c {:.4} kPa after Davis (1968): an approximation; the bounds \
             are proven for that strength, not for soil that dilates less than the flow rule says",
            number(dilation),
            less.friction_deg(),
            less.cohesion_kpa
        )
    })
}

fn of_one(d: &Description) -> Vec<String> {
    let mut all: Vec<Option<String>> = Vec::new();
    for (i, soil) in d.soils.iter().enumerate() {
        let entry = format!("soil {} ({:?})", i + 1, soil.name);
        all.push(weight(&entry, "unit_weight_kn_m3", soil.unit_weight_kn_m3));
        all.push(soil.phi_deg.and_then(|deg| friction(&entry, "phi_deg", deg)));
        all.push(lessened(&entry, soil));
        all.push(soil.law_words().map(|law| {
            format!("{entry}: {law}; the friction angle and the cohesion of an area of it are those at the least pressure")
        }));
        all.push(stress(&entry, "cohesion_kpa", soil.cohesion_kpa, soil.cohesion_kpa));
    }
    let structures = d.structures.iter().map(|s| {
        let points = if s.polygon.is_empty() { &s.edge } else { &s.polygon };
        ("structure", &s.name, points, s.delta_deg, s.adhesion_kpa)
    });
    let plates = d.plates.iter().map(|p| ("plate", &p.name, &p.line, p.delta_deg, p.adhesion_kpa));
    let ground = size(d.regions.iter().flat_map(|r| &r.polygon));
    for (kind, name, points, delta, adhesion) in structures.chain(plates) {
        let entry = format!("{kind} {name:?}");
        all.push(friction(&entry, "delta_deg", delta));
        all.push(stress(&entry, "adhesion_kpa", adhesion, adhesion));
        all.push(length(&entry, size(points), ground));
    }
    for member in &d.members {
        let moment = member.moment_knm_per_m.unwrap_or(0.0);
        all.push((moment > MOMENT_KNM_PER_M).then(|| {
            let (moment, most) = (number(moment), number(MOMENT_KNM_PER_M));
            format!(
                "member {:?}: its moment_knm_per_m is {moment}; few beams bear more than {most} for each metre of width: is it in Nm/m, or not over \
                 the spacing?",
                member.name
            )
        }));
        let pullout =
            member.pullout_kn_per_m2.map_or(0.0, |profile| profile.ends().into_iter().fold(0.0, f64::max));
        all.push((pullout > PULLOUT_KN_PER_M2).then(|| {
            let (pullout, most) = (number(pullout), number(PULLOUT_KN_PER_M2));
            format!(
                "member {:?}: its pullout_kn_per_m2 is {pullout}; rows of bars hold few more than {most}: is it the stress on the skin, or not \
                 over the spacing?",
                member.name
            )
        }));
        let parts = member.bond_factor < PARTS && member.moment_knm_per_m.is_none();
        all.push(parts.then(|| {
            format!(
                "member {:?}: its bond_factor is {}: it parts the soil as a smooth sheet does, whose faces bear that share of the soil's strength; if \
                 it is a row of bars, between which the soil goes on, give pullout_kn_per_m2 instead",
                member.name,
                number(member.bond_factor)
            )
        }));
        let value = member.tensile_kn_per_m.max(member.compressive_kn_per_m);
        all.push((value > MEMBER_KN_PER_M).then(|| {
            let (value, most) = (number(value), number(MEMBER_KN_PER_M));
            format!(
                "member {:?}: it bears {value} kN for each metre of width; few bear more than {most}: is it in N/m, or not over the \
                 spacing?",
                member.name
            )
        }));
    }
    all.push(extent(ground));
    all.push(stress("the problem", "surcharge_kpa", d.surcharge_kpa, d.surcharge_kpa));
    for (i, boundary) in d.boundaries.iter().enumerate() {
        let entry = format!("boundary {}", i + 1);
        for (key, profile) in [("pressure_kpa", boundary.pressure_kpa), ("shear_kpa", boundary.shear_kpa)] {
            let ends = profile.into_iter().flat_map(|profile| profile.ends());
            let greatest = ends.map(f64::abs).fold(0.0, f64::max);
            all.push(stress(&entry, key, greatest, greatest));
        }
    }
    all.extend(edges::notes(d));
    all.extend(water(d));
    all.extend(heads(d));
    if let Some(seismic) = d.seismic {
        for (key, value) in [("kh", seismic.kh), ("kv", seismic.kv)] {
            all.push((value.abs() > 1.0).then(|| {
                let value = number(value);
                format!(
                    "seismic: {key} is {value}; earthquakes have up to 1, in units of gravity: is it in m/s2?"
                )
            }));
        }
    }
    all.into_iter().flatten().collect()
}

/// The greater side of the box around points.
pub(super) fn size<'a>(points: impl IntoIterator<Item = &'a [f64; 2]>) -> f64 {
    let [low, high] =
        points.into_iter().fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], p| {
            [[0, 1].map(|i| low[i].min(p[i])), [0, 1].map(|i| high[i].max(p[i]))]
        });
    (high[0] - low[0]).max(high[1] - low[1])
}

fn length(entry: &str, m: f64, ground: f64) -> Option<String> {
    if m > PLATE_M {
        let (m, most) = (number(m), number(PLATE_M));
        return Some(format!("{entry}: it is {m} m long; few are longer than {most} m: is it in mm or cm?"));
    }
    (m > 0.0 && ground > RATIO * m).then(|| {
        let [m, ground, ratio] = [m, ground, RATIO].map(number);
        format!(
            "{entry}: it is {m} m long in ground of {ground} m; ground is rarely more than {ratio} times as large: are both in m?"
        )
    })
}

fn extent(m: f64) -> Option<String> {
    let cause = if m > GROUND_M {
        "is it in mm or cm?"
    } else if m < LEAST_GROUND_M {
        "is it in km?"
    } else {
        return None;
    };
    let [m, low, high] = [m, LEAST_GROUND_M, GROUND_M].map(number);
    Some(format!("the regions: the ground is {m} m large; it usually has {low} to {high} m: {cause}"))
}

/// Heads that give no water, and soil that water hardly ever has.
fn heads(d: &Description) -> Vec<Option<String>> {
    let heights = || d.regions.iter().flat_map(|r| &r.polygon).map(|p| p[1]);
    let most = heights().fold(f64::NEG_INFINITY, f64::max);
    let of_head = d.heads.iter().enumerate().map(|(i, head)| {
        let entry = match &head.name {
            Some(name) => format!("head {} ({name:?})", i + 1),
            None => format!("head {}", i + 1),
        };
        let lowest = head.line.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
        let (level, tall) = (head.head_m, size(d.regions.iter().flat_map(|r| &r.polygon)));
        if level < lowest {
            let [level, lowest] = [level, lowest].map(number);
            return Some(format!(
                "{entry}: head_m is {level}, and its line begins at y = {lowest} m, above it, so no water is given there: is it a height of y, \
                 not a depth?"
            ));
        }
        (level > most + tall).then(|| {
            let [level, most] = [level, most].map(number);
            format!(
                "{entry}: head_m is {level}, and the ground ends at y = {most} m; it is rarely that far under water: is it a pressure?"
            )
        })
    });
    let of_soil = d.soils.iter().enumerate().map(|(i, soil)| {
        let value = soil.permeability_m_per_s.filter(|k| !PERMEABILITY.contains(k))?;
        let (entry, [low, high]) = (format!("soil {} ({:?})", i + 1, soil.name), [PERMEABILITY.start(), PERMEABILITY.end()]);
        Some(format!(
            "{entry}: permeability_m_per_s is {value:e}; soils have {low:e} to {high:e} m/s: is it in m/day, or an intrinsic one in m2?"
        ))
    });
    of_head.chain(of_soil).collect()
}

fn water(d: &Description) -> Vec<Option<String>> {
    let Some(water) = &d.water else { return Vec::new() };
    let [low, high] = WATER;
    let weight = water.unit_weight_kn_m3;
    let cause = match weight {
        x if (1e3 * low..=1e3 * high).contains(&x) => "is it in N/m3?",
        x if (900.0..=1300.0).contains(&x) => "is it a density in kg/m3?",
        x if (0.9..=1.3).contains(&x) => "is it a density in t/m3?",
        _ => "is it in kN/m3?",
    };
    let unusual = !(low..=high).contains(&weight);
    let of_weight = unusual.then(|| {
        let [value, low, high] = [weight, low, high].map(number);
        format!("water: unit_weight_kn_m3 is {value}; water has {low} to {high} kN/m3: {cause}")
    });
    let heights = || d.regions.iter().flat_map(|r| &r.polygon).map(|p| p[1]);
    let [least, most] =
        [heights().fold(f64::INFINITY, f64::min), heights().fold(f64::NEG_INFINITY, f64::max)];
    let table = || water.table.iter().map(|p| p[1]);
    let [lowest, highest] =
        [table().fold(f64::INFINITY, f64::min), table().fold(f64::NEG_INFINITY, f64::max)];
    let place = if lowest > most {
        let [lowest, most] = [lowest, most].map(number);
        Some(format!(
            "water: its table is at y = {lowest} m or higher, above all ground, whose top is at y = {most} m; it is usually within the \
             ground: is all of it under open water?"
        ))
    } else if highest <= least {
        let [highest, least] = [highest, least].map(number);
        Some(format!(
            "water: its table is at y = {highest} m or lower, below all ground, which ends at y = {least} m; it is usually within the \
             ground: is its height counted from elsewhere?"
        ))
    } else {
        None
    };
    vec![of_weight, place]
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    fn notes_of(change: impl Fn(&str) -> String) -> Vec<String> {
        notes_of_text(&change(include_str!("../../../../data/problems/plate_layers.toml")))
    }

    fn notes_of_text(text: &str) -> Vec<String> {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.toml");
        std::fs::write(&path, text).unwrap();
        notes(&Description::read(&path).unwrap(), &[])
    }

    #[test]
    fn heads_that_give_no_water_are_told() {
        let dam = include_str!("../../../../data/problems/dam_seepage.toml");
        assert_eq!(notes_of_text(dam), Vec::<String>::new());
        for (old, new, words) in [
            ("head_m = 4", "head_m = -1", "no water is given there"),
            ("head_m = 4", "head_m = 40", "is it a pressure?"),
            ("= 1e-6", "= 9", "is it in m/day"),
        ] {
            let found = notes_of_text(&dam.replacen(old, new, 1));
            assert!(found.len() == 1 && found[0].contains(words), "{new}: {found:?}");
        }
    }

    #[test]
    fn a_member_that_parts_the_soil_is_told() {
        let cut = include_str!("../../../../data/problems/reinforced_cut.toml");
        assert_eq!(notes_of_text(cut), Vec::<String>::new());
        let found = notes_of_text(&cut.replacen("bond_factor = 0.8", "bond_factor = 0.2", 1));
        assert!(found.len() == 1 && found[0].contains("give pullout_kn_per_m2 instead"), "{found:?}");
        let bars = |pullout: &str| notes_of_text(&cut.replacen("bond_factor = 0.8", pullout, 1));
        assert_eq!(bars("pullout_kn_per_m2 = 10"), Vec::<String>::new());
        let found = bars("pullout_kn_per_m2 = [10, 900]");
        assert!(found.len() == 1 && found[0].contains("pullout_kn_per_m2 is 900"), "{found:?}");
    }

    #[test]
    fn each_is_told_once_and_what_is_usual_is_not() {
        assert_eq!(notes_of(str::to_owned), Vec::<String>::new());
        for (old, new, words) in [
            (
                "unit_weight_kn_m3 = 16",
                "unit_weight_kn_m3 = 16000",
                "soil 1 (\"dry sand\"): unit_weight_kn_m3 is 16000",
            ),
            ("phi_deg = 32", "phi_deg = 0.55", "phi_deg is 0.55"),
            ("phi_deg = 32", "phi_deg = 32\ncohesion_kpa = 12000", "cohesion_kpa is 12000"),
            ("[0.16, -0.45]]", "[160, -450]]", "plate \"blade\": it is 450.1 m long"),
            ("[[-3, -0.3], [3, -0.3]]\n\n", "[[-3, 2], [3, 2]]\n\n", "above all ground"),
            ("[[-3, -0.3], [3, -0.3]]\n\n", "[[-3, -20], [3, -20]]\n\n", "below all ground"),
            (
                "[[-3, -0.3], [3, -0.3]]\n\n",
                "[[-3, -0.3], [3, -0.3]]\nunit_weight_kn_m3 = 9810\n\n",
                "is it in N/m3?",
            ),
            ("[water]", "[seismic]\nkh = 9.81\n\n[water]", "is it in m/s2?"),
        ] {
            let found = notes_of(|text| {
                assert!(text.contains(old), "{old}");
                text.replacen(old, new, 1)
            });
            assert!(found.len() == 1 && found[0].contains(words), "{new}: {found:?}");
        }
    }
}
