//! Plates of `bound`, whose quantities have keys of their own.

use super::{friction, stress, weight};
use crate::bound::Request;
use crate::text::number;

/// Greatest depth and width of a plate in m.
const PLATE_M: f64 = 100.0;
/// How much wider than deep a plate usually is at most.
const RATIO: f64 = 500.0;

/// What hardly anybody means.
pub(crate) fn notes(r: &Request) -> Vec<String> {
    let mut all =
        vec![friction("the soil", "phi_deg", r.phi_deg), friction("the plate", "delta_deg", r.delta_deg)];
    if let Some(density) = r.density_kg_m3 {
        let of_weight = weight(
            "the soil",
            "the unit weight by density_kg_m3 and gravity_m_s2",
            1e-3 * density * r.loads.gravity_m_s2,
        );
        // Another planet is meant, not another unit.
        all.push(of_weight.filter(|_| r.loads.gravity_m_s2 > 9.0));
    }
    for (key, pa) in [
        ("cohesion_pa", r.loads.cohesion_pa),
        ("adhesion_pa", r.loads.adhesion_pa),
        ("surcharge_pa", r.loads.surcharge_pa),
    ] {
        all.push(stress("the soil", key, 1e-3 * pa, pa));
    }
    for (key, m) in [("depth_m", r.depth_m), ("width_m", r.width_m)] {
        let long = m.filter(|m| *m > PLATE_M).map(number);
        let most = number(PLATE_M);
        all.push(
            long.map(|m| {
                format!("the plate: {key} is {m}; few plates have more than {most} m: is it in mm?")
            }),
        );
    }
    if let (Some(depth), Some(width)) = (r.depth_m, r.width_m)
        && width <= PLATE_M
        && width > RATIO * depth
    {
        let [width, depth, ratio] = [width, depth, RATIO].map(number);
        all.push(Some(format!(
            "the plate: width_m is {width} at a depth_m of {depth}; few plates are more than {ratio} times as wide as deep: is one of \
             them in mm?"
        )));
    }
    all.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_width_in_millimetres_is_told() {
        let plate =
            Request { phi_deg: 35.0, depth_m: Some(0.025), width_m: Some(0.127), ..Request::default() };
        assert_eq!(notes(&plate), Vec::<String>::new());
        for (request, words) in [
            (Request { width_m: Some(127.0), ..plate.clone() }, "width_m is 127"),
            (Request { width_m: Some(99.0), ..plate.clone() }, "is one of them in mm?"),
            (Request { phi_deg: 0.6, ..plate.clone() }, "radians"),
            (Request { density_kg_m3: Some(1.6), ..plate.clone() }, "unit weight"),
        ] {
            let found = notes(&request);
            assert!(found.len() == 1 && found[0].contains(words), "{found:?}");
        }
    }
}
