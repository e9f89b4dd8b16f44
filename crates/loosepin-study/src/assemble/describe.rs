//! The uncertain inputs and the runs, in words.

use super::material::Material;
use crate::distribution_words::distribution_words;
use crate::file::{CorrelationMeasure, EpistemicSubject, RandomInput, Study, UncertainParameter, journal_words};
use crate::model::PLAY;
use crate::model::outputs::OutputSource;
use loosepin_result::study::{
    CorrelationDescription, CutDescription, CycleDescription, ElementDescription, InputDescription, InputKind,
    OutputDescription, PathOutput,
};
use loosepin_text::document::listed;
use loosepin_text::units::{SiUnit, format_number};
use loosepin_uncertainty::{EpistemicVariable, FocalElement, Interval, rank_of_normal};

/// The uncertain inputs as they are shown: as [`inputs`], all numbers that the places of journals are drawn from as one input.
pub fn shown_inputs(study: &Study) -> Vec<InputDescription> {
    let mut shown = inputs(study);
    let is_of_model = |input: &&RandomInput| input.quantity().is_some();
    let of_model = study.random.iter().filter(is_of_model).count();
    let journals = study.journals.map(|distribution| InputDescription {
        path: PLAY.to_owned(),
        kind: InputKind::DrawnPlay,
        unit: SiUnit::NONE,
        words: journal_words(distribution).to_owned(),
    });
    // They are the last of the random ones.
    shown.splice(of_model..study.random.len(), journals);
    shown
}

/// The uncertain inputs, random ones first, each kind in file order.
pub fn inputs(study: &Study) -> Vec<InputDescription> {
    let random = study.random.iter().map(|input| InputDescription {
        path: input.path.clone(),
        kind: InputKind::Random,
        unit: input.unit(&study.model),
        words: {
            let words = distribution_words(input.variable.distribution(), input.dimension(&study.model));
            let origin = input.origin.as_ref().map_or(String::new(), |origin| format!("; {origin}"));
            words + &origin + &uncertain_words(input, study)
        },
    });
    let epistemic = study.epistemic.iter().map(|input| {
        let [lower_si, upper_si] = input.variable.ends();
        let written = |value_si: f64| input.written(&study.model, value_si);
        let ends = |interval: &Interval| format!("{} .. {}", written(interval.lower()), written(interval.upper()));
        let (kind, words) = match (&input.variable, input.members_written(&study.model)) {
            _ if matches!(input.subject, EpistemicSubject::Play) => {
                (InputKind::Play, "journals anywhere in their play, at each position on the worse side".to_owned())
            }
            (EpistemicVariable::Evidence(evidence), _) => {
                let element = |element: &FocalElement| ElementDescription {
                    lower_si: element.interval.lower(),
                    upper_si: element.interval.upper(),
                    mass: element.mass,
                };
                let shown: Vec<String> = evidence
                    .elements()
                    .iter()
                    .map(|element| format!("{} with mass {}", ends(&element.interval), format_number(element.mass)))
                    .collect();
                let is_scattering = evidence.is_scattering();
                let how = if is_scattering { "scatters in an unknown way within" } else { "in one of" };
                let kind =
                    InputKind::Evidence { elements: evidence.elements().iter().map(element).collect(), is_scattering };
                (kind, format!("{how} {}", listed(&shown, "and")))
            }
            (EpistemicVariable::Fuzzy(fuzzy), _) => {
                let cut = |(alpha, interval): &(f64, Interval)| CutDescription {
                    alpha: *alpha,
                    lower_si: interval.lower(),
                    upper_si: interval.upper(),
                };
                let shown: Vec<String> = fuzzy
                    .cuts()
                    .iter()
                    .map(|(alpha, interval)| format!("{} to the degree {}", ends(interval), format_number(*alpha)))
                    .collect();
                let kind = InputKind::Fuzzy { cuts: fuzzy.cuts().iter().map(cut).collect() };
                (kind, format!("possible are {}", listed(&shown, "and")))
            }
            (EpistemicVariable::Periodic(interval), _) => {
                (InputKind::Periodic { lower_si, upper_si }, format!("any on a circle, {}", ends(interval)))
            }
            (EpistemicVariable::SecondOrder(parameter), _) => {
                let known = distribution_words(parameter.variable().distribution(), input.dimension(&study.model));
                let range = ends(&parameter.range());
                (
                    InputKind::SecondOrder { lower_si, upper_si },
                    format!("one value, as far as known {known}; looked at {range}"),
                )
            }
            (_, Some(of)) => {
                let words = format!("one of {}", listed(&of, "and"));
                (InputKind::Choice { of }, words)
            }
            (_, None) => (
                InputKind::Interval { lower_si, upper_si },
                format!("somewhere between {} and {}", written(lower_si), written(upper_si)),
            ),
        };
        InputDescription { path: input.path.clone(), kind, unit: input.unit(&study.model), words }
    });
    random.chain(epistemic).collect()
}

/// The correlations of random inputs, in file order.
pub fn correlations(study: &Study) -> Vec<CorrelationDescription> {
    let stated = study.correlation.iter().flat_map(|correlation| &correlation.stated);
    stated
        .map(|each| {
            let of = [each.first, each.second].map(|input| study.random[input].path.clone()).to_vec();
            match each.measure {
                CorrelationMeasure::Rank => CorrelationDescription { of, rank: each.value, linear: None },
                CorrelationMeasure::Linear => {
                    CorrelationDescription { of, rank: rank_of_normal(each.normal), linear: Some(each.value) }
                }
            }
        })
        .collect()
}

/// Which parameters are uncertain; the words before have them in the middle.
fn uncertain_words(input: &RandomInput, study: &Study) -> String {
    let words = |uncertain: &UncertainParameter| {
        let known = &study.epistemic[uncertain.epistemic];
        let known_words = match known.members_written(&study.model) {
            None if known.variable.is_second_order() => "with a distribution".to_owned(),
            Some(of) => format!("any of {}", listed(&of, "and")),
            None => {
                let [lower, upper] = known.variable.ends().map(|end| known.written(&study.model, end));
                format!("between {lower} and {upper}")
            }
        };
        format!("; its {} unknown, {known_words}", uncertain.parameter.words())
    };
    input.parameters.iter().map(words).collect()
}

/// The recorded cycle of every run.
pub fn cycle(material: &Material<'_>) -> CycleDescription {
    let study = material.study;
    let input = study.model.input(study.cycle.span, material.response.nominal());
    let stepping = material.response.stepping();
    CycleDescription {
        drive_speed_rad_s: input.is_drive.then_some(input.speed_rad_s),
        drive: input.name,
        transient_turns: study.cycle.transient_turns,
        recorded_turns: study.cycle.recorded_turns,
        tolerance_m: study.sampling.tolerance_m,
        method: stepping.map_or(String::new(), |stepping| stepping.settings.method.name.to_owned()),
    }
}

/// The outputs that were asked about.
pub fn outputs(material: &Material<'_>) -> Vec<OutputDescription> {
    let plan = material.response.plan();
    plan.outputs
        .iter()
        .enumerate()
        .filter(|(output, _)| plan.is_used(*output))
        .map(|(_, output)| OutputDescription {
            name: output.name.clone(),
            words: output.words.clone(),
            unit: output.unit.clone(),
            path: match output.seen {
                OutputSource::Path(_, part) => {
                    let point = output.point.as_deref().unwrap_or_default();
                    Some(PathOutput { point: point.to_owned(), part })
                }
                OutputSource::Reading(_) | OutputSource::Wear(..) | OutputSource::InSpace(_) => None,
            },
            contact_force_in: {
                let joint = output.seen.force_in();
                joint.and_then(|joint| material.response.name_of_contact(joint)).map(str::to_owned)
            },
        })
        .collect()
}
