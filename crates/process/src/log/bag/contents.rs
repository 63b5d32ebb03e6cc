use std::collections::BTreeMap;

use soilctl_session::messages::{StringMessage, decode};
use soilctl_session::read::Item;

use super::listed;
use crate::ProcessError;

const TEXT: &str = "std_msgs/msg/String";

/// Topics of a bag and the first URDF in it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct BagContents {
    /// Name and type of each topic that has messages; those under `/truth` are left out.
    topics: BTreeMap<String, String>,
    urdf: Option<String>,
}

impl BagContents {
    /// Notes what an item of the bag tells.
    pub fn note(&mut self, item: &Item<'_>) {
        match item {
            Item::Message(message) if !message.channel.topic.starts_with("/truth") => {
                let channel = message.channel;
                if !self.topics.contains_key(&channel.topic) {
                    self.topics.insert(channel.topic.clone(), channel.message_type.clone());
                }
                if self.urdf.is_none() && channel.message_type == TEXT {
                    self.urdf = decode(message.data)
                        .ok()
                        .map(|StringMessage { data }| data)
                        .filter(|text| is_urdf(text));
                }
            }
            Item::Attachment { data, .. } if self.urdf.is_none() => {
                self.urdf = std::str::from_utf8(data).ok().filter(|text| is_urdf(text)).map(str::to_owned);
            }
            _ => {}
        }
    }

    /// Text of the URDF: of a `std_msgs/msg/String` such as `/robot_description`, or attached.
    #[must_use]
    pub fn urdf(&self) -> Option<&str> {
        self.urdf.as_deref()
    }

    /// The topic of a type that was asked for, the usual one, or the only one of its type.
    ///
    /// # Errors
    /// [`ProcessError::Topic`] with the topics there are.
    pub fn choose(
        &self,
        asked: Option<&str>,
        usual: &str,
        message_type: &'static str,
    ) -> Result<String, ProcessError> {
        let of_type: Vec<&String> =
            self.topics.iter().filter(|(_, known)| *known == message_type).map(|(name, _)| name).collect();
        let found = match asked {
            Some(name) => of_type.iter().find(|known| **known == name),
            None => of_type.iter().find(|known| **known == usual).or(match of_type.as_slice() {
                [only] => Some(only),
                _ => None,
            }),
        };
        found.map(|name| (*name).clone()).ok_or_else(|| ProcessError::Topic {
            wanted: asked.unwrap_or(usual).to_owned(),
            message_type,
            known: listed(self.topics.iter().map(|(name, known)| format!("{name} ({known})"))),
        })
    }
}

fn is_urdf(text: &str) -> bool {
    text.contains("<robot")
}
