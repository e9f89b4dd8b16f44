//! Every pairing of a random input, a probability box, an interval, evidence and a fuzzy number, with bounds in closed form.
//!
//! ```text
//! Y = A + h(B),   h(b) = b where B is random or a probability box, (b - 0.15)² where it is not
//! ```
//!
//! Given one focal element or cut of each input, Y is normal with mean t and deviation s, each in an interval, or a number t: means and
//! probabilities have their extremes at ends of these intervals, masses add, quantiles invert the added distribution functions.

use loosepin::bounds::Statistic;
use loosepin::uncertainty::{
    Distribution, EpistemicParameter, EpistemicVariable, Evidence, FocalElement, FuzzyNumber, Parameter, USUAL_CUTS,
    normal_cdf,
};
use std::sync::Arc;

use super::known_case::{DEFAULT_MAX_EXCESS, KnownCase, interval};

/// A range: both ends.
type Range = (f64, f64);

const NORMAL: [f64; 2] = [0.3, 0.8];
const BOX_MEAN: Range = (-0.2, 0.4);
const BOX_DEVIATION: Range = (0.5, 0.9);
const INTERVAL: Range = (-0.7, 1.1);
const ELEMENTS: [(f64, f64, f64); 3] = [(-1.0, -0.2, 0.3), (-0.5, 0.6, 0.5), (0.2, 1.3, 0.2)];
const CORNERS: [f64; 4] = [-0.6, 0.1, 0.25, 0.9];
const LIMIT: f64 = 0.85;
const PROBABILITY: f64 = 0.9;
/// Value at which the square of an epistemic input vanishes.
const VERTEX: f64 = 0.15;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Random,
    ProbabilityBox,
    Interval,
    Evidence,
    Fuzzy,
}

/// What one focal element or cut leaves open: its mass, the mean and deviation of the normal part, the rest.
#[derive(Debug, Clone, Copy)]
struct Open {
    mass: f64,
    mean: Range,
    variance: Range,
}

impl Kind {
    const ALL: [Self; 5] = [Self::Random, Self::ProbabilityBox, Self::Interval, Self::Evidence, Self::Fuzzy];

    fn word(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::ProbabilityBox => "p-box",
            Self::Interval => "interval",
            Self::Evidence => "evidence",
            Self::Fuzzy => "fuzzy",
        }
    }

    fn is_epistemic(self) -> bool {
        matches!(self, Self::Interval | Self::Evidence | Self::Fuzzy)
    }

    /// What is open at degree `alpha`, for the square where `is_squared`.
    fn open(self, alpha: f64, is_squared: bool) -> Vec<Open> {
        let number = |mass: f64, (low, high): Range| {
            let square = |value: f64| (value - VERTEX) * (value - VERTEX);
            let least = if low <= VERTEX && VERTEX <= high { 0.0 } else { square(low).min(square(high)) };
            let mean = if is_squared { (least, square(low).max(square(high))) } else { (low, high) };
            Open { mass, mean, variance: (0.0, 0.0) }
        };
        match self {
            Self::Random => {
                let variance = NORMAL[1] * NORMAL[1];
                vec![Open { mass: 1.0, mean: (NORMAL[0], NORMAL[0]), variance: (variance, variance) }]
            }
            Self::ProbabilityBox => {
                let (low, high) = BOX_DEVIATION;
                vec![Open { mass: 1.0, mean: BOX_MEAN, variance: (low * low, high * high) }]
            }
            Self::Interval => vec![number(1.0, INTERVAL)],
            Self::Evidence => ELEMENTS.iter().map(|&(low, high, mass)| number(mass, (low, high))).collect(),
            Self::Fuzzy => {
                let [a, b, c, d] = CORNERS;
                vec![number(1.0, (a + alpha * (b - a), d - alpha * (d - c)))]
            }
        }
    }
}

/// All pairings, each once.
pub fn pairings() -> Vec<KnownCase> {
    let kinds = Kind::ALL.iter().enumerate();
    kinds.flat_map(|(first, &a)| Kind::ALL[first..].iter().map(move |&b| pairing(a, b))).collect()
}

fn pairing(a: Kind, b: Kind) -> KnownCase {
    let mut random = Vec::new();
    let mut epistemic: Vec<EpistemicVariable> = Vec::new();
    let mut parameters = Vec::new();
    // Where A and B stand among the random or the epistemic inputs.
    let mut places = Vec::new();
    for kind in [a, b] {
        places.push(if kind.is_epistemic() { epistemic.len() } else { random.len() });
        match kind {
            Kind::Random => random.push(Distribution::Normal { mean: NORMAL[0], standard_deviation: NORMAL[1] }),
            Kind::ProbabilityBox => {
                for (parameter, range) in [(Parameter::Mean, BOX_MEAN), (Parameter::StandardDeviation, BOX_DEVIATION)] {
                    parameters.push(EpistemicParameter { random: random.len(), parameter, epistemic: epistemic.len() });
                    epistemic.push(interval(range).into());
                }
                random.push(Distribution::Normal { mean: BOX_MEAN.0, standard_deviation: BOX_DEVIATION.0 });
            }
            Kind::Interval => epistemic.push(interval(INTERVAL).into()),
            Kind::Evidence => {
                let element = |(lower, upper, mass)| FocalElement { interval: interval((lower, upper)), mass };
                let evidence = Evidence::try_new(ELEMENTS.map(element).to_vec());
                epistemic.push(evidence.unwrap_or_else(|error| panic!("evidence: {error}")).into());
            }
            Kind::Fuzzy => {
                let fuzzy = FuzzyNumber::trapezoidal(CORNERS, &USUAL_CUTS);
                epistemic.push(fuzzy.unwrap_or_else(|error| panic!("fuzzy number: {error}")).into());
            }
        }
    }
    let is_one = [a, b].iter().all(|kind| *kind != Kind::Evidence);
    let is_random = !(a.is_epistemic() && b.is_epistemic());
    let mut statistics = vec![Statistic::Mean, Statistic::ProbabilityAbove(LIMIT), Statistic::Quantile(PROBABILITY)];
    if is_one && is_random {
        statistics.push(Statistic::StandardDeviation);
    }
    let bounds = |alpha: f64| -> Vec<(f64, f64)> {
        let open = combined(&a.open(alpha, false), &b.open(alpha, b.is_epistemic()));
        statistics.iter().map(|statistic| exact(&open, *statistic)).collect()
    };
    let has_levels = [a, b].contains(&Kind::Fuzzy);
    let levels = if has_levels { USUAL_CUTS.map(bounds).to_vec() } else { Vec::new() };
    let value =
        move |kind: Kind, place: usize, x: &[f64], u: &[f64]| if kind.is_epistemic() { u[place] } else { x[place] };
    let function = move |x: &[f64], u: &[f64]| {
        let (first, second) = (value(a, places[0], x, u), value(b, places[1], x, u));
        first + if b.is_epistemic() { (second - VERTEX) * (second - VERTEX) } else { second }
    };
    KnownCase {
        name: format!("{} and {}", a.word(), b.word()),
        random,
        epistemic,
        parameters,
        statistics: statistics.iter().copied().zip(bounds(0.0)).collect(),
        levels,
        function: Arc::new(function),
        sampling: [128, 128],
        compared_columns: Vec::new(),
        max_excess: DEFAULT_MAX_EXCESS,
    }
}

/// Every combination of what both leave open.
fn combined(a: &[Open], b: &[Open]) -> Vec<Open> {
    let both = |x: &Open, y: &Open| Open {
        mass: x.mass * y.mass,
        mean: (x.mean.0 + y.mean.0, x.mean.1 + y.mean.1),
        variance: (x.variance.0 + y.variance.0, x.variance.1 + y.variance.1),
    };
    a.iter().flat_map(|x| b.iter().map(move |y| both(x, y))).collect()
}

/// Bounds of one statistic.
fn exact(open: &[Open], statistic: Statistic) -> (f64, f64) {
    // P(Y <= y) of an element whose mean is t.
    let cdf = |y: f64, t: f64, variance: f64| match variance > 0.0 {
        true => normal_cdf((y - t) / variance.sqrt()),
        false if t <= y => 1.0,
        false => 0.0,
    };
    let least = |y: f64| -> f64 {
        let of = |e: &Open| e.mass * cdf(y, e.mean.1, e.variance.0).min(cdf(y, e.mean.1, e.variance.1));
        open.iter().map(of).sum()
    };
    let most = |y: f64| -> f64 {
        let of = |e: &Open| e.mass * cdf(y, e.mean.0, e.variance.0).max(cdf(y, e.mean.0, e.variance.1));
        open.iter().map(of).sum()
    };
    let quantile = |p: f64, cdf: &dyn Fn(f64) -> f64| {
        let (mut low, mut high) = (-20.0, 20.0);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            // Masses are added with round-off.
            if cdf(middle) < p - 1e-12 { low = middle } else { high = middle }
        }
        high
    };
    match statistic {
        Statistic::Mean => {
            open.iter().fold((0.0, 0.0), |(low, high), e| (low + e.mass * e.mean.0, high + e.mass * e.mean.1))
        }
        Statistic::StandardDeviation => (open[0].variance.0.sqrt(), open[0].variance.1.sqrt()),
        Statistic::ProbabilityAbove(limit) => (1.0 - most(limit), 1.0 - least(limit)),
        Statistic::Quantile(p) => (quantile(p, &most), quantile(p, &least)),
        other => panic!("no closed form of {other:?}"),
    }
}
