//! What a statement says, in words: all of it is read from what is proven, nothing from what the file says of itself.

use schemars::JsonSchema;
use serde::Serialize;
use soilctl_certificate::{
    Anisotropy, Bending, Condition, Envelope, Grip, LineUse, Linear, Material, Member, Objective, Region,
    Scale, Statement, StrengthLine,
};

/// Most lines of one kind; of the others their number is told.
const MOST: usize = 40;
/// Most corners of a region that are listed.
const CORNERS: usize = 12;

/// One thing that a statement says.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Said {
    /// What of: `soil`, `gravity`, `surface`, `line`, `member`, `width`, `bounded`, `units`.
    pub of: &'static str,
    /// What it says.
    pub says: String,
}

/// The statement one thing after another: soils and where they are, what acts, what holds, what is bounded, units.
pub(super) fn words(statement: &Statement, scale: &Scale) -> Vec<Said> {
    let mut all = Vec::new();
    let regions = statement.regions.iter().enumerate();
    capped(&mut all, "soil", regions.map(|(i, region)| format!("number {i}, {}", soil(statement, region))));
    let mut say = |of: &'static str, says: String| all.push(Said { of, says });
    say("gravity", format!("{} along (x, y), times the unit weight", point(statement.gravity)));
    say("surface", format!("pressure {}, level at y = {}", statement.surcharge, statement.datum));
    let sides = statement.boundaries.iter().map(|b| {
        let held = held(b.condition, statement.objective);
        format!("{}: {held}", side(statement, b.side()))
    });
    capped(&mut all, "line", sides);
    capped(&mut all, "member", statement.members.iter().map(|m| member(statement, m)));
    let mut say = |of: &'static str, says: String| all.push(Said { of, says });
    say(
        "width",
        match statement.width {
            Some(width) => format!(
                "the structure is {width} wide across the plane, and the soil goes on beyond its ends"
            ),
            None => "plane strain, the same for ever across the plane".to_owned(),
        },
    );
    say("bounded", bounded(statement.objective));
    let of_file = |value: Option<f64>, unit: &str| match value {
        Some(value) => format!("{value} {unit} by the file"),
        None => "of any size".to_owned(),
    };
    say(
        "units",
        format!(
            "a length of 1 is {}, a unit weight of 1 is {}; no proof depends on that",
            of_file(scale.length_m, "m"),
            of_file(scale.unit_weight_n_per_m3, "N/m3")
        ),
    );
    all
}

/// Adds things of one kind, and how many are left out.
fn capped(all: &mut Vec<Said>, of: &'static str, says: impl ExactSizeIterator<Item = String>) {
    let count = says.len();
    all.extend(says.take(MOST).map(|says| Said { of, says }));
    if count > MOST {
        all.push(Said { of, says: format!("and {} more", count - MOST) });
    }
}

/// Nobody needs to see that a zero is negative.
fn plain(x: f64) -> f64 {
    x + 0.0
}

fn point(p: [f64; 2]) -> String {
    let [x, y] = p.map(plain);
    format!("({x}, {y})")
}

/// Where a point is, or that there is none.
fn place(statement: &Statement, index: usize) -> String {
    statement.points.get(index).map_or_else(|| format!("point {index}, which is missing"), |p| point(*p))
}

fn soil(statement: &Statement, region: &Region) -> String {
    let Material { phi_deg, cohesion, unit_weight, pore_pressure, tension, ref envelope, anisotropy } =
        region.material;
    let mut text =
        format!("friction {phi_deg} deg, cohesion {}, unit weight {unit_weight}", linear(cohesion));
    if !pore_pressure.is_zero() {
        text += &format!(", pore pressure {}", linear(pore_pressure));
    }
    if let Some(tension) = tension {
        text += &format!(", no tension above {tension}");
    }
    if let Some(Anisotropy { passive, shear }) = anisotropy {
        text += &format!(
            ", which is the strength under the greatest pressure upright; {passive} of it where that is level, and no shear stress above {shear} of it on \
             level and upright planes"
        );
    }
    if let Some(Envelope { inside, outside }) = envelope {
        let lines = |lines: &[StrengthLine]| {
            let each = |line: &StrengthLine| format!("{} deg and {}", line.phi_deg, line.cohesion);
            lines.iter().map(each).collect::<Vec<_>>().join("; ")
        };
        text += &format!(", and no more than these lines of friction and cohesion bear: {}", lines(inside));
        if !outside.is_empty() {
            text += &format!(" (for the lower bound; for the upper bound only {})", lines(outside));
        }
    }
    let corners: Vec<usize> =
        region.loops.iter().flatten().filter_map(|side| start(statement, *side)).collect();
    if corners.len() <= CORNERS {
        let places: Vec<String> = corners.iter().map(|&corner| place(statement, corner)).collect();
        return format!("{text}; corners {}", places.join(" "));
    }
    let found = || corners.iter().filter_map(|&corner| statement.points.get(corner));
    let span = |axis: usize| {
        let values = || found().map(|p| p[axis]);
        let [low, high] =
            [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)];
        format!("{low} to {high}")
    };
    format!("{text}; {} corners, x {}, y {}", corners.len(), span(0), span(1))
}

/// Where a side of a line starts.
fn start(statement: &Statement, side: LineUse) -> Option<usize> {
    statement.lines.get(side.line).map(|line| line.walked(side.forward)[0])
}

/// From where to where a side goes.
fn side(statement: &Statement, side: LineUse) -> String {
    match statement.lines.get(side.line) {
        Some(line) => {
            let [from, to] = line.walked(side.forward);
            format!("left of {} to {}", place(statement, from), place(statement, to))
        }
        None => format!("line {}, which is missing", side.line),
    }
}

/// From where to where a member goes, and what it bears.
fn member(statement: &Statement, member: &Member) -> String {
    let Member { path, tension, compression, bond, attached, bending, pullout, name: _ } = member;
    let end = |side: Option<&LineUse>, i: usize| {
        let line = side.and_then(|side| Some(statement.lines.get(side.line)?.walked(side.forward)[i]));
        line.map_or_else(|| "a line that is missing".to_owned(), |point| place(statement, point))
    };
    let attached = match attached {
        [false, false] => "attached to nothing",
        [true, false] => "attached at its start",
        [false, true] => "attached at its end",
        [true, true] => "attached at both ends",
    };
    let bending = match bending {
        Some(Bending { moment, shear }) => {
            format!(", a beam: bending moment up to {moment}, shear force up to {shear}")
        }
        None => String::new(),
    };
    let held = match pullout {
        Some(grips) => format!("bars between which the soil goes on, {}", gripped(path, grips)),
        None => format!("faces bear {bond} times the shear strength of the soil beside them"),
    };
    format!(
        "from {} to {}: tension up to {tension}, compression up to {compression}{bending}, {held}, {attached}",
        end(path.first(), 0),
        end(path.last(), 1)
    )
}

/// What bars bear of the soil along the lines of their path, from their start to their end.
fn gripped(path: &[LineUse], grips: &[Grip]) -> String {
    let piece = |(walk, grip): (&LineUse, &Grip)| {
        let Grip { resistance: [mut a, mut b], part: [mut from, mut to] } = *grip;
        if !walk.forward {
            (a, b, from, to) = (b, a, 1.0 - to, 1.0 - from);
        }
        let values = if a == b { a.to_string() } else { format!("{a} to {b}") };
        let part = if [from, to] == [0.0, 1.0] {
            String::new()
        } else {
            format!(" between the fractions {} and {} of it", plain(from), plain(to))
        };
        format!("{values} for each length{part}")
    };
    let mut pieces: Vec<String> = path.iter().zip(grips).map(piece).collect();
    pieces.dedup();
    format!("held by {}", pieces.join(", then "))
}

fn linear(value: Linear) -> String {
    let Linear { at_origin, gradient } = value;
    let [at_origin, x, y] = [at_origin, gradient[0], gradient[1]].map(plain);
    if [x, y] == [0.0; 2] { at_origin.to_string() } else { format!("{at_origin} + {x} x + {y} y") }
}

fn held(condition: Condition, objective: Objective) -> String {
    match condition {
        Condition::Free => "free, with the pressure on the surface".to_owned(),
        Condition::Loaded { pressure: [a, b], shear: [s, t], live }
        | Condition::Lined { pressure: [a, b], shear: [s, t], live } => {
            // Whatever the mark says, only one objective multiplies loads that have it.
            let bounded = live && objective == Objective::Loads;
            let kind = if bounded { "the load that is bounded" } else { "loaded" };
            let [a, b, s, t] = [a, b, s, t].map(plain);
            let lined = matches!(condition, Condition::Lined { .. });
            let kind = if lined { format!("{kind} beyond a beam") } else { kind.to_owned() };
            format!("{kind}: pressure {a} to {b}, shear {s} to {t}")
        }
        Condition::Submerged => {
            "under open water, whose pressure is the pore pressure of the soil".to_owned()
        }
        Condition::Fixed => "fixed".to_owned(),
        Condition::Smooth => "fixed across, smooth along".to_owned(),
        Condition::Far => "the soil goes on beyond".to_owned(),
        Condition::Face { delta_deg, adhesion } => {
            format!("face of the structure, friction {delta_deg} deg, adhesion {adhesion}")
        }
    }
}

fn bounded(objective: Objective) -> String {
    match objective {
        Objective::Structure { velocity } => {
            format!(
                "the force of the structure on the soil, times its velocity {}, per unit width",
                point(velocity)
            )
        }
        Objective::Loads => "the factor on the loads".to_owned(),
        Objective::Body { gravity } => {
            format!("the factor on a body force {} that is added, times the unit weight", point(gravity))
        }
        Objective::Everything => {
            "the factor on all that acts, by which cohesion, adhesion and tension may be divided".to_owned()
        }
    }
}
