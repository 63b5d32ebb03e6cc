//! Strokes of one kind as one band: which are of one kind, and what each force would have been at the reference of its kind.

use soilctl_earth_pressure::{Case, ChenLiu, EarthPressureError, ForceModel};
use soilctl_soil::Angle;
use soilctl_strokes::{Campaign, Kind, Measurement, Pool, StrokeRow, StrokeTable, pool};

use super::answer::LeftOut;
use super::request::Request;
use crate::AppError;
use crate::text::number;

/// Strokes are of one kind if their tool angles differ by no more than this from that of the first, in deg,
const SAME_ALPHA_DEG: f64 = 1.0;
/// the inclinations that their forces were to have by no more than this, in deg,
const SAME_FRICTION_DEG: f64 = 6.0;
/// their depths by no more than this share, and their widths by no more than the other. Models are exact in depth, and the friction is
/// that at failure, which is closer together than what was asked for.
const SAME_DEPTH: f64 = 0.35;
const SAME_WIDTH: f64 = 1e-3;
/// Forces are carried over some degrees and tenths of the depth by Chen and Liu's model in a soil of this friction angle and density.
const USUAL_PHI_DEG: f64 = 40.0;
/// At 30 or 45 deg such a correction is by this share of itself different, by the table of proven bounds at 70 to 100 deg.
const CARRIED_SHARE: f64 = 0.2;
const USUAL_DENSITY_KG_M3: f64 = 1500.0;

/// Dense soil whose friction on the plate is held further below that of other strokes, in deg, yields slowly and before it bears all it
/// can: its forces are up to 15 % low (`docs/process.md`).
const FAR_BELOW_DEG: f64 = 3.0;
/// A plate that sank or rose by more of its depth was not pulled through the soil as models have it.
const MOST_DRIFT: f64 = 0.1;

/// A stroke and the friction on its plate.
#[derive(Clone)]
struct Stroke {
    row: StrokeRow,
    /// Inclination of the force when the soil failed, in deg, as far as it is told.
    friction_deg: Option<f64>,
}

/// Bands of all kinds of strokes.
#[derive(Debug, Clone)]
pub struct Bands {
    /// One measurement a kind, at its reference.
    pub measurements: Vec<Measurement>,
    /// Their bands, in the same order.
    pub pool: Pool,
    /// Probability with which all bands together hold their true forces.
    pub confidence: f64,
    /// Friction on the plate (deg) that all forces are brought to, if the strokes tell theirs.
    pub friction_deg: Option<f64>,
    /// Strokes that do not count.
    pub left_out: Vec<LeftOut>,
}

/// Whether the table says how forces scatter, or how well depths are known: strokes are repeated, or depths have a deviation.
pub(super) fn tells_scatter(table: &StrokeTable) -> bool {
    let strokes: Vec<Stroke> = table.rows().map(|row| Stroke { row, friction_deg: None }).collect();
    strokes.iter().any(|stroke| stroke.row.depth_sd_m.is_some()) || kinds(&strokes).len() < strokes.len()
}

/// The bands of a table.
pub(super) fn bands(
    request: &Request,
    table: &StrokeTable,
    campaign: &Campaign,
    model: &dyn ForceModel,
    confidence: f64,
) -> Result<Bands, AppError> {
    let strokes = table.rows().map(|row| Stroke { friction_deg: friction_deg(request, &row), row });
    let Chosen { strokes, friction_deg, left_out } = chosen(request, strokes.collect());
    let batch = |stroke: &Stroke| stroke.row.batch.clone();
    let first = strokes.first().and_then(batch);
    // In one preparation there is one density, and that is the one to find.
    let is_one_preparation = first.is_some() && strokes.iter().all(|stroke| batch(stroke) == first);
    let carrier = Carrier {
        request,
        campaign,
        friction_deg,
        density_sd_rel: if is_one_preparation { 0.0 } else { campaign.density_sd_rel },
        range: model.valid_range().alpha_deg,
    };
    let mut measurements = Vec::new();
    let mut all = Vec::new();
    for members in kinds(&strokes) {
        let members: Vec<&Stroke> = members.into_iter().filter_map(|place| strokes.get(place)).collect();
        let Some((reference, kind)) = carrier.kind(table.name(), &members)? else { continue };
        measurements.push(measurement(&reference, &kind, &members));
        all.push(kind);
    }
    let pool = pool(table.name(), &all, confidence)?;
    for (measurement, band) in measurements.iter_mut().zip(&pool.bands) {
        measurement.force_n = band.force_n;
        measurement.force_sd_n = band.force_n * band.mean_rel.hypot(band.common_rel);
    }
    Ok(Bands { measurements, pool, confidence, friction_deg, left_out })
}

/// Strokes that count, the friction (deg) that they are brought to, and the others.
struct Chosen {
    strokes: Vec<Stroke>,
    friction_deg: Option<f64>,
    left_out: Vec<LeftOut>,
}

/// Leaves out strokes in which the soil did not fail as models have it, unless none would be left. The friction is that of the option,
/// or the mean of what the strokes tell. Frictions that are far from the option's, taken together, are not taken into account.
fn chosen(request: &Request, mut strokes: Vec<Stroke>) -> Chosen {
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
fn friction_deg(request: &Request, row: &StrokeRow) -> Option<f64> {
    match request.delta_deg.number() {
        // Less may be mobilised when the soil fails, never more.
        Some(delta_deg) => {
            row.friction_angle_deg.map(|angle| angle.clamp(0.0, delta_deg + request.delta_tol_deg))
        }
        None => row.friction_angle_deg.or(row.delta_set_deg),
    }
}

/// Places of the strokes of each kind, in the order in which kinds first appear.
fn kinds(strokes: &[Stroke]) -> Vec<Vec<usize>> {
    let mut kinds: Vec<Vec<usize>> = Vec::new();
    for (place, stroke) in strokes.iter().enumerate() {
        let of = |members: &&mut Vec<usize>| {
            members.first().and_then(|first| strokes.get(*first)).is_some_and(|first| are_alike(first, stroke))
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

/// The plate of a kind.
struct Reference {
    alpha_deg: f64,
    depth_m: f64,
    width_m: f64,
}

/// A force at the reference of its kind.
struct Carried {
    force_n: f64,
    /// Relative standard deviation by what is the stroke's own; `None` if the table does not say that of the force.
    sd_rel: Option<f64>,
    /// Logarithm of what tool angle and friction have changed.
    corrected: f64,
}

/// Brings forces to a reference.
struct Carrier<'a> {
    request: &'a Request,
    campaign: &'a Campaign,
    friction_deg: Option<f64>,
    /// Of the density between preparations.
    density_sd_rel: f64,
    /// Tool angles that the model covers, in deg.
    range: (f64, f64),
}

impl Carrier<'_> {
    fn kind(&self, file: &str, members: &[&Stroke]) -> Result<Option<(Reference, Kind)>, AppError> {
        let mut angles: Vec<f64> = members.iter().map(|stroke| stroke.row.alpha_deg).collect();
        angles.sort_by(f64::total_cmp);
        let Some(first) = members.first() else { return Ok(None) };
        let middle = angles.get(angles.len() / 2).copied().unwrap_or(first.row.alpha_deg);
        let inside = middle.clamp(self.range.0, self.range.1);
        let reference = Reference {
            // A plate that stood a little outside of what the model covers is carried to the end.
            alpha_deg: if (inside - middle).abs() <= SAME_ALPHA_DEG { inside } else { middle },
            depth_m: members.iter().map(|s| s.row.depth_m).sum::<f64>() / members.len() as f64,
            width_m: first.row.width_m,
        };
        let carried = members.iter().map(|stroke| {
            self.carried(&reference, stroke).map_err(|problem| AppError::Row {
                file: file.to_owned(),
                line: stroke.row.line,
                problem,
            })
        });
        let carried: Vec<Carried> = carried.collect::<Result<_, AppError>>()?;
        let corrected = carried.iter().map(|one| one.corrected).sum::<f64>() / members.len() as f64;
        let common = self.common_rel(&reference, members).map_err(AppError::EarthPressure)?;
        let depth_mm = 1e3 * reference.depth_m;
        let kind = Kind {
            label: format!("{} deg, {} mm", number(reference.alpha_deg), number((depth_mm * 10.0).round() / 10.0)),
            lines: members.iter().map(|stroke| stroke.row.line).collect(),
            forces_n: carried.iter().map(|one| one.force_n).collect(),
            sds_rel: carried.iter().map(|one| one.sd_rel).collect(),
            common_rel: common.hypot(CARRIED_SHARE * corrected),
        };
        Ok(Some((reference, kind)))
    }

    fn carried(&self, to: &Reference, stroke: &Stroke) -> Result<Carried, EarthPressureError> {
        let row = &stroke.row;
        let friction = stroke.friction_deg;
        let alpha_deg = row.alpha_deg + row.turned_deg.unwrap_or(0.0);
        let here = self.usual_n(alpha_deg, friction, row.depth_m, row.width_m)?;
        let there = self.usual_n(to.alpha_deg, self.friction_deg, to.depth_m, to.width_m)?;
        let force_n = row.force_n * there / here;
        let beside = self.usual_n(to.alpha_deg, self.friction_deg, row.depth_m, row.width_m)?;
        let corrected = (beside / here).ln();
        let Some(force_sd_n) = row.force_sd_n else { return Ok(Carried { force_n, sd_rel: None, corrected }) };
        let by_depth = self.depth_exponent(alpha_deg, friction, row)?;
        let depth_sd_m = row.depth_sd_m.unwrap_or(self.campaign.depth_sd_m);
        let friction_sd_deg = match (row.friction_angle_deg, friction) {
            (Some(_), _) => row.friction_angle_sd_deg.unwrap_or(self.campaign.instrument.friction_angle_sd),
            (None, Some(_)) => self.campaign.delta_sd_deg,
            (None, None) => 0.0,
        };
        let by_friction = match friction {
            Some(deg) => {
                let more = self.usual_n(alpha_deg, Some(deg + 1.0), row.depth_m, row.width_m)?;
                (more / here).ln()
            }
            None => 0.0,
        };
        let own = [force_sd_n / row.force_n, by_depth * depth_sd_m / row.depth_m, by_friction * friction_sd_deg];
        Ok(Carried { force_n, sd_rel: Some(together(&own)), corrected })
    }

    /// What strokes of a kind share: the sensor's gain, the datum of depths, the density of their preparations, the soil ahead.
    fn common_rel(&self, at: &Reference, members: &[&Stroke]) -> Result<f64, EarthPressureError> {
        let Some(first) = members.first() else { return Ok(0.0) };
        let mut batches: Vec<Option<&str>> = members.iter().map(|stroke| stroke.row.batch.as_deref()).collect();
        batches.sort_unstable();
        batches.dedup();
        let by_depth = self.depth_exponent(at.alpha_deg, self.friction_deg, &first.row)?;
        let campaign = self.campaign;
        Ok(together(&[
            campaign.instrument.force_gain_sd,
            by_depth * campaign.depth_common_sd_m / at.depth_m,
            self.density_sd_rel / (batches.len() as f64).sqrt(),
            campaign.soil_sd_rel,
        ]))
    }

    /// Relative change of a force with a relative change of the depth: 2 under the soil's weight alone.
    fn depth_exponent(
        &self,
        alpha_deg: f64,
        friction_deg: Option<f64>,
        row: &StrokeRow,
    ) -> Result<f64, EarthPressureError> {
        let at = |depth_m: f64| self.usual_n(alpha_deg, friction_deg, depth_m, row.width_m);
        Ok((at(1.01 * row.depth_m)? / at(row.depth_m)?).ln() / 1.01_f64.ln())
    }

    /// Force in N that a soil of usual strength fails at.
    fn usual_n(
        &self,
        alpha_deg: f64,
        friction_deg: Option<f64>,
        depth_m: f64,
        width_m: f64,
    ) -> Result<f64, EarthPressureError> {
        let loads = &self.request.loads;
        let case = Case {
            tool_angle: Angle::from_degrees(alpha_deg),
            surface_slope: Angle::from_degrees(loads.beta_deg),
            friction: Angle::from_degrees(USUAL_PHI_DEG),
            interface: Angle::from_degrees(friction_deg.unwrap_or(0.5 * USUAL_PHI_DEG).clamp(0.0, USUAL_PHI_DEG)),
        };
        let net = ChenLiu.predict(&case)?.net;
        let slant_m = depth_m / alpha_deg.to_radians().sin();
        let weight = 0.5 * USUAL_DENSITY_KG_M3 * loads.gravity_m_s2 * slant_m * net.weight;
        let others = loads.surcharge_pa * net.surcharge
            + loads.cohesion_pa * net.cohesion
            + loads.adhesion_pa * net.adhesion;
        Ok(slant_m * width_m * (weight + others))
    }
}

fn measurement(reference: &Reference, kind: &Kind, members: &[&Stroke]) -> Measurement {
    let mean = |value: fn(&StrokeRow) -> Option<f64>| {
        let some: Vec<f64> = members.iter().filter_map(|stroke| value(&stroke.row)).collect();
        (!some.is_empty()).then(|| some.iter().sum::<f64>() / some.len() as f64)
    };
    let forces = kind.forces_n.iter();
    Measurement {
        alpha_deg: reference.alpha_deg,
        depth_m: reference.depth_m,
        width_m: reference.width_m,
        force_n: 0.0,
        force_sd_n: 0.0,
        force_min_n: forces.clone().copied().fold(f64::INFINITY, f64::min),
        force_max_n: forces.copied().fold(0.0, f64::max),
        count: members.len(),
        lines: kind.lines.clone(),
        stroke_ids: members.iter().filter_map(|stroke| stroke.row.stroke_id.clone()).collect(),
        label: kind.label.clone(),
        density_kg_m3: mean(|row| row.density_kg_m3),
        delta_set_deg: mean(|row| row.delta_set_deg),
    }
}

/// Independent deviations together.
fn together(parts: &[f64]) -> f64 {
    parts.iter().map(|part| part * part).sum::<f64>().sqrt()
}
