//! Writing and reading a log: steps and bytes a second. At 500 Hz and ten times real time, 5000 steps a second are needed.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, reason = "a benchmark")]

#[path = "../tests/common/mod.rs"]
mod common;

use std::hint::black_box;

use common::{Digger, STROKE_TICKS, setup};
use criterion::{Criterion, SamplingMode, Throughput};
use soilctl_controller::State;
use soilctl_session::read::scan;
use soilctl_session::{KEYFRAME_STEPS, LogWriter, StepRecord, replay};

/// One stroke: what a control thread hands to the logger.
fn steps() -> (State, Vec<StepRecord>) {
    let setup = setup(1);
    let mut digger = Digger::new(&setup);
    let state = digger.rig.state;
    (state, (0..STROKE_TICKS).map(|_| digger.step(|_| {})).collect())
}

fn write(state: &State, records: &[StepRecord]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut writer = LogWriter::new(&mut bytes, &setup(1)).unwrap();
    for (number, record) in (0..).zip(records) {
        if number % KEYFRAME_STEPS == 0 {
            writer.flush().unwrap();
            writer.keyframe(number, state).unwrap();
        }
        writer.step(number, record).unwrap();
    }
    writer.finish(0).unwrap();
    bytes
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let (state, records) = steps();
    let bytes = write(&state, &records);
    println!("{} bytes for {} steps", bytes.len(), records.len());
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("bench.mcap");
    common::write_log(&path, 1, STROKE_TICKS);

    let mut group = criterion.benchmark_group("log");
    group.sampling_mode(SamplingMode::Flat).sample_size(10);
    group.throughput(Throughput::Elements(STROKE_TICKS));
    group.bench_function("write, steps", |b| b.iter(|| write(&state, black_box(&records))));
    group.bench_function("read, steps", |b| {
        b.iter(|| scan::<soilctl_session::SessionError>(black_box(&path), &mut |_| Ok(())).unwrap())
    });
    group.bench_function("replay, steps", |b| b.iter(|| replay(black_box(&path), 0).unwrap()));
    group.throughput(Throughput::Bytes(bytes.len() as u64));
    group.bench_function("write, bytes of the file", |b| b.iter(|| write(&state, black_box(&records))));
    group.finish();
    criterion.final_summary();
}
