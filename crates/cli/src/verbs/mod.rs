//! The verbs, one file each. A new verb is a module, a line in [`Verb`] and a line in [`Verb::run`]; what it does is a use
//! case of `soilctl_app`, in whose list it stands.

mod ahead;
mod arm;
mod bound;
mod certify;
mod climb;
mod completions;
mod console;
mod convert;
mod demo;
mod design;
mod diagnose;
mod dig;
mod doctor;
mod estimate;
mod excavate;
mod heights;
mod limits;
mod log;
mod man;
mod monitor;
mod obstacle;
mod pages;
mod places;
mod predict;
mod process;
mod profile;
mod replay;
mod report;
mod run;
mod schemas;
mod serve;
mod shear;
mod simulate;
mod soils;
mod solve;
mod stability;
mod surface;
mod table;
mod tool;
mod view;
mod workbench;

use clap::Subcommand;
use soilctl_app::Outcome;

use crate::error::CliError;
use crate::output::Output;

/// What there is to do.
#[derive(Debug, Subcommand)]
pub(crate) enum Verb {
    /// Force and coefficients of a plate from a named model
    Predict(predict::Args),
    /// Proven lower and upper bounds on a plate's force, by limit analysis
    Bound(bound::Args),
    /// Proven bounds on the force of a curved blade, a bucket, or any other tool in section
    Tool(tool::Args),
    /// From what distance on the force of a tool says that something is buried ahead
    Obstacle(obstacle::Args),
    /// Proven bounds for any plane-strain collapse problem described in a file
    Solve(solve::Args),
    /// The least of something that is enough, by proven bounds: a strength, a length, a slope, a water level
    Design(design::Args),
    /// Tells whether a slope, footing or wall stands for every soil that explains the strokes, or that was published
    Stability(stability::Args),
    /// Tells which slopes a wheel climbs on every soil that explains the strokes, or that was published
    Climb(climb::Args),
    /// Soils of the Moon and Mars with strength and density as published
    Soils(soils::Args),
    /// Makes a problem file of a drawing (DXF, GeoJSON, CSV), or a drawing of a problem file
    Convert(convert::Args),
    /// Draws, checks, solves and saves problem files on a page in the browser
    Workbench(workbench::Args),
    /// Proves the bounds of a saved solution anew
    Certify(certify::Args),
    /// Every soil that could have produced the measured forces
    Estimate(Box<estimate::Args>),
    /// Whether the soil is the same at several places, what it is at each, and what lies between
    Places(places::Args),
    /// Whether the ground changes with depth: one soil, a gradient or a step, by strokes at several depths
    Profile(profile::Args),
    /// What the crack ahead of the plate says of the soil, beside what the force says
    Surface(surface::Args),
    /// What height maps before and after a stroke say: where the ground broke, heap and furrow
    Heights(heights::Args),
    /// Where model and measurement disagree, which effect is missing, and the gap after it is added
    Diagnose(diagnose::Args),
    /// One HTML page: the estimate with its figures and what they mean
    Report(Box<report::Args>),
    /// Friction angle against normal stress from direct-shear tests
    Shear(Box<shear::Args>),
    /// Runs a campaign on the simulated arm and soil, a log for each batch
    Simulate(simulate::Args),
    /// A trench dug in passes at least cost to the motors: which forces fail the soil, at which tool angle, how deep a pass may be
    Excavate(Box<excavate::Args>),
    /// A simulated campaign from the soil to the estimate, compared with the truth, on one page
    Demo(demo::Args),
    /// Shows, builds and checks prediction tables
    Table(table::Args),
    /// Looks into, checks, repairs and exports logs
    Log(log::Args),
    /// Failure forces of the strokes in logs, and what they say together
    Process(Box<process::Args>),
    /// Whether something is buried ahead of strokes: where their force rises beyond what the soil explains
    Ahead(Box<ahead::Args>),
    /// Runs the controller again on a log's inputs and compares every output bit
    Replay(replay::Args),
    /// Hosts a live session: the 500 Hz controller on the simulated arm or on a driver of one's own
    Run(run::Args),
    /// Operates a live session, or plays a log
    Console(console::Args),
    /// Shows a live session or a log in 3-D, on a page in the browser
    Monitor(monitor::Args),
    /// Lets the plate of a simulated session be dragged through soil, on a page in the browser
    Dig(dig::Args),
    /// Shows a log in the Rerun viewer: arm, forces, curves, states and events in a layout
    View(view::Args),
    /// What an arm and its controller are like: skewing of the plate's force, the arm as a URDF
    Arm(arm::Args),
    /// Tells what is there: browser, viewer, Python package, real-time rights
    Doctor(doctor::Args),
    /// Prints a completion script for a shell
    Completions(completions::Args),
    /// Writes the man pages
    Man(man::Args),
    /// Writes the JSON schemas of all requests and answers
    Schemas(schemas::Args),
}

impl Verb {
    /// Whether it answers once, in JSON, and ends by itself, so that another program may wait for it.
    pub(crate) const fn is_one_answer(&self) -> bool {
        !matches!(
            self,
            Self::Run(_) | Self::Console(_) | Self::Dig(_) | Self::Workbench(_) | Self::Completions(_)
        )
    }

    /// Carries it out. `whole` is the command line that it is a verb of.
    pub(crate) fn run(self, whole: fn() -> clap::Command, output: &mut Output) -> Result<Outcome, CliError> {
        match self {
            Self::Predict(args) => predict::run(&args, output),
            Self::Bound(args) => bound::run(&args, output),
            Self::Tool(args) => tool::run(&args, output),
            Self::Obstacle(args) => obstacle::run(&args, output),
            Self::Solve(args) => solve::run(&args, output),
            Self::Design(args) => design::run(&args, output),
            Self::Stability(args) => stability::run(&args, output),
            Self::Climb(args) => climb::run(&args, output),
            Self::Soils(args) => soils::run(&args, output),
            Self::Convert(args) => convert::run(&args, output),
            Self::Workbench(args) => workbench::run(&args, output),
            Self::Certify(args) => certify::run(&args, output),
            Self::Estimate(args) => estimate::run(&args, output),
            Self::Places(args) => places::run(&args, output),
            Self::Profile(args) => profile::run(&args, output),
            Self::Surface(args) => surface::run(&args, output),
            Self::Heights(args) => heights::run(&args, output),
            Self::Diagnose(args) => diagnose::run(&args, output),
            Self::Report(args) => report::run(&args, output),
            Self::Shear(args) => shear::run(&args, output),
            Self::Simulate(args) => simulate::run(&args, output),
            Self::Excavate(args) => excavate::run(&args, output),
            Self::Demo(args) => demo::run(&args, output),
            Self::Table(args) => table::run(&args, output),
            Self::Log(args) => log::run(&args, output),
            Self::Process(args) => process::run(&args, output),
            Self::Ahead(args) => ahead::run(&args, output),
            Self::Replay(args) => replay::run(&args, output),
            Self::Run(args) => run::run(&args, output),
            Self::Console(args) => console::run(&args, output),
            Self::Monitor(args) => monitor::run(&args, output),
            Self::Dig(args) => dig::run(&args, output),
            Self::View(args) => view::run(&args, output),
            Self::Arm(args) => arm::run(&args, output),
            Self::Doctor(args) => doctor::run(&args, output),
            Self::Completions(args) => completions::run(&args, whole(), output),
            Self::Man(args) => man::run(&args, whole()),
            Self::Schemas(args) => schemas::run(&args),
        }
    }
}
