//! Posterior distributions of the crank from its stroke, 2 r: closed forms.

use super::motion::{ROD, of_crank, stroke};
use loosepin_identify::motion_record::{MarginalSummary, MotionPosterior, MotionSpecimen, PosteriorRefusal};
use loosepin_identify::{NO_CALLBACK, Options, identify};

fn with_posterior(tables: &str, options: &Options) -> MotionSpecimen {
    let study = of_crank(tables);
    let mut answer = identify(&study, options, NO_CALLBACK).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    answer.motion.remove(0)
}

fn options(confidence: f64) -> Options {
    Options { with_posterior: true, confidence, ..Options::default() }
}

/// Mean, standard deviation and ends of the credible interval, mm.
fn summary(specimen: &MotionSpecimen) -> [f64; 4] {
    let Some(MotionPosterior::Given(given)) = &specimen.posterior else { panic!("{:?}", specimen.posterior) };
    let shares: f64 = given.marginals[0].shares.iter().sum();
    assert!((shares - 1.0).abs() < 1e-12, "{shares}");
    let MarginalSummary { mean_si, standard_deviation_si, credible_si } =
        given.marginals[0].summary.expect("the crank is no list");
    [mean_si, standard_deviation_si, credible_si[0], credible_si[1]].map(|value_si| 1e3 * value_si)
}

#[test]
fn analytic_an_independent_error_makes_the_crank_normal() {
    // 2 r = 100.3 mm with a standard deviation of 0.3 mm: r is normal about 50.15 mm with 0.15 mm. 99 errors are drawn: their mean is off by
    // 0.1 standard deviations, their deviation by 7 %; three of each are allowed.
    let found = with_posterior(&format!("{ROD}{}", stroke("\"100.3 mm\"", "scatter = \"0.3 mm\"")), &options(0.98));
    let [mean, deviation, low, high] = summary(&found);
    assert!((mean - 50.15).abs() < 0.3 * 0.15, "{mean}");
    assert!((deviation / 0.15 - 1.0).abs() < 0.21, "{deviation}");
    // Of a normal distribution 98 % lie within 2.326 standard deviations of its mean, whatever the draws were.
    for (end, expected) in [(low, mean - 2.326 * deviation), (high, mean + 2.326 * deviation)] {
        assert!((end - expected).abs() < 0.05 * deviation, "{end} {expected}");
    }
}

#[test]
fn analytic_a_common_error_alone_makes_the_crank_uniform() {
    // The rod scatters, of which the stroke knows nothing: r is anywhere from 50.05 to 50.25 mm, with the same probability.
    let found = with_posterior(&format!("{ROD}{}", stroke("\"100.3 mm\"", "error = \"± 0.2 mm\"")), &options(0.9));
    let [mean, deviation, low, high] = summary(&found);
    // Cells beside the ends are 1/20 of the set.
    let cell = 0.2 / 20.0;
    assert!((mean - 50.15).abs() < cell, "{mean}");
    assert!((deviation - 0.2 / 12.0_f64.sqrt()).abs() < cell, "{deviation}");
    assert!((low - 50.06).abs() < cell && (high - 50.24).abs() < cell, "{low} {high}");
}

#[test]
fn a_distribution_is_given_only_where_it_is_asked_for_and_can_be() {
    let error = stroke("\"100.3 mm\"", "error = \"± 0.2 mm\"");
    assert_eq!(with_posterior(&error, &Options::default()).posterior, None);
    let refused = |tables: &str, confidence: f64| match with_posterior(tables, &options(confidence)).posterior {
        Some(MotionPosterior::Refused(refusal)) => refusal,
        other => panic!("{other:?}"),
    };
    assert_eq!(refused(&error, 0.99), PosteriorRefusal::NothingScatters);
    let far = format!("{ROD}{}", stroke("\"103 mm\"", "error = \"± 0.2 mm\""));
    assert_eq!(refused(&far, 0.8), PosteriorRefusal::Misfit);
    // One feature needs ten runs; a confidence of 0.8 makes nine.
    let scatter = format!("{ROD}{}", stroke("\"100.3 mm\"", "scatter = \"0.3 mm\""));
    assert_eq!(refused(&scatter, 0.8), PosteriorRefusal::FewRuns { runs: 9, least: 10 });
}
