//! What an AGS file says of the ground: holes with their strata, and tests of strength and weight in them.

use std::collections::BTreeMap;

use super::tables::{Group, Row};
use crate::DrawingError;

/// Depths that differ by less are one (m): the standard writes them to a centimetre.
pub(super) const SAME_DEPTH_M: f64 = 5e-3;
/// Weight of 1 Mg of soil (kN), by standard gravity.
const KN_A_MG: f64 = 9.806_65;

/// A hole.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Hole {
    pub(super) name: String,
    /// Easting and northing (m), if the file has them.
    pub(super) plan: Option<[f64; 2]>,
    /// Level of the ground (m).
    pub(super) ground_m: f64,
    /// From the top downwards, without gaps.
    pub(super) strata: Vec<Stratum>,
}

/// What a hole goes through between two depths.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stratum {
    pub(super) code: String,
    /// Levels (m).
    pub(super) top_m: f64,
    pub(super) base_m: f64,
}

/// A number that a test gave.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Test {
    pub(super) hole: String,
    pub(super) depth_m: f64,
    pub(super) of: Property,
    pub(super) value: f64,
}

/// What tests tell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Property {
    Undrained,
    Cohesion,
    Friction,
    Weight,
}

impl Property {
    /// Its name and unit.
    pub(super) const fn words(self) -> (&'static str, &'static str) {
        match self {
            Self::Undrained => ("undrained strength", "kPa"),
            Self::Cohesion => ("effective cohesion", "kPa"),
            Self::Friction => ("effective friction", "deg"),
            Self::Weight => ("unit weight", "kN/m3"),
        }
    }
}

/// Columns of test results: group, heading of the value, its unit, heading of the depth, what it is, and what one of that unit is.
const TESTS: [(&str, &str, &str, &str, Property, f64); 8] = [
    ("TRIT", "TRIT_CU", "kPa", "SPEC_DPTH", Property::Undrained, 1.0),
    ("IVAN", "IVAN_IVAN", "kPa", "IVAN_DPTH", Property::Undrained, 1.0),
    ("LVAN", "LVAN_VNPK", "kPa", "SPEC_DPTH", Property::Undrained, 1.0),
    ("TREG", "TREG_COH", "kPa", "SPEC_DPTH", Property::Cohesion, 1.0),
    ("TREG", "TREG_PHI", "deg", "SPEC_DPTH", Property::Friction, 1.0),
    ("SHBG", "SHBG_PCOH", "kPa", "SPEC_DPTH", Property::Cohesion, 1.0),
    ("SHBG", "SHBG_PHI", "deg", "SPEC_DPTH", Property::Friction, 1.0),
    ("LDEN", "LDEN_BDEN", "Mg/m3", "SPEC_DPTH", Property::Weight, KN_A_MG),
];

/// Holes with strata, those that are named or all, in the order of the file. What is wrong with others does not matter.
pub(super) fn holes(groups: &BTreeMap<String, Group>, named: &[String]) -> Result<Vec<Hole>, DrawingError> {
    let group = |name: &'static str, what: &'static str| {
        let lacks = || DrawingError::Kind(format!("it has no group {name}, {what}"));
        groups.get(name).ok_or_else(lacks)
    };
    let is_wanted = |name: &str| named.is_empty() || named.iter().any(|wanted| wanted == name);
    let mut places = BTreeMap::new();
    for row in group("LOCA", "where the holes are")?.rows() {
        let name = row.needed("LOCA_ID")?;
        if places.insert(name, row).is_some() && is_wanted(name) {
            return Err(row.malformed(format!("hole {name} is there twice")));
        }
    }
    let mut holes: Vec<Hole> = Vec::new();
    for row in group("GEOL", "the strata in the holes")?.rows() {
        let name = row.needed("LOCA_ID")?;
        if !is_wanted(name) {
            continue;
        }
        let i = match holes.iter().position(|hole| hole.name == name) {
            Some(i) => i,
            None => {
                let place = places.get(name);
                holes.push(hole(
                    name,
                    place.ok_or_else(|| row.malformed(format!("hole {name} is not in group LOCA")))?,
                )?);
                holes.len() - 1
            }
        };
        let stratum = stratum(&row, holes[i].ground_m)?;
        holes[i].strata.push(stratum);
    }
    holes.iter_mut().try_for_each(put_in_order)?;
    Ok(holes)
}

/// A hole without its strata.
fn hole(name: &str, row: &Row<'_>) -> Result<Hole, DrawingError> {
    let pair = |[a, b]: [&str; 2]| Ok::<_, DrawingError>(row.number(a, "m")?.zip(row.number(b, "m")?));
    let plan = match pair(["LOCA_NATE", "LOCA_NATN"])? {
        Some(plan) => Some(plan),
        None => pair(["LOCA_LOCX", "LOCA_LOCY"])?,
    };
    let lacks = || row.malformed(format!("hole {name} has no level of the ground, LOCA_GL"));
    let ground_m = row.number("LOCA_GL", "m")?.ok_or_else(lacks)?;
    Ok(Hole { name: name.to_owned(), plan: plan.map(|(x, y)| [x, y]), ground_m, strata: Vec::new() })
}

fn stratum(row: &Row<'_>, ground_m: f64) -> Result<Stratum, DrawingError> {
    let depth = |heading: &str| {
        let found = row.number(heading, "m")?;
        found.ok_or_else(|| row.malformed(format!("{heading} is missing")))
    };
    let (top, base) = (depth("GEOL_TOP")?, depth("GEOL_BASE")?);
    if base <= top {
        return Err(row.malformed(format!("GEOL_BASE, {base} m, must be below GEOL_TOP, {top} m")));
    }
    let code = row.text("GEOL_GEOL").or_else(|| row.text("GEOL_LEG"));
    let code = code.ok_or_else(|| row.malformed("GEOL_GEOL and GEOL_LEG are missing".into()))?;
    Ok(Stratum { code: code.to_owned(), top_m: ground_m - top, base_m: ground_m - base })
}

/// Sorts strata, and makes one of those that follow each other with the same code.
fn put_in_order(hole: &mut Hole) -> Result<(), DrawingError> {
    hole.strata.sort_by(|a, b| b.top_m.total_cmp(&a.top_m));
    let mut above = hole.ground_m;
    let mut strata: Vec<Stratum> = Vec::new();
    for stratum in hole.strata.drain(..) {
        if (stratum.top_m - above).abs() > SAME_DEPTH_M {
            let [from, to] = [above, stratum.top_m].map(|level| hole.ground_m - level);
            let what = if to > from { "no stratum" } else { "two strata" };
            let [from, to] = [from.min(to), from.max(to)];
            return Err(DrawingError::Kind(format!(
                "hole {} has {what} between {from:.2} and {to:.2} m; mend the file, or leave the hole out with --holes",
                hole.name
            )));
        }
        above = stratum.base_m;
        match strata.last_mut() {
            Some(last) if last.code == stratum.code => last.base_m = stratum.base_m,
            Some(last) => {
                let top_m = last.base_m;
                strata.push(Stratum { top_m, ..stratum });
            }
            None => strata.push(Stratum { top_m: hole.ground_m, ..stratum }),
        }
    }
    hole.strata = strata;
    Ok(())
}

/// All numbers of tests that can be placed in a hole.
pub(super) fn tests(groups: &BTreeMap<String, Group>) -> Result<Vec<Test>, DrawingError> {
    let mut found = Vec::new();
    for (group, heading, unit, depth, of, one) in TESTS {
        for row in groups.get(group).into_iter().flat_map(Group::rows) {
            let depth_m = match row.number(depth, "m")? {
                Some(depth_m) => Some(depth_m),
                None => row.number("SAMP_TOP", "m")?,
            };
            let value = row.number(heading, unit)?;
            if let (Some(hole), Some(depth_m), Some(value)) = (row.text("LOCA_ID"), depth_m, value) {
                found.push(Test { hole: hole.to_owned(), depth_m, of, value: value * one });
            }
        }
    }
    Ok(found)
}

/// What codes of strata stand for, by group ABBR.
pub(super) fn meanings(groups: &BTreeMap<String, Group>) -> BTreeMap<&str, &str> {
    let rows = groups.get("ABBR").into_iter().flat_map(Group::rows);
    let of_strata = rows.filter(|row| matches!(row.text("ABBR_HDNG"), Some("GEOL_GEOL" | "GEOL_LEG")));
    of_strata.filter_map(|row| row.text("ABBR_CODE").zip(row.text("ABBR_DESC"))).collect()
}
