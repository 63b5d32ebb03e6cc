//! Lines inside the soil: where soils meet and where the water table is. Other lines are cuts of the solver's making, which mean
//! nothing and are not drawn.

use soilctl_certificate::{LineUse, Linear, Material, Statement};
use soilctl_limit_analysis::results::Point;

/// Part of the greatest pore pressure that counts as none.
const NONE: f64 = 1e-9;

/// Lines with soil on both sides and no condition, with what is on either side.
fn inside(statement: &Statement) -> impl Iterator<Item = ([Point; 2], [&Material; 2])> {
    let owner = |side: LineUse| {
        statement.regions.iter().find(|region| region.loops.iter().flatten().any(|used| *used == side))
    };
    (0..statement.lines.len()).filter_map(move |line| {
        if statement.boundaries.iter().any(|b| b.line == line) {
            return None;
        }
        let [a, b] = [true, false].map(|forward| owner(LineUse { line, forward }));
        let ends = statement.lines[line].walked(true).map(|p| statement.points[p]);
        Some((ends, [&a?.material, &b?.material]))
    })
}

/// Lines between two soils, whatever water there is in them.
pub(crate) fn between_soils(statement: &Statement) -> Vec<Vec<Point>> {
    let differ = |[a, b]: &[&Material; 2]| {
        a.phi_deg != b.phi_deg
            || a.cohesion != b.cohesion
            || a.unit_weight != b.unit_weight
            || a.tension != b.tension
            || a.envelope != b.envelope
            || a.anisotropy != b.anisotropy
    };
    inside(statement).filter(|(_, soils)| differ(soils)).map(|(ends, _)| ends.to_vec()).collect()
}

/// Lines below which pore pressure grows from nothing.
pub(crate) fn water_table(statement: &Statement) -> Vec<[Point; 2]> {
    let size = |p: &Linear, ends: &[Point; 2]| {
        let reach = ends.iter().flatten().map(|x| x.abs()).fold(0.0, f64::max);
        p.at_origin.abs() + reach * (p.gradient[0].abs() + p.gradient[1].abs())
    };
    let begins =
        |ends: &[Point; 2], wet: &Linear| ends.iter().all(|p| wet.at(*p).abs() <= NONE * size(wet, ends));
    let is_table = |(ends, [a, b]): &([Point; 2], [&Material; 2])| match (
        a.pore_pressure.is_zero(),
        b.pore_pressure.is_zero(),
    ) {
        (true, false) => begins(ends, &b.pore_pressure),
        (false, true) => begins(ends, &a.pore_pressure),
        (true, true) | (false, false) => false,
    };
    inside(statement).filter(is_table).map(|(ends, _)| ends).collect()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use soilctl_limit_analysis::Description;
    use soilctl_limit_analysis::describe::{Aim, RegionEntry, SoilEntry, Water};

    use super::*;

    /// Two soils of different weight with a bent water table through the lower one, which cuts both in places.
    fn statement() -> Statement {
        let soil = |name: &str, weight: f64| SoilEntry {
            name: name.into(),
            phi_deg: Some(30.0),
            cohesion_kpa: 5.0,
            unit_weight_kn_m3: weight,
            ..SoilEntry::default()
        };
        let region = |soil: &str, low: f64, high: f64| RegionEntry {
            soil: soil.into(),
            polygon: vec![[0.0, low], [10.0, low], [10.0, high], [0.0, high]],
            ..RegionEntry::default()
        };
        let description = Description {
            objective: Aim::UnitWeight {},
            default_boundary: Some(soilctl_limit_analysis::describe::Kind::Free),
            water: Some(Water {
                rise_m: 0.0,
                table: vec![[0.0, -3.0], [4.0, -3.0], [10.0, -2.0]],
                unit_weight_kn_m3: 10.0,
            }),
            soils: vec![soil("upper", 17.0), soil("lower", 20.0)],
            regions: vec![region("upper", -1.0, 0.0), region("lower", -5.0, -1.0)],
            ..Description::default()
        };
        description.described().unwrap().statement
    }

    #[test]
    fn soils_meet_at_one_line_and_the_water_table_is_another_and_cuts_are_neither() {
        let statement = statement();
        let length = |lines: &[[Point; 2]]| -> f64 { lines.iter().map(|[a, b]| (b[0] - a[0]).abs()).sum() };
        let soils: Vec<[Point; 2]> =
            between_soils(&statement).into_iter().map(|line| line.try_into().unwrap()).collect();
        let water = water_table(&statement);
        let wide = statement.points.iter().map(|p| p[0]).fold(0.0, f64::max)
            - statement.points.iter().map(|p| p[0]).fold(0.0, f64::min);
        for (what, lines) in [("soils", &soils), ("water", &water)] {
            assert!((length(lines) / wide - 1.0).abs() < 1e-9, "{what}: {lines:?}");
        }
        assert!(soils.iter().all(|[a, b]| a[1] == b[1]) && water.iter().any(|[a, b]| a[1] != b[1]));
        // The table is cut below its kink.
        assert!(inside(&statement).count() > soils.len() + water.len());
    }
}
