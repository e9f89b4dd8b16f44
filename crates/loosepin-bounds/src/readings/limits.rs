//! The range of the responses so far, and the limits of statistics that follow from it.

use crate::data::direction::{Direction, range_of};
use crate::estimators::sample::Sample;
use crate::measures::measure::Measured;
use loosepin_terms::Event;

/// By this share of the range of all responses a search concedes that a rough statistic of curves lies beyond the furthest of them.
const ROUGH_MARGIN: f64 = 0.1;

/// The same for any other statistic: a hill of which a run has met the upper half may be twice as high.
const HALF_SEEN_MARGIN: f64 = 1.0;

/// Fewer runs at a point than this do not show the range of the response.
const MIN_RUNS_FOR_RANGE: usize = 8;

/// The furthest that a search concedes to a statistic: means and quantiles stay within the range of the responses at all points together
/// and a margin, deviations within half of it, others where they state that they do. Infinite where the runs at a point are too few to show that range. A model of many inputs
/// on few points would concede what no mechanism does.
pub(crate) fn furthest_conceded(
    of: &dyn Measured,
    is_of_rough_curves: bool,
    samples: &[&Sample],
    direction: Direction,
) -> f64 {
    let margin = if is_of_rough_curves { ROUGH_MARGIN } else { HALF_SEEN_MARGIN };
    let unlimited = direction.sign() * f64::INFINITY;
    let Some((low, high)) = responses(samples) else { return unlimited };
    let [least, greatest] = of.furthest([low, high], margin * (high - low));
    direction.of(least, greatest)
}

/// Whether `event` happens, or would where responses went beyond the furthest run as far as a search concedes it to them: otherwise its
/// probability is 0 at every u.
pub(crate) fn can_change(event: Event, samples: &[&Sample]) -> bool {
    let Some((low, high)) = responses(samples) else { return true };
    let margin = HALF_SEEN_MARGIN * (high - low);
    event.holds(low - margin) || event.holds(high + margin)
}

/// The least and the greatest response at all points together; `None` if the runs at a point are too few to show them.
fn responses(samples: &[&Sample]) -> Option<(f64, f64)> {
    if samples.iter().any(|sample| sample.values().len() < MIN_RUNS_FOR_RANGE) {
        return None;
    }
    Some(range_of(samples.iter().filter_map(|sample| sample.ends()).flat_map(|(low, high)| [low, high])))
}

#[cfg(test)]
mod tests {
    use super::can_change;
    use crate::estimators::sample::Sample;
    use loosepin_terms::Event;

    #[test]
    fn analytic_an_event_within_the_range_of_all_responses_beyond_the_last_can_happen() {
        // From 0 to 2 at both points together.
        let samples =
            [0.0, 1.0].map(|least| Sample::new([(0..8).map(move |i| least + f64::from(i) / 7.0)].into_iter()));
        let samples = samples.each_ref();
        assert!(can_change(Event::Above(3.9), &samples) && !can_change(Event::Above(4.1), &samples));
        assert!(can_change(Event::Below(-1.9), &samples) && !can_change(Event::Below(-2.1), &samples));
        // Seven runs at a point do not show a range.
        let few = Sample::new([(0..7).map(f64::from)].into_iter());
        assert!(can_change(Event::Above(1e9), &[&few]));
    }
}
