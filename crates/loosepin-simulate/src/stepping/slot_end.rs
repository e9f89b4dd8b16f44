//! Kinks of the gap of a pin where faces and round ends of a slot meet.
//!
//! ```text
//! p = ±ξ - h                     the pin is in the round end of that side where p ≥ 0
//! g = η² - c²                    at the faces
//! g = η² + p² - c²               in an end
//! ```
//!
//! g̈ jumps by 2 ṗ² at p = 0, so that no polynomial over a step across it tells of contact: a pin that flies along the slot has the same g until it is in the
//! end. Steps end there, and each one looks for contact with the wall at which it begins, whose g is smooth wherever the pin is.

use loosepin_math::Real;

/// Signs of ξ at the two ends.
pub const ENDS: [f64; 2] = [1.0, -1.0];

/// p of an end and its derivatives, by those of ξ.
fn past_end<T: Real>([along_m, rate, second]: [T; 3], half_length_m: T, side: f64) -> [T; 3] {
    let side = T::from_f64(side);
    [side * along_m - half_length_m, side * rate, side * second]
}

/// g and its derivatives at the end of a step as the wall at its start has them; `gap`: of the wall that is there; `along`: ξ at both ends.
pub fn continued_gap<T: Real>(gap: [T; 3], along: [[T; 3]; 2], half_length_m: T) -> [T; 3] {
    let zero = T::zero();
    let mut continued = gap;
    for side in ENDS {
        let [start, end] = along.map(|along| past_end(along, half_length_m, side));
        let [p, rate, second] = end;
        let bent = rate.squared() + p * second;
        let square = [p.squared(), (p + p) * rate, bent + bent];
        let (starts_before, ends_before) = (start[0].less_than(zero), p.less_than(zero));
        for (value, square) in continued.iter_mut().zip(square) {
            let from_face = T::select(ends_before, zero, -square);
            let from_end = T::select(ends_before, square, zero);
            *value += T::select(starts_before, from_face, from_end);
        }
    }
    continued
}

/// Whether a step begins past an end, and p at both ends of it less where it counts as passed: `band_m` further on, so that the next step begins on the
/// other side, and a pin that trembles by less does not pass.
pub fn passage<T: Real>(along: [[T; 3]; 2], half_length_m: T, side: f64, band_m: T) -> (T::Mask, [[T; 3]; 2]) {
    let [mut start, mut end] = along.map(|along| past_end(along, half_length_m, side));
    let is_before = start[0].less_than(T::zero());
    let level_m = T::select(is_before, band_m, -band_m);
    start[0] -= level_m;
    end[0] -= level_m;
    (level_m.less_than(T::zero()), [start, end])
}
