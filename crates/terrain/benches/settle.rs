//! Time of a step of settling over grid size. A monitor that draws 60 frames a second has 16.7 ms for each.
#![allow(clippy::unwrap_used, missing_docs, clippy::cast_precision_loss)]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use soilctl_terrain::{HeightField, Repose};

/// Steep waves: a good part of the faces flows.
fn waves(n: usize) -> HeightField {
    let heights =
        (0..n * n).map(|k| 0.05 * (((k % n) as f64) * 0.2).sin() * (((k / n) as f64) * 0.15).cos()).collect();
    HeightField::from_heights(n, 0.005, heights).unwrap()
}

fn settle(criterion: &mut Criterion) {
    let repose = Repose::from_radians(0.58).unwrap();
    let mut group = criterion.benchmark_group("settle_step");
    for n in [64, 128, 256, 512, 1024] {
        group.throughput(Throughput::Elements((n * n) as u64));
        let field = waves(n);
        group.bench_with_input(BenchmarkId::from_parameter(n), &field, |bench, field| {
            bench.iter_batched_ref(
                || field.clone(),
                |field| field.settle_step(&repose),
                criterion::BatchSize::LargeInput,
            );
        });
    }
    group.finish();
}

criterion_group!(benches, settle);
criterion_main!(benches);
