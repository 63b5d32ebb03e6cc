//! Set-membership estimation: every soil that explains the measured forces within their uncertainty.

mod answer;
mod bands;
#[cfg(not(target_family = "wasm"))]
mod beside;
mod exact;
mod inputs;
mod law;
mod request;
mod unknowns;
mod words;

use soilctl_earth_pressure::{ChenLiu, ForceModel, InPlaneStrain, model};
use soilctl_estimator::{
    Conflict, Estimate, Optimiser, Projections, Quantity, Region, Setup, StrokeMenu, agreement_factor,
    best_fit, conflict, estimate, local_minima, next_strokes, projections, section, slip_stress_pa,
    spread_starts,
};

pub use answer::{
    Answer, Centre, Disagreement, LeftOut, Measured, Minimum, NextStroke, PlaneStrain, Point, Pooled,
    Section, distinct,
};
pub use bands::Bands;
#[cfg(not(target_family = "wasm"))]
pub use beside::Beside;
pub use exact::{ContourSection, Crossing, ExactAnswer};
use inputs::Files;
pub use inputs::Inputs;
pub use law::{LawAnswer, LawRange, LawSlice, ShearTest};
pub use request::{Request, Uncertainty};
pub use unknowns::{Cost, Intervals, Name, Pair, Unknown, UnknownsAnswer};

use soilctl_strokes::Measurement;
#[cfg(not(target_family = "wasm"))]
use soilctl_strokes::{Campaign, StrokeTable};

use crate::request::Ends;
use crate::{AppError, Watch, request as requests};

/// An estimate with everything that figures and pages are drawn from.
pub struct Estimation {
    /// What was asked.
    pub request: Request,
    /// What was known.
    pub inputs: Inputs,
    /// The force model.
    pub model: Box<dyn ForceModel>,
    /// The consistent set.
    pub estimate: Estimate,
    /// Its shadows.
    pub projections: Projections,
    /// Sections at the chosen deltas (deg).
    pub sections: Vec<(f64, Region)>,
    /// The answer.
    pub answer: Answer,
}

impl Estimation {
    /// The setup that the estimator worked with.
    ///
    /// # Errors
    /// None in practice: the same setup gave this estimate.
    pub fn setup(&self) -> Result<Setup<'_>, AppError> {
        self.inputs.setup(&self.request, &*self.model)
    }
}

/// Estimates with everything that was asked for.
///
/// # Errors
/// [`AppError`] if the request or the table makes no sense, or a file cannot be read. That no soil explains the measurements is
/// an answer.
pub fn run(request: &Request, _watch: &dyn Watch) -> Result<Estimation, AppError> {
    requests::check(request)?;
    of_files(request, &Files::read(request, request.exact)?)
}

/// The same for a part of a table that was read, such as the strokes of one place.
#[cfg(not(target_family = "wasm"))]
pub(crate) fn of_part(
    request: &Request,
    table: StrokeTable,
    campaign: Campaign,
) -> Result<Estimation, AppError> {
    of_files(request, &Files::of(table, campaign))
}

/// What is known before anything is estimated, for what asks the estimator itself.
#[cfg(not(target_family = "wasm"))]
pub(crate) struct Known {
    pub(crate) inputs: Inputs,
    pub(crate) model: Box<dyn ForceModel>,
    pub(crate) ends: Ends,
}

#[cfg(not(target_family = "wasm"))]
impl Known {
    /// Of a table that was read.
    pub(crate) fn of(request: &Request, table: StrokeTable, campaign: Campaign) -> Result<Self, AppError> {
        let files = Files::of(table, campaign);
        let (ends, model) = ends_and_model(request, &files)?;
        Ok(Self { inputs: Inputs::new(request, &files, false, &*model)?, model, ends })
    }

    /// The setup of the estimator, for this request or one with more unknowns.
    pub(crate) fn setup(&self, request: &Request) -> Result<Setup<'_>, AppError> {
        self.inputs.setup(request, &*self.model)
    }
}

/// Whether plates have ends, and the model with or without them.
fn ends_and_model(request: &Request, files: &Files) -> Result<(Ends, Box<dyn ForceModel>), AppError> {
    let known = model(&request.model)?;
    Ok(match ends(request, files, &*known)? {
        Ends::Finite => (Ends::Finite, known),
        Ends::None => (Ends::None, InPlaneStrain::of(known)),
    })
}

fn of_files(request: &Request, files: &Files) -> Result<Estimation, AppError> {
    request.intervals.refuse(&[
        ("--exact", request.exact),
        ("--next-strokes", request.next_strokes),
        ("--compare", request.compare),
        ("--friction-law", request.friction_law.is_some()),
        ("--sections", !request.sections_deg.is_empty()),
    ])?;
    let exact_data = request.exact;
    let knows_ends = model(&request.model)?.has_ends();
    let (ends, model) = ends_and_model(request, files)?;
    let inputs = Inputs::new(request, files, exact_data, &*model)?;
    let setup = inputs.setup(request, &*model)?;
    let deltas = inputs.sections(request);
    // Exact data have bands of no width, which meet nowhere but in theory: contours take their place.
    let estimate = if exact_data { Estimate::default() } else { estimate(&setup)? };
    let projections = match &estimate.joint {
        Some(joint) => Projections {
            delta_density: joint.pair(Quantity::InterfaceFriction, Quantity::Density),
            phi_delta: joint.pair(Quantity::Friction, Quantity::InterfaceFriction),
            volume: None,
        },
        None if exact_data => Projections::default(),
        None => projections(&setup)?,
    };
    // What takes all loads as known is not asked about unknown ones.
    let knows_loads = setup.unknowns.is_none();
    let sections = if exact_data || !knows_loads { &[] } else { &deltas[..] };
    let sections = sections
        .iter()
        .map(|&delta| Ok((delta, section(&setup, delta)?)))
        .collect::<Result<Vec<_>, AppError>>()?;
    let exact = if exact_data { Some(exact::answer(&setup, &deltas)?) } else { None };
    let consistent = estimate.is_consistent();
    let disagreement = if consistent || exact_data { None } else { disagreement_of_strokes(&setup)? };
    let next = if request.next_strokes && consistent {
        Some(
            next_strokes(&setup, &estimate, &menu(request, &inputs, &setup), &ChenLiu)?
                .iter()
                .map(NextStroke::from)
                .collect(),
        )
    } else {
        None
    };
    let optimisers = if request.compare { Some(compare(&setup, &estimate)?) } else { None };
    let best_estimate = if knows_loads { best_fit(&setup, &estimate)?.map(Into::into) } else { None };
    let plane_strain = if ends == Ends::Finite && !exact_data {
        Some(PlaneStrain::from(&in_plane_strain(request, files)?))
    } else {
        None
    };
    let slip_stress_pa = estimate
        .phi_deg
        .filter(|_| knows_loads)
        .map_or_else(|| vec![None; setup.observations.len()], |phi_deg| slip_stress_pa(&setup, phi_deg));
    let mut answer = Answer {
        model: model.id().into(),
        ends,
        width_ratio: width_ratio(&setup),
        end_factor: estimate.end_factor,
        plane_strain,
        consistent,
        phi_deg: estimate.phi_deg,
        reference_stress_pa: setup.friction_law.map(|law| law.reference_stress_pa),
        slip_stress_pa: slip_stress_pa
            .iter()
            .flatten()
            .copied()
            .reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]),
        friction_law: LawAnswer::of(&setup, &estimate)?,
        unknowns: UnknownsAnswer::of(&setup, &estimate, request.intervals.costs)?,
        gravity_m_s2: setup.gravity_m_s2,
        density_kg_m3: estimate.density_kg_m3,
        regions: Vec::new(),
        region: estimate.region.polygons().to_vec(),
        delta_density: projections.delta_density.polygons().to_vec(),
        phi_delta: projections.phi_delta.polygons().to_vec(),
        area_deg_kg_m3: estimate.region.area(),
        volume_deg2_kg_m3: projections.volume,
        delta_deg: [inputs.delta_deg.0, inputs.delta_deg.1],
        density_known_kg_m3: inputs.density_kg_m3.map(|(low, high)| [low, high]),
        centre: centre(&estimate),
        best_estimate,
        cut_by: words::limits(&estimate),
        confidence: inputs.bands.as_ref().map(|bands| bands.confidence),
        confidence_each: inputs.bands.as_ref().map(|bands| bands.pool.each),
        scatter_over_stated: inputs.bands.as_ref().and_then(|bands| bands.pool.scatter_over_stated),
        measurements: setup
            .observations
            .iter()
            .zip(&inputs.measurements)
            .enumerate()
            .map(|(place, (observation, m))| {
                Measured::of(observation, m.count, slip_stress_pa[place], inputs.band(place))
            })
            .collect(),
        left_out: inputs.bands.as_ref().map_or_else(Vec::new, |bands| bands.left_out.clone()),
        disagreement,
        verdict: String::new(),
        next_strokes: next,
        optimisers,
        exact,
        warnings: inputs.warnings.clone(),
    };
    if consistent {
        answer.regions = sections
            .iter()
            .map(|(delta_deg, region)| Section {
                delta_deg: *delta_deg,
                polygons: region.polygons().concat(),
            })
            .collect();
    }
    answer.verdict = words::verdict(&answer);
    answer.warnings.extend(words::warnings(&answer, request, knows_ends));
    Ok(Estimation { request: request.clone(), inputs, model, estimate, projections, sections, answer })
}

/// Whether plates have ends. If a model file has their effect, its forces are without it, and they must not be counted twice.
fn ends(request: &Request, files: &Files, model: &dyn ForceModel) -> Result<Ends, AppError> {
    let ends = Ends::of(request.ends, model, true)?;
    let (Ends::Finite, Some(path)) = (ends, &files.without_ends) else { return Ok(ends) };
    if request.ends.is_some() {
        return Err(AppError::Request(format!(
            "{} takes the effect of ends out of the forces, and --ends finite would count it again; leave one of them out",
            path.display()
        )));
    }
    Ok(Ends::None)
}

/// The same measurements and the same model, asked about plates without ends.
fn in_plane_strain(request: &Request, files: &Files) -> Result<Estimate, AppError> {
    let model = InPlaneStrain::of(model(&request.model)?);
    let inputs = Inputs::new(request, files, false, &*model)?;
    Ok(estimate(&inputs.setup(request, &*model)?)?)
}

/// Least and greatest width of a plate over its depth.
fn width_ratio(setup: &Setup<'_>) -> [f64; 2] {
    let ratios = setup.observations.iter().map(|o| o.plate().width_m() / o.plate().depth_m());
    ratios.fold([f64::INFINITY, 0.0], |[low, high], ratio| [low.min(ratio), high.max(ratio)])
}

fn centre(estimate: &Estimate) -> Option<Centre> {
    let [phi_deg, density_kg_m3] = estimate.region.centroid()?;
    let reach = |centre: f64, [low, high]: [f64; 2]| (high - centre).max(centre - low);
    Some(Centre {
        phi_deg,
        phi_half_width_deg: reach(phi_deg, estimate.phi_deg?),
        density_kg_m3,
        density_half_width_kg_m3: reach(density_kg_m3, estimate.density_kg_m3?),
    })
}

/// What breaks the consistency of the strokes; `None` if they agree, and only tests in direct shear say otherwise.
fn disagreement_of_strokes(setup: &Setup<'_>) -> Result<Option<Disagreement>, AppError> {
    let strokes = Setup { shear_tests: Vec::new(), ..setup.clone() };
    if !setup.shear_tests.is_empty() && estimate(&strokes)?.is_consistent() {
        return Ok(None);
    }
    disagreement(&strokes).map(Some)
}

fn disagreement(setup: &Setup<'_>) -> Result<Disagreement, AppError> {
    let Conflict { culprits, pairs, alone, .. } = conflict(setup)?;
    let label = |i: usize| setup.observations[i].label().to_owned();
    Ok(Disagreement {
        culprits: culprits.into_iter().map(label).collect(),
        pairs: pairs.into_iter().map(|(i, j)| [label(i), label(j)]).collect(),
        alone: alone.into_iter().map(label).collect(),
        uncertainty_factor: agreement_factor(setup)?,
    })
}

/// Strokes to choose from: scatter as in the table, depth error as in the campaign.
fn menu(request: &Request, inputs: &Inputs, setup: &Setup<'_>) -> StrokeMenu {
    let or_of_table = |asked: &[f64], of: fn(&Measurement) -> f64| {
        let mut lengths_m = asked.to_vec();
        if lengths_m.is_empty() {
            lengths_m = inputs.measurements.iter().map(|m| (of(m) * 1e3).round() / 1e3).collect();
            lengths_m.sort_by(f64::total_cmp);
            lengths_m.dedup();
        }
        lengths_m
    };
    let relative = setup.observations.iter().map(|o| 0.5 * (o.high_n() - o.low_n()) / o.force_n());
    StrokeMenu {
        tool_angles_deg: request.next_alpha_deg.clone(),
        depths_m: or_of_table(&request.next_depth_m, |m| m.depth_m),
        widths_m: or_of_table(&request.next_width_m, |m| m.width_m),
        force_scatter: relative.sum::<f64>() / setup.observations.len() as f64,
        // Bands of strokes of one kind have it in them.
        depth_error_m: if inputs.bands.is_some() { 0.0 } else { inputs.campaign.depth_sd_m },
        force_limit_n: request.force_limit_n,
    }
}

fn compare(setup: &Setup<'_>, estimate: &Estimate) -> Result<Vec<Minimum>, AppError> {
    let starts = spread_starts(setup);
    let mut found = Vec::new();
    for optimiser in [Optimiser::DownhillSimplex, Optimiser::LevenbergMarquardt] {
        for minimum in local_minima(setup, optimiser, &starts)? {
            let inside = estimate.region.contains([minimum.end.phi_deg, minimum.end.density_kg_m3]);
            found.push(Minimum::of(&minimum, inside));
        }
    }
    Ok(found)
}
