//! The inputs of a study, as Python lists them.

use loosepin::study::{self, EpistemicSubject};

/// Name, SI unit, whether it is random, what is known of it in words, least and greatest value, value in the model, and the words of its
/// values where these are laws.
pub type StudyInput = (String, String, bool, String, f64, f64, Option<f64>, Option<Vec<String>>);

/// The inputs of `study`: random ones, then unknown ones, each kind in file order.
pub fn of(study: &study::Study) -> Vec<StudyInput> {
    let nominal = study.model.quantities().nominal();
    let random = study.random.iter().map(|input| {
        let [lower, upper] = [0.0, 1.0].map(|probability| input.variable.quantile(probability));
        (true, lower, upper, input.quantity().map(|quantity| nominal[quantity]), None)
    });
    let unknown = study.epistemic.iter().map(|input| {
        let [lower, upper] = input.variable.ends();
        let laws = match &input.subject {
            EpistemicSubject::Law { laws, .. } => Some(laws.iter().map(|law| law.name().to_owned()).collect()),
            EpistemicSubject::Quantity(_) | EpistemicSubject::Parameter { .. } | EpistemicSubject::Play => None,
        };
        (false, lower, upper, input.quantity().map(|quantity| nominal[quantity]), laws)
    });
    let described = study::describe_inputs(study).into_iter();
    let of = |(input, (is_random, lower, upper, nominal, laws)): (loosepin::result::study::InputDescription, _)| {
        (input.path, input.unit.symbol().to_owned(), is_random, input.words, lower, upper, nominal, laws)
    };
    described.zip(random.chain(unknown)).map(of).collect()
}
