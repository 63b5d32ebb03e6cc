//! Recordings of other programs on pages: their arm with its shapes and meshes, in every container, whole and damaged.
#![allow(clippy::unwrap_used)]

#[path = "../../motion/tests/common/mod.rs"]
mod bags;
mod common;

use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::Path;

use bags::{URDF, crane, folder};
use common::{Page, monitor};
use soilctl_monitor::{BagSettings, Monitor, Settings, Source};
use soilctl_mutants::{each_mutant, recordings};

fn play(path: &Path, bag: BagSettings) -> Source {
    Source::Log { path: path.to_owned(), from_s: 0.0, bag }
}

/// Head and content of what is at a path.
fn get(monitor: &Monitor, path: &str) -> (String, Vec<u8>) {
    let mut stream = TcpStream::connect(monitor.address()).unwrap();
    write!(stream, "GET {path} HTTP/1.1\r\nHost: localhost\r\n\r\n").unwrap();
    let mut bytes = Vec::new();
    stream.read_to_end(&mut bytes).unwrap();
    let end = bytes.windows(4).position(|four| four == b"\r\n\r\n").unwrap() + 4;
    (String::from_utf8_lossy(&bytes[..end]).into_owned(), bytes[end..].to_vec())
}

#[test]
fn shapes_and_meshes_of_an_arm() {
    let (folder, path) = folder();
    crane(&path, &|_| false);
    let stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 9 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
    std::fs::write(folder.path().join("boom.stl"), stl).unwrap();
    let urdf = URDF.replace(
        "<link name=\"boom\"/>",
        "<link name=\"boom\"><visual><geometry><mesh filename=\"boom.stl\" scale=\"2 1 1\"/></geometry></visual><visual>\
         <geometry><mesh filename=\"none.stl\"/></geometry></visual><visual><geometry><sphere radius=\"0.1\"/></geometry></visual></link>",
    );
    let mut settings = BagSettings { urdf: Some(urdf), ..BagSettings::default() };
    settings.meshes.roots = vec![folder.path().to_owned()];
    let (monitor, _) = monitor(play(&path, settings), false);
    assert!(monitor.damage().is_empty());
    let [note] = monitor.notes() else { panic!("{:?}", monitor.notes()) };
    assert!(note.contains("none.stl") && note.contains("--mesh-root"), "{note}");
    let mut page = Page::open(monitor.address());
    let scene = page.wait("scene", |_| true);
    let bodies = scene["arm"]["bodies"].as_array().unwrap();
    let kinds: Vec<_> = bodies.iter().map(|body| body["shape"]["kind"].as_str().unwrap()).collect();
    assert_eq!(kinds, ["mesh", "sphere"]);
    assert_eq!(scene["arm"]["joints"].as_array().unwrap().len(), 5);
    // The boom turns by at most 0.5 rad, 0.2 m and 0.625 m and 18 m out.
    let furthest = scene["space_m"][1][0].as_f64().unwrap();
    assert!((furthest - 18.8).abs() < 0.2, "{furthest}");
    let log = page.wait("log", |_| true);
    assert_eq!(log["notes"].as_array().unwrap().len(), 1);
    assert!((log["from_s"].as_f64().unwrap() - 0.5).abs() < 1e-6);
    // A part, its colour and counts, three corners of six numbers, three numbers of corners.
    let (head, mesh) = get(&monitor, "/mesh/0");
    assert!(head.starts_with("HTTP/1.1 200") && head.contains("nosniff"), "{head}");
    assert_eq!(mesh.len(), 4 * (1 + 6 + 18 + 3));
    for nothing in ["/mesh/1", "/mesh/", "/mesh/-1", "/mesh/boom.stl", "/mesh/../boom.stl", "/mesh/0/0"] {
        assert!(get(&monitor, nothing).0.starts_with("HTTP/1.1 404"), "{nothing}");
    }
}

#[test]
fn every_container_and_its_mutants() {
    const ARM: &str = r#"<robot name="arm"><link name="world"/><link name="cart"/><link name="lift"><visual><geometry><box size="1 2 3"/></geometry></visual></link>
<joint name="base" type="revolute"><parent link="world"/><child link="cart"/><limit lower="-2" upper="2" effort="1" velocity="1"/></joint>
<joint name="arm" type="continuous"><parent link="cart"/><child link="lift"/><origin xyz="0 0 0.1"/></joint></robot>"#;
    let start = |path: &Path| {
        let settings = Settings {
            listen: "127.0.0.1:0".parse().unwrap(),
            hosts: Vec::new(),
            commands: false,
            note: Box::new(|_| {}),
        };
        let bag = BagSettings { urdf: Some(ARM.into()), ..BagSettings::default() };
        Monitor::start(play(path, bag), settings)
    };
    let (files, folders) = recordings();
    for file in files.iter().chain(&folders) {
        let monitor = start(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        drop(monitor);
    }
    each_mutant(51, |path| drop(start(path))).unwrap();
}
