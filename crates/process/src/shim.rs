//! Stands in for the crate that reads all containers.
#![allow(missing_docs)]
use soilctl_session::messages::{JointState, StringMessage, WrenchStamped, decode};
use soilctl_session::read::Channel;
pub(crate) use soilctl_session::read::{Item, RawMessage, scan};
#[derive(Default)]
pub(crate) struct Readers;
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Joints,
    Wrench,
    Text,
}
impl Kind {
    pub(crate) fn message_type(self) -> &'static str {
        match self {
            Self::Joints => "sensor_msgs/msg/JointState",
            Self::Wrench => "geometry_msgs/msg/WrenchStamped",
            Self::Text => "std_msgs/msg/String",
        }
    }
}
pub(crate) enum Reading {
    Joints { stamp_ns: Option<i64>, names: Vec<String>, positions: Vec<f64> },
    Wrench { stamp_ns: Option<i64>, frame: String, wrench: [f64; 6] },
    Text(String),
}
impl Readers {
    pub(crate) fn kind(&mut self, channel: &Channel) -> Option<Kind> {
        [Kind::Joints, Kind::Wrench, Kind::Text]
            .into_iter()
            .find(|k| k.message_type() == channel.message_type)
    }
    pub(crate) fn read(&mut self, message: &RawMessage<'_>) -> Option<Result<Reading, String>> {
        Some(match self.kind(message.channel)? {
            Kind::Joints => decode::<JointState>(message.data).map_err(|e| e.to_string()).and_then(|m| {
                if m.name.len() == m.position.len() {
                    Ok(Reading::Joints {
                        stamp_ns: m.header.stamp.ns(),
                        names: m.name,
                        positions: m.position,
                    })
                } else {
                    Err("lengths".into())
                }
            }),
            Kind::Wrench => decode::<WrenchStamped>(message.data).map_err(|e| e.to_string()).map(|m| {
                let [f, t] = [m.wrench.force, m.wrench.torque];
                Reading::Wrench {
                    stamp_ns: m.header.stamp.ns(),
                    frame: m.header.frame_id,
                    wrench: [f.x, f.y, f.z, t.x, t.y, t.z],
                }
            }),
            Kind::Text => decode::<StringMessage>(message.data)
                .map_err(|e| e.to_string())
                .map(|m| Reading::Text(m.data)),
        })
    }
}
