//! Tool files: the outline of a tool as its author writes it, in TOML, JSON or CSV.

use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::shape::{Piece, Shape};
use crate::AppError;
use crate::files::read_text;

/// What [`ToolFile::schema`] may say.
pub const TOOL_SCHEMA: &str = "soilctl.tool-file/1";

/// Most points of a tool: a curve of that many pieces is as smooth as meshes can tell.
const MAX_POINTS: usize = 100;

/// A tool in section, in metres: x in the direction in which it moves, y upwards, from anywhere. It is thin and rigid.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ToolFile {
    /// `soilctl.tool-file/1`, or left out.
    pub schema: Option<String>,
    /// What it is, in words.
    pub title: Option<String>,
    /// Points from the tip, which is what goes first into the ground, to the top; 2 to 100. Straight between them.
    pub points_m: Vec<[f64; 2]>,
    /// An arc in place of points.
    pub arc: Option<ArcEntry>,
    /// Friction angle between soil and tool; that of the request if left out.
    pub delta_deg: Option<f64>,
    /// Adhesion between them; that of the request if left out.
    pub adhesion_pa: Option<f64>,
    /// Pieces with an interface of their own.
    pub piece: Vec<PieceEntry>,
    /// Whether flat thin side plates close both ends of the tool: the hull of its points, which is what lies between it and straight lines over its
    /// hollows. They count where the tool has a width; in plane strain there are no ends.
    pub side_plates: bool,
    /// Corners of side plates of another outline, as seen from the side, in place of `side_plates = true`; 3 to 100, and their hull counts.
    pub side_plates_m: Vec<[f64; 2]>,
}

/// A circular arc from the tip to the top. Where the angle grows upwards the tool is hollow ahead, as the blade of a bulldozer is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ArcEntry {
    /// Radius, above 0.
    pub radius_m: f64,
    /// Tool angle of the tangent at the tip, from the horizontal.
    pub tip_alpha_deg: f64,
    /// Tool angle of the tangent at the top; from the other by at most 180 degrees.
    pub top_alpha_deg: f64,
    /// Straight pieces that stand for the arc, 1 to 99; their ends lie on it.
    #[serde(default = "pieces")]
    pub pieces: u32,
}

const fn pieces() -> u32 {
    8
}

/// What holds on one piece.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PieceEntry {
    /// Its number, from 1 at the tip.
    pub number: u32,
    /// Friction angle between soil and this piece.
    #[serde(default)]
    pub delta_deg: Option<f64>,
    /// Adhesion between them.
    #[serde(default)]
    pub adhesion_pa: Option<f64>,
}

/// A row of a tool file in CSV. The interface is that of the piece from this point to the next.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
struct PointRow {
    x_m: f64,
    y_m: f64,
    #[serde(default)]
    delta_deg: Option<f64>,
    #[serde(default)]
    adhesion_pa: Option<f64>,
}

impl ToolFile {
    /// Reads a tool file, as its name ends: .toml, .json or .csv.
    ///
    /// # Errors
    /// [`AppError::File`] if it cannot be read, [`AppError::Request`] if it is no tool file.
    pub fn read(path: &Path) -> Result<Self, AppError> {
        let wrong = |problem: &str| AppError::Request(format!("{}: {}", path.display(), problem.trim_end()));
        let ending = path.extension().and_then(|e| e.to_str()).unwrap_or("").to_ascii_lowercase();
        let text = || read_text(path);
        let file: Self = match ending.as_str() {
            "toml" => toml::from_str(&text()?).map_err(|e| wrong(&e.to_string()))?,
            "json" => serde_json::from_str(&text()?).map_err(|e| wrong(&e.to_string()))?,
            "csv" => Self::from_csv(&text()?).map_err(|e| wrong(&e))?,
            _ => return Err(wrong("the name of a tool file ends in .toml, .json or .csv")),
        };
        file.check().map_err(|problem| wrong(&problem))?;
        Ok(file)
    }

    fn from_csv(text: &str) -> Result<Self, String> {
        let mut file = Self::default();
        let mut reader =
            csv::ReaderBuilder::new().trim(csv::Trim::All).comment(Some(b'#')).from_reader(text.as_bytes());
        for (index, row) in reader.deserialize::<PointRow>().enumerate() {
            let row = row.map_err(|e| e.to_string())?;
            file.points_m.push([row.x_m, row.y_m]);
            if row.delta_deg.is_some() || row.adhesion_pa.is_some() {
                let number = u32::try_from(index + 1).unwrap_or(u32::MAX);
                file.piece.push(PieceEntry {
                    number,
                    delta_deg: row.delta_deg,
                    adhesion_pa: row.adhesion_pa,
                });
            }
        }
        let last = u32::try_from(file.points_m.len()).unwrap_or(u32::MAX);
        if file.piece.last().is_some_and(|piece| piece.number == last) {
            return Err("the last row has an interface, but no piece begins there; leave it empty".into());
        }
        Ok(file)
    }

    fn check(&self) -> Result<(), String> {
        if let Some(other) = self.schema.as_ref().filter(|s| *s != TOOL_SCHEMA) {
            return Err(format!("schema is \"{other}\", this version reads \"{TOOL_SCHEMA}\""));
        }
        self.check_side_plates()?;
        if let Some(arc) = &self.arc {
            return arc.check(self.points_m.is_empty());
        }
        let count = self.points_m.len();
        if !(2..=MAX_POINTS).contains(&count) {
            return Err(format!(
                "it has {count} points_m; a tool has 2 to {MAX_POINTS} from tip to top, or an arc"
            ));
        }
        Ok(())
    }

    fn check_side_plates(&self) -> Result<(), String> {
        let count = self.side_plates_m.len();
        if count == 0 {
            return Ok(());
        }
        if self.side_plates {
            return Err(
                "it has both side_plates and side_plates_m; keep side_plates_m if they have an outline of their own".into()
            );
        }
        if !(3..=MAX_POINTS).contains(&count) {
            return Err(format!(
                "it has {count} side_plates_m; side plates have 3 to {MAX_POINTS} corners, as seen from the side"
            ));
        }
        match self.side_plates_m.iter().flatten().find(|x| x.is_nan() || x.abs() > 1e6) {
            Some(x) => Err(format!("a corner of side_plates_m is at {x} m; give it within 1e6 m")),
            None => Ok(()),
        }
    }

    /// Whether it has side plates of any outline.
    pub(super) fn has_side_plates(&self) -> bool {
        self.side_plates || !self.side_plates_m.is_empty()
    }

    /// The tool as it is drawn, with what the request says of interfaces that the file leaves out.
    ///
    /// # Errors
    /// [`AppError::Request`] for interfaces that are missing or wrong, and for a tool that meets itself.
    pub(super) fn shape(&self, delta_deg: Option<f64>, adhesion_pa: f64) -> Result<Shape, AppError> {
        let points = self.arc.as_ref().map_or_else(|| self.points_m.clone(), ArcEntry::points);
        let count = points.len().saturating_sub(1);
        for (index, entry) in self.piece.iter().enumerate() {
            let number = entry.number;
            if !(1..=count).contains(&(number as usize)) {
                return Err(AppError::Request(format!(
                    "a [[piece]] of the tool has the number {number}; the tool has pieces 1 to {count}, from its tip"
                )));
            }
            if self.piece[..index].iter().any(|other| other.number == number) {
                return Err(AppError::Request(format!(
                    "piece {number} of the tool is there twice; keep one"
                )));
            }
        }
        let piece = |(index, ends): (usize, &[[f64; 2]])| {
            let own = self.piece.iter().find(|entry| entry.number as usize == index + 1);
            let delta = own.and_then(|own| own.delta_deg).or(self.delta_deg).or(delta_deg);
            let Some(delta_deg) = delta else {
                return Err(AppError::Request(format!(
                    "piece {} of the tool has no friction angle; give --delta DEG, or delta_deg in the tool file",
                    index + 1
                )));
            };
            let adhesion = own.and_then(|own| own.adhesion_pa).or(self.adhesion_pa);
            Ok(Piece { ends: [ends[0], ends[1]], delta_deg, adhesion_pa: adhesion.unwrap_or(adhesion_pa) })
        };
        let pieces = points.windows(2).enumerate().map(piece).collect::<Result<Vec<_>, _>>()?;
        let off_arc_m = self.arc.as_ref().map_or(0.0, ArcEntry::sagitta_m);
        let sides = if self.side_plates { &points } else { &self.side_plates_m };
        Ok(Shape::new(pieces, off_arc_m)?.with_side_plates(sides))
    }
}

impl ArcEntry {
    fn check(&self, is_alone: bool) -> Result<(), String> {
        if !is_alone {
            return Err("it has both points_m and an arc; keep one of them".into());
        }
        let turn = self.top_alpha_deg - self.tip_alpha_deg;
        if !(self.radius_m.is_finite() && self.radius_m > 0.0) {
            return Err(format!("radius_m of the arc is {}; it must be above 0 m", self.radius_m));
        }
        if !(turn.is_finite() && turn != 0.0 && turn.abs() <= 180.0) {
            return Err(format!(
                "the arc turns from {} to {} deg; it must turn by more than 0 and at most 180 deg",
                self.tip_alpha_deg, self.top_alpha_deg
            ));
        }
        if !(1..MAX_POINTS).contains(&(self.pieces as usize)) {
            return Err(format!("pieces of the arc is {}; it must be 1 to {}", self.pieces, MAX_POINTS - 1));
        }
        Ok(())
    }

    /// Points on the arc. Upwards along the tool the tangent is `(-cos alpha, sin alpha)`.
    fn points(&self) -> Vec<[f64; 2]> {
        let [from, to] = [self.tip_alpha_deg, self.top_alpha_deg].map(f64::to_radians);
        let radius = self.radius_m * (to - from).signum();
        let at = |part: u32| {
            let (sin, cos) = (from + (to - from) * f64::from(part) / f64::from(self.pieces)).sin_cos();
            [radius * (from.sin() - sin), radius * (from.cos() - cos)]
        };
        (0..=self.pieces).map(at).collect()
    }

    /// How far the pieces are from the arc at most.
    fn sagitta_m(&self) -> f64 {
        let turn = (self.top_alpha_deg - self.tip_alpha_deg).to_radians() / f64::from(self.pieces);
        self.radius_m * (1.0 - (0.5 * turn).cos())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(name: &str, text: &str) -> Result<ToolFile, AppError> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        ToolFile::read(&path)
    }

    #[test]
    fn the_same_tool_in_all_forms() {
        let toml = "points_m = [[0.1, 0], [0, 0], [0, 0.2]]\n[[piece]]\nnumber = 1\ndelta_deg = 12\n";
        let json = r#"{"points_m": [[0.1, 0], [0, 0], [0, 0.2]], "piece": [{"number": 1, "delta_deg": 12}]}"#;
        let csv = "x_m, y_m, delta_deg\n# the bottom\n0.1, 0, 12\n0, 0,\n0, 0.2,\n";
        let tool = read("a.toml", toml).unwrap();
        assert_eq!(tool, read("a.json", json).unwrap());
        assert_eq!(tool, read("a.csv", csv).unwrap());
        let shape = tool.shape(Some(20.0), 0.0).unwrap();
        let deltas: Vec<f64> = shape.pieces().iter().map(|piece| piece.delta_deg).collect();
        assert_eq!(deltas, [12.0, 20.0]);
    }

    #[test]
    fn what_makes_no_sense_is_refused() {
        for (name, text, words) in [
            ("a.txt", "", "ends in .toml, .json or .csv"),
            ("a.toml", "points_m = [[0, 0]]", "it has 1 points_m"),
            ("a.toml", "points = [[0, 0]]", "unknown field"),
            (
                "a.toml",
                "points_m = [[0, 0], [0, 1]]\nside_plates_m = [[0, 0], [1, 0]]",
                "it has 2 side_plates_m",
            ),
            (
                "a.toml",
                "points_m = [[0, 0], [0, 1]]\nside_plates_m = [[0, 0], [1, 0], [0, nan]]",
                "is at NaN m",
            ),
            (
                "a.toml",
                "points_m = [[0, 0], [0, 1]]\nside_plates = true\nside_plates_m = [[0, 0], [1, 0], [0, 1]]",
                "both side_plates and",
            ),
            ("a.toml", "schema = \"x\"", "schema is \"x\""),
            ("a.toml", "[arc]\nradius_m = 0\ntip_alpha_deg = 30\ntop_alpha_deg = 90", "above 0 m"),
            ("a.toml", "[arc]\nradius_m = 1\ntip_alpha_deg = 30\ntop_alpha_deg = 30", "it must turn"),
            ("a.csv", "x_m,y_m,delta_deg\n0,0,\n0,1,5\n", "no piece begins there"),
            ("a.csv", "x_m,z_m\n0,0\n", "field"),
        ] {
            let problem = read(name, text).unwrap_err().to_string();
            assert!(problem.contains(words), "{text}: {problem}");
        }
        let tool = read("a.toml", "points_m = [[0, 0], [0, 1]]\n[[piece]]\nnumber = 2").unwrap();
        assert!(tool.shape(Some(1.0), 0.0).unwrap_err().to_string().contains("pieces 1 to 1"));
        let tool = read("a.toml", "points_m = [[0, 0], [0, 1]]").unwrap();
        assert!(tool.shape(None, 0.0).unwrap_err().to_string().contains("--delta"));
    }

    #[test]
    fn an_arc_has_its_radius_tangents_and_hollow_side() {
        let arc = ArcEntry { radius_m: 0.3, tip_alpha_deg: 40.0, top_alpha_deg: 100.0, pieces: 60 };
        let points = arc.points();
        let (sin, cos) = 40f64.to_radians().sin_cos();
        // The centre is ahead of the tip, at right angles to its tangent.
        let centre = [0.3 * sin, 0.3 * cos];
        for p in &points {
            assert!(((p[0] - centre[0]).hypot(p[1] - centre[1]) - 0.3).abs() < 1e-12);
        }
        // The first piece is half a degree steeper than the tangent.
        let first = (points[1][1] - points[0][1]).atan2(points[0][0] - points[1][0]).to_degrees();
        assert!((first - 40.5).abs() < 1e-9);
        assert!((arc.sagitta_m() - 0.3 * (1.0 - 0.5f64.to_radians().cos())).abs() < 1e-12);
    }
}
