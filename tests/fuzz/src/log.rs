//! Checksums of a write-ahead log, made right.
//!
//! Source: "WAL-mode File Format", sections 2 and 3, <https://www.sqlite.org/walformat.html>.

/// Bytes of the header of a log.
const HEADER: usize = 32;
/// Bytes of the header of a frame, before its page.
const FRAME_HEADER: usize = 24;

/// The log with the magic number, the format, the salts of its frames and all checksums as SQLite wants them; what stands in the
/// frames is left as it is. Too short a log is returned as it is.
pub fn with_right_checksums(log: &[u8]) -> Vec<u8> {
    let mut log = log.to_vec();
    if log.len() < HEADER {
        return log;
    }
    // The last bit of the magic number says how words are read for the checksums.
    let is_big_endian = log[3] & 1 == 1;
    log[..4].copy_from_slice(&(0x377f_0682 | u32::from(is_big_endian)).to_be_bytes());
    log[4..8].copy_from_slice(&3_007_000_u32.to_be_bytes());
    let page = u32::from_be_bytes([log[8], log[9], log[10], log[11]]);
    // A page has 512 to 65536 bytes, a power of two: the nearest below what is written.
    let page = 1_usize << page.clamp(512, 65536).ilog2();
    log[8..12].copy_from_slice(&(page as u32).to_be_bytes());
    let mut sums = sum([0, 0], &log[..24], is_big_endian);
    write_sums(&mut log[24..32], sums);
    let salts: [u8; 8] = std::array::from_fn(|k| log[16 + k]);
    let mut start = HEADER;
    while start + FRAME_HEADER + page <= log.len() {
        let frame = &mut log[start..start + FRAME_HEADER + page];
        frame[8..16].copy_from_slice(&salts);
        sums = sum(sums, &frame[..8], is_big_endian);
        sums = sum(sums, &frame[FRAME_HEADER..], is_big_endian);
        write_sums(&mut frame[16..24], sums);
        start += FRAME_HEADER + page;
    }
    log
}

/// The running checksums behind `bytes`, whose number is a multiple of eight.
fn sum([mut first, mut second]: [u32; 2], bytes: &[u8], is_big_endian: bool) -> [u32; 2] {
    let word = |bytes: &[u8; 4]| if is_big_endian { u32::from_be_bytes(*bytes) } else { u32::from_le_bytes(*bytes) };
    for pair in bytes.as_chunks::<4>().0.as_chunks::<2>().0 {
        first = first.wrapping_add(word(&pair[0])).wrapping_add(second);
        second = second.wrapping_add(word(&pair[1])).wrapping_add(first);
    }
    [first, second]
}

/// Checksums are written with the highest byte first, however words are read.
fn write_sums(place: &mut [u8], sums: [u32; 2]) {
    place[..4].copy_from_slice(&sums[0].to_be_bytes());
    place[4..8].copy_from_slice(&sums[1].to_be_bytes());
}
