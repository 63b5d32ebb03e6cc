//! Raw shear-box records: the synthetic example must give its truth back, and bad records must be refused.
#![allow(clippy::unwrap_used)]

mod common;

#[path = "../examples/make_raw_example.rs"]
#[allow(dead_code)]
mod example;

use common::data;
use soilctl_direct_shear::raw::{
    FrictionLoop, RawAnalysis, RawRun, RawSample, RawSettings, ShearBox, analyse_runs, parse_friction_loop,
    parse_runs, read_friction_loop, read_runs,
};
use soilctl_direct_shear::{LogLogFit, SlopeFloorFit};
use soilctl_soil::units;

fn settings() -> RawSettings {
    RawSettings { bias_n: example::BIAS_N, ..RawSettings::default() }
}

fn analysed(with_loop: bool) -> RawAnalysis {
    let runs = read_runs(data("direct_shear_raw/runs.csv")).unwrap();
    let known = read_friction_loop(data("direct_shear_raw/loop.csv")).unwrap();
    analyse_runs(&runs, with_loop.then_some(&known), &settings()).unwrap()
}

#[test]
fn the_files_are_those_of_the_example_program() {
    for (name, text) in [("runs.csv", example::runs_csv()), ("loop.csv", example::loop_csv())] {
        let stored = std::fs::read_to_string(data(&format!("direct_shear_raw/{name}"))).unwrap();
        assert_eq!(stored.lines().count(), text.lines().count());
        for (a, b) in stored.split([',', '\n']).zip(text.split([',', '\n'])) {
            match (a.parse::<f64>(), b.parse::<f64>()) {
                // A last digit may fall differently where the mathematics library differs.
                (Ok(a), Ok(b)) => assert!((a - b).abs() < 1.5e-3, "{a} {b}"),
                _ => assert_eq!(a, b),
            }
        }
    }
}

#[test]
fn peaks_displacements_and_dilation_of_the_example_are_recovered() {
    let analysis = analysed(true);
    assert_eq!((analysis.runs.len(), analysis.loads.len()), (19, 7));
    assert!(analysis.warnings.is_empty(), "{:?}", analysis.warnings);
    for load in &analysis.loads {
        let truth = example::true_friction_deg(load.load_kg);
        assert!((load.friction.degrees() - truth).abs() < 0.3, "{load:?} against {truth}");
        let dropped: Vec<_> = load.dropped.iter().map(|name| name.ends_with("kg-d")).collect();
        assert_eq!(dropped, if load.load_kg < 10.0 { vec![true] } else { vec![] });
        assert_eq!(load.standard_deviation_deg.is_some(), load.load_kg < 10.0);
    }
    for run in &analysis.runs {
        assert!((run.peak_displacement_m * 1e3 - example::PEAK_MM).abs() < 0.45, "{}", run.run_id);
        let dilation = example::true_dilation_deg(run.friction.degrees());
        assert!((run.dilation.unwrap().degrees() - dilation).abs() < 0.8, "{} {dilation}", run.run_id);
        assert_eq!((run.smoothed, run.trace.len()), (run.load_kg < 10.0, 51));
    }
}

#[test]
fn machine_friction_matters_at_the_lowest_load_only() {
    let (with, without) = (analysed(true), analysed(false));
    let gain = |index: usize| without.loads[index].friction.degrees() - with.loads[index].friction.degrees();
    assert!((0.5..1.0).contains(&gain(0)), "{}", gain(0));
    assert!(gain(6) < 0.02, "{}", gain(6));
    assert!((with.runs[0].loop_correction_deg - gain(0)).abs() < 0.05);
    assert!(without.warnings.iter().any(|warning| warning.contains("friction loop")));
}

#[test]
fn the_points_go_into_the_fits() {
    let analysis = analysed(true);
    let series = analysis.series(Some("synthetic".to_owned())).unwrap();
    assert_eq!(analysis.weights(), [3.0, 3.0, 3.0, 3.0, 1.0, 1.0, 1.0]);
    let fit = SlopeFloorFit::fit(&series.points, Some(&analysis.weights())).unwrap();
    assert!((fit.floor.degrees() - example::FLOOR_DEG).abs() < 0.2, "{fit:?}");
    assert!((fit.slope_deg_per_decade - example::SLOPE_DEG_PER_DECADE).abs() < 0.3, "{fit:?}");
    assert_eq!(LogLogFit::fit(&series.points).unwrap().misfit.points, 4);
}

#[test]
fn loads_of_the_thesis_give_the_stresses_of_table_6_13() {
    let printed = [0.18, 0.36, 1.16, 2.33, 6.95, 10.91, 18.82];
    let appendix = ShearBox::default();
    let body = ShearBox { area_m2: ShearBox::TABLE_6_13_AREA_M2, ..appendix };
    for (load, stress) in example::LOADS_KG.iter().zip(printed) {
        // 0.18 and 0.36 psi are printed to two digits.
        let slack = if stress < 1.0 { 0.018 } else { 0.004 };
        let ours = units::pa_to_psi(body.normal_stress_pa(*load));
        assert!((ours / stress - 1.0).abs() < slack, "{ours} {stress}");
        let ours = units::pa_to_psi(appendix.normal_stress_pa(*load));
        assert!((ours / stress - 1.0).abs() < 0.023, "{ours} {stress}");
    }
    assert!((appendix.normal_stress_pa(0.4473) - 1232.0).abs() < 0.5);
}

fn run_with(id: &str, load_kg: f64, forces: &[f64]) -> RawRun {
    let samples = forces.iter().enumerate().map(|(index, force)| RawSample {
        displacement_m: 1e-4 * f64::from(u32::try_from(index).unwrap()),
        shear_force_n: *force,
        vertical_m: None,
    });
    RawRun::new(id, load_kg, samples.collect()).unwrap()
}

#[test]
fn smoothing_is_for_low_loads() {
    let spike = [0.0, 3.0, 3.0, 6.0, 3.0, 3.0, 3.0];
    let low = analyse_runs(&[run_with("low", 0.5, &spike)], None, &RawSettings::default()).unwrap();
    let normal = 0.5 * 9.806_65;
    assert!((low.runs[0].friction.tan() - 4.0 / normal).abs() < 1e-12);
    assert!(low.runs[0].dilation.is_none() && low.warnings.iter().any(|w| w.contains("repeat")));
    let high = analyse_runs(&[run_with("high", 20.0, &spike)], None, &RawSettings::default()).unwrap();
    assert!((high.runs[0].friction.tan() - 6.0 / (40.0 * normal)).abs() < 1e-12);
}

#[test]
fn a_record_that_still_rises_and_runs_that_differ_are_warned_of() {
    let runs = [run_with("a", 20.0, &[0.0, 50.0, 100.0]), run_with("b", 20.0, &[0.0, 150.0, 100.0])];
    let analysis = analyse_runs(&runs, None, &RawSettings::default()).unwrap();
    assert!(analysis.warnings.iter().any(|w| w.contains("`a`") && w.contains("beyond")), "{analysis:?}");
    assert!(analysis.warnings.iter().any(|w| w.contains("differ by")));
    assert_eq!(analysis.loads[0].kept, ["a", "b"]);
}

#[test]
fn the_loop_is_averaged_over_the_common_displacement() {
    let text = "displacement_mm,shear_force_n,direction\n0,5,forward\n1,1.2,forward\n3,1.2,forward\n\
                4,0.8,reverse\n1,0.8,reverse\n";
    let found = parse_friction_loop(text.as_bytes(), "loop.csv").unwrap();
    assert!((found.half_height_n() - 0.2).abs() < 1e-12);
    assert!((found.range_m().0 - 1e-3).abs() < 1e-15 && (found.range_m().1 - 3e-3).abs() < 1e-15);
}

#[test]
fn bad_loops_are_refused() {
    let header = "displacement_mm,shear_force_n,direction\n";
    for (rows, fragment) in [
        ("0,1,forward\n1,1,forward\n", "two points"),
        ("0,1,forward\n1,1,forward\n2,0,reverse\n3,0,reverse\n", "no range in common"),
        ("0,0,forward\n1,0,forward\n0,1,reverse\n1,1,reverse\n", "swapped"),
        ("0,1,up\n", "line 2, column `direction`: \"up\""),
    ] {
        let error = parse_friction_loop(format!("{header}{rows}").as_bytes(), "loop.csv").unwrap_err();
        assert!(error.to_string().contains(fragment), "{error}");
    }
    assert!(FrictionLoop::new(f64::NAN, 0.0, 1.0).is_err());
}

#[test]
fn bad_runs_are_refused() {
    let header = "run_id,load_kg,displacement_mm,shear_force_n,vertical_mm\n";
    for (rows, fragment) in [
        ("a,1,0,0,\na,1,1,5,\n", "at least 3"),
        ("a,1,0,0,\na,1,2,5,\na,1,1,5,\n", "goes back"),
        ("a,1,1,0,\na,1,1,5,\na,1,1,5,\n", "never advances"),
        ("a,1,0,0,0\na,1,1,5,\na,1,2,5,0\n", "all or none"),
        ("a,1,0,0,\na,2,1,5,\n", "line 3, column `load_kg`: \"2\""),
        ("a,0,0,0,\n", "line 2, column `load_kg`: \"0\""),
        ("a,1,0,x,\n", "line 2, column `shear_force_n`: \"x\""),
    ] {
        let error = parse_runs(format!("{header}{rows}").as_bytes(), "runs.csv").unwrap_err();
        assert!(error.to_string().contains(fragment), "{error}");
    }
    let settings = RawSettings::default();
    let run = run_with("a", 1.0, &[0.0, -5.0, -6.0]);
    let error = analyse_runs(std::slice::from_ref(&run), None, &RawSettings { bias_n: 9.0, ..settings });
    assert!(error.unwrap_err().to_string().contains("above 0 N"));
    assert!(analyse_runs(&[], None, &settings).is_err());
    assert!(analyse_runs(&[run.clone(), run], None, &settings).is_err());
    assert!(RawSettings { runs_kept: 1, ..settings }.check().is_err());
    assert!(RawSettings { bias_n: f64::NAN, ..settings }.check().is_err());
}
