//! Certified brackets on a grid, in steps that can be broken off and taken up again.

mod answer;
mod cases;
mod cost;
mod journal;
mod options;
mod solve;
mod store;

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use soilctl_earth_pressure::table::{BracketRow, BracketRules, BracketTable};
use soilctl_jobs::Journal;

pub use answer::{BuiltBounds, EmptyNode, Plan};
use cases::{Node, key};
use cost::Cost;
use journal::{Entry, Found, Header};
pub use options::BoundsOptions;
use solve::{Solver, may_have_ends, solution_path};
use store::Store;

use super::Answer;
use super::brackets::{NAME, SOURCE};
use crate::table_file::{for_brackets, read_brackets, write_brackets};
use crate::{AppError, Interrupted, Watch};

/// Where solved cases are kept until all are done.
enum Kept<'a> {
    Journal(Journal),
    Store(&'a Store),
}

impl Kept<'_> {
    fn add(&mut self, entry: &Entry) -> Result<(), AppError> {
        match self {
            Self::Journal(journal) => Ok(journal.add(entry)?),
            Self::Store(store) => store.publish(entry),
        }
    }
}

/// `out` may be missing with a store: then the store is what is made.
pub(super) fn build(
    options: &BoundsOptions,
    axes: [Vec<f64>; 3],
    out: Option<&Path>,
    watch: &dyn Watch,
) -> Result<Answer, AppError> {
    out.map(for_brackets).transpose()?;
    let header = Header::new(options.rules(), axes, options.shard.map(|shard| shard.to_string()));
    let cases = cases::cases(&header.axes, options.shard);
    let store = options.store.as_deref().map(|folder| Store::new(folder, &header));
    let mut known = out.map_or_else(|| Ok(Vec::new()), |out| known(out, &header))?;
    if let Some(store) = &store {
        let left = todo(&cases, &known, None);
        known.extend(store.known(&left)?);
    }
    let todo = todo(&cases, &known, options.save.as_deref());
    let cost = Cost::new(header.rules, &known);
    if options.dry_run {
        let plan = Plan::new(cases.len(), &todo, &cost, options.threads());
        return Ok(Answer::Plan(plan));
    }
    let kept = match (&store, out) {
        (Some(store), _) => Kept::Store(store),
        (None, Some(out)) => Kept::Journal(Journal::begin(&journal::journal_path(out), &header, &known)?),
        (None, None) => {
            return Err(AppError::Request(
                "--out is missing: name the file for the table, or with --store a folder for its cases"
                    .into(),
            ));
        }
    };
    let (entries, finished) = run(options, &header, known, &todo, &cost, kept, watch)?;
    let mut empty = Vec::new();
    let mut rows: Vec<BracketRow> = Vec::new();
    // A row that got its ends later stands in it twice, without them first.
    let mut latest: BTreeMap<_, Entry> = BTreeMap::new();
    latest.extend(entries.into_iter().map(|entry| (key(entry.node()), entry)));
    for entry in latest.into_values() {
        match entry.found {
            Found::Solved(row) => rows.push(row),
            Found::Empty { node, reason } => empty.push((node, reason)),
        }
    }
    empty.sort_by_key(|(node, _)| key(*node));
    let table = BracketTable::new(NAME, header.rules, rows)?;
    if let Some(out) = out.filter(|_| finished) {
        if !table.rows().is_empty() {
            write_brackets(&table, SOURCE, out)?;
        }
        journal::remove(out)?;
        if table.rows().is_empty() {
            let reason = empty.first().map_or("this shard has no case", |(_, reason)| reason);
            return Err(AppError::Request(format!("no node of the table could be filled: {reason}")));
        }
    }
    let waiting = || options.store.clone().or_else(|| out.map(journal::journal_path)).unwrap_or_default();
    let file = out.filter(|_| finished).map_or_else(waiting, Path::to_owned);
    Ok(Answer::BuildBounds(BuiltBounds::new(&table, empty, cases.len(), finished, &file)))
}

/// What is known from the journal, or else from the table itself if it is there already.
fn known(out: &Path, header: &Header) -> Result<Vec<Entry>, AppError> {
    if let Some(entries) = journal::read(out, header)? {
        return Ok(entries);
    }
    if !out.exists() {
        return Ok(Vec::new());
    }
    let (table, version) = read_brackets(out)?;
    let BracketRules { max_gap, max_elements } = table.rules();
    if table.rules() != header.rules || version != header.program_version {
        return Err(AppError::Request(format!(
            "{} is there already, built by soilctl {version} with --max-gap {max_gap} --max-elements {max_elements}; to \
             extend it use the same, to build anew delete it or choose another --out",
            out.display()
        )));
    }
    let proven = table.rows().iter().filter(|row| row.certified);
    Ok(proven.map(|row| Entry { found: Found::Solved(*row), seconds: None }).collect())
}

/// Cases that are not known, or known without ends or without the solution that is to be saved.
fn todo(cases: &[Node], known: &[Entry], save: Option<&Path>) -> Vec<Node> {
    let is_whole = |entry: &&Entry| match &entry.found {
        Found::Solved(row) => {
            let saved = save.is_none_or(|folder| solution_path(folder, row.node()).exists());
            saved && !is_without_ends(row)
        }
        Found::Empty { .. } => true,
    };
    let whole: BTreeSet<_> = known.iter().filter(is_whole).map(|entry| key(entry.node())).collect();
    cases.iter().filter(|node| !whole.contains(&key(**node))).copied().collect()
}

/// Whether a row lacks what can be known of plates with ends: one of an earlier version.
fn is_without_ends(row: &BracketRow) -> bool {
    row.ends_term.is_none() && may_have_ends(row.node())
}

/// Solves what is left to do. All entries, and whether all is done.
fn run(
    options: &BoundsOptions,
    header: &Header,
    mut entries: Vec<Entry>,
    todo: &[Node],
    cost: &Cost,
    mut kept: Kept<'_>,
    watch: &dyn Watch,
) -> Result<(Vec<Entry>, bool), AppError> {
    if let Some(folder) = &options.save {
        std::fs::create_dir_all(folder)
            .map_err(|problem| AppError::File { path: folder.display().to_string(), problem })?;
    }
    watch.begin(todo.len() as u64, "cases");
    watch.say("first cases");
    let mut left = cost.time_left(todo, options.threads());
    let stop = watch.stop(Interrupted::KeepsResults);
    // With solutions to save, all is solved anew.
    let plane = entries.iter().filter(|_| options.save.is_none()).filter_map(|entry| match &entry.found {
        Found::Solved(row) => is_without_ends(row).then(|| (key(row.node()), *row)),
        Found::Empty { .. } => None,
    });
    let solver = Solver { rules: header.rules, save: options.save.as_deref(), stop, plane: plane.collect() };
    let before = entries.len();
    let solved = solver.solve(todo, options.threads(), |entry| {
        kept.add(&entry)?;
        left.done(&entry);
        watch.advance(1);
        watch.say(&left.words());
        entries.push(entry);
        Ok(())
    });
    watch.end();
    solved?;
    let finished = entries.len() - before == todo.len();
    Ok((entries, finished))
}
