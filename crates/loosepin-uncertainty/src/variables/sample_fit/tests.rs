use super::{FittedFamily, SampleFit, SampleFitError};
use crate::RandomVariable;

/// In increasing order; `random_variable/peer_quantiles.py` fits the same.
const SAMPLE: [f64; 12] = [0.21, 0.26, 0.29, 0.30, 0.33, 0.34, 0.36, 0.38, 0.41, 0.47, 0.55, 0.72];

fn fit(family: FittedFamily) -> SampleFit {
    family.fit(&SAMPLE).unwrap()
}

#[test]
fn peer_scipy() {
    // Means, deviations and distances printed by `random_variable/peer_quantiles.py`, whose searches stop at 1e-8 of a parameter.
    const RELATIVE_TOLERANCE: f64 = 1e-6;
    for (family, mean, deviation, distance, anderson_darling) in [
        (FittedFamily::Normal, 0.385, 0.139_967_528_701_871, 0.180_914_880_228_291_55, 0.492_274_509_904_730_1),
        (
            FittedFamily::Lognormal,
            0.385_936_090_706_356_54,
            0.133_094_675_404_224_46,
            0.118_365_529_068_160_89,
            0.171_815_975_739_894_8,
        ),
        (
            FittedFamily::Weibull,
            0.384_820_874_868_621_54,
            0.141_284_589_218_972_86,
            0.172_578_215_599_693_55,
            0.462_700_260_611_372_37,
        ),
        (
            FittedFamily::Gamma,
            0.384_999_997_567_177_45,
            0.125_144_097_779_558_73,
            0.139_320_874_023_642_68,
            0.253_858_940_770_150_8,
        ),
        (
            FittedFamily::Gumbel,
            0.381_695_541_777_891_2,
            0.122_980_648_496_511_01,
            0.101_975_237_441_682_91,
            0.156_000_192_240_847_82,
        ),
        (FittedFamily::Exponential, 0.385, 0.385, 0.420_421_721_215_190_1, 2.644_374_821_643_771),
    ] {
        let found = fit(family);
        let variable = RandomVariable::try_new(found.distribution).unwrap();
        let goodness = found.goodness;
        for (found, expected) in [
            (variable.mean(), mean),
            (variable.standard_deviation(), deviation),
            (goodness.kolmogorov_smirnov, distance),
            (goodness.anderson_darling, anderson_darling),
        ] {
            assert!((found / expected - 1.0).abs() < RELATIVE_TOLERANCE, "{family:?}: {found} {expected}");
        }
    }
}

#[test]
fn identity_the_unit_of_the_sample_does_not_matter() {
    const RELATIVE_TOLERANCE: f64 = 1e-10; // round-off of the searches
    for (_, family) in FittedFamily::ALL {
        let in_metres: Vec<f64> = SAMPLE.iter().map(|value| value * 1e-3).collect();
        let [there, here] = [fit(family), family.fit(&in_metres).unwrap()].map(|fit| {
            let variable = RandomVariable::try_new(fit.distribution).unwrap();
            [variable.mean(), variable.standard_deviation(), fit.goodness.anderson_darling]
        });
        let scaled = [1e-3 * there[0], 1e-3 * there[1], there[2]];
        for (found, expected) in here.into_iter().zip(scaled) {
            assert!((found / expected - 1.0).abs() < RELATIVE_TOLERANCE, "{family:?}: {found} {expected}");
        }
    }
}

#[test]
fn only_a_poor_fit_is_rejected() {
    let rejected: Vec<Option<bool>> = FittedFamily::ALL.map(|(_, family)| fit(family).goodness.is_rejected).to_vec();
    assert_eq!(rejected, [Some(false), Some(false), Some(false), None, Some(false), Some(true)]);
}

#[test]
fn what_cannot_be_fitted_is_refused() {
    let refused = |family: FittedFamily, values: &[f64]| family.fit(values).unwrap_err();
    assert_eq!(refused(FittedFamily::Normal, &SAMPLE[..4]), SampleFitError::TooFew { count: 4 });
    assert_eq!(refused(FittedFamily::Normal, &[]), SampleFitError::TooFew { count: 0 });
    assert_eq!(refused(FittedFamily::Gumbel, &[0.3; 9]), SampleFitError::NoScatter);
    let mut turned: Vec<f64> = SAMPLE.iter().map(|value| value - 0.25).collect();
    turned.sort_by(f64::total_cmp);
    for family in [FittedFamily::Lognormal, FittedFamily::Weibull, FittedFamily::Gamma, FittedFamily::Exponential] {
        assert!(matches!(refused(family, &turned), SampleFitError::NotPositive { value } if value < 0.0), "{family:?}");
    }
    assert!(FittedFamily::Gumbel.fit(&turned).is_ok() && FittedFamily::Normal.fit(&turned).is_ok());
}
