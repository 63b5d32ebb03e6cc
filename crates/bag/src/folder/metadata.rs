use std::fs::File;
use std::io::Read;
use std::path::Path;

use saphyr_parser::{Event, Parser};

/// Name of the file that ROS 2 writes beside the parts of a bag.
pub(super) const NAME: &str = "metadata.yaml";
/// Key under which all stands.
const ROOT: &str = "rosbag2_bagfile_information";
/// Longest file that is read, in bytes. A thousand topics take 1 MB.
const MOST_BYTES: u64 = 4 << 20;
/// Most parts of a recording. A day in parts of ten seconds has 8640.
const MOST_FILES: usize = 20_000;
/// Deepest nesting. ROS 2 has five levels.
const MOST_LEVELS: usize = 32;

/// What is needed of it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Metadata {
    pub(super) files: Vec<String>,
    pub(super) compression_format: String,
    pub(super) compression_mode: String,
}

/// The text of the file; nothing if there is none.
///
/// # Errors
/// In words.
pub(super) fn text(folder: &Path) -> Result<Option<String>, String> {
    let file = match File::open(folder.join(NAME)) {
        Ok(file) => file,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(format!("{NAME} cannot be opened: {error}")),
    };
    let mut text = String::new();
    file.take(MOST_BYTES + 1)
        .read_to_string(&mut text)
        .map_err(|error| format!("{NAME} cannot be read: {error}"))?;
    if text.len() as u64 > MOST_BYTES {
        return Err(format!("{NAME} has more than {MOST_BYTES} bytes, the most that is read"));
    }
    Ok(Some(text))
}

/// Whether this is the text of a bag and not of something else.
pub(super) fn is_of_a_bag(text: &str) -> bool {
    text.contains(ROOT)
}

/// Walks over the text as it is parsed, and builds nothing of it but what is needed. Aliases are never followed, so they cannot
/// multiply.
///
/// # Errors
/// In words.
pub(super) fn metadata(text: &str) -> Result<Metadata, String> {
    let mut walk = Walk::default();
    for event in Parser::new_from_str(text) {
        let (event, _) = event.map_err(|error| format!("{NAME} is malformed: {error}"))?;
        match event {
            Event::Scalar(text, ..) => walk.scalar(&text),
            Event::Alias(_) => walk.scalar(""),
            Event::MappingStart(..) => walk.levels.push(Level::Mapping { key: None }),
            Event::SequenceStart(..) => walk.levels.push(Level::Sequence),
            Event::MappingEnd | Event::SequenceEnd => {
                walk.levels.pop();
                walk.value_done();
            }
            // Other documents of the same file are not ours.
            Event::DocumentEnd => break,
            _ => {}
        }
        if walk.found.files.len() > MOST_FILES {
            return Err(format!("{NAME} lists more than {MOST_FILES} files"));
        }
        if walk.levels.len() > MOST_LEVELS {
            return Err(format!("{NAME} is nested more than {MOST_LEVELS} deep"));
        }
    }
    Ok(walk.found)
}

enum Level {
    Mapping { key: Option<String> },
    Sequence,
}

#[derive(Default)]
struct Walk {
    levels: Vec<Level>,
    found: Metadata,
}

impl Walk {
    fn scalar(&mut self, text: &str) {
        if let Some(Level::Mapping { key: key @ None }) = self.levels.last_mut() {
            *key = Some(text.to_owned());
            return;
        }
        match self.levels.as_slice() {
            [Level::Mapping { key: Some(root) }, Level::Mapping { key: Some(key) }] if root == ROOT => {
                match key.as_str() {
                    "compression_format" => text.clone_into(&mut self.found.compression_format),
                    "compression_mode" => text.clone_into(&mut self.found.compression_mode),
                    _ => {}
                }
            }
            [Level::Mapping { key: Some(root) }, Level::Mapping { key: Some(key) }, Level::Sequence]
                if root == ROOT && key == "relative_file_paths" =>
            {
                self.found.files.push(text.to_owned());
            }
            _ => {}
        }
        self.value_done();
    }

    /// After a value comes the next key.
    fn value_done(&mut self) {
        if let Some(Level::Mapping { key }) = self.levels.last_mut() {
            *key = None;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn finds_what_ros_writes_and_nothing_else() {
        let text = "other: {compression_mode: FILE}\nrosbag2_bagfile_information:\n  compression_mode: MESSAGE\n  \
                    compression_format: zstd\n  relative_file_paths: [a_0.db3, \"a_1.db3\"]\n  files:\n    - path: b.db3\n      \
                    relative_file_paths: [c]\n";
        let found = metadata(text).unwrap();
        assert_eq!(found.files, ["a_0.db3", "a_1.db3"]);
        assert_eq!((found.compression_mode.as_str(), found.compression_format.as_str()), ("MESSAGE", "zstd"));
        // Qualities of service in a text, as Humble writes them.
        let text = "rosbag2_bagfile_information:\n  topics_with_message_count:\n    - topic_metadata:\n        \
                    offered_qos_profiles: \"- history: 3\\n  depth: 0\"\n  relative_file_paths:\n    - x.mcap";
        assert_eq!(metadata(text).unwrap().files, ["x.mcap"]);
        assert_eq!(metadata("").unwrap(), Metadata::default());
    }

    #[test]
    fn hostile_texts_end() {
        let bomb = (1..30).fold("a0: &a0 [x, x, x]\n".to_owned(), |text, i| {
            text + &format!("a{i}: &a{i} [*a{}, *a{}, *a{}]\n", i - 1, i - 1, i - 1)
        });
        assert!(metadata(&bomb).is_ok());
        let long = 100_000;
        for text in [
            "[", "{", "- ", "? ", "&a ", "!x ", "a: ", "\"", "|\n ", "#", "[a,", "{a:", "*a ", "---\n", "\t",
            "%", "'", "\u{feff}",
        ] {
            let started = std::time::Instant::now();
            let _ = metadata(&text.repeat(long));
            let _ = metadata(&format!("rosbag2_bagfile_information: {}", text.repeat(long)));
            assert!(started.elapsed().as_secs() < 5, "{text:?} took {:?}", started.elapsed());
        }
    }
}
