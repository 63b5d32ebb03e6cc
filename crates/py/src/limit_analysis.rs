//! Proven bounds: plates and described problems.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::Ordering;

use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyMapping};
use soilctl_app::bound::{EndBudget, EndField, find_end, ratio_of_ends};
use soilctl_certificate::{LowerField, SCHEMA, Scale, Solution as Saved, Statement, UpperField};
use soilctl_earth_pressure::{Blocks, Case, LoadFactors};
use soilctl_limit_analysis::describe::{Aim, Quantity};
use soilctl_limit_analysis::results::problem_units;
use soilctl_limit_analysis::{
    Bound as Proven, Bounds, Description, DescriptionError, EmbeddedPlate, Factorisation, LimitError,
    Options, Problem, SafetyBounds, bound_section, factor_of_safety,
};
use soilctl_soil::{Angle, Interface, Plate, Soil};

use crate::array::{whole, whole_or_none};
use crate::bracket::{Bracket, Progress, Proofs};
use crate::earth_pressure::{beyond, ends_named};
use crate::error::{Answer, Fail, file_at, input, kinds, no_answer};
use crate::interruptible::run_interruptible;

/// Stands in for a size that was not given, so that the others are checked all the same.
const ANY: f64 = 1.0;

/// What may be spent, as it was given.
struct Budget<'a> {
    max_gap: f64,
    max_elements: usize,
    max_work: Option<u64>,
    max_seconds: Option<f64>,
    max_memory_mb: Option<u64>,
    threads: usize,
    factorisation: &'a str,
}

/// The same, checked.
fn options(budget: &Budget<'_>) -> Answer<Options> {
    let &Budget { max_gap, max_elements, max_seconds, max_memory_mb, threads, .. } = budget;
    for (name, value) in [("max_gap", Some(max_gap)), ("max_seconds", max_seconds)] {
        if let Some(value) = value
            && !(value > 0.0 && value.is_finite())
        {
            return Err(input(format!("{name} is {value}; it must be a finite number above 0")));
        }
    }
    if !(1000..=1_000_000).contains(&max_elements) {
        return Err(input(format!("max_elements is {max_elements}; it must be from 1000 to 1000000")));
    }
    if !(1..=1024).contains(&threads) {
        return Err(input(format!("threads is {threads}; it must be from 1 to 1024")));
    }
    let max_memory_bytes = match max_memory_mb {
        None => u64::MAX,
        Some(mb) if mb >= 100 => mb.saturating_mul(1_000_000),
        Some(mb) => return Err(input(format!("max_memory_mb is {mb}; it must be at least 100"))),
    };
    let max_work = match budget.max_work {
        None => Options::MAX_WORK,
        Some(0) => return Err(input("max_work is 0; it must be at least 1")),
        Some(steps) => steps,
    };
    let factorisation =
        match budget.factorisation {
            "auto" => None,
            name => Some(Factorisation::ALL.into_iter().find(|one| one.name() == name).ok_or_else(|| {
                input(format!("factorisation is {name:?}; it must be auto, qdldl or faer"))
            })?),
        };
    Ok(Options {
        max_gap,
        max_elements,
        max_work,
        max_seconds,
        max_memory_bytes,
        threads,
        factorisation,
        ..Options::default()
    })
}

/// Runs the solver; `bracket` makes the answer, also of what there is when the user ends the run.
fn run<B: Send>(
    py: Python<'_>,
    options: Options,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Options, &dyn Fn(Progress)) -> Result<B, LimitError> + Send,
    bracket: impl Fn(&B) -> Bracket,
) -> Answer<Bracket> {
    let stop = Arc::clone(&options.stop);
    let bar = match progress {
        Some(wanted) if wanted.is_instance_of::<PyBool>() && wanted.is_truthy()? => {
            Some(py.import("soilctl._progress")?.getattr("Levels")?.call0()?)
        }
        _ => None,
    };
    let progress = bar.as_ref().or(progress.filter(|given| !given.is_instance_of::<PyBool>()));
    if let Some(given) = progress.filter(|given| !given.is_callable()) {
        let message = format!(
            "progress is of type {}; it must be callable, or True for a bar of tqdm",
            given.get_type().name()?
        );
        return Err(Fail(kinds::InputTypeError::new_err(message)));
    }
    let ended = run_interruptible(
        py,
        |report: &dyn Fn(Progress)| work(&options, report),
        || stop.store(true, Ordering::Relaxed),
        |level| match progress {
            Some(progress) => progress.call1((level,)).map(|_| ()),
            None => Ok(()),
        },
        || Ok(()),
    );
    if let Some(bar) = &bar {
        bar.call_method0("close")?;
    }
    let ended = ended?;
    match ended.raised {
        None => Ok(bracket(&ended.answer?)),
        Some(raised) if raised.is_instance_of::<PyKeyboardInterrupt>(py) => {
            let best = ended.answer.ok().map(|found| bracket(&found));
            Err(Fail(kinds::Interrupted::new_err(("interrupted; the best bounds so far are in .best", best))))
        }
        Some(raised) => Err(Fail(raised)),
    }
}

/// The same for a problem that both bounds are of.
fn run_both(
    py: Python<'_>,
    problem: &Problem,
    options: Options,
    progress: Option<&Bound<'_, PyAny>>,
    bracket: impl Fn(&Bounds) -> Bracket,
) -> Answer<Bracket> {
    let work = |options: &Options, report: &dyn Fn(Progress)| both(problem, options, report);
    run(py, options, progress, work, bracket)
}

/// Both bounds of a problem, each level of which is reported.
fn both(problem: &Problem, options: &Options, report: &dyn Fn(Progress)) -> Result<Bounds, LimitError> {
    bound_section(problem, options, &mut |level, gap| {
        report(Progress { elements: level.upper.elements, gap, factor: None });
    })
}

fn saved(
    statement: &Statement,
    scale: Scale,
    lower: Option<&Proven<LowerField>>,
    upper: Option<&Proven<UpperField>>,
) -> Saved {
    Saved {
        schema: SCHEMA.to_owned(),
        program: format!("soilctl {}", env!("CARGO_PKG_VERSION")),
        statement: statement.clone(),
        scale,
        lower: lower.map(Proven::claim),
        upper: upper.map(Proven::claim),
        mechanism: None,
        space: None,
    }
}

/// Proven bounds on the net force coefficient of an embedded plate, per slant length: ``K = 2 F / (gamma L^2 w)``.
///
/// Args:
///     tool_angle_deg: Plate from the horizontal, 10 to 170.
///     friction_angle_deg: Internal friction of the soil, above 0 and below 70.
///     interface_friction_deg: Friction between soil and plate, at most that of the soil.
///     surface_slope_deg: Slope of the ground, positive when it rises ahead of the plate.
///     density_kg_m3: Bulk density; for forces, and with cohesion, adhesion or surcharge.
///     depth_m: Vertical depth of the plate's lower edge; likewise.
///     width_m: Width of the plate; for forces, and with it and a depth the plate has ends.
///     width_ratio: Width over vertical depth, where neither is given in metres.
///     ends: ``finite`` for a plate with ends, whose force is above that of plane strain, ``none`` for plane strain. By default
///         a plate with a width has ends.
///     cohesion_pa: Cohesion of the soil.
///     adhesion_pa: Adhesion between soil and plate.
///     surcharge_pa: Vertical pressure on the surface.
///     gravity_m_s2: Gravity; by default the standard one.
///     tetrahedra: About how many tetrahedra the stress field about an end of an upright plate on level ground has, which bounds from
///         below what ends add to the force of soil with weight alone: more take longer and narrow the bracket; 0 for none.
///     max_gap: Gap at which to stop.
///     max_elements: Most elements of a mesh.
///     max_work: Work that may be spent: elements of each mesh times steps of the solver on it, the same on every
///         machine; by default three million.
///     max_seconds: Time that may be spent, if it is to be limited: where the run ends then depends on the machine, and
///         ``stopped_by`` says ``seconds``.
///     max_memory_mb: Memory that may be used: a mesh whose programs may need more is not made.
///     threads: The bounds are the same for any number.
///     factorisation: What factorises the systems of the solver's steps: ``qdldl``, ``faer``, or ``auto`` for the choice by the
///         size of each program. The last digits depend on it.
///     progress: Called after each level with an object that has ``elements`` and ``gap``; if it raises, the run
///         ends. Or True for a bar of tqdm.
///
/// Raises:
///     InputError: If a number is out of its range.
///     NoAnswerError: If no pair of bounds was proven within the budget.
///     Interrupted: At Ctrl-C; the best bounds so far are in its ``best``.
#[pyfunction]
#[pyo3(signature = (
    *, tool_angle_deg, friction_angle_deg, interface_friction_deg, surface_slope_deg = 0.0, density_kg_m3 = None,
    depth_m = None, width_m = None, cohesion_pa = 0.0, adhesion_pa = 0.0, surcharge_pa = 0.0,
    gravity_m_s2 = 9.80665, width_ratio = None, ends = None, tetrahedra = 400, max_gap = 0.01,
    max_elements = 20000, max_work = None, max_seconds = None, max_memory_mb = None, threads = 1,
    factorisation = "auto", progress = None,
))]
#[allow(clippy::too_many_arguments, reason = "keywords of a Python function")]
pub(crate) fn bound(
    py: Python<'_>,
    tool_angle_deg: f64,
    friction_angle_deg: f64,
    interface_friction_deg: f64,
    surface_slope_deg: f64,
    density_kg_m3: Option<f64>,
    depth_m: Option<f64>,
    width_m: Option<f64>,
    cohesion_pa: f64,
    adhesion_pa: f64,
    surcharge_pa: f64,
    gravity_m_s2: f64,
    width_ratio: Option<f64>,
    ends: Option<&str>,
    #[pyo3(from_py_with = whole)] tetrahedra: usize,
    max_gap: f64,
    #[pyo3(from_py_with = whole)] max_elements: usize,
    #[pyo3(from_py_with = whole_or_none)] max_work: Option<u64>,
    max_seconds: Option<f64>,
    #[pyo3(from_py_with = whole_or_none)] max_memory_mb: Option<u64>,
    #[pyo3(from_py_with = whole)] threads: usize,
    factorisation: &str,
    progress: Option<&Bound<'_, PyAny>>,
) -> Answer<Bracket> {
    let degrees = Angle::from_degrees;
    let (depth, width, density) =
        (depth_m.unwrap_or(ANY), width_m.unwrap_or(ANY), density_kg_m3.unwrap_or(ANY));
    let plate = Plate::new(degrees(tool_angle_deg), degrees(surface_slope_deg), depth, width)?;
    let soil = Soil::new(degrees(friction_angle_deg), density)?
        .with_cohesion(cohesion_pa)?
        .with_gravity(gravity_m_s2)?;
    Interface::new(degrees(interface_friction_deg), adhesion_pa)?;
    let (length_m, weight) = (plate.slant_length_m(), soil.unit_weight_n_m3());
    let known = depth_m.is_some() && density_kg_m3.is_some();
    for scale in [length_m * weight, plate.weight_scale_n(&soil)] {
        if !(scale.is_finite() && scale > 0.0) {
            return Err(beyond("", scale));
        }
    }
    let stress = |name: &str, stress_pa: f64| match known || stress_pa == 0.0 {
        true => Ok(stress_pa / (length_m * weight)),
        false => Err(input(format!(
            "{name} is {stress_pa} Pa, but how much that is depends on depth and density; give depth_m and density_kg_m3 too"
        ))),
    };
    let embedded = EmbeddedPlate {
        alpha_deg: tool_angle_deg,
        beta_deg: surface_slope_deg,
        phi_deg: friction_angle_deg,
        delta_deg: interface_friction_deg,
        cohesion: stress("cohesion_pa", cohesion_pa)?,
        adhesion: stress("adhesion_pa", adhesion_pa)?,
        surcharge: stress("surcharge_pa", surcharge_pa)?,
    };
    let mut problem = embedded.problem()?;
    let ends = ends.map(ends_named).transpose()?;
    let ratio = ratio_of_ends(ends, width_ratio, width_m, depth_m).map_err(input)?;
    let mechanism = match ratio {
        Some(ratio) => {
            problem = embedded.problem_with_ends(ratio * degrees(tool_angle_deg).sin())?;
            let EmbeddedPlate { surcharge, cohesion, adhesion, .. } = embedded;
            let loads = LoadFactors { weight: 0.5, surcharge, cohesion, adhesion };
            let case =
                Case::from_deg(tool_angle_deg, surface_slope_deg, friction_angle_deg, interface_friction_deg);
            Some(py.detach(|| Blocks.proven(&case, problem.statement(), loads))?)
        }
        None => None,
    };
    let newtons = (known && width_m.is_some()).then(|| plate.weight_scale_n(&soil));
    let scale = Scale {
        length_m: known.then_some(length_m),
        unit_weight_n_per_m3: known.then_some(weight),
        description: Some(format!(
            "embedded plate: alpha {tool_angle_deg} deg, beta {surface_slope_deg} deg, phi {friction_angle_deg} deg, \
             delta {interface_friction_deg} deg; the coefficient per slant length is the bound times 2 / sin(alpha + delta)"
        )),
    };
    // From a force along the surface to one inclined at delta to the plate's normal.
    let factor = 2.0 / degrees(tool_angle_deg + interface_friction_deg).sin();
    let options = options(&Budget {
        max_gap,
        max_elements,
        max_work,
        max_seconds,
        max_memory_mb,
        threads,
        factorisation,
    })?;
    let work = |options: &Options, report: &dyn Fn(Progress)| {
        let bounds = both(&problem, options, report)?;
        let end = ratio.map(|ratio| {
            let budget = EndBudget {
                tetrahedra,
                seconds: options.max_seconds.map(|all| all - bounds.seconds),
                memory: options.max_memory_bytes,
                stop: Arc::clone(&options.stop),
            };
            find_end(&embedded, ratio * degrees(tool_angle_deg).sin(), &budget, &mut |_| {})
        });
        // Why there is none, the command line says.
        Ok((bounds, end.and_then(Result::ok)))
    };
    run(py, options, progress, work, |(bounds, end): &(Bounds, Option<EndField>)| {
        // The factor and the product are each good to a rounding or two; rounding is outwards.
        let slack = 4.0 * f64::EPSILON;
        let held = mechanism.as_ref().map_or(bounds.upper.value, |claim| claim.claimed);
        let borne = end.as_ref().map_or(bounds.lower.value, |end| end.claim.claimed.max(bounds.lower.value));
        let (lower, upper) = (factor * borne, factor * held);
        let (lower, upper) = (lower - slack * lower.abs(), upper + slack * upper.abs());
        // A flow in the plane proves nothing where there are ends.
        let flow = mechanism.is_none().then_some(&bounds.upper);
        let mut solution = saved(problem.statement(), scale.clone(), Some(&bounds.lower), flow);
        solution.mechanism.clone_from(&mechanism);
        solution.space = end.as_ref().map(|end| end.claim.clone());
        bracket(
            bounds,
            [lower, upper],
            ("net coefficient per slant length", ""),
            newtons,
            Arc::new(solution),
            [0.0; 2],
        )
    })
}

/// Proven bounds for a plane-strain collapse problem that is described in a file or a dict.
///
/// What is bounded is what the description's objective asks for: a force, a factor on loads or weights, an acceleration,
/// or a factor of safety (see ``Bracket.quantity``). Descriptions with cases or sweeps are for ``soilctl.use_cases.solve``.
///
/// Args:
///     problem: Path of a problem file (.toml or .json), or the description as a dict or another mapping, whose numbers may be
///         numpy's.
///     max_gap, max_elements, max_work, max_seconds, max_memory_mb, threads, factorisation, progress: As for ``bound``.
///
/// Raises:
///     InputError: If the description makes no sense.
///     FileError: If the file cannot be read.
///     NoAnswerError: If there is no collapse load, or no pair of bounds was proven within the budget.
///     Interrupted: At Ctrl-C; the best bounds so far are in its ``best``.
#[pyfunction]
#[pyo3(signature = (
    problem, *, max_gap = 0.01, max_elements = 20000, max_work = None, max_seconds = None, max_memory_mb = None,
    threads = 1, factorisation = "auto", progress = None,
))]
#[allow(clippy::too_many_arguments, reason = "keywords of a Python function")]
pub(crate) fn solve(
    py: Python<'_>,
    problem: &Bound<'_, PyAny>,
    max_gap: f64,
    #[pyo3(from_py_with = whole)] max_elements: usize,
    #[pyo3(from_py_with = whole_or_none)] max_work: Option<u64>,
    max_seconds: Option<f64>,
    #[pyo3(from_py_with = whole_or_none)] max_memory_mb: Option<u64>,
    #[pyo3(from_py_with = whole)] threads: usize,
    factorisation: &str,
    progress: Option<&Bound<'_, PyAny>>,
) -> Answer<Bracket> {
    let description = match problem.cast::<PyMapping>() {
        Ok(given) => {
            let text: String = py.import("soilctl._plain")?.call_method1("dumps", (given,))?.extract()?;
            Description::from_json(&text)
        }
        Err(_) => Description::read(&problem.extract::<PathBuf>()?),
    };
    let description = description.map_err(LimitError::from)?;
    if !(description.cases.is_empty() && description.sweeps.is_empty()) {
        return Err(input(
            "the problem has cases or sweeps, which soilctl.use_cases.solve bounds, from a file; this function bounds one problem",
        ));
    }
    let options = options(&Budget {
        max_gap,
        max_elements,
        max_work,
        max_seconds,
        max_memory_mb,
        threads,
        factorisation,
    })?;
    if description.objective == (Aim::StrengthReduction {}) {
        let work = |options: &Options, report: &dyn Fn(Progress)| {
            factor_of_safety(&description, options, &mut |factor, level, gap| {
                report(Progress { elements: level.upper.elements, gap, factor: Some(factor) });
            })
        };
        return run(py, options, progress, work, |found| safety_bracket(&description, found));
    }
    let described = description.described()?;
    let problem = described.problem()?;
    let name = match described.quantity {
        Quantity::ForceKnPerM => ("force of the structure", "kN/m"),
        Quantity::LoadFactor => ("factor on the live loads", ""),
        Quantity::WeightFactor => ("factor on the unit weights", ""),
        Quantity::Acceleration => ("acceleration over gravity", ""),
    };
    let origin_m = problem_units(&description, &described).origin;
    run_both(py, &problem, options, progress, |bounds| {
        let ends = described.in_units([bounds.lower.value, bounds.upper.value]);
        let solution =
            saved(problem.statement(), described.scale(), Some(&bounds.lower), Some(&bounds.upper));
        bracket(bounds, ends, name, None, Arc::new(solution), origin_m)
    })
}

/// A bracket from bounds in its own units.
fn bracket(
    bounds: &Bounds,
    [lower, upper]: [f64; 2],
    (quantity, unit): (&'static str, &'static str),
    newtons: Option<f64>,
    solution: Arc<Saved>,
    origin_m: [f64; 2],
) -> Bracket {
    Bracket {
        lower,
        upper,
        quantity: quantity.into(),
        unit: unit.into(),
        ended: bounds.ended,
        work: bounds.work,
        seconds: bounds.seconds,
        force_n: newtons.map(|n| (n * lower, n * upper)),
        elements: (bounds.lower.elements, bounds.upper.elements),
        proofs: Proofs::Both(solution),
        origin_m,
    }
}

fn safety_bracket(description: &Description, found: &SafetyBounds) -> Bracket {
    let (lower, upper) = (&found.lower, &found.upper);
    let of_lower = |proof: &soilctl_limit_analysis::SafetyProof<LowerField>| {
        saved(&proof.described.statement, proof.described.scale(), Some(&proof.bound), None)
    };
    let of_upper = saved(&upper.described.statement, upper.described.scale(), None, Some(&upper.bound));
    let proofs = vec![("lower".into(), Arc::new(of_lower(lower))), ("upper".into(), Arc::new(of_upper))];
    Bracket {
        lower: lower.factor,
        upper: upper.factor,
        quantity: "factor of safety".into(),
        unit: String::new(),
        ended: found.ended,
        work: found.work,
        seconds: found.seconds,
        force_n: None,
        elements: (lower.bound.elements, upper.bound.elements),
        proofs: Proofs::Several(proofs),
        origin_m: problem_units(description, &upper.described).origin,
    }
}

impl From<LimitError> for Fail {
    fn from(problem: LimitError) -> Self {
        match problem {
            LimitError::Certificate(problem) => problem.into(),
            LimitError::NoCollapse { .. } | LimitError::NothingProven { .. } => no_answer(problem),
            LimitError::Description(DescriptionError::File { ref path, .. }) => file_at(&problem, path),
            _ => input(problem),
        }
    }
}
