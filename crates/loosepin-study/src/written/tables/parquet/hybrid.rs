//! Runs of equal numbers, and numbers of few bits side by side: definition levels and indices of a dictionary (Encodings.md, "Run
//! Length Encoding / Bit-Packing Hybrid (RLE = 3)").

use super::bits::{pack, unpack};
use super::cursor::{Cursor, write_varint};
use super::error::ParquetError;

/// Numbers that are packed together; a run that is shorter is not worth its header.
const GROUP: usize = 8;

/// The numbers, each below 2^`width`.
pub fn encode(numbers: &[u32], width: u32) -> Vec<u8> {
    let mut bytes = Vec::new();
    let (mut packed_from, mut at) = (0, 0);
    while at < numbers.len() {
        let run = numbers[at..].iter().take_while(|&number| *number == numbers[at]).count();
        // A packed stretch is whole groups: the run gives what the last one lacks.
        let lacking = (packed_from..at).len().next_multiple_of(GROUP) - (packed_from..at).len();
        if run >= lacking + GROUP {
            write_packed(&mut bytes, &numbers[packed_from..at + lacking], width);
            write_varint(&mut bytes, ((run - lacking) as u64) << 1);
            bytes.extend(&numbers[at].to_le_bytes()[..width.div_ceil(8) as usize]);
            packed_from = at + run;
        }
        at += run;
    }
    write_packed(&mut bytes, &numbers[packed_from..], width);
    bytes
}

fn write_packed(bytes: &mut Vec<u8>, numbers: &[u32], width: u32) {
    let groups = numbers.len().div_ceil(GROUP);
    if groups > 0 {
        write_varint(bytes, (groups as u64) << 1 | 1);
        let padded = numbers.iter().copied().map(u64::from).chain(std::iter::repeat(0));
        pack(bytes, padded.take(groups * GROUP), width);
    }
}

/// The first `count` numbers; for each of them there is memory.
///
/// # Errors
/// A width of more than 32 bits, and bytes that end too early.
pub fn decode(bytes: &[u8], width: u32, count: usize) -> Result<Vec<u32>, ParquetError> {
    if width > u32::BITS {
        return Err(ParquetError::wrong("the width of indices", width, "at most 32 bits"));
    }
    let mut cursor = Cursor::new(bytes);
    let mut numbers = Vec::with_capacity(count);
    while numbers.len() < count {
        let left = count - numbers.len();
        let header = cursor.varint("a run")?;
        let length = header >> 1;
        if header & 1 == 1 {
            let packed = cursor.take("packed numbers", length.saturating_mul(u64::from(width)))?;
            let here = usize::try_from(length.saturating_mul(GROUP as u64)).unwrap_or(usize::MAX).min(left);
            numbers.extend(unpack(packed, width).take(here).map(|number| number as u32));
        } else {
            let stored = cursor.take("the number of a run", u64::from(width.div_ceil(8)))?;
            let number = stored.iter().rev().fold(0, |number, &byte| number << 8 | u64::from(byte));
            if number >> width > 0 {
                return Err(ParquetError::wrong("the number of a run", number, format!("below 2^{width}")));
            }
            let here = usize::try_from(length).unwrap_or(usize::MAX).min(left);
            numbers.extend(std::iter::repeat_n(number as u32, here));
        }
    }
    Ok(numbers)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Encodings.md: a run is its length twice and its number, a packed stretch the number of its groups twice and one, then the example
    /// of three bits.
    #[test]
    fn published_runs_and_packed_numbers() {
        let counted: Vec<u32> = (0..8).collect();
        assert_eq!(encode(&counted, 3), [0b11, 0b1000_1000, 0b1100_0110, 0b1111_1010]);
        assert_eq!(encode(&[5; 100], 3), [200, 1, 5]);
        assert_eq!(encode(&[1; 20], 0), [40]);
        assert_eq!(encode(&[300; 9], 9), [18, 0x2c, 0x01]);
        assert!(encode(&[], 3).is_empty());
    }

    /// 1, then 31 ones, of which seven fill the group of the first numbers: 24 are a run.
    #[test]
    fn analytic_a_run_fills_the_group_before_it() {
        let numbers: Vec<u32> = std::iter::once(0).chain([1; 31]).collect();
        assert_eq!(encode(&numbers, 1), [0b11, 0b1111_1110, 48, 1]);
        assert_eq!(decode(&[0b11, 0b1111_1110, 48, 1], 1, 32), Ok(numbers));
    }

    #[test]
    fn identity_numbers_are_read_back() {
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as u32
        };
        for width in 0..=32 {
            let mask = ((1_u64 << width) - 1) as u32;
            let mut numbers = Vec::new();
            for _ in 0..40 {
                let number = next() & mask;
                numbers.extend(std::iter::repeat_n(number, next() as usize % 20));
            }
            let bytes = encode(&numbers, width);
            assert_eq!(decode(&bytes, width, numbers.len()), Ok(numbers));
        }
    }

    #[test]
    fn crooked_runs_are_refused() {
        let told = |bytes: &[u8], width| decode(bytes, width, 9).expect_err("no numbers").to_string();
        assert_eq!(told(&[], 3), "a run: 1 bytes are needed where 0 are left");
        assert_eq!(told(&[0xfd, 0xff, 0x03, 1], 3), "packed numbers: 98298 bytes are needed where 1 are left");
        assert_eq!(told(&[18, 9], 3), "the number of a run is 9; must be below 2^3");
        assert_eq!(told(&[18, 9], 33), "the width of indices is 33; must be at most 32 bits");
        // A run of no numbers is no end.
        assert_eq!(told(&[0, 1, 0, 1], 3), "a run: 1 bytes are needed where 0 are left");
    }
}
