//! Which strokes count, and which of them are of one kind.

use soilctl_strokes::StrokeRow;

use super::super::answer::LeftOut;
use super::super::request::Request;
use crate::text::number;

/// Strokes are of one kind if their tool angles differ by no more than this from that of the first, in deg,
pub(super) const SAME_ALPHA_DEG: f64 = 1.0;
/// the inclinations that their forces were to have by no more than this, in deg,
const SAME_FRICTION_DEG: f64 = 6.0;
/// their depths by no more than this share, and their widths by no more than the other. Models are exact in depth, and the friction is
/// that at failure, which is closer together than what was asked for.
const SAME_DEPTH: f64 = 0.35;
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
}

/// Leaves out strokes in which the soil did not fail as models have it, unless none would be left. The friction is that of the option,
/// or the mean of what the strokes tell. Frictions that are far from the option's, taken together, are not taken into account.
pub(super) fn chosen(request: &Request, mut strokes: Vec<Stroke>) -> Chosen {
    let mut told: Vec<f64> = strokes.iter().filter_map(|stroke| stroke.friction_deg).collect();
    told.sort_by(f64::total_cmp);
    let middle = told.get(told.len() / 2).copied();
    let given = request.delta_deg.number();
    if let (Some(given), Some(middle)) = (given, middle)
        && (given - middle).abs() > FAR_BELOW_DEG
    {
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
    let (strokes, left_out) = if kept.is_empty() { (strokes, Vec::new()) } else { (kept, out) };
    let left_out = left_out.iter().filter_map(|stroke| {
        Some(LeftOut { line: stroke.row.line, stroke_id: stroke.row.stroke_id.clone(), reason: why(stroke)? })
    });
    let told: Vec<f64> = strokes.iter().filter_map(|stroke| stroke.friction_deg).collect();
    let mean = (!told.is_empty()).then(|| told.iter().sum::<f64>() / told.len() as f64);
    Chosen { left_out: left_out.collect(), friction_deg: given.or(mean), strokes }
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

/// Places of the strokes of each kind, in the order in which kinds first appear.
pub(super) fn kinds(strokes: &[Stroke]) -> Vec<Vec<usize>> {
    let mut kinds: Vec<Vec<usize>> = Vec::new();
    for (place, stroke) in strokes.iter().enumerate() {
        let of = |members: &&mut Vec<usize>| {
            members
                .first()
                .and_then(|first| strokes.get(*first))
                .is_some_and(|first| are_alike(first, stroke))
        };
        match kinds.iter_mut().find(of) {
            Some(members) => members.push(place),
            None => kinds.push(vec![place]),
        }
    }
    kinds
}

fn are_alike(first: &Stroke, other: &Stroke) -> bool {
    let (a, b) = (&first.row, &other.row);
    // The set-point rather than what was measured, which scatters about it.
    let asked = |stroke: &Stroke| stroke.row.delta_set_deg.or(stroke.friction_deg);
    let friction = match (asked(first), asked(other)) {
        (Some(a), Some(b)) => (a - b).abs() <= SAME_FRICTION_DEG,
        (None, None) => true,
        (Some(_), None) | (None, Some(_)) => false,
    };
    friction
        && (a.alpha_deg - b.alpha_deg).abs() <= SAME_ALPHA_DEG
        && (b.depth_m / a.depth_m - 1.0).abs() <= SAME_DEPTH
        && (b.width_m / a.width_m - 1.0).abs() <= SAME_WIDTH
}
