//! Responses with known shape: the fitted surrogates, and their own error estimates.

use super::trials::{ishigami, ishigami_inputs, oscillator, oscillator_inputs, points};
use super::{Choice, Input, Kind, Options, Surrogate, SurrogateError, SurrogateVerdict, TrainingData, TrainingOutput};
use loosepin_uncertainty::{Distribution, Interval, RandomVariable, normal};

/// A normal, an interval and a lognormal input.
fn mixed_inputs() -> Vec<Input> {
    let random = |distribution| Input::Random(RandomVariable::try_new(distribution).unwrap());
    vec![
        random(Distribution::Normal { mean: 0.4, standard_deviation: 0.3 }),
        Input::Epistemic(Interval::try_new(0.2, 1.7).unwrap()),
        random(Distribution::Lognormal { mean: 2.3, standard_deviation: 0.4 }),
    ]
}

fn smooth(x: &[f64]) -> f64 {
    libm::sin(2.0 * x[0]) + x[1] * x[1] * libm::log(x[2]) + 0.3 * x[0] * x[1]
}

/// Standard normal numbers that belong to a run.
fn noise(run: usize) -> f64 {
    normal(20_261, run as u64)
}

fn fit_number(inputs: Vec<Input>, at: Vec<Vec<f64>>, values: Vec<Option<f64>>, choice: Choice) -> Surrogate {
    let data = TrainingData::try_new(inputs, at, vec![TrainingOutput::number("y", values)]).unwrap();
    Surrogate::fit(&data, &Options { choice, most_neurons: 6, ..Options::default() }).unwrap()
}

/// Q² of the first output at points that were not learned from.
fn q2(surrogate: &Surrogate, at: &[Vec<f64>], truth: impl Fn(&[f64]) -> Vec<f64>) -> f64 {
    let truth: Vec<Vec<f64>> = at.iter().map(|x| truth(x)).collect();
    let (mut square, mut total) = (0.0, 0.0);
    for t in 0..truth[0].len() {
        let mean = truth.iter().map(|y| y[t]).sum::<f64>() / truth.len() as f64;
        total += truth.iter().map(|y| (y[t] - mean) * (y[t] - mean)).sum::<f64>();
    }
    for (x, y) in at.iter().zip(&truth) {
        let values = surrogate.predict(x).unwrap().remove(0).values;
        square += values.iter().zip(y).map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
    }
    1.0 - square / total
}

/// Points over the inner 96 % of the inputs, where every surrogate of 40 runs and more answers.
fn inner_points(inputs: &[Input], count: usize) -> Vec<Vec<f64>> {
    let sobol = loosepin_uncertainty::ScrambledSobol::try_new(99, inputs.len()).unwrap();
    (0..count as u32)
        .map(|i| {
            let share = |k| 0.02 + 0.96 * sobol.point(0, i, k);
            let value = |(k, input): (usize, &Input)| match input {
                Input::Random(variable) => variable.quantile(share(k)),
                Input::Epistemic(interval) => interval.at(share(k)),
            };
            inputs.iter().enumerate().map(value).collect()
        })
        .collect()
}

/// Q² of one kind on a smooth response of mixed inputs.
fn q2_of_kind(kind: Kind) -> f64 {
    let at = points(&mixed_inputs(), 11, 0, 50);
    let values = at.iter().map(|x| Some(smooth(x))).collect();
    let surrogate = fit_number(mixed_inputs(), at, values, Choice::Only(kind));
    q2(&surrogate, &inner_points(&mixed_inputs(), 200), |x| vec![smooth(x)])
}

const MIN_Q2_OF_KIND: f64 = 0.99; // an rms error of a tenth of the standard deviation; measured 0.998 and better

#[test]
fn analytic_chaos_and_kriging_learn_a_smooth_response_of_mixed_inputs() {
    for kind in [Kind::Chaos, Kind::Kriging] {
        let found = q2_of_kind(kind);
        assert!(found > MIN_Q2_OF_KIND, "{kind:?}: {found}");
    }
}

#[test]
fn analytic_a_network_learns_a_smooth_response_of_mixed_inputs() {
    let found = q2_of_kind(Kind::Network);
    assert!(found > MIN_Q2_OF_KIND, "{found}");
}

#[test]
fn analytic_ishigami_is_found_by_its_polynomials() {
    const MIN_Q2: f64 = 0.98;
    let at = points(&ishigami_inputs(), 7, 0, 100);
    let values = at.iter().map(|x| Some(ishigami(x))).collect();
    let surrogate = fit_number(ishigami_inputs(), at, values, Choice::Only(Kind::Chaos));
    let found = q2(&surrogate, &points(&ishigami_inputs(), 8, 0, 300), |x| vec![ishigami(x)]);
    assert!(found > MIN_Q2, "{found}");
    assert!(surrogate.outputs()[0].quality.q2.unwrap() > MIN_Q2);
}

#[test]
fn analytic_a_curve_of_twenty_inputs_is_learned_and_its_error_known_along_it() {
    const MIN_Q2: f64 = 0.85;
    const Q2_TOLERANCE: f64 = 0.1; // held-out from 50 runs against 200 fresh points
    let at = points(&oscillator_inputs(), 7, 0, 50);
    let rows = at.iter().map(|x| Some(oscillator(x))).collect();
    let data = TrainingData::try_new(oscillator_inputs(), at, vec![TrainingOutput::curve("y", rows)]).unwrap();
    let options = Options { choice: Choice::Only(Kind::Kriging), most_modes: 4, ..Options::default() };
    let surrogate = Surrogate::fit(&data, &options).unwrap();
    let found = q2(&surrogate, &points(&oscillator_inputs(), 8, 0, 200), oscillator);
    let quality = &surrogate.outputs()[0].quality;
    assert!(found > MIN_Q2, "{found}");
    assert!((found - quality.q2.unwrap()).abs() < Q2_TOLERANCE, "{found}, held out {:?}", quality.q2);
    assert_eq!(quality.rms_along.len(), super::trials::TIMES);
    // The error grows with time: the phase of the swing is what is uncertain.
    let mean =
        |range: core::ops::Range<usize>| quality.rms_along[range.clone()].iter().sum::<f64>() / range.len() as f64;
    assert!(mean(150..200) > 1.2 * mean(0..50));
}

#[test]
fn analytic_white_noise_is_recognised_and_kept() {
    const TOLERANCE: f64 = 0.25; // of the deviation: 80 numbers fix it to 8 %
    let at = points(&mixed_inputs(), 11, 0, 80);
    let values = (0..80).map(|run| Some(3.0 + 0.4 * noise(run))).collect();
    let surrogate = fit_number(mixed_inputs(), at.clone(), values, Choice::Auto);
    let output = &surrogate.outputs()[0];
    assert_eq!((output.residual.verdict, output.kinds()), (SurrogateVerdict::Nothing, vec![Kind::Constant]));
    let errors: Vec<f64> =
        (0..80).map(|i| surrogate.residual(0, &at[7], f64::from(i) / 80.0).unwrap().unwrap()[0]).collect();
    let square = errors.iter().map(|e| e * e).sum::<f64>() / 80.0;
    assert!((square.sqrt() / 0.4 - 1.0).abs() < TOLERANCE, "{}", square.sqrt());
}

#[test]
fn analytic_a_curve_of_white_noise_is_recognised_and_its_places_stay_together() {
    const PLACES: usize = 7;
    let at = points(&mixed_inputs(), 11, 0, 80);
    // The same number at every place, with a factor: what is drawn must be such a curve again.
    let row = |run: usize| (1..=PLACES).map(|place| 3.0 + 0.4 * place as f64 * noise(run)).collect();
    let output = TrainingOutput::curve("y", (0..80).map(|run| Some(row(run))).collect());
    let data = TrainingData::try_new(mixed_inputs(), at.clone(), vec![output]).unwrap();
    let surrogate = Surrogate::fit(&data, &Options { most_neurons: 6, ..Options::default() }).unwrap();
    let output = &surrogate.outputs()[0];
    assert_eq!(output.residual.verdict, SurrogateVerdict::Nothing);
    const TOLERANCE: f64 = 1e-9; // round-off of one mode
    let drawn = surrogate.residual(0, &at[7], 0.37).unwrap().unwrap();
    for (place, value) in drawn.iter().enumerate() {
        assert!((value - (place + 1) as f64 * drawn[0]).abs() < TOLERANCE, "{drawn:?}");
    }
}

#[test]
fn analytic_a_step_along_a_curve_is_kept_as_scatter() {
    let inputs = || mixed_inputs()[..2].to_vec();
    let at = points(&inputs(), 11, 0, 100);
    let row =
        |x: &Vec<f64>| (0..5).map(|place| if x[1] > 0.83 { 2.7 } else { 0.3 } + 0.1 * place as f64 * x[0]).collect();
    let output = TrainingOutput::curve("y", at.iter().map(|x| Some(row(x))).collect());
    let data = TrainingData::try_new(inputs(), at.clone(), vec![output]).unwrap();
    let options = Options { choice: Choice::Only(Kind::Kriging), ..Options::default() };
    let verdict = Surrogate::fit(&data, &options).unwrap().outputs()[0].residual.verdict;
    assert!(verdict.keeps_residual(), "{verdict:?}");
}

#[test]
fn analytic_noise_on_a_smooth_response_is_a_floor_of_its_size() {
    const TOLERANCE: f64 = 0.3; // of the deviation: 120 numbers, and what the surrogate does not know yet
    let at = points(&mixed_inputs(), 11, 0, 120);
    let values = at.iter().enumerate().map(|(run, x)| Some(smooth(x) + 0.3 * noise(run))).collect();
    let surrogate = fit_number(mixed_inputs(), at.clone(), values, Choice::Only(Kind::Kriging));
    let output = &surrogate.outputs()[0];
    assert_eq!(output.residual.verdict, SurrogateVerdict::Floor);
    assert!((output.quality.rms / 0.3 - 1.0).abs() < TOLERANCE, "{}", output.quality.rms);
    let deviation = surrogate.predict(&at[3]).unwrap()[0].deviations[0];
    assert!((deviation / 0.3 - 1.0).abs() < 2.0 * TOLERANCE, "{deviation}");
}

#[test]
fn analytic_noise_that_grows_along_an_input_has_a_scale_that_grows() {
    const TOLERANCE: f64 = 0.35; // of the slope: 150 logarithms of errors with a deviation of 1.1 each, floored
    let at = points(&mixed_inputs(), 11, 0, 150);
    let scaled = |x: &[f64]| mixed_inputs()[1].scaled(x[1]);
    let values =
        at.iter().enumerate().map(|(run, x)| Some(smooth(x) + 0.3 * libm::exp(0.6 * scaled(x)) * noise(run))).collect();
    let surrogate = fit_number(mixed_inputs(), at.clone(), values, Choice::Only(Kind::Kriging));
    let residual = &surrogate.outputs()[0].residual;
    assert!(residual.verdict.keeps_residual(), "{:?} {:?}", residual.verdict, residual.learning);
    assert!((residual.scale[1] / 0.6 - 1.0).abs() < TOLERANCE, "{:?}", residual.scale);
}

#[test]
fn analytic_a_step_is_recognised() {
    let inputs = || mixed_inputs()[..2].to_vec();
    let at = points(&inputs(), 11, 0, 100);
    let values = at.iter().map(|x| Some(if x[1] > 0.83 { 2.7 } else { 0.3 } + 0.1 * x[0])).collect();
    let surrogate = fit_number(inputs(), at, values, Choice::Only(Kind::Kriging));
    assert_eq!(surrogate.outputs()[0].residual.verdict, SurrogateVerdict::Jump);
}

#[test]
fn analytic_a_smooth_response_is_no_noise() {
    let at = points(&mixed_inputs(), 11, 0, 60);
    for kind in [Kind::Chaos, Kind::Kriging] {
        let values = at.iter().map(|x| Some(smooth(x))).collect();
        let surrogate = fit_number(mixed_inputs(), at.clone(), values, Choice::Only(kind));
        let residual = &surrogate.outputs()[0].residual;
        assert!(
            matches!(residual.verdict, SurrogateVerdict::Falling | SurrogateVerdict::Resolved),
            "{kind:?}: {residual:?}"
        );
    }
}

#[test]
fn analytic_a_constant_output_is_constant() {
    let at = points(&mixed_inputs(), 11, 0, 9);
    let surrogate = fit_number(mixed_inputs(), at.clone(), vec![Some(0.1); 9], Choice::Auto);
    let output = &surrogate.outputs()[0];
    let prediction = surrogate.predict(&at[4]).unwrap().remove(0);
    assert_eq!((prediction.values[0], prediction.deviations[0]), (0.1, 0.0));
    assert_eq!(
        (output.residual.verdict, output.quality.q2, output.quality.rms),
        (SurrogateVerdict::Constant, None, 0.0)
    );
}

#[test]
fn analytic_one_input_is_enough() {
    const TOLERANCE: f64 = 0.01; // of an amplitude of one, from 20 points over half a period and more
    let inputs = vec![Input::Epistemic(Interval::try_new(0.3, 4.1).unwrap())];
    let at = points(&inputs, 11, 0, 20);
    let values = at.iter().map(|x| Some(libm::sin(x[0]))).collect();
    let surrogate = fit_number(inputs, at, values, Choice::Auto);
    for x in [0.4, 1.7, 3.3] {
        let prediction = surrogate.predict(&[x]).unwrap().remove(0);
        assert!((prediction.values[0] - libm::sin(x)).abs() < TOLERANCE, "{x}");
    }
}

#[test]
fn too_few_different_points_are_refused() {
    let at = vec![vec![0.4, 0.5, 2.2]];
    let error =
        TrainingData::try_new(mixed_inputs(), at, vec![TrainingOutput::number("stroke", [Some(0.7)])]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "output 'stroke': 1 different points among 1 runs, 0 of which failed; a surrogate needs at least 4\n\
         hint: make more runs, or give the bounds directly"
    );
    let same = vec![vec![0.4, 0.5, 2.2]; 9];
    let error = TrainingData::try_new(mixed_inputs(), same, vec![TrainingOutput::number("stroke", vec![Some(0.7); 9])])
        .unwrap_err();
    assert!(matches!(error, SurrogateError::TooFewRuns { different: 1, runs: 9, .. }));
}

#[test]
fn numbers_that_are_none_are_refused_at_their_place() {
    let at = points(&mixed_inputs(), 11, 0, 6);
    let mut values = vec![Some(0.7); 6];
    values[4] = Some(f64::NAN);
    let error =
        TrainingData::try_new(mixed_inputs(), at.clone(), vec![TrainingOutput::number("stroke", values)]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "output 'stroke', run 4: NaN; must be finite\nhint: leave out the output of a run that failed"
    );
    let mut outside = at;
    outside[2][1] = 1.9;
    let outputs = vec![TrainingOutput::number("stroke", vec![Some(0.7); 6])];
    let error = TrainingData::try_new(mixed_inputs(), outside, outputs).unwrap_err();
    assert_eq!(error.to_string(), "run 2: input 1 is 1.9; it must lie between 0.2 and 1.7");
}

#[test]
fn identity_duplicates_are_held_out_together() {
    // Each point twice, with different noise: the held-out error must be the error of a fresh point, not of a twin.
    let once = points(&mixed_inputs(), 11, 0, 30);
    let at: Vec<Vec<f64>> = once.iter().chain(&once).cloned().collect();
    let values: Vec<Option<f64>> = (0..60).map(|run| Some(noise(run % 30) + 0.01 * noise(run))).collect();
    for kind in [Kind::Kriging, Kind::Chaos] {
        let surrogate = fit_number(mixed_inputs(), at.clone(), values.clone(), Choice::Only(kind));
        assert!(surrogate.outputs()[0].quality.rms > 0.7, "{kind:?}: {}", surrogate.outputs()[0].quality.rms);
        assert!(surrogate.predict(&at[0]).unwrap()[0].values[0].is_finite());
    }
}

#[test]
fn analytic_missing_outputs_are_left_out_and_counted() {
    const MIN_Q2: f64 = 0.98;
    let at = points(&mixed_inputs(), 11, 0, 60);
    let values = at.iter().enumerate().map(|(run, x)| (run % 9 != 4).then(|| smooth(x))).collect();
    let surrogate = fit_number(mixed_inputs(), at, values, Choice::Only(Kind::Kriging));
    let quality = &surrogate.outputs()[0].quality;
    assert_eq!((quality.runs, quality.missing), (53, 7));
    assert!(q2(&surrogate, &inner_points(&mixed_inputs(), 200), |x| vec![smooth(x)]) > MIN_Q2);
}

#[test]
fn a_surrogate_does_not_extrapolate() {
    let at = points(&mixed_inputs(), 11, 0, 20);
    let values = at.iter().map(|x| Some(smooth(x))).collect();
    let surrogate = fit_number(mixed_inputs(), at.clone(), values, Choice::Only(Kind::Chaos));
    let mut far = at[3].clone();
    far[0] = 4.5;
    let (lower, upper) = surrogate.ranges()[0];
    assert_eq!(
        surrogate.predict(&far).unwrap_err(),
        SurrogateError::Extrapolation { input: 0, value: 4.5, lower, upper }
    );
    assert!(lower < 0.0 && upper > 0.8 && upper < 2.0, "{lower} {upper}");
    // An interval ends where it ends.
    assert!(surrogate.ranges()[1].0 >= 0.2 && surrogate.ranges()[1].1 <= 1.7);
    assert_eq!(surrogate.predict(&far[..2]).unwrap_err(), SurrogateError::QueryLength { length: 2, inputs: 3 });
}

#[test]
fn identity_a_saved_surrogate_gives_the_same_bits_again() {
    let at = points(&mixed_inputs(), 11, 0, 30);
    for kind in Kind::ALL {
        let values = at.iter().map(|x| Some(smooth(x))).collect();
        let surrogate = fit_number(mixed_inputs(), at.clone(), values, Choice::Only(kind));
        let text = surrogate.to_json().unwrap();
        let loaded = Surrogate::from_json(&text).unwrap();
        for x in inner_points(&mixed_inputs(), 20) {
            assert_eq!(surrogate.predict(&x), loaded.predict(&x), "{kind:?}");
            assert_eq!(surrogate.residual(0, &x, 0.37), loaded.residual(0, &x, 0.37));
        }
        assert_eq!(loaded.outputs()[0].quality, surrogate.outputs()[0].quality);
        assert_eq!(loaded.to_json().unwrap(), text);
    }
}

#[test]
fn text_that_is_no_surrogate_is_refused() {
    let error = Surrogate::from_json("{}").err().unwrap();
    assert_eq!(error.to_string(), "no saved surrogate: missing field `format` at line 1 column 2");
    let error = Surrogate::from_json("{\"format\": 7}").err().unwrap();
    assert_eq!(error.to_string(), "a saved surrogate of format 7; this program reads format 1");
}

#[test]
fn identity_the_same_bits_for_any_number_of_threads() {
    let at = points(&mixed_inputs(), 11, 0, 25);
    let values: Vec<Option<f64>> = at.iter().map(|x| Some(smooth(x))).collect();
    let texts: Vec<String> = [1, 3]
        .into_iter()
        .map(|threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| fit_number(mixed_inputs(), at.clone(), values.clone(), Choice::Auto).to_json().unwrap())
        })
        .collect();
    assert_eq!(texts[0], texts[1]);
}

#[test]
fn analytic_known_noise_is_not_taken_for_the_response() {
    // Half of the runs carry noise three times as large as the response; told so, the process trusts the others.
    let at = points(&mixed_inputs(), 11, 0, 60);
    let deviation = |run: usize| if run.is_multiple_of(2) { 3.0 } else { 1e-3 };
    let values: Vec<f64> = at.iter().enumerate().map(|(run, x)| smooth(x) + deviation(run) * noise(run)).collect();
    let test = inner_points(&mixed_inputs(), 200);
    let fitted = |output: TrainingOutput| {
        let data = TrainingData::try_new(mixed_inputs(), at.clone(), vec![output]).unwrap();
        let options = Options { choice: Choice::Only(Kind::Kriging), ..Options::default() };
        q2(&Surrogate::fit(&data, &options).unwrap(), &test, |x| vec![smooth(x)])
    };
    let plain = TrainingOutput::number("y", values.iter().map(|y| Some(*y)));
    let variances = (0..60).map(|run| deviation(run) * deviation(run)).collect();
    let (blind, told) = (fitted(plain.clone()), fitted(plain.with_noise(variances)));
    assert!(told > 0.95 && blind < 0.8, "{blind} {told}");
}
