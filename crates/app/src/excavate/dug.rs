//! The trench on the simulated arm, in three manners.

use soilctl_campaign::Plan;
use soilctl_digging::{Excavation, Made, Rules, Soils, Trench, again, excavate};
use soilctl_earth_pressure::ForceModel;

use super::answer::{DugRow, DugTrench, Manner};
use super::request::Request;
use super::row;
use crate::{AppError, Interrupted, Watch};

/// The fixed tool angle that others are compared with, in deg.
pub(super) const FIXED_DEG: f64 = 90.0;

/// Digs in all manners.
#[allow(clippy::too_many_arguments, reason = "each is what it says")]
pub(super) fn all(
    plan: &Plan,
    request: &Request,
    model: &dyn ForceModel,
    before: &Soils,
    trench: &Trench,
    rules: &Rules,
    watch: &dyn Watch,
) -> Result<Vec<DugTrench>, AppError> {
    let stop = watch.stop(Interrupted::KeepsResults);
    watch.begin(3, "trenches");
    let mut all = Vec::new();
    let mut without = None;
    for manner in [Manner::Learning, Manner::Planned, Manner::Fixed] {
        let found = match (manner, &without) {
            (Manner::Learning, _) => excavate(plan, request.seed, model, before, trench, rules, true, &stop)?,
            (Manner::Planned, _) | (Manner::Fixed, None) => {
                excavate(plan, request.seed, model, before, trench, rules, false, &stop)?
            }
            (Manner::Fixed, Some(Excavation { passes, .. })) => {
                again(plan, request.seed, model, before, passes, FIXED_DEG, &stop)?
            }
        };
        all.push(told(manner, &found));
        if manner == Manner::Planned {
            without = Some(found);
        }
        watch.advance(1);
    }
    watch.end();
    Ok(all)
}

fn told(manner: Manner, found: &Excavation) -> DugTrench {
    let swept_m3 = found.sum(|dug| dug.swept_m3);
    let work_j = found.sum(|dug| dug.work_j.iter().sum());
    let heat_a2s = found.sum(|dug| dug.heat_a2s.iter().sum());
    let over_volume = |value: f64| (swept_m3 > 0.0).then(|| value / swept_m3);
    DugTrench {
        manner,
        ended: found.end.into(),
        depth_m: found.depth_m,
        passes: found.passes.iter().map(made).collect(),
        swept_m3,
        peak_share: found.peak_share(),
        work_j,
        work_kj_m3: over_volume(1e-3 * work_j),
        heat_a2s,
        heat_a2s_per_l: over_volume(1e-3 * heat_a2s),
        time_s: found.sum(|dug| dug.time_s.iter().sum()),
    }
}

fn made(made: &Made) -> DugRow {
    let dug = &made.dug;
    DugRow {
        planned: row(&made.pass),
        depth_m: dug.depth_m,
        floor_m: made.floor_m,
        travel_m: dug.travel_m,
        swept_m3: dug.swept_m3,
        peak_force_n: dug.peak_force_n,
        peak_share: dug.peak_share,
        work_j: dug.work_j.iter().sum(),
        heat_a2s: dug.heat_a2s.iter().sum(),
        time_s: dug.time_s.iter().sum(),
        learned: made.taught.into(),
        phi_deg: made.ranges[0],
        density_kg_m3: made.ranges[1],
        failure: dug.failure.clone(),
    }
}
