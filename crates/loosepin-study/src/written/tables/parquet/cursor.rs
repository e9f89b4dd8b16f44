//! Bytes that are read from front to back, and the numbers of variable length among them: seven bits a byte, the lowest first
//! (unsigned LEB128; Thrift compact protocol, "Integer encoding").

use super::error::ParquetError;

/// What is left of some bytes. Nothing is taken that is not there.
#[derive(Debug, Clone)]
pub struct Cursor<'a> {
    rest: &'a [u8],
}

impl<'a> Cursor<'a> {
    /// At the first of `bytes`.
    pub fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes }
    }

    /// How many bytes are left.
    pub fn left(&self) -> usize {
        self.rest.len()
    }

    /// The next `count` bytes, which are `what`.
    pub fn take(&mut self, what: &'static str, count: u64) -> Result<&'a [u8], ParquetError> {
        let split = usize::try_from(count).ok().and_then(|count| self.rest.split_at_checked(count));
        let (taken, rest) = split.ok_or(ParquetError::CutShort { what, needed: count, left: self.left() })?;
        self.rest = rest;
        Ok(taken)
    }

    /// The next `N` bytes.
    pub fn array<const N: usize>(&mut self, what: &'static str) -> Result<[u8; N], ParquetError> {
        let mut bytes = [0; N];
        bytes.copy_from_slice(self.take(what, N as u64)?);
        Ok(bytes)
    }

    /// All bytes that are left.
    pub fn take_rest(&mut self) -> &'a [u8] {
        std::mem::take(&mut self.rest)
    }

    /// A number without sign.
    pub fn varint(&mut self, what: &'static str) -> Result<u64, ParquetError> {
        let mut number = 0;
        for shift in (0..u64::BITS).step_by(7) {
            let [byte] = self.array(what)?;
            let bits = u64::from(byte & 0x7f);
            // Of the tenth byte one bit has a place.
            if shift == 63 && bits > 1 {
                break;
            }
            number |= bits << shift;
            if byte < 0x80 {
                return Ok(number);
            }
        }
        Err(ParquetError::Overlong { what })
    }

    /// A number with sign: 0, -1, 1, -2, ... stand as 0, 1, 2, 3, ...
    pub fn zigzag(&mut self, what: &'static str) -> Result<i64, ParquetError> {
        let number = self.varint(what)?;
        Ok((number >> 1).cast_signed() ^ -(number & 1).cast_signed())
    }
}

/// Appends a number without sign.
pub fn write_varint(bytes: &mut Vec<u8>, mut number: u64) {
    while number >= 0x80 {
        bytes.push(number as u8 | 0x80);
        number >>= 7;
    }
    bytes.push(number as u8);
}

/// Appends a number with sign, as [`Cursor::zigzag`] reads it.
pub fn write_zigzag(bytes: &mut Vec<u8>, number: i64) {
    write_varint(bytes, (number << 1 ^ number >> 63).cast_unsigned());
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 50399 is 11 0001001 1011111 in groups of seven bits; zigzag as in the table of the compact protocol.
    #[test]
    fn analytic_numbers_of_variable_length() {
        let written = |number| {
            let mut bytes = Vec::new();
            write_varint(&mut bytes, number);
            bytes
        };
        assert_eq!(written(0), [0]);
        assert_eq!(written(127), [0x7f]);
        assert_eq!(written(50_399), [0xdf, 0x89, 0x03]);
        assert_eq!(written(u64::MAX), [0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x01]);
        for (number, bytes) in [(0, vec![0]), (-1, vec![1]), (1, vec![2]), (-2, vec![3]), (-65, vec![0x81, 0x01])] {
            let mut zigzag = Vec::new();
            write_zigzag(&mut zigzag, number);
            assert_eq!(zigzag, bytes);
        }
        for number in [0, 1, 127, 128, 50_399, u64::MAX / 2, u64::MAX] {
            assert_eq!(Cursor::new(&written(number)).varint("n"), Ok(number));
            let mut zigzag = Vec::new();
            write_zigzag(&mut zigzag, number.cast_signed());
            assert_eq!(Cursor::new(&zigzag).zigzag("n"), Ok(number.cast_signed()));
        }
    }

    #[test]
    fn numbers_that_are_too_long_or_cut_short_are_refused() {
        let told = |bytes: &[u8]| Cursor::new(bytes).varint("the size").expect_err("no number").to_string();
        assert_eq!(told(&[0x80]), "the size: 1 bytes are needed where 0 are left");
        assert_eq!(told(&[0xff; 10]), "the size: the number has more than 64 bits");
        let taken = Cursor::new(&[1, 2]).take("the page", u64::MAX).expect_err("two bytes").to_string();
        assert_eq!(taken, "the page: 18446744073709551615 bytes are needed where 2 are left");
    }
}
