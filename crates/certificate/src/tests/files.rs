#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::fs;

use tempfile::tempdir;

use crate::examples::{rankine_field, wall, wedge_field};
use crate::{CertificateError, Claim, Objective, SCHEMA, Scale, Solution, prove};

pub(super) fn solution() -> Solution {
    Solution {
        schema: SCHEMA.into(),
        program: "test 0".into(),
        statement: wall(),
        scale: Scale { length_m: Some(0.1), ..Scale::default() },
        lower: Some(Claim { field: rankine_field(4, 2.9), claimed: 99.0, computed: None }),
        upper: Some(Claim { field: wedge_field(1.8), claimed: 0.1, computed: None }),
        mechanism: None,
        space: None,
    }
}

#[test]
fn a_file_restores_every_number() {
    let folder = tempdir().unwrap();
    let path = folder.path().join("a.json");
    let mut written = solution();
    written.statement.objective = Objective::Structure { velocity: [0.1 + 0.2, 5e-324] };
    written.write(&path).unwrap();
    assert_eq!(Solution::read(&path).unwrap(), written);
}

#[test]
fn files_call_gauges_chains() {
    let text = serde_json::to_string(&solution()).unwrap();
    for words in [
        r#""chains":[{"constant":0.0,"gradient":{"free":{"x":0.0,"y":0.0}}}]"#,
        r#""jet":{"chain":{"chain":0}}"#,
    ] {
        assert!(text.contains(words), "{words} in {text}");
    }
}

#[test]
fn claims_are_not_trusted() {
    let proof = prove(&solution()).unwrap();
    let (lower, upper) = (proof.lower.unwrap(), proof.upper.unwrap());
    assert_eq!((lower.claimed, upper.claimed), (99.0, 0.1));
    assert!((lower.proven - 5.8).abs() < 1e-9);
    assert!((upper.proven - 1.8 * 12.0_f64.sqrt()).abs() < 1e-9);
}

#[test]
fn what_is_no_solution_is_refused() {
    let folder = tempdir().unwrap();
    let path = folder.path().join("a.json");
    let text = serde_json::to_string(&solution()).unwrap();
    let read = |text: &str| {
        fs::write(&path, text).unwrap();
        Solution::read(&path).map(|_| ()).unwrap_err()
    };
    let nested = "[".repeat(100_000);
    for bad in ["", "{}", "null", &nested, &text[..text.len() - 1]] {
        assert!(matches!(read(bad), CertificateError::Format { .. }));
    }
    for (old, new) in [
        ("\"datum\":", "\"extra\":1,\"datum\":"),
        ("\"datum\":0.0", "\"datum\":1e999"),
        ("\"datum\":0.0", "\"datum\":null"),
        ("\"region\":0", "\"region\":-1"),
        ("\"region\":0", "\"region\":0.5"),
        ("\"inside\"", "\"outside\""),
        ("\"claimed\":", "\"x\":0,\"claimed\":"),
    ] {
        assert!(text.contains(old), "{old}");
        let error = read(&text.replacen(old, new, 1));
        assert!(matches!(error, CertificateError::Format { .. }), "{new}: {error}");
    }
    let other = read(&text.replacen(SCHEMA, "soilctl.solution/2", 1));
    assert!(matches!(other, CertificateError::Schema { .. }), "{other}");
    let missing = Solution::read(&folder.path().join("b.json")).unwrap_err();
    assert!(matches!(missing, CertificateError::File { .. }), "{missing}");
    let mut nan = solution();
    nan.statement.datum = f64::NAN;
    assert!(matches!(nan.write(&path).unwrap_err(), CertificateError::Format { .. }));
    assert!(matches!(prove(&nan).unwrap_err(), CertificateError::OutOfRange { .. }));
}
