//! Models of a target over the box.

use std::borrow::Cow;

use crate::estimators::index::index_of_either;
use crate::search::models::index_model::{IndexForecast, IndexModel};
use crate::search::models::local::{LocalFits, LocalSmoothers};
use crate::search::models::noise::Noise;
use crate::search::models::prediction::{Allowance, Prediction};
use crate::search::target::{Target, TargetKind};

/// Half of the distance of indices over which the slope of that of either of two events is taken.
const HALF_STEP: f64 = 1e-4;

/// Prediction of a target at a place.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Forecast {
    /// Prediction of the target.
    Plain(Prediction),
    /// Of an index.
    Index(IndexForecast),
    /// Predictions of the indices of two events.
    Either([IndexForecast; 2]),
}

impl Forecast {
    /// The target where its model is right.
    pub fn mean(self) -> f64 {
        self.moved(Allowance::NONE, 1.0)
    }

    /// Change of the target where its model, or that of each event, errs by one of its standard deviations.
    pub fn deviation(self) -> f64 {
        self.moved(Allowance::ONE, 1.0) - self.mean()
    }

    /// The target where its model, or that of each event, errs by `allowance` towards `sign`.
    pub fn moved(self, allowance: Allowance, sign: f64) -> f64 {
        match self {
            Self::Plain(prediction) => prediction.moved(allowance, sign),
            Self::Index(index) => index.moved(allowance, sign),
            Self::Either(sides) => {
                let [a, b] = sides.map(|side| side.moved(allowance, sign));
                index_of_either(a, b)
            }
        }
    }
}

/// The model of a target on the points at which it is defined.
pub(crate) enum TargetModel<'a> {
    /// Fits of the target itself.
    Plain(LocalFits<'a>),
    /// Of an index.
    Index(IndexModel<'a>),
    /// Models of the indices of two events.
    Either(Box<[IndexModel<'a>; 2]>),
}

impl<'a> TargetModel<'a> {
    /// The model of `target` on the points of `smoother`, those at which it is `defined`.
    pub fn new(smoother: &'a LocalSmoothers, target: &Target, defined: &[usize]) -> Self {
        let among = |values: &[f64]| -> Vec<f64> { defined.iter().map(|&point| values[point]).collect() };
        match &target.kind {
            TargetKind::Plain => Self::Plain(smoother.fit(&among(&target.values), &target.noise.at_points(defined))),
            TargetKind::Index => Self::Index(IndexModel::new(smoother, &among(&target.values))),
            TargetKind::Either([a, b]) => {
                Self::Either(Box::new([a, b].map(|own| IndexModel::new(smoother, &among(own)))))
            }
        }
    }

    /// The models of `targets`, all of them defined at the same points: [`LocalSmoothers::fit_all`].
    pub fn all<'t>(smoother: &'a LocalSmoothers, targets: &[&'t Target], defined: &[usize]) -> Vec<Self> {
        let plain = targets.iter().filter(|target| matches!(target.kind, TargetKind::Plain));
        let among = |target: &&'t Target| -> (Cow<'t, [f64]>, Cow<'t, Noise>) {
            // Nearly always a target is defined at every point.
            if defined.len() == target.values.len() {
                return (Cow::Borrowed(&target.values), Cow::Borrowed(&target.noise));
            }
            let values = defined.iter().map(|&point| target.values[point]).collect();
            (Cow::Owned(values), Cow::Owned(target.noise.at_points(defined)))
        };
        let seen: Vec<(Cow<'_, [f64]>, Cow<'_, Noise>)> = plain.map(among).collect();
        let seen: Vec<(&[f64], &Noise)> = seen.iter().map(|(values, noise)| (&**values, &**noise)).collect();
        let mut fits = smoother.fit_all(&seen).into_iter();
        let model = |target: &&Target| match target.kind {
            TargetKind::Plain => fits.next().map_or_else(|| Self::new(smoother, target, defined), Self::Plain),
            TargetKind::Index | TargetKind::Either(_) => Self::new(smoother, target, defined),
        };
        targets.iter().map(model).collect()
    }

    /// Prediction at `place`, with what an allowance asks for.
    pub fn at(&self, place: &[f64], allowance: Allowance) -> Forecast {
        match self {
            Self::Plain(fit) => Forecast::Plain(fit.at(place, allowance)),
            Self::Index(model) => Forecast::Index(model.at(place, allowance)),
            Self::Either(models) => Forecast::Either([0, 1].map(|side| models[side].at(place, allowance))),
        }
    }

    /// [`Self::at`] for each of `places`, computed side by side with the same bits.
    pub fn at_each(&self, places: &[Vec<f64>], allowance: Allowance) -> Vec<Forecast> {
        match self {
            Self::Plain(fit) => fit.at_each(places, allowance).into_iter().map(Forecast::Plain).collect(),
            Self::Index(model) => model.at_each(places, allowance).into_iter().map(Forecast::Index).collect(),
            Self::Either(models) => {
                let [a, b] = &**models;
                let sides = a.at_each(places, allowance).into_iter().zip(b.at_each(places, allowance));
                sides.map(|(a, b)| Forecast::Either([a, b])).collect()
            }
        }
    }

    /// The smooth part of the target at `place` where its model, or that of each event, errs by `allowance` towards `sign`, with how this
    /// changes along each axis.
    pub fn moved_and_slopes(&self, place: &[f64], allowance: Allowance, sign: f64) -> (f64, Vec<f64>) {
        match self {
            Self::Plain(fit) => fit.moved_and_slopes(place, allowance, sign),
            Self::Index(model) => model.moved_and_slopes(place, allowance, sign),
            Self::Either(models) => {
                let [(a, of_a), (b, of_b)] = [0, 1].map(|side| models[side].moved_and_slopes(place, allowance, sign));
                let along = |a: [f64; 2], b: [f64; 2]| {
                    (index_of_either(a[1], b[1]) - index_of_either(a[0], b[0])) / (2.0 * HALF_STEP)
                };
                let beside = |x: f64| [x - HALF_STEP, x + HALF_STEP];
                let (by_a, by_b) = (along(beside(a), [b; 2]), along([a; 2], beside(b)));
                let slopes = of_a.iter().zip(&of_b).map(|(of_a, of_b)| by_a * of_a + by_b * of_b);
                (index_of_either(a, b), slopes.collect())
            }
        }
    }

    /// Predictions, with what an allowance asks for, at every one of [`Self::places`].
    pub fn at_places(&self, allowance: Allowance) -> Box<dyn Iterator<Item = Forecast> + '_> {
        match self {
            Self::Plain(fit) => Box::new(fit.at_places(allowance).map(Forecast::Plain)),
            Self::Index(model) => Box::new(model.at_places(allowance).map(Forecast::Index)),
            Self::Either(models) => {
                let [a, b] = &**models;
                Box::new(a.at_places(allowance).zip(b.at_places(allowance)).map(|(a, b)| Forecast::Either([a, b])))
            }
        }
    }

    /// The candidates, then the points.
    pub fn places(&self) -> &[Vec<f64>] {
        match self {
            Self::Plain(fit) => fit.places(),
            Self::Index(model) => model.places(),
            Self::Either(models) => models[0].places(),
        }
    }

    /// The share of sampling noise in the variance between the points.
    pub fn noise_share(&self) -> f64 {
        match self {
            Self::Plain(fit) => fit.noise_share(),
            Self::Index(_) | Self::Either(_) => 1.0,
        }
    }

    /// Variance of the sampling noise that it sees between the points; 0 for indices.
    pub fn noise_variance(&self) -> f64 {
        match self {
            Self::Plain(fit) => fit.noise_variance(),
            Self::Index(_) | Self::Either(_) => 0.0,
        }
    }

    /// Whether the target is exact and without kinks, according to its values.
    pub fn is_smoothest(&self) -> bool {
        match self {
            Self::Plain(fit) => fit.is_smoothest(),
            Self::Index(model) => model.is_smoothest(),
            Self::Either(models) => models.iter().all(IndexModel::is_smoothest),
        }
    }

    /// Whether the target is taken for rough; indices are known exactly, and never are.
    pub fn is_rough(&self) -> bool {
        match self {
            Self::Plain(fit) => fit.is_rough(),
            Self::Index(_) | Self::Either(_) => false,
        }
    }

    /// Whether it smooths the values instead of interpolating them.
    pub fn is_regressing(&self) -> bool {
        match self {
            Self::Plain(fit) => fit.is_regressing(),
            Self::Index(_) | Self::Either(_) => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Allowance, Forecast, IndexForecast, Prediction};
    use crate::search::models::prediction::Roughness;

    /// An index whose z is `from`, and `to` where its model errs by one of its deviations.
    fn index(is_compressed: bool, [from, to]: [f64; 2]) -> IndexForecast {
        let of = |z: f64| if is_compressed { z.asinh() } else { z };
        let deviation = of(to) - of(from);
        let prediction = Prediction { mean: of(from), deviation, roughness: Roughness::default() };
        IndexForecast { prediction, is_compressed }
    }

    #[test]
    fn analytic_two_events_whose_models_err_join_as_their_probabilities_do() {
        // Φ(-1.1) + Φ(-0.7) = 0.135666 + 0.241964 = Φ(-0.311712); moved by a deviation, Φ(-0.5) + Φ(-0.3) = 0.690626 = Φ(0.497626).
        const TOLERANCE: f64 = 2e-6;
        let forecast = Forecast::Either([index(true, [-1.1, -0.5]), index(false, [-0.7, -0.3])]);
        assert!((forecast.mean() - (-0.311_712_f64).asinh()).abs() < TOLERANCE, "{}", forecast.mean().sinh());
        assert!(
            (forecast.moved(Allowance::ONE, 1.0) - 0.497_626_f64.asinh()).abs() < TOLERANCE,
            "{}",
            forecast.moved(Allowance::ONE, 1.0).sinh()
        );
    }

    #[test]
    fn identity_events_that_leave_no_room_for_the_rest_are_certain() {
        // Φ(1.3) + Φ(0.4) is more than 1: either happens, whatever the index of the more probable one.
        let certain = Forecast::Either([index(true, [1.3, 1.4]), index(false, [0.4, 0.5])]).mean();
        assert!(certain.sinh() > 39.0, "{certain}");
    }
}
