//! The menu of follow-ups, and the strokes of each.

use soilctl_effects::{Channel, Covariate};
use soilctl_soil::units::inches_to_m;
use soilctl_strokes::StrokeRow;

use crate::data::Data;

/// Strokes in a preparation.
const BATCH: usize = 6;
/// Most levels of a menu entry that are gone through before the next tool angle.
const LEVELS: usize = 4;

/// A way to vary the strokes of a campaign.
pub(super) struct Menu {
    /// What it varies.
    pub(super) covariates: &'static [Covariate],
    pub(super) name: &'static str,
    /// Whether a plan of the arm can say it: its plate, its speed and the place of its box are those of its settings.
    pub(super) by_plan: bool,
    change: fn(&Data, usize, &mut StrokeRow),
}

fn cycle(values: &[f64], i: usize) -> f64 {
    values[i % values.len()]
}

pub(super) const MENU: [Menu; 10] = [
    Menu {
        covariates: &[Covariate::Depth],
        name: "a depth ladder from half the usual depth to one and a half times it",
        by_plan: true,
        change: |data, i, row| row.depth_m = cycle(&[0.5, 1.5, 0.75, 1.25], i) * data.reference.depth_m,
    },
    Menu {
        covariates: &[Covariate::Width],
        name: "a second, narrower plate at shallow and deep strokes",
        by_plan: false,
        change: |data, i, row| {
            row.width_m *= if i % 4 < 2 { 0.4 } else { 1.0 };
            row.depth_m = cycle(&[0.6, 1.4], i) * data.reference.depth_m;
        },
    },
    Menu {
        covariates: &[],
        name: "a depth ladder from half the usual depth to one and a half times it, with a narrower plate in every other batch",
        by_plan: false,
        change: |data, i, row| {
            row.width_m *= if (i / BATCH).is_multiple_of(2) { 0.4 } else { 1.0 };
            row.depth_m = cycle(&[0.5, 1.5, 0.75, 1.25], i) * data.reference.depth_m;
        },
    },
    Menu {
        covariates: &[Covariate::Speed],
        name: "a ladder of speeds over a factor of 16, in random order",
        by_plan: false,
        change: |data, i, row| {
            row.speed_mps =
                Some(cycle(&[1.0, 4.0, 0.25, 4.0, 1.0, 0.25], i) * data.reference.speed_mps.unwrap_or(0.01));
        },
    },
    Menu {
        covariates: &[Covariate::Radius],
        name: "the same tool angles at 12 in and 17 in, swapped",
        by_plan: true,
        change: |_, i, row| row.radius_m = Some(inches_to_m(if i % 2 == 0 { 12.0 } else { 17.0 })),
    },
    Menu {
        covariates: &[Covariate::BaseAngle],
        name: "the box turned round by 180 deg in every other batch (base angles count from the box), strokes over the arm's base angles",
        by_plan: false,
        change: |data, i, row| {
            // The arm goes where it went before; of a box that was turned already, nobody knows where that was.
            let (low, high) =
                data.reference.base_deg.filter(|(low, high)| high - low <= 90.0).unwrap_or((-35.0, 35.0));
            let turn = if (i / BATCH).is_multiple_of(2) { 180.0 } else { 0.0 };
            row.base_deg = Some(turn + cycle(&[low, f64::midpoint(low, high), high], i));
        },
    },
    Menu {
        covariates: &[Covariate::PriorGap],
        name: "strokes at set distances from earlier ones: side by side and far apart",
        by_plan: false,
        change: |_, i, row| row.gap_prior_m = Some(cycle(&[0.01, 0.15, 0.03], i)),
    },
    Menu {
        covariates: &[Covariate::Wall],
        name: "strokes close to a wall and in the middle of the box",
        by_plan: false,
        change: |_, i, row| row.wall_m = Some(cycle(&[0.01, 0.2, 0.04], i)),
    },
    Menu {
        covariates: &[Covariate::InterfaceSetPoint],
        name: "bracketing strokes: the interface friction set 4 deg low, right and 4 deg high",
        by_plan: true,
        change: |data, i, row| {
            row.delta_set_deg = Some((data.delta_set_deg(0) + cycle(&[-4.0, 0.0, 4.0], i)).max(1.0))
        },
    },
    Menu {
        covariates: &[Covariate::Order, Covariate::Time, Covariate::Batch],
        name: "the first batch once more, at the end",
        by_plan: true,
        change: |_, _, _| {},
    },
];

/// For what depends on the tool angle in a way that no effect does.
pub(super) const ANGLES: Menu = Menu {
    covariates: &[Covariate::ToolAngle],
    name: "tool angles halfway between those of the campaign",
    by_plan: true,
    change: |data, i, row| {
        let angles = &data.levels_deg;
        let next = angles.get((i + i / LEVELS) % angles.len() + 1).unwrap_or(&angles[0]);
        row.alpha_deg = 0.5 * (row.alpha_deg + next);
    },
};

/// Strokes of a menu entry: batches of six made after the campaign.
pub(super) fn design(data: &Data, entry: &Menu, readings: &[Channel], count: usize) -> Vec<StrokeRow> {
    let last = data.rows.iter().filter_map(|row| row.time_s).fold(0.0, f64::max);
    // Follow-ups that were made before have such names, too.
    let number = |name: Option<&str>| name?.strip_prefix("next")?.parse::<usize>().ok();
    let largest = |names: &mut dyn Iterator<Item = Option<&str>>| names.filter_map(number).max().unwrap_or(0);
    let strokes = largest(&mut data.rows.iter().map(|row| row.stroke_id.as_deref()));
    let batches = largest(&mut data.rows.iter().map(|row| row.batch.as_deref()));
    (0..count)
        .map(|i| {
            // One tool angle further in each round, so that no angle always meets the same level of the menu.
            let level = (i + i / LEVELS) % data.levels_deg.len();
            let like = like(data, i, level);
            let mut row = StrokeRow {
                line: i + 2,
                stroke_id: Some(format!("next{:02}", strokes + i + 1)),
                batch: Some(format!("next{}", batches + 1 + i / BATCH)),
                order: Some((i % BATCH) as u32 + 1),
                time_s: data.reference.time_s.map(|_| last + 3600.0 + 300.0 * i as f64),
                alpha_deg: data.levels_deg[level],
                depth_m: like.depth_m,
                width_m: like.width_m,
                speed_mps: like.speed_mps,
                radius_m: like.radius_m,
                base_deg: like.base_deg,
                gap_prior_m: like.gap_prior_m,
                wall_m: like.wall_m,
                density_kg_m3: like.density_kg_m3,
                delta_set_deg: like.delta_set_deg,
                force_n: 1.0,
                ..StrokeRow::default()
            };
            (entry.change)(data, i, &mut row);
            readings.iter().for_each(|channel| channel.fill(&mut row, 0.0));
            row
        })
        .collect()
}

/// The stroke that the `i`-th of a follow-up is like, but for its tool angle and what the menu changes. An arm reaches some tool angles from
/// some places only: for a plan of it, one of the same tool angle.
fn like(data: &Data, i: usize, level: usize) -> &StrokeRow {
    let of_level: Vec<&StrokeRow> =
        data.rows.iter().zip(&data.level).filter(|(_, of)| **of == level).map(|(row, _)| row).collect();
    match of_level.get((i / LEVELS) % of_level.len().max(1)) {
        Some(row) if data.is_compared() => row,
        _ => &data.rows[(i * 5) % data.len().min(12)],
    }
}
