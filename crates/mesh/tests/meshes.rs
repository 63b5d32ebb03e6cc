//! Meshes from files, and files that are none.
#![allow(clippy::unwrap_used)]

use std::fs;
use std::path::Path;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use soilctl_mesh::{Budget, MeshError, Sought, find, load};

/// A triangle with a node that turns it by a quarter about y, shifts it and makes it twice as large.
fn gltf(buffer: &str) -> String {
    format!(
        r#"{{"asset":{{"version":"2.0"}},"nodes":[{{"mesh":0,"translation":[0,0,5],"rotation":[0,0.70710678118654752,0,0.70710678118654752],
        "scale":[2,2,2]}}],"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":2}},"indices":1,"material":0}}]}}],
        "materials":[{{"pbrMetallicRoughness":{{"baseColorFactor":[1,0,0.25,0.5]}}}}],
        "accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}},{{"bufferView":1,"componentType":5121,"count":3,"type":"SCALAR"}},
        {{"bufferView":0,"byteOffset":36,"componentType":5126,"count":3,"type":"VEC3"}}],
        "bufferViews":[{{"buffer":0,"byteLength":72}},{{"buffer":0,"byteOffset":72,"byteLength":3}}],
        "buffers":[{{"byteLength":75,"uri":"{buffer}"}}]}}"#
    )
}

fn buffer() -> Vec<u8> {
    let points = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let normals = [0.0_f32, 0.0, 1.0].repeat(3);
    let bytes = points.iter().chain(&normals).flat_map(|value| value.to_le_bytes());
    bytes.chain([0, 1, 2]).collect()
}

fn sought(folder: &Path) -> Sought {
    Sought { roots: vec![folder.to_owned()], urdf_folder: None }
}

#[test]
fn gltf_with_nodes_colours_and_buffers() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("a.bin"), buffer()).unwrap();
    fs::write(folder.path().join("beside.gltf"), gltf("a.bin")).unwrap();
    let data = format!("data:application/octet-stream;base64,{}", STANDARD.encode(buffer()));
    fs::write(folder.path().join("within.gltf"), gltf(&data)).unwrap();
    let read = |name: &str| load(name, &sought(folder.path()), &mut Budget::default());
    let mesh = read("beside.gltf").unwrap();
    assert_eq!(mesh, read("within.gltf").unwrap());
    let [part] = &mesh.parts[..] else { panic!("{mesh:?}") };
    // By hand: x goes to -z, twice as large, 5 m along z; then y up becomes z up, so (x, y, z) is (x, -z, y).
    let expected = [[0.0, -5.0, 0.0], [0.0, -3.0, 0.0], [0.0, -5.0, 2.0]];
    for (found, expected) in part.points.iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() < 1e-6, "{:?}", part.points);
    }
    // z goes to x.
    for (found, expected) in part.normals[0].iter().zip([1.0, 0.0, 0.0]) {
        assert!((found - expected).abs() < 1e-6, "{:?}", part.normals);
    }
    let [red, green, blue, opacity] = part.colour.unwrap();
    assert_eq!((red, green, opacity), (1.0, 0.0, 0.5));
    assert!((blue - 0.25_f32.powf(1.0 / 2.2)).abs() < 1e-6);

    // A buffer elsewhere is no buffer of it.
    fs::create_dir(folder.path().join("sub")).unwrap();
    for elsewhere in ["../a.bin", "/etc/passwd", "file:///etc/passwd", "http://a/b"] {
        fs::write(folder.path().join("sub/c.gltf"), gltf(elsewhere)).unwrap();
        assert!(matches!(read("sub/c.gltf"), Err(MeshError::Malformed { .. })), "{elsewhere}");
    }
}

#[test]
fn numbers_that_reach_too_far_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let data = format!("data:;base64,{}", STANDARD.encode(buffer()));
    let good = gltf(&data);
    let refuse = |from: &str, to: &str| {
        assert!(good.contains(from), "{from}");
        fs::write(folder.path().join("a.gltf"), good.replace(from, to)).unwrap();
        let error = load("a.gltf", &sought(folder.path()), &mut Budget::default()).unwrap_err();
        assert!(matches!(error, MeshError::Malformed { .. } | MeshError::TooLarge { .. }), "{to}: {error}");
    };
    refuse("\"byteLength\":72}", "\"byteLength\":73000}");
    refuse("\"count\":3,\"type\":\"VEC3\"},{", "\"count\":18446744073709551615,\"type\":\"VEC3\"},{");
    refuse("\"count\":3,\"type\":\"VEC3\"},{", "\"count\":4000000000,\"type\":\"VEC3\"},{");
    refuse("\"byteOffset\":36", "\"byteOffset\":18446744073709551615");
    refuse("\"bufferView\":0,", "\"bufferView\":9,");
    refuse("\"version\":\"2.0\"", "\"version\":\"1.0\"");
    refuse("\"mesh\":0,", "\"mesh\":7,");
    refuse(
        "\"nodes\":[{\"mesh\":0,",
        "\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"children\":[0,0],\"mesh\":0,",
    );
    // The third corner is the second one, which makes no triangle with flat shades, and one of no size with normals: harmless.
    refuse("\"componentType\":5121", "\"componentType\":5126");
    let mut far = buffer();
    far[74] = 9;
    fs::write(folder.path().join("a.gltf"), gltf(&format!("data:;base64,{}", STANDARD.encode(far)))).unwrap();
    assert!(load("a.gltf", &sought(folder.path()), &mut Budget::default()).is_err());
}

#[test]
fn files_are_found_where_the_documentation_says() {
    let folder = tempfile::tempdir().unwrap();
    let place = |path: &str| {
        let path = folder.path().join(path);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, "solid").unwrap();
        path.canonicalize().unwrap()
    };
    let mesh = place("ws/src/arm_description/meshes/visual/a.stl");
    fs::create_dir_all(folder.path().join("ws/src/arm_description/urdf")).unwrap();
    let urdf =
        Sought { roots: Vec::new(), urdf_folder: Some(folder.path().join("ws/src/arm_description/urdf")) };
    let root = |path: &str| Sought { roots: vec![folder.path().join(path)], urdf_folder: None };
    let found = |name: &str, sought: &Sought| find(name, sought).map(|path| path.canonicalize().unwrap());
    for sought in [&urdf, &root("ws/src"), &root("ws/src/arm_description")] {
        assert_eq!(found("package://arm_description/meshes/visual/a.stl", sought).unwrap(), mesh);
    }
    assert_eq!(found("../meshes/visual/a.stl", &urdf).unwrap(), mesh);
    let name = "file:///home/other/ws/src/arm_description/meshes/visual/a.stl";
    assert_eq!(found(name, &root("ws/src")).unwrap(), mesh);
    for outside in [
        "../../../../../../../../etc/passwd",
        "",
        "package://",
        "a/../../b",
        "http://example.org/a.stl",
        "a\0b",
    ] {
        assert!(matches!(find(outside, &urdf), Err(MeshError::Name { .. })), "{outside}");
    }
    assert!(matches!(find("/etc/passwd", &root("ws")), Err(MeshError::Missing { .. })));
    assert!(matches!(find("package://other/a.stl", &urdf), Err(MeshError::Missing { .. })));
    fs::write(folder.path().join("a.dae"), "<COLLADA/>").unwrap();
    let error = load("a.dae", &root("."), &mut Budget::default()).unwrap_err();
    assert!(matches!(error, MeshError::Kind { .. }), "{error}");
}
