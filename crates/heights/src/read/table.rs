//! A table with a point a row.

use crate::HeightsError;

/// The most points that are read.
const MOST_POINTS: usize = 10_000_000;
const COLUMNS: [&str; 3] = ["x_m", "y_m", "z_m"];

/// The points of a table with the columns `x_m`, `y_m`, `z_m`; others are passed over. Rows whose height is empty or NaN have no point;
/// how many they are.
pub(super) fn points(text: &str, file: &str) -> Result<(Vec<[f64; 3]>, usize), HeightsError> {
    let mut reader =
        csv::ReaderBuilder::new().trim(csv::Trim::All).comment(Some(b'#')).from_reader(text.as_bytes());
    let wrong = |line: u64, reason: String| HeightsError::Line { file: file.to_owned(), line, reason };
    let at = |error: csv::Error| wrong(error.position().map_or(1, csv::Position::line), error.to_string());
    let header = reader.headers().map_err(at)?.clone();
    let mut places = [0; 3];
    for (place, name) in places.iter_mut().zip(COLUMNS) {
        let found = header.iter().position(|column| column.trim_start_matches('\u{feff}') == name);
        *place = found.ok_or_else(|| {
            wrong(1, format!("there is no column {name}; a height map has x_m, y_m and z_m, in m"))
        })?;
    }
    let (mut points, mut missing) = (Vec::new(), 0);
    let mut record = csv::StringRecord::new();
    while reader.read_record(&mut record).map_err(at)? {
        let line = record.position().map_or(0, csv::Position::line);
        let mut point = [0.0; 3];
        for ((value, place), name) in point.iter_mut().zip(places).zip(COLUMNS) {
            let cell = record.get(place).unwrap_or_default();
            let number = if cell.is_empty() && name == "z_m" { Some(f64::NAN) } else { cell.parse().ok() };
            let allowed = |x: &f64| x.is_finite() || (name == "z_m" && x.is_nan());
            *value = number
                .filter(allowed)
                .ok_or_else(|| wrong(line, format!("{name} is `{cell}`; it must be a number, in m")))?;
        }
        if point[2].is_nan() {
            missing += 1;
        } else {
            points.push(point);
        }
        if points.len() > MOST_POINTS {
            let (count, most) = (points.len() as u64, MOST_POINTS as u64);
            return Err(HeightsError::TooLarge { file: file.to_owned(), what: "points", count, most });
        }
    }
    Ok((points, missing))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn columns_by_their_names() {
        let (found, missing) = points("# scan\nz_m, n, x_m,y_m\n3,a,1,2\n,b,1,3\nnan,c,1,4\n", "f").unwrap();
        assert_eq!((found, missing), (vec![[1.0, 2.0, 3.0]], 2));
        for (text, word) in [
            ("x,y,z\n1,2,3\n", "no column x_m"),
            ("x_m,y_m,z_m\n1,2,3\n1,,3\n", "f, line 3: y_m is ``"),
            ("x_m,y_m,z_m\n1,2,inf\n", "z_m is `inf`"),
            ("x_m,y_m,z_m\n1,2\n", "line 2"),
            ("", "no column x_m"),
        ] {
            let problem = points(text, "f").unwrap_err().to_string();
            assert!(problem.contains(word), "{text}: {problem}");
        }
    }
}
