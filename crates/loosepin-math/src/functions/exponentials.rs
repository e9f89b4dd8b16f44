//! Exponentials of many numbers at once, with the bits of `libm::exp`.

use core::f64::consts::LOG2_E;

use crate::fused::with_vector_instructions;

/// Arguments up to this in size take the same way, and their exponentials are normal numbers.
const LARGEST: f64 = 700.0;

/// From here on in size an argument has multiples of ln 2 taken out: the first number above ½ ln 2 whose lower half is zero.
const REDUCED: f64 = f64::from_bits(0x3fd6_2e43_0000_0000);
/// Below this in size 1 + x is all.
const LINEAR: f64 = f64::from_bits(0x3e30_0001_0000_0000);

/// ln 2 as the sum of two numbers.
const LN_2_PARTS: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];

// Minimax coefficients of fdlibm's `e_exp.c`.
const COEFFICIENTS: [f64; 5] = [
    1.666_666_666_666_660_2e-1,
    -2.777_777_777_701_559_3e-3,
    6.613_756_321_437_934e-5,
    -1.653_390_220_546_525_2e-6,
    4.138_136_797_057_238_5e-8,
];

/// Exponent of 1, and a number whose last binary digit is 1.
const BIAS: f64 = 1023.0;
const UNIT_DIGIT: f64 = (1_u64 << 52) as f64;

/// Puts the exponentials of `arguments` into `results`, one for each, with the bits of `libm::exp`: the same operations in the same
/// order, without branches, so that they are done for several numbers at once.
pub fn exponentials(arguments: &[f64], results: &mut [f64]) {
    debug_assert_eq!(arguments.len(), results.len(), "one result for each argument");
    with_vector_instructions(
        #[inline(always)]
        || {
            for (result, argument) in results.iter_mut().zip(arguments) {
                *result = within_range(*argument);
            }
        },
    );
    // Rare: overflow, underflow, and what is not a number.
    for (result, argument) in results.iter_mut().zip(arguments) {
        if argument.abs() > LARGEST || argument.is_nan() {
            *result = libm::exp(*argument);
        }
    }
}

/// exp x for |x| <= 700; of other numbers it means nothing.
#[inline(always)]
fn within_range(x: f64) -> f64 {
    let is_reduced = x.abs() >= REDUCED;
    let multiples = if is_reduced { (LOG2_E * x + 0.5_f64.copysign(x)).trunc() } else { 0.0 };
    let (high, low) = (x - multiples * LN_2_PARTS[0], multiples * LN_2_PARTS[1]);
    let rest = high - low;
    let square = rest * rest;
    let [p1, p2, p3, p4, p5] = COEFFICIENTS;
    let c = rest - square * (p1 + square * (p2 + square * (p3 + square * (p4 + square * p5))));
    let scaled = 1.0 + (rest * c / (2.0 - c) - low + high);
    // Its last digits are the exponent of the power of two.
    let exponent = (multiples + (UNIT_DIGIT + BIAS)).to_bits() << 52;
    if x.abs() >= LINEAR { scaled * f64::from_bits(exponent) } else { 1.0 + x }
}

#[cfg(test)]
mod tests {
    use super::exponentials;

    /// Every one of `arguments` has the bits of its own exponential.
    fn check(arguments: &[f64]) {
        let mut found = vec![0.0; arguments.len()];
        exponentials(arguments, &mut found);
        for (x, found) in arguments.iter().zip(found) {
            let expected = libm::exp(*x);
            let is_same = found.to_bits() == expected.to_bits() || found.is_nan() && expected.is_nan();
            assert!(is_same, "exp({x:e}): {found:e}, not {expected:e}");
        }
    }

    #[test]
    fn identity_exponentials_have_the_bits_of_the_library() {
        // Of all sizes and both signs, with mantissas that repeat nowhere.
        let number = |i: u64| {
            let mantissa = i.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 12;
            let exponent = 1023 - 40 + i % 52;
            f64::from_bits((i % 2) << 63 | exponent << 52 | mantissa)
        };
        check(&(0..200_000).map(number).collect::<Vec<f64>>());
        check(&(0..200_000).map(|i| -1.1e-4 * f64::from(i)).collect::<Vec<f64>>());
    }

    #[test]
    fn identity_exponentials_at_and_beside_every_limit_have_the_bits_of_the_library() {
        const HIGH_HALVES: [u64; 8] =
            [0x3fd6_2e42, 0x3fd6_2e43, 0x3ff0_a2b1, 0x3ff0_a2b2, 0x3ff0_a2b3, 0x3e30_0000, 0x3e30_0001, 0x4085_e000];
        const LOW_HALVES: [u64; 5] = [0, 1, 0x3f3b_ab73, 0xfefa_39ef, 0xffff_ffff];
        let mut arguments = vec![0.0, 5e-324, 1e-300, 700.0, 709.5, 709.79, 745.0, 745.2, 1e300];
        for high in HIGH_HALVES {
            arguments.extend(LOW_HALVES.map(|low| f64::from_bits(high << 32 | low)));
        }
        arguments.extend([f64::INFINITY, f64::NAN]);
        let negative: Vec<f64> = arguments.iter().map(|x| -x).collect();
        check(&arguments);
        check(&negative);
    }
}
