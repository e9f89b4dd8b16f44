//! Groups of a binary file.

use super::error::{DxfError, DxfProblem, FilePosition};
use super::group::{Group, Value, ValueType};

/// First bytes of a binary file.
pub(super) const SENTINEL: &[u8] = b"AutoCAD Binary DXF\r\n\x1a\0";

/// The groups of a binary file. Numbers are little-endian.
pub(super) struct BinaryGroups<'a> {
    bytes: &'a [u8],
    /// Bytes read.
    at: usize,
    /// Codes have two bytes since R13; before that one, or three of which the first is 255.
    has_wide_codes: bool,
}

impl<'a> BinaryGroups<'a> {
    /// The groups behind the sentinel.
    pub fn of(bytes: &'a [u8]) -> Self {
        // The first group is 0 SECTION, or a comment.
        const SECTION: [u8; 2] = 0_u16.to_le_bytes();
        const COMMENT: [u8; 2] = 999_u16.to_le_bytes();
        let has_wide_codes = bytes.starts_with(&SECTION) || bytes.starts_with(&COMMENT);
        Self { bytes, at: 0, has_wide_codes }
    }

    /// The place in the file of the next byte.
    pub fn place(&self) -> FilePosition {
        FilePosition::Byte(SENTINEL.len() + self.at)
    }

    pub fn next(&mut self) -> Result<Option<Group<'a>>, DxfError> {
        if self.at == self.bytes.len() {
            return Ok(None);
        }
        const THREE_BYTES: u8 = 255;
        let code = if self.has_wide_codes {
            i32::from(u16::from_le_bytes(self.take_array()?))
        } else {
            match self.take_array()? {
                [THREE_BYTES] => i32::from(u16::from_le_bytes(self.take_array()?)),
                [code] => i32::from(code),
            }
        };
        let place = self.place();
        let value = match ValueType::of(code).ok_or_else(|| place.error(DxfProblem::UnknownCode { code }))? {
            ValueType::Text => {
                let length = self.bytes[self.at..].iter().position(|byte| *byte == 0);
                let text = self.take(length.ok_or_else(|| self.ends())?)?;
                self.at += 1;
                Value::Text(String::from_utf8_lossy(text))
            }
            ValueType::Real => Value::Real(f64::from_le_bytes(self.take_array()?)),
            ValueType::Flag => Value::Integer(i64::from(u8::from_le_bytes(self.take_array()?))),
            ValueType::Integer16 => Value::Integer(i64::from(i16::from_le_bytes(self.take_array()?))),
            ValueType::Integer32 => Value::Integer(i64::from(i32::from_le_bytes(self.take_array()?))),
            ValueType::Integer64 => Value::Integer(i64::from_le_bytes(self.take_array()?)),
            ValueType::Bytes => {
                let length = u8::from_le_bytes(self.take_array()?);
                self.take(usize::from(length))?;
                Value::Bytes
            }
        };
        Ok(Some(Group { code, value, place }))
    }

    fn take(&mut self, count: usize) -> Result<&'a [u8], DxfError> {
        let taken = self.bytes[self.at..].get(..count).ok_or_else(|| self.ends())?;
        self.at += count;
        Ok(taken)
    }

    fn take_array<const COUNT: usize>(&mut self) -> Result<[u8; COUNT], DxfError> {
        let taken = self.bytes[self.at..].first_chunk().ok_or_else(|| self.ends())?;
        self.at += COUNT;
        Ok(*taken)
    }

    fn ends(&self) -> DxfError {
        self.place().error(DxfProblem::EndsInGroup)
    }
}
