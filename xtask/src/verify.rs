//! What takes too long for every change: `cargo xtask verify`, whole or in parts.
//!
//! All of it runs in the profile of the tests, where the inner loops are optimised and overflow in our arithmetic is found, with the
//! whole workspace's features: what `cargo xtask test` compiled is not compiled again.

use crate::browser;
use crate::error::XtaskError;
use crate::fuzz;
use crate::run::Step;
use crate::systems;
use crate::tasks::{cargo, find_soilctl, python_tests, setup};
use crate::workspace::Workspace;

/// Cases of each property test; an ordinary test run takes proptest's 256.
const CASES: &str = "20000";

/// The same where a case is a mesh or a problem.
const MESH_CASES: &str = "2000";

/// Random problems with structures of which a comparison counts.
const STRUCTURES: &str = "1000";

/// Random problems whose answers are known.
const KNOWN: &str = "10000";

/// Damaged copies of each recording.
const MUTANTS: &str = "2500";

/// Bags of other arms.
const BAGS: &str = "60";

/// Ignored tests that are not run: what they ask for is not met yet, or they only measure time.
const LEFT_OUT: [&str; 2] = ["exact_strip_at_40_degrees_on_3000_elements", "speed"];

/// A part that can be asked for alone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    Properties,
    Meshes,
    Exact,
    Structures,
    Ends,
    Arm,
    Mutants,
    Bags,
    Diagnosis,
    Soils,
    Chain,
    Published,
    Browser,
    Fuzz,
    Windows,
}

pub(crate) const PARTS: [(Part, &str, &str); 15] = [
    (Part::Properties, "properties", "property tests with 20000 cases each"),
    (Part::Meshes, "meshes", "the same for meshes and problem files, 2000 cases"),
    (
        Part::Exact,
        "exact",
        "known collapse loads on fine meshes, and 10000 random problems whose answers are known",
    ),
    (
        Part::Structures,
        "structures",
        "1000 random problems with structures of every kind and soils of every law: the order of their bounds",
    ),
    (Part::Ends, "ends", "a thousand plates with ends: the order of their bounds, and proofs"),
    (Part::Arm, "arm", "millions of steps, and many killed processes"),
    (
        Part::Mutants,
        "mutants",
        "every byte of a recording, a robot or a drawing may be wrong: 2500 copies of each",
    ),
    (Part::Bags, "bags", "strokes in 60 bags of other arms"),
    (
        Part::Diagnosis,
        "diagnosis",
        "how often a hidden effect is named, and how often another; effects that a controller hides, in logs",
    ),
    (
        Part::Soils,
        "soils",
        "a thousand soils whose friction falls with stress, a thousand for each combination of unknown loads and slope, three hundred slopes that stand, fail, or depend, and blocks that are found in four \
         soils",
    ),
    (Part::Chain, "chain", "from simulated strokes to the soil, against the truth; logs of gigabytes"),
    (
        Part::Published,
        "published",
        "published slopes, cuts and dams beside their values; ten of them drawn on the workbench; all of data/problems",
    ),
    (
        Part::Browser,
        "browser",
        "long tests of pages and estimates in Python; the workbench of a static site: its bits against the program's, size and time",
    ),
    (Part::Fuzz, "fuzz", "the targets of fuzz/ compile"),
    (Part::Windows, "windows", "the task of this name"),
];

impl Part {
    /// The parts of words, all for none.
    ///
    /// # Errors
    ///
    /// A word that is no part.
    pub(crate) fn from_words(words: &[String]) -> Result<Vec<Self>, String> {
        if words.is_empty() {
            return Ok(PARTS.map(|(part, ..)| part).to_vec());
        }
        let part = |word: &String| PARTS.into_iter().find(|(_, name, _)| name == word).map(|(part, ..)| part);
        words.iter().map(|word| part(word).ok_or_else(|| format!("verify has no part {word:?}"))).collect()
    }

    fn run(self, workspace: &Workspace) -> Result<(), XtaskError> {
        match self {
            Self::Properties => properties(workspace),
            Self::Meshes => tests(workspace, "meshes and problem files", &["mesh_random", "describe"])
                .env("PROPTEST_CASES", MESH_CASES)
                .run(),
            Self::Exact => {
                ignored(workspace, "known collapse loads", &["exact", "describe", "plates", "sand"], "exact")
                    .env("KNOWN", KNOWN)
                    .run()
            }
            Self::Structures => tests(workspace, "random ground with structures", &["random_structures"])
                .env("STRUCTURES", STRUCTURES)
                .run(),
            Self::Ends => ignored(workspace, "a thousand plates with ends", &["ends"], "plates").run(),
            Self::Arm => {
                ignored(workspace, "long tests of the arm", &["kill", "log", "no_allocation"], "").run()
            }
            Self::Mutants => tests(
                workspace,
                "files made to do harm",
                &["mutants", "foreign", "monitor_others", "formats"],
            )
            .env("SOILCTL_MUTANTS", MUTANTS)
            .run(),
            Self::Bags => bags(workspace),
            Self::Diagnosis => {
                ignored(workspace, "diagnosis of hidden campaigns", &["rates", "signals"], "").run()
            }
            Self::Soils => ignored(
                workspace,
                "laws of stress, stability, digging, and what is buried",
                &["estimator_law", "estimator_unknowns", "stability", "ahead", "trench"],
                "",
            )
            .run(),
            Self::Chain => ignored(workspace, "the whole chain", &["memory", "chain", "coverage"], "").run(),
            Self::Published => published(workspace),
            Self::Browser => browser(workspace),
            Self::Fuzz => fuzz::check(workspace),
            Self::Windows => systems::windows(workspace),
        }
    }
}

/// Runs the parts up to the first that fails, and says what each took.
pub(crate) fn run(workspace: &Workspace, parts: &[Part]) -> Result<(), XtaskError> {
    for part in parts {
        let start = std::time::Instant::now();
        part.run(workspace)?;
        eprintln!("== {part:?}: {} s", start.elapsed().as_secs());
    }
    Ok(())
}

/// The library and these test programs of every crate that has them.
fn tests(workspace: &Workspace, name: &str, programs: &[&str]) -> Step {
    let programs = programs.iter().flat_map(|program| ["--test", program]);
    cargo(workspace, name).args(["test", "--workspace", "--locked", "--no-fail-fast"]).args(programs)
}

/// The tests that are ignored elsewhere, those with `filter` in their name.
fn ignored(workspace: &Workspace, name: &str, programs: &[&str], filter: &str) -> Step {
    let left_out = LEFT_OUT.iter().flat_map(|name| ["--skip", name]);
    let step =
        tests(workspace, name, programs).args(["--lib", "--", "--ignored", "--nocapture"]).args(left_out);
    if filter.is_empty() { step } else { step.args([filter]) }
}

fn properties(workspace: &Workspace) -> Result<(), XtaskError> {
    const PROGRAMS: [&str; 10] = [
        "ends",
        "estimator_properties",
        "plate_bounds",
        "fits",
        "input",
        "strokes",
        "limits",
        "properties",
        "settling",
        "forward_inverse",
    ];
    tests(workspace, "property tests", &PROGRAMS)
        .args(["--lib"])
        .env("PROPTEST_CASES", CASES)
        // Some tests draw again what does not suit them.
        .env("PROPTEST_MAX_GLOBAL_REJECTS", CASES)
        .env("PROPTEST_MAX_LOCAL_REJECTS", "10000000")
        .run()
}

fn browser(workspace: &Workspace) -> Result<(), XtaskError> {
    setup(workspace)?;
    python_tests(workspace, "long Python tests", &find_soilctl(workspace)?).args(["-m", "long"]).run()?;
    let folder = workspace.target().join("workbench");
    browser::make(workspace, &folder)?;
    // What is compared for speed is optimised on both sides.
    cargo(workspace, "the program to compare with")
        .args(["build", "--locked", "--release", "--workspace", "--bin", "soilctl"])
        .run()?;
    Step::new("the workbench of a static site", workspace.venv_python())
        .args(["-m", "pytest", "tests/python/browser"])
        .dir(workspace.root())
        .env(
            "SOILCTL",
            workspace.target().join("release").join(format!("soilctl{}", std::env::consts::EXE_SUFFIX)),
        )
        .env("SOILCTL_WORKBENCH", folder)
        .run()
}

fn published(workspace: &Workspace) -> Result<(), XtaskError> {
    setup(workspace)?;
    Step::new("published problems", workspace.venv_python())
        .args(["-m", "pytest", "tests/python/test_published.py", "tests/python/test_problems.py"])
        .dir(workspace.root())
        .env("SOILCTL", find_soilctl(workspace)?)
        .env("SOILCTL_PUBLISHED", "all")
        .run()
}

fn bags(workspace: &Workspace) -> Result<(), XtaskError> {
    setup(workspace)?;
    Step::new("strokes in bags of other arms", workspace.venv_python())
        .args(["-m".into(), "foreign.score".into(), find_soilctl(workspace)?.into_os_string(), BAGS.into()])
        .dir(&workspace.root().join("tests/python"))
        .run()
}

#[cfg(test)]
mod checks {
    use super::*;

    #[test]
    fn no_word_means_all_and_a_wrong_one_is_named() {
        assert_eq!(Part::from_words(&[]).unwrap().len(), PARTS.len());
        assert_eq!(Part::from_words(&["arm".into(), "bags".into()]).unwrap(), [Part::Arm, Part::Bags]);
        assert!(Part::from_words(&["leg".into()]).unwrap_err().contains("\"leg\""));
    }
}
