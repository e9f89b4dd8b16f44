//! The page of an identification: what is consistent with readings and motion, measured over predicted, what to measure next.

use maud::{Markup, html};

use super::gain::gain_section;
use super::grounds::grounds;
use super::lengths::push_lengths;
use super::motion::{first_map, push_features, push_runs, push_unknowns};
use super::plan::plan_section;
use super::posterior::push_posterior;
use super::ranges::range;
use super::readings::push_readings;
use super::readings_words::headline;
use crate::medium::article_page::page_section;
use crate::medium::page::{self, Page, sentences};
use crate::numbers::number::{NumberWriter, Rounding};
use crate::study::repeat_section::repeat_section;
use crate::words::wording::capitalised;
use loosepin_result::identification::{Identification, Outcome, PlayBounds, Specimen};
use loosepin_result::motion_identification::MotionSpecimen;
use loosepin_text::article::{Content, Fact, Medium, Section};

/// Unknowns that are named in the answer.
const MAX_NAMED: usize = 4;

/// The page of an identification as one HTML text that needs no network. Text from files is escaped.
pub fn identification_page(answer: &Identification) -> String {
    let writer = NumberWriter::for_page(&answer.display_units);
    let below = answer.motion.first().map_or_else(Markup::default, |first| first_map(first, &writer));
    let of_motion = |id, title, push: &dyn Fn(&mut Section, usize, &MotionSpecimen)| {
        each((id, title), &answer.motion, |specimen| &specimen.name, push)
    };
    let parts = [
        of_motion("unknowns", "Values consistent with the motion", &|section, index, specimen| {
            push_unknowns(section, specimen, index, &writer);
            push_runs(section, specimen, Medium::Page);
        }),
        of_motion("features", "Measured and predicted", &|section, index, specimen| {
            push_features(section, specimen, index, &writer);
        }),
        of_motion("posterior", "Probability of the values", &|section, index, specimen| {
            push_posterior(section, specimen, index, &writer);
        }),
        of_motion("lengths", "Lengths of the specimen", &|section, _, specimen| {
            push_lengths(section, specimen, &writer)
        }),
        each(
            ("plays", "Values consistent with the readings"),
            &answer.specimens,
            |specimen| &specimen.name,
            &|section, index, it| {
                push_readings(section, it, index, &writer);
            },
        ),
        answer.plan.as_ref().map(|plan| plan_section(plan, &writer)),
        answer.gain.as_ref().map(|gain| gain_section(gain, &writer)),
        Some(method(answer, &writer)),
    ];
    let mut sections: Vec<page::Section> = parts.into_iter().filter_map(page_section).collect();
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
        more: html! {},
        is_folded: false,
        sections,
        identity: "identification".to_owned(),
        version: answer.version.clone(),
    }
    .into_html()
}

/// The contents that `push` makes for each specimen, below its name if there are several; empty if it makes none.
fn each<S>(
    (id, title): (&'static str, &'static str),
    specimens: &[S],
    name: impl Fn(&S) -> &Option<String>,
    push: &dyn Fn(&mut Section, usize, &S),
) -> Option<Section> {
    let mut section = Section::new(id, title);
    let mut is_told = false;
    for (index, specimen) in specimens.iter().enumerate() {
        if let Some(name) = name(specimen) {
            section.push(Content::Heading(format!("Specimen {name}").into()));
        }
        let before = section.blocks.len();
        push(&mut section, index, specimen);
        is_told |= section.blocks.len() > before;
    }
    is_told.then_some(section)
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
        let words: Vec<String> = specimen.unknowns.iter().enumerate().take(MAX_NAMED).map(told).collect();
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

fn method(answer: &Identification, writer: &NumberWriter<'_>) -> Section {
    let holds: String = grounds(answer, writer).iter().map(|words| format!("{}. ", capitalised(words))).collect();
    let motion = "one joint test of all features at each value: the rank of the measurement among independent runs";
    let readings =
        "two linear inequalities of the plays for each reading, factors with their bounds; linear programming";
    let mut facts = vec![Fact::new("Holds", [holds])];
    facts.extend((!answer.motion.is_empty()).then(|| Fact::new("Motion", [motion])));
    facts.extend((!answer.specimens.is_empty()).then(|| Fact::new("Readings", [readings])));
    facts.push(Fact::new("Version", [format!("loosepin {}", answer.version)]));
    Section::of_facts("method", "How this was computed", facts)
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
        assert!(!identification_page(&told).contains("Probability of the values"));
        told.motion[0].posterior = Some(MotionPosterior::Given(given));
        let page = identification_page(&told).replace('\u{a0}', " ");
        for words in
            ["Probability of the values", "99 % credible", "Posterior density of gudgeon", "0.1300 mm to 0.2900 mm"]
        {
            assert!(page.contains(words), "{words}");
        }
        for name in ["posterior.0.0", "posterior.0.1"] {
            assert!(page.contains(&format!("data-figure=\"{name}\"")), "{name}");
        }
        told.motion[0].posterior = Some(MotionPosterior::Refused(PosteriorRefusal::NothingScatters));
        assert!(identification_page(&told).contains("No posterior distribution: there is no scatter"));
    }

    #[test]
    fn a_misfit_has_no_values() {
        let page = identification_page(&answer(Some(MotionMisfit { least_distance: 7.0, culprits: Vec::new() })));
        assert!(page.contains("Misfit: no values of the unknowns explain the motion."));
        assert!(page.contains("7.00 times as far from the runs as the test allows"), "how far");
        assert!(page.contains("none") && !page.contains("of the box is consistent"));
    }
}
