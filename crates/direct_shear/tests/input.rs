//! Tables that are right, and what is said about those that are not.
#![allow(clippy::unwrap_used)]

mod common;

use common::table_6_13;
use soilctl_direct_shear::{
    DirectShearError, FrictionCurve, LogLogFit, ShearPoint, parse_shear_points, read_shear_points,
};
use soilctl_soil::{Angle, units};

const HEADER: &str = "soil,normal_stress_psi,friction_angle_deg\n";

fn error(text: &str) -> String {
    parse_shear_points(text.as_bytes(), "shear.csv").unwrap_err().to_string()
}

/// Every fragment must be in the message.
fn says(message: &str, fragments: &[&str]) {
    for fragment in fragments {
        assert!(message.contains(fragment), "`{fragment}` is not in: {message}");
    }
}

#[test]
fn table_6_13_comes_in_its_own_order() {
    let table = table_6_13();
    let names: Vec<_> = table.iter().map(|series| series.soil.as_deref().unwrap()).collect();
    assert_eq!(names, ["ticino_loose", "nevada_fine", "ticino_rained", "glass_beads"]);
    assert!(table.iter().all(|series| series.points.len() == 7));
    assert!((table[3].points[0].normal_stress_pa() - units::psi_to_pa(0.18)).abs() < 1e-9);
}

#[test]
fn pascals_other_columns_comments_and_a_byte_order_mark_are_read() {
    let text =
        "\u{feff}# made by hand\nnote,friction_angle_deg,normal_stress_pa\r\n\r\nx,40.5,1000\r\n,38,2e3\r\n";
    let table = parse_shear_points(text.as_bytes(), "shear.csv").unwrap();
    assert_eq!((table.len(), table[0].soil.as_deref()), (1, None));
    assert_eq!(table[0].points[1], ShearPoint::new(2000.0, Angle::from_degrees(38.0)).unwrap());
}

#[test]
fn interleaved_soils_keep_the_order_of_their_first_line() {
    let table =
        parse_shear_points(format!("{HEADER}b,1,30\na,1,31\nb,2,29\n").as_bytes(), "shear.csv").unwrap();
    assert_eq!((table[0].soil.as_deref(), table[0].points.len()), (Some("b"), 2));
    assert_eq!((table[1].soil.as_deref(), table[1].points.len()), (Some("a"), 1));
}

#[test]
fn a_bad_cell_is_named_by_line_and_column() {
    says(
        &error(&format!("{HEADER}a,0.18,41\n\n# x\n\na,0,39\n")),
        &["shear.csv, line 6, column `normal_stress_psi`", "\"0\"", "psi"],
    );
    says(&error("soil,normal_stress_psi,friction_angle_deg\r\na,1,40\r\n\r\na,2,95\r\n"), &["line 4"]);
    for bad in ["90", "0", "-3", "NaN", "inf", "steep", ""] {
        says(
            &error(&format!("{HEADER}a,1,{bad}\n")),
            &["line 2, column `friction_angle_deg`", &format!("\"{bad}\""), "above 0 and below 90 deg"],
        );
    }
    for bad in ["-1", "NaN", "1e300", "1e-300"] {
        says(&error(&format!("{HEADER}a,{bad},40\n")), &["line 2, column `normal_stress_psi`", bad]);
    }
    says(&error(&format!("{HEADER},1,40\n")), &["line 2, column `soil`", "not empty"]);
}

#[test]
fn bad_columns_are_named() {
    says(&error("soil,friction_angle_deg\na,40\n"), &["line 1", "normal_stress_psi", "`soil`"]);
    says(&error("normal_stress_pa\n1\n"), &["`friction_angle_deg` is missing"]);
    says(&error("normal_stress_pa,normal_stress_psi,friction_angle_deg\n1,1,40\n"), &["both", "keep one"]);
    says(&error("Soil,normal_stress_pa,friction_angle_deg\na,1,40\n"), &["`Soil`", "write `soil`"]);
    says(&error("normal_stress_pa,soil,soil,friction_angle_deg\n1,a,a,40\n"), &["twice"]);
}

#[test]
fn bad_files_are_explained() {
    says(&error(""), &["shear.csv", "no rows"]);
    says(&error(HEADER), &["no rows"]);
    says(&error(&format!("{HEADER}\na,0,18,40\n")), &["line 3", "4 cells", "point"]);
    let bytes = [HEADER.as_bytes(), b"a,1,40\n\xff,1,40\n"].concat();
    says(&parse_shear_points(&bytes, "shear.csv").unwrap_err().to_string(), &["line 3", "UTF-8"]);
    let missing = read_shear_points("no/such/file.csv").unwrap_err();
    assert!(matches!(missing, DirectShearError::Io { .. }));
    says(&missing.to_string(), &["no/such/file.csv"]);
}

#[test]
fn a_file_on_disk_is_named_in_messages() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("mine.csv");
    std::fs::write(&path, format!("{HEADER}a,1,95\n")).unwrap();
    says(&read_shear_points(&path).unwrap_err().to_string(), &["mine.csv, line 2"]);
}

#[test]
fn serialised_names_carry_their_units() {
    let points = table_6_13().remove(0).points;
    let at = LogLogFit::fit(&points).unwrap().friction_at(1000.0).unwrap();
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.serialize(points[0]).unwrap();
    let text = String::from_utf8(writer.into_inner().unwrap()).unwrap();
    says(&text, &["normal_stress_pa,friction_angle_deg\n1241.0", "41.3"]);
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.serialize(at).unwrap();
    let text = String::from_utf8(writer.into_inner().unwrap()).unwrap();
    says(&text, &["normal_stress_pa,friction_angle_deg,extrapolated,standard_error_deg\n1000.0,"]);
}

proptest::proptest! {
    #[test]
    fn no_bytes_make_the_reader_panic(bytes in proptest::collection::vec(proptest::prelude::any::<u8>(), 0..200)) {
        let _ = parse_shear_points(&bytes, "shear.csv");
        let _ = parse_shear_points(&[HEADER.as_bytes(), &bytes].concat(), "shear.csv");
        let _ = soilctl_direct_shear::raw::parse_runs(&bytes, "runs.csv");
        let _ = soilctl_direct_shear::raw::parse_friction_loop(&bytes, "loop.csv");
    }
}
