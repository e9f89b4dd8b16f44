//! From the name of a number in results, `slider total maximum_absolute`, back to the question that asks for it.

use super::words::{DEVIATIONS, REDUCTIONS};
use crate::model::StudyModel;
use loosepin_text::diagnostics::{Code, nearest_name, problems};

/// The keys of a question.
#[derive(Debug, Clone, PartialEq)]
pub struct NamedQuestion {
    /// Output of the model.
    pub output: String,
    /// Component of it, where it is a path.
    pub component: Option<&'static str>,
    /// Word of the deviation.
    pub of: &'static str,
    /// Where in the cycle.
    pub place: NamedPlace,
}

/// Where in the cycle.
#[derive(Debug, Clone, PartialEq)]
pub enum NamedPlace {
    /// The whole curve.
    Cycle,
    /// One number of the curve, by its word.
    Reduced(&'static str),
    /// An angle of this drive, rad.
    Pose(String, f64),
}

problems! {
    /// Why a name is that of no number or curve.
    #[derive(Debug, Clone, PartialEq)]
    pub enum NameProblem {
        Unknown { name: String, nearest: Option<String>, example: String } => Code::UnknownReference,
            says("outputs: no number or curve of this model is called '{name}'"),
            hint_of(Some(match nearest {
                Some(nearest) => format!("did you mean '{nearest}'?"),
                None => format!(
                    "a name is an output, which deviation of it, and what of its curve, for example '{example}'; \
                     or give a dict with the keys of a question"
                ),
            }));
    }
}

impl NamedQuestion {
    /// The question for what results call `name`: an output of the model (of a path with its component) and the word of a deviation;
    /// behind them nothing for the whole curve, the word of a reduction, or `at 1.5 rad`.
    ///
    /// # Errors
    /// Nothing has this name.
    pub fn of_name(model: &StudyModel, name: &str) -> Result<Self, NameProblem> {
        let (curve, place) = place_of(model, name);
        let outputs = model.outputs();
        let found = curve.rsplit_once(' ').and_then(|(output, word)| {
            let output = outputs.iter().find(|known| known.name == output)?;
            let of = DEVIATIONS.iter().find(|(known, _)| *known == word)?.0;
            Some(Self {
                output: model.output_names().get(output.output).map_or(String::new(), |name| (*name).to_owned()),
                component: output.component,
                of,
                place,
            })
        });
        found.ok_or_else(|| {
            let curves = outputs.iter().flat_map(|output| DEVIATIONS.map(|(of, _)| format!("{} {of}", output.name)));
            let names: Vec<String> = curves
                .flat_map(|curve| {
                    let reduced = REDUCTIONS.map(|(word, _)| format!("{curve} {word}"));
                    std::iter::once(curve).chain(reduced)
                })
                .collect();
            let nearest = nearest_name(name, names.iter().map(String::as_str)).map(str::to_owned);
            let output = outputs.first().map_or("slider", |output| &output.name);
            let example = format!("{output} value maximum");
            NameProblem::Unknown { name: name.to_owned(), nearest, example }
        })
    }
}

/// The name of the curve, and which part of it is meant.
fn place_of<'n>(model: &StudyModel, name: &'n str) -> (&'n str, NamedPlace) {
    if let Some((curve, angle_rad)) = name.strip_suffix(" rad").and_then(|rest| rest.rsplit_once(" at "))
        && let Ok(angle_rad) = angle_rad.parse::<f64>()
    {
        let drive = model.cycle_input(&model.quantities().nominal()).name;
        return (curve, NamedPlace::Pose(drive, angle_rad));
    }
    let reduced = name.rsplit_once(' ').and_then(|(curve, word)| {
        Some((curve, NamedPlace::Reduced(REDUCTIONS.iter().find(|(known, _)| *known == word)?.0)))
    });
    reduced.unwrap_or((name, NamedPlace::Cycle))
}

#[cfg(test)]
mod tests {
    use super::{NamedPlace, NamedQuestion};
    use crate::runs::design_runs::DesignRuns;
    use crate::written::texts::study_with;

    #[test]
    fn identity_names_of_results_lead_back_to_their_questions() {
        let study = study_with("cases/four_bar_coupler_path/study.toml", &[]);
        let model = study.model.clone();
        let runs = DesignRuns::new(study).unwrap_or_else(|refused| panic!("{}", refused.0));
        let recorded = runs.recorded();
        assert!(recorded.len() > 2, "{recorded:?}");
        for name in recorded.into_iter().map(|output| output.name) {
            let question = NamedQuestion::of_name(&model, &name).unwrap_or_else(|error| panic!("{error}"));
            let component = question.component.map_or(String::new(), |component| format!(" {component}"));
            let place = match question.place {
                NamedPlace::Cycle => String::new(),
                NamedPlace::Reduced(word) => format!(" {word}"),
                NamedPlace::Pose(_, angle_rad) => format!(" at {angle_rad} rad"),
            };
            assert_eq!(format!("{}{component} {}{place}", question.output, question.of), name);
        }
    }

    #[test]
    fn a_name_with_a_wrong_letter_is_told_the_right_one() {
        let model = study_with("cases/slider_crank_worn_pin/study.toml", &[]).model;
        let refused = |name: &str| match NamedQuestion::of_name(&model, name) {
            Ok(question) => panic!("{question:?}"),
            Err(error) => (error.to_string(), loosepin_text::diagnostics::Problem::hint(&error)),
        };
        let says = |name: &str| format!("outputs: no number or curve of this model is called '{name}'");
        let meant = Some("did you mean 'slider total rms'?".to_owned());
        assert_eq!(refused("slider totl rms"), (says("slider totl rms"), meant));
        assert_eq!(refused("slider").0, says("slider"));
    }
}
