//! ESRI's ASCII grid: a header of names and numbers, then the heights, the northern row first.

use std::collections::BTreeMap;

use crate::{Grid, HeightMap, HeightsError, MOST_CELLS};

const NAMES: [&str; 8] =
    ["ncols", "nrows", "xllcorner", "xllcenter", "yllcorner", "yllcenter", "cellsize", "nodata_value"];
/// No data, if the header does not say.
const NO_DATA: f64 = -9999.0;

/// Whether a text begins like one.
pub(super) fn is_grid(text: &str) -> bool {
    text.split_whitespace().next().is_some_and(|word| NAMES.contains(&word.to_ascii_lowercase().as_str()))
}

pub(super) fn read(text: &str, file: &str) -> Result<HeightMap, HeightsError> {
    let wrong =
        |line: usize, reason: String| HeightsError::Line { file: file.to_owned(), line: line as u64, reason };
    let mut header: BTreeMap<String, f64> = BTreeMap::new();
    let mut heights = Vec::new();
    let mut cells = None;
    for (line, row) in (1..).zip(text.lines()) {
        let mut words = row.split_whitespace().peekable();
        let name = words.peek().map(|word| word.to_ascii_lowercase()).unwrap_or_default();
        if heights.is_empty() && name.starts_with(|c: char| c.is_ascii_alphabetic()) && name != "nan" {
            if !NAMES.contains(&name.as_str()) {
                return Err(wrong(
                    line,
                    format!("`{name}` is no key of a grid's header; they are {}", NAMES.join(", ")),
                ));
            }
            let value = words.nth(1).and_then(|word| word.parse().ok()).filter(|x: &f64| !x.is_infinite());
            let value = value.ok_or_else(|| wrong(line, format!("`{name}` has no number")))?;
            header.insert(name, value);
            continue;
        }
        let most = match cells {
            Some(most) => most,
            None => *cells.insert(size(&header, file)?.iter().product::<usize>()),
        };
        let no_data = header.get("nodata_value").copied().unwrap_or(NO_DATA);
        for word in words {
            let height: f64 = word.parse().map_err(|_| wrong(line, format!("`{word}` is no height")))?;
            heights.push(Some(height).filter(|z| *z != no_data && !z.is_nan()));
        }
        if heights.len() > most {
            return Err(wrong(line, format!("there are more heights than the {most} cells of the header")));
        }
    }
    let [columns, rows] = size(&header, file)?;
    if heights.len() != columns * rows {
        let reason = format!("it ends after {} of {} heights", heights.len(), columns * rows);
        return Err(HeightsError::format(file, reason));
    }
    let cell = header.get("cellsize").copied().filter(|cell| *cell > 0.0);
    let cell = cell.ok_or_else(|| HeightsError::format(file, "its header has no cellsize above 0"))?;
    let [left, below] = ["x", "y"].map(|axis| {
        let corner = header.get(&format!("{axis}llcorner")).map(|corner| corner + 0.5 * cell);
        corner.or(header.get(&format!("{axis}llcenter")).copied())
    });
    let (Some(left), Some(below)) = (left, below) else {
        return Err(HeightsError::format(file, "its header has no xllcorner and yllcorner, nor centres"));
    };
    let origin = [left, below + (rows - 1) as f64 * cell];
    HeightMap::new(Grid::new([columns, rows], origin, [cell, 0.0], [0.0, -cell])?, heights)
}

fn size(header: &BTreeMap<String, f64>, file: &str) -> Result<[usize; 2], HeightsError> {
    let count = |name: &str| {
        let count =
            header.get(name).copied().filter(|x| (1.0..=MOST_CELLS as f64).contains(x) && x.fract() == 0.0);
        count.map(|count| count as usize).ok_or_else(|| {
            HeightsError::format(
                file,
                format!("its header has no {name}, a whole number from 1 to {MOST_CELLS}"),
            )
        })
    };
    let [columns, rows] = [count("ncols")?, count("nrows")?];
    if columns * rows > MOST_CELLS {
        let (count, most) = ((columns * rows) as u64, MOST_CELLS as u64);
        return Err(HeightsError::TooLarge { file: file.to_owned(), what: "cells", count, most });
    }
    Ok([columns, rows])
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    const GRID: &str =
        "ncols 3\nnrows 2\nxllcorner 10\nyllcorner 20\ncellsize 0.5\nNODATA_value -1\n1 2 3\n4 -1 6\n";

    /// As ESRI says: the first row is the northern one, and the corner is that of the cell, not its centre.
    #[test]
    fn the_first_row_is_north() {
        let map = read(GRID, "g").unwrap();
        assert!(is_grid(GRID) && !is_grid("x_m,y_m,z_m\n"));
        assert_eq!(map.height_m([10.25, 20.75]), Some(1.0));
        assert_eq!(map.height_m([11.25, 20.25]), Some(6.0));
        assert_eq!(map.height_m([10.75, 20.25]), None);
        let centre = GRID.replace("corner", "center");
        assert_eq!(read(&centre, "g").unwrap().height_m([10.0, 20.5]), Some(1.0));
    }

    #[test]
    fn what_makes_no_sense_is_refused() {
        for (from, to, word) in [
            ("ncols 3", "ncols 2.5", "no ncols"),
            ("ncols 3", "ncols 3e300", "no ncols"),
            ("ncols 3", "ncols 10000\nnrows 10000\ncellsize 1", "are read"),
            ("nrows 2", "nrows 3", "ends after 6 of 9"),
            ("nrows 2", "nrows 1", "more heights"),
            ("cellsize 0.5", "cellsize", "no number"),
            ("cellsize 0.5", "cellsize 0", "no cellsize above 0"),
            ("cellsize 0.5", "cellsize -0.5", "no cellsize above 0"),
            ("cellsize 0.5", "cellsize 5000", "side of a cell"),
            ("cellsize 0.5", "cells 0.5", "no key"),
            ("xllcorner 10\n", "", "no xllcorner"),
            ("6", "six", "`six` is no height"),
            ("6", "1e30", "within 9000 m"),
        ] {
            // A second nrows would overrule what is tested.
            let text = if to.contains("nrows") && from != "nrows 2" {
                GRID.replace("nrows 2\n", "")
            } else {
                GRID.to_owned()
            };
            let problem = read(&text.replace(from, to), "g").unwrap_err().to_string();
            assert!(problem.contains(word), "{to}: {problem}");
        }
    }
}
