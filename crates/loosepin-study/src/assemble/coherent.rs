//! Bounds that do not contradict each other: ranges, order, inner within outer.
//!
//! Each bound holds by itself with the confidence of the study. Two bounds of numbers of which one never exceeds the other may still be out of
//! order, since each has its own error:
//!
//! ```text
//! S <= T:  upper(S) <= upper(T), lower(S) <= lower(T)      by  upper(S) := min(upper(S), upper(T)),  lower(T) := max(lower(S), lower(T))
//! ```
//!
//! What is known better stays as it is. The narrowed end holds where both do, so that misses add: [`super::Material::confidence`]. No end is
//! narrowed beyond the value that was found; where values themselves are out of order, the other end is widened.
//!
//! What is beyond the range of a number is cut off, which takes no other bound to hold.

use loosepin_math::places_in_order;
use loosepin_result::study::{BoundEnd, BoundRecord, CutBounds, PercentileBounds, Reading};

/// Ends of bounds, lower and upper.
type Ends = [BoundEnd; 2];

/// Moves both ends into `[least, most]`, in which the number lies whatever the inputs are.
pub(super) fn cut_to_range(ends: &mut Ends, range: [f64; 2]) {
    ends.iter_mut().for_each(|end| cut_end_to_range(end, range));
}

/// Moves an end into `[least, most]`.
pub(super) fn cut_end_to_range(end: &mut BoundEnd, [least, most]: [f64; 2]) {
    // What is not a number stays none: `clamp` keeps it.
    end.value_si = end.value_si.clamp(least, most);
    // An end of the range is reached at most: what the error has beyond is none.
    let widened_si = end.widened_si.clamp(least, most);
    if widened_si.is_finite() && (widened_si == least || widened_si == most) {
        set_widened(end, widened_si);
    }
}

/// Widens the upper end of the bounds of a number where it lies below the value found for one that never exceeds it.
pub(super) fn hold_smaller(of: &mut Ends, smaller: &Ends) {
    let is_in_order = smaller[1].value_si <= of[1].widened_si;
    if !is_in_order {
        widen_up(&mut of[1], smaller[1].widened_si);
    }
}

/// Widens the lower end of the bounds of a number where it lies above the value found for one that it never exceeds.
pub(super) fn hold_larger(of: &mut Ends, larger: &Ends) {
    let is_in_order = larger[0].value_si >= of[0].widened_si;
    if !is_in_order {
        widen_down(&mut of[0], larger[0].widened_si);
    }
}

/// Widens outer bounds by inner ones.
fn hold_inner(outer: &mut BoundRecord, inner: &BoundRecord) {
    widen_down(&mut outer.lower, inner.lower.widened_si);
    widen_up(&mut outer.upper, inner.upper.widened_si);
}

fn widen_up(end: &mut BoundEnd, to_si: f64) {
    if to_si > end.widened_si {
        end.error.optimisation_si += to_si - end.widened_si;
        end.widened_si = to_si;
    }
}

fn widen_down(end: &mut BoundEnd, to_si: f64) {
    if to_si < end.widened_si {
        end.error.optimisation_si += end.widened_si - to_si;
        end.widened_si = to_si;
    }
}

/// Moves the widened end of a bound back to `limit` where it lies beyond. Then the bound holds where that of the limit does too.
pub(super) fn narrow(end: &mut BoundEnd, limit_si: f64) -> bool {
    let outward = if end.widened_si >= end.value_si { 1.0 } else { -1.0 };
    let is_narrowed = outward * (end.widened_si - limit_si) > 0.0 && outward * (limit_si - end.value_si) >= 0.0;
    if is_narrowed {
        set_widened(end, limit_si);
    }
    is_narrowed
}

/// [`narrow`]s to the nearest of `limits_si`. Gives how many of them the narrowed end rests on: the nearest of several misses where any of those
/// within the end does.
pub(super) fn narrow_to_nearest(end: &mut BoundEnd, limits_si: &[f64]) -> usize {
    let outward = if end.widened_si >= end.value_si { 1.0 } else { -1.0 };
    let within = limits_si.iter().filter(|limit_si| outward * (end.widened_si - **limit_si) > 0.0);
    let rests_on = within.clone().count();
    let nearest = within.copied().min_by(|a, b| (outward * a).total_cmp(&(outward * b)));
    if nearest.is_some_and(|limit_si| narrow(end, limit_si)) { rests_on } else { 0 }
}

/// Moves the widened end of a bound to `limit`, and makes its error the difference to the value.
fn set_widened(end: &mut BoundEnd, limit_si: f64) {
    let room = (limit_si - end.value_si).abs();
    end.widened_si = limit_si;
    // What was not found has no room beside the limit, and stays unknown.
    if room.is_nan() {
        return;
    }
    end.error.sampling_si = end.error.sampling_si.min(room);
    end.error.surrogate_si = end.error.surrogate_si.min(room - end.error.sampling_si);
    end.error.optimisation_si = room - end.error.sampling_si - end.error.surrogate_si;
}

/// Nests the cuts: the bounds at a higher degree of possibility lie within those at a lower one.
pub(super) fn nest_cuts(cuts: &mut [CutBounds]) {
    let places = places_in_order(&cuts.iter().map(|cut| -cut.alpha).collect::<Vec<f64>>());
    for pair in places.windows(2) {
        let inner = cuts[pair[0]].bounds.clone();
        cuts[pair[1]].bounds.iter_mut().zip(&inner).for_each(|(outer, inner)| hold_inner(outer, inner));
    }
}

/// Percentiles of one statistic do not fall with their probability.
pub(super) fn order_percentiles(percentiles: &mut [PercentileBounds]) {
    let places = places_in_order(&percentiles.iter().map(|bounds| bounds.percentile).collect::<Vec<f64>>());
    for pair in places.windows(2) {
        let smaller = percentiles[pair[0]].bounds.clone();
        let larger = percentiles[pair[1]].bounds.iter_mut().zip(&smaller);
        larger.for_each(|(larger, smaller)| widen_up(&mut larger.upper, smaller.upper.widened_si));
    }
    for pair in places.windows(2).rev() {
        let larger = percentiles[pair[1]].bounds.clone();
        let smaller = percentiles[pair[0]].bounds.iter_mut().zip(&larger);
        smaller.for_each(|(smaller, larger)| widen_down(&mut smaller.lower, larger.lower.widened_si));
    }
}

/// One value for all mechanisms is a distribution, and a distribution that is independent of the random inputs is one: by the reading that
/// allows more, bounds are no narrower. `records` holds the same bounds by each reading.
pub(super) fn nest_readings(records: &mut [Vec<BoundRecord>]) {
    let rank = |reading: Reading| Reading::ALL.iter().position(|own| *own == reading);
    let mut places: Vec<usize> = (0..records.len()).filter(|place| !records[*place].is_empty()).collect();
    places.sort_by_key(|place| rank(records[*place][0].reading));
    for pair in places.windows(2) {
        let inner = records[pair[0]].clone();
        records[pair[1]].iter_mut().zip(&inner).for_each(|(outer, inner)| hold_inner(outer, inner));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_result::study::{NumericalError, Witness};

    fn end(value_si: f64, widened_si: f64) -> BoundEnd {
        let error = NumericalError { sampling_si: (widened_si - value_si).abs(), ..NumericalError::default() };
        BoundEnd { value_si, widened_si, witness: Witness::new(), error }
    }

    fn is_consistent(ends: &Ends) -> bool {
        const ROUND_OFF: f64 = 1e-9;
        ends.iter().all(|end| ((end.widened_si - end.value_si).abs() - end.error.total_si()).abs() < ROUND_OFF)
    }

    #[test]
    fn analytic_a_magnitude_is_not_negative_and_its_error_is_what_is_left() {
        let mut ends = [end(700.0, -2800.0), end(41_000.0, 87_000.0)];
        cut_to_range(&mut ends, [0.0, f64::INFINITY]);
        assert_eq!(ends.each_ref().map(|end| end.widened_si), [0.0, 87_000.0]);
        assert_eq!(ends.each_ref().map(|end| end.error.total_si()), [700.0, 46_000.0]);
        let mut unknown = [end(f64::NAN, f64::NEG_INFINITY), end(f64::NAN, f64::INFINITY)];
        cut_to_range(&mut unknown, [0.0, f64::INFINITY]);
        assert!(unknown[0].value_si.is_nan() && unknown[0].widened_si == 0.0 && unknown[1].widened_si == f64::INFINITY);
    }

    #[test]
    fn analytic_order_narrows_what_is_known_less_exactly_and_widens_only_where_values_are_out_of_order() {
        let (mut median, mut upper) = ([end(3.0, 2.5), end(5.0, 9.0)], [end(4.0, 2.0), end(6.0, 7.0)]);
        let before = (median.clone(), upper.clone());
        hold_larger(&mut median, &before.1);
        hold_smaller(&mut upper, &before.0);
        assert_eq!((&median, &upper), (&before.0, &before.1), "nothing is widened");
        assert!(narrow(&mut median[1], 7.0) && narrow(&mut upper[0], 2.5));
        assert_eq!([median[0].widened_si, median[1].widened_si], [2.5, 7.0]);
        assert_eq!([upper[0].widened_si, upper[1].widened_si], [2.5, 7.0]);
        assert!(is_consistent(&median) && is_consistent(&upper));
        // The median was found beyond all that the larger quantile allows.
        let median = [end(3.0, 2.5), end(8.0, 9.0)];
        hold_smaller(&mut upper, &median);
        assert_eq!(upper[1].widened_si, 9.0);
        assert!(!narrow(&mut median.clone()[1], 7.0) && is_consistent(&upper));
    }

    #[test]
    fn analytic_the_nearest_of_several_limits_rests_on_all_within() {
        // The least of three upper ends holds where all three do; the fourth lies beyond the bound and plays no part.
        let mut upper = end(5.0, 9.0);
        assert_eq!(narrow_to_nearest(&mut upper, &[8.0, 6.5, 7.0, 12.0]), 3);
        assert_eq!(upper.widened_si, 6.5);
        let mut lower = end(5.0, 1.0);
        assert_eq!(narrow_to_nearest(&mut lower, &[2.0, 0.5, 4.0]), 2);
        assert_eq!(lower.widened_si, 4.0);
        // What lies beyond the value that was found narrows nothing.
        assert_eq!(narrow_to_nearest(&mut end(5.0, 9.0), &[8.0, 4.0]), 0);
        assert_eq!(narrow_to_nearest(&mut end(5.0, 9.0), &[]), 0);
    }
}
