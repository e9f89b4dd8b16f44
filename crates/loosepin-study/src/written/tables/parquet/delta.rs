//! Counts as differences from one to the next (Encodings.md, "Delta Encoding (DELTA_BINARY_PACKED = 5)").

use super::bits::{pack, unpack, width_of};
use super::cursor::{Cursor, write_varint, write_zigzag};
use super::error::ParquetError;

/// Differences of a block, which has one least difference, and its parts, which have one width each.
const BLOCK: usize = 256;
const PARTS: usize = 4;

/// The counts: block size, parts, number of counts, the first; then block by block the least difference, the width of each part, and
/// how much larger each difference is. Differences have 64 bits and go round.
pub fn encode(counts: &[u64]) -> Vec<u8> {
    let mut bytes = Vec::new();
    for number in [BLOCK, PARTS, counts.len()] {
        write_varint(&mut bytes, number as u64);
    }
    write_zigzag(&mut bytes, counts.first().map_or(0, |first| first.cast_signed()));
    let differences: Vec<i64> = counts.windows(2).map(|pair| pair[1].wrapping_sub(pair[0]).cast_signed()).collect();
    for block in differences.chunks(BLOCK) {
        let least = block.iter().copied().min().unwrap_or_default();
        write_zigzag(&mut bytes, least);
        let excess: Vec<u64> = block.iter().map(|difference| difference.wrapping_sub(least).cast_unsigned()).collect();
        let parts = excess.chunks(BLOCK / PARTS);
        let width = |part: &[u64]| width_of(part.iter().copied().max().unwrap_or_default());
        let widths = bytes.len();
        bytes.extend(parts.clone().map(|part| width(part) as u8));
        bytes.resize(widths + PARTS, 0);
        for part in parts {
            let padded = part.iter().copied().chain(std::iter::repeat(0)).take(BLOCK / PARTS);
            pack(&mut bytes, padded, width(part));
        }
    }
    bytes
}

/// The `count` counts of `bytes`; for each of them there is memory. Blocks may have any size that the format allows.
///
/// # Errors
/// Another number of counts, sizes that the format does not allow, and bytes that end too early.
pub fn decode(bytes: &[u8], count: usize) -> Result<Vec<u64>, ParquetError> {
    let mut cursor = Cursor::new(bytes);
    let block = cursor.varint("the block size")?;
    let parts = cursor.varint("the parts of a block")?;
    let there = cursor.varint("the number of counts")?;
    let first = cursor.zigzag("the first count")?.cast_unsigned();
    if block == 0 || block % 128 > 0 {
        return Err(ParquetError::wrong("the block size", block, "a multiple of 128"));
    }
    let of_part = block.checked_div(parts).unwrap_or_default();
    if of_part == 0 || of_part % 32 > 0 || of_part * parts != block {
        return Err(ParquetError::wrong("the parts of a block", parts, format!("parts of {block} in multiples of 32")));
    }
    if there != count as u64 {
        return Err(ParquetError::wrong("the number of counts", there, count.to_string()));
    }
    let mut counts = Vec::with_capacity(count);
    counts.extend((count > 0).then_some(first));
    let mut last = first;
    while counts.len() < count {
        let least = cursor.zigzag("the least difference")?.cast_unsigned();
        for &width in cursor.take("the widths of a block", parts)? {
            if counts.len() == count {
                // Widths of parts that are not there may be anything.
                break;
            }
            if width > 64 {
                return Err(ParquetError::wrong("the width of differences", width, "at most 64 bits"));
            }
            let packed = cursor.take("differences", (of_part / 8).saturating_mul(u64::from(width)))?;
            let here = usize::try_from(of_part).unwrap_or(usize::MAX).min(count - counts.len());
            counts.extend(unpack(packed, u32::from(width)).take(here).map(|excess| {
                last = last.wrapping_add(least).wrapping_add(excess);
                last
            }));
        }
    }
    Ok(counts)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first example of Encodings.md, in blocks of ours: 1 to 5 have the difference 1 and nothing beyond it.
    #[test]
    fn published_equal_differences() {
        let bytes = [0x80, 0x02, 4, 5, 2, 2, 0, 0, 0, 0];
        assert_eq!(encode(&[1, 2, 3, 4, 5]), bytes);
        assert_eq!(decode(&bytes, 5), Ok(vec![1, 2, 3, 4, 5]));
    }

    /// The second: 7, 5, 3, 1, 2, 3, 4, 5 have the least difference -2, beyond which are 0, 0, 0, 3, 3, 3, 3, of two bits.
    #[test]
    fn published_differences_beyond_the_least() {
        let counts = [7, 5, 3, 1, 2, 3, 4, 5];
        let mut bytes = vec![0x80, 0x02, 4, 8, 14, 3, 2, 0, 0, 0, 0b1100_0000, 0b0011_1111];
        bytes.resize(10 + 64 * 2 / 8, 0);
        assert_eq!(encode(&counts), bytes);
        assert_eq!(decode(&bytes, 8), Ok(counts.to_vec()));
        // In blocks of 128 with four parts of 32, and widths of parts that are not there.
        let mut bytes = vec![0x80, 0x01, 4, 8, 14, 3, 2, 9, 99, 255, 0b1100_0000, 0b0011_1111];
        bytes.resize(10 + 32 * 2 / 8, 0);
        assert_eq!(decode(&bytes, 8), Ok(counts.to_vec()));
    }

    #[test]
    fn identity_counts_are_read_back() {
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state
        };
        for length in [0, 1, 2, 64, 65, 66, 256, 257, 258, 513, 1000] {
            for shift in [0, 1, 17, 40, 60] {
                let mut counts: Vec<u64> = (0..length).map(|_| next() >> shift).collect();
                if length > 2 {
                    (counts[0], counts[1]) = (u64::MAX, 0);
                }
                assert_eq!(decode(&encode(&counts), length), Ok(counts));
            }
        }
    }

    #[test]
    fn crooked_blocks_are_refused() {
        let told = |bytes: &[u8]| decode(bytes, 5).expect_err("no counts").to_string();
        assert_eq!(told(&[100, 4, 5, 2]), "the block size is 100; must be a multiple of 128");
        assert_eq!(told(&[0x80, 1, 0, 5, 2]), "the parts of a block is 0; must be parts of 128 in multiples of 32");
        assert_eq!(told(&[0x80, 1, 3, 5, 2]), "the parts of a block is 3; must be parts of 128 in multiples of 32");
        assert_eq!(told(&[0x80, 1, 4, 6, 2]), "the number of counts is 6; must be 5");
        assert_eq!(
            told(&[0x80, 1, 4, 5, 2, 2, 65, 0, 0, 0]),
            "the width of differences is 65; must be at most 64 bits"
        );
        assert_eq!(told(&[0x80, 1, 4, 5, 2, 2, 1, 0, 0, 0]), "differences: 4 bytes are needed where 0 are left");
    }
}
