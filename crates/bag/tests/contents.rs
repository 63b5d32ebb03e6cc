//! What is in a recording, how regularly it comes, and every topic as a table.
#![allow(clippy::unwrap_used, clippy::expect_used)]

mod common;

use common::{START_NS, STEP_NS, data};
use soilctl_bag::{
    BagError, Channel, Clock, Contents, Item, Kind, Rate, Rates, RawMessage, Readers, contents, scan,
};

fn rates(name: &str) -> std::collections::BTreeMap<String, Rate> {
    let mut rates = Rates::default();
    scan::<BagError>(&data(name), &mut |item| {
        if let Item::Message(message) = item {
            rates.note(&message);
        }
        Ok(())
    })
    .unwrap();
    rates.finish()
}

#[test]
fn contents_of_every_container() {
    for name in ["lz4.mcap", "split", "sqlite", "sqlite_message", "none.bag", "ros1.mcap"] {
        let found = contents(&data(name)).unwrap();
        assert!(found.ending.is_whole(), "{name}");
        let told: Vec<_> =
            found.topics.iter().map(|(name, topic)| (name.as_str(), topic.messages, topic.kind)).collect();
        assert_eq!(
            told,
            [
                ("/bare_wrench", 4, Some(Kind::Wrench)),
                ("/everything", 4, None),
                ("/joint_states", 16, Some(Kind::Joints)),
                ("/robot_description", 1, Some(Kind::Text)),
                ("/vendor/force", 4, Some(Kind::Wrench)),
                ("/wrench", 16, Some(Kind::Wrench)),
            ],
            "{name}"
        );
        let wrench = &found.topics["/wrench"];
        assert_eq!(wrench.first_ns, START_NS.unsigned_abs() + 2);
        assert_eq!(wrench.last_ns, (START_NS + 15 * STEP_NS + 2).unsigned_abs());
        assert!(found.urdf.unwrap().contains("<robot name"));
        assert_eq!(
            found.profile,
            if name.contains("ros1") || name.contains("bag") { "ros1" } else { "ros2" }
        );
    }
    let found = contents(&data("old.db3")).unwrap();
    assert!(found.topics["/vendor/force"].problem.as_ref().unwrap().contains("no definition"));
}

#[test]
fn a_topic_is_chosen_or_the_error_lists_them() {
    let found = contents(&data("lz4.mcap")).unwrap();
    let choose = |asked, usual, kind| found.choose(asked, usual, kind);
    assert_eq!(choose(None, "/joint_states", Kind::Joints).unwrap(), "/joint_states");
    assert_eq!(choose(None, "/other", Kind::Joints).unwrap(), "/joint_states", "the only one");
    assert_eq!(choose(None, "/wrench", Kind::Wrench).unwrap(), "/wrench");
    assert_eq!(choose(Some("/vendor/force"), "/wrench", Kind::Wrench).unwrap(), "/vendor/force");
    for (asked, usual, kind) in [
        (None, "/ft", Kind::Wrench),
        (Some("/nothing"), "/wrench", Kind::Wrench),
        (Some("/wrench"), "/x", Kind::Joints),
    ] {
        let said = choose(asked, usual, kind).unwrap_err().to_string();
        assert!(said.contains("/vendor/force (my_robot_msgs/msg/MyWrench)"), "{said}");
        assert!(said.contains(asked.unwrap_or(usual)) && !said.contains("/truth"), "{said}");
    }
    let old = contents(&data("old.db3")).unwrap();
    let said = old.choose(Some("/vendor/force"), "/wrench", Kind::Wrench).unwrap_err();
    assert!(matches!(said, BagError::Unreadable { .. }), "{said}");
    let none = Contents::default().choose(None, "/wrench", Kind::Wrench).unwrap_err().to_string();
    assert!(none.contains("its topics are none"), "{none}");
}

#[test]
fn rates_of_a_recording() {
    for name in ["lz4.mcap", "sqlite", "bz2.bag"] {
        let rates = rates(name);
        assert!(!rates.contains_key("/truth/soil"));
        let wrench = &rates["/wrench"];
        assert_eq!(wrench.clock, Clock::Stamp);
        assert_eq!((wrench.messages, wrench.gaps), (16, 0));
        assert_eq!(wrench.rate_hz(), Some(100.0));
        let stamps = wrench.stamps.unwrap();
        assert_eq!((stamps.unset, stamps.out_of_order, stamps.duplicates, stamps.malformed), (0, 0, 0, 0));
        assert_eq!(stamps.largest_offset_ns, 498);
        let bare = &rates["/bare_wrench"];
        assert_eq!((bare.clock, bare.stamps, bare.rate_hz()), (Clock::Log, None, Some(25.0)));
        assert_eq!(rates["/robot_description"].rate_hz(), None);
    }
}

/// Stamps as bad drivers set them.
#[test]
fn odd_stamps_are_counted() {
    let channel = Channel {
        topic: "/wrench".into(),
        message_type: "geometry_msgs/msg/WrenchStamped".into(),
        message_encoding: "cdr".into(),
        schema_encoding: String::new(),
        schema: Vec::new(),
        metadata: Default::default(),
    };
    let mut rates = Rates::default();
    let mut note = |log_s: u64, sec: u32, length: usize| {
        let mut data = vec![0, 1, 0, 0];
        data.extend(sec.to_le_bytes());
        data.resize(length, 0);
        let log_time_ns = log_s * 1_000_000_000;
        rates.note(&RawMessage {
            channel_id: 3,
            channel: &channel,
            sequence: 0,
            log_time_ns,
            publish_time_ns: log_time_ns,
            data: &data,
        });
    };
    for (log_s, sec, length) in [
        (10, 10, 72),
        (11, 11, 72),
        (12, 11, 72),
        (13, 12, 72),
        (14, 9, 72),
        (15, 13, 72),
        (16, 0, 72),
        (40, 14, 72),
        (41, 9, 6),
    ] {
        note(log_s, sec, length);
    }
    let rate = rates.finish().remove("/wrench").unwrap();
    let stamps = rate.stamps.unwrap();
    assert_eq!((stamps.unset, stamps.out_of_order, stamps.duplicates, stamps.malformed), (1, 1, 1, 1));
    assert_eq!(stamps.largest_offset_ns, -26_000_000_000);
    // Some have no stamp, so the times of recording count.
    assert_eq!((rate.clock, rate.gaps, rate.interval_ns), (Clock::Log, 1, Some(1e9)));
    assert_eq!(
        (rate.longest_gaps[0].from_ns, rate.longest_gaps[0].length_ns),
        (16_000_000_000, 24_000_000_000)
    );
}

#[test]
fn any_topic_is_a_table() {
    for name in ["lz4.mcap", "big_endian.mcap", "none.bag", "sqlite"] {
        let ros1 = name == "none.bag";
        let (mut rows, mut readers) = (std::collections::BTreeMap::new(), Readers::new());
        scan::<BagError>(&data(name), &mut |item| {
            if let Item::Message(message) = item {
                let cells = readers.reader(&message).unwrap().cells(message.data).unwrap();
                let text: Vec<String> = cells.iter().map(|(name, cell)| format!("{name}={cell}")).collect();
                rows.insert(message.channel.topic.clone(), text.join("|"));
            }
            Ok(())
        })
        .unwrap();
        let seq = |text: &str| if ros1 { format!("header_seq=7|{text}") } else { text.to_owned() };
        // Of the last message on each topic.
        assert_eq!(
            rows["/joint_states"],
            seq(
                "stamp_s=1700000000.15|header_frame_id=|base_position=1.875|base_velocity=0.125|base_effort=NaN|arm_position=-1.875|\
                 arm_velocity=0.25|arm_effort=NaN|bucket_é_position=2|bucket_é_velocity=0.5|bucket_é_effort=NaN"
            ),
            "{name}"
        );
        assert_eq!(
            rows["/vendor/force"],
            seq(
                "stamp_s=1700000000.1200008|header_frame_id=flange|wrench_force_x=1.5|wrench_force_y=-1.5|wrench_force_z=1|\
                 wrench_torque_x=0.5|wrench_torque_y=0.25|wrench_torque_z=24|status=12|sensor=s"
            ),
            "{name}"
        );
        assert_eq!(
            rows["/everything"],
            seq(
                "stamp_s=1700000000.12|header_frame_id=f|flag=true|i8=-5|u16=60000|i64=-1099511627776|f32=0.125|text=a, b|\
                 vector_0=1|vector_1=2|vector_2=3|bytes=1; 2; 255|names=x; yz|pair_count=1|pair_value=0.5|\
                 pairs=0 0; 1 0.125; 2 0.25|two_0_count=9|two_0_value=-1|two_1_count=8|two_1_value=-2|last=true"
            ),
            "{name}"
        );
        assert_eq!(rows["/truth/soil"], "data=sand");
    }
}
