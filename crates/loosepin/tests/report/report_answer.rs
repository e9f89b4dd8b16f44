//! The sentences that a reader takes away: what they claim, that they never claim more than the bounds hold, and that
//! they say so when something is missing.

use loosepin::accuracy::record::{ClearanceAnswer, GuideOverhang, SearchedPosition};
use loosepin::report::{motion_page, motion_text, study_page, study_sentences, study_text};
use loosepin::result::ContactShape;
use loosepin::study::result::{
    AllocationStop, CountedMechanisms, CutBounds, Deviation, FurtherOutput, FurtherTurns, InputDescription, InputKind,
    NumericalError, PathCurve, PathError, PathOutput, PercentileBounds, PromiseRecord, PromisedEnd, Purpose,
    PurposeRuns, Reduction, ResponsePoint, Side, Statistic, StudyResult, Verdict,
};
use loosepin::units::SiUnit;

use super::report_fixture::{self, study::worn_pin};

/// The text on one line, so that a sentence can be looked for wherever it was wrapped.
pub fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[track_caller]
pub fn assert_says(result: &StudyResult, sentence: &str) {
    let text = one_line(&study_text(result));
    assert!(text.contains(sentence), "'{sentence}' is not in: {text}");
}

fn quantile_bound_m(value: f64, error: f64) -> StudyResult {
    let mut result = worn_pin();
    result.bounds.truncate(1);
    let bound = &mut result.bounds[0];
    assert_eq!(bound.at, ResponsePoint::Reduced { reduction: Reduction::MaximumAbsolute });
    bound.upper.value_si = value - error;
    bound.upper.widened_si = value;
    bound.upper.error.sampling_si = error;
    bound.upper.error.optimisation_si = 0.0;
    result
}

#[test]
fn analytic_headline_rounds_the_bound_outwards() {
    let headline = "The slider (x of slider.pin) stays within";
    assert_says(&quantile_bound_m(5.3421e-4, 4e-6), &format!("{headline} ±0.535 mm of its ideal motion"));
    assert_says(&quantile_bound_m(5.3421e-4, 4e-5), &format!("{headline} ±0.54 mm of its ideal motion"));
    assert_says(&quantile_bound_m(5.34e-4, 4e-6), &format!("{headline} ±0.534 mm of its ideal motion"));
    assert_says(
        &quantile_bound_m(5.3421e-4, 4e-6),
        "in at least 97.5 % of mechanisms. This holds for every gudgeon radial clearance from 0.1 to 0.5 mm and every steel pin \
         restitution from 0.7 to 0.9.",
    );
    assert_says(
        &quantile_bound_m(5.3421e-4, 4e-6),
        "Numerical error of the limit over the whole cycle: at most 0.004 mm, included in it.",
    );
}

#[test]
fn analytic_runs_that_would_halve_a_large_error() {
    let shown = |sampling_si: f64, optimisation_si: f64| {
        let mut result = quantile_bound_m(6e-4, 0.0);
        let upper = &mut result.bounds[0].upper;
        upper.error = NumericalError { sampling_si, optimisation_si, surrogate_si: 0.0 };
        result.accuracy = None;
        one_line(&study_text(&result))
    };
    let says = |text: &str, words: &str| assert!(text.contains(words), "'{words}' is not in: {text}");
    // s/sqrt(k) + o = (s + o)/2 with o = s/5 holds for k = (2 s/(s - o))^2 = 6.25, the next power of two of 256 k is 2048.
    says(&shown(1e-4, 2e-5), "at most 0.2 mm, included in it. About 150000 runs halve it (set inner = 2048).");
    says(
        &shown(4e-5, 6e-5),
        "included in it. Of this, 0.06 mm comes from the search over the unknown values (a larger outer reduces it slowly), and \
         0.04 mm from the random samples (about 71000 runs halve this part: set inner = 1024).",
    );
    says(&shown(1e-6, 9e-5), "(a larger outer reduces it slowly). The band at single angles");
    assert!(!shown(1e-5, 1e-5).contains("halve"));
}

/// The band over the cycle answers; its errors are `share` of it, most of them from the samples or from the search.
fn curve_with_error(share: f64, is_sampling: bool) -> StudyResult {
    let mut result = curve_between(Deviation::Total, -5e-4, 5e-4);
    result.accuracy = None;
    let curve = &mut result.curves[0];
    curve.numerical_error_si = share * 5e-4;
    let mut bound = worn_pin().bounds[0].clone();
    bound.at = ResponsePoint::Curve { pose_rad: curve.pose_rad[0] };
    bound.of = curve.of;
    bound.statistic = Statistic::Quantile(curve.probabilities[1]);
    // More than that of the band, which the limit over the whole cycle has narrowed.
    let [most, least] = [1.6, 0.2].map(|part| part * curve.numerical_error_si);
    let (sampling_si, optimisation_si) = if is_sampling { (most, least) } else { (least, most) };
    bound.upper.error = NumericalError { sampling_si, optimisation_si, surrogate_si: 0.0 };
    bound.lower.error = NumericalError { sampling_si: 0.0, optimisation_si: 0.0, surrogate_si: 0.0 };
    result.bounds = vec![bound];
    result
}

#[test]
fn a_large_error_says_what_reduces_it() {
    assert_says(
        &curve_with_error(0.2, false),
        "This is large: most of it comes from the search over the unknown values, and more of them (outer) reduce it.",
    );
    assert_says(
        &curve_with_error(0.2, true),
        "This is large: most of it comes from the random samples, and more of them (inner) reduce it.",
    );
    assert!(!study_text(&curve_with_error(0.05, true)).contains("This is large"));
}

#[test]
fn analytic_how_finely_the_box_was_seen_is_told_by_the_side_of_its_largest_gap() {
    let mut result = worn_pin();
    // Squares of 5.25 % and 0.31 % of the area of the box: √0.0525 = 0.2291, √0.0031 = 0.0557.
    assert_says(
        &result,
        "- Peaks narrower than 23 % of the range of each unknown input could be missed (64 values tried). Single runs resolve 6 %, for \
         peaks above the scatter. -",
    );
    let gaps = result.gaps.as_mut().expect("the fixture has gaps");
    gaps.axes = 1;
    assert_says(
        &result,
        "Peaks narrower than 6 % of the range of the unknown input could be missed (64 values tried). Single runs resolve 1 %",
    );
    // Records of older versions do not say how many axes the box has.
    result.gaps.as_mut().expect("gaps").axes = 0;
    assert_says(
        &result,
        "Peaks that fill less than 5.3 % of the box of the unknown inputs could be missed (64 values tried).",
    );
    result.gaps = None;
    assert!(!study_text(&result).contains("could be missed"));
}

/// The headline and what follows it up to the details, on one line.
fn told(result: &StudyResult) -> String {
    let text = one_line(&study_text(result));
    let from = text.find(" The ").expect("a sentence on an output") + 1;
    text[from..].split(" - ").next().expect("a text").to_owned()
}

#[test]
fn every_output_has_its_sentence_and_one_that_does_not_meet_its_requirement_stands_first() {
    let mut result = quantile_bound_m(5.34e-4, 4e-6);
    let mut beside = result.bounds[0].clone();
    beside.output = "lift".to_owned();
    beside.upper.widened_si = 2e-4;
    result.bounds.push(beside);
    let sentences = [
        "The slider (x of slider.pin) stays within ±0.534 mm of its ideal motion over the whole cycle in at least 97.5 % of mechanisms.",
        "The lift stays within ±0.200 mm of its ideal motion over the whole cycle in at least 97.5 % of mechanisms.",
    ];
    let last = "All this holds for every gudgeon radial clearance from 0.1 to 0.5 mm and every steel pin restitution from 0.7 to 0.9.";
    result.requirements.clear();
    assert_eq!(told(&result), format!("{} {} {last}", sentences[0], sentences[1]));
    let mut requirement = worn_pin().requirements[0].clone();
    requirement.output = "lift".to_owned();
    requirement.verdict = Verdict::NotMet;
    result.requirements = vec![requirement];
    assert_eq!(told(&result), format!("{} {} {last}", sentences[1], sentences[0]));
    // The page has the same sentences.
    let page = study_page(&result).replace('\u{a0}', " ");
    let places = [sentences[1], sentences[0], last].map(|sentence| page.find(sentence).expect("the sentence"));
    assert!(places.is_sorted());
}

#[test]
fn a_path_is_told_by_part_and_shown_with_its_zone() {
    let mut result = worn_pin();
    result.bounds.truncate(1);
    let part = |result: &mut StudyResult, part: PathError| {
        result.outputs[0].path = Some(PathOutput { point: "tool (coupler.tool)".to_owned(), part });
    };
    for (own, sentence) in [
        (
            PathError::Magnitude,
            "The tool (coupler.tool) stays within 0.612 mm of where it should be over the whole cycle in",
        ),
        (
            PathError::Along,
            "The tool (coupler.tool) stays within ±0.612 mm of where it should be, along its path, over the whole cycle in",
        ),
        (
            PathError::Normal,
            "The tool (coupler.tool) stays within ±0.612 mm of its ideal path, across it, over the whole cycle in",
        ),
        (
            PathError::Contour,
            "The tool (coupler.tool) stays within ±0.612 mm of its ideal path, whatever the timing, over the whole cycle in",
        ),
    ] {
        part(&mut result, own);
        assert_says(&result, sentence);
    }
    assert_says(
        &result,
        "Met: the distance of tool (coupler.tool) from its path stays within ±0.7 mm over the whole cycle in",
    );
    assert!(!study_page(&result).contains("<figure class=\"zone\">"), "without a path there is no zone");
    // A circle of 100 mm, passed against the clock: to the left is inwards.
    let curve = &mut result.curves[0];
    let angles: Vec<[f64; 2]> = curve.pose_rad.iter().map(|angle| angle.sin_cos().into()).collect();
    curve.path = Some(PathCurve {
        x_m: angles.iter().map(|[_, cosine]| 0.1 * cosine).collect(),
        y_m: angles.iter().map(|[sine, _]| 0.1 * sine).collect(),
        tangent_x: angles.iter().map(|[sine, _]| -sine).collect(),
        tangent_y: angles.iter().map(|[_, cosine]| *cosine).collect(),
    });
    let page = study_page(&result).replace('\u{a0}', " ");
    // 8 % of the diagonal of 283 mm over 0.59 mm is 38.
    assert!(page.contains("The path of tool (coupler.tool), deviations magnified 20 times."));
    assert!(page.contains("where 95 % of mechanisms stay at each angle, for all unknown values"));
    // Two turns: the band is filled where both lie, since all its pieces are turned the same way round.
    let zone = |page: &str| {
        let from = page.find("<path class=\"band\" d=\"").expect("a band");
        page[from..].split('"').nth(3).expect("its pieces").matches('Z').count()
    };
    assert_eq!(zone(&page), result.curves[0].pose_rad.len(), "one piece a pose");
    // Without an end somewhere there is none.
    result.curves[0].mixed.upper_si[0] = f64::INFINITY;
    assert!(!study_page(&result).contains("<figure class=\"zone\">"));
}

#[test]
fn a_bound_that_does_not_exist_makes_no_headline() {
    // Failed runs leave no bound of a quantile above their share: the curve answers instead.
    let mut result = worn_pin();
    result.bounds[0].upper.widened_si = f64::INFINITY;
    assert_says(
        &result,
        "At each angle of crank, the slider (x of slider.pin) stays within ±0.583 mm of its ideal motion in at least 95 % of mechanisms.",
    );
    let page = study_page(&result);
    assert!(page.contains("∞"), "the table shows that there is no upper bound");
}

#[test]
fn without_quantile_and_curve_a_statistic_answers() {
    let mut result = worn_pin();
    result.curves.clear();
    result.bounds.retain(|bound| bound.statistic == Statistic::Mean);
    result.bounds.truncate(1);
    assert_says(
        &result,
        "The mean of slider (x of slider.pin) (deviation, largest absolute value in the cycle) lies between",
    );
    result.bounds.clear();
    assert_says(&result, "The study has only requirements, no statistic.");
    result.requirements.clear();
    assert_says(&result, "The study has no statistic.");
}

#[test]
fn without_intervals_only_scatter_is_named() {
    let mut result = worn_pin();
    result.inputs.retain(|input| input.kind == InputKind::Random);
    assert_says(&result, "of mechanisms. This holds for the stated scatter.");
}

#[test]
fn a_choice_of_laws_is_listed() {
    let mut result = worn_pin();
    result.inputs = vec![InputDescription {
        path: "contact.steel_pin.law".to_owned(),
        kind: InputKind::Choice { of: ["lankarani-nikravesh", "flores", "johnson"].map(str::to_owned).to_vec() },
        unit: SiUnit::NONE,
        words: "any of lankarani-nikravesh, flores, johnson".to_owned(),
    }];
    assert_says(&result, "This holds for each steel pin law of the list (lankarani-nikravesh, flores and johnson).");
}

#[test]
fn inputs_that_would_read_the_same_keep_their_paths() {
    let mut result = worn_pin();
    result.inputs[2].path = "joint.pin.play".to_owned();
    result.inputs[3].path = "body.pin.play".to_owned();
    assert_says(&result, "This holds for every joint.pin.play from 0.1 to 0.5 mm and every body.pin.play from");
}

#[test]
fn analytic_a_quantile_that_is_not_known_names_the_number_of_mechanisms_that_it_takes() {
    // 0.975^n < 0.005 from n = 210 on, 0.999^n from n = 5296 on.
    let mut result = worn_pin();
    result.bounds[0].upper.widened_si = f64::INFINITY;
    result.counts.inner = 128;
    assert_says(&result, " bounds has no end: too few samples lie beyond a quantile. Increase 'inner' to 256 or more.");
    result.bounds[0].statistic = Statistic::Quantile(0.999);
    assert_says(&result, "Increase 'inner' to 8192 or more.");
    result.bounds[0].statistic = Statistic::Quantile(0.975);
    // Failed runs are the reason, and more samples are no way out.
    result.counts.inner = 256;
    assert!(!study_text(&result).contains("no end"));
    result.counts.inner = 128;
    result.curves[0].mixed.upper_si[0] = f64::INFINITY;
    result.curves[0].numerical_error_si = f64::INFINITY;
    assert_says(
        &result,
        "At each angle of crank, the slider (x of slider.pin) has no bound: too few samples lie beyond a quantile. Increase 'inner' to 256 or more.",
    );
    assert!(!study_text(&result).contains("at most ∞"));
    let page = study_page(&result);
    assert!(
        page.contains("The orange band has no end at some angles: too few samples lie beyond a quantile"),
        "{page}"
    );
}

#[test]
fn parts_that_pass_through_each_other_are_told() {
    let mut result = worn_pin();
    result.impacts[0].largest_penetration_share = 0.1;
    assert!(!study_text(&result).contains("the parts penetrate"));
    result.impacts[0].largest_penetration_share = 0.143;
    assert_says(
        &result,
        "In gudgeon the parts penetrate each other by up to 14.3 % of the clearance; contact laws hold up to about a tenth. Force and deviation depend on the law: compare with another one.",
    );
    result.impacts[0].laws[0].basis.shape = ContactShape::Given;
    assert_says(&result, "more than a tenth: force and deviation depend on the given stiffness.");
    result.impacts[0].largest_penetration_share = 1.3;
    assert_says(
        &result,
        "In gudgeon the parts penetrate each other by up to 130 % of the clearance: the contact law does not hold.",
    );
}

/// The law stands beside a force that is asked about, and contacts below the least impact speed are told.
#[test]
fn the_law_of_a_force_stands_beside_it() {
    let mut result = worn_pin();
    let law = "Contact forces in gudgeon are those of lankarani-nikravesh (point contact, no length of the bearing enters). The stated \
               restitution of 0.7 to 0.9 acts as 0.796 to 0.9132 in a free impact; valid for impacts up to 0.052 m/s (98.1 % are faster).";
    assert!(!one_line(&study_text(&result)).contains(law));
    result.outputs[0].contact_force_in = Some("gudgeon".to_owned());
    assert_says(&result, law);
    result.impacts[0].laws[0].basis.is_law_named = false;
    assert_says(&result, "those of lankarani-nikravesh by default (point contact");
    let mut other = result.impacts[0].laws[0].clone();
    (other.law, other.basis.shape) = ("johnson".to_owned(), ContactShape::Line { length_m: 0.02 });
    other.basis.largest_valid_penetration_m = Some(2.7066e-4);
    result.impacts[0].laws.push(other);
    assert_says(&result, "no length of the bearing enters) and johnson by default (line contact over 20 mm).");
    assert_says(&result, "(98.1 % are faster) and penetrations up to 0.27 mm.");
    // Records of older versions name no law.
    result.impacts[0].laws.clear();
    assert!(!one_line(&study_text(&result)).contains("Contact forces in"));
}

#[test]
fn contacts_below_a_raised_least_impact_speed_are_told() {
    let mut result = worn_pin();
    result.impacts[0].impacts_per_turn = [0.0; 3];
    assert!(!one_line(&study_text(&result)).contains("least impact speed"));
    result.impacts[0].laws[0].basis.minimum_impact_speed_m_s = Some(10.0);
    assert_says(
        &result,
        "In gudgeon no contact began faster than the minimum impact speed of 10 m/s: all are computed as impacts at this speed, which lose less energy, and none is counted. Use a lower minimum_impact_speed.",
    );
}

#[test]
fn warnings_stand_after_the_answer_on_a_terminal_and_with_the_verdict_on_a_page() {
    let beyond = "98.1 % of the impacts in gudgeon are faster than the contact law is valid for";
    let settled = "In 12.6 % of the runs the motion does not repeat from turn to turn";
    let mut result = worn_pin();
    for (shown, is_page) in [(study_text(&result), false), (study_page(&result), true)] {
        let shown = one_line(&shown).replace('\u{a0}', " ");
        let place = |words: &str| shown.find(words).unwrap_or_else(|| panic!("'{words}' is not in: {shown}"));
        let (verdict, headline) = (place("equirement"), place("stays within ±0."));
        for caveat in [beyond, settled] {
            let is_before = place(caveat) < place("of its ideal motion over the whole cycle in at");
            assert!(verdict < place(caveat) && is_before == is_page, "{caveat}");
        }
        assert!(verdict < headline);
    }
    // Without a verdict they are about the answer.
    result.requirements.clear();
    assert_says(&result, &format!("Warnings - {beyond}"));
    result.impacts[0].share_outside_validity = Some(0.0);
    let excess = |of, mean_excess_si, largest_excess_si| FurtherOutput {
        output: "slider".to_owned(),
        of,
        reduction: Reduction::MaximumAbsolute,
        mean_excess_si,
        largest_excess_si,
    };
    let outputs = vec![excess(Deviation::Clearance, 2e-6, 3e-6), excess(Deviation::Total, 8.74e-6, 4.11e-5)];
    result.further_turns =
        Some(FurtherTurns { turns: 5, runs: 64, outputs, broken_later: vec![Some(0), Some(3), None] });
    result.requirements = worn_pin().requirements;
    assert_says(
        &result,
        "does not repeat from turn to turn. In 5 further turns (64 runs), the largest deviation of slider grew by at most 0.042 mm (mean \
         0.0087 mm). None of these runs left the limit of slider (deviation, within ±0.7 mm) later. 3 of these runs left the limit of slider (deviation, within ±0.5 mm) \
         only in the further turns: over more turns, fewer mechanisms keep it than stated.",
    );
    // It overturns a verdict: page and short answer have it too.
    for text in [study_page(&result), study_sentences(&result).join(" ")] {
        assert!(text.replace('\u{a0}', " ").contains("fewer mechanisms keep it than stated"), "{text}");
    }
    if let Some(further) = &mut result.further_turns {
        (further.turns, further.runs) = (1, 1);
    }
    assert_says(&result, "In 1 further turn (1 run), the largest deviation of slider grew by at most 0.042 mm");
    result.settled_share = Some(1.0);
    let text = one_line(&study_text(&result));
    assert!(!text.contains("valid for") && !text.contains("is periodic"), "{text}");
}

#[test]
fn verdicts_stand_first_and_with_their_numbers() {
    let mut result = worn_pin();
    result.requirements.truncate(1);
    assert_says(
        &result,
        "Met: the deviation of slider stays within ±0.7 mm over the whole cycle in 99.96 % to 100 % of mechanisms; required: at least \
         99.73 %.",
    );
    result.requirements[0].verdict = Verdict::Undecided;
    result.requirements[0].probability = [0.99712, 0.99741];
    assert_says(
        &result,
        "Undecided: the deviation of slider stays within ±0.7 mm over the whole cycle in 99.71 % to 99.75 % of mechanisms; required: at \
         least 99.73 %. The required share lies within its error: increase 'inner' and 'outer'.",
    );
    assert!(study_page(&result).contains("Requirement undecided"));
    // None of 256 lies outside: a share of 6 in 256 may still do so.
    result.requirements[0].probability = [1.0 - 6.0 / 256.0, 1.0];
    result.requirements[0].counted =
        Some(CountedMechanisms { mechanisms: 256, outside: 0, sampling_error: 6.0 / 256.0 });
    assert_says(
        &result,
        "in 97.6 % to 100 % of mechanisms; required: at least 99.73 %. All 256 mechanisms passed, but 256 can prove only 97.6 %: increase \
         'inner' to 4096 or more.",
    );
    // What was counted would do: the search between the 64 values is in the way.
    result.requirements[0].probability = [0.604, 1.0];
    result.requirements[0].counted = Some(CountedMechanisms { mechanisms: 4096, outside: 0, sampling_error: 0.0013 });
    assert_says(
        &result,
        "in 60.4 % to 100 % of mechanisms; required: at least 99.73 %. Between the 64 values of the unknown inputs that were tried the \
         share may still be smaller: increase 'outer' to 128 or more.",
    );
    // Both are: with enough mechanisms 60.4 % would still be all that is shown.
    result.requirements[0].counted =
        Some(CountedMechanisms { mechanisms: 256, outside: 0, sampling_error: 6.0 / 256.0 });
    assert_says(
        &result,
        "increase 'inner' to 4096 or more. Between the 64 values of the unknown inputs that were tried the share may still be smaller: \
         increase 'outer' to 128 or more.",
    );
    // 0.2 % of 4000 are outside: (0.002/0.0007)² times as many.
    result.requirements[0].probability = [0.996, 0.999];
    result.requirements[0].counted = Some(CountedMechanisms { mechanisms: 4000, outside: 8, sampling_error: 0.002 });
    assert_says(
        &result,
        "Of 4000 mechanisms 8 are outside, fewer than permitted, but so few may be chance: increase 'inner' to 32768 or more.",
    );
    result.requirements[0].counted = Some(CountedMechanisms { mechanisms: 4000, outside: 14, sampling_error: 0.002 });
    assert_says(
        &result,
        "Of 4000 mechanisms 14 are outside, more than permitted, but so few may be chance: 'inner' of 32768 or more shows whether it is \
         not met.",
    );
    result.requirements[0].counted = Some(CountedMechanisms { mechanisms: 10_000, outside: 27, sampling_error: 0.002 });
    assert_says(
        &result,
        "Of 10000 mechanisms 27 are outside, as many as permitted: no number of runs decides this, another limit or share does.",
    );
    result.requirements[0].lower_si = f64::NEG_INFINITY;
    result.requirements[0].of = Deviation::Value;
    assert_says(&result, "Undecided: the value of slider stays below 0.7 mm over the whole cycle");
}

#[test]
fn a_mechanism_without_play_says_so() {
    let mut record = report_fixture::motion::worn_pin();
    record.outputs[0].clearance = ClearanceAnswer::default();
    // The rod moves the slider by Δl/cos b, the crank by Δr (cos t + tan b sin t), sin b = -(r/l) sin t; of whole degrees most at
    // 225°: 0.03644020 mm.
    let text = one_line(&motion_text(&record));
    let scatter =
        "No joint has play. Part scatter moves the slider with a standard deviation of at most 0.03645 mm (at 225°).";
    assert!(text.contains(scatter), "{text}");
    assert!(!text.contains("the motion is ideal"), "{text}");
    let page = motion_page(&record);
    assert!(page.contains("Effect of part scatter") && page.contains("parameter.rod_length"), "it has its section");
    record.outputs[0].dimensional_standard_deviation_si.clear();
    record.outputs[0].dimensional_contributors.clear();
    let text = one_line(&motion_text(&record));
    assert!(text.contains("No joint has play and no part scatters: the motion is ideal."), "{text}");
    assert!(!text.contains("not known"), "{text}");
    assert!(!motion_page(&record).contains("Effect of part scatter"));
}

#[test]
fn play_of_which_nothing_is_known_is_not_said_to_be_none() {
    let mut record = report_fixture::motion::worn_pin();
    record.outputs[0].clearance.forget();
    let sentence = "What the play of 'gudgeon' and 'crankpin' does is not known.";
    let scattering = one_line(&motion_text(&record));
    assert!(scattering.contains(sentence) && scattering.contains("Part scatter moves the slider"), "{scattering}");
    record.outputs[0].dimensional_standard_deviation_si.clear();
    record.outputs[0].dimensional_contributors.clear();
    let text = one_line(&motion_text(&record));
    for wrong in ["the motion is ideal", "moves none of the outputs", "No joint has play"] {
        assert!(text.contains(sentence) && !text.contains(wrong), "{text}");
    }
    assert!(!motion_page(&record).contains("an eccentricity e"), "nothing was computed");
}

#[test]
fn how_much_of_a_deviation_is_lean_is_said_beside_it() {
    let mut record = report_fixture::motion::worn_pin();
    assert!(!one_line(&motion_text(&record)).contains("lean"));
    // Without lean a quarter is left, at all angles alike.
    let answer = &mut record.outputs[0].clearance;
    answer.held_first_order_si = answer.first_order_si.iter().map(|all_si| 0.25 * all_si).collect();
    let text = one_line(&motion_text(&record));
    assert!(
        text.contains("75 % of the ±0.") && text.contains("is lean: with pins that do not lean it is ±0."),
        "{text}"
    );
    assert!(motion_page(&record).contains("with pins that do not lean"), "its chart has the curve");
}

#[test]
fn a_study_says_that_its_runs_know_no_lean() {
    let lean = "bands, forces and verdicts are without lean";
    let mut result = worn_pin();
    assert!(!one_line(&study_text(&result)).contains(lean));
    result.leans = true;
    let text = one_line(&study_text(&result));
    assert!(text.contains(lean), "{text}");
    assert!(one_line(&study_page(&result)).contains(lean));
}

#[test]
fn how_play_is_found_is_said_of_journals_that_must_meet_conditions_together() {
    let mut record = report_fixture::motion::worn_pin();
    let page = motion_page(&record);
    assert!(page.contains("an eccentricity e") && !page.contains("that let the loops close"), "each by itself");
    let own = record.outputs[0].clearance.clone();
    record.outputs[0].clearance = ClearanceAnswer {
        searched: vec![SearchedPosition {
            position: 90,
            found_si: [-6e-4, 6e-4],
            proven_si: Some([f64::NEG_INFINITY, f64::INFINITY]),
            conditions: 1,
        }],
        first_order_si: own.first_order_si,
        contributors: own.contributors,
        ..ClearanceAnswer::default()
    };
    let page = motion_page(&record);
    let method = "the largest g·p over all places p of the journals in their bearings that let the loops close";
    let chart = "Each journal may be anywhere in its clearance circle, as far as the loops close. The band is";
    assert!(page.contains(method) && page.contains("a search over all places of the journals"), "{page}");
    assert!(page.contains(chart), "{page}");
    for wrong in ["an eccentricity e", "leans", "The standard deviation assumes"] {
        assert!(!page.contains(wrong), "{wrong}");
    }
}

#[test]
fn a_block_that_overhangs_its_guide_is_named_with_the_angles() {
    let mut record = report_fixture::motion::worn_pin();
    let overhang = "overhang";
    assert!(!motion_text(&record).contains(overhang));
    let spans_rad = [[20.0_f64, 50.0], [200.0, 200.0]].map(|span| span.map(f64::to_radians)).to_vec();
    record.guide_overhangs = vec![GuideOverhang { joint: "rail".to_owned(), spans_rad }];
    let due = "Joint rail: the block may overhang an end of its guide at 20° to 50° and 200° of crank. It can tilt further there than \
               the worst case assumes, so that the effect of play may be larger than stated.";
    let text = one_line(&motion_text(&record));
    assert!(text.contains(due), "{text}");
    let page = motion_page(&record).replace('\u{202f}', " ");
    assert!(page.contains(due));
}

/// The curve of the study from `lowest_m` to `highest_m`, half as far in the middle of the ranges, and nothing else to answer with.
fn curve_between(of: Deviation, lowest_m: f64, highest_m: f64) -> StudyResult {
    let mut result = worn_pin();
    result.bounds.clear();
    let curve = &mut result.curves[0];
    curve.of = of;
    let middle_m = 0.5 * (lowest_m + highest_m);
    for (range, share) in [(&mut curve.mixed, 1.0), (&mut curve.random, 0.5)] {
        range.lower_si.fill(middle_m + share * (lowest_m - middle_m));
        range.upper_si.fill(middle_m + share * (highest_m - middle_m));
    }
    result
}

#[test]
fn analytic_what_lies_on_one_side_is_not_within_plus_or_minus() {
    let one_sided = curve_between(Deviation::Total, 4.3e-4, 5.9e-4);
    assert_says(&one_sided, "stays between 0.43 mm and 0.59 mm of its ideal motion");
    let nearly_even = curve_between(Deviation::Total, 5.003e-4, 5.196e-4);
    assert_says(&nearly_even, "stays between 0.500 mm and 0.520 mm of its ideal motion");
    let even = curve_between(Deviation::Total, -4.97e-4, 5.13e-4);
    assert_says(&even, "stays within ±0.513 mm of its ideal motion");
    // What the answer has already is not said again.
    assert_says(
        &even,
        "- At each angle, 95 % of mechanisms stay within ±0.261 mm at mid-range values of the unknown inputs. -",
    );
    let value = curve_between(Deviation::Value, 0.1552, 0.1698);
    assert_says(
        &value,
        "At each angle of crank, the slider (x of slider.pin) lies between 155 mm and 170 mm in at least 95 % of mechanisms.",
    );
    let text = one_line(&study_text(&value));
    assert!(!text.contains("mid-range values"), "{text}");
    let even_value = curve_between(Deviation::Value, -0.1698, 0.1693);
    assert_says(&even_value, "lies between -170 mm and 170 mm in at least 95 % of mechanisms.");
}

#[test]
fn identity_runs_are_told_by_what_they_were_for() {
    let mut result = worn_pin();
    let parts = [(Purpose::Contributors, 640), (Purpose::Rare, 5120)];
    result.counts.by_purpose.extend(parts.map(|(purpose, runs)| PurposeRuns { purpose, runs }));
    result.counts.runs += 640 + 5120;
    let page = one_line(&study_page(&result));
    let account = "23 296 = 64 values of the unknown inputs × 256 random samples (8 independent replicates of 32) + 1024 of the \
                   probability-only treatment + 128 of the interval-only treatment + 640 for sensitivities + 5120 for small probabilities";
    assert!(page.contains(account), "{page}");
    assert!(!page.contains("for the two other treatments"));
}

#[test]
fn without_intervals_nothing_is_said_to_hold_over_them() {
    let mut result = worn_pin();
    result.inputs.retain(|input| input.kind == InputKind::Random);
    result.counts.outer = 1;
    result.counts.by_purpose.truncate(1);
    result.counts.runs = 256;
    let text = one_line(&study_text(&result));
    assert!(text.contains("Bounds, numerical error included"), "{text}");
    assert!(!text.contains("all values of the unknown inputs"), "{text}");
    let page = one_line(&study_page(&result));
    assert!(page.contains("256 = 256 random samples (8 independent replicates of 32)"), "{page}");
    assert!(page.contains("Shares of mechanisms."), "{page}");
    assert!(page.contains("Each statistic lies between its two bounds. "), "{page}");
}

#[test]
fn lists_of_uneven_length_leave_gaps() {
    let mut result = worn_pin();
    let bounds = result.bounds.clone();
    let fewer = bounds[..1].to_vec();
    result.percentiles = vec![
        PercentileBounds { percentile: 0.05, bounds: bounds.clone() },
        PercentileBounds { percentile: 0.95, bounds: fewer.clone() },
    ];
    result.cuts = vec![CutBounds { alpha: 0.0, bounds }, CutBounds { alpha: 0.5, bounds: fewer }];
    assert!(study_text(&result).contains("5 % percentile"));
    assert!(study_page(&result).contains("Degree 0.5"));
}

#[test]
fn the_share_below_a_limit_is_the_same_in_the_picture_as_in_the_table() {
    let mut result = worn_pin();
    let asked = result.bounds.iter_mut().find(|bound| matches!(bound.statistic, Statistic::ProbabilityAbove(_)));
    let asked = asked.expect("the fixture asks for a probability");
    (asked.lower.widened_si, asked.upper.widened_si) = (0.125, 0.75);
    let page = one_line(&study_page(&result));
    assert!(page.contains("Below 0.4 mm: between 25 % and 87.5 % of mechanisms."), "{page}");
    result.bounds.retain(|bound| !bound.statistic.is_probability());
    let pbox = &mut result.boxes[0];
    (pbox.value_si, pbox.lower, pbox.upper) = (vec![3e-4, 3.9e-4, 4.1e-4], vec![0.0, 0.5, 0.75], vec![0.0, 0.875, 1.0]);
    let page = one_line(&study_page(&result));
    assert!(page.contains("Below 0.4 mm: between 50 % and 100 % of mechanisms that were run."), "{page}");
}

#[test]
fn where_only_curves_were_asked_for_no_empty_table_is_shown() {
    let mut result = worn_pin();
    result.bounds.retain(|bound| matches!(bound.at, ResponsePoint::Curve { .. }));
    let count = result.bounds.len();
    let page = one_line(&study_page(&result));
    assert!(page.contains(&format!("All bounds are points of curves: {count} rows in bounds.csv.")), "{page}");
    assert!(!page.contains("± error</th>"));
    assert_says(&result, "All bounds are points of curves");
}

#[test]
fn names_send_no_commands_to_a_terminal() {
    let mut result = worn_pin();
    result.name = "a\u{1b}[31mb\u{202e}c".to_owned();
    assert!(study_text(&result).starts_with("a\u{fffd}[31mb\u{fffd}c\n"), "{}", study_text(&result));
}

#[test]
fn a_search_for_offers_says_why_it_ended() {
    let mut result = worn_pin();
    let allocation = result.allocation.as_mut().expect("the fixture has one");
    allocation.choices.clear();
    (allocation.combinations, allocation.excluded, allocation.studies) = (9, 9, 1);
    allocation.stop = AllocationStop::AllExcluded;
    assert_says(
        &result,
        "No offer found: none of 9 combinations meets the requirements. Each was run, or is looser than one that was run (1 direct \
         study).",
    );
    let allocation = result.allocation.as_mut().expect("the fixture has one");
    (allocation.combinations, allocation.excluded, allocation.studies) = (81, 30, 27);
    allocation.stop = AllocationStop::TriedEnough;
    assert_says(
        &result,
        "No offer found: the search ended after 27 direct studies. Of 81 combinations, 30 are excluded: run without success, or looser \
         than such a one. The 51 others that cost more were not tried.",
    );
    let allocation = result.allocation.as_mut().expect("the fixture has one");
    (allocation.combinations, allocation.excluded, allocation.studies) = (160_000, 0, 0);
    allocation.stop = AllocationStop::TooManyCombinations;
    assert_says(&result, "No offer found: 160000 combinations are too many to search.");
}

#[test]
fn what_is_promised_is_said_to_be_a_share_of_volume_and_never_met() {
    let mut result = worn_pin();
    result.requirements.truncate(1);
    result.requirements[0].promised = Some(0.9981);
    result.requirements[0].verdict = Verdict::Promised;
    let end = |side: Side, bound_si: f64, failed_values: u64| PromisedEnd {
        output: "slider".to_owned(),
        of: Deviation::Total,
        at: ResponsePoint::Reduced { reduction: Reduction::MaximumAbsolute },
        statistic: Statistic::Quantile(0.975),
        unit: SiUnit::LENGTH,
        side,
        bound_si,
        witness: result.requirements[0].witness.clone(),
        failed_values,
    };
    let ends = vec![end(Side::Upper, 6.1234e-4, 0), end(Side::Lower, f64::NEG_INFINITY, 2)];
    result.promise = Some(PromiseRecord {
        share: 0.99,
        confidence: 0.995,
        boxes: 1,
        values: 533,
        inner: 256,
        miss: 0.01,
        runs: 136_448,
        ends,
        bands: Vec::new(),
    });
    for words in [
        "Requirements promised for a share of the box",
        "in at least 99.81 % of mechanisms, for at least 99 % of the box of the intervals with 99.5 % confidence (not for every value)",
        "Promised for 99 % of the box",
        "With 99.5 % confidence, each of these bounds holds in at least 99 % of the box of the intervals.",
        "It is not a probability of the true values, and it does not hold for every value.",
        "at most 0.6124 mm; the limit is largest at",
        "nothing is promised, because runs failed at 2 of the 533 values that were tried.",
    ] {
        assert_says(&result, words);
    }
    let (text, page) = (one_line(&study_text(&result)), one_line(&study_page(&result)));
    assert!(!text.contains("All requirements met") && !text.contains("Met:"), "{text}");
    // In the answer and in the table.
    assert_eq!(page.matches("class=\"verdict promised\"").count(), 2, "{page}");

    // Undecided for failed runs.
    let undecided = &mut result.requirements[0];
    (undecided.promised, undecided.failed_values, undecided.verdict) = (Some(0.0), 3, Verdict::Undecided);
    assert_says(&result, "Runs failed at 3 of the 533 values that were tried: nothing is promised.");
}
