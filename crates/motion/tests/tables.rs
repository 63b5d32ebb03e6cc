//! Topics as tables.
#![allow(clippy::unwrap_used)]

mod common;

use std::sync::atomic::AtomicBool;

use common::{Bag, crane, folder, positions};
use soilctl_columns::{Cell, Form, Kind};
use soilctl_motion::{MotionError, table, write_table};

#[test]
fn a_topic_is_a_table_on_the_one_clock() {
    let (_folder, path) = folder();
    crane(&path, &|_| false);
    let (mut names, mut rows) = (Vec::new(), Vec::new());
    let found = table(
        &path,
        "/joint_states",
        &AtomicBool::new(false),
        &mut |header| {
            names = header.to_vec();
            Ok(())
        },
        &mut |row| {
            rows.push(row.to_vec());
            Ok(())
        },
    )
    .unwrap();
    assert_eq!((found.rows, found.columns, found.clock.origin_s), (1000, names.len(), common::START_S));
    let place = |name: &str| names.iter().position(|(known, _)| known == name).unwrap();
    assert_eq!(names[0], ("time_s".to_owned(), Kind::Float));
    for (k, row) in (0..).zip(&rows) {
        let t_s = 0.5 + 0.01 * f64::from(k);
        assert!((row[0].number().unwrap() - t_s).abs() < 1e-6);
        assert_eq!(row[place("reach_position")], Cell::Float(positions(t_s)[1].1));
        assert!(row[place("turn_effort")].number().unwrap().is_nan());
    }
    // Without a stamp the time of the log counts, which is 2 ms ahead.
    let mut first_s = f64::NAN;
    table(&path, "/robot_description", &AtomicBool::new(false), &mut |_| Ok(()), &mut |row| {
        first_s = row[0].number().unwrap();
        Ok(())
    })
    .unwrap();
    assert!((first_s - 0.498).abs() < 1e-6, "{first_s}");
}

/// Two parts of a robot on one topic: the table has the joints of both.
#[test]
fn messages_with_other_joints_share_a_table() {
    let (folder, path) = folder();
    let mut bag = Bag::new(&path);
    bag.joints("/joint_states", 0.1, &[("a", 1.0)]);
    bag.joints("/joint_states", 0.2, &[("b", 2.0), ("a", 3.0)]);
    bag.put("/joint_states", common::JOINTS, 0.3, &[0, 1, 0, 0, 1]);
    bag.finish();
    let out = folder.path().join("out.csv");
    let found = write_table(&path, "/joint_states", &out, Form::Csv, &AtomicBool::new(false)).unwrap();
    assert_eq!((found.rows, found.malformed, found.ending.damage.len()), (2, 1, 1));
    let text = std::fs::read_to_string(&out).unwrap();
    let lines: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    let place = |name: &str| lines[0].iter().position(|known| *known == name).unwrap();
    assert_eq!((lines[1][place("a_position")], lines[1][place("b_position")]), ("1", "NaN"));
    assert_eq!((lines[2][place("a_position")], lines[2][place("b_position")]), ("3", "2"));

    let error = write_table(&path, "/none", &out, Form::Csv, &AtomicBool::new(false)).unwrap_err();
    assert!(matches!(&error, MotionError::NoTopic { known, .. } if known == "/joint_states"), "{error}");
}
