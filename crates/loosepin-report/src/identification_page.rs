//! The page of an identification: what is consistent with readings and motion, measured over predicted, what to measure next.

use maud::{Markup, html};

use super::identification_figures::{RangeRow, map, ranges, shares, strip};
use super::identification_gain::{bound_words, narrower_words};
use super::identification_text::{
    alike_words, further_words, grounds, headline, misfit_words, range, stated, sum_words,
};
use super::lengths_text::{LENGTH_HEADS, length_rows, length_words};
use super::motion_identification_text::{self as motion_text, plan_words};
use super::number::{NumberWriter, Rounding};
use super::page::{Page, Section, cards, facts, sentences};
use super::posterior_figure::density;
use super::posterior_text::{motion_range, posterior_heads, posterior_rows, posterior_words};
use super::repeat_section::repeat_section;
use super::wording::capitalised;
use loosepin_result::identification::{Gain, Identification, Outcome, PlayBounds, Specimen};
use loosepin_result::motion_identification::{MotionPlan, MotionPosterior, MotionSpecimen, SpecimenLengths};
use loosepin_text::units::counted;

/// Digits of a measured value.
const DIGITS: usize = 4;
/// Unknowns that are named in the answer.
const MOST_NAMED: usize = 4;

/// The page of an identification as one HTML text that needs no network. Text from files is escaped.
pub fn identification_page(answer: &Identification) -> String {
    let writer = NumberWriter::for_page(&answer.display_units);
    let below = answer.motion.first().map_or_else(Markup::default, |first| first_map(first, &writer));
    let mut sections = Vec::new();
    if !answer.motion.is_empty() {
        let body = each(&answer.motion, |specimen| &specimen.name, |index, it| unknowns(it, index, &writer));
        sections.push(Section::new("unknowns", "What the motion leaves", body));
        let body = each(&answer.motion, |specimen| &specimen.name, |index, it| features(it, index, &writer));
        sections.push(Section::new("features", "Measured and predicted", body));
    }
    if answer.motion.iter().any(|specimen| specimen.posterior.is_some()) {
        let body = each(&answer.motion, |specimen| &specimen.name, |index, it| posterior(it, index, &writer));
        sections.push(Section::new("posterior", "How probable the values are", body));
    }
    if answer.motion.iter().any(|specimen| specimen.lengths.is_some()) {
        let body = each(&answer.motion, |specimen| &specimen.name, |_, it| lengths(it, &writer));
        sections.push(Section::new("lengths", "Lengths of the specimen", body));
    }
    if !answer.specimens.is_empty() {
        let body = each(&answer.specimens, |specimen| &specimen.name, |index, it| plays(it, index, &writer));
        sections.push(Section::new("plays", "What the readings leave", body));
    }
    if let Some(plan) = &answer.plan {
        sections.push(Section::new("next", "What to measure next", next(plan, &writer)));
    }
    if let Some(gain) = &answer.gain {
        sections.push(Section::new("gain", "The study before and after", gained(gain, &writer)));
    }
    sections.push(Section::new("method", "How this was computed", method(answer, &writer)));
    sections.extend(repeat_section(&answer.repeat));
    Page {
        title: answer.study.clone(),
        kicker: "Identification",
        subtitle: html! {
            (answer.model) " · " (writer.percent(answer.confidence, Rounding::Nearest)) " confidence"
        },
        answer: sentences(&answer_sentences(answer, &writer)),
        is_answer_short: true,
        beside: html! {},
        below,
        sections,
        identity: "identification".to_owned(),
        version: answer.version.clone(),
    }
    .into_html()
}

/// The same for each specimen, below its name where there are several.
fn each<S>(specimens: &[S], name: impl Fn(&S) -> &Option<String>, body: impl Fn(usize, &S) -> Markup) -> Markup {
    html! {
        @for (index, specimen) in specimens.iter().enumerate() {
            @if let Some(name) = name(specimen) { h3 { "Specimen " (name) } }
            (body(index, specimen))
        }
    }
}

/// The answer in sentences, the most important first.
fn answer_sentences(answer: &Identification, writer: &NumberWriter<'_>) -> Vec<String> {
    let named = |name: &Option<String>, words: String| match name {
        Some(name) => format!("Specimen {name}: {words}"),
        None => capitalised(&words),
    };
    let of_motion = |specimen: &MotionSpecimen| {
        if specimen.misfit.is_some() {
            return named(&specimen.name, "misfit: no values of the unknowns explain the motion.".to_owned());
        }
        let told = |(place, unknown): (usize, &PlayBounds)| {
            let list = specimen.lists.iter().find(|list| list.unknown == place);
            match list {
                Some(list) => format!("{} is {}", unknown.name, list.after.join(" or ")),
                None => format!("{} is {}", unknown.name, range(unknown.after_si, &unknown.unit, writer)),
            }
        };
        let words: Vec<String> = specimen.unknowns.iter().enumerate().take(MOST_NAMED).map(told).collect();
        named(&specimen.name, format!("{}.", words.join("; ")))
    };
    let of_readings = |specimen: &Specimen| match &specimen.outcome {
        Outcome::Consistent(known) => named(&specimen.name, headline(&specimen.readings, known, writer)),
        Outcome::Misfit(_) => named(&specimen.name, "misfit: no values of the plays explain the readings.".to_owned()),
    };
    let mut words: Vec<String> = answer.motion.iter().map(of_motion).collect();
    words.extend(answer.specimens.iter().map(of_readings));
    words.extend(answer.gain.iter().map(|gain| format!("The study before (A) and after (B): {}", gain.headline)));
    words
}

/// Places of the unknowns that are no lists.
fn continuous(specimen: &MotionSpecimen) -> Vec<usize> {
    let is_list = |unknown: usize| specimen.lists.iter().any(|list| list.unknown == unknown);
    (0..specimen.unknowns.len()).filter(|unknown| !is_list(*unknown)).collect()
}

/// The map that the page begins with.
fn first_map(specimen: &MotionSpecimen, writer: &NumberWriter<'_>) -> Markup {
    match continuous(specimen)[..] {
        [] => Markup::default(),
        [only] => strip(specimen, only, "map.first".to_owned(), writer),
        [across, up, ..] => map(specimen, [across, up], "map.first".to_owned(), writer),
    }
}

/// Unknowns before and after, and the maps that the page does not begin with.
fn unknowns(specimen: &MotionSpecimen, index: usize, writer: &NumberWriter<'_>) -> Markup {
    let row = |(place, unknown): (usize, &PlayBounds)| match specimen.lists.iter().find(|list| list.unknown == place) {
        Some(list) => [html! { (unknown.name) }, html! { (list.before.join(", ")) }, html! { (list.after.join(", ")) }],
        None => [
            html! { (unknown.name) },
            html! { (stated(unknown.before_si, &unknown.unit, writer)) },
            html! { (range(unknown.after_si, &unknown.unit, writer)) },
        ],
    };
    let places = continuous(specimen);
    let pairs = places.iter().enumerate().flat_map(|(k, a)| places[k + 1..].iter().map(move |b| [*a, *b]));
    // The first one stands below the answer.
    let pairs: Vec<[usize; 2]> = pairs.skip(usize::from(index == 0)).collect();
    let share = |share: f64| writer.percent(share, Rounding::Up);
    html! {
        @if let Some(misfit) = &specimen.misfit {
            (items(&motion_text::misfit_words(misfit, &specimen.features, writer)))
        } @else {
            p {
                (share(specimen.share_of_box[0])) " of the box is consistent, " (share(specimen.share_of_box[1]))
                " with the cells beside it."
            }
            (cards(["unknown", "before", "after"], specimen.unknowns.iter().enumerate().map(row)))
        }
        @if places.len() == 1 && index > 0 { (strip(specimen, places[0], format!("map.{index}"), writer)) }
        @for pair in &pairs { (map(specimen, *pair, format!("map.{index}.{}-{}", pair[0], pair[1]), writer)) }
        p.quiet {
            (specimen.points.len()) " values were tested with " (counted(specimen.runs_per_point, "run")) " each."
            @if specimen.failed > 0 {
                " " (counted(specimen.failed, "run")) " failed: each counts as if it lay further off than the measurement."
            }
            @if specimen.is_coarse { " The search ended at its number of points: more of them (--points) narrow further." }
        }
    }
}

/// Measured features over what is predicted.
fn features(specimen: &MotionSpecimen, index: usize, writer: &NumberWriter<'_>) -> Markup {
    let rows: Vec<RangeRow> = specimen
        .features
        .iter()
        .map(|feature| RangeRow {
            label: feature.name.clone(),
            unit: feature.unit.clone(),
            before_si: feature.predicted_before_si,
            after_si: feature.predicted_after_si,
            measured_si: Some((feature.measured_si, feature.found_si)),
        })
        .collect();
    let alternative = format!("Bars: predicted ranges of {}, and what was measured.", counted(rows.len(), "feature"));
    let caption = html! {
        strong { "Measured over predicted." }
        " Wide bar: least to largest of all runs at all tested values; narrow bar: at the consistent ones. Dot: measured, with the true \
         values that its common error allows. Each row has its own scale."
    };
    let row = |feature: &loosepin_result::motion_identification::MotionFeature| {
        let after = feature.predicted_after_si;
        [
            html! { (feature.name) },
            html! { (writer.rounded(feature.measured_si, &feature.unit, DIGITS, Rounding::Nearest)) },
            html! { (motion_range(feature.found_si, &feature.unit, writer)) },
            html! { (motion_range(feature.predicted_before_si, &feature.unit, writer)) },
            html! { (after.map_or_else(|| "none".to_owned(), |ends_si| motion_range(ends_si, &feature.unit, writer))) },
        ]
    };
    let heads = ["feature", "#measured", "with its common error", "predicted before", "predicted after"];
    html! {
        (ranges(&rows, format!("features.{index}"), (alternative, caption), writer))
        (cards(heads, specimen.features.iter().map(row)))
    }
}

/// Lengths of the specimen, or why they are not told.
fn lengths(specimen: &MotionSpecimen, writer: &NumberWriter<'_>) -> Markup {
    let Some(lengths) = &specimen.lengths else { return Markup::default() };
    html! {
        @if let SpecimenLengths::Given(rows) = lengths {
            (cards(LENGTH_HEADS, length_rows(rows, writer).into_iter().map(|row| row.map(|cell| html! { (cell) }))))
        }
        (items(&length_words(specimen, lengths, writer)))
    }
}

/// Words of the terminal as sentences of a list.
fn items(words: &[String]) -> Markup {
    html! { ul { @for words in words { li { (capitalised(words)) "." } } } }
}

/// The posterior distribution, or why there is none.
fn posterior(specimen: &MotionSpecimen, index: usize, writer: &NumberWriter<'_>) -> Markup {
    let Some(posterior) = &specimen.posterior else { return Markup::default() };
    let words = posterior_words(specimen, posterior, writer);
    let MotionPosterior::Given(given) = posterior else {
        return items(&words);
    };
    let heads = posterior_heads(given, writer);
    let rows = posterior_rows(specimen, given, writer).into_iter().map(|row| row.map(|cell| html! { (cell) }));
    html! {
        @for (place, (unknown, marginal)) in specimen.unknowns.iter().zip(&given.marginals).enumerate() {
            @if let Some(summary) = &marginal.summary {
                (density(unknown, (marginal, summary), given.probability, format!("posterior.{index}.{place}"), writer))
            }
        }
        (cards(heads.each_ref().map(String::as_str), rows))
        (items(&words))
    }
}

/// What readings of a backlash test leave.
fn plays(specimen: &Specimen, index: usize, writer: &NumberWriter<'_>) -> Markup {
    let known = match &specimen.outcome {
        Outcome::Consistent(known) => known,
        Outcome::Misfit(misfit) => {
            return items(&misfit_words(misfit, &specimen.readings, writer));
        }
    };
    let rows: Vec<RangeRow> = known
        .plays
        .iter()
        .map(|play| RangeRow {
            label: play.name.clone(),
            unit: play.unit.clone(),
            before_si: play.before_si,
            after_si: Some(play.after_si),
            measured_si: None,
        })
        .collect();
    let alternative = format!("Bars: {} before and after.", counted(rows.len(), "play"));
    let caption = html! { strong { "Each play before and after." } " Wide bar: the interval of the study; narrow bar: what the readings leave." };
    let row = |play: &PlayBounds| {
        [
            html! { (play.name) },
            html! { (stated(play.before_si, &play.unit, writer)) },
            html! { (range(play.after_si, &play.unit, writer)) },
            html! { (if play.is_identifiable { "yes" } else { "no" }) },
        ]
    };
    let is_sum = |weights: &[f64]| weights.iter().filter(|weight| **weight != 0.0).count() > 1;
    let sums = known.combinations.iter().filter(|sum| is_sum(&sum.weights));
    let sums: Vec<String> = sums.map(|sum| sum_words(sum, &known.plays, writer)).collect();
    let next: Vec<String> =
        alike_words(known, &specimen.readings).into_iter().chain(further_words(known, writer)).collect();
    html! {
        (ranges(&rows, format!("plays.{index}"), (alternative, caption), writer))
        (cards(["play", "before", "after", "fixed by itself"], known.plays.iter().map(row)))
        @if !sums.is_empty() {
            h3 { "Sums that the readings fix" }
            ul { @for sum in &sums { li { (sum) "." } } }
        }
        @if !next.is_empty() {
            h3 { "What to measure next" }
            (items(&next))
        }
    }
}

/// What features of the motion would tell.
fn next(plan: &MotionPlan, writer: &NumberWriter<'_>) -> Markup {
    html! {
        (shares(plan, "next.features".to_owned(), writer))
        (items(&plan_words(plan, writer)))
    }
}

fn gained(gain: &Gain, writer: &NumberWriter<'_>) -> Markup {
    let row = |bound: &loosepin_result::identification::GainedBound| {
        [
            html! { (bound.response) },
            html! { (bound.statistic) },
            html! { (bound_words(bound.before_si, bound, writer)) },
            html! { (bound_words(bound.after_si, bound, writer)) },
            html! { (narrower_words(bound, writer)) },
        ]
    };
    html! {
        p { (gain.headline) }
        @for band in &gain.bands { p { (band) } }
        (cards(["of", "statistic", "before (A)", "after (B)", "change"], gain.bounds.iter().map(row)))
        p.quiet { "Runs: " (writer.count(gain.runs[0])) " before, " (writer.count(gain.runs[1])) " after." }
    }
}

fn method(answer: &Identification, writer: &NumberWriter<'_>) -> Markup {
    let grounds = grounds(answer, writer);
    let mut rows = vec![("Holds".to_owned(), html! { @for words in &grounds { (capitalised(words)) ". " } })];
    if !answer.motion.is_empty() {
        rows.push((
            "Motion".to_owned(),
            html! { "one joint test of all features at each value: the rank of the measurement among independent runs" },
        ));
    }
    if !answer.specimens.is_empty() {
        rows.push((
            "Readings".to_owned(),
            html! { "two linear inequalities of the plays for each reading, factors with their bounds; linear programming" },
        ));
    }
    rows.push(("Version".to_owned(), html! { "loosepin " (answer.version) }));
    facts(&rows)
}

#[cfg(test)]
mod tests {
    use super::identification_page;
    use loosepin_result::identification::{Gain, Identification, PlayBounds};
    use loosepin_result::motion_identification::{
        Marginal, MarginalSummary, MotionFeature, MotionMisfit, MotionPosterior, MotionSpecimen, Posterior,
        PosteriorRefusal, TestedPoint,
    };
    use loosepin_text::units::{DisplayUnits, SiUnit};

    fn unknown(name: &str, after_si: [f64; 2]) -> PlayBounds {
        PlayBounds {
            path: format!("joint.{name}.radial_clearance"),
            name: name.to_owned(),
            unit: SiUnit::LENGTH,
            before_si: [1e-4, 5e-4],
            after_si,
            is_identifiable: false,
            is_interval: true,
        }
    }

    /// Two unknowns, four cells, of which that of the small values is consistent.
    fn answer(misfit: Option<MotionMisfit>) -> Identification {
        let point = |values_si: [f64; 2], is_consistent: bool| TestedPoint {
            values_si: values_si.to_vec(),
            is_consistent: is_consistent && misfit.is_none(),
            distance: if is_consistent { 0.4 } else { 7.0 },
        };
        let feature = MotionFeature {
            name: "slider, <rms>".to_owned(),
            unit: SiUnit::LENGTH,
            measured_si: 2e-3,
            repeats: 1,
            found_si: [1.9e-3, 2.1e-3],
            predicted_before_si: [1e-3, 4e-3],
            predicted_after_si: misfit.is_none().then_some([1.5e-3, 2.5e-3]),
        };
        let specimen = MotionSpecimen {
            name: None,
            features: vec![feature],
            unknowns: vec![unknown("pin", [1e-4, 3e-4]), unknown("gudgeon", [1e-4, 3e-4])],
            lists: Vec::new(),
            share_of_box: [0.25, 1.0],
            grid: vec![2, 2],
            cells: if misfit.is_none() { vec![0] } else { Vec::new() },
            points: vec![
                point([2e-4, 2e-4], true),
                point([4e-4, 2e-4], false),
                point([2e-4, 4e-4], false),
                point([4e-4, 4e-4], false),
            ],
            runs_per_point: 199,
            failed: 0,
            is_coarse: false,
            misfit,
            posterior: None,
            lengths: None,
        };
        Identification {
            study: "worn <pin>".to_owned(),
            model: "slider-crank".to_owned(),
            version: "0.1.0".to_owned(),
            confidence: 0.99,
            random_inputs: Vec::new(),
            display_units: DisplayUnits::default(),
            specimens: Vec::new(),
            motion: vec![specimen],
            plan: None,
            gain: None,
            repeat: Default::default(),
        }
    }

    #[test]
    fn the_map_shows_the_cell_that_is_kept_and_text_of_files_is_escaped() {
        let mut with_gain = answer(None);
        with_gain.gain =
            Some(Gain { headline: "It shrinks.".to_owned(), bands: Vec::new(), bounds: Vec::new(), runs: [8, 8] });
        let page = identification_page(&with_gain);
        for words in [
            "worn &lt;pin&gt;",
            "slider, &lt;rms&gt;",
            "Pin is 0.1000 mm to 0.3000 mm; gudgeon is",
            "Map of pin and gudgeon: 4 tested values; consistent cells: 1.",
            "The study before (A) and after (B): It shrinks.",
        ] {
            assert!(page.replace('\u{a0}', " ").contains(words), "{words}");
        }
        assert!(!page.contains("<rms>"));
        // One closed square.
        assert_eq!(
            page.split("class=\"cell\"").nth(1).and_then(|rest| rest.split('>').next()).map(|d| d.matches('Z').count()),
            Some(1)
        );
    }

    #[test]
    fn a_posterior_distribution_is_drawn_for_each_unknown() {
        let summary = MarginalSummary { mean_si: 2e-4, standard_deviation_si: 3e-5, credible_si: [1.3e-4, 2.9e-4] };
        let marginal = Marginal { shares: vec![0.75, 0.25], summary: Some(summary) };
        let given = Posterior {
            probability: 0.99,
            effective_values: 4.0,
            effective_runs: 796.0,
            marginals: vec![marginal.clone(), marginal],
        };
        let mut told = answer(None);
        assert!(!identification_page(&told).contains("How probable the values are"));
        told.motion[0].posterior = Some(MotionPosterior::Given(given));
        let page = identification_page(&told).replace('\u{a0}', " ");
        for words in
            ["How probable the values are", "99 % credible", "Posterior density of gudgeon", "0.1300 mm to 0.2900 mm"]
        {
            assert!(page.contains(words), "{words}");
        }
        for name in ["posterior.0.0", "posterior.0.1"] {
            assert!(page.contains(&format!("data-figure=\"{name}\"")), "{name}");
        }
        told.motion[0].posterior = Some(MotionPosterior::Refused(PosteriorRefusal::NothingScatters));
        assert!(identification_page(&told).contains("No posterior distribution: nothing scatters"));
    }

    #[test]
    fn a_misfit_has_no_values() {
        let page = identification_page(&answer(Some(MotionMisfit { least_distance: 7.0, culprits: Vec::new() })));
        assert!(page.contains("Misfit: no values of the unknowns explain the motion."));
        assert!(page.contains("7.00 times as far from the runs as the test allows"), "how far");
        assert!(page.contains("none") && !page.contains("of the box is consistent"));
    }
}
