//! Problems to begin with.

use serde::Serialize;
use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{Aim, SoilEntry};

/// A problem to begin with.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Template {
    StripFooting,
    StripLoad,
    Slope,
    WallPassive,
    WallActive,
    SmoothWall,
    Plate,
    Embankment,
    Anchor,
}

/// A template as pages take it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Given {
    id: &'static str,
    name: &'static str,
    what: &'static str,
    problem: Description,
}

impl Template {
    const ALL: [Self; 9] = [
        Self::StripFooting,
        Self::StripLoad,
        Self::Slope,
        Self::WallPassive,
        Self::WallActive,
        Self::SmoothWall,
        Self::Plate,
        Self::Embankment,
        Self::Anchor,
    ];

    const fn words(self) -> [&'static str; 3] {
        match self {
            Self::StripFooting => {
                ["strip-footing", "Strip footing", "rough, 2 m wide, on sand with a surcharge: force"]
            }
            Self::StripLoad => {
                ["strip-load", "Strip load", "flexible, 2 m wide, on clay: bearing capacity in kPa"]
            }
            Self::Slope => ["slope", "Slope", "1 in 2 with a water table: factor of safety"],
            Self::WallPassive => {
                ["wall-passive", "Retaining wall, passive", "rough, 3 m, pushed into sand: force"]
            }
            Self::WallActive => {
                ["wall-active", "Retaining wall, active", "rough, 3 m, giving way: force of the sand"]
            }
            Self::SmoothWall => {
                ["wall-smooth", "Smooth wall", "no friction on its face, pushed: Rankine's force"]
            }
            Self::Plate => ["plate", "Plate in sand", "leaning, pushed through sand: force"],
            Self::Embankment => {
                ["embankment", "Embankment on clay", "half of it, sand on clay: factor of safety"]
            }
            Self::Anchor => ["anchor", "Anchor block", "buried in clay, pulled obliquely: force"],
        }
    }

    fn problem(self) -> Option<Description> {
        let file = |text: &str| Description::from_toml(text).ok();
        let sand = SoilEntry {
            name: "sand".into(),
            phi_deg: Some(35.0),
            unit_weight_kn_m3: 17.0,
            ..SoilEntry::default()
        };
        let clay = SoilEntry {
            name: "clay".into(),
            phi_deg: Some(0.0),
            cohesion_kpa: 40.0,
            unit_weight_kn_m3: 18.0,
            ..SoilEntry::default()
        };
        let titled = |title: &str, it: Description| Some(Description { title: Some(title.into()), ..it });
        match self {
            Self::StripFooting => file(include_str!("../../../data/problems/footing_sand.toml")),
            Self::StripLoad => titled("strip load on clay", Description::strip_load(clay, 2.0)),
            Self::Slope => file(include_str!("../../../data/problems/slope.toml")),
            Self::WallPassive => file(include_str!("../../../data/problems/wall_passive.toml")),
            Self::WallActive => file(include_str!("../../../data/problems/wall_active.toml")),
            Self::SmoothWall => {
                let mut it = file(include_str!("../../../data/problems/wall_passive.toml"))?;
                it.structures.iter_mut().for_each(|wall| wall.delta_deg = 0.0);
                titled("smooth wall, passive", it)
            }
            Self::Plate => {
                let mut it = Description::embedded_plate(sand, 60.0, 0.3, 20.0);
                // Whole decimetres are easier to go on from than what sine and cosine give.
                it.plates.iter_mut().for_each(|plate| plate.line = vec![[0.0, 0.0], [0.15, -0.26]]);
                it.objective = Aim::Structure { name: "plate".into(), direction: [1.0, 0.0] };
                titled("plate in sand", it)
            }
            Self::Embankment => file(include_str!("../../../data/problems/embankment.toml")),
            Self::Anchor => file(include_str!("../../../data/problems/anchor.toml")),
        }
    }
}

/// All templates.
pub(crate) fn all() -> Vec<Given> {
    let given = |template: &Template| {
        let [id, name, what] = template.words();
        template.problem().map(|problem| Given { id, name, what, problem })
    };
    Template::ALL.iter().filter_map(given).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::*;

    #[test]
    fn all_templates_are_problems() {
        let all = all();
        assert_eq!(all.len(), Template::ALL.len());
        for given in all {
            given.problem.described().unwrap();
            assert!(given.problem.title.is_some(), "{}", given.id);
        }
    }
}
