//! Messages of Protocol Buffers in their binary form: fields one after another, each with its number, kind and value
//! (<https://protobuf.dev/programming-guides/encoding>).

/// Kinds of fields: a number of as many bytes as it needs, and bytes after their length.
const VARINT: u64 = 0;
const LENGTH_DELIMITED: u64 = 2;

/// A message. Empty texts and lists are left out: a reader takes a missing field for an empty one.
#[derive(Default)]
pub(super) struct Message(Vec<u8>);

impl Message {
    pub fn integer(mut self, field: u64, value: i64) -> Self {
        varint(&mut self.0, field << 3 | VARINT);
        varint(&mut self.0, value.cast_unsigned());
        self
    }

    pub fn text(self, field: u64, text: &str) -> Self {
        if text.is_empty() { self } else { self.bytes(field, text.as_bytes()) }
    }

    pub fn texts(self, field: u64, texts: &[&str]) -> Self {
        texts.iter().fold(self, |message, text| message.bytes(field, text.as_bytes()))
    }

    pub fn message(self, field: u64, inner: Self) -> Self {
        self.bytes(field, &inner.0)
    }

    pub fn messages(self, field: u64, inner: impl IntoIterator<Item = Self>) -> Self {
        inner.into_iter().fold(self, |message, inner| message.message(field, inner))
    }

    pub fn integers(self, field: u64, values: &[i64]) -> Self {
        let mut packed = Vec::new();
        values.iter().for_each(|value| varint(&mut packed, value.cast_unsigned()));
        if packed.is_empty() { self } else { self.bytes(field, &packed) }
    }

    pub fn doubles(self, field: u64, values: &[f64]) -> Self {
        let packed: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        if packed.is_empty() { self } else { self.bytes(field, &packed) }
    }

    pub fn into_bytes(self) -> Vec<u8> {
        self.0
    }

    fn bytes(mut self, field: u64, bytes: &[u8]) -> Self {
        varint(&mut self.0, field << 3 | LENGTH_DELIMITED);
        varint(&mut self.0, bytes.len() as u64);
        self.0.extend(bytes);
        self
    }
}

/// Seven bits a byte, the lowest first; the highest bit of a byte says that more follow.
fn varint(bytes: &mut Vec<u8>, mut value: u64) {
    while value >= 0x80 {
        bytes.push(value as u8 | 0x80);
        value >>= 7;
    }
    bytes.push(value as u8);
}

#[cfg(test)]
mod tests {
    use super::Message;

    /// The examples of protobuf.dev/programming-guides/encoding.
    #[test]
    fn published_messages_of_the_guide() {
        assert_eq!(Message::default().integer(1, 150).into_bytes(), [0x08, 0x96, 0x01]);
        assert_eq!(Message::default().integer(1, -2).into_bytes(), [8, 254, 255, 255, 255, 255, 255, 255, 255, 255, 1]);
        assert_eq!(Message::default().text(2, "testing").into_bytes(), *b"\x12\x07testing");
        let inner = Message::default().integer(1, 150);
        assert_eq!(Message::default().message(3, inner).into_bytes(), [0x1a, 0x03, 0x08, 0x96, 0x01]);
        let packed = Message::default().integers(6, &[3, 270, 86942]);
        assert_eq!(packed.into_bytes(), [0x32, 0x06, 0x03, 0x8e, 0x02, 0x9e, 0xa7, 0x05]);
    }

    #[test]
    fn empty_texts_and_lists_are_left_out() {
        let message = Message::default().text(1, "").integers(2, &[]).doubles(3, &[]).texts(4, &[]).messages(5, []);
        assert!(message.into_bytes().is_empty());
    }
}
