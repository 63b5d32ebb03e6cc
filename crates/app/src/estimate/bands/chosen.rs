//! Which strokes count, and which of them are of one kind.

use std::cmp::Ordering;

use soilctl_strokes::StrokeRow;

use super::super::answer::LeftOut;
use super::super::request::Request;
use crate::text::number;

/// Strokes are of one kind if their tool angles differ by no more than this from that of the first, in deg,
pub(in crate::estimate) const SAME_ALPHA_DEG: f64 = 1.0;
/// the inclinations that their forces were to have by no more than this, in deg,
const SAME_FRICTION_DEG: f64 = 6.0;
/// their depths by no more than this share, and their widths by no more than the other. Models are exact in depth, and the friction is
/// that at failure, which is closer together than what was asked for.
const SAME_DEPTH: f64 = 0.35;
/// The same where loads are unknowns, or the ground may change with depth: how a force grows with depth is then not known, and to first order a mean
/// depth needs it not.
const SAME_DEPTH_OF_LOADS: f64 = 0.05;
const SAME_WIDTH: f64 = 1e-3;
/// Dense soil whose friction on the plate is held further below that of other strokes, in deg, yields slowly and before it bears all it
/// can: its forces are up to 15 % low (`docs/process.md`).
const FAR_BELOW_DEG: f64 = 3.0;
/// A plate that sank or rose by more of its depth was not pulled through the soil as models have it.
const MOST_DRIFT: f64 = 0.1;

/// A stroke and the friction on its plate.
#[derive(Clone)]
pub(super) struct Stroke {
    pub(super) row: StrokeRow,
    /// Inclination of the force when the soil failed, in deg, as far as it is told.
    pub(super) friction_deg: Option<f64>,
}

/// Strokes that count, the friction (deg) that they are brought to, and the others.
pub(super) struct Chosen {
    pub(super) strokes: Vec<Stroke>,
    pub(super) friction_deg: Option<f64>,
    pub(super) left_out: Vec<LeftOut>,
    /// What is doubtful about that, in sentences.
    pub(super) warnings: Vec<String>,
}

/// Leaves out strokes in which the soil did not fail as models have it, unless none would be left. The friction is that of the option,
/// or the mean of what the strokes tell. Frictions that are far from the option's, taken together, are not taken into account.
pub(super) fn chosen(request: &Request, mut strokes: Vec<Stroke>) -> Chosen {
    let mut told: Vec<f64> = strokes.iter().filter_map(|stroke| stroke.friction_deg).collect();
    told.sort_by(f64::total_cmp);
    let middle = told.get(told.len() / 2).copied();
    let given = request.delta_deg.number();
    let mut warnings = Vec::new();
    if let (Some(given), Some(middle)) = (given, middle)
        && (given - middle).abs() > FAR_BELOW_DEG
    {
        warnings.push(format!(
            "--delta is {} deg, and the forces lay at {middle:.1} deg to the plate's normal when the soil failed; they are taken as they \
             are, as if the friction on the plate had been that of --delta",
            number(given)
        ));
        strokes.iter_mut().for_each(|stroke| stroke.friction_deg = None);
    }
    let least = given.or(middle).map(|friction| friction - FAR_BELOW_DEG);
    let why = |stroke: &Stroke| {
        let drift_m = stroke.row.z_drift_m.unwrap_or(0.0).abs();
        if drift_m > MOST_DRIFT * stroke.row.depth_m {
            return Some(format!(
                "the plate sank or rose by {} mm before the soil failed, more than a tenth of its depth",
                number((1e4 * drift_m).round() / 10.0)
            ));
        }
        let friction = stroke.friction_deg.filter(|friction| least.is_some_and(|least| *friction < least))?;
        Some(format!(
            "the force lay at {friction:.1} deg to the plate's normal when the soil failed, more than {FAR_BELOW_DEG} deg below the others"
        ))
    };
    let (out, kept): (Vec<Stroke>, Vec<Stroke>) = strokes.iter().cloned().partition(|s| why(s).is_some());
    if kept.is_empty()
        && let Some(reason) = out.first().and_then(&why)
    {
        warnings.push(format!("every stroke would be left out, so all count; of the first one, {reason}"));
    }
    let (strokes, left_out) = if kept.is_empty() { (strokes, Vec::new()) } else { (kept, out) };
    let left_out = left_out.iter().filter_map(|stroke| {
        Some(LeftOut { line: stroke.row.line, stroke_id: stroke.row.stroke_id.clone(), reason: why(stroke)? })
    });
    let told: Vec<f64> = strokes.iter().filter_map(|stroke| stroke.friction_deg).collect();
    let mean = (!told.is_empty()).then(|| told.iter().sum::<f64>() / told.len() as f64);
    Chosen { left_out: left_out.collect(), friction_deg: given.or(mean), strokes, warnings }
}

/// Inclination of the force when the soil failed: as measured, otherwise as asked for. With a number for delta only what was measured
/// counts.
pub(super) fn friction_deg(request: &Request, row: &StrokeRow) -> Option<f64> {
    match request.delta_deg.number() {
        // Less may be mobilised when the soil fails, never more.
        Some(delta_deg) => {
            row.friction_angle_deg.map(|angle| angle.clamp(0.0, delta_deg + request.delta_tol_deg))
        }
        None => row.friction_angle_deg.or(row.delta_set_deg),
    }
}

/// Depths of strokes of one kind differ by this share at most.
pub(super) fn same_depth(request: &Request) -> f64 {
    if request.intervals.any() || request.tells_depths_apart { SAME_DEPTH_OF_LOADS } else { SAME_DEPTH }
}

/// Places of the strokes of each kind, in the order in which kinds first appear. Which strokes are of one kind does not depend on their
/// order: each kind begins with the least tool angle, then depth, that is left.
pub(super) fn kinds(strokes: &[Stroke], same_depth: f64) -> Vec<Vec<usize>> {
    let mut sorted: Vec<(usize, &Stroke)> = strokes.iter().enumerate().collect();
    let rank = |stroke: &Stroke| [stroke.row.alpha_deg, stroke.row.depth_m, asked_deg(stroke).unwrap_or(0.0)];
    sorted.sort_by(|(_, a), (_, b)| {
        let pairs = rank(a).into_iter().zip(rank(b));
        pairs.map(|(a, b)| a.total_cmp(&b)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal)
    });
    let mut kinds: Vec<Vec<usize>> = Vec::new();
    for (place, stroke) in sorted {
        let of = |members: &&mut Vec<usize>| {
            members
                .first()
                .and_then(|first| strokes.get(*first))
                .is_some_and(|first| are_alike(first, stroke, same_depth))
        };
        match kinds.iter_mut().find(of) {
            Some(members) => members.push(place),
            None => kinds.push(vec![place]),
        }
    }
    kinds.iter_mut().for_each(|members| members.sort_unstable());
    kinds.sort_unstable();
    kinds
}

/// The set-point rather than what was measured, which scatters about it.
fn asked_deg(stroke: &Stroke) -> Option<f64> {
    stroke.row.delta_set_deg.or(stroke.friction_deg)
}

fn are_alike(first: &Stroke, other: &Stroke, same_depth: f64) -> bool {
    let (a, b) = (&first.row, &other.row);
    let friction = match (asked_deg(first), asked_deg(other)) {
        (Some(a), Some(b)) => (a - b).abs() <= SAME_FRICTION_DEG,
        (None, None) => true,
        (Some(_), None) | (None, Some(_)) => false,
    };
    friction
        && (a.alpha_deg - b.alpha_deg).abs() <= SAME_ALPHA_DEG
        && (b.depth_m / a.depth_m - 1.0).abs() <= same_depth
        && (b.width_m / a.width_m - 1.0).abs() <= SAME_WIDTH
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::request::NumberOrColumn;

    fn strokes(plates: &[(f64, f64)]) -> Vec<Stroke> {
        let row = |(alpha_deg, depth_m): &(f64, f64)| StrokeRow {
            alpha_deg: *alpha_deg,
            depth_m: *depth_m,
            width_m: 0.1,
            force_n: 5.0,
            friction_angle_deg: Some(20.0),
            ..StrokeRow::default()
        };
        plates.iter().map(|plate| Stroke { row: row(plate), friction_deg: Some(20.0) }).collect()
    }

    /// From 70.0 on, 70.9 is within a degree and 71.5 is not, wherever they stand in the table.
    #[test]
    fn the_order_of_strokes_does_not_say_which_are_of_one_kind() {
        let plates = [(70.9, 0.02), (71.5, 0.02), (70.0, 0.02), (90.0, 0.02), (70.0, 0.04)];
        assert_eq!(kinds(&strokes(&plates), SAME_DEPTH), [vec![0, 2], vec![1], vec![3], vec![4]]);
        let turned: Vec<_> = plates.iter().rev().copied().collect();
        assert_eq!(kinds(&strokes(&turned), SAME_DEPTH), [vec![0], vec![1], vec![2, 4], vec![3]]);
    }

    #[test]
    fn strokes_that_all_count_in_spite_of_a_doubt_and_a_friction_that_is_not_believed_are_said() {
        let mut sunk = strokes(&[(70.0, 0.02), (80.0, 0.02)]);
        sunk.iter_mut().for_each(|stroke| stroke.row.z_drift_m = Some(0.003));
        let request = Request::default();
        let all = chosen(&request, sunk.clone());
        assert_eq!((all.strokes.len(), all.left_out.len(), all.warnings.len()), (2, 0, 1));
        assert!(all.warnings[0].contains("sank or rose by 3 mm"), "{:?}", all.warnings);
        sunk[1].row.z_drift_m = None;
        let some = chosen(&request, sunk);
        assert_eq!((some.strokes.len(), some.left_out.len(), some.warnings.len()), (1, 1, 0));
        let request = Request { delta_deg: NumberOrColumn::Number(30.0), ..request };
        let far = chosen(&request, strokes(&[(70.0, 0.02)]));
        assert!(
            far.strokes[0].friction_deg.is_none() && far.warnings[0].contains("--delta is 30 deg"),
            "{:?}",
            far.warnings
        );
    }
}
