//! Numbers of 0 to 64 bits side by side, from the lowest bit of each byte to the highest (Encodings.md, "Run Length Encoding / Bit-Packing Hybrid", "Delta Encoding").

/// Appends the `width` bits of each value; what is left of the last byte is 0.
pub fn pack(bytes: &mut Vec<u8>, values: impl Iterator<Item = u64>, width: u32) {
    let (mut pending, mut filled) = (0_u128, 0);
    for value in values {
        pending |= u128::from(value) << filled;
        filled += width;
        while filled >= 8 {
            bytes.push(pending as u8);
            pending >>= 8;
            filled -= 8;
        }
    }
    if filled > 0 {
        bytes.push(pending as u8);
    }
}

/// The values of `width` bits that `bytes` hold, `width` being at most 64; without end where it is 0.
pub fn unpack(bytes: &[u8], width: u32) -> impl Iterator<Item = u64> {
    let mask = (1_u128 << width) - 1;
    let (mut bytes, mut pending, mut filled) = (bytes.iter(), 0_u128, 0);
    std::iter::from_fn(move || {
        while filled < width {
            pending |= u128::from(*bytes.next()?) << filled;
            filled += 8;
        }
        let value = (pending & mask) as u64;
        pending >>= width;
        filled -= width;
        Some(value)
    })
}

/// The bits that `largest` takes.
pub fn width_of(largest: u64) -> u32 {
    u64::BITS - largest.leading_zeros()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The example of Encodings.md: 0 to 7 in three bits each.
    #[test]
    fn published_packing_of_three_bits() {
        let mut bytes = Vec::new();
        pack(&mut bytes, 0..8, 3);
        assert_eq!(bytes, [0b1000_1000, 0b1100_0110, 0b1111_1010]);
    }

    #[test]
    fn identity_every_width_is_read_back() {
        for width in 0..=64 {
            let mask = ((1_u128 << width) - 1) as u64;
            let values: Vec<u64> = (1..=33_u64).map(|k| k.wrapping_mul(0x9e37_79b9_7f4a_7c15) & mask).collect();
            let mut bytes = Vec::new();
            pack(&mut bytes, values.iter().copied(), width);
            assert_eq!(bytes.len(), (33 * width as usize).div_ceil(8));
            assert_eq!(unpack(&bytes, width).take(33).collect::<Vec<_>>(), values);
        }
    }

    #[test]
    fn analytic_width_of_numbers() {
        assert_eq!([0, 1, 2, 3, 4, 255, 256, u64::MAX].map(width_of), [0, 1, 2, 2, 3, 8, 9, 64]);
    }
}
