//! The next best stroke: which tool angle, depth and width would shrink the region most.
//!
//! For a few soils spread over the consistent set the failure force of each candidate is predicted, given the
//! uncertainty that such a stroke would have, and added as a measurement. What is left of the region, averaged
//! over those soils, ranks the candidate. (Hong 2001, figure 7-13, found 40 deg by hand.)

use soilctl_earth_pressure::ForceModel;
use soilctl_soil::{Angle, Plate};

use crate::constraint::{constraint, merged};
use crate::end_factor::EndFactors;
use crate::estimate::{Estimate, estimate, region_only};
use crate::{EstimatorError, Observation, Setup};

/// What a stroke costs and how well it measures.
#[derive(Debug, Clone, PartialEq)]
pub struct StrokeMenu {
    /// Tool angles in degrees to consider.
    pub tool_angles_deg: Vec<f64>,
    /// Vertical depths in m to consider.
    pub depths_m: Vec<f64>,
    /// Plate widths in m to consider.
    pub widths_m: Vec<f64>,
    /// Relative scatter of the force from stroke to stroke (one band half width).
    pub force_scatter: f64,
    /// Uncertainty of the depth in m (one band half width); it enters twice, force going with depth squared.
    pub depth_error_m: f64,
    /// Greatest force in N that the arm can exert; candidates above it are left out.
    pub force_limit_n: Option<f64>,
}

/// A candidate with what it promises.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// Tool angle in degrees.
    pub alpha_deg: f64,
    /// Vertical depth in m.
    pub depth_m: f64,
    /// Plate width in m.
    pub width_m: f64,
    /// Expected area of the (phi, density) region after the stroke, relative to before.
    pub area_left: f64,
    /// Expected width of the phi range after the stroke in degrees.
    pub phi_width_deg: f64,
    /// Expected width of the density range after the stroke in kg/m3.
    pub density_width_kg_m3: f64,
    /// Largest force expected in N.
    pub force_n: f64,
    /// Model used for prediction and region: the setup's, or the closed form where that does not cover the tool angle.
    pub model: &'static str,
}

/// Candidates, the best first. Tool angles that the setup's model does not cover are judged by `closed_form`, such as
/// [`soilctl_earth_pressure::ChenLiu`].
///
/// # Errors
/// As [`estimate`]; [`EstimatorError::TooLittle`] if nothing is consistent, or the menu is empty.
pub fn next_strokes<'m>(
    setup: &Setup<'m>,
    now: &Estimate,
    menu: &StrokeMenu,
    closed_form: &'m dyn ForceModel,
) -> Result<Vec<Candidate>, EstimatorError> {
    if !now.is_consistent() {
        return Err(EstimatorError::TooLittle {
            task: "the choice of the next stroke",
            needed: "at least one consistent soil",
            found: "is none; find the conflict first".into(),
        });
    }
    setup.check_one_friction("the choice of the next stroke")?;
    setup.check_known_loads("the choice of the next stroke")?;
    let own = Stage::new(setup.clone(), now.clone())?;
    let outside = |alpha: f64| {
        let (low, high) = setup.model.valid_range().alpha_deg;
        alpha < low || alpha > high
    };
    // One model for old and new measurements alike, so that the two do not disagree by model form.
    let closed_form = if menu.tool_angles_deg.iter().any(|&alpha| outside(alpha)) {
        let setup = Setup { model: closed_form, ..setup.clone() };
        let before = estimate(&setup)?;
        if before.is_consistent() { Some(Stage::new(setup, before)?) } else { None }
    } else {
        None
    };
    let mut candidates = Vec::new();
    for &alpha_deg in &menu.tool_angles_deg {
        let Some(stage) = (if outside(alpha_deg) { closed_form.as_ref() } else { Some(&own) }) else {
            continue;
        };
        for &depth_m in &menu.depths_m {
            for &width_m in &menu.widths_m {
                candidates.extend(stage.candidate(menu, alpha_deg, depth_m, width_m)?);
            }
        }
    }
    candidates.sort_by(|a, b| a.area_left.total_cmp(&b.area_left).then(a.alpha_deg.total_cmp(&b.alpha_deg)));
    Ok(candidates)
}

struct Stage<'m> {
    setup: Setup<'m>,
    before: Estimate,
    /// Soils spread over the consistent set, with the end factor of each.
    soils: Vec<([f64; 3], EndFactors)>,
}

impl<'m> Stage<'m> {
    fn new(setup: Setup<'m>, before: Estimate) -> Result<Self, EstimatorError> {
        let soils = spread(&setup, &before);
        let factors = end_factors(&setup, &soils)?;
        Ok(Self { soils: soils.into_iter().zip(factors).collect(), setup, before })
    }

    /// `None` if the model has no answer for the candidate, or it needs more force than the arm has.
    fn candidate(
        &self,
        menu: &StrokeMenu,
        alpha_deg: f64,
        depth_m: f64,
        width_m: f64,
    ) -> Result<Option<Candidate>, EstimatorError> {
        let plate = Plate::new(Angle::from_degrees(alpha_deg), Angle::ZERO, depth_m, width_m)?;
        let uncertainty = menu.force_scatter + 2.0 * menu.depth_error_m / depth_m;
        let (mut area, mut phi, mut density, mut force, mut count) = (0.0, 0.0, 0.0, 0.0_f64, 0.0);
        for &(soil, ends) in &self.soils {
            let Some(force_n) = self.force_n(&plate, soil, ends)? else {
                return Ok(None);
            };
            let mut observations = self.setup.observations.clone();
            observations.push(Observation::new("candidate", plate, force_n, uncertainty * force_n)?);
            let after = region_only(&self.setup.with_observations(observations))?;
            let Some((phi_range, density_range)) = after.bounds() else { continue };
            area += after.area();
            phi += phi_range[1] - phi_range[0];
            density += density_range[1] - density_range[0];
            force = force.max(force_n);
            count += 1.0;
        }
        if count == 0.0 || menu.force_limit_n.is_some_and(|limit| force > limit) {
            return Ok(None);
        }
        Ok(Some(Candidate {
            alpha_deg,
            depth_m,
            width_m,
            area_left: area / count / self.before.region.area(),
            phi_width_deg: phi / count,
            density_width_kg_m3: density / count,
            force_n: force,
            model: self.setup.model.id(),
        }))
    }

    /// The force that a plate needs in a soil, by the model at an end factor; `None` if the model has no answer or no force
    /// above 0.
    fn force_n(
        &self,
        plate: &Plate,
        [phi_deg, density_kg_m3, delta_deg]: [f64; 3],
        ends: EndFactors,
    ) -> Result<Option<f64>, EstimatorError> {
        let any = Observation::new("candidate", *plate, 1.0, 1.0)?;
        let Ok(constraint) = constraint(&self.setup, &any) else { return Ok(None) };
        let force = constraint.net(phi_deg, delta_deg).ok().flatten().map(|net| {
            let (per_density, rest_n) = constraint.force_parts(&net, ends);
            density_kg_m3 * per_density + rest_n
        });
        Ok(force.filter(|force| *force > 0.0))
    }
}

/// Soils spread over the consistent set: at three densities of the region, the middle of its phi range there.
fn spread(setup: &Setup<'_>, before: &Estimate) -> Vec<[f64; 3]> {
    let delta = f64::midpoint(setup.delta_deg.0, setup.delta_deg.1);
    let Some((_, density)) = before.region.bounds() else { return Vec::new() };
    [0.2, 0.5, 0.8]
        .into_iter()
        .filter_map(|t| {
            let rho = density[0] + t * (density[1] - density[0]);
            let (low, high) = phi_range_at(before, rho)?;
            Some([f64::midpoint(low, high), rho, delta])
        })
        .collect()
}

fn phi_range_at(before: &Estimate, density: f64) -> Option<(f64, f64)> {
    let mut ends: Option<(f64, f64)> = None;
    for ring in before.region.polygons().iter().flatten() {
        for (i, a) in ring.iter().enumerate() {
            let b = ring[(i + 1) % ring.len()];
            if (a[1] > density) != (b[1] > density) {
                let x = a[0] + (density - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                ends = Some(ends.map_or((x, x), |(l, h)| (l.min(x), h.max(x))));
            }
        }
    }
    ends
}

/// For each soil the middle of the end factors that measurements leave there, or all of them if strokes share none.
fn end_factors(setup: &Setup<'_>, soils: &[[f64; 3]]) -> Result<Vec<EndFactors>, EstimatorError> {
    if !setup.shares_ends() {
        return Ok(vec![EndFactors::ANY; soils.len()]);
    }
    let constraints = merged(setup)?;
    let of = |[phi_deg, density_kg_m3, delta_deg]: [f64; 3]| {
        let nets = constraints.iter().map(|c| Some((c, c.net(phi_deg, delta_deg).ok().flatten()?)));
        let nets = nets.collect::<Option<Vec<_>>>()?;
        let left = EndFactors::all().filter(|ends| {
            let ends = ends.of_strokes(setup.end_tolerance);
            nets.iter().all(|(constraint, net)| {
                let [low, high] = constraint.band(net, ends);
                low <= density_kg_m3 && density_kg_m3 <= high
            })
        });
        left.reduce(EndFactors::hull).map(|ends| EndFactors::at(ends.middle()))
    };
    Ok(soils.iter().map(|&soil| of(soil).unwrap_or(EndFactors::ANY)).collect())
}
