use serde_json::{Map, Value, json};

use super::Command;

/// A command as a person types it: its name and the keys of what it needs, in the order in which values without a key are
/// taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CommandWord {
    /// Its name.
    pub name: &'static str,
    /// Its keys.
    pub keys: &'static [&'static str],
    /// What may stand there, for completion; empty for numbers.
    pub choices: &'static [&'static str],
    /// What it does.
    pub help: &'static str,
}

const fn word(
    name: &'static str,
    keys: &'static [&'static str],
    choices: &'static [&'static str],
    help: &'static str,
) -> CommandWord {
    CommandWord { name, keys, choices, help }
}

/// All commands of the protocol.
pub const COMMANDS: [CommandWord; 23] = [
    word("enable", &[], &[], "amplifiers on; the arm holds where it is"),
    word("disable", &[], &[], "amplifiers off"),
    word("reset", &[], &[], "leave the safe state after a fault, to off"),
    word(
        "start",
        &["sequence"],
        &["homing", "wall_sensing", "insert_stroke_pullout", "campaign", "friction_sweep"],
        "start a sequence",
    ),
    word("abort", &[], &[], "end sequence and motion; the arm holds where it is"),
    word("continue", &[], &[], "the soil is prepared: go on"),
    word("store", &["on"], &["true", "false"], "switch storage on or off"),
    word("bias", &[], &[], "take the force sensor's bias; plate in free air"),
    word(
        "stroke",
        &["radius_m", "base_deg", "tool_angle_deg", "depth_m", "delta_deg", "batch"],
        &[],
        "the stroke that insert_stroke_pullout makes",
    ),
    word("plan_index", &["index"], &[], "stroke of the plan, from 0, at which a campaign begins"),
    word(
        "set",
        &["parameter", "value"],
        &["speed_scale", "lead_rate_m_s", "accommodate", "law"],
        "set a parameter",
    ),
    word("move_joints", &["joints_deg"], &[], "move all joints, as in move_joints 0,30,100,0,30"),
    word("move_tip", &["x_m", "y_m", "z_m", "tool_angle_deg"], &[], "move the tip along a straight line"),
    word("touch", &["direction", "travel_m"], &[], "move the tip until it touches, as in touch 0,0,-1 0.05"),
    word("insert", &["depth_m"], &[], "push the plate into the soil"),
    word("pull", &["delta_deg", "law"], &["force", "position"], "pull the plate until the soil fails"),
    word("velocity", &["rates_deg_s", "seconds"], &[], "turn joints, as in velocity 5,0,0,0,0 2"),
    word(
        "follow",
        &["x_m", "y_m", "z_m", "tool_angle_deg", "hand"],
        &[],
        "lead the plate by hand; say it again within 0.2 s, or the arm stops",
    ),
    word("hold", &["seconds"], &[], "hold for a time"),
    word("emergency_stop", &[], &[], "press the emergency stop"),
    word("release_stop", &[], &[], "release the emergency stop; then reset"),
    word("advance", &["seconds"], &[], "let simulated time go on"),
    word("end", &[], &[], "end the session: safe state, log closed"),
];

/// The command in a line such as `start homing`, `set speed_scale 0.5` or `stroke radius_m=0.43 base_deg=0 ...`. Values are
/// true, false, numbers, numbers with commas between them, or names.
///
/// # Errors
/// In words: no such command, a value too many, one that is missing or of the wrong kind.
pub fn parse_command(line: &str) -> Result<Command, String> {
    let mut words = line.split_whitespace();
    let name = words.next().unwrap_or_default();
    let known = COMMANDS.iter().find(|known| known.name == name).ok_or_else(|| {
        let names: Vec<_> = COMMANDS.iter().map(|known| known.name).collect();
        format!("there is no command `{name}`; there are {}", names.join(", "))
    })?;
    let mut object = Map::from_iter([("name".to_owned(), json!(name))]);
    let mut free = known.keys.iter();
    for text in words {
        let (key, text) = match text.split_once('=') {
            Some((key, text)) if known.keys.contains(&key) => (key, text),
            Some((key, _)) => return Err(format!("{name} has no `{key}`; {}", usage(known))),
            None => match free.find(|key| !object.contains_key(**key)) {
                Some(key) => (*key, text),
                None => return Err(format!("`{text}` is too much; {}", usage(known))),
            },
        };
        object.insert(key.to_owned(), value(text));
    }
    serde_json::from_value(Value::Object(object)).map_err(|error| format!("{error}; {}", usage(known)))
}

fn usage(word: &CommandWord) -> String {
    let keys: String = word.keys.iter().map(|key| format!(" {}", key.to_uppercase())).collect();
    format!("usage: {}{keys}", word.name)
}

fn value(text: &str) -> Value {
    let number = |text: &str| text.parse::<f64>().ok().filter(|number| number.is_finite());
    if let Ok(flag) = text.parse::<bool>() {
        return json!(flag);
    }
    if let Ok(whole) = text.parse::<u32>() {
        return json!(whole);
    }
    if let Some(number) = number(text) {
        return json!(number);
    }
    match text.split(',').map(number).collect::<Option<Vec<_>>>() {
        Some(list) => json!(list),
        None => json!(text),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_become_commands() {
        assert_eq!(parse_command("enable"), Ok(Command::Enable));
        assert_eq!(parse_command(" start  homing "), Ok(Command::Start { sequence: "homing".to_owned() }));
        assert_eq!(
            parse_command("move_joints 0,30,100.5,0,-30"),
            Ok(Command::MoveJoints { joints_deg: [0.0, 30.0, 100.5, 0.0, -30.0] })
        );
        let stroke = parse_command("stroke 0.43 delta_deg=23 0 80 0.025").unwrap();
        let wanted = Command::Stroke {
            radius_m: 0.43,
            base_deg: 0.0,
            tool_angle_deg: 80.0,
            depth_m: 0.025,
            delta_deg: 23.0,
            batch: 0,
        };
        assert_eq!(stroke, wanted);
        for (line, reason) in [
            ("", "no command ``"),
            ("jump", "there are enable"),
            ("start", "missing field `sequence`"),
            ("start homing now", "too much; usage: start SEQUENCE"),
            ("hold minutes=1", "no `minutes`"),
            ("hold long", "invalid type"),
            ("hold NaN", "invalid type"),
        ] {
            let error = parse_command(line).unwrap_err();
            assert!(error.contains(reason), "{line}: {error}");
        }
    }

    /// Every word leads to a command, and every command of the protocol has its word.
    #[test]
    fn words_and_commands_are_the_same() {
        let schema = schemars::schema_for!(Command);
        let variants = schema.get("oneOf").and_then(Value::as_array).unwrap();
        let mut names: Vec<_> =
            variants.iter().map(|one| one["properties"]["name"]["const"].as_str().unwrap()).collect();
        let mut words: Vec<_> = COMMANDS.iter().map(|word| word.name).collect();
        names.sort_unstable();
        words.sort_unstable();
        assert_eq!(names, words);
        for variant in variants {
            let name = variant["properties"]["name"]["const"].as_str().unwrap();
            let word = COMMANDS.iter().find(|word| word.name == name).unwrap();
            let keys = variant["properties"].as_object().unwrap().keys();
            let mut keys: Vec<_> = keys.filter(|key| *key != "name").map(String::as_str).collect();
            let mut known = word.keys.to_vec();
            keys.sort_unstable();
            known.sort_unstable();
            assert_eq!(keys, known, "{name}");
        }
    }
}
