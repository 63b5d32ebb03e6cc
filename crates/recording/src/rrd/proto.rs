//! The few protocol-buffer messages of the file format, written by hand: field by field, in rising order.

use super::Id;

/// A message that is being put together.
#[derive(Debug, Default)]
pub(super) struct Message(Vec<u8>);

impl Message {
    pub(super) fn number(self, field: u8, value: u64) -> Self {
        self.key(field, 0).varint(value)
    }

    pub(super) fn bytes(self, field: u8, value: &[u8]) -> Self {
        let mut longer = self.key(field, 2).varint(value.len() as u64);
        longer.0.extend_from_slice(value);
        longer
    }

    pub(super) fn message(self, field: u8, value: &Self) -> Self {
        self.bytes(field, &value.0)
    }

    fn fixed(self, field: u8, value: u64) -> Self {
        let mut longer = self.key(field, 1);
        longer.0.extend_from_slice(&value.to_le_bytes());
        longer
    }

    pub(super) fn as_bytes(&self) -> &[u8] {
        &self.0
    }

    fn key(self, field: u8, wire: u64) -> Self {
        self.varint(u64::from(field) << 3 | wire)
    }

    fn varint(mut self, mut value: u64) -> Self {
        while value >= 0x80 {
            self.0.push(value.to_le_bytes()[0] | 0x80);
            value >>= 7;
        }
        self.0.push(value.to_le_bytes()[0]);
        self
    }
}

/// What a file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Recording = 1,
    Blueprint = 2,
}

/// `StoreId`.
pub(super) fn store(kind: Kind, id: &str) -> Message {
    let application = Message::default().bytes(1, super::APPLICATION.as_bytes());
    Message::default().number(1, kind as u64).bytes(2, id.as_bytes()).message(3, &application)
}

/// `SetStoreInfo`.
pub(super) fn set_store_info(row: Id, store: &Message) -> Message {
    const OTHER_PROGRAM: u64 = 6;
    let name = Message::default().bytes(1, super::APPLICATION.as_bytes());
    let source = Message::default().number(1, OTHER_PROGRAM).message(2, &name);
    let info = Message::default().message(2, store).message(5, &source);
    Message::default().message(1, &tuid(row)).message(2, &info)
}

/// `ArrowMsg` with a payload compressed by LZ4.
pub(super) fn arrow(store: &Message, chunk: Id, is_static: bool, ipc: &[u8]) -> Message {
    const LZ4: u64 = 2;
    const ARROW_IPC: u64 = 1;
    Message::default()
        .message(1, store)
        .number(2, LZ4)
        .number(3, ipc.len() as u64)
        .number(4, ARROW_IPC)
        .bytes(5, &lz4_flex::block::compress(ipc))
        .message(6, &tuid(chunk))
        .number(7, u64::from(is_static))
}

/// `BlueprintActivationCommand`.
pub(super) fn activate(blueprint: &Message) -> Message {
    Message::default().message(1, blueprint).number(2, 1).number(3, 1)
}

fn tuid(id: Id) -> Message {
    Message::default().fixed(1, id.high()).fixed(2, id.low())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The example of the protocol-buffer documentation: 150 in field 1, "testing" in field 2.
    #[test]
    fn fields_are_encoded_as_the_documentation_says() {
        assert_eq!(Message::default().number(1, 150).as_bytes(), [0x08, 0x96, 0x01]);
        let text = Message::default().bytes(2, b"testing");
        assert_eq!(text.as_bytes(), [0x12, 0x07, 0x74, 0x65, 0x73, 0x74, 0x69, 0x6e, 0x67]);
        let inner = Message::default().message(3, &Message::default().number(1, 150));
        assert_eq!(inner.as_bytes(), [0x1a, 0x03, 0x08, 0x96, 0x01]);
    }
}
