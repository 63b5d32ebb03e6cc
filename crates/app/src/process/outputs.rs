//! Files: the stroke table, `campaign.json` and `traces.csv` beside it.

use std::collections::BTreeMap;
use std::fs::File;
use std::io::{BufReader, BufWriter, Read, Seek, SeekFrom, Write};
use std::path::Path;

use soilctl_jobs::Beside;
use soilctl_process::table::{StrokeRecord, write_table};
use soilctl_strokes::{Campaign, TraceTable};

use super::inputs::Inputs;
use super::manifest::{self, Entry};
use super::work::Done;
use crate::AppError;
use crate::files::{failed, save};

/// What is known of the campaign: the description beside the table or else beside the first log, otherwise the defaults.
pub(super) fn campaign(inputs: &Inputs) -> Result<Campaign, AppError> {
    let beside = inputs.out.iter().map(|(path, _)| path).chain(inputs.logs.first().map(|log| &log.path));
    for path in beside {
        if let Some(found) = Campaign::read_beside(path)? {
            return Ok(found);
        }
    }
    Ok(Campaign::default())
}

/// Writes everything that belongs to the table; what was written.
pub(super) fn write(
    inputs: &Inputs,
    done: &Done,
    strokes: &[StrokeRecord],
    campaign: &Campaign,
) -> Result<Vec<String>, AppError> {
    let Some((out, form)) = &inputs.out else { return Ok(Vec::new()) };
    let folder = out.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut written = Vec::new();
    if !strokes.is_empty() {
        let mut bytes = Vec::new();
        write_table(*form, strokes, &mut bytes)?;
        save(out, &bytes)?;
        written.push(out.display().to_string());
        // A description that somebody wrote or `simulate` left is not replaced.
        if Campaign::read_beside(out)?.is_none() {
            campaign.write_beside(out)?;
            written.push(out.with_file_name("campaign.json").display().to_string());
        }
    }
    let entries = traces(inputs, folder, &done.entries)?;
    written.push(folder.join("traces.csv").display().to_string());
    manifest::finish(inputs, folder, &entries)?;
    written.push(folder.join("manifest.jsonl").display().to_string());
    // What waited is in the table now.
    let waiting = manifest::parts(folder);
    std::fs::remove_dir_all(&waiting).map_err(failed(&waiting))?;
    for shard in manifest::shards(folder).map_err(failed(folder))? {
        std::fs::remove_file(&shard).map_err(failed(&shard))?;
    }
    Ok(written)
}

/// Puts the traces of all logs together, in order; the entries with the places of theirs.
fn traces(
    inputs: &Inputs,
    folder: &Path,
    entries: &BTreeMap<usize, Entry>,
) -> Result<BTreeMap<usize, Entry>, AppError> {
    let path = folder.join("traces.csv");
    let new = Beside::new(&path);
    let mut old = File::open(&path).ok();
    let mut file = BufWriter::new(File::create(new.path()).map_err(failed(&path))?);
    let header = TraceTable::header();
    file.write_all(header.as_bytes()).map_err(failed(&path))?;
    let mut at = header.len() as u64;
    let mut placed = entries.clone();
    for (place, entry) in &mut placed {
        if entry.error.is_some() {
            continue;
        }
        let bytes = match (entry.trace_bytes, &mut old) {
            (Some([from, to]), Some(old)) => {
                old.seek(SeekFrom::Start(from)).map_err(failed(&path))?;
                let mut part = BufReader::new(old).take(to - from);
                std::io::copy(&mut part, &mut file).map_err(failed(&path))?
            }
            _ => {
                let part = manifest::part(folder, &inputs.logs[*place]);
                let mut part_file = BufReader::new(File::open(&part).map_err(failed(&part))?);
                std::io::copy(&mut part_file, &mut file).map_err(failed(&path))?
            }
        };
        entry.trace_bytes = Some([at, at + bytes]);
        at += bytes;
    }
    file.flush().map_err(failed(&path))?;
    new.keep().map_err(failed(&path))?;
    Ok(placed)
}
