//! What lies between places.

use soilctl_estimator::{DENSITY_SEARCH_KG_M3, PHI_SEARCH_DEG};
use soilctl_ground::{Field, LEAST_SITES, Site, contains, convex_hull, next_places};
use soilctl_stats::normal_quantile;

use super::answer::{Between, Cell, Covariance};
use super::found::Place;
use super::request::Request;
use crate::AppError;
use crate::text::number;

/// Cells along the longer side of the ground, unless their size is given.
const CELLS: f64 = 30.0;
/// Most cells.
const MOST_CELLS: f64 = 20_000.0;

/// Kriging of the sets of places; a reason in words if there is nothing to krige.
pub(super) fn between(request: &Request, places: &[Place]) -> Result<Result<Between, String>, AppError> {
    let consistent = places.iter().filter(|place| place.found.answer.consistent);
    let known: Vec<(&Place, [f64; 2])> = consistent.filter_map(|place| Some((place, place.at?))).collect();
    if places.iter().all(|place| place.at.is_none()) {
        return Ok(Err(
            "the table has no coordinates of places (place_x_m, place_y_m), so nothing is said between them"
                .into(),
        ));
    }
    if known.len() < LEAST_SITES {
        return Ok(Err(format!(
            "{} places have coordinates and a set; what lies between is told from {LEAST_SITES} on",
            known.len()
        )));
    }
    let deviations = normal_quantile(0.5 * (1.0 - request.estimate.confidence));
    let field = |of: fn(&Place) -> Option<[f64; 2]>| {
        let sites = known.iter().filter_map(|(place, [x_m, y_m])| {
            let [low, high] = of(place)?;
            Some(Site { x_m: *x_m, y_m: *y_m, low, high })
        });
        Field::new(&sites.collect::<Vec<_>>(), deviations)
    };
    let phi = field(|place| place.found.answer.phi_deg)?;
    let density = field(|place| place.found.answer.density_kg_m3)?;
    let points: Vec<[f64; 2]> = known.iter().map(|(_, at)| *at).collect();
    let hull = convex_hull(&points);
    let (cell_m, middles) = grid(request, &points)?;
    let cell = |[x_m, y_m]: [f64; 2]| {
        let (of_phi, of_density) = (phi.at(x_m, y_m), density.at(x_m, y_m));
        Cell {
            x_m,
            y_m,
            phi_deg: within([of_phi.low, of_phi.high], PHI_SEARCH_DEG),
            density_kg_m3: within([of_density.low, of_density.high], DENSITY_SEARCH_KG_M3),
            phi_sd_deg: of_phi.sd,
            density_sd_kg_m3: of_density.sd,
            inside: contains(&hull, [x_m, y_m]),
        }
    };
    let cells: Vec<Cell> = middles.into_iter().map(cell).collect();
    let mut candidates: Vec<[f64; 2]> =
        cells.iter().filter(|cell| cell.inside).map(|cell| [cell.x_m, cell.y_m]).collect();
    if candidates.is_empty() {
        // Places on a line have no inside.
        candidates = cells.iter().map(|cell| [cell.x_m, cell.y_m]).collect();
    }
    let is_variation_open = phi.is_unbounded() || density.is_unbounded();
    let fields = [phi, density];
    let next_places = next_places(&fields, &candidates, request.next_places as usize);
    let [phi_covariances, density_covariances] = fields.map(|field| {
        field.variograms().map(|v| Covariance { length_m: v.length_m, sd: v.sd }).collect::<Vec<_>>()
    });
    Ok(Ok(Between {
        cell_m,
        hull,
        phi_covariances,
        density_covariances,
        is_variation_open,
        deviations,
        cells,
        next_places,
    }))
}

/// No soil is beyond what any estimate searches.
fn within([low, high]: [f64; 2], (least, most): (f64, f64)) -> [f64; 2] {
    [low.clamp(least, most), high.clamp(least, most)]
}

/// Side and middles of the cells over the places, and one cell around them.
fn grid(request: &Request, points: &[[f64; 2]]) -> Result<(f64, Vec<[f64; 2]>), AppError> {
    let ends = |d: usize| {
        let values = points.iter().map(|p| p[d]);
        values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
    };
    let (x, y) = (ends(0), ends(1));
    let longer = (x.1 - x.0).max(y.1 - y.0);
    let cell_m = request.cell_m.unwrap_or_else(|| round(longer / CELLS));
    let range = |(low, high): (f64, f64)| ((low / cell_m).floor() - 1.0, (high / cell_m).ceil() + 1.0);
    let (across, up) = (range(x), range(y));
    let count = (across.1 - across.0 + 1.0) * (up.1 - up.0 + 1.0);
    if count.is_nan() || count > MOST_CELLS {
        return Err(AppError::Request(format!(
            "--cell is {} m, which makes {} cells; the limit is {MOST_CELLS}, so take larger ones",
            number(cell_m),
            number(count)
        )));
    }
    let steps = |(low, high): (f64, f64)| (0..=(high - low) as usize).map(move |i| (low + i as f64) * cell_m);
    Ok((cell_m, steps(up).flat_map(|y| steps(across).map(move |x| [x, y])).collect()))
}

/// The next of 1, 2, 5, 10 ... from here.
fn round(value: f64) -> f64 {
    let decade = libm::pow(10.0, libm::log10(value).floor());
    let steps = [1.0, 2.0, 5.0, 10.0];
    steps.iter().map(|step| step * decade).find(|step| *step >= value * (1.0 - 1e-9)).unwrap_or(value)
}
