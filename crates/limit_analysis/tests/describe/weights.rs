use soilctl_limit_analysis::Description;
use soilctl_limit_analysis::describe::{Aim, BoundaryEntry, Kind, Side, SoilEntry};

use crate::common::{area, described, refusals, region, soil};

fn heavy(name: &str, unit_weight_kn_m3: f64) -> SoilEntry {
    SoilEntry { unit_weight_kn_m3, ..soil(name, 30.0, 5.0) }
}

#[test]
fn level_layers_need_no_cut() {
    let mut d = Description::strip_footing(heavy("top", 16.0), 2.0, 10.0, 0.0);
    d.soils.push(heavy("base", 20.0));
    let depths = [0.0, -3.0, -16.0];
    let layer = |i: usize| {
        let [a, b] = [depths[i], depths[i + 1]];
        [[-16.0, b], [0.3, b], [16.0, b], [16.0, a], [-16.0, a]]
    };
    d.regions = vec![region("base", &layer(1)), region("top", &layer(0))];
    let s = described(&d).statement;
    assert_eq!(s.regions.len(), 2);
    // The one on top comes first: it gives the unit weight of the reference.
    assert!(s.regions[0].material.unit_weight < s.regions[1].material.unit_weight);
}

#[test]
fn tops_that_bend_are_cut_below_their_corners_down_through_all_layers() {
    let mut d = Description::slope(heavy("top", 16.0), 6.0, 45.0);
    d.soils.extend([heavy("middle", 18.0), heavy("base", 20.0)]);
    d.regions = vec![
        region(
            "top",
            &[
                [30.0, 4.0],
                [30.0, 6.0],
                [6.0, 6.0],
                [0.0, 0.0],
                [-18.0, 0.0],
                [-18.0, -1.0],
                [5.0, -2.0],
                [15.0, 3.0],
            ],
        ),
        region(
            "middle",
            &[[-18.0, -1.0], [5.0, -2.0], [15.0, 3.0], [30.0, 4.0], [30.0, 1.0], [2.0, -4.0], [-18.0, -4.0]],
        ),
        region("base", &[[-18.0, -4.0], [2.0, -4.0], [30.0, 1.0], [30.0, -6.0], [-18.0, -6.0]]),
    ];
    let found = described(&d);
    let s = &found.statement;
    let total: f64 = (0..s.regions.len()).map(|r| area(s, r)).sum();
    let expected = 18.0 * 6.0 + 30.0 * 12.0 - 0.5 * 6.0 * 6.0;
    assert!((total * found.length_m * found.length_m - expected).abs() < 1e-9);
    // The middle layer below two corners, the base below those and its own.
    assert_eq!(s.regions.len(), 1 + 3 + 4);
}

#[test]
fn a_lens_in_lighter_soil_is_taken() {
    let mut d = Description::strip_footing(heavy("sand", 16.0), 2.0, 10.0, 0.0);
    d.soils.push(heavy("lens", 20.0));
    let [w, h] = [16.0, 16.0];
    let lens = [[-3.0, -5.0], [0.0, -6.0], [4.0, -5.0], [1.0, -4.0]];
    d.regions = vec![
        region(
            "sand",
            &[
                [-w, 0.0],
                [-w, -h],
                [w, -h],
                [w, 0.0],
                [4.0, 0.0],
                [4.0, -5.0],
                [0.0, -6.0],
                [-3.0, -5.0],
                [-3.0, 0.0],
            ],
        ),
        region("sand", &[[-3.0, 0.0], [-3.0, -5.0], [1.0, -4.0], [4.0, -5.0], [4.0, 0.0]]),
        region("lens", &lens),
    ];
    let found = d.described().unwrap();
    let refusals = crate::common::refusals(&found.statement);
    // Soil beside and below a lens carries more on one part of its top than on another.
    assert!(refusals.is_empty(), "{refusals:?}");
}

#[test]
fn strength_that_grows_with_depth_is_linear() {
    let clay = SoilEntry {
        cohesion_gradient_kpa_per_m: 2.0,
        cohesion_level_m: Some(-1.0),
        ..soil("clay", 0.0, 10.0)
    };
    let found = described(&Description::strip_footing(clay, 2.0, 0.0, 3.0));
    let cohesion = found.statement.regions[0].material.cohesion;
    for depth in [0.0, 1.0, 10.0] {
        let kpa = cohesion.at([0.0, -depth / found.length_m]) * found.stress_kpa;
        assert!((kpa - (8.0 + 2.0 * depth)).abs() < 1e-12);
    }
}

#[test]
fn soil_goes_on_below_soil_of_its_weight_only_where_all_above_it_weighs_alike() {
    // A layer at the bottom, below two columns of its own weight: on the left there is something heavier in the column above, or on both sides.
    for (right, taken) in [("right", false), ("heavy", true)] {
        let mut d = Description::level_ground(soil("top", 20.0, 5.0), 2.0, 4.0);
        d.boundaries[0].kind = Kind::Smooth;
        d.boundaries[0].sides.pop();
        d.boundaries.push(BoundaryEntry::on_sides(Kind::Fixed, &[Side::Bottom]));
        d.objective = Aim::StrengthReduction {};
        let column = |x: f64, y: f64| vec![[x, y - 1.0], [x + 2.0, y - 1.0], [x + 2.0, y], [x, y]];
        d.regions[0].polygon = vec![[-2.0, -1.0], [2.0, -1.0], [2.0, 0.0], [-2.0, 0.0]];
        d.regions.push(region("heavy", &column(-2.0, -1.0)));
        d.regions.push(region(right, &column(0.0, -1.0)));
        d.regions.push(region("left", &column(-2.0, -2.0)));
        d.regions.push(region("right", &column(0.0, -2.0)));
        d.regions.push(region("below", &[[-2.0, -4.0], [2.0, -4.0], [2.0, -3.0], [-2.0, -3.0]]));
        for (name, phi) in [("heavy", 21.0), ("right", 22.0), ("left", 23.0), ("below", 24.0)] {
            d.soils.push(soil(name, phi, 5.0));
        }
        // Of one weight nothing is cut; then what is known by its friction gets its weight.
        let mut statement = described(&d).statement;
        for region in &mut statement.regions {
            region.material.unit_weight *= match region.material.phi_deg {
                20.0 => 1.0,
                21.0 => 3.0,
                _ => 2.0,
            };
        }
        let refusals = refusals(&statement);
        let bent = refusals.iter().any(|e| e.to_string().contains("one straight top"));
        assert_eq!((refusals.is_empty(), bent), (taken, !taken), "{refusals:?}");
    }
}
