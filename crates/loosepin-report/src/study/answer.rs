//! The answer of a study in sentences that need no training to read, every number rounded so that the claim stays true.

use crate::numbers::number::{NumberWriter, Rounding, plain_name};
use crate::numbers::tag::Tag;
use crate::study::output_summary::{between, largest, output_summaries, smallest};
use crate::study::way_to_decide::way_to_decide;
use crate::words::error::error_sentence;
use crate::words::failed::failed_sentence;
use crate::words::force::{JointForces, study_sentences};
use crate::words::turn::turns_sentence;
use crate::words::wording::{
    band_error, capitalised, counted, deviation_of, is_by_surrogate, listed, output_unit, path_part, place_words,
    verdict_words,
};
use loosepin_result::study::{
    Deviation, DeviationCurve, InputKind, PathError, PromiseRecord, RequirementOutcome, StudyResult, Treatment,
    TreatmentBand, TreatmentComparison, Verdict,
};
use loosepin_text::units::SiUnit;

/// The answer, for pages and terminals alike.
pub(crate) struct StudyAnswer {
    /// How many runs failed, before all else, where that is a main fact.
    pub failed: Option<String>,
    /// Each requirement with its verdict and its numbers.
    pub requirements: Vec<String>,
    /// Caveats that may overturn the verdict, or else the numbers of the answer.
    pub caveats: Vec<String>,
    /// The sentence on the output that matters most.
    pub headline: String,
    /// A sentence on every other output; empty where there is one output.
    pub further: Vec<String>,
    /// For which values all of these sentences hold; where there is one output, its own sentence says so.
    pub conditions: Option<String>,
    /// The numerical error, and what would reduce a large one.
    pub error: String,
    /// Scatter alone, runs and assumptions.
    pub details: Vec<String>,
    /// Whether a stated requirement is not met.
    pub verdict: Option<Verdict>,
}

/// Builds the answer from the bounds that the study has: the largest deviation over the cycle where it was asked for,
/// the band over the cycle otherwise.
pub(crate) fn answer(result: &StudyResult, writer: &NumberWriter) -> StudyAnswer {
    let curve = main_curve(result);
    let answers = output_summaries(result);
    let mut sentences = answers.iter().map(|summary| summary.sentence(result, writer));
    let headline = sentences.next().unwrap_or_else(|| {
        let empty = result.requirements.is_empty();
        let said = if empty { "The study has no statistic." } else { "The study has only requirements, no statistic." };
        said.to_owned()
    });
    let further: Vec<String> = sentences.collect();
    let is_answered = further.len() + result.bounds.len() + result.curves.len() > 0;
    // A sentence that there is no bound holds without conditions.
    let is_endless =
        matches!(answers[..], [only] if only.error_si().is_some_and(|(error_si, _)| error_si.is_infinite()));
    let is_answered = is_answered && !is_endless;
    let conditions = if is_answered { conditions(result, further.is_empty(), writer) } else { String::new() };
    let (headline, conditions) = match further.is_empty() {
        true => (headline + &conditions, None),
        false => (headline, Some(conditions.trim_start().to_owned())),
    };
    let verdict = result.verdict();
    let caveats = caveats(result, writer);
    let mut details = Vec::new();
    details.extend(curve.and_then(|curve| scatter_sentence(result, curve, !further.is_empty(), writer)));
    details.extend(study_sentences(result, writer));
    details.extend(gaps_sentence(result, writer));
    details.push(runs_sentence(result, writer));
    let requirements = requirement_sentences(result, writer);
    let error = error_sentence(result, &answers, writer);
    let failed = failed_sentence(result, writer);
    StudyAnswer { failed, requirements, caveats, headline, further, conditions, error, details, verdict }
}

/// What the numbers of the study take for granted and its runs contradict: impacts beyond the validity of the contact law, deep
/// penetrations, contacts below the least impact speed, and motions that differ from turn to turn.
fn caveats(result: &StudyResult, writer: &NumberWriter) -> Vec<String> {
    let beyond = result.impacts.iter().filter_map(|joint| {
        let share = joint.share_outside_validity.filter(|share| *share > 0.0)?;
        Some(format!(
            "{} of the impacts in {} are faster than the contact law is valid for: the real deviation may differ. Such fast impacts lose more energy: widen the restitution downwards.",
            writer.with_tag(&Tag::joint(&joint.joint, "impacts", "outside validity")).percent(share, Rounding::Up),
            joint.joint
        ))
    });
    let of_forces = |joint| {
        let of = JointForces::study(joint);
        [of.warning(writer), of.slow(writer)].into_iter().flatten()
    };
    let soft = result.impacts.iter().flat_map(of_forces);
    beyond.chain(soft).chain(turns_sentence(result, writer)).collect()
}

/// The verdict over all requirements as a headline.
pub(crate) fn verdict_headline(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Met => "All requirements met",
        Verdict::Promised => "Requirements promised for a share of the box",
        Verdict::NotMet => "Requirement not met",
        Verdict::Undecided => "Requirement undecided",
    }
}

/// " This holds for every gudgeon radial clearance from 0.1 to 0.5 mm." or what replaces it.
fn conditions(result: &StudyResult, is_of_one: bool, writer: &NumberWriter) -> String {
    let given = Tag::Given("range of an input");
    let writer = &writer.with_tag(&given);
    let parts: Vec<String> = result
        .inputs
        .iter()
        .filter_map(|input| {
            let name = plain_name(&input.path, &result.inputs);
            match &input.kind {
                InputKind::Random | InputKind::DrawnPlay => None,
                InputKind::Play => Some("every place of the journals in their play".to_owned()),
                InputKind::Interval { lower_si, upper_si } | InputKind::SecondOrder { lower_si, upper_si } => {
                    Some(format!(
                        "every {name} from {} to {}",
                        writer.shortest(*lower_si, &input.unit),
                        writer.value_shortest(*upper_si, &input.unit)
                    ))
                }
                InputKind::Evidence { elements, .. } => {
                    Some(format!("the evidence on the {name} ({})", counted(elements.len() as u64, "interval", writer)))
                }
                InputKind::Periodic { .. } => Some(format!("every {name} of the full period")),
                InputKind::Fuzzy { .. } => Some(format!("every possible {name}")),
                InputKind::Choice { of } => {
                    let of: Vec<String> = of.iter().map(|member| writer.as_written(member)).collect();
                    Some(format!("each {name} of the list ({})", listed(&of)))
                }
            }
        })
        .collect();
    let for_what = if parts.is_empty() { "the stated scatter".to_owned() } else { listed(&parts) };
    format!(" {} for {for_what}.", if is_of_one { "This holds" } else { "All this holds" })
}

fn main_curve(result: &StudyResult) -> Option<&DeviationCurve> {
    result
        .curves
        .iter()
        .find(|curve| curve.of == Deviation::Total)
        .or(result.curves.first())
        .filter(|curve| !curve.mixed.lower_si.is_empty())
}

/// The band of scatter alone beside that of all unknown values; `None` for the output itself, whose size is no deviation.
fn scatter_sentence(
    result: &StudyResult,
    curve: &DeviationCurve,
    of_several: bool,
    writer: &NumberWriter,
) -> Option<String> {
    if curve.of == Deviation::Value {
        return None;
    }
    let [random_ends, mixed_ends] =
        [&curve.random, &curve.mixed].map(|range| [smallest(&range.lower_si), largest(&range.upper_si)]);
    let magnitude = |[lowest, highest]: [f64; 2]| lowest.abs().max(highest.abs());
    let (random, mixed) = (magnitude(random_ends), magnitude(mixed_ends));
    let is_worth_saying = random.is_finite() && mixed.is_finite() && random < 0.95 * mixed && !curve.centre.is_empty();
    is_worth_saying.then(|| {
        let share = writer
            .with_tag(&Tag::Given("probability"))
            .percent(curve.probabilities[1] - curve.probabilities[0], Rounding::Nearest);
        let tags = ["random", "mixed"].map(|part| Tag::curve(curve, part));
        let is_on_both_sides = [random_ends, mixed_ends].into_iter().all(|[low, high]| low < 0.0 && high > 0.0);
        let [random, mixed] = if is_on_both_sides {
            [(random, &tags[0]), (mixed, &tags[1])].map(|(most, tag)| {
                let reach = tag.part("reach");
                let error_si = curve.numerical_error_si;
                let reach = writer.with_tag(&reach).for_sentence(most, error_si, &curve.unit, Rounding::Up);
                format!("within ±{reach}")
            })
        } else {
            [(random_ends, &tags[0]), (mixed_ends, &tags[1])]
                .map(|([low, high], tag)| between(low, high, &curve.unit, &writer.with_tag(tag)))
        };
        let of_several = of_several.then(|| format!("the {} stays", deviation_of(&curve.output, curve.of, &result.outputs)));
        match of_several {
            None => format!(
                "With the unknown values in the middle of their ranges, {share} of mechanisms stay {random} at each angle. With all \
                 unknown values, they stay {mixed}."
            ),
            Some(it_stays) => format!(
                "With the unknown values in the middle of their ranges, {it_stays} {random} in {share} of mechanisms at each angle. With all \
                 unknown values, it stays {mixed}."
            ),
        }
    })
}

fn requirement_sentences(result: &StudyResult, writer: &NumberWriter) -> Vec<String> {
    result
        .requirements
        .iter()
        .map(|requirement| {
            let unit = output_unit(result, &requirement.output);
            let limits = requirement_words(result, requirement, &unit, writer);
            let way_out = match requirement.verdict {
                Verdict::Undecided => format!(" {}", way_to_decide(result, requirement, writer)),
                Verdict::Met | Verdict::Promised | Verdict::NotMet => String::new(),
            };
            let searched = format!(
                "in {} of mechanisms",
                writer
                    .with_tag(&Tag::requirement(requirement, "share"))
                    .percent_range(requirement.probability[0], requirement.probability[1])
            );
            let share = match (requirement.promised, &result.promise) {
                (Some(least), Some(promise)) => {
                    let tag = Tag::requirement(requirement, "promised");
                    format!(
                        "{}; searched over every value: {searched}",
                        promised_share(promise, least, &writer.with_tag(&tag))
                    )
                }
                _ => searched,
            };
            format!(
                "{}: the {} stays {limits} {} {share}; required: at least {}.{way_out}",
                capitalised(verdict_words(requirement.verdict)),
                deviation_of(&requirement.output, requirement.of, &result.outputs),
                place_words(requirement.at, writer),
                writer
                    .with_tag(&Tag::Given("required share"))
                    .percent(requirement.probability_at_least, Rounding::Nearest),
            )
        })
        .collect()
}

/// What a promise says of a requirement that it decides, to stand behind the sentence on its verdict.
fn promised_share(promise: &PromiseRecord, least_share: f64, writer: &NumberWriter) -> String {
    let given = writer.with_tag(&Tag::Given("promise"));
    format!(
        "in at least {} of mechanisms, for at least {} of the box of the intervals with {} confidence (not for every value)",
        writer.percent(least_share, Rounding::Down),
        given.percent(promise.share, Rounding::Down),
        given.percent(promise.confidence, Rounding::Down),
    )
}

/// The limits of a requirement; a distance stays within its limit, which has no sign.
pub(crate) fn requirement_words(
    result: &StudyResult,
    requirement: &RequirementOutcome,
    unit: &SiUnit,
    writer: &NumberWriter,
) -> String {
    let RequirementOutcome { lower_si, upper_si, .. } = *requirement;
    let is_distance = matches!(path_part(&requirement.output, &result.outputs), Some((_, PathError::Magnitude)));
    if is_distance && lower_si == -upper_si && upper_si.is_finite() {
        return format!("within {}", writer.with_tag(&Tag::Given("required limit")).value_shortest(upper_si, unit));
    }
    limits_words(lower_si, upper_si, unit, writer)
}

/// "within ±0.6 mm", "below 0.6 mm", "between −0.2 and 0.6 mm".
pub(crate) fn limits_words(lower_si: f64, upper_si: f64, unit: &SiUnit, writer: &NumberWriter) -> String {
    let writer = writer.with_tag(&Tag::Given("required limit"));
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

/// How finely the box of the unknown values was seen. Where surrogates answer, direct runs stand at their bounds alone.
fn gaps_sentence(result: &StudyResult, writer: &NumberWriter) -> Option<String> {
    let gaps = result.gaps.filter(|_| !is_by_surrogate(result))?;
    let [points, runs] = [(gaps.between_points, "gap between points"), (gaps.between_runs, "gap between runs")]
        .map(|(share, what)| writer.with_tag(&Tag::Count(what)).percent(share, Rounding::Up));
    let values = counted(result.counts.outer, "value", &writer.with_tag(&Tag::Count("values of the unknown inputs")));
    let single = if runs == points {
        String::new()
    } else {
        format!(" Single runs leave gaps of {runs}, and see only peaks that stand out of their scatter.")
    };
    Some(format!(
        "Between the {values} of the unknown inputs that were tried, a peak of a result may be missed if it fills less than {points} of their box.{single}"
    ))
}

fn runs_sentence(result: &StudyResult, writer: &NumberWriter) -> String {
    let runs = counted(result.counts.runs, "run", &writer.with_tag(&Tag::Count("runs")));
    let failed = match result.counts.failed {
        0 => "none failed.".to_owned(),
        failed => format!(
            "{} failed. Probabilities and quantiles allow for both outcomes of a failed run. Means and standard deviations use \
             the finished runs only and have no bound.",
            crate::words::wording::count(failed, &writer.with_tag(&Tag::Count("failed runs")))
        ),
    };
    let random = result.inputs.iter().filter(|input| input.kind == InputKind::Random).count();
    let journals = result.inputs.iter().filter(|input| input.kind == InputKind::DrawnPlay);
    let journals: String = journals.map(|input| format!(", {}", input.words)).collect();
    let turns = |number: f64| turns(number, result.cycle.drive_speed_rad_s, writer);
    let cycle = if result.cycle.method.is_empty() {
        format!("loops closed at each position of {}, without dynamics", turns(result.cycle.recorded_turns))
    } else {
        format!("{} of start-up, {} recorded", turns(result.cycle.transient_turns), turns(result.cycle.recorded_turns))
    };
    format!(
        "{runs}, {failed} Assumptions: the model as written, {}{journals}, {cycle}.",
        match random {
            0 if journals.is_empty() => "no random input".to_owned(),
            0 => "no other random input".to_owned(),
            some => {
                let inputs = counted(some as u64, "random input", &writer.with_tag(&Tag::Count("random inputs")));
                format!(
                    "{inputs} with {} as stated",
                    if some == 1 { "its distribution" } else { "their distributions" }
                )
            }
        },
    )
}

/// A number of turns of the drive, or of cycles where no drive turns at a constant speed.
pub(crate) fn turns(turns: f64, drive_speed_rad_s: Option<f64>, writer: &NumberWriter) -> String {
    let number = writer.with_tag(&Tag::Given("turns")).shortest(turns, &SiUnit::NONE);
    format!("{number} {}{}", turn_word(drive_speed_rad_s), if turns == 1.0 { "" } else { "s" })
}

/// "turn" of the drive, or "cycle" where no drive turns at a constant speed.
pub(crate) fn turn_word(drive_speed_rad_s: Option<f64>) -> &'static str {
    if drive_speed_rad_s.is_some() { "turn" } else { "cycle" }
}

/// One paragraph a treatment: its assumption, the share of mechanisms that its band holds, its width compared with the mixed band.
pub(crate) fn treatment_sentences(comparison: &TreatmentComparison, writer: &NumberWriter) -> Vec<String> {
    let sentence = |band: &TreatmentBand| {
        let assumption = match band.treatment {
            Treatment::ProbabilityOnly => "Probability only takes every unknown value as random.",
            Treatment::IntervalOnly => "Interval only takes the worst case of all inputs, random ones included.",
            Treatment::Mixed => "Mixed keeps random inputs random and unknown values unknown.",
        };
        let held = share_sentence(band, comparison, writer);
        format!("{assumption} {held}{}", width_sentence(band, comparison, writer))
    };
    comparison.bands.iter().map(sentence).collect()
}

/// The share of mechanisms inside a band at the worst of the unknown values, beside the promised one.
fn share_sentence(band: &TreatmentBand, comparison: &TreatmentComparison, writer: &NumberWriter) -> String {
    let promised = comparison.promised_coverage;
    let promise = writer.with_tag(&Tag::Given("promised share")).percent(promised, Rounding::Nearest);
    let tag = |part: &str| Tag::band(comparison, band, part);
    let (worst, error) = (tag("share at the worst values"), tag("error of the share"));
    let least = writer.with_tag(&tag("counted share")).percent(band.coverage_minimum, Rounding::Down);
    let writer = writer.with_tag(&worst);
    if band.is_promise_unknown(promised) {
        let (of_what, least_share) = if band.is_by_surrogate {
            ("surrogate", band.least_share())
        } else {
            ("runs", (band.coverage_minimum - band.coverage_error).max(0.0))
        };
        return format!(
            "At the worst unknown values, {} of mechanisms lie inside the band. The {of_what} cannot show whether the promised \
             {promise} do.",
            writer.percent_range(least_share, band.coverage_minimum)
        );
    }
    if band.coverage_minimum >= 1.0 {
        return format!("Every run lies inside the band; {promise} are promised.");
    }
    if !band.keeps_promise(promised) {
        let is_less = band.least_share() < band.coverage_minimum;
        let least = if is_less { writer.percent_range(band.least_share(), band.coverage_minimum) } else { least };
        return format!(
            "At the worst unknown values, only {least} of mechanisms lie inside the band; {promise} are promised."
        );
    }
    if band.coverage_minimum < promised {
        return format!(
            "At the worst unknown values, {least} ± {} of mechanisms lie inside the band. This agrees with the promised {promise}.",
            writer.with_tag(&error).percent(band.coverage_error, Rounding::Up)
        );
    }
    format!("At all unknown values tested, at least {least} of mechanisms lie inside the band; {promise} are promised.")
}

/// Difference in width from the mixed band, as far as its error resolves it; empty if both hardly differ.
fn width_sentence(band: &TreatmentBand, comparison: &TreatmentComparison, writer: &NumberWriter) -> String {
    let mixed = comparison.bands.iter().find(|band| band.treatment == Treatment::Mixed).map(TreatmentBand::width_si);
    let is_known = |width: f64| width > 0.0 && width.is_finite();
    let Some(mixed) = mixed.filter(|mixed| band.treatment != Treatment::Mixed && is_known(*mixed)) else {
        return String::new();
    };
    // Beside a band without an end no width compares.
    if !band.width_si().is_finite() {
        return String::new();
    }
    let wider = (100.0 * (band.width_si() / mixed - 1.0)).round() / 100.0;
    let tag = Tag::band(comparison, band, "width compared with the mixed band");
    let by = writer.with_tag(&tag).percent(wider.abs(), Rounding::Nearest);
    let compared = match wider {
        0.02.. => format!("{by} wider than the mixed band"),
        ..=-0.02 => format!("{by} narrower than the mixed band"),
        _ => return String::new(),
    };
    if band.error_si().is_some_and(|error_si| error_si > (band.width_si() - mixed).abs()) {
        let error = band_error(band, comparison, writer);
        return format!(
            " The band found is {compared}, but the error of its ends, {error}, is larger than this difference."
        );
    }
    format!(" The band is {compared}.")
}
