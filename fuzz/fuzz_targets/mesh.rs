//! A mesh of a robot's link, whatever its bytes.
#![no_main]

use std::path::PathBuf;
use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use soilctl_mesh::{Budget, Sought, load};

static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
    let folder = std::env::temp_dir().join(format!("soilctl-fuzz-{}", std::process::id()));
    let _ = std::fs::create_dir_all(&folder);
    folder
});

fuzz_target!(|bytes: &[u8]| {
    let sought = Sought { roots: vec![FOLDER.clone()], urdf_folder: None };
    if std::fs::write(FOLDER.join("mesh"), bytes).is_ok() {
        let _ = load("mesh", &sought, &mut Budget::default());
    }
});
