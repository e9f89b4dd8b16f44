//! After how many turns a motion repeats itself.

use crate::math::Vec2;

/// Two sections count as the same where every journal is within this share of its clearance of where it was.
pub const REPEAT_SHARE: f64 = 1e-2;

/// The smallest number of turns p, at most half of those looked at, after which every journal is back: |e(k + p) - e(k)| within
/// [`REPEAT_SHARE`] of the clearance for all turns k. None where there is none: the motion has not settled, has a longer period,
/// or never repeats itself.
///
/// `sections_m`: the eccentricities of all joints with play, m, once a turn; `clearances_m`: their radial clearances, m.
pub fn period_turns(sections_m: &[Vec<Vec2<f64>>], clearances_m: &[f64]) -> Option<usize> {
    let turns = sections_m.len();
    let is_back = |before: &[Vec2<f64>], after: &[Vec2<f64>]| {
        let mut joints = before.iter().zip(after).zip(clearances_m);
        joints.all(|((before, after), clearance_m)| (*after - *before).length() <= REPEAT_SHARE * clearance_m)
    };
    (1..=turns / 2).find(|&period| (period..turns).all(|k| is_back(&sections_m[k - period], &sections_m[k])))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CLEARANCE_M: f64 = 3e-4;

    fn sections(turns: usize, x_m: impl Fn(usize) -> f64) -> Vec<Vec<Vec2<f64>>> {
        (0..turns).map(|k| vec![Vec2::new(x_m(k), -1e-4), Vec2::new(2e-4, 0.7e-4)]).collect()
    }

    #[test]
    fn analytic_periods_of_one_two_and_three_turns() {
        let period = |x_m: &dyn Fn(usize) -> f64| period_turns(&sections(20, x_m), &[CLEARANCE_M, CLEARANCE_M]);
        assert_eq!(period(&|_| 1.3e-4), Some(1));
        assert_eq!(period(&|k| if k % 2 == 0 { 1.3e-4 } else { -0.4e-4 }), Some(2));
        assert_eq!(period(&|k| [1.3e-4, -0.4e-4, 0.9e-4][k % 3]), Some(3));
    }

    #[test]
    fn analytic_just_within_and_just_beyond_the_share() {
        let drift = |share: f64| {
            let jump_m = share * REPEAT_SHARE * CLEARANCE_M;
            period_turns(&sections(12, |k| if k < 11 { 1e-4 } else { 1e-4 + jump_m }), &[CLEARANCE_M, CLEARANCE_M])
        };
        assert_eq!(drift(0.99), Some(1));
        assert_eq!(drift(1.01), None);
    }

    #[test]
    fn analytic_a_period_longer_than_half_of_the_turns_is_not_claimed() {
        let seven = |turns| period_turns(&sections(turns, |k| 1e-4 * (k % 7) as f64), &[CLEARANCE_M, CLEARANCE_M]);
        assert_eq!(seven(14), Some(7));
        assert_eq!(seven(13), None);
        assert_eq!(period_turns(&[], &[]), None);
    }
}
