//! What was given, as tables: soils, what acts, load cases.

use soilctl_app::solve::{CaseAnswer, Solved};
use soilctl_app::text::{number, number_or_dash};
use soilctl_figure::{Align, Table};
use soilctl_limit_analysis::describe::{Case, SoilEntry};

use crate::PageError;
use crate::problem::Scene;

/// The tables that there is something for.
pub(super) fn tables(found: &Solved) -> Result<Vec<Table>, PageError> {
    let given = soils("Soils, as given", &found.given.soils)?;
    let of_case = match &found.answer.governing {
        Some(_) => Some(soils(&format!("Soils{}", of_case(found)), &found.description.soils)?),
        None => None,
    };
    let all = [Some(given), of_case, acting(found)?, cases(found)?];
    Ok(all.into_iter().flatten().collect())
}

/// Why numbers may be others than in the file.
fn of_case(found: &Solved) -> String {
    found.answer.governing.as_ref().map_or_else(String::new, |name| {
        format!(", as in {name}, with its values set and partial factors applied")
    })
}

/// Downwards, and how much more along x.
fn permeability(soil: &SoilEntry) -> String {
    let down = soil.permeability_m_per_s.map_or_else(|| "not given".to_owned(), |k| format!("{k:e}"));
    soil.permeability_ratio.map_or(down.clone(), |ratio| format!("{down}, times {} along x", number(ratio)))
}

fn soils(caption: &str, soils: &[SoilEntry]) -> Result<Table, PageError> {
    let is_permeable = soils.iter().any(|soil| soil.permeability_m_per_s.is_some());
    let mut columns = vec![
        ("soil", Align::Left),
        ("friction angle (°)", Align::Right),
        ("cohesion (kPa)", Align::Right),
        ("unit weight (kN/m³)", Align::Right),
        ("tension at most (kPa)", Align::Right),
        ("pore pressure ratio", Align::Right),
    ];
    if is_permeable {
        columns.push(("permeability (m/s)", Align::Right));
    }
    let mut table = Table::new(caption, columns);
    for soil in soils {
        let mut cohesion = number(soil.cohesion_kpa);
        if soil.cohesion_gradient_kpa_per_m != 0.0 {
            let level = number(soil.cohesion_level_m.unwrap_or_default());
            cohesion += &format!(" at y = {level} m, + {} per m", number(soil.cohesion_gradient_kpa_per_m));
        }
        if let Some(of) = soil.anisotropy {
            cohesion += &format!("; passive {} of it, shear {}", number(of.passive), number(of.shear));
        }
        let mut friction = number(soil.phi_deg.unwrap_or_default());
        if let Some(dilation_deg) = soil.dilation_deg {
            let less = soil.after_davis();
            friction += &format!(", dilation {} (Davis)", number(dilation_deg));
            cohesion += &format!("; taken as φ {:.2}°, c {:.3}", less.friction_deg(), less.cohesion_kpa);
        }
        if let Some(law) = soil.law_words() {
            (friction, cohesion) = (law, "by the law".to_owned());
        }
        let tension = soil.tension_kpa.map_or_else(|| "as strength allows".to_owned(), number);
        let mut row = vec![
            soil.name.clone(),
            friction,
            cohesion,
            number(soil.unit_weight_kn_m3),
            tension,
            number(soil.pore_pressure_ratio),
        ];
        if is_permeable {
            row.push(permeability(soil));
        }
        table.row(row)?;
    }
    Ok(table)
}

/// All that acts beside the soil's weight; none if nothing does.
fn acting(found: &Solved) -> Result<Option<Table>, PageError> {
    let columns = [("what acts", Align::Left), ("where", Align::Left), ("how much", Align::Left)];
    let mut table = Table::new(format!("What acts beside the soil's weight{}", of_case(found)), columns);
    let understood = Scene::of_file(&found.description, &found.described).understood();
    let point = |[x, y]: [f64; 2]| format!("({}, {})", number(x), number(y));
    let span = |[a, b]: [f64; 2]| {
        if a == b { number(a) } else { format!("{} to {}", number(a), number(b)) }
    };
    let mut rows: Vec<[String; 3]> = Vec::new();
    if understood.surcharge != 0.0 {
        let much = format!("{} kPa", number(understood.surcharge));
        rows.push(["surcharge".into(), "all free ground".into(), much]);
    }
    for load in &understood.loads {
        let name = if load.live { "load, whose factor is bounded" } else { "load" };
        let mut much = format!("{} kPa", span(load.pressure));
        if load.shear != [0.0; 2] {
            much += &format!(", shear {} kPa", span(load.shear));
        }
        rows.push([name.into(), format!("{} to {} m", point(load.ends[0]), point(load.ends[1])), much]);
    }
    if let Some(water) = &found.description.water {
        let levels: Vec<String> = water.levels().into_iter().map(point).collect();
        let much = format!("hydrostatic, {} kN/m³", number(water.unit_weight_kn_m3));
        rows.push(["ground water".into(), format!("below {} m", levels.join(", ")), much]);
    }
    for head in &found.description.heads {
        let name = head
            .name
            .as_ref()
            .map_or_else(|| "ground water".to_owned(), |name| format!("ground water, {name}"));
        let points: Vec<String> = head.line.iter().copied().map(point).collect();
        rows.push([
            name,
            format!("along {} m", points.join(", ")),
            format!("head {} m", number(head.head_m)),
        ]);
    }
    for (words, _) in &understood.shaking {
        rows.push([words.clone(), "all soil".into(), "steady, times the weight".into()]);
    }
    let is_empty = rows.is_empty();
    for row in rows {
        table.row(row)?;
    }
    Ok((!is_empty).then_some(table))
}

/// Each case with what it sets, its partial factors and its bounds; none if the file has none.
fn cases(found: &Solved) -> Result<Option<Table>, PageError> {
    if found.answer.cases.is_empty() {
        return Ok(None);
    }
    let columns = [
        ("load case", Align::Left),
        ("sets", Align::Left),
        ("partial factors", Align::Left),
        ("lower bound", Align::Right),
        ("upper bound", Align::Right),
        ("one or more", Align::Left),
    ];
    let mut table = Table::new("Load cases, and what was proven of each", columns);
    for case in &found.answer.cases {
        let factors = found.cases.iter().find(|one| one.name == case.name).map_or_else(String::new, factors);
        let sets: Vec<String> =
            case.values.iter().map(|(key, value)| format!("{key} = {}", number(*value))).collect();
        table.row([
            case.name.clone(),
            dash(sets.join(", ")),
            dash(factors),
            number_or_dash(case.lower),
            number_or_dash(case.upper),
            enough(case),
        ])?;
    }
    Ok(Some(table))
}

/// Those other than one.
fn factors(case: &Case) -> String {
    let named = case.factors.named().into_iter().filter_map(|(key, value)| {
        let name = key.rsplit('.').next().unwrap_or(key);
        value.filter(|value| *value != 1.0).map(|value| format!("{name} {}", number(value)))
    });
    named.collect::<Vec<_>>().join(", ")
}

fn enough(case: &CaseAnswer) -> String {
    match (case.enough, &case.problem) {
        (_, Some(problem)) => problem.clone(),
        (Some(true), None) => "yes".into(),
        (Some(false), None) => "no".into(),
        (None, None) => "–".into(),
    }
}

fn dash(words: String) -> String {
    if words.is_empty() { "–".into() } else { words }
}
