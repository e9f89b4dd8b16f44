//! The entry `ARROW:schema` of a Parquet file, in which pyarrow and pandas find the unit of each column.
//!
//! It is the schema message of Arrow's IPC format, a FlatBuffer of the tables of `Message.fbs` and `Schema.fbs`, in Base64.

use crate::runs::table::{RunColumn, RunData};

/// Name of the entry among the key-value metadata of the file.
pub const ARROW_SCHEMA_KEY: &str = "ARROW:schema";
/// Key of the field metadata that holds the unit of a column.
const UNIT_KEY: &str = "unit";

/// `MetadataVersion.V5` and `MessageHeader.Schema`.
const METADATA_VERSION: u32 = 4;
const SCHEMA_HEADER: u32 = 1;
/// Members of the union `Type`.
const INT: u32 = 2;
const FLOATING_POINT: u32 = 3;
const UTF8: u32 = 5;
/// `Precision.DOUBLE`
const DOUBLE: u32 = 2;

/// The schema of `columns` with their units, as Parquet keeps it.
pub fn arrow_schema(columns: &[RunColumn]) -> String {
    let schema = Item::Table(vec![None, Some(Item::List(columns.iter().map(field).collect()))]);
    let message =
        Item::Table(vec![Some(Item::Number(METADATA_VERSION)), Some(Item::Number(SCHEMA_HEADER)), Some(schema)]);
    let buffer = message.to_buffer();
    let mut framed = vec![0xff; 4];
    framed.extend((buffer.len() as u32).to_le_bytes());
    framed.extend(buffer);
    base64(&framed)
}

/// A table `Field`: name, nullable, type (its member of the union, then its table), no dictionary, no children, metadata.
fn field(column: &RunColumn) -> Item {
    let number = |value: u32| Some(Item::Number(value));
    let text = |text: &str| Some(Item::Text(text.to_owned()));
    let (kind, details) = match column.data {
        RunData::F64(_) => (FLOATING_POINT, vec![number(DOUBLE)]),
        // 64 bits, not signed.
        RunData::U64(_) => (INT, vec![number(64), number(0)]),
        RunData::Text(_) => (UTF8, Vec::new()),
    };
    let unit = Item::Table(vec![text(UNIT_KEY), text(column.unit.symbol())]);
    Item::Table(vec![
        text(&column.name),
        number(u32::from(column.data.is_nullable())),
        number(kind),
        Some(Item::Table(details)),
        None,
        Some(Item::List(Vec::new())),
        Some(Item::List(vec![unit])),
    ])
}

/// A part of a FlatBuffer. Numbers of all widths take four bytes of their table, little-endian.
enum Item {
    Number(u32),
    Text(String),
    List(Vec<Item>),
    /// By the index of the field in its definition; `None` is not written.
    Table(Vec<Option<Item>>),
}

impl Item {
    /// The whole buffer: the place of this item, then the item; a multiple of eight bytes, as IPC asks for.
    fn to_buffer(&self) -> Vec<u8> {
        let mut buffer = Vec::new();
        self.write_cell(&mut buffer);
        let at = self.write(&mut buffer);
        point(&mut buffer, 0, at);
        align(&mut buffer, 8);
        buffer
    }

    /// What stands in a table or list: a number, or four bytes for the place of anything else.
    fn write_cell(&self, buffer: &mut Vec<u8>) {
        let number = if let Self::Number(number) = self { *number } else { 0 };
        buffer.extend(number.to_le_bytes());
    }

    /// Appends the item, and behind it what it points at; returns where it begins.
    fn write(&self, buffer: &mut Vec<u8>) -> usize {
        align(buffer, 4);
        match self {
            Self::Number(_) => buffer.len(),
            Self::Text(text) => {
                let at = write_length(buffer, text.len());
                buffer.extend(text.as_bytes());
                buffer.push(0);
                at
            }
            Self::List(items) => {
                let at = write_length(buffer, items.len());
                write_all(buffer, items.iter());
                at
            }
            Self::Table(fields) => {
                let present = fields.iter().flatten().count();
                let list_of_fields = buffer.len();
                let mut cell = 4_u16;
                buffer.extend((4 + 2 * fields.len() as u16).to_le_bytes());
                buffer.extend((4 + 4 * present as u16).to_le_bytes());
                for field in fields {
                    buffer.extend(if field.is_some() { cell } else { 0 }.to_le_bytes());
                    cell += if field.is_some() { 4 } else { 0 };
                }
                align(buffer, 4);
                let at = write_length(buffer, buffer.len() - list_of_fields);
                write_all(buffer, fields.iter().flatten());
                at
            }
        }
    }
}

/// Appends the cells of `items`, then what they point at.
fn write_all<'a>(buffer: &mut Vec<u8>, items: impl Iterator<Item = &'a Item> + Clone) {
    let first = buffer.len();
    items.clone().for_each(|item| item.write_cell(buffer));
    for (index, item) in items.enumerate() {
        if !matches!(item, Item::Number(_)) {
            let at = item.write(buffer);
            point(buffer, first + 4 * index, at);
        }
    }
}

/// Appends the number that a text, a list or a table begins with; returns its place.
fn write_length(buffer: &mut Vec<u8>, length: usize) -> usize {
    let at = buffer.len();
    buffer.extend((length as u32).to_le_bytes());
    at
}

/// Lets the four bytes at `cell` point at `at`, which comes later.
fn point(buffer: &mut [u8], cell: usize, at: usize) {
    buffer[cell..cell + 4].copy_from_slice(&((at - cell) as u32).to_le_bytes());
}

fn align(buffer: &mut Vec<u8>, bytes: usize) {
    buffer.resize(buffer.len().next_multiple_of(bytes), 0);
}

/// Base64 with padding (RFC 4648, section 4).
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for group in bytes.chunks(3) {
        let bits = (0..3).fold(0, |bits, k| bits << 8 | usize::from(*group.get(k).unwrap_or(&0)));
        for digit in 0..4 {
            text.push(if digit <= group.len() { DIGITS[bits >> (18 - 6 * digit) & 63] as char } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::base64;

    /// RFC 4648, section 10.
    #[test]
    fn published_base64_of_the_standard() {
        for (bytes, text) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }
}
