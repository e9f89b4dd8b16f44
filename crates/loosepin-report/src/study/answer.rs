//! The answer of a study in sentences that need no training to read, every number rounded so that the claim stays true.

use crate::numbers::number::{NumberWriter, Rounding, plain_name};
use crate::numbers::tag::{Tag, same_wording};
use crate::study::output_summary::{OutputSummary, between, largest, output_summaries, smallest};
use crate::study::way_to_decide::way_to_decide;
use crate::words::error::{ErrorWords, error_words};
use crate::words::failed::failed_sentence;
use crate::words::force::{JointForces, force_warnings, study_sentences};
use crate::words::limits::requirement_words;
use crate::words::turn::{is_broken_later, turns_sentence};
use crate::words::wording::{
    RUNS_WITHOUT_LEAN, capitalised, counted, deviation_of, is_by_surrogate, listed, output_unit, place_words,
    verdict_words,
};
use loosepin_result::study::{
    Deviation, DeviationCurve, FurtherOutput, InputKind, PromiseRecord, StudyResult, Verdict,
};
use loosepin_text::units::SiUnit;

/// The answer, for pages and terminals alike.
pub(crate) struct StudyAnswer {
    /// How many runs failed, before all else, where that is a main fact.
    pub failed: Option<String>,
    /// Each requirement with its verdict and its numbers.
    pub requirements: Vec<String>,
    /// What the runs contradict of what the numbers take for granted.
    pub caveats: Vec<String>,
    /// That runs leave a limit in later turns: it overturns the verdict, and stands beside it.
    pub overturns: Option<String>,
    /// The sentence on the output that matters most.
    pub headline: String,
    /// A sentence on every other output; empty where there is one output.
    pub further: Vec<String>,
    /// For which values all of these sentences hold; where there is one output, its own sentence says so.
    pub conditions: Option<String>,
    /// The numerical error, and what would reduce a large one.
    pub error: ErrorWords,
    /// How narrow a peak between the unknown values that were tried may be.
    pub gaps: Option<String>,
    /// Scatter alone, gaps, runs and assumptions.
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
    // What the numbers take for granted and the runs contradict.
    let forces: Vec<JointForces> = result.impacts.iter().map(JointForces::study).collect();
    let mut caveats = force_warnings(&forces, writer);
    caveats.extend(result.leans.then(|| RUNS_WITHOUT_LEAN.to_owned()));
    let (mut overturns, mut details) = (None, Vec::new());
    match turns_sentence(result, writer) {
        of_turns if is_broken_later(result) => overturns = of_turns,
        of_turns if do_later_turns_matter(result, &answers) => caveats.extend(of_turns),
        of_turns => details.extend(of_turns),
    }
    let first = answers.first().copied();
    details.extend(curve.and_then(|curve| scatter_sentence(result, curve, first, !further.is_empty(), writer)));
    details.extend(study_sentences(result, writer));
    let gaps = gaps_words(result, writer);
    details.extend(gaps.as_ref().map(|(peaks, runs)| format!("{peaks}.{runs}")));
    let gaps = gaps.map(|(peaks, _)| format!("{peaks}."));
    details.push(runs_sentence(result, writer));
    let requirements = requirement_sentences(result, writer);
    let error = error_words(result, &answers, writer);
    let failed = failed_sentence(result, writer);
    StudyAnswer {
        failed,
        requirements,
        caveats,
        overturns,
        headline,
        further,
        conditions,
        error,
        gaps,
        details,
        verdict,
    }
}

/// Whether later turns may change an answer: they go further by more than its numerical error, or are not known.
fn do_later_turns_matter(result: &StudyResult, answers: &[OutputSummary]) -> bool {
    let Some(further) = &result.further_turns else { return true };
    let error_si = |output: &str| {
        let errors = answers.iter().filter(|answer| answer.output() == output);
        let errors_si = errors.filter_map(|answer| answer.error_si()).map(|(error_si, _)| error_si);
        errors_si.filter(|error_si| error_si.is_finite()).reduce(f64::min)
    };
    // Not a number matters.
    let is_within = |one: &FurtherOutput| one.largest_excess_si <= error_si(&one.output).unwrap_or(0.0);
    !further.outputs.iter().all(is_within)
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
        .find(|curve| curve.of == Deviation::of_all_causes())
        .or(result.curves.first())
        .filter(|curve| !curve.mixed.lower_si.is_empty())
}

/// The band of scatter alone at each angle, and that of all unknown values where `first`, the answer, has another number; `None` for the
/// output itself, whose size is no deviation.
fn scatter_sentence(
    result: &StudyResult,
    curve: &DeviationCurve,
    first: Option<OutputSummary<'_>>,
    of_several: bool,
    writer: &NumberWriter,
) -> Option<String> {
    if curve.of.is_value() {
        return None;
    }
    let [random_ends, mixed_ends] =
        [&curve.random, &curve.mixed].map(|range| [smallest(&range.lower_si), largest(&range.upper_si)]);
    let magnitude = |[lowest, highest]: [f64; 2]| lowest.abs().max(highest.abs());
    let (random_si, mixed_si) = (magnitude(random_ends), magnitude(mixed_ends));
    let is_known = random_si.is_finite() && mixed_si.is_finite() && !curve.centre.is_empty();
    let is_worth_saying = is_known && random_si < 0.95 * mixed_si;
    is_worth_saying.then(|| {
        let share = writer
            .with_tag(&Tag::Given("probability"))
            .percent(curve.probabilities[1] - curve.probabilities[0], Rounding::Nearest);
        let tags = ["random", "mixed"].map(|part| Tag::curve(curve, part));
        let is_on_both_sides = [random_ends, mixed_ends].into_iter().all(|[low, high]| low < 0.0 && high > 0.0);
        let [random, mixed] = if is_on_both_sides {
            [(random_si, &tags[0]), (mixed_si, &tags[1])].map(|(most, tag)| {
                let reach = tag.part("reach");
                let error_si = curve.numerical_error_si;
                let reach = writer.with_tag(&reach).for_sentence(most, error_si, &curve.unit, Rounding::Up);
                format!("within ±{reach}")
            })
        } else {
            [(random_ends, &tags[0]), (mixed_ends, &tags[1])]
                .map(|([low, high], tag)| between(low, high, &curve.unit, &writer.with_tag(tag)))
        };
        let is_answer = match first {
            // What is narrowed to the limit over the whole cycle is this limit.
            Some(OutputSummary::Largest(bound, _)) => {
                (&bound.output, bound.of) == (&curve.output, curve.of) && bound.upper.widened_si <= mixed_si
            }
            Some(OutputSummary::Curve(first)) => std::ptr::eq(first, curve),
            Some(OutputSummary::Bound(_)) | None => false,
        };
        let stay = match of_several {
            true => format!(
                "the {} stays {random} in {share} of mechanisms",
                deviation_of(&curve.output, curve.of, &result.outputs)
            ),
            false => format!("{share} of mechanisms stay {random}"),
        };
        let mixed = if is_answer { String::new() } else { format!("; for all values, {mixed}") };
        format!("At each angle, {stay} at mid-range values of the unknown inputs{mixed}.")
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

/// How finely the box of the unknown values was seen, and by single runs. Where surrogates answer, direct runs stand at their bounds alone.
fn gaps_words(result: &StudyResult, writer: &NumberWriter) -> Option<(String, String)> {
    let gaps = result.gaps.filter(|_| !is_by_surrogate(result))?;
    let tried = counted(result.counts.outer, "value", &writer.with_tag(&Tag::Count("values of the unknown inputs")));
    let Some([point_side, run_side]) =
        gaps.side(gaps.between_points).zip(gaps.side(gaps.between_runs)).map(<[f64; 2]>::from)
    else {
        let share = writer.with_tag(&Tag::Count("gap between points")).percent(gaps.between_points, Rounding::Up);
        let peaks = format!(
            "Peaks that fill less than {share} of the box of the unknown inputs could be missed ({tried} tried)"
        );
        return Some((peaks, String::new()));
    };
    let whole = |side: f64, what| {
        // To whole percents: a gap is sought, not known.
        writer.with_tag(&Tag::Count(what)).percent((100.0 * side).ceil() / 100.0, Rounding::Up)
    };
    let [points, runs] =
        [whole(point_side, "side of a gap between points"), whole(run_side, "side of a gap between runs")];
    let single = if same_wording(&runs, &points) {
        String::new()
    } else {
        format!(" Single runs resolve {runs}, for peaks above the scatter.")
    };
    let each = if gaps.axes == 1 { "the range of the unknown input" } else { "the range of each unknown input" };
    Some((format!("Peaks narrower than {points} of {each} could be missed ({tried} tried)"), single))
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
