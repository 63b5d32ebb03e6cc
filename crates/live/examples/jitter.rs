//! How well this machine keeps time: `cargo run --release -p soilctl-live --example jitter -- [SECONDS] [BUSY THREADS]` runs the
//! simulated arm in real time with five operators, one of whom stops reading, and a log in memory, and prints overruns and
//! histograms.
#![allow(clippy::unwrap_used, reason = "an example")]

#[path = "../tests/common/mod.rs"]
mod common;

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use common::{Operator, Running, simulated};
use soilctl_live::protocol::{Command, ServerMessage, parse_command};

fn main() {
    let mut args = std::env::args().skip(1).map(|text| text.parse::<u64>().unwrap());
    let (seconds, busy) = (args.next().unwrap_or(60), args.next().unwrap_or(0));
    let mut session = simulated();
    (session.real_time, session.most_ticks) = (true, Some(500 * seconds));
    let mut running = Running::new(session);
    let stop = Arc::new(AtomicBool::new(false));
    for _ in 0..busy {
        let stop = Arc::clone(&stop);
        std::thread::spawn(move || {
            while !stop.load(Ordering::Relaxed) {
                std::hint::spin_loop();
            }
        });
    }
    let lazy = soilctl_live::local::connect(&running.socket()).unwrap();
    let readers: Vec<_> = (0..3)
        .map(|_| {
            let mut operator = running.operator();
            std::thread::spawn(move || while !matches!(operator.next(), ServerMessage::End { .. }) {})
        })
        .collect();
    let mut operator = running.operator();
    operator.ask(Command::Enable).unwrap();
    let mover = std::thread::spawn(move || back_and_forth(&mut operator));
    let report = running.host.take().unwrap().wait().unwrap();
    stop.store(true, Ordering::Relaxed);
    drop(lazy);
    for reader in readers {
        reader.join().unwrap();
    }
    let state = mover.join().unwrap();
    let timing = report.timing.unwrap();
    eprintln!("{} ticks, {busy} busy threads; {:?}", report.ticks, report.ending);
    eprintln!("overruns: {}, ticks given up: {}", timing.overruns, timing.skipped);
    eprintln!("late by: {}", timing.lateness.words());
    eprintln!("busy for: {}", timing.busy.words());
    eprintln!("SCHED_FIFO: {}, memory locked: {}", timing.fifo, timing.locked);
    eprintln!("log: {:?}; fault: {:?}", report.log.unwrap(), report.fault);
    eprintln!(
        "{} clients: {} messages not taken, {} states and {} events dropped; of one that reads: {state:?}",
        report.clients, report.messages_dropped, report.states_dropped, report.events_dropped
    );
}

/// Keeps the arm moving until the session ends; what this operator lost.
fn back_and_forth(operator: &mut Operator) -> Option<soilctl_live::protocol::Dropped> {
    operator.commander.send(parse_command("set speed_scale 1").unwrap()).unwrap();
    let mut there = false;
    let mut go = true;
    loop {
        if std::mem::take(&mut go) {
            there = !there;
            let base = if there { "10" } else { "0" };
            let line = format!("move_joints {base},40,90,0,30");
            let _ = operator.commander.send(parse_command(&line).unwrap());
        }
        match operator.next() {
            ServerMessage::End { .. } => return operator.state.as_ref().map(|state| state.dropped),
            ServerMessage::Event(event) => go = event.kind.starts_with("trajectory_ended/joint_move"),
            _ => {}
        }
    }
}
