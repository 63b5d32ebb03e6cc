//! What ends a run, and that only the user's clock lets the machine have a say in it.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use soilctl_certificate::{prove_lower, prove_upper};
use soilctl_limit_analysis::{
    Bounds, Description, EmbeddedPlate, Ended, Factorisation, LimitError, Options, StoppedBy, bound,
    factor_of_safety,
};

const PLATE: EmbeddedPlate = EmbeddedPlate {
    alpha_deg: 90.0,
    beta_deg: 0.0,
    phi_deg: 35.0,
    delta_deg: 10.0,
    cohesion: 0.0,
    adhesion: 0.0,
    surcharge: 0.0,
};

fn solve(options: &Options) -> Bounds {
    bound(&PLATE.problem().unwrap(), options, &mut |_, _| {}).unwrap()
}

/// No gap to stop at.
fn open() -> Options {
    Options { max_gap: 0.0, ..Options::default() }
}

/// All but the seconds.
fn assert_same(one: &Bounds, other: &Bounds) {
    assert_eq!((one.ended, one.work), (other.ended, other.work));
    assert_eq!(one.lower.value.to_bits(), other.lower.value.to_bits());
    assert_eq!(one.upper.value.to_bits(), other.upper.value.to_bits());
    assert_eq!(one.lower.field, other.lower.field);
    assert_eq!(one.upper.field, other.upper.field);
}

#[test]
fn work_ends_a_run_at_the_same_place_every_time_and_on_any_number_of_threads() {
    let at = |threads, max_work| solve(&Options { threads, max_work, ..open() });
    let one = at(1, 150_000);
    assert_eq!((one.ended, one.ended.stopped_by()), (Ended::Work, StoppedBy::Work));
    for threads in [1, 2, 4] {
        assert_same(&one, &at(threads, 150_000));
    }
    // Levels that are begun are finished, so a little more may be spent than was allowed.
    assert!((75_000..=300_000).contains(&one.work), "{}", one.work);
    let less = at(1, 60_000);
    assert!(less.ended == Ended::Work && less.work < one.work && less.gap() > one.gap());
}

#[test]
fn a_memory_limit_allows_the_same_meshes_on_any_number_of_threads() {
    let at = |threads| solve(&Options { threads, max_memory_bytes: 150_000_000, ..open() });
    let one = at(1);
    assert_eq!((one.ended, one.ended.stopped_by()), (Ended::Memory, StoppedBy::Memory));
    assert_same(&one, &at(2));
}

#[test]
fn a_clock_that_ends_a_run_is_told_and_one_that_does_not_changes_nothing() {
    let mut seconds = 0.5;
    let ended = loop {
        let problem = PLATE.problem().unwrap();
        let options = Options { max_seconds: Some(seconds), max_work: u64::MAX, ..open() };
        match bound(&problem, &options, &mut |_, _| {}) {
            Ok(bounds) => break bounds.ended,
            // On this machine more time is needed for the first bounds.
            Err(LimitError::NothingProven { .. }) => seconds *= 2.0,
            Err(other) => panic!("{other}"),
        }
    };
    assert_eq!((ended, ended.stopped_by()), (Ended::Time, StoppedBy::Seconds));
    let goal = Options { max_gap: 0.1, ..Options::default() };
    let timed = solve(&Options { max_seconds: Some(1e9), ..goal.clone() });
    assert_eq!((timed.ended, timed.ended.stopped_by()), (Ended::Gap, StoppedBy::Goal));
    assert_same(&timed, &solve(&goal));
}

#[test]
fn both_factorisations_prove_bounds_and_say_who_they_are() {
    let at = |factorisation, threads| {
        solve(&Options { factorisation, threads, max_gap: 0.1, ..Options::default() })
    };
    let statement = PLATE.problem().unwrap().statement().clone();
    let [qdldl, faer] = Factorisation::ALL.map(|one| {
        let bounds = at(Some(one), 1);
        assert_same(&bounds, &at(Some(one), 2));
        assert_eq!(prove_lower(&statement, &bounds.lower.field).unwrap(), bounds.lower.value);
        assert_eq!(prove_upper(&statement, &bounds.upper.field).unwrap(), bounds.upper.value);
        assert_eq!([bounds.lower.factorisation, bounds.upper.factorisation], [one; 2]);
        assert_eq!(bounds.upper.claim().computed.unwrap().factorisation, one.name());
        bounds
    });
    // The first meshes are the same, and what they are solved to differs in the last digits only.
    let first = |bounds: &Bounds| bounds.levels[0].upper.proven.unwrap();
    assert!((first(&faer) / first(&qdldl) - 1.0).abs() < 1e-4);
    // Small programs have the bits that they have on every machine.
    assert_same(&qdldl, &at(None, 1));
}

#[test]
fn a_factor_of_safety_within_some_work_is_the_same_every_time() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/problems/slope.toml");
    let slope = Description::read(file.as_ref()).unwrap();
    let at = |threads| {
        let options = Options { max_gap: 1e-4, max_work: 400_000, threads, ..Options::default() };
        factor_of_safety(&slope, &options, &mut |_, _, _| {}).unwrap()
    };
    let (one, two) = (at(1), at(2));
    assert_eq!(one.ended, Ended::Work);
    assert_eq!((one.ended, one.work, &one.trials), (two.ended, two.work, &two.trials));
    assert_eq!(one.lower.bound.field, two.lower.bound.field);
    assert_eq!(one.upper.bound.field, two.upper.bound.field);
}
