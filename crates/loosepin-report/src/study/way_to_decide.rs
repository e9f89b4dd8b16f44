//! What decides a requirement that is undecided: the part of the error that is in the way, and the number that makes it small enough.

use crate::numbers::number::{NumberWriter, Rounding};
use crate::numbers::tag::Tag;
use crate::words::wording::{count, counted, failed_words, is_by_surrogate};
use loosepin_result::study::{CountedMechanisms, RequirementOutcome, StudyResult};

/// No more mechanisms are made at one value of the unknown inputs.
const MOST: f64 = 1e7;

/// What is in the way of a verdict.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Obstacle {
    /// The search over the unknown values alone: what was counted keeps the requirement, error included.
    Search,
    /// Too few mechanisms, none of which lies outside.
    Few { needed: f64 },
    /// Too few mechanisms, of which fewer lie outside than are permitted.
    Near { needed: f64 },
    /// Too few mechanisms, of which more lie outside than are permitted.
    Above { needed: f64 },
    /// So near to what is required that no number of mechanisms decides.
    Same,
}

/// Hint for a requirement that is undecided.
pub(super) fn way_to_decide(result: &StudyResult, requirement: &RequirementOutcome, writer: &NumberWriter) -> String {
    if requirement.promised.is_some() {
        // A share of 0 may also come from a value at which every mechanism lies outside.
        if let (Some(promise), 1..) = (&result.promise, requirement.failed_values) {
            let values = failed_words(promise, requirement.failed_values, writer);
            return format!("Runs failed at {values}: nothing is promised.");
        }
        return "The promised share is too small: increase 'inner' under [promise].".to_owned();
    }
    let counts = requirement.counted.map(|counts| (counts, Obstacle::of(requirement, counts)));
    if is_by_surrogate(result) && result.counts.failed > 0 {
        return "Some runs failed, and only direct runs count failures: use direct = \"double-loop\".".to_owned();
    }
    let few = counts.filter(|(_, obstacle)| matches!(obstacle, Obstacle::Few { .. }));
    if is_by_surrogate(result) && few.is_none() {
        return "The required share lies within its error: increase 'training_runs' or 'inner', or use \
                direct = \"double-loop\"."
            .to_owned();
    }
    match counts {
        Some((counts, obstacle)) => {
            let search = obstacle.beside_search(requirement, counts).then(|| search_words(result, requirement, writer));
            let mut words = obstacle.words(result, requirement, counts, writer);
            if let Some(search) = search.filter(|_| !is_by_surrogate(result)) {
                words.push_str(&format!(" {search}"));
            }
            words
        }
        None => "The required share lies within its error: increase 'inner' and 'outer'.".to_owned(),
    }
}

/// The share outside that the search over the unknown values adds to what was counted.
fn search_share(requirement: &RequirementOutcome, counts: CountedMechanisms) -> f64 {
    (1.0 - requirement.probability[0] - share_outside(counts) - counts.sampling_error).max(0.0)
}

fn share_outside(counts: CountedMechanisms) -> f64 {
    counts.outside as f64 / counts.mechanisms.max(1) as f64
}

impl Obstacle {
    fn of(requirement: &RequirementOutcome, counts: CountedMechanisms) -> Self {
        let allowed = 1.0 - requirement.probability_at_least;
        let (outside, error, mechanisms) = (share_outside(counts), counts.sampling_error, counts.mechanisms as f64);
        // The error of a share falls with the root of the number of mechanisms, and that of none with the number itself.
        let within = |room: f64| mechanisms * (error / room) * (error / room);
        let made = |needed: f64, of: fn(f64) -> Self| if needed < MOST { of(needed) } else { Self::Same };
        if outside + error <= allowed {
            Self::Search
        } else if counts.outside == 0 {
            made(mechanisms * error / allowed, |needed| Self::Few { needed })
        } else if outside < allowed {
            made(within(allowed - outside), |needed| Self::Near { needed })
        } else {
            made(within(outside - allowed), |needed| Self::Above { needed })
        }
    }

    /// Whether the search is in the way as well once there are enough mechanisms.
    fn beside_search(self, requirement: &RequirementOutcome, counts: CountedMechanisms) -> bool {
        let room = 1.0 - requirement.probability_at_least - share_outside(counts);
        matches!(self, Self::Few { .. } | Self::Near { .. }) && search_share(requirement, counts) > room
    }

    fn words(
        self,
        result: &StudyResult,
        requirement: &RequirementOutcome,
        counts: CountedMechanisms,
        writer: &NumberWriter,
    ) -> String {
        let number = |value: u64, part: &str| count(value, &writer.with_tag(&Tag::requirement(requirement, part)));
        let power = |needed: f64| number((needed.ceil() as u64).next_power_of_two(), "needed");
        let all =
            || counted(counts.mechanisms, "mechanism", &writer.with_tag(&Tag::requirement(requirement, "mechanisms")));
        let some = || number(counts.outside, "outside");
        match self {
            Self::Search => search_words(result, requirement, writer),
            Self::Few { needed } => format!(
                "All {} passed, but {} can prove only {}: increase 'inner' to {} or more.",
                all(),
                number(counts.mechanisms, "mechanisms"),
                writer
                    .with_tag(&Tag::requirement(requirement, "share lower"))
                    .percent(requirement.probability[0], Rounding::Down),
                power(needed)
            ),
            Self::Near { needed } => format!(
                "Of {} {} are outside, fewer than permitted, but so few may be chance: increase 'inner' to {} or more.",
                all(),
                some(),
                power(needed)
            ),
            Self::Above { needed } => format!(
                "Of {} {} are outside, more than permitted, but so few may be chance: 'inner' of {} or more shows whether it is not met.",
                all(),
                some(),
                power(needed)
            ),
            Self::Same => format!(
                "Of {} {} are outside, as many as permitted: no number of runs decides this, another limit or share does.",
                all(),
                some()
            ),
        }
    }
}

/// That the search over the unknown values leaves too much, and what makes it less.
fn search_words(result: &StudyResult, requirement: &RequirementOutcome, writer: &NumberWriter) -> String {
    let (of_values, of_needed) =
        (Tag::Count("values of the unknown inputs"), Tag::requirement(requirement, "values needed"));
    let [outer, needed] = [&of_values, &of_needed].map(|tag| writer.with_tag(tag));
    format!(
        "Between the {} of the unknown inputs that were tried the share may still be smaller: increase 'outer' to {} or more.",
        counted(result.counts.outer, "value", &outer),
        count((2 * result.counts.outer).next_power_of_two(), &needed)
    )
}

#[cfg(test)]
mod tests {
    use super::{Obstacle, search_share};
    use loosepin_result::study::{CountedMechanisms, Deviation, RequirementOutcome, ResponsePoint, Verdict, Witness};

    fn undecided(
        least: f64,
        mechanisms: u64,
        outside: u64,
        sampling_error: f64,
    ) -> (RequirementOutcome, CountedMechanisms) {
        let counts = CountedMechanisms { mechanisms, outside, sampling_error };
        let outcome = RequirementOutcome {
            output: "steer".to_owned(),
            of: Deviation::Total,
            at: ResponsePoint::Whole,
            lower_si: -1.0,
            upper_si: 1.0,
            probability_at_least: 0.99,
            probability: [least, 1.0],
            witness: Witness::new(),
            promised: None,
            failed_values: 0,
            counted: Some(counts),
            verdict: Verdict::Undecided,
        };
        (outcome, counts)
    }

    #[test]
    fn analytic_the_part_of_the_error_that_is_in_the_way_is_named() {
        const TOLERANCE: f64 = 1e-12;
        let of = |(outcome, counts): &(RequirementOutcome, CountedMechanisms)| Obstacle::of(outcome, *counts);
        // None of 1,024: 0.52 % would be enough, the rest is the search.
        let search = undecided(0.604, 1024, 0, 0.00516);
        assert_eq!(of(&search), Obstacle::Search);
        assert!((search_share(&search.0, search.1) - (0.396 - 0.00516)).abs() < TOLERANCE);
        // None of 256, of which 2.05 % may still be outside: 256 · 2.05/1 are needed.
        let few = undecided(0.9795, 256, 0, 0.0205);
        let Obstacle::Few { needed } = of(&few) else { panic!("{:?}", of(&few)) };
        assert!((needed - 524.8).abs() < 1e-9 && !of(&few).beside_search(&few.0, few.1), "{needed}");
        // More of them would not suffice where the search leaves more than is permitted.
        let both = undecided(0.60, 256, 0, 0.0205);
        assert!(of(&both).beside_search(&both.0, both.1));
        // Half of what is permitted, with an error of 0.6 %: (0.6/0.5)² as many.
        let near = undecided(0.989, 1000, 5, 0.006);
        let Obstacle::Near { needed } = of(&near) else { panic!("{:?}", of(&near)) };
        assert!((needed - 1440.0).abs() < 1e-6, "{needed}");
        assert!(matches!(of(&undecided(0.97, 1000, 14, 0.01)), Obstacle::Above { .. }));
        assert_eq!(of(&undecided(0.98, 1000, 10, 0.01)), Obstacle::Same);
    }
}
