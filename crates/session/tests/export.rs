//! A table is whole, or it is not there.
#![allow(clippy::unwrap_used, clippy::panic)]

mod common;

use std::collections::BTreeMap;
use std::fs::File;
use std::path::Path;

use mcap::records::MessageHeader;
use soilctl_session::read::{Item, scan};
use soilctl_session::{Form, SessionError, export, topics};

/// A log with one good step and one that is none.
fn half_good(good: &Path, out: &Path) {
    let mut message = None;
    scan::<SessionError>(good, &mut |item| {
        if let Item::Message(found) = item
            && found.channel.topic == topics::STEP
            && message.is_none()
        {
            message = Some((found.channel.clone(), found.data.to_vec()));
        }
        Ok(())
    })
    .unwrap();
    let (channel, data) = message.unwrap();
    let mut writer = mcap::Writer::new(File::create(out).unwrap()).unwrap();
    let schema = writer.add_schema(&channel.message_type, &channel.schema_encoding, &channel.schema).unwrap();
    let id = writer.add_channel(schema, &channel.topic, &channel.message_encoding, &BTreeMap::new()).unwrap();
    for (sequence, data) in [(0, &data[..]), (1, &data[..data.len() / 2])] {
        let header = MessageHeader { channel_id: id, sequence, log_time: 0, publish_time: 0 };
        writer.write_to_known_channel(&header, data).unwrap();
    }
    writer.finish().unwrap();
}

#[test]
fn a_malformed_message_leaves_no_part_of_a_table() {
    let dir = tempfile::tempdir().unwrap();
    let (good, bad) = (dir.path().join("good.mcap"), dir.path().join("bad.mcap"));
    common::write_log(&good, 1, 5);
    half_good(&good, &bad);
    for (name, form) in [("t.csv", Form::Csv), ("t.parquet", Form::Parquet)] {
        let out = dir.path().join(name);
        let error = export(&bad, topics::STEP, &out, form).unwrap_err();
        assert!(matches!(error, SessionError::Message { number: 1, .. }), "{error}");
        let files = || std::fs::read_dir(dir.path()).unwrap().count();
        let before = files();
        assert!(!out.exists() && before >= 2);
        // What was there stays as it was.
        std::fs::write(&out, "old").unwrap();
        export(&bad, topics::STEP, &out, form).unwrap_err();
        assert_eq!(std::fs::read_to_string(&out).unwrap(), "old");
        assert_eq!(files(), before + 1, "nothing lies beside it");
        assert_eq!(export(&good, topics::STEP, &out, form).unwrap().rows, 5);
        assert_eq!(files(), before + 1);
    }
}
