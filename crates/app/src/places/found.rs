//! Strokes put to their places, and what they say there.

use soilctl_strokes::{Campaign, ReadOptions, StrokeRow, StrokeTable};

use super::request::Request;
use crate::AppError;
use crate::estimate::{self, Estimation};
use crate::text::number;

/// Most places: pairs grow with their square.
const MOST_PLACES: usize = 200;
/// Strokes of one name are at one place if they are no farther apart than this, in m: the length of some strokes.
const ONE_PLACE_M: f64 = 2.0;

/// A place with what its strokes say.
pub(super) struct Place {
    pub(super) name: String,
    /// x and y in m.
    pub(super) at: Option<[f64; 2]>,
    pub(super) rows: Vec<StrokeRow>,
    pub(super) found: Estimation,
}

/// The table of all strokes.
pub(super) struct Table {
    name: String,
    campaign: Campaign,
}

impl Table {
    /// The estimate of some strokes of the table.
    pub(super) fn estimate(
        &self,
        request: &Request,
        of: &str,
        rows: &[StrokeRow],
    ) -> Result<Estimation, AppError> {
        let table = StrokeTable::new(&format!("{} (strokes of {of} alone)", self.name), rows)?;
        estimate::of_part(&request.estimate.request(&request.file), table, self.campaign.clone())
    }
}

/// Strokes by place, with the estimate of each.
pub(super) fn places(request: &Request) -> Result<(Table, Vec<Place>), AppError> {
    let strokes = request.file.strokes(ReadOptions::default())?;
    let table = Table { name: strokes.name().to_owned(), campaign: request.file.campaign()? };
    let mut grouped: Vec<(String, Vec<StrokeRow>)> = Vec::new();
    for row in strokes.rows() {
        let name = name(&table, &row)?;
        match grouped.iter_mut().find(|(known, _)| *known == name) {
            Some((_, rows)) => rows.push(row),
            None => grouped.push((name, vec![row])),
        }
    }
    match grouped.len() {
        1 => {
            return Err(AppError::Request(format!(
                "{} has one place; places takes two and more, and estimate answers for one",
                table.name
            )));
        }
        count if count > MOST_PLACES => {
            return Err(AppError::Request(format!(
                "{} has {count} places, the limit is {MOST_PLACES}; strokes at one place need one name in the column place",
                table.name
            )));
        }
        _ => {}
    }
    let places = grouped.into_iter().map(|(name, rows)| {
        let at = coordinates(&table, &name, &rows)?;
        let found = table.estimate(request, &name, &rows)?;
        Ok(Place { name, at, rows, found })
    });
    let places = places.collect::<Result<Vec<_>, AppError>>()?;
    Ok((table, places))
}

/// The name of the place of a stroke; of one without a name its coordinates.
fn name(table: &Table, row: &StrokeRow) -> Result<String, AppError> {
    match (row.place.as_deref().filter(|name| !name.is_empty()), row.place_x_m, row.place_y_m) {
        (Some(name), ..) => Ok(name.to_owned()),
        (None, Some(x), Some(y)) => Ok(format!("({}, {}) m", number(x), number(y))),
        (None, ..) => Err(AppError::Request(format!(
            "{}, line {}: the stroke has no place; fill the column place, or both place_x_m and place_y_m",
            table.name, row.line
        ))),
    }
}

/// Where the strokes of a place are: their mean; `None` if none says where.
fn coordinates(table: &Table, name: &str, rows: &[StrokeRow]) -> Result<Option<[f64; 2]>, AppError> {
    let known: Vec<[f64; 2]> = rows.iter().filter_map(|row| Some([row.place_x_m?, row.place_y_m?])).collect();
    if known.is_empty() {
        return Ok(None);
    }
    let mean = [0, 1].map(|d| known.iter().map(|at| at[d]).sum::<f64>() / known.len() as f64);
    let off = known.iter().map(|at| libm::hypot(at[0] - mean[0], at[1] - mean[1])).fold(0.0, f64::max);
    if off > ONE_PLACE_M {
        return Err(AppError::Request(format!(
            "{}: strokes of place {name} are up to {} m from their middle, more than {ONE_PLACE_M} m; give places that lie apart names of their \
             own",
            table.name,
            number(off)
        )));
    }
    Ok(Some(mean))
}
