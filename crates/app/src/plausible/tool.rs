//! Tools in the ground, whose quantities have keys of their own.

use super::{friction, stress, weight};
use crate::text::number;
use crate::tool::Setting;

/// Greatest depth of a tool in m.
const TOOL_M: f64 = 100.0;

/// What hardly anybody means.
pub(crate) fn notes(setting: &Setting) -> Vec<String> {
    let loads = &setting.loads;
    let mut all = vec![friction("the soil", "phi_deg", setting.phi_deg)];
    all.push(setting.delta_deg.and_then(|deg| friction("the tool", "delta_deg", deg)));
    let of_weight = weight(
        "the soil",
        "the unit weight by density_kg_m3 and gravity_m_s2",
        1e-3 * setting.density_kg_m3 * loads.gravity_m_s2,
    );
    // Another planet is meant, not another unit.
    all.push(of_weight.filter(|_| loads.gravity_m_s2 > 9.0));
    for (key, pa) in [
        ("cohesion_pa", loads.cohesion_pa),
        ("adhesion_pa", loads.adhesion_pa),
        ("surcharge_pa", loads.surcharge_pa),
    ] {
        all.push(stress("the soil", key, 1e-3 * pa, pa));
    }
    let deep = setting.depth_m.filter(|m| *m > TOOL_M).map(number);
    let most = number(TOOL_M);
    all.push(
        deep.map(|m| format!("the tool: depth_m is {m}; few tools go deeper than {most} m: is it in mm?")),
    );
    all.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_unusual_is_told() {
        let usual =
            Setting { phi_deg: 35.0, delta_deg: Some(20.0), density_kg_m3: 1600.0, ..Setting::default() };
        assert_eq!(notes(&usual), Vec::<String>::new());
        for (setting, words) in [
            (Setting { phi_deg: 0.6, ..usual.clone() }, "radians"),
            (Setting { density_kg_m3: 1.6, ..usual.clone() }, "unit weight"),
            (Setting { depth_m: Some(150.0), ..usual.clone() }, "is it in mm?"),
        ] {
            let found = notes(&setting);
            assert!(found.len() == 1 && found[0].contains(words), "{found:?}");
        }
    }
}
