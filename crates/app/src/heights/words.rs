//! What two height maps come to, and what to keep in mind.

use soilctl_heights::NoBreak;

use super::{Answer, Request, VolumeAnswer};
use crate::text::{measured, sentence_case};

fn mm(m: f64) -> String {
    format!("{:.1}", 1e3 * m)
}

/// Why it cannot be said where the ground broke.
pub(super) fn no_break(why: NoBreak) -> String {
    match why {
        NoBreak::NoRise { most_m, needed_m } => format!(
            "nothing near the plate rises out of the noise: the profile ahead rises by {} mm at most, where {} mm would count; check the plate's place, and that \
             the map was made after the stroke",
            mm(most_m),
            mm(needed_m)
        ),
        NoBreak::Faint { most_m, needed_m } => format!(
            "the ground ahead rises by {} mm at most, less than the {} mm that would show where the rise ends; finer maps or less noise are needed",
            mm(most_m),
            mm(needed_m)
        ),
        NoBreak::OffMap => "the ground has risen up to where the map ends; scan more of it ahead of the plate".to_owned(),
        NoBreak::Hidden => "the rise ends where the ground was not seen; scan it from another side, or without the arm in the way".to_owned(),
    }
}

/// The result in sentences.
pub(super) fn verdict(answer: &Answer) -> String {
    let mut text = match (&answer.ground_break, &answer.no_break_because) {
        (Some(broke), _) => {
            let [low, high] = broke.within_m.map(mm);
            format!(
                "The ground broke {} mm ahead of the plate, along the surface; between {low} and {high} mm with two standard deviations of {} mm and the resolution of {} mm.",
                mm(broke.distance_m),
                mm(broke.sd_m),
                mm(broke.resolution_m)
            )
        }
        (None, Some(why)) => format!("It cannot be said where the ground broke: {why}."),
        (None, None) => String::new(),
    };
    let said = |name: &str, volume: &VolumeAnswer| {
        if volume.cells == 0 {
            format!("no {name} stands out of the noise")
        } else {
            format!("the {name} has {}", measured(1e3 * volume.volume_m3, 1e3 * volume.sd_m3, "l"))
        }
    };
    text += &format!(" {}, {}", sentence_case(&said("heap", &answer.heap)), said("furrow", &answer.furrow));
    text += &match (answer.swelling, answer.swelling_sd) {
        (Some(ratio), Some(sd)) => format!("; the soil takes {} times the room.", measured(ratio, sd, "1")),
        _ => ".".to_owned(),
    };
    text
}

/// What to keep in mind.
pub(super) fn warnings(
    answer: &Answer,
    request: &Request,
    depth_m: Option<f64>,
    mut warnings: Vec<String>,
) -> Vec<String> {
    if let Some(broke) = &answer.ground_break {
        if let (Some(pushed), Some(depth)) = (answer.pushed_m, depth_m)
            && pushed > depth
        {
            warnings.push(format!(
                "the furrow has the volume of {} mm of this plate's way, more than its depth: a heap has grown since the ground broke first, and what it covers may be \
                 farther than the first crack",
                mm(pushed)
            ));
        } else if answer.pushed_m.is_none() {
            warnings.push("models speak of the first crack: scan before a heap has grown; --depth would tell how far the plate pushed".to_owned());
        }
        if let Some(again) = broke.again_m {
            warnings.push(format!(
                "the ground rises once more {} mm ahead of the plate: a second crack, or something else moved it",
                mm(again)
            ));
        }
        let shown = broke.parts_m.iter().flatten().count();
        if shown < 2 {
            warnings.push(format!(
                "the edge shows in {shown} of {} parts of the plate's width, so how ragged it is is not in its standard deviation; finer or less noisy maps would tell",
                broke.parts_m.len()
            ));
        }
        if broke.resolution_m > 0.1 * broke.distance_m {
            warnings.push("cells are large against the distance; finer ones would tell more".to_owned());
        }
        if answer.slope_deg.abs() > 2.0 {
            warnings.push(format!(
                "the ground ahead of the plate slopes by {:.1} deg; tell `surface` so by --beta",
                answer.slope_deg
            ));
        }
    }
    if request.plate_sd_m.is_none() {
        warnings.push(format!(
            "how well the plate's place is known was not said; {} mm, half a cell, are taken (--plate-sd)",
            mm(answer.plate.sd_m)
        ));
    }
    for (name, volume) in [("heap", &answer.heap), ("furrow", &answer.furrow)] {
        if volume.off_map {
            warnings.push(format!("the {name} reaches the edge of the map, so it may be larger"));
        }
        if volume.hidden_cells > 0 {
            warnings.push(format!(
                "{} cells in or beside the {name} were not seen, and their volume is not counted",
                volume.hidden_cells
            ));
        }
    }
    if let (Some(ratio), Some(sd)) = (answer.swelling, answer.swelling_sd)
        && ratio + 3.0 * sd < 1.0
    {
        warnings.push(
            "the heap is smaller than the furrow: soil was carried away, compacted, or not seen".to_owned(),
        );
    }
    if let Some(depth) = depth_m
        && answer.heap.most_m > 2.0 * depth
    {
        warnings.push(format!(
            "the ground rises by {} mm at its highest, more than twice the depth: something that is no soil, such as the plate, stands in the second map",
            mm(answer.heap.most_m)
        ));
    }
    if answer.elsewhere_cells > 0 {
        warnings.push(format!(
            "{} cells changed elsewhere, apart from the plate, and are not counted",
            answer.elsewhere_cells
        ));
    }
    if request.out.is_some() && answer.ground_break.is_none() {
        warnings.push("no stroke table is written, since there is no break distance".to_owned());
    }
    warnings
}
