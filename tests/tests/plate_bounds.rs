//! The built-in table of proven bounds against the bounds of Hong (2001), Appendix C, and against Chen & Liu.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use soilctl_earth_pressure::table::{BracketRow, CellStatus, PredictionTable};
use soilctl_earth_pressure::thesis::{Column, appendix_c};
use soilctl_earth_pressure::{Case, model, plate_bounds};

/// Cells of both tables at one node.
fn pairs(printed: &PredictionTable) -> Vec<(BracketRow, f64, CellStatus)> {
    let ours = plate_bounds().unwrap();
    assert_eq!(ours.rows().len(), 287);
    let cells = printed.filled().zip(ours.rows());
    cells
        .map(|((node, cell), row)| {
            assert_eq!(node, row.node());
            (*row, cell.k_net, cell.status)
        })
        .collect()
}

#[test]
fn no_proven_lower_bound_exceeds_an_upper_bound_of_the_thesis() {
    for (row, printed, _) in pairs(&appendix_c(Column::UpperBound).unwrap()) {
        assert!(row.lower <= printed, "{:?}: {} is proven, {printed} printed", row.node(), row.lower);
    }
}

#[test]
fn no_solved_lower_bound_of_the_thesis_exceeds_a_proven_upper_bound() {
    for (row, printed, status) in pairs(&appendix_c(Column::LowerBound).unwrap()) {
        let solved = status == CellStatus::Solved;
        assert!(!solved || row.upper >= printed, "{:?}: {} proven, {printed} printed", row.node(), row.upper);
    }
}

/// Chen & Liu's mechanisms are rigorous where the optimum is one: their bound is never below a proven lower bound.
#[test]
fn no_proven_lower_bound_exceeds_chen_and_liu() {
    let chen = model("chen").unwrap();
    for row in plate_bounds().unwrap().rows() {
        let case = Case::level_deg(row.alpha_deg, row.phi_deg, row.delta_deg);
        let upper = chen.predict(&case).unwrap().k_net().0;
        assert!(row.lower <= upper, "{:?}: {} is proven, Chen & Liu give {upper}", row.node(), row.lower);
    }
}

/// The thesis interpolated its lower bound at delta = 5 deg. In two of the 42 rows that is no lower bound.
#[test]
fn the_proven_bounds_find_the_two_false_lower_bounds_of_the_thesis() {
    let errata = [[75.0, 45.0, 5.0], [75.0, 50.0, 5.0]];
    let found: Vec<_> = pairs(&appendix_c(Column::LowerBound).unwrap())
        .into_iter()
        .filter(|(row, printed, _)| *printed > row.upper)
        .map(|(row, ..)| row.node())
        .collect();
    assert_eq!(found, errata);
}
