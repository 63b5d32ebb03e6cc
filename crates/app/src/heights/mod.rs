//! Height maps before and after a stroke: where the ground broke ahead of the plate, and the soil that was moved.

mod answer;
mod arm;
mod picture;
mod request;
mod words;

use std::path::Path;

use soilctl_heights::{
    Change, Cloud, Format as Kind, HeightMap, Moment, Plate, Reading, Source, Stroke, Volume, change, read,
    read_after, stroke,
};
use soilctl_motion::Motion;
use soilctl_strokes::{ReadOptions, StrokeRow, StrokeTable};

pub use answer::{
    Answer, BreakAnswer, Format, MapAnswer, PictureAnswer, PlateAnswer, ProfileAnswer, ShiftAnswer,
    VolumeAnswer,
};
pub(crate) use arm::into_root;
pub use request::Request;

use crate::{AppError, Interrupted, Watch, files, request as requests};

/// Widths of the plate that are looked at around it.
const REACH: f64 = 10.0;
/// Standard deviations in `within_m`.
const WITHIN: f64 = 2.0;

/// Compares two maps of the ground.
///
/// # Errors
/// [`AppError`] if the request makes no sense, a map cannot be read, or the maps have nothing to do with each other.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Answer, AppError> {
    requests::check(request)?;
    if let Some(out) = &request.out {
        files::refuse_over(out, request.replace)?;
        files::can_be_written(out)?;
    }
    let table = Table::of(request)?;
    let row = table.as_ref().map(|table| &table.stroke);
    let width_m = request.width_m.or(row.map(|row| row.width_m)).ok_or_else(|| {
        AppError::Request(
            "the width of the plate is not known: give --width, or the stroke by --strokes and --stroke"
                .into(),
        )
    })?;
    let depth_m = request.depth_m.or(row.map(|row| row.depth_m));
    let stop = watch.stop(Interrupted::LeavesNothing);
    let scans = match (request.plate_x_m, request.plate_y_m, request.heading_deg) {
        (Some(x), Some(y), Some(heading_deg)) => {
            let plate = Plate { at_m: [x, y], sd_m: 0.0, heading_deg, width_m };
            plate.check()?;
            by_place(request, plate, depth_m)?
        }
        _ => arm::scans(request, &arm::arm(request, &stop)?, width_m, depth_m)?,
    };
    let mut answer = told(request, scans)?;
    if let (Some(out), Some(table), Some(broke)) = (&request.out, table, &answer.ground_break) {
        if table.stroke.break_distance_m.is_some() {
            let name = table.stroke.stroke_id.unwrap_or_default();
            answer.warnings.push(format!("stroke {name} had a break distance, which is replaced"));
        }
        let numbers = [("break_distance_m", broke.distance_m), ("break_distance_sd_m", broke.table_sd_m)];
        table.all.with_numbers(table.row, &numbers)?.write(out)?;
        answer.written = Some(out.display().to_string());
    }
    Ok(answer)
}

/// What clouds before and after a stroke say of it, where the arm is known already and they are in its root frame.
///
/// # Errors
/// [`AppError`] as of [`run`].
pub(crate) fn of_stroke(
    request: &Request,
    arm: &Motion,
    clouds: [Cloud; 2],
    width_m: f64,
    depth_m: f64,
) -> Result<Answer, AppError> {
    told(request, arm::of_clouds(request, arm, clouds, width_m, Some(depth_m))?)
}

fn told(request: &Request, scans: Scans) -> Result<Answer, AppError> {
    let Scans { before, after, sources: [of_before, of_after], mut plate, depth_m, mut notes } = scans;
    notes.extend(compare(request, &of_before, &of_after)?);
    plate.sd_m = request.plate_sd_m.unwrap_or(0.5 * before.grid().cell_m());
    let found = change(&before, &after, &plate, request.deviations, request.height_sd_m)?;
    let said = stroke(&before, &found, &plate, request.deviations)?;
    let maps = [(&request.before, &before, of_before), (&request.after, &after, of_after)];
    let mut answer = Answer {
        maps: maps.into_iter().map(|(path, map, source)| map_answer(path, map, &source)).collect(),
        plate: PlateAnswer {
            x_m: plate.at_m[0],
            y_m: plate.at_m[1],
            sd_m: plate.sd_m,
            heading_deg: plate.heading_deg,
            width_m: plate.width_m,
            depth_m,
        },
        pushed_m: depth_m.map(|depth| said.furrow.m3.max(0.0) / (plate.width_m * depth)),
        picture: picture::picture(&found, &plate, &said),
        ..answer(request, &found, said)
    };
    answer.verdict = words::verdict(&answer);
    answer.warnings = words::warnings(&answer, request, depth_m, notes);
    answer.warnings.extend(found.notes);
    Ok(answer)
}

/// Two maps, and the plate on them.
struct Scans {
    before: HeightMap,
    after: HeightMap,
    sources: [Source; 2],
    plate: Plate,
    depth_m: Option<f64>,
    notes: Vec<String>,
}

/// How both maps are to be read.
fn readings(request: &Request, around_m: [f64; 2], width_m: f64) -> [Reading; 2] {
    let before = Reading {
        around_m,
        reach_m: request.reach_m.unwrap_or(REACH * width_m),
        cell_m: request.cell_m,
        topic: request.topic.clone(),
        moment: request.before_at_s.map_or(Moment::First, Moment::At),
    };
    let after = Reading { moment: request.after_at_s.map_or(Moment::Last, Moment::At), ..before.clone() };
    [before, after]
}

/// Maps around a plate whose place is known.
fn by_place(request: &Request, plate: Plate, depth_m: Option<f64>) -> Result<Scans, AppError> {
    let [first, second] = readings(request, plate.at_m, plate.width_m);
    let (before, of_before) = read(&request.before, &first)?;
    let (after, of_after) = read_after(&request.after, &second, before.grid())?;
    Ok(Scans { before, after, sources: [of_before, of_after], plate, depth_m, notes: Vec::new() })
}

/// A stroke table and the stroke in it that is asked about.
struct Table {
    all: StrokeTable,
    row: usize,
    stroke: StrokeRow,
}

impl Table {
    fn of(request: &Request) -> Result<Option<Self>, AppError> {
        let (Some(path), Some(name)) = (&request.strokes, &request.stroke) else { return Ok(None) };
        let all = StrokeTable::read(path, ReadOptions { allow_zero_sd: true })?;
        let found = all.rows().enumerate().find(|(_, row)| row.stroke_id.as_deref() == Some(name.as_str()));
        let Some((row, stroke)) = found else {
            let known: Vec<String> = all.rows().filter_map(|row| row.stroke_id).take(10).collect();
            let known = if known.is_empty() {
                "it has no stroke_id".to_owned()
            } else {
                format!("it has {}", known.join(", "))
            };
            return Err(AppError::Request(format!("{} has no stroke `{name}`; {known}", path.display())));
        };
        Ok(Some(Self { all, row, stroke }))
    }
}

/// Whether both maps can be of one ground at two times; what is odd about them.
fn compare(request: &Request, before: &Source, after: &Source) -> Result<Vec<String>, AppError> {
    if !before.frame.is_empty() && !after.frame.is_empty() && before.frame != after.frame {
        return Err(AppError::Request(format!(
            "the map before is in the frame {}, the one after in {}; bring both into one frame, in which the plate's place is given too",
            before.frame, after.frame
        )));
    }
    if let (Some(first), Some(second)) = (before.time_ns, after.time_ns) {
        in_order(request, first, second)?;
    }
    let mut notes: Vec<String> = before.notes.iter().chain(&after.notes).cloned().collect();
    if before.frame.contains("optical") {
        notes.push(format!(
            "the frame {} sounds like that of a camera, whose z points away from it; z must point upwards: transform the clouds",
            before.frame
        ));
    }
    Ok(notes)
}

/// Refuses clouds of which the second is not later.
fn in_order(request: &Request, first_ns: i64, second_ns: i64) -> Result<(), AppError> {
    if first_ns == second_ns && request.before == request.after {
        return Err(AppError::Request(format!(
            "{} has one cloud at both times; give --before-at and --after-at, in s after its first cloud",
            request.before.display()
        )));
    }
    if second_ns < first_ns {
        return Err(AppError::Request(
            "the map after the stroke is older than that before it; give them in the other order".into(),
        ));
    }
    Ok(())
}

fn map_answer(path: &Path, map: &HeightMap, source: &Source) -> MapAnswer {
    MapAnswer {
        file: path.display().to_string(),
        format: match source.format {
            Kind::GeoTiff => Format::Geotiff,
            Kind::AsciiGrid => Format::AsciiGrid,
            Kind::Table => Format::Table,
            Kind::ScatteredTable => Format::ScatteredTable,
            Kind::Cloud => Format::Cloud,
        },
        frame: source.frame.clone(),
        time_s: source.time_ns.map(|ns| ns as f64 / 1e9),
        size: map.grid().size(),
        cell_m: map.grid().cell_m(),
        seen: map.seen(),
        points: source.points,
        points_per_cell: source.points_a_cell,
        missing_points: source.missing,
    }
}

/// What does not depend on how the maps were read.
fn answer(request: &Request, change: &Change, said: Stroke) -> Answer {
    let volume = |of: &Volume| VolumeAnswer {
        volume_m3: of.m3,
        sd_m3: of.sd_m3,
        most_m: of.most_m,
        cells: of.cells,
        off_map: of.off_map,
        hidden_cells: of.hidden,
    };
    let no_break_because = said.broke.as_ref().err().map(|why| words::no_break(*why));
    let broke = said.broke.ok().map(|broke| {
        let half = WITHIN * broke.sd_m + broke.resolution_m;
        BreakAnswer {
            distance_m: broke.distance_m,
            sd_m: broke.sd_m,
            resolution_m: broke.resolution_m,
            within_m: [(broke.distance_m - half).max(0.0), broke.distance_m + half],
            parts_m: broke.parts_m.to_vec(),
            again_m: broke.again_m,
            table_sd_m: broke.sd_m + broke.resolution_m,
        }
    });
    let shift = change.shift;
    Answer {
        maps: Vec::new(),
        plate: PlateAnswer { x_m: 0.0, y_m: 0.0, sd_m: 0.0, heading_deg: 0.0, width_m: 0.0, depth_m: None },
        noise_m: change.noise_m,
        clumping: change.clumping,
        unchanged_cells: change.unchanged,
        deviations: request.deviations,
        shift: ShiftAnswer {
            up_m: shift.up_m,
            up_sd_m: shift.up_sd_m,
            tilt_deg: shift.tilt.map(|slope| libm::atan(slope).to_degrees()),
            sideways_m: shift.sideways_m,
        },
        slope_deg: said.slope_deg,
        ground_break: broke,
        no_break_because,
        heap: volume(&said.heap),
        furrow: volume(&said.furrow),
        swelling: said.swelling.map(|[ratio, _]| ratio),
        swelling_sd: said.swelling.map(|[_, sd]| sd),
        pushed_m: None,
        elsewhere_cells: said.elsewhere,
        profile: ProfileAnswer {
            ahead_m: said.profile.ahead_m,
            rise_m: said.profile.rise_m,
            noise_m: said.profile.noise_m,
            lines: said.profile.lines,
        },
        picture: PictureAnswer { cell_m: 0.0, ahead_m: Vec::new(), left_m: Vec::new(), change_m: Vec::new() },
        written: None,
        verdict: String::new(),
        warnings: Vec::new(),
    }
}
