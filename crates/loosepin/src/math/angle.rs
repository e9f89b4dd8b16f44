//! Sine and cosine with the same bits on every processor.

/// π/2 in three parts: the first two have 33 significant bits, so that their products with whole numbers below 2²⁰
/// are exact (Cody and Waite's reduction; parts as in fdlibm's `e_rem_pio2.c`).
const HALF_PI_PARTS: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_795_950_6e-21];

/// Largest argument, rad, that the three-part reduction takes: beyond 2²⁰ quarter turns the products round.
const LARGEST_REDUCED_RAD: f64 = 1.6e6;

// Taylor-like minimax coefficients on [-π/4, π/4], as in fdlibm's `k_sin.c` and `k_cos.c`.
const SINE: [f64; 6] = [
    -1.666_666_666_666_663_2e-1,
    8.333_333_333_322_49e-3,
    -1.984_126_982_985_795e-4,
    2.755_731_370_707_006_8e-6,
    -2.505_076_025_340_686_3e-8,
    1.589_690_995_211_55e-10,
];
const COSINE: [f64; 6] = [
    4.166_666_666_666_66e-2,
    -1.388_888_888_887_411e-3,
    2.480_158_728_947_673e-5,
    -2.755_731_435_139_066_3e-7,
    2.087_572_321_298_175e-9,
    -1.135_964_755_778_819_5e-11,
];

/// Sine and cosine of `angle_rad`, to about one unit in the last place.
///
/// Only additions, multiplications and one rounding are used, so the result does not depend on the platform's
/// mathematics library. Arguments beyond 1.6e6 rad go to the pure-Rust `libm`; a non-finite one gives NaN.
#[inline]
pub fn sin_cos(angle_rad: f64) -> (f64, f64) {
    // The comparison is written so that NaN takes the slow path as well.
    if !(angle_rad.abs() <= LARGEST_REDUCED_RAD) {
        return libm::sincos(angle_rad);
    }
    // Adding and taking away 1.5 · 2⁵² rounds to the nearest whole number.
    const ROUNDER: f64 = 6_755_399_441_055_744.0;
    let quarter_turns = angle_rad * std::f64::consts::FRAC_2_PI + ROUNDER - ROUNDER;
    let coarse = angle_rad - quarter_turns * HALF_PI_PARTS[0];
    let middle = quarter_turns * HALF_PI_PARTS[1];
    let reduced = coarse - middle;
    // What was lost in the subtraction above, and the third part.
    let tail = (coarse - reduced) - middle - quarter_turns * HALF_PI_PARTS[2];

    let square = reduced * reduced;
    let sine_series = SINE[1] + square * (SINE[2] + square * (SINE[3] + square * (SINE[4] + square * SINE[5])));
    let cube = square * reduced;
    let sine = reduced + (tail + (cube * (SINE[0] + square * sine_series) - 0.5 * square * tail));

    let cosine_series = square
        * (COSINE[0]
            + square
                * (COSINE[1]
                    + square * (COSINE[2] + square * (COSINE[3] + square * (COSINE[4] + square * COSINE[5])))));
    let half_square = 0.5 * square;
    let head = 1.0 - half_square;
    let cosine = head + (((1.0 - head) - half_square) + (square * cosine_series - reduced * tail));

    match (quarter_turns as i64) & 3 {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    }
}

#[cfg(test)]
mod tests {
    use super::sin_cos;

    /// Two units in the last place of 1: what a kernel without fused operations is allowed against a correctly rounded one.
    const SINE_TOLERANCE: f64 = 4.5e-16;

    #[test]
    fn peer_sine_and_cosine_agree_with_libm_over_many_turns() {
        let mut angle_rad = -2.0e6;
        while angle_rad < 2.0e6 {
            let (sine, cosine) = sin_cos(angle_rad);
            assert!((sine - libm::sin(angle_rad)).abs() < SINE_TOLERANCE, "sin {angle_rad}: {sine}");
            assert!((cosine - libm::cos(angle_rad)).abs() < SINE_TOLERANCE, "cos {angle_rad}: {cosine}");
            angle_rad += 37.123_456_789;
        }
        let mut angle_rad = -13.0;
        while angle_rad < 13.0 {
            let (sine, cosine) = sin_cos(angle_rad);
            assert!((sine - libm::sin(angle_rad)).abs() < SINE_TOLERANCE, "sin {angle_rad}: {sine}");
            assert!((cosine - libm::cos(angle_rad)).abs() < SINE_TOLERANCE, "cos {angle_rad}: {cosine}");
            angle_rad += 1.017e-4;
        }
    }

    #[test]
    fn analytic_special_angles() {
        assert_eq!(sin_cos(0.0), (0.0, 1.0));
        assert!(sin_cos(f64::NAN).0.is_nan());
        assert!(sin_cos(f64::INFINITY).1.is_nan());
    }
}
