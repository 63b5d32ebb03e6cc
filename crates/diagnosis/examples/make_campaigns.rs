//! Writes the example campaigns of `data/campaigns`, what is hidden in them apart from the rest:
//! `cargo run -p soilctl-diagnosis --example make_campaigns data/campaigns`.

use std::error::Error;
use std::path::PathBuf;

use soilctl_diagnosis::self_test::{Case, Design, Kind, SelfTest};
use soilctl_effects::EffectId;
use soilctl_strokes::StrokeTable;

const CAMPAIGNS: [(&str, EffectId, u64); 3] = [
    ("campaign_a", EffectId::TipBearing, 101),
    ("campaign_b", EffectId::ForceDrift, 102),
    ("campaign_c", EffectId::AdjacentStroke, 103),
];

fn main() -> Result<(), Box<dyn Error>> {
    let out = PathBuf::from(std::env::args().nth(1).ok_or("give the folder to write to")?);
    let test = SelfTest::new("table", 2001)?;
    std::fs::create_dir_all(out.join("sealed"))?;
    for (name, id, number) in CAMPAIGNS {
        let case = Case { kind: Kind::Single, number, causes: vec![id.into()], design: Design::default() };
        let campaign = test.campaign(&case)?.ok_or("the drawn soil has no finite force")?;
        let folder = out.join(name);
        std::fs::create_dir_all(&folder)?;
        let strokes = folder.join("strokes.csv");
        StrokeTable::new("strokes.csv", &campaign.rows)?.write(&strokes)?;
        campaign.campaign.write_beside(&strokes)?;
        let hidden: Vec<String> = campaign
            .hidden
            .iter()
            .map(|h| {
                format!("    {{\"id\": \"{}\", \"size\": {}, \"detail\": {}}}", h.cause, h.size, h.detail)
            })
            .collect();
        let sealed = format!("{{\n  \"hidden\": [\n{}\n  ]\n}}\n", hidden.join(",\n"));
        std::fs::write(out.join("sealed").join(format!("{name}.json")), sealed)?;
    }
    Ok(())
}
