//! The answer of a study in sentences that need no training to read, every number rounded so that the claim stays true.

use super::number::{NumberWriter, Rounding, plain_name};
use super::study_page::bound_value;
use super::wording::{counted, deviation_words, is_by_surrogate, listed, output_words, place_words, statistic_words};
use loosepin_result::study::{
    BoundRecord, CountedMechanisms, Deviation, DeviationCurve, Guarantee, InputKind, Reduction, RequirementOutcome,
    ResponsePoint, Statistic, StudyResult, Treatment, TreatmentBand, TreatmentComparison, Verdict,
};
use loosepin_text::units::SiUnit;

/// Digits of a bound in a sentence.
const SENTENCE_DIGITS: usize = 2;
/// Further digits where both ends of a range are nearly the same, at most.
const MOST_MORE_DIGITS: f64 = 6.0;

/// The answer, for pages and terminals alike.
pub(super) struct Answer {
    /// Each requirement with its verdict and its numbers.
    pub requirements: Vec<String>,
    /// The one sentence.
    pub headline: String,
    /// What must be known with it.
    pub details: Vec<String>,
    /// Whether a stated requirement is not met.
    pub verdict: Option<Verdict>,
}

/// Builds the answer from the bounds that the study has: the largest deviation over the cycle where it was asked for,
/// the band over the cycle otherwise.
pub(super) fn answer(result: &StudyResult, writer: &NumberWriter) -> Answer {
    let conditions = conditions(result, writer);
    let curve = main_curve(result);
    let headline = match (main_bound(result), curve) {
        (Some((bound, probability)), _) => bound_sentence(result, bound, probability, &conditions, writer),
        (None, Some(curve)) => curve_sentence(result, curve, &conditions, writer),
        (None, None) => match result.bounds.iter().find(|bound| bound.treatment == Treatment::Mixed) {
            Some(bound) => statistic_sentence(result, bound, &conditions, writer),
            None if result.requirements.is_empty() => format!("{conditions} nothing was asked for."),
            None => format!("{conditions} no more was asked for than whether the requirements are met."),
        },
    };
    let mut details = Vec::new();
    details.extend(curve.and_then(|curve| scatter_sentence(curve, writer)));
    details.push(error_sentence(result, writer));
    details.push(runs_sentence(result, writer));
    let requirements = requirement_sentences(result, writer);
    Answer { requirements, headline, details, verdict: result.verdict() }
}

/// The verdict over all requirements as a headline.
pub(super) fn verdict_headline(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Met => "All requirements met",
        Verdict::NotMet => "Requirement not met",
        Verdict::Undecided => "Requirement undecided",
    }
}

/// "With the gudgeon radial clearance anywhere between 0.1 and 0.5 mm, " or what replaces it.
fn conditions(result: &StudyResult, writer: &NumberWriter) -> String {
    let parts: Vec<String> = result
        .inputs
        .iter()
        .filter_map(|input| {
            let name = plain_name(&input.path, &result.inputs);
            match &input.kind {
                InputKind::Random => None,
                InputKind::Interval { lower_si, upper_si } | InputKind::SecondOrder { lower_si, upper_si } => {
                    Some(format!(
                        "the {name} anywhere between {} and {}",
                        writer.shortest(*lower_si, &input.unit),
                        writer.value_shortest(*upper_si, &input.unit)
                    ))
                }
                InputKind::Evidence { elements, .. } => Some(format!(
                    "what is known of the {name} in {}",
                    counted(elements.len() as u64, "interval", writer)
                )),
                InputKind::Periodic { .. } => Some(format!("the {name} anywhere on its circle")),
                InputKind::Fuzzy { .. } => Some(format!("the {name} wherever it is possible")),
                InputKind::Choice { of } => Some(format!("the {name} any of {}", listed(of))),
            }
        })
        .collect();
    if parts.is_empty() { "With the stated scatter,".to_owned() } else { format!("With {},", listed(&parts)) }
}

fn main_bound(result: &StudyResult) -> Option<(&BoundRecord, f64)> {
    result.bounds.iter().find_map(|bound| {
        let is_main = bound.treatment == Treatment::Mixed
            && bound.of == Deviation::Total
            && bound.at == (ResponsePoint::Reduced { reduction: Reduction::MaximumAbsolute })
            && bound.upper.widened_si.is_finite();
        match bound.statistic {
            Statistic::Quantile(probability) if is_main && probability > 0.5 => Some((bound, probability)),
            _ => None,
        }
    })
}

fn main_curve(result: &StudyResult) -> Option<&DeviationCurve> {
    result
        .curves
        .iter()
        .find(|curve| curve.of == Deviation::Total)
        .or(result.curves.first())
        .filter(|curve| !curve.mixed.lower_si.is_empty())
}

fn bound_sentence(
    result: &StudyResult,
    bound: &BoundRecord,
    probability: f64,
    conditions: &str,
    writer: &NumberWriter,
) -> String {
    format!(
        "{conditions} the {} stays within ±{} of its ideal motion over the whole cycle in at least {} of mechanisms.",
        output_words(&bound.output, &result.outputs),
        writer.for_sentence(bound.upper.widened_si, bound.upper.error.total_si(), &bound.unit, Rounding::Up),
        writer.percent(probability, Rounding::Down)
    )
}

/// Any bound: the statistic, what it is of, and its two ends.
fn statistic_sentence(result: &StudyResult, bound: &BoundRecord, conditions: &str, writer: &NumberWriter) -> String {
    let unit = output_unit(result, &bound.output);
    format!(
        "{conditions} the {} of {} ({}, {}) lies between {} and {}.",
        statistic_words(bound.statistic, &unit, writer),
        output_words(&bound.output, &result.outputs),
        deviation_words(bound.of),
        place_words(bound.at, writer),
        bound_value(&bound.lower, bound, Rounding::Down, writer),
        bound_value(&bound.upper, bound, Rounding::Up, writer),
    )
}

/// The unit of an output; that of a pure number where the result does not describe it.
pub(super) fn output_unit(result: &StudyResult, name: &str) -> SiUnit {
    let output = result.outputs.iter().find(|output| output.name == name);
    output.map_or(SiUnit::NONE, |output| output.unit.clone())
}

fn curve_sentence(result: &StudyResult, curve: &DeviationCurve, conditions: &str, writer: &NumberWriter) -> String {
    let (lowest, highest) = (smallest(&curve.mixed.lower_si), largest(&curve.mixed.upper_si));
    let magnitude = highest.abs().max(lowest.abs());
    let is_even = lowest < 0.0 && highest > 0.0 && (highest.abs() - lowest.abs()).abs() <= 0.1 * magnitude;
    let range = if is_even && curve.of != Deviation::Value {
        format!("within ±{}", writer.rounded(magnitude, &curve.unit, SENTENCE_DIGITS, Rounding::Up))
    } else {
        between(lowest, highest, &curve.unit, writer)
    };
    let share = writer.percent(curve.probabilities[1] - curve.probabilities[0], Rounding::Nearest);
    let subject = output_words(&curve.output, &result.outputs);
    match curve.of {
        Deviation::Value => format!("{conditions} the {subject} lies {range}: {share} of mechanisms at any angle."),
        _ => format!(
            "{conditions} the {subject} stays {range} of its ideal motion in at least {share} of mechanisms, at each \
             angle of {} taken by itself.",
            result.cycle.drive
        ),
    }
}

/// Both ends, rounded outwards, with so many digits that rounding hardly widens what lies between them.
fn between(lowest_si: f64, highest_si: f64, unit: &SiUnit, writer: &NumberWriter) -> String {
    let more = (lowest_si.abs().max(highest_si.abs()) / (highest_si - lowest_si)).log10().floor();
    let digits = SENTENCE_DIGITS + if more.is_finite() { more.clamp(0.0, MOST_MORE_DIGITS) as usize } else { 0 };
    format!(
        "between {} and {}",
        writer.rounded(lowest_si, unit, digits, Rounding::Down),
        writer.rounded(highest_si, unit, digits, Rounding::Up)
    )
}

/// What not knowing costs; nothing of the output itself, whose size is no deviation.
fn scatter_sentence(curve: &DeviationCurve, writer: &NumberWriter) -> Option<String> {
    if curve.of == Deviation::Value {
        return None;
    }
    let [random_ends, mixed_ends] =
        [&curve.random, &curve.mixed].map(|range| [smallest(&range.lower_si), largest(&range.upper_si)]);
    let magnitude = |[lowest, highest]: [f64; 2]| lowest.abs().max(highest.abs());
    let (random, mixed) = (magnitude(random_ends), magnitude(mixed_ends));
    let is_worth_saying = random.is_finite() && mixed.is_finite() && random < 0.95 * mixed && !curve.centre.is_empty();
    is_worth_saying.then(|| {
        let share = writer.percent(curve.probabilities[1] - curve.probabilities[0], Rounding::Nearest);
        let middle =
            format!("If the unknown values were in the middle of their ranges, {share} of mechanisms would stay");
        if [random_ends, mixed_ends].into_iter().all(|[lowest, highest]| lowest < 0.0 && highest > 0.0) {
            return format!(
                "{middle} within ±{} at each angle; not knowing them, with the numerical error, widens this to ±{}.",
                writer.rounded(random, &curve.unit, SENTENCE_DIGITS, Rounding::Up),
                writer.rounded(mixed, &curve.unit, SENTENCE_DIGITS, Rounding::Up)
            );
        }
        let [random, mixed] = [random_ends, mixed_ends].map(|[low, high]| between(low, high, &curve.unit, writer));
        format!("{middle} {random} at each angle; not knowing them, with the numerical error, widens this to {mixed}.")
    })
}

fn requirement_sentences(result: &StudyResult, writer: &NumberWriter) -> Vec<String> {
    result
        .requirements
        .iter()
        .map(|requirement| {
            let unit = output_unit(result, &requirement.output);
            let limits = limits_words(requirement.lower_si, requirement.upper_si, &unit, writer);
            let verdict = match requirement.verdict {
                Verdict::Met => "is met".to_owned(),
                Verdict::NotMet => "is not met".to_owned(),
                Verdict::Undecided => {
                    let way_out = way_to_decide(result, requirement, writer);
                    format!("is undecided, because the numerical error reaches over it ({way_out})")
                }
            };
            format!(
                "The requirement that the {} of {} stays {limits} {} in at least {} of mechanisms {verdict}: the true \
                 share is {}.",
                deviation_words(requirement.of),
                requirement.output,
                place_words(requirement.at, writer),
                writer.percent(requirement.probability_at_least, Rounding::Nearest),
                writer.percent_range(requirement.probability[0], requirement.probability[1]),
            )
        })
        .collect()
}

/// What would decide a requirement that is undecided.
fn way_to_decide(result: &StudyResult, requirement: &RequirementOutcome, writer: &NumberWriter) -> String {
    // No more are made.
    const MOST: f64 = 1e7;
    let allowed = 1.0 - requirement.probability_at_least;
    // None lies outside, and still so few mechanisms would not show a share that is small enough.
    let too_few = requirement.counted.filter(|counted| counted.outside == 0 && counted.sampling_error > allowed);
    let needed = |counted: &CountedMechanisms| counted.mechanisms as f64 * counted.sampling_error / allowed;
    if is_by_surrogate(result) && result.counts.failed > 0 {
        "what fails is told by direct runs alone: direct = \"double-loop\"".to_owned()
    } else if let Some(known) = too_few.filter(|known| needed(known) < MOST) {
        format!(
            "of {} none lies outside, and so few show no larger share: 'inner' should be {} or more",
            counted(known.mechanisms, "mechanism", writer),
            super::wording::count((needed(&known).ceil() as u64).next_power_of_two(), writer)
        )
    } else if is_by_surrogate(result) {
        "more training_runs, a larger 'inner' or direct = \"double-loop\" may tell".to_owned()
    } else {
        "larger 'inner' and 'outer' make it smaller".to_owned()
    }
}

/// "within ±0.6 mm", "below 0.6 mm", "between −0.2 and 0.6 mm".
pub(super) fn limits_words(lower_si: f64, upper_si: f64, unit: &SiUnit, writer: &NumberWriter) -> String {
    match (lower_si.is_finite(), upper_si.is_finite()) {
        (true, true) if lower_si == -upper_si => format!("within ±{}", writer.value_shortest(upper_si, unit)),
        (true, true) => {
            format!("between {} and {}", writer.shortest(lower_si, unit), writer.value_shortest(upper_si, unit))
        }
        (true, false) => format!("above {}", writer.value_shortest(lower_si, unit)),
        (false, true) => format!("below {}", writer.value_shortest(upper_si, unit)),
        (false, false) => "anywhere".to_owned(),
    }
}

fn error_sentence(result: &StudyResult, writer: &NumberWriter) -> String {
    let mixed = || result.bounds.iter().filter(|bound| bound.treatment == Treatment::Mixed);
    let error_text = match (main_bound(result), main_curve(result)) {
        (Some((bound, _)), _) => Some(writer.error(bound.upper.error.total_si(), &bound.unit)),
        (None, Some(curve)) => Some(writer.error(curve.numerical_error_si, &curve.unit)),
        (None, None) => None,
    };
    let inner = mixed().filter(|bound| bound.guarantee == Guarantee::Inner).count();
    let mut sentence = match error_text {
        Some(error) => format!("Numerical error of this answer: at most {error}, already added on the outside."),
        None => "The numerical error of each bound stands beside it.".to_owned(),
    };
    if inner > 0 {
        // The answer itself first: whoever reads on knows it as a promise.
        let is_answer = main_bound(result).is_some_and(|(bound, _)| bound.guarantee == Guarantee::Inner);
        let subject = match (is_answer, mixed().count()) {
            (true, _) if inner == 1 => "It is".to_owned(),
            (true, all) => format!("It and {} of the {} other bounds are", inner - 1, all - 1),
            (false, all) => format!("{inner} of {all} bounds {}", if inner == 1 { "is" } else { "are" }),
        };
        let by = if is_by_surrogate(result) {
            "by direct runs at their values"
        } else {
            "by the search or for want of samples beyond them (larger 'inner')"
        };
        sentence.push_str(&format!(" {subject} not confirmed, {by}, and may be wider."));
    }
    sentence
}

fn runs_sentence(result: &StudyResult, writer: &NumberWriter) -> String {
    let runs = counted(result.counts.runs, "run", writer);
    let failed = match result.counts.failed {
        0 => "none failed".to_owned(),
        failed => format!(
            "{} of them failed: {} counted as not known in probabilities and quantiles; means and deviations are those of \
             the finished runs and have no bound",
            super::wording::count(failed, writer),
            if failed == 1 { "it is" } else { "they are" }
        ),
    };
    let random = result.inputs.iter().filter(|input| input.kind == InputKind::Random).count();
    format!(
        "From {runs}; {failed}. Assumed: the model as written, {} as stated, {} to start up and {} recorded.",
        match random {
            0 => "no random scatter".to_owned(),
            1 => "the distribution of 1 random input".to_owned(),
            many => format!("the distributions of {many} random inputs"),
        },
        turns(result.cycle.transient_turns, result.cycle.drive_speed_rad_s),
        turns(result.cycle.recorded_turns, result.cycle.drive_speed_rad_s),
    )
}

/// A number of turns of the drive, or of cycles where no drive turns at a constant speed.
pub(super) fn turns(turns: f64, drive_speed_rad_s: Option<f64>) -> String {
    let one = turn_word(drive_speed_rad_s);
    if turns == 1.0 { format!("1 {one}") } else { format!("{turns} {one}s") }
}

/// What goes round: the drive, or the cycle where no drive turns at a constant speed.
pub(super) fn turn_word(drive_speed_rad_s: Option<f64>) -> &'static str {
    if drive_speed_rad_s.is_some() { "turn" } else { "cycle" }
}

/// What the three treatments claim and which of them keeps its promise, one sentence each.
pub(super) fn treatment_sentences(comparison: &TreatmentComparison, writer: &NumberWriter) -> Vec<String> {
    let promised = comparison.promised_coverage;
    let mixed_width =
        comparison.bands.iter().find(|band| band.treatment == Treatment::Mixed).map(TreatmentBand::width_si);
    comparison
        .bands
        .iter()
        .map(|band| {
            let keeps = band.keeps_promise(promised);
            let least = writer.percent(band.coverage_minimum, Rounding::Down);
            let least_by_surrogate = writer.percent_range(band.least_share(), band.coverage_minimum);
            let promise = writer.percent(promised, Rounding::Nearest);
            let start = match band.treatment {
                Treatment::ProbabilityOnly => {
                    "Treating everything as probability pretends to know which unknown values are likely."
                }
                Treatment::IntervalOnly => {
                    "Treating everything as interval throws away what is known about the scatter."
                }
                Treatment::Mixed => "Taking each for what it is claims neither too much nor too little knowledge.",
            };
            let kept = if band.is_promise_unknown(promised) {
                format!(
                    "Whether its band keeps the promise of {promise} {} not tell: where the truth is unkind, {} lie inside",
                    if band.ends.is_some() { "the surrogate does" } else { "the runs do" },
                    if band.ends.is_some() {
                        least_by_surrogate
                    } else {
                        writer.percent_range((band.coverage_minimum - band.coverage_error).max(0.0), band.coverage_minimum)
                    }
                )
            } else if band.coverage_minimum >= 1.0 {
                "Its band keeps the promise: every run lies inside, whatever is true".to_owned()
            } else if keeps && band.coverage_minimum < promised {
                format!(
                    "Its band keeps the promise of {promise} within numerical error: where the truth is unkind, {least} \
                     ± {} lie inside",
                    writer.percent(band.coverage_error, Rounding::Up)
                )
            } else if keeps {
                format!("Its band keeps the promise: at least {least} of mechanisms lie inside, whatever is true")
            } else {
                let is_less = band.least_share() < band.coverage_minimum;
                let least = if is_less { least_by_surrogate } else { least };
                format!("Its band breaks the promise of {promise}: where the truth is unkind, only {least} lie inside")
            };
            let width = match mixed_width {
                Some(mixed) if band.treatment != Treatment::Mixed && mixed > 0.0 => {
                    let ratio = band.width_si() / mixed;
                    if ratio > 1.02 {
                        format!(", at {ratio:.2} times the width that is needed.")
                    } else if ratio < 0.98 && !keeps {
                        format!(", for it is only {ratio:.2} times as wide as the band that does.")
                    } else {
                        ".".to_owned()
                    }
                }
                _ => ".".to_owned(),
            };
            format!("{start} {kept}{width}")
        })
        .collect()
}

fn smallest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::INFINITY, f64::min)
}

fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}
