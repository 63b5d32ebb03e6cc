//! The table of proven bounds that is built in: `data/plate_bounds.csv`, made by `soilctl table build`.

use crate::EarthPressureError;
use crate::table::{BracketModel, BracketTable, parse_bracket};

const CSV: &str = include_str!("../../../../data/plate_bounds.csv");
const SIDECAR: &str = include_str!("../../../../data/plate_bounds.csv.json");

/// Lower and upper bounds on the 287 sets of Appendix C, by finite-element limit analysis, each proven with interval
/// arithmetic.
///
/// # Errors
/// [`EarthPressureError::BadTable`] if the built-in file is damaged, which a test rules out.
pub fn plate_bounds() -> Result<BracketTable, EarthPressureError> {
    Ok(parse_bracket("plate_bounds.csv", CSV, SIDECAR)?.0)
}

/// Model `table`: the bracket between the two.
///
/// # Errors
/// As [`plate_bounds`].
pub(crate) fn bracket() -> Result<BracketModel, EarthPressureError> {
    let reference = "bracket of certified limit-analysis bounds (soilctl table build), moved outwards by the \
                     interpolation margin";
    BracketModel::of("table", reference, &plate_bounds()?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_built_in_table_is_whole_and_proven() {
        let table = plate_bounds().unwrap();
        assert_eq!(table.rows().len(), 287);
        assert!(table.rows().iter().all(|row| row.certified && row.lower < row.upper));
    }
}
