//! Folders with the parts of one recording.

mod join;
mod metadata;

use std::path::{Component, Path, PathBuf};

use soilctl_session::read::Ending;

use self::join::Join;
use crate::damage::note;
use crate::scan::{Halt, Visit, show_file};
use crate::{BagError, container};

/// The files of a recording in order, and what is wrong with the list.
#[derive(Debug, Default)]
pub(crate) struct Parts {
    files: Vec<PathBuf>,
    damage: Vec<String>,
}

/// Whether there is a `metadata.yaml` of a bag.
pub(crate) fn has_metadata(folder: &Path) -> bool {
    metadata::text(folder).is_ok_and(|text| text.is_some_and(|text| metadata::is_of_a_bag(&text)))
}

/// The parts that `metadata.yaml` lists, or else files that are numbered as parts of one recording.
///
/// # Errors
/// [`BagError::File`] if the folder cannot be read, [`BagError::NotARecording`] if it holds none, or several.
pub(crate) fn parts(folder: &Path) -> Result<Parts, BagError> {
    let mut parts = Parts::default();
    let there = numbered(folder)?;
    let listed = match metadata::text(folder) {
        Ok(Some(text)) if metadata::is_of_a_bag(&text) => metadata::metadata(&text).map(Some),
        Ok(_) => Ok(None),
        Err(problem) => Err(problem),
    };
    match listed {
        Ok(Some(listed)) if !listed.files.is_empty() => {
            let (mode, format) = (&listed.compression_mode, &listed.compression_format);
            if !mode.is_empty() && !mode.eq_ignore_ascii_case("none") && format != "zstd" {
                let problem = format!(
                    "{} says that it is compressed with `{format}`; only zstd is known",
                    metadata::NAME
                );
                parts.damage.push(problem);
            }
            for name in &listed.files {
                match within(folder, name) {
                    Some(path) if !parts.files.contains(&path) => parts.files.push(path),
                    Some(_) => {}
                    None => note(
                        &mut parts.damage,
                        format!("{} lists `{name}`, which is not in the folder", metadata::NAME),
                    ),
                }
            }
            for (_, _, path) in &there {
                if !parts.files.contains(path) {
                    let name = path.file_name().unwrap_or_default().display();
                    note(
                        &mut parts.damage,
                        format!("{name} is left out, since {} does not list it", metadata::NAME),
                    );
                }
            }
            if parts.files.is_empty() {
                return Err(BagError::not_a_recording(
                    folder,
                    format!("none of the files that its {} lists is there", metadata::NAME),
                ));
            }
            return Ok(parts);
        }
        Ok(Some(_)) => parts.damage.push(format!("{} lists no files", metadata::NAME)),
        Ok(None) => {}
        Err(problem) => parts.damage.push(problem),
    }
    // Recorders that are killed leave no list.
    let mut names: Vec<&str> = there.iter().map(|(name, ..)| name.as_str()).collect();
    names.dedup();
    match names.as_slice() {
        [_] => parts.files = there.into_iter().map(|(.., path)| path).collect(),
        [] => {
            let reason = "it is a folder without a recording".to_owned();
            return Err(BagError::not_a_recording(folder, reason));
        }
        several => {
            let reason = format!("it is a folder with {} recordings; give one of them", several.len());
            return Err(BagError::not_a_recording(folder, reason));
        }
    }
    Ok(parts)
}

/// Name without number, number and path of each recording in a folder, in this order.
fn numbered(folder: &Path) -> Result<Vec<(String, u64, PathBuf)>, BagError> {
    let failed = |error: std::io::Error| BagError::file(folder, &error);
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(failed)? {
        let path = entry.map_err(failed)?.path();
        if path.is_dir() || !container::is_recording(&path) {
            continue;
        }
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        let (stem, _) = name.split_once('.').unwrap_or((name, ""));
        let (stem, number) = match stem.rsplit_once('_') {
            Some((before, number)) if !number.is_empty() && number.bytes().all(|b| b.is_ascii_digit()) => {
                (before, number.parse().unwrap_or(u64::MAX))
            }
            _ => (stem, 0),
        };
        found.push((stem.to_owned(), number, path));
    }
    found.sort();
    Ok(found)
}

/// A file that `metadata.yaml` names, if it is in the folder. The first versions of ROS 2 named it with the folder before it, and some
/// leave the ending of a compressed file out. What is outside is not looked at, since anybody may have written the list.
fn within(folder: &Path, name: &str) -> Option<PathBuf> {
    let given = Path::new(name);
    let plain = given.components().all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
    let inside = plain.then_some(given);
    let only = given.file_name().map(Path::new);
    [inside, only].into_iter().flatten().find_map(|name| {
        let mut packed = name.as_os_str().to_owned();
        packed.push(".zstd");
        [folder.join(name), folder.join(packed)].into_iter().find(|path| path.is_file())
    })
}

/// Shows what the parts hold, one after another.
pub(crate) fn show(folder: &Path, visit: &mut Visit<'_>) -> Result<Ending, Halt> {
    let Parts { files, damage } = parts(folder)?;
    let mut all = Ending { damage, ..Ending::default() };
    let mut join = Join::default();
    let mut failure = None;
    let mut shown = 0;
    for path in &files {
        let name = path.file_name().unwrap_or_default().display().to_string();
        join.next_part();
        let done = container::look(path).map_err(Halt::from).and_then(|(container, packed)| {
            show_file(path, container, packed, &mut |item| join.item(item, visit))
        });
        match done {
            Ok(ending) => {
                shown += 1;
                all.bytes += ending.bytes;
                all.compressions.extend(ending.compressions);
                for problem in ending.damage {
                    note(&mut all.damage, format!("{name}: {problem}"));
                }
            }
            Err(Halt::Visitor) => return Err(Halt::Visitor),
            Err(Halt::Failed(error)) => {
                note(&mut all.damage, format!("a part is left out: {error}"));
                failure.get_or_insert(error);
            }
        }
    }
    for problem in join.damage {
        note(&mut all.damage, problem);
    }
    match failure {
        Some(error) if shown == 0 => Err(error.into()),
        _ => Ok(all),
    }
}
