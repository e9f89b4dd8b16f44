//! From the differences of two runs to how long the first can be trusted.

use loosepin_result::simulation::TrustHorizon;
use loosepin_text::units::{decimal_exponent, power_of_ten};

/// Powers of ten of the lengths for which the time of trust is stated.
const LENGTHS: i32 = 3;
/// The largest of them over the smallest clearance, or over the size of a mechanism without play, at most: what is larger says nothing about the
/// motion within the play.
const MAX_OF_CLEARANCE: f64 = 0.1;
/// As above, without play.
const MAX_OF_SIZE: f64 = 1e-3;

/// Share of a length by which two runs may differ while a position counts as right to that length: the second run errs as well, and a difference
/// may pass through zero where both are wrong. Measured by `just campaign trust-horizons` on mechanisms other than those that show it.
pub(super) const SHARE: f64 = 0.2;

/// The lengths for which horizons are stated, largest first, m: powers of ten, at most a tenth of the smallest clearance.
pub(super) fn lengths_m(smallest_clearance_m: Option<f64>, size_m: f64) -> Vec<f64> {
    let largest_m = smallest_clearance_m.map_or(MAX_OF_SIZE * size_m, |clearance_m| MAX_OF_CLEARANCE * clearance_m);
    // A tenth of a clearance of 0.1 mm is 10 µm, in spite of round-off.
    let first = decimal_exponent(largest_m * (1.0 + 1e-9)).unwrap_or(0);
    (0..LENGTHS).map(|k| power_of_ten(first - k)).collect()
}

/// How long `difference_m`, the differences at `time_s` (the first of them at the start of the history), stays within `SHARE` of `length_m`.
/// `is_whole`: the last difference is that at the end of the history.
pub(super) fn horizon(
    length_m: f64,
    time_s: &[f64],
    difference_m: &[f64],
    is_whole: bool,
    turn_s: f64,
) -> TrustHorizon {
    let right = difference_m.iter().take_while(|&&difference_m| difference_m <= SHARE * length_m).count();
    let until_s = right.checked_sub(1).map(|last| time_s[last]);
    TrustHorizon {
        length_m,
        until_s,
        turns: until_s.map(|until_s| (until_s - time_s[0]) / turn_s),
        is_end: is_whole && right == difference_m.len(),
    }
}

#[cfg(test)]
mod tests {
    use super::{SHARE, horizon, lengths_m};

    #[test]
    fn analytic_lengths_are_powers_of_ten_below_a_tenth_of_the_clearance() {
        assert_eq!(lengths_m(Some(1e-4), 0.3), [1e-5, 1e-6, 1e-7]);
        assert_eq!(lengths_m(Some(5e-4), 0.3), [1e-5, 1e-6, 1e-7]);
        assert_eq!(lengths_m(Some(2e-6), 0.3), [1e-7, 1e-8, 1e-9]);
        assert_eq!(lengths_m(None, 0.3), [1e-4, 1e-5, 1e-6]);
    }

    #[test]
    fn analytic_a_horizon_is_the_last_instant_before_the_runs_part_and_stays_it_when_they_meet_again() {
        const LENGTH_M: f64 = 3e-6;
        let times_s = [0.2, 0.3, 0.4, 0.5];
        let at = |shares: [f64; 4], is_whole: bool| {
            horizon(LENGTH_M, &times_s, &shares.map(|share| share * SHARE * LENGTH_M), is_whole, 0.05)
        };
        let found = at([0.1, 0.9, 1.1, 0.2], true);
        assert_eq!((found.until_s, found.is_end), (Some(0.3), false));
        assert!(found.turns.is_some_and(|turns| (turns - 2.0).abs() < 1e-12), "{found:?}");
        assert_eq!((at([0.0; 4], true).until_s, at([0.0; 4], true).is_end), (Some(0.5), true));
        // A second run that did not come to the end tells nothing about it.
        assert!(!at([0.0; 4], false).is_end);
        assert_eq!((at([1.1; 4], true).until_s, at([1.1; 4], true).turns), (None, None));
        assert!(!at([f64::NAN; 4], true).is_end);
    }
}
