//! Recordings of other programs, in every container, whole and damaged. `tests/python/test_view.py` reads what is written with Rerun.
#![allow(clippy::unwrap_used, clippy::cast_precision_loss)]

#[path = "../../motion/tests/common/mod.rs"]
mod common;

use common::{URDF, crane, folder};
use soilctl_mutants::{each_mutant, recordings};
use soilctl_recording::{RecordingError, Settings, record};

/// The joints of `crates/bag/tests/data`.
const ARM: &str = r#"<robot name="arm"><link name="world"/><link name="cart"/>
<link name="a/b c"><visual><geometry><box size="1 2 3"/></geometry></visual></link>
<joint name="base" type="revolute"><parent link="world"/><child link="cart"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
<joint name="arm" type="continuous"><parent link="cart"/><child link="a/b c"/><origin xyz="0 0 0.1"/></joint></robot>"#;

#[test]
fn the_arm_its_wrenches_and_its_joints_are_shown() {
    let (_folder, path) = folder();
    crane(&path, &|t_s| t_s > 5.0);
    let out = path.with_extension("rrd");
    let urdf = URDF.replace(
        "<link name=\"boom\"/>",
        "<link name=\"boom\"><visual><geometry><box size=\"0.4 0.1 0.1\"/></geometry></visual></link>",
    );
    let settings = Settings { urdf: Some(urdf), surface_z_m: Some(0.1), ..Settings::default() };
    let found = record(&path, &out, &settings).unwrap();
    let foreign = found.foreign.unwrap();
    assert_eq!((foreign.states, foreign.clock_origin_s, foreign.notes.len()), (1000, common::START_S, 0));
    let rows = |entity: &str| found.entities.get(entity).copied().unwrap_or(0);
    for entity in ["/world/links/boom", "/world/bones", "/joints/turning", "/joints/sliding", "/end_point"] {
        assert_eq!(rows(entity), 1000, "{entity}");
    }
    for entity in ["/force_sensor", "/torque_sensor", "/world/force"] {
        assert_eq!(rows(entity), 451, "{entity}");
    }
    assert!((found.span_s[0] - 0.5).abs() < 1e-9 && (found.span_s[1] - 10.49).abs() < 1e-9);
    // The same recording gives the same bytes.
    let first = std::fs::read(&out).unwrap();
    record(&path, &out, &settings).unwrap();
    assert_eq!(first, std::fs::read(&out).unwrap());
    let error = record(&path, &out, &Settings { end_link: Some("none".into()), ..settings }).unwrap_err();
    assert!(matches!(error, RecordingError::Motion { .. }), "{error}");
    assert_eq!(first, std::fs::read(&out).unwrap());
}

#[test]
fn every_container_and_its_mutants() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out.rrd");
    let settings = Settings { urdf: Some(ARM.into()), ..Settings::default() };
    let (files, folders) = recordings();
    for file in files.iter().chain(&folders) {
        let found =
            record(file, &out, &settings).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        assert_eq!(found.entities["/world/links/a_b_c"], 16, "{}", file.display());
        assert_eq!(found.entities["/force_sensor"], 16, "{}", file.display());
    }
    each_mutant(41, |path| drop(record(path, &out, &settings))).unwrap();
}
