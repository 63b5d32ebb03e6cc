//! The closed-form models against the tables of Hong (2001): Appendix C and Table 4.3.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use serde::Deserialize;
use soilctl_earth_pressure::table::BracketModel;
use soilctl_earth_pressure::thesis::{Column, appendix_c};
use soilctl_earth_pressure::{Case, ForceModel, Input, model, sensitivity_percent};
use soilctl_soil::Angle;
use soilctl_tests::{data, shown};

/// Model against column: (case, ours, printed) for each printed row.
fn against(id: &str, column: Column) -> Vec<(Case, f64, f64)> {
    let model = model(id).unwrap();
    let rows: Vec<_> = appendix_c(column)
        .unwrap()
        .filled()
        .map(|([alpha, phi, delta], cell)| {
            let case = Case::level_deg(alpha, phi, delta);
            (case, model.predict(&case).unwrap().k_net().0, cell.k_net)
        })
        .collect();
    rows
}

fn worst(rows: &[(Case, f64, f64)]) -> f64 {
    rows.iter().map(|(_, ours, printed)| (ours - printed).abs()).fold(0.0, f64::max)
}

#[test]
fn coulomb_reproduces_appendix_c() {
    let rows = against("coulomb", Column::Coulomb);
    assert_eq!(rows.len(), 286);
    assert!(worst(&rows) <= 0.0006, "{}", worst(&rows));
}

#[test]
fn the_thesis_variant_of_the_log_spiral_reproduces_appendix_c() {
    let rows = against("log-spiral-thesis", Column::LogSpiral);
    assert_eq!(rows.len(), 286);
    assert!(worst(&rows) <= 0.001, "{}", worst(&rows));
}

/// The printed optimiser stalled on the boundary psi = 0; elsewhere both are the same optimum.
#[test]
fn chen_is_never_above_appendix_c_and_equal_where_the_optimum_is_interior() {
    let rows = against("chen", Column::Chen);
    assert_eq!(rows.len(), 287);
    let equal = rows.iter().filter(|(_, ours, printed)| (ours - printed).abs() <= 0.0006).count();
    for (case, ours, printed) in &rows {
        assert!(*ours <= printed + 0.0006, "{case:?}: {ours} above {printed}");
        assert!(*ours >= printed - 0.013, "{case:?}: {ours} far below {printed}");
    }
    assert!(equal >= 172, "{equal} rows equal");
}

#[test]
fn caquot_is_its_column() {
    let rows = against("caquot", Column::Caquot);
    assert_eq!(rows.len(), 287);
    assert!(worst(&rows) < 1e-12);
}

/// Passive coefficient of the classical tables: rough value times reduction factor, where both are published.
#[test]
fn caquot_split_agrees_with_the_classical_tables() {
    // Kp(rough) at alpha 90 deg, horizontal surface, and R at delta/phi 0 and 0.5 (Caquot & Kerisel 1948).
    for (phi, rough, r) in [(30.0, 6.42, [0.467, 0.746]), (40.0, 17.5, [0.262, 0.592])] {
        for (ratio, r) in [(0.0, r[0]), (0.5, r[1])] {
            let p = model("caquot").unwrap().predict(&Case::level_deg(90.0, phi, ratio * phi)).unwrap();
            let passive = p.passive.unwrap().weight;
            assert!((passive / (rough * r) - 1.0).abs() < 0.002, "{phi} {ratio}: {passive} {}", rough * r);
        }
    }
}

/// Both log-spirals share everything but two quirks, which can only raise the force.
#[test]
fn the_quirks_raise_the_log_spiral_by_up_to_a_quarter() {
    let (mut most, mut least) = (0.0_f64, f64::MAX);
    for ([alpha, phi, delta], _) in appendix_c(Column::LogSpiral).unwrap().filled() {
        let case = Case::level_deg(alpha, phi, delta);
        let passive = |id: &str| model(id).unwrap().predict(&case).unwrap().passive.unwrap().weight;
        let ratio = passive("log-spiral-thesis") / passive("log-spiral");
        (most, least) = (most.max(ratio), least.min(ratio));
    }
    assert!(least > 0.99 && (1.15..1.25).contains(&most), "{least} {most}");
}

#[test]
fn the_documentation_shows_appendix_c_as_it_is_here() {
    let columns = [
        against("coulomb", Column::Coulomb),
        against("log-spiral-thesis", Column::LogSpiral),
        against("chen", Column::Chen),
    ];
    // The two cells that are empty in print have no answer either.
    let degrees = |case: &Case| [case.tool_angle, case.friction, case.interface].map(|a| a.degrees().round());
    let lines: Vec<_> = columns[0]
        .iter()
        .map(|(case, ..)| {
            let find = |column: &Vec<(Case, f64, f64)>| {
                let (_, ours, printed) =
                    column.iter().find(|(other, ..)| degrees(other) == degrees(case)).unwrap();
                [*ours, *printed]
            };
            let [alpha, phi, delta] = degrees(case);
            (format!("{alpha},{phi},{delta}"), columns.iter().flat_map(find).collect())
        })
        .collect();
    let header =
        "alpha_deg,phi_deg,delta_deg,coulomb,coulomb_printed,log_spiral,log_spiral_printed,chen,chen_printed";
    shown("appendix_c.csv", header, &lines);
}

#[test]
fn the_documentation_shows_table_4_3_as_it_is_here() {
    let mut lines = Vec::new();
    for (column, id) in ["coulomb", "log-spiral-thesis", "chen"].into_iter().enumerate() {
        for row in sensitivities() {
            if let Some(printed) = [row.coulomb, row.log_spiral, row.chen][column] {
                let key = format!("{id},{},{},{}", row.alpha_deg, row.input, row.step_deg);
                lines.push((key, vec![row.percent(&*model(id).unwrap()), printed]));
            }
        }
    }
    shown("table_4_3.csv", "model,alpha_deg,input,step_deg,percent,percent_printed", &lines);
}

#[derive(Deserialize)]
struct SensitivityRow {
    step_deg: f64,
    alpha_deg: f64,
    input: String,
    coulomb: Option<f64>,
    log_spiral: Option<f64>,
    chen: Option<f64>,
}

impl SensitivityRow {
    /// By how much the force changes under a model, in per cent.
    fn percent(&self, model: &dyn ForceModel) -> f64 {
        let input = match self.input.as_str() {
            "alpha" => Input::ToolAngle,
            "beta" => Input::SurfaceSlope,
            "phi" => Input::Friction,
            _ => Input::Interface,
        };
        let base = Case::level_deg(self.alpha_deg, 40.0, 25.0);
        sensitivity_percent(model, &base, input, Angle::from_degrees(self.step_deg)).unwrap()
    }
}

fn sensitivities() -> Vec<SensitivityRow> {
    csv::Reader::from_path(data("table_4_3.csv")).unwrap().deserialize().map(Result::unwrap).collect()
}

/// Worst deviation from one model's blocks of Table 4.3 (phi = 40, delta = 25 deg, level), in per cent points.
fn table_4_3(model: &dyn ForceModel, pick: impl Fn(&SensitivityRow) -> Option<f64>, skip: &str) -> f64 {
    let mut worst = 0.0_f64;
    for row in sensitivities() {
        let Some(printed) = pick(&row).filter(|_| row.input != skip) else { continue };
        let ours = row.percent(model);
        let off = (ours - printed).abs();
        assert!(
            off < 0.2,
            "{} alpha {} {} +{}: {ours} {printed}",
            model.id(),
            row.alpha_deg,
            row.input,
            row.step_deg
        );
        worst = worst.max(off);
    }
    worst
}

#[test]
fn table_4_3_coulomb_and_chen() {
    let coulomb = table_4_3(&*model("coulomb").unwrap(), |r| r.coulomb, "");
    let chen = table_4_3(&*model("chen").unwrap(), |r| r.chen, "");
    assert!(coulomb <= 0.06 && chen <= 0.06, "{coulomb} {chen}");
}

/// The printed surface-slope block of the log-spiral follows no reading of the text; the other blocks do.
#[test]
fn table_4_3_log_spiral() {
    let log_spiral = table_4_3(&*model("log-spiral-thesis").unwrap(), |r| r.log_spiral, "beta");
    assert!(log_spiral <= 0.1, "{log_spiral}");
}

/// The cells of the printed lower bound that exceed Chen & Liu's upper bound, and the margin that heals them.
/// Against the printed Chen column there are two; its optimiser stalled by 0.006 in the third, (75, 40, 5).
#[test]
fn the_bracket_heals_the_cells_that_were_never_solved() {
    let chen = model("chen").unwrap();
    let printed = model("thesis-lb").unwrap();
    let [lower, upper] = [Column::LowerBound, Column::UpperBound].map(|column| appendix_c(column).unwrap());
    let bracket = BracketModel::new("thesis", "Appendix C", lower.clone(), upper);
    let mut above = Vec::new();
    for ([alpha, phi, delta], _) in lower.filled() {
        let case = Case::level_deg(alpha, phi, delta);
        let upper = chen.predict(&case).unwrap().k_net().0;
        if printed.predict(&case).unwrap().k_net().0 > upper {
            above.push((alpha, phi, delta));
        }
        assert!(bracket.predict(&case).unwrap().net_lower.0 <= upper, "{case:?}");
    }
    assert_eq!(above, [(75.0, 40.0, 5.0), (75.0, 45.0, 5.0), (75.0, 50.0, 5.0)]);
}
