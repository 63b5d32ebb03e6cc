//! Height maps that GDAL and tifffile wrote, those that are refused, and files made to do harm.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::path::{Path, PathBuf};

use soilctl_heights::{Format, HeightMap, HeightsError, Moment, Reading, Source, read};
use soilctl_mutants::{Random, in_time};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

fn reading() -> Reading {
    Reading { around_m: [101.0, 199.5], reach_m: 10.0, cell_m: None, topic: None, moment: Moment::Last }
}

fn open(path: &Path) -> Result<(HeightMap, Source), HeightsError> {
    read(path, &reading())
}

/// Cell (row j, column i) is `i / 8 - j / 4`, times `times`, with its centre where GDAL says that it is.
fn check(name: &str, format: Format, times: f64, place: impl Fn(f64, f64) -> [f64; 2]) {
    let (map, source) = open(&data(name)).unwrap();
    assert_eq!((source.format, map.grid().size(), map.seen()), (format, [6, 4], 23), "{name}");
    for j in 0..4 {
        for i in 0..6 {
            let place = place(f64::from(i), f64::from(j));
            let expected =
                if (i, j) == (2, 1) { None } else { Some(times * (f64::from(i) / 8.0 - f64::from(j) / 4.0)) };
            assert_eq!(map.height_m(place), expected, "{name} at {place:?}");
        }
    }
}

#[test]
fn maps_of_others() {
    let north_up = |i: f64, j: f64| [100.0 + 0.5 * (i + 0.5), 200.0 - 0.25 * (j + 0.5)];
    for name in ["plain.tif", "deflate.tif", "float_code.tif", "big.tif"] {
        check(name, Format::GeoTiff, 1.0, north_up);
    }
    // Its tie point is the centre of a cell, but GDAL moves what it is given by half of one, so that the place is the same.
    check("point.tif", Format::GeoTiff, 8.0, north_up);
    let turned = |i: f64, j: f64| {
        let (i, j) = (i + 0.5, j + 0.5);
        [0.4 * i + 0.15 * j + 100.0, 0.3 * i - 0.2 * j + 200.0]
    };
    check("turned.tif", Format::GeoTiff, 1.0, turned);
    check("grid.asc", Format::AsciiGrid, 1.0, |i, j| [100.0 + 0.5 * (i + 0.5), 200.0 - 0.5 * (j + 0.5)]);
}

#[test]
fn what_is_no_map_in_metres_is_refused() {
    for (name, words) in [
        ("degrees.tif", "degrees; project it to metres"),
        ("feet.tif", "unit EPSG 9003"),
        ("two_bands.tif", "not one height each"),
        ("nowhere.tif", "does not say where it is"),
        ("scales.tif", "a scale or an offset"),
        ("no_code.tif", "within 9000 m of zero; if it stands for no data"),
        ("zstd.tif", "as a TIFF"),
        ("make.py", "no column x_m"),
        ("missing.tif", "check the path"),
    ] {
        let problem = open(&data(name)).unwrap_err().to_string();
        assert!(problem.contains(words), "{name}: {problem}");
    }
    let far = Reading { around_m: [0.0, 0.0], ..reading() };
    let problem = read(&data("plain.tif"), &far).unwrap_err().to_string();
    assert!(
        problem.contains("no ground within 10 m of the plate") && problem.contains("100.25"),
        "{problem}"
    );
}

/// The same heights as points, in any order, are the same map; off the nodes they are put into cells.
#[test]
fn tables_of_points() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("points.csv");
    let (map, _) = open(&data("plain.tif")).unwrap();
    let mut rows: Vec<String> = map
        .heights_m()
        .iter()
        .enumerate()
        .filter_map(|(cell, z)| {
            let [x, y] = map.grid().place(cell);
            z.map(|z| format!("{x},{y},{z}\n"))
        })
        .collect();
    rows.rotate_left(9);
    std::fs::write(&path, format!("x_m,y_m,z_m\n{}", rows.concat())).unwrap();
    let (found, source) = open(&path).unwrap();
    assert_eq!(source.format, Format::Table);
    for cell in 0..map.grid().cells() {
        assert_eq!(found.height_m(map.grid().place(cell)), map.heights_m()[cell]);
    }
    let cells = Reading { cell_m: Some(1.0), ..reading() };
    let (found, source) = read(&path, &cells).unwrap();
    assert_eq!(
        (source.format, source.points, found.grid().size()),
        (Format::ScatteredTable, Some(23), [3, 1])
    );
    // Two columns of cells, of rows 0 to 3: i is 0 or 1, and the median is that of eight heights.
    assert_eq!((found.heights_m()[0], source.points_a_cell), (Some(-0.3125), Some(8)));
}

/// Clouds of the tests of `soilctl-bag`: (i / 8, j / 4, (i + j) / 16) without that of row 1, column 2.
#[test]
fn clouds_of_recordings() {
    for file in ["clouds.mcap", "clouds.bag"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../bag/tests/clouds").join(file);
        for (moment, second) in [
            (Moment::First, 0),
            (Moment::Last, 2),
            (Moment::At(1.5), 1),
            (Moment::At(0.0), 0),
            (Moment::At(1e300), 2),
        ] {
            let here = Reading { around_m: [0.0; 2], reach_m: 1.0, cell_m: Some(0.125), topic: None, moment };
            let (map, source) = read(&path, &here).unwrap();
            assert_eq!(source.time_ns, Some(1_700_000_000_000_000_000 + second * 1_000_000_000));
            assert_eq!((source.frame.as_str(), source.missing, source.points), ("bin", 1, Some(5)));
            assert_eq!(map.seen(), 5);
            assert_eq!(map.grid().cell_of([0.25, 0.25]).and_then(|cell| map.heights_m()[cell]), None);
            assert_eq!(map.height_m([0.1875, 0.0625]), Some(0.0625));
        }
        let wrong = Reading { topic: Some("/depth".into()), ..reading() };
        let problem = read(&path, &wrong).unwrap_err().to_string();
        assert!(problem.contains("no topic /depth") && problem.contains("/scan"), "{problem}");
        let problem = open(&path).unwrap_err().to_string();
        assert!(problem.contains("none of its 5 points is within 10 m"), "{problem}");
    }
}

#[test]
fn files_made_to_do_harm() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random(11);
    let mut read = 0;
    for name in ["plain.tif", "deflate.tif", "turned.tif", "point.tif", "big.tif", "grid.asc"] {
        let bytes = std::fs::read(data(name)).unwrap();
        for _ in 0..5 * soilctl_mutants::count() {
            let path = folder.path().join(name);
            std::fs::write(&path, random.mutant(&bytes)).unwrap();
            in_time(&path, || {
                if let Ok((map, _)) = open(&path) {
                    assert!(map.heights_m().iter().flatten().all(|z| z.is_finite()));
                    read += 1;
                }
            });
        }
    }
    assert!(read > 0);
}
