//! What soil bears and what fails it, on the simulated arm in simulated sand.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::path::Path;

use soilctl_campaign::Plan;
use soilctl_controller::TrajectoryKind;
use soilctl_digging::{Bite, Machine, Soils, borne};
use soilctl_earth_pressure::plane_model;

/// As long as the sand bears the plate's force, it is none that fails it for certain; when it fails, the force is none that it bears for certain.
/// Both at the inclination that the force has, whether that is the friction on the plate or less.
#[test]
fn sand_bears_what_is_within_and_fails_beyond() {
    for (soil, alpha, delta_set) in [("ticino_loose", 80.0, 23.0), ("glass_beads", 90.0, 8.0)] {
        let text = format!(
            "version = 1\nsoil = \"{soil}\"\nmodel = \"table\"\n[preparation]\ndensity_sd_rel = 0.0\n[[batches]]\nradius_m = 0.4318\n\
             strokes = [{{ base_deg = 0.0, alpha_deg = {alpha}, depth_m = 0.025, delta_set_deg = {delta_set} }}]\n"
        );
        let plan = Plan::from_toml(&text, "plan", Path::new(".")).unwrap();
        let preset = plan.soil();
        let soils = Soils::within(
            [preset.phi_deg; 2],
            [preset.delta_deg; 2],
            [preset.density_kg_m3; 2],
            preset.gravity_m_s2,
        )
        .unwrap();
        let table = plane_model("table").unwrap();
        let (mut borne_ticks, mut failed) = (0, None);
        let dug = Machine::new(&plan, 3, 0)
            .unwrap()
            .stroke_watched(&plan.strokes().strokes()[0], &mut |tick| {
                let truth = &tick.truth.soil;
                let strokes = tick.outputs.telemetry.trajectory == Some(TrajectoryKind::Stroke);
                if !strokes
                    || failed.is_some()
                    || truth.normal_n < 1.0
                    || tick.outputs.tick % 20 != 0 && !truth.failing
                {
                    return;
                }
                let bite = Bite {
                    tool_angle_deg: truth.tool_angle_rad.to_degrees(),
                    depth_m: truth.depth_m,
                    heap_m: truth.heap_m,
                    width_m: 0.127,
                };
                // The edge may hold a little more than the face.
                let inclination = truth.tangent_n.atan2(truth.normal_n).to_degrees();
                let inclination = inclination.clamp(0.0, preset.delta_deg);
                let limits = borne(table.as_ref(), &soils, &bite, inclination).unwrap();
                let face = truth.normal_n / inclination.to_radians().cos();
                if truth.failing {
                    failed = Some((face, limits));
                } else {
                    assert!(face <= 1.01 * limits.fails_n.unwrap(), "{face} N is borne, {limits:?}");
                    borne_ticks += 1;
                }
            })
            .unwrap();
        let (face, limits) = failed.unwrap();
        assert!(dug.done && borne_ticks > 50, "{borne_ticks}");
        // 1 %: interpolation of the plant's coefficients, and what is called failing.
        assert!(face >= 0.985 * limits.bears_n.unwrap(), "{face} N fails, {limits:?}");
    }
}
