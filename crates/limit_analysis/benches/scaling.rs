//! Time and memory against the number of elements, with both factorisations side by side:
//! `cargo bench -p soilctl-limit-analysis --bench scaling [-- ELEMENTS]`, by default up to 50 000.
//!
//! Two adaptive runs of the plate (90, 40, 25), one with QDLDL and one with faer, take turns level by level, each on one
//! thread, without a gap to stop at: what else the machine does slows both. Seconds per step of the solver are processor time:
//! those of the solver's clock, times the part of the level for which the thread had a processor. Memory is the peak of the
//! process in that level.
#![allow(clippy::print_stdout, reason = "a benchmark's answer")]
#![allow(clippy::unwrap_used, reason = "a benchmark may stop")]

use std::fs::{read_to_string, write};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

use soilctl_limit_analysis::{EmbeddedPlate, Factorisation, Level, Options, Solve, bound};

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

/// One solve: processor time per step, and the level's peak of memory.
struct Row {
    solve: Solve,
    step_s: f64,
    peak_mb: f64,
}

/// Levels of both runs, whose turn it is, and how many were printed.
#[derive(Default)]
struct Board {
    levels: [Vec<[Option<Row>; 2]>; 2],
    turn: usize,
    over: [bool; 2],
}

impl Board {
    fn print(&self, number: usize) {
        let [Some(a), Some(b)] = [0, 1].map(|run| self.levels[run].get(number)) else { return };
        for (kind, (a, b)) in ["upper", "lower"].into_iter().zip(a.iter().zip(b)) {
            let (Some(a), Some(b)) = (a, b) else { continue };
            println!(
                "{kind} {:>8} {:>8} {:>6} {:>6} {:>9.4} {:>9.4} {:>6.2} {:>7.2} {:>7.0} {:>7.0}",
                a.solve.elements,
                a.solve.size,
                a.solve.iterations,
                b.solve.iterations,
                a.step_s,
                b.step_s,
                a.step_s / b.step_s,
                a.step_s * f64::from(a.solve.iterations) / (b.step_s * f64::from(b.solve.iterations)),
                a.peak_mb,
                b.peak_mb,
            );
        }
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
    let (mut clock, mut used) = (Instant::now(), processor_s());
    let bounds = bound(&plate.problem().unwrap(), &options, &mut |level: &Level, _| {
        let share = (processor_s() - used) / clock.elapsed().as_secs_f64();
        let peak_mb = peak_mb();
        let row = |solve: Solve| {
            let step_s = share * solve.seconds / f64::from(solve.iterations.max(1));
            Row { solve, step_s, peak_mb }
        };
        let mut guard = turn(board, run);
        guard.levels[run].push([Some(row(level.upper)), level.lower.map(row)]);
        guard.print(guard.levels[run].len() - 1);
        guard.turn = 1 - run;
        drop(guard);
        drop(turn(board, run));
        (clock, used) = (Instant::now(), processor_s());
    });
    board.lock().unwrap_or_else(PoisonError::into_inner).over[run] = true;
    println!("{}: gap {:.3} %", Factorisation::ALL[run].name(), 100.0 * bounds.unwrap().gap());
}

fn main() {
    // Cargo adds an option of its own.
    let wanted = std::env::args().skip(1).find_map(|word| word.parse().ok());
    let board = Mutex::new(Board::default());
    println!("                          steps of      s per step with   ratio of:      peak in MB of");
    println!("bound elements     size  qdldl   faer     qdldl      faer   step   solve   qdldl    faer");
    std::thread::scope(|scope| {
        for number in 0..2 {
            let board = &board;
            scope.spawn(move || run(board, number, wanted.unwrap_or(50_000)));
        }
    });
}
