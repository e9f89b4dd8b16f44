//! Records as Parquet stores its metadata: the compact protocol of Apache Thrift (thrift/doc/specs/thrift-compact-protocol.md), of
//! which runs need truth values, integers, texts, lists and structs.

use super::cursor::{Cursor, write_varint, write_zigzag};
use super::error::ParquetError;

/// Lists and structs within each other. Those of a footer are nine deep.
const DEEPEST: usize = 24;
/// Values of one record. A footer has some thirty for each column of a row group; each takes 40 bytes of memory, and one of the file.
const MOST_VALUES: usize = 1 << 22;

const STOP: u8 = 0;
const TRUE: u8 = 1;
const FALSE: u8 = 2;
const BYTE: u8 = 3;
const I16: u8 = 4;
const I32: u8 = 5;
const I64: u8 = 6;
const BINARY: u8 = 8;
const LIST: u8 = 9;
const STRUCT: u8 = 12;

/// A value of a record.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    Truth(bool),
    Byte(i8),
    I32(i32),
    I64(i64),
    Bytes(Vec<u8>),
    List(Vec<Value>),
    Struct(Fields),
}

/// The fields of a struct by their numbers, which go up.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Fields(Vec<(i16, Value)>);

impl Value {
    /// A text.
    pub fn text(text: &str) -> Self {
        Self::Bytes(text.as_bytes().to_vec())
    }

    /// A list of numbers.
    pub fn numbers(numbers: &[i32]) -> Self {
        Self::List(numbers.iter().map(|&number| Self::I32(number)).collect())
    }

    fn code(&self) -> u8 {
        match self {
            Self::Truth(true) => TRUE,
            Self::Truth(false) => FALSE,
            Self::Byte(_) => BYTE,
            Self::I32(_) => I32,
            Self::I64(_) => I64,
            Self::Bytes(_) => BINARY,
            Self::List(_) => LIST,
            Self::Struct(_) => STRUCT,
        }
    }

    /// Appends the value alone. Of a truth value, the type of its field says all.
    fn write(&self, bytes: &mut Vec<u8>) {
        match self {
            Self::Truth(_) => (),
            Self::Byte(number) => bytes.push(number.cast_unsigned()),
            Self::I32(number) => write_zigzag(bytes, i64::from(*number)),
            Self::I64(number) => write_zigzag(bytes, *number),
            Self::Bytes(content) => {
                write_varint(bytes, content.len() as u64);
                bytes.extend(content);
            }
            Self::List(items) => {
                let code = items.first().map_or(STRUCT, Self::code);
                if items.len() < 15 {
                    bytes.push((items.len() as u8) << 4 | code);
                } else {
                    bytes.push(0xf0 | code);
                    write_varint(bytes, items.len() as u64);
                }
                items.iter().for_each(|item| item.write(bytes));
            }
            Self::Struct(fields) => fields.write(bytes),
        }
    }

    fn read(
        cursor: &mut Cursor<'_>,
        code: u8,
        is_item: bool,
        depth: usize,
        values: &mut usize,
    ) -> Result<Self, ParquetError> {
        if depth > DEEPEST {
            return Err(ParquetError::wrong("the depth of the metadata", depth, format!("at most {DEEPEST}")));
        }
        *values += 1;
        if *values > MOST_VALUES {
            let rule = format!("at most {MOST_VALUES}");
            return Err(ParquetError::wrong("the number of values of the metadata", *values, rule));
        }
        let what = "a value of the metadata";
        Ok(match code {
            TRUE | FALSE if is_item => Self::Truth(cursor.array(what)? == [TRUE]),
            TRUE | FALSE => Self::Truth(code == TRUE),
            BYTE => Self::Byte(i8::from_le_bytes(cursor.array(what)?)),
            I16 | I32 => {
                let number = cursor.zigzag(what)?;
                let of_32_bits = i32::try_from(number);
                Self::I32(of_32_bits.map_err(|_| ParquetError::wrong(what, number, "a number of 32 bits"))?)
            }
            I64 => Self::I64(cursor.zigzag(what)?),
            BINARY => {
                let length = cursor.varint(what)?;
                Self::Bytes(cursor.take("a text of the metadata", length)?.to_vec())
            }
            LIST => {
                let [header] = cursor.array("a list of the metadata")?;
                let length = if header >> 4 < 15 { u64::from(header >> 4) } else { cursor.varint(what)? };
                // An item takes a byte at least.
                if length > cursor.left() as u64 {
                    let what = "a list of the metadata";
                    return Err(ParquetError::CutShort { what, needed: length, left: cursor.left() });
                }
                let mut items = Vec::new();
                for _ in 0..length {
                    items.push(Self::read(cursor, header & 15, true, depth + 1, values)?);
                }
                Self::List(items)
            }
            STRUCT => Self::Struct(Fields::read_within(cursor, depth + 1, values)?),
            _ => return Err(ParquetError::wrong("a type of the metadata", code, "one that runs use")),
        })
    }
}

impl Fields {
    /// Those of a struct; `None` is not written.
    pub fn new(fields: impl IntoIterator<Item = (i16, Option<Value>)>) -> Self {
        Self(fields.into_iter().filter_map(|(number, value)| Some((number, value?))).collect())
    }

    /// Appends the struct: of each field the step from the number of the last one, which is below 16, and its type, then its value.
    pub fn write(&self, bytes: &mut Vec<u8>) {
        let mut last = 0;
        for (number, value) in &self.0 {
            bytes.push(((number - last) as u8) << 4 | value.code());
            value.write(bytes);
            last = *number;
        }
        bytes.push(STOP);
    }

    /// The struct at `cursor`.
    ///
    /// # Errors
    /// What `parquet.thrift` has no use for, and bytes that end too early.
    pub fn read(cursor: &mut Cursor<'_>) -> Result<Self, ParquetError> {
        Self::read_within(cursor, 0, &mut 0)
    }

    fn read_within(cursor: &mut Cursor<'_>, depth: usize, values: &mut usize) -> Result<Self, ParquetError> {
        let (mut fields, mut last) = (Vec::new(), 0_i16);
        loop {
            let [header] = cursor.array("a field of the metadata")?;
            if header == STOP {
                return Ok(Self(fields));
            }
            let step = i64::from(header >> 4);
            let number = if step > 0 { i64::from(last) + step } else { cursor.zigzag("a field of the metadata")? };
            last = i16::try_from(number)
                .map_err(|_| ParquetError::wrong("the number of a field", number, "a number of 16 bits"))?;
            fields.push((last, Value::read(cursor, header & 15, false, depth, values)?));
        }
    }

    fn get(&self, number: i16) -> Option<&Value> {
        self.0.iter().find_map(|(own, value)| (*own == number).then_some(value))
    }

    /// Field `number` where it is there and an integer.
    pub fn integer(&self, number: i16) -> Option<i64> {
        match self.get(number)? {
            Value::Byte(number) => Some(i64::from(*number)),
            Value::I32(number) => Some(i64::from(*number)),
            Value::I64(number) => Some(*number),
            _ => None,
        }
    }

    /// Field `number`, an integer that counts or measures `what`.
    pub fn size(&self, number: i16, what: &'static str) -> Result<usize, ParquetError> {
        let size = self.integer(number).ok_or(ParquetError::Missing { what })?;
        usize::try_from(size).map_err(|_| ParquetError::wrong(what, size, "at least 0"))
    }

    /// Field `number` where it is there and a truth value.
    pub fn truth(&self, number: i16) -> Option<bool> {
        if let Value::Truth(truth) = self.get(number)? { Some(*truth) } else { None }
    }

    /// Field `number` where it is there and a struct.
    pub fn fields(&self, number: i16) -> Option<&Fields> {
        if let Value::Struct(fields) = self.get(number)? { Some(fields) } else { None }
    }

    /// Field `number` where it is there and a text.
    pub fn text(&self, number: i16) -> Result<Option<&str>, ParquetError> {
        let Some(Value::Bytes(bytes)) = self.get(number) else { return Ok(None) };
        std::str::from_utf8(bytes).map(Some).map_err(|_| ParquetError::NotUtf8)
    }

    /// The structs of the list in field `number`, which is a list of `what`; none where it is not there.
    ///
    /// # Errors
    /// Another value, and items that are no structs.
    pub fn list<'a>(&'a self, number: i16, what: &'static str) -> Result<Vec<&'a Fields>, ParquetError> {
        let wrong = |value: &Value| ParquetError::OtherType { what, code: value.code() };
        match self.get(number) {
            None => Ok(Vec::new()),
            Some(Value::List(items)) => {
                let fields =
                    |item: &'a Value| if let Value::Struct(fields) = item { Ok(fields) } else { Err(wrong(item)) };
                items.iter().map(fields).collect()
            }
            Some(value) => Err(wrong(value)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(fields: &Fields) -> Vec<u8> {
        let mut bytes = Vec::new();
        fields.write(&mut bytes);
        bytes
    }

    /// Field headers, integers, texts, truth values and the short form of lists as the specification draws them.
    #[test]
    fn published_struct_of_the_compact_protocol() {
        let fields = Fields::new([
            (1, Some(Value::I32(-1))),
            (2, None),
            (4, Some(Value::text("ab"))),
            (5, Some(Value::Truth(true))),
            (6, Some(Value::Truth(false))),
            (7, Some(Value::numbers(&[0, 3, 8]))),
            (15, Some(Value::Struct(Fields::new([(10, Some(Value::Byte(64)))])))),
            (16, Some(Value::I64(i64::MIN))),
        ]);
        let bytes = written(&fields);
        assert_eq!(bytes[..6], [0x15, 0x01, 0x38, 0x02, b'a', b'b']);
        assert_eq!(bytes[6..12], [0x11, 0x12, 0x19, 0x35, 0x00, 0x06]);
        assert_eq!(bytes[12..17], [0x10, 0x8c, 0xa3, 0x40, 0x00]);
        assert_eq!(bytes[17..], [0x16, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x01, 0x00]);
        assert_eq!(Fields::read(&mut Cursor::new(&bytes)), Ok(fields));
    }

    /// The long forms: a list of more than 14 items, and a field number that is written out (here 20, then -1).
    #[test]
    fn published_long_forms() {
        let fields = Fields::new([(3, Some(Value::numbers(&[1; 15])))]);
        let bytes = written(&fields);
        assert_eq!(bytes[..4], [0x39, 0xf5, 15, 2]);
        assert_eq!(Fields::read(&mut Cursor::new(&bytes)), Ok(fields));
        let read = Fields::read(&mut Cursor::new(&[0x05, 40, 2, 0x04, 1, 4, 0x19, 0x21, 1, 2, 0])).expect("fields");
        assert_eq!((read.integer(20), read.integer(-1)), (Some(1), Some(2)));
        assert_eq!(read.get(0), Some(&Value::List(vec![Value::Truth(true), Value::Truth(false)])));
    }

    #[test]
    fn a_list_of_other_items_is_refused() {
        let fields = Fields::new([(1, Some(Value::numbers(&[3]))), (2, Some(Value::I32(3)))]);
        let told = |number| fields.list(number, "the row groups").expect_err("no structs").to_string();
        assert_eq!(told(1), "the row groups: a value of type 5 stands there; must be a list of structs");
        assert_eq!(told(2), "the row groups: a value of type 5 stands there; must be a list of structs");
        assert_eq!(fields.list(3, "the row groups"), Ok(Vec::new()));
    }

    /// A list of empty structs takes a byte of the file and forty of memory for each.
    #[test]
    fn more_values_than_a_footer_has_are_refused() {
        let mut bytes = vec![0x19, 0xfc];
        write_varint(&mut bytes, MOST_VALUES as u64);
        bytes.resize(bytes.len() + MOST_VALUES + 1, 0);
        let told = Fields::read(&mut Cursor::new(&bytes)).expect_err("too many").to_string();
        assert_eq!(told, "the number of values of the metadata is 4194305; must be at most 4194304");
    }

    #[test]
    fn crooked_structs_are_refused() {
        let told = |bytes: &[u8]| Fields::read(&mut Cursor::new(bytes)).expect_err("no fields").to_string();
        assert_eq!(told(&[0x15]), "a value of the metadata: 1 bytes are needed where 0 are left");
        assert_eq!(
            told(&[0x18, 0xff, 0xff, 0x7f]),
            "a text of the metadata: 2097151 bytes are needed where 0 are left"
        );
        assert_eq!(
            told(&[0x19, 0xfc, 0xff, 0xff, 0x7f]),
            "a list of the metadata: 2097151 bytes are needed where 0 are left"
        );
        assert_eq!(told(&[0x1b, 0]), "a type of the metadata is 11; must be one that runs use");
        assert_eq!(told(&[0x1c; 99]), "the depth of the metadata is 25; must be at most 24");
        assert_eq!(told(&[0x19; 99]), "the depth of the metadata is 25; must be at most 24");
        assert_eq!(
            told(&[0x05, 0xff, 0xff, 0x7f, 2]),
            "the number of a field is -1048576; must be a number of 16 bits"
        );
    }
}
