//! Rigid blocks in plans.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::path::Path;

use soilctl_campaign::{CampaignError, Plan};

fn read(block: &str) -> Result<Plan, CampaignError> {
    let text = format!(
        "version = 1\nsoil = \"ticino_loose\"\nmodel = \"chen\"\n[[blocks]]\n{block}\n[[batches]]\nstrokes = [\n{{ radius_m = 0.43, base_deg = 10.0, \
         alpha_deg = 90.0, depth_m = 0.02, delta_set_deg = 22.0 }},\n]\n[[batches]]\nstrokes = [\n{{ radius_m = 0.43, base_deg = 10.0, alpha_deg = \
         90.0, depth_m = 0.02, delta_set_deg = 22.0 }},\n]\n"
    );
    Plan::from_toml(&text, "plan", Path::new(""))
}

#[test]
fn blocks_lie_in_their_batches_and_not_below_a_plate() {
    let good = "face_radius_m = 0.38\nbase_deg = 10.0\ntop_m = 0.005\nwidth_m = 0.2\nlength_m = 0.1";
    let plan = read(&format!("batch = 1\n{good}")).unwrap();
    assert_eq!((plan.blocks_of(0).len(), plan.blocks_of(1).len()), (0, 1));
    assert_eq!(read(good).unwrap().blocks_of(0).len(), 1);
    // Strokes of their own are made alone, in soil without blocks.
    assert_eq!(plan.apart().unwrap().blocks_of(0), []);
    for (bad, said) in [
        (format!("batch = 2\n{good}"), "numbered from 0 to 1"),
        (good.replace("0.38", "0.44"), "above `blocks[0]`"),
        (good.replace("0.005", "-0.005"), "blocks[0].top_m"),
        (good.replace("width_m = 0.2", "width_m = nan"), "blocks[0].width_m"),
        (format!("{good}\nheight_m = 1"), "height_m"),
    ] {
        let problem = read(&bad).unwrap_err().to_string();
        assert!(problem.contains(said), "{problem}");
    }
}
