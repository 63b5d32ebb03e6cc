//! The campaign description: defaults, errors by key, and the way to a file and back.

use soilctl_strokes::Campaign;

#[test]
fn every_key_is_optional_and_unknown_ones_are_ignored() {
    let campaign = Campaign::from_json("{\"design\": null}", "c.json").unwrap();
    assert_eq!(campaign, Campaign::default());
    assert_eq!(Campaign::from_json("\u{feff}{}", "c.json").unwrap(), Campaign::default());
}

#[test]
fn given_keys_are_taken_over() {
    let json = r#"{"phi_independent_deg": 38, "dense_preparation": true, "instrument": {"tare_sd": 0.2}}"#;
    let campaign = Campaign::from_json(json, "c.json").unwrap();
    assert_eq!(campaign.phi_independent_deg, Some(38.0));
    assert_eq!(campaign.phi_independent_sd, Some(1.0));
    assert!(campaign.dense_preparation);
    assert_eq!(campaign.instrument.tare_sd, 0.2);
    assert_eq!(campaign.instrument.z_sd, Campaign::default().instrument.z_sd);
}

#[test]
fn a_wrong_value_is_reported_with_its_key() {
    for (json, parts) in [
        (r#"{"delta_sd_deg": "1"}"#, ["key delta_sd_deg is \"1\"", "at least 0", "it is 1)"]),
        (r#"{"depth_sd_m": -1}"#, ["key depth_sd_m is -1", "at least 0", "0.0005"]),
        (r#"{"phi_independent_deg": 95}"#, ["key phi_independent_deg is 95", "below 90", "unknown"]),
        (r#"{"phi_independent_sd": 0}"#, ["key phi_independent_sd is 0", "above 0", ""]),
        (r#"{"dense_preparation": 1}"#, ["key dense_preparation is 1", "true or false", "false"]),
        (r#"{"design": []}"#, ["key design is []", "text in quotes", ""]),
        (r#"{"instrument": 3}"#, ["key instrument is 3", "an object", "defaults"]),
        (
            r#"{"instrument": {"joint_stiffness_n_per_m": 0}}"#,
            ["key instrument.joint_stiffness", "above 0", ""],
        ),
        ("[1]", ["c.json is not a JSON object", "[1]", "braces"]),
        ("{\"design\": ", ["c.json is not a JSON object", "line 1", "column"]),
        ("{\"depth_sd_m\": NaN}", ["c.json is not a JSON object", "line 1", "column"]),
    ] {
        let message = Campaign::from_json(json, "c.json").unwrap_err().to_string();
        for part in parts {
            assert!(message.contains(part), "{part:?} is not in: {message}");
        }
    }
}

#[test]
fn a_key_that_means_nothing_is_refused_with_the_nearest_one() {
    for (json, parts) in [
        (r#"{"delta_sd_dge": 2}"#, ["c.json, key delta_sd_dge", "most like it is delta_sd_deg"]),
        (
            r#"{"instrument": {"joint_stiffness": 1}}"#,
            ["key instrument.joint_stiffness ", "is instrument.joint_stiffness_n_per_m"],
        ),
        // A key at the wrong level is misspelt, too, and `null` does not hide it.
        (r#"{"tare_sd": null}"#, ["key tare_sd", "known are instrument, phi_independent_deg"]),
        (r#"{"instrument": {"Z_sd": 0.1}}"#, ["key instrument.Z_sd", "is instrument.z_sd"]),
    ] {
        let message = Campaign::from_json(json, "c.json").unwrap_err().to_string();
        for part in parts {
            assert!(message.contains(part), "{part:?} is not in: {message}");
        }
    }
}

#[test]
fn it_stands_beside_the_strokes() {
    let dir = tempfile::tempdir().unwrap();
    let strokes = dir.path().join("strokes.csv");
    assert_eq!(Campaign::read_beside(&strokes).unwrap(), None);
    let mut campaign = Campaign { design: "Table 6.2".into(), ..Campaign::default() };
    campaign.instrument.z_sd = 0.1 + 0.2;
    campaign.write_beside(&strokes).unwrap();
    assert_eq!(Campaign::read_beside(&strokes).unwrap(), Some(campaign));
}
