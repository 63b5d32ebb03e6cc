//! Certified brackets on a grid, in steps that can be broken off and taken up again.

mod answer;
mod cases;
mod cost;
mod journal;
mod solve;
mod store;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use soilctl_earth_pressure::table::{BracketRow, BracketRules, BracketTable};
use soilctl_jobs::{Journal, Shard};

pub use answer::{BuiltBounds, EmptyNode, Plan};
use cases::{Node, key};
use cost::Cost;
use journal::{Entry, Found, Header};
use solve::{Solver, solution_path};
use store::Store;

use super::Answer;
use super::brackets::{NAME, SOURCE};
use crate::request::finite;
use crate::simulate::cores;
use crate::table_file::{for_brackets, read_brackets, write_brackets};
use crate::{AppError, Interrupted, Watch};

/// Options of the model `bounds`.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema, clap::Args)]
#[serde(default)]
pub struct BoundsOptions {
    /// Bounds: gap (U - L) / ((U + L) / 2) at which a case is done [default: 0.01]
    #[arg(long, value_name = "FRACTION", value_parser = finite, allow_negative_numbers = true)]
    #[schemars(extend("exclusiveMinimum" = 0.0))]
    pub max_gap: Option<f64>,

    /// Bounds: most elements that a case is given [default: 12000]
    #[arg(long, value_name = "N")]
    #[schemars(range(min = 600, max = 1_000_000))]
    pub max_elements: Option<u32>,

    /// Bounds: cases solved at a time; the table is the same for any number [default: all cores]
    #[arg(long, value_name = "N")]
    #[schemars(range(min = 1, max = 1024))]
    pub threads: Option<u32>,

    /// Bounds: only each N-th case, starting with the I-th; all shards may fill one --store, or `table merge` unites their files
    #[arg(long, value_name = "I/N")]
    #[schemars(with = "Option<String>")]
    pub shard: Option<Shard>,

    /// Bounds: folder where each solved case is a file of its own, for any number of runs and machines at a time; what is there
    /// is not solved again
    #[arg(long, value_name = "DIR")]
    pub store: Option<PathBuf>,

    /// Bounds: folder for the fields that prove each case, for `soilctl certify`
    #[arg(long, value_name = "DIR")]
    pub save: Option<PathBuf>,

    /// Bounds: only says how many cases there are and how long they will take
    #[arg(long)]
    pub dry_run: bool,
}

impl BoundsOptions {
    /// The first of these options that was given: they are for the model `bounds` only.
    pub(super) fn given(&self) -> Option<&'static str> {
        [
            (self.max_gap.is_some(), "--max-gap"),
            (self.max_elements.is_some(), "--max-elements"),
            (self.threads.is_some(), "--threads"),
            (self.shard.is_some(), "--shard"),
            (self.store.is_some(), "--store"),
            (self.save.is_some(), "--save"),
            (self.dry_run, "--dry-run"),
        ]
        .into_iter()
        .find_map(|(given, name)| given.then_some(name))
    }

    fn rules(&self) -> BracketRules {
        let max_elements = self.max_elements.unwrap_or(12_000) as usize;
        BracketRules { max_gap: self.max_gap.unwrap_or(0.01), max_elements }
    }

    fn threads(&self) -> usize {
        self.threads.map_or_else(cores, |threads| threads as usize)
    }
}

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
    for entry in entries {
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
            let reason = empty.first().map_or("delta is above phi everywhere", |(_, reason)| reason);
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
    Ok(table.rows().iter().map(|row| Entry { found: Found::Solved(*row), seconds: None }).collect())
}

/// Cases that are not known, or known without the solution that is to be saved.
fn todo(cases: &[Node], known: &[Entry], save: Option<&Path>) -> Vec<Node> {
    let is_whole = |entry: &&Entry| match (&entry.found, save) {
        (Found::Solved(row), Some(folder)) => solution_path(folder, row.node()).exists(),
        _ => true,
    };
    let whole: BTreeSet<_> = known.iter().filter(is_whole).map(|entry| key(entry.node())).collect();
    cases.iter().filter(|node| !whole.contains(&key(**node))).copied().collect()
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
    let solver = Solver { rules: header.rules, save: options.save.as_deref(), stop };
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
