//! How fast messages are read. A force sensor sends some thousand a second.
#![allow(clippy::unwrap_used, missing_docs)]

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use soilctl_bag::{BagError, Channel, Item, RawMessage, Readers, contents, scan};

fn bench(criterion: &mut Criterion) {
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data");
    let mut samples: Vec<(Channel, Vec<u8>)> = Vec::new();
    let recording = format!("{data}/none.mcap");
    scan::<BagError>(recording.as_ref(), &mut |item| {
        if let Item::Message(message) = item
            && !samples.iter().any(|(channel, _)| channel.topic == message.channel.topic)
        {
            samples.push((message.channel.clone(), message.data.to_vec()));
        }
        Ok(())
    })
    .unwrap();
    let mut group = criterion.benchmark_group("read");
    group.throughput(Throughput::Elements(1));
    for (name, topic) in
        [("wrench", "/wrench"), ("wrapped wrench", "/vendor/force"), ("joint state", "/joint_states")]
    {
        let (channel, data) = samples.iter().find(|(channel, _)| channel.topic == topic).unwrap();
        let message =
            RawMessage { channel_id: 1, channel, sequence: 0, log_time_ns: 1, publish_time_ns: 1, data };
        let mut readers = Readers::new();
        group.bench_function(name, |bencher| bencher.iter(|| readers.read(black_box(&message))));
        group.bench_function(format!("{name} as cells"), |bencher| {
            bencher.iter(|| readers.reader(black_box(&message)).unwrap().cells(data));
        });
    }
    group.finish();
    // Recordings of a minute, if they were made: see the README.
    if let Ok(folder) = std::env::var("SOILCTL_BAGS") {
        let mut group = criterion.benchmark_group("contents");
        group.sample_size(10);
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let messages = contents(&path).unwrap().topics.values().map(|topic| topic.messages).sum();
            group.throughput(Throughput::Elements(messages));
            group.bench_function(path.file_name().unwrap().to_str().unwrap(), |bencher| {
                bencher.iter(|| contents(&path).unwrap());
            });
        }
    }
}

criterion_group!(benches, bench);
criterion_main!(benches);
