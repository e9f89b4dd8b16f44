//! Values one after another (Encodings.md, "Plain (PLAIN = 0)"). Doubles go by their bits, so that they and counts are the same here.

use super::cursor::Cursor;
use super::error::ParquetError;

/// A value that stands in pages.
pub trait Stored<'a>: Copy + Eq + std::hash::Hash {
    /// The value at `cursor`.
    fn read(cursor: &mut Cursor<'a>) -> Result<Self, ParquetError>;
    /// Appends the value.
    fn write(self, bytes: &mut Vec<u8>);
    /// The bytes that it takes.
    fn length(self) -> usize;
}

/// Eight bytes, the lowest first.
impl<'a> Stored<'a> for u64 {
    fn read(cursor: &mut Cursor<'a>) -> Result<Self, ParquetError> {
        Ok(Self::from_le_bytes(cursor.array("a number")?))
    }

    fn write(self, bytes: &mut Vec<u8>) {
        bytes.extend(self.to_le_bytes());
    }

    fn length(self) -> usize {
        size_of::<Self>()
    }
}

/// Its length in four bytes, then the text.
impl<'a> Stored<'a> for &'a str {
    fn read(cursor: &mut Cursor<'a>) -> Result<Self, ParquetError> {
        let length = u32::from_le_bytes(cursor.array("the length of a text")?);
        std::str::from_utf8(cursor.take("a text", u64::from(length))?).map_err(|_| ParquetError::NotUtf8)
    }

    fn write(self, bytes: &mut Vec<u8>) {
        // A page holds less than four gigabytes, which the writer of pages sees to.
        bytes.extend((self.len() as u32).to_le_bytes());
        bytes.extend(self.as_bytes());
    }

    fn length(self) -> usize {
        size_of::<u32>() + self.len()
    }
}

/// All of `values`.
pub fn encode<'a, T: Stored<'a>>(values: &[T]) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(length(values));
    values.iter().for_each(|value| value.write(&mut bytes));
    bytes
}

/// The bytes that `values` take.
pub fn length<'a, T: Stored<'a>>(values: &[T]) -> usize {
    values.iter().map(|value| value.length()).sum()
}

/// `count` values.
///
/// # Errors
/// Bytes that end too early, and texts that are none.
pub fn decode<'a, T: Stored<'a>>(cursor: &mut Cursor<'a>, count: usize) -> Result<Vec<T>, ParquetError> {
    // Each value takes bytes: there are no more of them than bytes.
    let mut values = Vec::with_capacity(count.min(cursor.left()));
    for _ in 0..count {
        values.push(T::read(cursor)?);
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn published_plain_values() {
        assert_eq!(encode(&[1.0_f64.to_bits(), 258]), [0, 0, 0, 0, 0, 0, 0xf0, 0x3f, 2, 1, 0, 0, 0, 0, 0, 0]);
        assert_eq!(encode(&["ä", ""]), [2, 0, 0, 0, 0xc3, 0xa4, 0, 0, 0, 0]);
        let bytes = encode(&["ä", "", "word"]);
        assert_eq!(decode::<&str>(&mut Cursor::new(&bytes), 3), Ok(vec!["ä", "", "word"]));
        let bytes = encode(&[u64::MAX, 7]);
        assert_eq!(decode::<u64>(&mut Cursor::new(&bytes), 2), Ok(vec![u64::MAX, 7]));
    }

    #[test]
    fn crooked_values_are_refused() {
        let told =
            |bytes: &[u8]| decode::<&str>(&mut Cursor::new(bytes), usize::MAX).expect_err("no texts").to_string();
        assert_eq!(told(&[1, 0, 0, 0, 65]), "the length of a text: 4 bytes are needed where 0 are left");
        assert_eq!(told(&[0, 0, 0, 0x80, 65]), "a text: 2147483648 bytes are needed where 1 are left");
        assert_eq!(told(&[1, 0, 0, 0, 0xff]), "a text is not in UTF-8");
        let told = decode::<u64>(&mut Cursor::new(&[1, 2]), 1).expect_err("no number").to_string();
        assert_eq!(told, "a number: 8 bytes are needed where 2 are left");
    }
}
