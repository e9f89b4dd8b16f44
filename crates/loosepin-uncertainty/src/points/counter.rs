//! Random bits that belong to a position, not to a moment: the same key gives the same bits in any order of asking.

use crate::functions::normal::normal_quantile;

/// Mixes 64 bits: the finaliser of SplitMix64 (variant 13 of D. Stafford), a bijection with good avalanche.
const fn mix(bits: u64) -> u64 {
    let bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

/// 64 random bits that belong to `key` and `counter`.
///
/// The output function of SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, "Fast splittable pseudorandom number
/// generators", OOPSLA 2014), with the state hashed from the key. Chain it to hash several words:
/// `hash(hash(seed, replicate), dimension)`.
pub const fn hash(key: u64, counter: u64) -> u64 {
    mix(mix(key.wrapping_add(0x9e37_79b9_7f4a_7c15)).wrapping_add(counter.wrapping_mul(0x9e37_79b9_7f4a_7c15)))
}

/// A number uniform in (0, 1) that belongs to `key` and `counter`.
pub fn uniform(key: u64, counter: u64) -> f64 {
    ((hash(key, counter) >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
}

/// A standard normal number that belongs to `key` and `counter`.
pub fn normal(key: u64, counter: u64) -> f64 {
    normal_quantile(uniform(key, counter))
}

#[cfg(test)]
mod tests {
    use super::hash;

    #[test]
    fn identity_each_input_bit_flips_half_of_the_output_bits() {
        // 64 input bits x 64 output bits over 200 keys: the mean share of flipped bits has a standard deviation of 0.0006.
        const SHARE_TOLERANCE: f64 = 0.003;
        let mut flipped = 0_u32;
        for key in 0..200 {
            for bit in 0..64 {
                flipped += (hash(key, 12_345) ^ hash(key, 12_345 ^ (1 << bit))).count_ones();
            }
        }
        let share = f64::from(flipped) / (200.0 * 64.0 * 64.0);
        assert!((share - 0.5).abs() < SHARE_TOLERANCE, "{share}");
    }

    #[test]
    fn identity_key_and_counter_are_not_interchangeable() {
        assert_ne!(hash(3, 5), hash(5, 3));
    }
}
