//! Whether the soil is the same at several places, what it is at each, and what lies between.

mod answer;
mod between;
mod files;
mod found;
mod pairs;
mod request;
mod words;

use soilctl_ground::groups;

pub use answer::{Answer, Between, By, Cell, Covariance, Group, Pair, PlaceFound};
use found::{Place, Table};
pub use request::Request;

use crate::estimate::Estimation;
use crate::{AppError, Watch, files as disk, request as requests};

/// Estimates at each place, compares, pools and interpolates; writes the files that were asked for.
///
/// # Errors
/// [`AppError`] if the request or the table makes no sense, or a file cannot be read or written. That no soil explains the strokes of a place
/// is an answer.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    requests::check(request)?;
    let origin = request.origin()?;
    for path in request.geojson.iter().chain(&request.cells) {
        disk::can_be_written(path)?;
    }
    let (table, places) = found::places(request)?;
    watch.begin(2, "places");
    let pairs = pairs::pairs(request, &places)?;
    watch.advance(1);
    let (groups, refused) = pooled(request, &table, &places, &pairs)?;
    watch.advance(1);
    watch.end();
    let between = between::between(request, &places)?;
    let mut answer = answer(request, &places, pairs, groups)?;
    let missing = between.as_ref().err().cloned();
    answer.between = between.ok();
    answer.verdict = words::verdict(&answer);
    answer.warnings = words::warnings(&answer, &places, missing, &refused);
    if let Some(path) = &request.geojson {
        disk::save(path, files::geojson(&answer, origin)?.as_bytes())?;
    }
    if let Some(path) = &request.cells {
        disk::save(path, files::cells(&answer)?.as_bytes())?;
    }
    Ok(answer)
}

/// Places of one soil, as far as is known, with the estimate of all their strokes.
type Pooled = Vec<(Vec<usize>, Estimation)>;

/// Groups of places that no pair of which differs, and whose strokes some soil explains together; also sets of places whose pairs
/// do not differ, but whose strokes no soil explains together.
fn pooled(
    request: &Request,
    table: &Table,
    places: &[Place],
    pairs: &[Pair],
) -> Result<(Pooled, Vec<Vec<usize>>), AppError> {
    let known: Vec<usize> = (0..places.len()).filter(|i| places[*i].found.answer.consistent).collect();
    let of_pair = |i: usize, j: usize| {
        let (i, j) = (i.min(j), i.max(j));
        // Pairs are in the order of two loops over all places.
        i * (2 * places.len() - i - 1) / 2 + j - i - 1
    };
    let likeness = |a: usize, b: usize| {
        let pair = pairs.get(of_pair(known[a], known[b]))?;
        (!pair.differ).then(|| pair.p.unwrap_or(1.0))
    };
    let estimate = |members: &[usize]| {
        let rows: Vec<_> = members.iter().flat_map(|m| places[known[*m]].rows.iter().cloned()).collect();
        let names: Vec<&str> = members.iter().map(|m| places[known[*m]].name.as_str()).collect();
        table.estimate(request, &names.join(", "), &rows)
    };
    let mut refused = Vec::new();
    let together = |members: &[usize]| {
        let consistent = estimate(members)?.answer.consistent;
        if !consistent {
            refused.push(members.iter().map(|m| known[*m]).collect());
        }
        Ok::<bool, AppError>(consistent)
    };
    let found = groups(known.len(), likeness, together)?;
    let found = found.into_iter().map(|members| {
        let estimation = estimate(&members)?;
        Ok((members.iter().map(|m| known[*m]).collect(), estimation))
    });
    Ok((found.collect::<Result<_, AppError>>()?, refused))
}

fn answer(request: &Request, places: &[Place], pairs: Vec<Pair>, groups: Pooled) -> Result<Answer, AppError> {
    let Some(first) = places.first() else { return Err(AppError::Request("there is no place".into())) };
    let group_of = |place: usize| groups.iter().position(|(members, _)| members.contains(&place));
    let statistical = request.estimate.is_statistical();
    Ok(Answer {
        model: first.found.answer.model.clone(),
        ends: first.found.answer.ends,
        confidence: statistical.then_some(request.estimate.confidence),
        false_discovery: statistical.then_some(request.false_discovery),
        places: places.iter().enumerate().map(|(i, place)| PlaceFound::of(place, group_of(i))).collect(),
        pairs,
        groups: groups
            .iter()
            .filter_map(|(members, found)| {
                Some(Group {
                    places: members.iter().map(|m| places[*m].name.clone()).collect(),
                    phi_deg: found.answer.phi_deg?,
                    density_kg_m3: found.answer.density_kg_m3?,
                    region: found.answer.region.clone(),
                })
            })
            .collect(),
        between: None,
        verdict: String::new(),
        warnings: Vec::new(),
    })
}

impl PlaceFound {
    fn of(place: &Place, group: Option<usize>) -> Self {
        let answer = &place.found.answer;
        Self {
            name: place.name.clone(),
            x_m: place.at.map(|at| at[0]),
            y_m: place.at.map(|at| at[1]),
            strokes: place.rows.len(),
            consistent: answer.consistent,
            phi_deg: answer.phi_deg,
            density_kg_m3: answer.density_kg_m3,
            delta_deg: answer.delta_deg,
            region: answer.region.clone(),
            group,
        }
    }
}
