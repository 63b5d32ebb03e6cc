//! Plans: what ships, what is refused, and what they turn into.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::path::Path;

use soilctl_campaign::{CampaignError, Plan};

const TABLE_6_2: &str = include_str!("../../../data/plans/table_6_2.toml");
const TABLE_6_3: &str = include_str!("../../../data/plans/table_6_3.toml");

fn plan(text: &str) -> Result<Plan, CampaignError> {
    Plan::from_toml(text, "plan.toml", Path::new(""))
}

fn refused(text: &str) -> String {
    plan(text).unwrap_err().to_string()
}

const HEAD: &str = "version = 1\nsoil = \"ticino_loose\"\n";
const STROKE: &str = "[[batches]]\nstrokes = [{ radius_m = 0.4, base_deg = 0.0, alpha_deg = 80.0, depth_m = 0.02, \
                      delta_set_deg = 23.0 }]\n";

#[test]
fn the_tables_of_the_thesis() {
    for (text, batches, in_batch, soil) in
        [(TABLE_6_2, 8, 6, "ticino_loose"), (TABLE_6_3, 12, 4, "ticino_rained")]
    {
        let plan = plan(text).unwrap();
        assert_eq!((plan.batches(), plan.soil().name.as_str()), (batches, soil));
        for batch in 0..batches {
            assert_eq!(plan.strokes_of(batch), batch * in_batch..(batch + 1) * in_batch);
            for stroke in &plan.strokes().strokes()[plan.strokes_of(batch)] {
                assert_eq!(usize::from(stroke.batch), batch);
            }
        }
        assert!(plan.strokes_of(batches).is_empty());
    }
}

#[test]
fn what_is_refused() {
    for (text, words) in [
        ("version = 1\n".to_owned() + STROKE, "missing field `soil`"),
        (format!("version = 2\nsoil = \"ticino_loose\"\n{STROKE}"), "`version` is 2; it must be 1"),
        (format!("version = 1\nsoil = \"ticino\"\n{STROKE}"), "there is no soil `ticino`"),
        (format!("{HEAD}batches = []\n"), "`batches` is empty"),
        (format!("{HEAD}[[batches]]\nstrokes = []\n"), "`batches[0].strokes` is empty"),
        (format!("{HEAD}speed = 3\n{STROKE}"), "unknown field `speed`"),
        (format!("{HEAD}model = \"plasticity\"\n{STROKE}"), "plasticity"),
        (format!("{HEAD}seed = -1\n{STROKE}"), "-1"),
        (format!("{HEAD}end_factor = 1.5\n{STROKE}"), "`end_factor` is 1.5; it must be from 0 to 1"),
        (format!("{HEAD}end_factor = nan\n{STROKE}"), "`end_factor` is NaN"),
        (
            HEAD.to_owned() + &STROKE.replace("radius_m = 0.4, ", ""),
            "`batches[0].strokes[0].radius_m` is missing",
        ),
        (HEAD.to_owned() + &STROKE.replace("0.02", "0.5"), "stroke 1 cannot be reached at full depth"),
        (HEAD.to_owned() + &STROKE.replace("80.0", "140.0"), "it must be from 45 to 135 deg"),
        (format!("{HEAD}[preparation]\ndensity_sd_rel = 0.5\n{STROKE}"), "`density_sd_rel` is 0.5"),
    ] {
        let message = refused(&text);
        assert!(message.contains(words), "{words}: {message}");
    }
    assert!(matches!(Plan::read(Path::new("/no/such.toml")), Err(CampaignError::File { .. })));
}

#[test]
fn a_soil_by_its_numbers_and_the_radius_of_the_batch() {
    let text = "version = 1\nmodel = \"chen\"\n[soil]\nphi_deg = 38.0\ndelta_deg = 20.0\ndensity_kg_m3 = 1500.0\n\
                loosest_kg_m3 = 1400.0\ndensest_kg_m3 = 1700.0\n[[batches]]\nradius_m = 0.35\nstrokes = [\
                { base_deg = 0.0, alpha_deg = 80.0, depth_m = 0.02, delta_set_deg = 20.0 },\
                { radius_m = 0.4, base_deg = 20.0, alpha_deg = 80.0, depth_m = 0.02, delta_set_deg = 20.0 }]\n";
    let plan = plan(text).unwrap();
    assert_eq!(plan.soil().phi_deg, 38.0);
    let radii: Vec<f64> = plan.strokes().strokes().iter().map(|stroke| stroke.radius_m).collect();
    assert_eq!(radii, [0.35, 0.4]);
    let message = refused(&text.replace("delta_deg = 20.0", "delta_deg = 50.0"));
    assert!(message.contains("plan.toml: `delta_deg` is 50 deg"), "{message}");
}

/// The controller that a log describes is the one of the plan, strokes included.
#[test]
fn a_log_holds_the_whole_plan() {
    let plan = plan(TABLE_6_2).unwrap();
    let params = plan.setup(3).unwrap().params().unwrap();
    assert_eq!(params.plan().strokes(), plan.strokes().strokes());
    assert_eq!(params.config(), plan.controller());
}

/// Soil under another gravity brings the arm along.
#[test]
fn on_mars() {
    let plan = plan(&(HEAD.replace("ticino_loose", "mars_pathfinder") + STROKE)).unwrap();
    assert_eq!(plan.params().arm().config().gravity_m_s2, 3.71);
    plan.simulated_plant(1, 0).unwrap();
}
