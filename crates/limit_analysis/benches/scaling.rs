//! Time and memory against the number of elements, with both factorisations side by side:
//! `cargo bench -p soilctl-limit-analysis --bench scaling [-- ELEMENTS]`, by default up to 50 000.
//!
//! Two adaptive runs of the plate (90, 40, 25), one with QDLDL and one with faer, take turns level by level, each on one
//! thread, without a gap to stop at. Seconds are the processor time of the level, with its mesh and proofs, so they do not
//! depend on what else the machine does. Runs may take a different number of steps; the ratio is that of the time for each
//! element and step. Memory is the peak of the process in that level.
#![allow(clippy::print_stdout, reason = "a benchmark's answer")]
#![allow(clippy::unwrap_used, reason = "a benchmark may stop")]

use std::fs::{read_to_string, write};
use std::sync::{Mutex, MutexGuard, PoisonError};

use soilctl_limit_analysis::{EmbeddedPlate, Factorisation, Level, Options, bound};

/// Peak memory of this process in MB since the last call, where the system tells.
fn peak_mb() -> f64 {
    let status = read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|l| l.starts_with("VmHWM"));
    let kilobytes = line.and_then(|l| l.split_whitespace().nth(1)).and_then(|n| n.parse::<f64>().ok());
    // Starts the count anew.
    let _ = write("/proc/self/clear_refs", "5");
    kilobytes.map_or(f64::NAN, |k| k / 1024.0)
}

/// Processor time of this thread in seconds, where the system tells.
fn processor_s() -> f64 {
    let told = read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    told.split_whitespace().next().and_then(|ns| ns.parse::<f64>().ok()).map_or(f64::NAN, |ns| 1e-9 * ns)
}

/// A level, its processor time, and its peak of memory.
struct Row {
    level: Level,
    seconds: f64,
    peak_mb: f64,
}

/// Levels of both runs, whose turn it is, and which are over.
#[derive(Default)]
struct Board {
    rows: [Vec<Row>; 2],
    turn: usize,
    over: [bool; 2],
}

impl Board {
    /// Prints a level that both runs have done.
    fn print(&self, number: usize) {
        let [Some(a), Some(b)] = [0, 1].map(|run| self.rows[run].get(number)) else { return };
        let solves = |row: &Row| [Some(row.level.upper), row.level.lower];
        for (name, both) in ["upper", "lower"].into_iter().zip(solves(a).into_iter().zip(solves(b))) {
            let (Some(a), Some(b)) = both else {
                print!("{:29}", "");
                continue;
            };
            print!("{name} {:>6} {:>7} {:>3} {:>3}  ", a.elements, a.size, a.iterations, b.iterations);
        }
        let work = |row: &Row| (row.level.upper.work + row.level.lower.map_or(0, |l| l.work)) as f64;
        let ratio = (a.seconds / work(a)) / (b.seconds / work(b));
        println!("{:>8.2} {:>8.2} {ratio:>6.2} {:>6.0} {:>6.0}", a.seconds, b.seconds, a.peak_mb, b.peak_mb);
    }
}

/// The board, when it is this run's turn, or the other run is over.
fn turn(board: &Mutex<Board>, run: usize) -> MutexGuard<'_, Board> {
    loop {
        let guard = board.lock().unwrap_or_else(PoisonError::into_inner);
        if guard.turn == run || guard.over[1 - run] {
            return guard;
        }
        drop(guard);
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
}

fn run(board: &Mutex<Board>, run: usize, max_elements: usize) {
    let plate = EmbeddedPlate { phi_deg: 40.0, delta_deg: 25.0, ..EmbeddedPlate::default() };
    let factorisation = Some(Factorisation::ALL[run]);
    let options =
        Options { max_gap: 0.0, max_work: u64::MAX, max_elements, factorisation, ..Options::default() };
    drop(turn(board, run));
    let mut used = processor_s();
    let bounds = bound(&plate.problem().unwrap(), &options, &mut |level: &Level, _| {
        let row = Row { level: level.clone(), seconds: processor_s() - used, peak_mb: peak_mb() };
        let mut guard = turn(board, run);
        guard.rows[run].push(row);
        guard.print(guard.rows[run].len() - 1);
        guard.turn = 1 - run;
        drop(guard);
        drop(turn(board, run));
        used = processor_s();
    });
    board.lock().unwrap_or_else(PoisonError::into_inner).over[run] = true;
    println!("{}: gap {:.3} %", Factorisation::ALL[run].name(), 100.0 * bounds.unwrap().gap());
}

fn main() {
    // Cargo adds an option of its own.
    let wanted = std::env::args().skip(1).find_map(|word| word.parse().ok());
    let board = Mutex::new(Board::default());
    println!(
        "                     steps of                     steps of   seconds with        peak in MB with"
    );
    println!(
        "    elements    size  q. fa.       elements    size  q. fa.    qdldl     faer  ratio  qdldl   faer"
    );
    std::thread::scope(|scope| {
        for number in 0..2 {
            let board = &board;
            scope.spawn(move || run(board, number, wanted.unwrap_or(50_000)));
        }
    });
}
