//! The use cases of soilctl, each a module with a `Request`, a function `run` and an `Answer`:
//!
//! ```text
//! Request (plain data, defaults, ranges)  ->  run(&request, &watch)  ->  Answer (plain data, JSON schema)
//! ```
//!
//! The command line turns arguments into requests and answers into words; Python binds the same types; figures and pages are
//! drawn from answers by the crate `pages`. Nothing here prints, draws or knows how it was called; what goes on during long work is
//! told to a [`Watch`].
//!
//! In browsers there are those only that need neither recordings nor threads nor drives.

#[cfg(not(target_family = "wasm"))]
pub mod ahead;
mod answer;
#[cfg(not(target_family = "wasm"))]
pub mod arm;
pub mod bound;
pub mod certify;
pub mod convert;
#[cfg(not(target_family = "wasm"))]
pub mod demo;
#[cfg(not(target_family = "wasm"))]
pub mod design;
#[cfg(not(target_family = "wasm"))]
pub mod diagnose;
#[cfg(not(target_family = "wasm"))]
pub mod doctor;
mod error;
pub mod estimate;
#[cfg(not(target_family = "wasm"))]
pub mod excavate;
pub mod files;
mod finite;
#[cfg(not(target_family = "wasm"))]
pub mod heights;
pub mod limits;
#[cfg(not(target_family = "wasm"))]
pub mod log;
mod machine;
pub mod obstacle;
#[cfg(not(target_family = "wasm"))]
pub mod places;
mod plausible;
pub mod predict;
#[cfg(not(target_family = "wasm"))]
pub mod process;
#[cfg(not(target_family = "wasm"))]
pub mod profile;
#[cfg(not(target_family = "wasm"))]
pub mod replay;
#[cfg(not(target_family = "wasm"))]
pub mod report;
pub mod request;
pub mod shear;
#[cfg(not(target_family = "wasm"))]
pub mod simulate;
pub mod soils;
pub mod solve;
pub mod stability;
#[cfg(not(target_family = "wasm"))]
pub mod surface;
pub mod table;
pub mod table_file;
mod table_source;
mod terms;
pub mod text;
pub mod tool;
#[cfg(not(target_family = "wasm"))]
pub mod topics;
#[cfg(not(target_family = "wasm"))]
mod use_cases;
mod watch;

pub use answer::{Answer, Outcome, document, schema};
pub use error::AppError;
pub use finite::check as check_finite;
pub use table_source::TableSource;
#[cfg(not(target_family = "wasm"))]
pub use use_cases::UseCase;
#[cfg(not(target_family = "wasm"))]
use use_cases::use_case;
pub use watch::{Interrupted, Proven, Unwatched, Watch};

/// All use cases, from which schemas, documentation and Python's functions follow.
#[cfg(not(target_family = "wasm"))]
pub const USE_CASES: &[UseCase] = &[
    use_case!("predict", predict, predict::run),
    use_case!("bound", bound, |request, watch| bound::run(request, watch)?.complete()),
    use_case!("tool", tool, |request, watch| tool::run(request, watch)?.complete()),
    use_case!("obstacle", obstacle, |request, watch| obstacle::run(request, watch)?.complete()),
    use_case!("solve", solve, |request, watch| solve::run(request, watch)?.complete()),
    use_case!("solve check", solve::check, |request, watch| {
        Ok(solve::check::run(request, watch)?.answer)
    }),
    use_case!("convert", convert, convert::run),
    use_case!("design", design, design::run),
    use_case!("stability", stability, stability::run),
    use_case!("climb", stability::climb, stability::climb::run),
    use_case!("soils", soils, soils::run),
    use_case!("certify", certify, |request, watch| Ok(certify::run(request, watch)?.answer)),
    use_case!("table show", table::show, table::show::run),
    use_case!("table build", table::build, table::build::run),
    use_case!("table merge", table::merge, table::merge::run),
    use_case!("table check", table::check, table::check::run),
    use_case!("estimate", estimate, |request, watch| Ok(estimate::run(request, watch)?.answer)),
    use_case!("places", places, places::run),
    use_case!("profile", profile, profile::run),
    use_case!("surface", surface, surface::run),
    use_case!("heights", heights, heights::run),
    use_case!("shear", shear, |request, watch| Ok(shear::run(request, watch)?.answer)),
    use_case!("simulate", simulate, simulate::run),
    use_case!("excavate", excavate, excavate::run),
    use_case!("process", process, process::run),
    use_case!("ahead", ahead, ahead::run),
    use_case!("diagnose", diagnose, |request, watch| Ok(diagnose::run(request, watch)?.answer)),
    use_case!("diagnose self-test", diagnose::self_test, diagnose::self_test::run),
    use_case!("diagnose self-test-logs", diagnose::self_test_logs, diagnose::self_test_logs::run),
    use_case!("demo", demo, |request, watch| Ok(demo::run(request, watch)?.answer)),
    use_case!("log info", log::info, log::info::run),
    use_case!("log doctor", log::doctor, log::doctor::run),
    use_case!("log recover", log::recover, log::recover::run),
    use_case!("log export", log::export, log::export::run),
    use_case!("doctor", doctor, doctor::run),
    use_case!("replay", replay, replay::run),
    use_case!("arm skewing", arm::skewing, |request, watch| {
        Ok(arm::skewing::run(request, watch)?.answer)
    }),
    use_case!("arm urdf", arm::urdf, arm::urdf::run),
];
