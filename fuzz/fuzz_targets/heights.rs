//! A height map, whatever its bytes: a GeoTIFF, an ESRI grid or a table of points by its first byte.
#![no_main]

use std::path::PathBuf;
use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use soilctl_heights::{Moment, Reading, read};

static STEM: LazyLock<PathBuf> =
    LazyLock::new(|| std::env::temp_dir().join(format!("soilctl-fuzz-{}", std::process::id())));

fuzz_target!(|bytes: &[u8]| {
    let Some((kind, bytes)) = bytes.split_first() else { return };
    let file = STEM.with_extension(["tif", "asc", "csv"][usize::from(kind % 3)]);
    let reading =
        Reading { around_m: [0.0; 2], reach_m: 1.0, cell_m: None, topic: None, moment: Moment::First };
    if std::fs::write(&file, bytes).is_ok() {
        let _ = read(&file, &reading);
    }
});
