//! Arctangent with the same bits on every processor.

use crate::Real;

/// Arguments from which the next of [`PLACES`] is the nearer one, as in fdlibm's `s_atan.c`.
const BREAKS: [f64; 4] = [0.4375, 0.6875, 1.1875, 2.4375];
/// Summands to the arctangent of the reduced argument: atan 0, atan ½, atan 1, atan 3/2, π/2.
const PLACES: [f64; 5] =
    [0.0, 0.463_647_609_000_806_1, std::f64::consts::FRAC_PI_4, 0.982_793_723_247_329, std::f64::consts::FRAC_PI_2];

// Minimax coefficients of fdlibm's `s_atan.c`, for arguments up to 7/16.
const SERIES: [f64; 11] = [
    3.333_333_333_333_293e-1,
    -1.999_999_999_987_648_3e-1,
    1.428_571_427_250_346_6e-1,
    -1.111_111_040_546_235_6e-1,
    9.090_887_133_436_507e-2,
    -7.691_876_205_044_83e-2,
    6.661_073_137_387_531e-2,
    -5.833_570_133_790_573_5e-2,
    4.976_877_994_615_932e-2,
    -3.653_157_274_421_691_6e-2,
    1.628_582_011_536_578_2e-2,
];

/// atan x, rad, to about one unit in the last place, on any [`Real`].
#[inline(always)]
pub fn arctangent<T: Real>(x: T) -> T {
    let constant = T::from_f64;
    let size = x.abs();
    // tan(a - b) = (tan a - tan b)/(1 + tan a tan b) for tan b = 0, ½, 1, 3/2, ∞.
    let (mut above, mut below, mut place) = (size, T::one(), constant(PLACES[0]));
    let reduced = [
        (size + size - T::one(), size + constant(2.0)),
        (size - T::one(), size + T::one()),
        (size - constant(1.5), constant(1.5).mul_add(size, T::one())),
        (-T::one(), size),
    ];
    for (k, (next_above, next_below)) in reduced.into_iter().enumerate() {
        let is_nearer = constant(BREAKS[k]).less_than(size);
        above = T::select(is_nearer, next_above, above);
        below = T::select(is_nearer, next_below, below);
        place = T::select(is_nearer, constant(PLACES[k + 1]), place);
    }
    let small = above / below;
    let square = small * small;
    let mut sum = constant(SERIES[SERIES.len() - 1]);
    for coefficient in SERIES.iter().rev().skip(1) {
        sum = sum.mul_add(square, constant(*coefficient));
    }
    let angle = place + (small - small * (square * sum));
    T::select(x.less_than(T::zero()), -angle, angle)
}

#[cfg(test)]
mod tests {
    use super::arctangent;

    #[test]
    fn peer_arctangent_agrees_with_libm() {
        /// Two units in the last place of one.
        const ABSOLUTE_RAD: f64 = 4.5e-16;
        let mut x = 1e-9;
        while x < 1e9 {
            for value in [x, -x] {
                assert!((arctangent(value) - libm::atan(value)).abs() <= ABSOLUTE_RAD, "atan {value}");
            }
            x *= 1.003_7;
        }
        assert_eq!(arctangent(0.0), 0.0);
    }
}
