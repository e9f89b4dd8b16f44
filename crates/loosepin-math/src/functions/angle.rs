//! Sine and cosine with the same bits on every processor.

use crate::Real;

/// π/2 as the sum of two numbers. With a fused multiply-add the first part leaves an exact remainder.
const HALF_PI_PARTS: [f64; 2] = [std::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17];

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

/// Sine and cosine of `angle_rad`, to about one unit in the last place, on any [`Real`].
///
/// Only additions, fused multiplications and comparisons are used, so the result has the same bits on every platform and
/// on any number of lanes. Beyond 1e15 rad it means nothing; one that is not finite gives NaN.
#[inline(always)]
pub fn sin_cos<T: Real>(angle_rad: T) -> (T, T) {
    let constant = T::from_f64;
    let quarter_turns = (angle_rad * constant(std::f64::consts::FRAC_2_PI)).nearest_whole();
    let coarse = quarter_turns.mul_add(constant(-HALF_PI_PARTS[0]), angle_rad);
    let reduced = quarter_turns.mul_add(constant(-HALF_PI_PARTS[1]), coarse);

    let square = reduced * reduced;
    let sine = (square * reduced).mul_add(polynomial(square, &SINE), reduced);
    let head = square.mul_add(constant(-0.5), T::one());
    let cosine = (square * square).mul_add(polynomial(square, &COSINE), head);

    // Which quarter turn it is, told from a half of an eighth so that no rounding meets a tie: -1/8, 1/8, 3/8, -3/8 for 0, 1, 2, 3. Odd ones
    // exchange the two.
    let fourths = quarter_turns.mul_add(constant(0.25), constant(-0.125));
    let place = fourths - fourths.nearest_whole();
    let (is_middle, is_late) = (T::zero().less_than(place), constant(0.25).less_than(place.abs()));
    let (first, second) = (T::select(is_middle, cosine, sine), T::select(is_middle, sine, cosine));
    let sine = T::select(is_late, -second, first);
    let turned = T::select(is_late, first, second);
    let cosine = T::select(is_middle, -turned, turned);
    (sine, cosine)
}

/// An angle with its sine and cosine.
#[derive(Debug, Clone, Copy)]
pub struct KnownAngle<T> {
    /// The angle, rad.
    pub angle_rad: T,
    /// Its sine.
    pub sine: T,
    /// Its cosine.
    pub cosine: T,
}

impl<T: Real> KnownAngle<T> {
    /// Zero.
    #[inline(always)]
    pub fn zero() -> Self {
        Self { angle_rad: T::zero(), sine: T::zero(), cosine: T::one() }
    }
}

/// Distance from a known angle up to which [`sin_cos_near`] is as exact as [`sin_cos`], rad: a 48th of a turn. The error grows with its ninth
/// power: 1e-11 at twice as much.
pub const NEAR_RAD: f64 = std::f64::consts::TAU / 48.0;

// Minimax coefficients on [-NEAR_RAD, NEAR_RAD], of (sin δ - δ)/δ³ and of (cos δ - 1)/δ² over δ², weighted so that the errors of sine and
// cosine are least: 1.8e-16 and 2e-18.
const NEAR_SINE: [f64; 3] = [-1.666_666_666_631_953_5e-1, 8.333_332_276_749_556e-3, -1.983_159_211_463_513e-4];
const NEAR_COSINE: [f64; 4] = [-0.5, 4.166_666_666_623_778e-2, -1.388_888_770_408_049e-3, 2.479_143_070_379_531e-5];

/// Sine and cosine of an angle that is [`NEAR_RAD`] or less from a known one, by the addition theorem: 13 multiplications in place of the 20
/// of [`sin_cos`], and no choice.
#[inline(always)]
pub fn sin_cos_near<T: Real>(angle_rad: T, known: &KnownAngle<T>) -> (T, T) {
    let turn = angle_rad - known.angle_rad;
    let square = turn * turn;
    let sine = (square * turn).mul_add(polynomial(square, &NEAR_SINE), turn);
    let cosine_less_one = square * polynomial(square, &NEAR_COSINE);
    // The small parts are added first.
    let across = known.cosine.mul_add(sine, known.sine * cosine_less_one);
    let along = known.cosine.mul_add(cosine_less_one, -(known.sine * sine));
    (known.sine + across, known.cosine + along)
}

/// Sine and cosine of an angle that is near a known one, where one is.
#[inline(always)]
pub fn sin_cos_by<T: Real>(angle_rad: T, near: Option<&KnownAngle<T>>) -> (T, T) {
    match near {
        Some(known) => sin_cos_near(angle_rad, known),
        None => angle_rad.sin_cos(),
    }
}

/// Σ c_k xᵏ by Horner's rule.
#[inline(always)]
fn polynomial<T: Real, const N: usize>(x: T, coefficients: &[f64; N]) -> T {
    let mut sum = T::from_f64(coefficients[N - 1]);
    for k in (0..N - 1).rev() {
        sum = sum.mul_add(x, T::from_f64(coefficients[k]));
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::{KnownAngle, NEAR_RAD, sin_cos, sin_cos_near};

    /// Two units in the last place of 1: what the kernel is allowed against a correctly rounded one.
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
    fn peer_sine_and_cosine_near_a_known_angle_agree_with_libm() {
        for start in 0..2000 {
            let angle_rad = 0.0137 * f64::from(start) - 13.0;
            let (sine, cosine) = (libm::sin(angle_rad), libm::cos(angle_rad));
            let known = KnownAngle { angle_rad, sine, cosine };
            for share in -50..=50 {
                let near_rad = angle_rad + NEAR_RAD * f64::from(share) / 50.0;
                let (sine, cosine) = sin_cos_near(near_rad, &known);
                assert!((sine - libm::sin(near_rad)).abs() < SINE_TOLERANCE, "sin {near_rad}: {sine}");
                assert!((cosine - libm::cos(near_rad)).abs() < SINE_TOLERANCE, "cos {near_rad}: {cosine}");
            }
        }
        // The error at twice the distance, as it is stated.
        let (sine, cosine) = sin_cos_near(2.0 * NEAR_RAD, &KnownAngle::zero());
        let errors = [sine - libm::sin(2.0 * NEAR_RAD), cosine - libm::cos(2.0 * NEAR_RAD)];
        assert!(errors.iter().all(|error| error.abs() < 1e-11), "{errors:?}");
    }

    #[test]
    fn analytic_special_angles() {
        assert_eq!(sin_cos(0.0), (0.0, 1.0));
        assert!(sin_cos(f64::NAN).0.is_nan());
        assert!(sin_cos(f64::INFINITY).1.is_nan());
    }
}
