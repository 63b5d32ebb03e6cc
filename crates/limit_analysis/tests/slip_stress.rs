//! At which stress the friction counts: fields of both bounds against closed forms.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use soilctl_earth_pressure::{Case, EQUIVALENT_OVER_MEAN, mean_slip_stress_over_pressure};
use soilctl_limit_analysis::results::{FlowResults, SlipStress, StressResults, slip_stress};
use soilctl_limit_analysis::{EmbeddedPlate, Options, bound};

fn options() -> Options {
    Options { max_gap: 1e-6, max_work: u64::MAX, max_elements: 1500, ..Options::default() }
}

/// Normal stresses where soil slips ahead of a plate, and the normal pressure on the plate, in unit weight times slant length.
fn stresses(plate: &EmbeddedPlate) -> (SlipStress, f64) {
    let problem = plate.problem().unwrap();
    let bounds = bound(&problem, &options(), &mut |_, _| {}).unwrap();
    let flow = FlowResults::new(problem.statement(), &bounds.upper.field).unwrap();
    let stress = StressResults::new(problem.statement(), &bounds.lower.field).unwrap();
    let slope = plate.alpha_deg.to_radians().tan();
    let is_ahead = |[x, y]: [f64; 2]| x > -y / slope;
    let force = f64::midpoint(bounds.lower.value, bounds.upper.value)
        / (plate.alpha_deg + plate.delta_deg).to_radians().sin();
    (slip_stress(&flow, &stress, is_ahead).unwrap(), force * plate.delta_deg.to_radians().cos())
}

#[test]
fn fields_and_the_closed_form_agree_on_the_stress_where_soil_slips() {
    for (alpha_deg, phi_deg, delta_deg) in [(90.0, 35.0, 0.0), (60.0, 35.0, 20.0), (105.0, 45.0, 20.0)] {
        let plate = EmbeddedPlate { alpha_deg, phi_deg, delta_deg, ..EmbeddedPlate::default() };
        let (found, pressure) = stresses(&plate);
        let case = Case::level_deg(alpha_deg, phi_deg, delta_deg);
        let expected = mean_slip_stress_over_pressure(&case).unwrap() * pressure;
        let text = format!("{alpha_deg} {phi_deg} {delta_deg}: {found:?}, expected {expected}");
        // By Jensen's inequality.
        assert!(found.mean <= found.equivalent && found.equivalent <= found.heavy, "{text}");
        let [least, most] = EQUIVALENT_OVER_MEAN;
        assert!(least <= found.equivalent / expected && found.equivalent / expected <= most, "{text}");
    }
}
