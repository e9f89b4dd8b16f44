//! A quantity whose extremes are sought, and what models say of it.

use super::search::{Direction, extreme};
use super::smooth::index_of_either;
use super::smoother::Fit;

/// A quantity known at every point, whose extremes are sought.
#[derive(Debug, Clone)]
pub(super) struct Target {
    /// Value at every point; not a number where it is undefined.
    pub values: Vec<f64>,
    /// The values of which those of the target are made; nothing where it is modelled as it is.
    pub sides: Option<Sides>,
    /// Mean sampling variance of the values.
    pub noise_variance: f64,
    /// Gains below these are not worth a point: of the minimum, of the maximum.
    pub resolutions: [f64; 2],
}

/// The indices of two events that exclude each other, at every point, where the target is that of either: it has a kink or a
/// ridge where one takes over from the other, which each of them alone has not.
#[derive(Debug, Clone)]
pub(super) struct Sides(pub [Vec<f64>; 2]);

impl Target {
    /// Greatest less least value.
    pub fn range(&self) -> f64 {
        let range = extreme(&self.values, Direction::Maximum) - extreme(&self.values, Direction::Minimum);
        range.max(0.0)
    }
}

/// What a model says of a target at a place.
#[derive(Debug, Clone, Copy)]
pub(super) enum Forecast {
    /// Mean and standard deviation of the target.
    Alone(f64, f64),
    /// Those of its two sides.
    OfSides([(f64, f64); 2]),
}

impl Forecast {
    /// The target where its model is right.
    pub fn mean(self) -> f64 {
        self.moved(0.0)
    }

    /// By how much it moves where its model, or that of each side, errs by one of its standard deviations.
    pub fn deviation(self) -> f64 {
        match self {
            Self::Alone(_, deviation) => deviation,
            Self::OfSides(_) => self.moved(1.0) - self.mean(),
        }
    }

    /// The target where its model, or that of each side, errs by so many of its standard deviations.
    pub fn moved(self, deviations: f64) -> f64 {
        match self {
            Self::Alone(mean, deviation) => mean + deviations * deviation,
            Self::OfSides(sides) => {
                let [a, b] = sides.map(|(mean, deviation)| mean + deviations * deviation);
                index_of_either(a, b)
            }
        }
    }
}

/// The model of a target on the points at which it is defined.
pub(super) enum TargetModel<'a> {
    /// Of the target itself.
    Alone(Fit<'a>),
    /// Of its two sides.
    OfSides([Fit<'a>; 2]),
}

impl TargetModel<'_> {
    /// What it says at `place`.
    pub fn at(&self, place: &[f64]) -> Forecast {
        match self {
            Self::Alone(fit) => {
                let (mean, deviation) = fit.at(place);
                Forecast::Alone(mean, deviation)
            }
            Self::OfSides(fits) => Forecast::OfSides([fits[0].at(place), fits[1].at(place)]),
        }
    }

    /// What it says at every one of [`Self::places`].
    pub fn at_places(&self) -> Box<dyn Iterator<Item = Forecast> + '_> {
        match self {
            Self::Alone(fit) => Box::new(fit.at_places().map(|(mean, deviation)| Forecast::Alone(mean, deviation))),
            Self::OfSides([a, b]) => Box::new(a.at_places().zip(b.at_places()).map(|(a, b)| Forecast::OfSides([a, b]))),
        }
    }

    /// The candidates, then the points.
    pub fn places(&self) -> &[Vec<f64>] {
        let (Self::Alone(fit) | Self::OfSides([fit, _])) = self;
        fit.places()
    }

    /// What it takes of the differences between the points for noise, as a variance; of sides, which have none, 0.
    pub fn noise_variance(&self) -> f64 {
        match self {
            Self::Alone(fit) => fit.noise_variance(),
            Self::OfSides(_) => 0.0,
        }
    }

    /// Whether it passes beside the values rather than through them.
    pub fn is_smoothed(&self) -> bool {
        self.noise_variance() > 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::Forecast;

    #[test]
    fn analytic_two_sides_that_err_join_as_their_probabilities_do() {
        // Φ(-1.1) + Φ(-0.7) = 0.135666 + 0.241964 = Φ(-0.311766); moved by two deviations, Φ(-0.5) + Φ(-0.3) = 0.690626 = Φ(0.497626).
        const TOLERANCE: f64 = 2e-6;
        let compressed = |z: f64| z.asinh();
        let deviation = |from: f64, to: f64| 0.5 * (compressed(to) - compressed(from));
        let sides = [(-1.1, -0.5), (-0.7, -0.3)].map(|(from, to)| (compressed(from), deviation(from, to)));
        let forecast = Forecast::OfSides(sides);
        assert!((forecast.mean() - compressed(-0.311_712)).abs() < TOLERANCE, "{}", forecast.mean().sinh());
        assert!((forecast.moved(2.0) - compressed(0.497_626)).abs() < TOLERANCE, "{}", forecast.moved(2.0).sinh());
    }

    #[test]
    fn identity_sides_that_leave_no_room_for_the_rest_are_certain() {
        // Φ(1.3) + Φ(0.4) is more than 1: either happens, whatever the index of the more probable one.
        let certain = Forecast::OfSides([(1.3_f64.asinh(), 0.0), (0.4_f64.asinh(), 0.0)]).mean();
        assert!(certain.sinh() > 39.0, "{certain}");
    }
}
