//! The drawing of a problem file, read from its data.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod common;

use std::collections::BTreeMap;

use common::soilctl;

/// Ground water behind a wall that stands in open water, two loads, of which one is cut by a change of soil, and an earthquake.
const CANAL: &str = r#"
title = "sheet wall beside a canal"
surcharge_kpa = 10
default_boundary = "free"
objective = { kind = "load" }
water = { table = [[-10, -1], [0, -1], [0.01, -0.5], [12, -0.5]] }
seismic = { kh = 0.1 }
soil = [
  { name = "sand", phi_deg = 33, cohesion_kpa = 2, unit_weight_kn_m3 = 19 },
  { name = "silt", phi_deg = 30, cohesion_kpa = 4, unit_weight_kn_m3 = 19 },
  { name = "clay", phi_deg = 20, cohesion_kpa = 15, unit_weight_kn_m3 = 19 },
]
region = [
  { soil = "silt", polygon = [[-10, 0], [-4, 0], [-4, -3], [-10, -3]] },
  { soil = "sand", polygon = [[-4, 0], [0, 0], [0, -3], [-4, -3]] },
  { soil = "clay", polygon = [[-10, -3], [-4, -3], [0, -3], [12, -3], [12, -7], [-10, -7]] },
]
boundary = [
  { kind = "fixed", sides = ["bottom"] },
  { kind = "smooth", sides = ["left", "right"] },
  { kind = "load", line = [[-5, 0], [-2, 0]], pressure_kpa = [20, 60], shear_kpa = 5, live = true },
  { kind = "load", line = [[6, -3], [9, -3]], pressure_kpa = 50 },
]
plate = [{ name = "sheet wall", line = [[0, 0.5], [0, -5]], delta_deg = 15, held = "fixed" }]
"#;

/// A layer of the figure's data: its kind, and the points of each part and ring.
#[derive(Default)]
struct Layer {
    kind: String,
    rings: BTreeMap<(String, String), Vec<[f64; 2]>>,
}

impl Layer {
    /// The area of all rings; those of holes are told apart by their number.
    fn area(&self) -> f64 {
        let of = |ring: &[[f64; 2]]| -> f64 {
            let next = ring.iter().cycle().skip(1);
            ring.iter().zip(next).map(|(a, b)| 0.5 * (a[0] * b[1] - b[0] * a[1])).sum()
        };
        self.rings.iter().map(|((_, ring), p)| if ring == "0" { of(p).abs() } else { -of(p).abs() }).sum()
    }

    /// Length from corner to corner, of all rings.
    fn length(&self) -> f64 {
        let steps = self.rings.values().flat_map(|ring| ring.windows(2));
        steps.map(|s| (s[1][0] - s[0][0]).hypot(s[1][1] - s[0][1])).sum()
    }
}

/// What a CSV file draws, by name.
fn drawn(text: &str) -> BTreeMap<String, Layer> {
    let mut layers: BTreeMap<String, Layer> = BTreeMap::new();
    for row in text.lines().skip(1) {
        // Only names have quotes and commas in them.
        let quoted: Vec<&str> = row.split('"').collect();
        let (name, kind, rest) = match &quoted[..] {
            [before, name, after, ..] => (*name, before.split(',').nth(1).unwrap(), &after[1..]),
            _ => {
                let cells: Vec<&str> = row.splitn(4, ',').collect();
                (cells[2], cells[1], cells[3])
            }
        };
        let cells: Vec<&str> = rest.split(',').collect();
        let layer = layers.entry(name.to_owned()).or_default();
        kind.clone_into(&mut layer.kind);
        let point = [cells[2], cells[3]].map(|x| x.parse::<f64>().unwrap());
        assert!(point.iter().all(|x| x.is_finite()), "{row}");
        layer.rings.entry((cells[0].to_owned(), cells[1].to_owned())).or_default().push(point);
    }
    layers
}

#[test]
fn all_that_a_file_says_is_drawn_named_and_in_its_place() {
    let dir = tempfile::tempdir().unwrap();
    let [problem, figure] = ["canal.toml", "canal.csv"].map(|name| dir.path().join(name));
    std::fs::write(&problem, CANAL).unwrap();
    let [problem, path] = [&problem, &figure].map(|path| path.to_str().unwrap());
    let done = soilctl(&["solve", problem, "--check", "--plot", path]);
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let layers = drawn(&std::fs::read_to_string(path).unwrap());
    let layer =
        |name: &str| layers.get(name).unwrap_or_else(|| panic!("{name} is not in {:?}", layers.keys()));
    for (name, area) in [
        ("sand: φ 33°, c 2 kPa, 19 kN/m³", 12.0),
        ("silt: φ 30°, c 4 kPa, 19 kN/m³", 18.0),
        ("clay: φ 20°, c 15 kPa, 19 kN/m³", 88.0),
    ] {
        assert!((layer(name).area() - area).abs() < 1e-9, "{name}: {}", layer(name).area());
    }
    // From the bed at -3 up to -0.5, but for the step of the table beside the wall; also over the load.
    let water = layer("open water").area();
    assert!((29.98..30.0).contains(&water), "{water}");
    assert!((22.0..22.6).contains(&layer("water table").length()));
    for (name, length) in [("rigid structure", 5.5), ("smooth side: slides along", 11.0)] {
        assert!((layer(name).length() - length).abs() < 1e-9, "{name}");
    }
    assert_eq!(layer("load").kind, "paths");
    for text in ["20 to 60 kPa, shear 5 kPa", "50 kPa", "sheet wall (held fixed)", "earthquake, kh = 0.1"] {
        assert_eq!(layer(text).kind, "text", "{text}");
    }
    // The held wall is fixed too, on its sides.
    for name in
        ["free surface", "fixed base and side: no motion", "surcharge 10 kPa", "load whose factor is bounded"]
    {
        assert!(!layer(name).rings.is_empty());
    }
}

#[test]
fn every_example_is_drawn_in_every_form() {
    let dir = tempfile::tempdir().unwrap();
    let problems = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/problems");
    for problem in std::fs::read_dir(problems).unwrap() {
        let problem = problem.unwrap().path();
        for form in ["svg", "png", "csv"] {
            let figure = dir.path().join(format!("a.{form}"));
            let [problem, figure] = [&problem, &figure].map(|path| path.to_str().unwrap());
            let done = soilctl(&["solve", problem, "--check", "--plot", figure]);
            assert!(done.status.success(), "{problem}: {}", String::from_utf8_lossy(&done.stderr));
            assert!(std::fs::metadata(figure).unwrap().len() > 1000, "{problem} {form}");
        }
        let layers = drawn(&std::fs::read_to_string(dir.path().join("a.csv")).unwrap());
        for name in ["kN/m³", "free surface"] {
            assert!(layers.keys().any(|key| key.contains(name)), "{}: {name}", problem.display());
        }
    }
}
