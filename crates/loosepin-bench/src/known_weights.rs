//! Probability boxes alone, whose runs at few distributions are weighted for all others: responses with jumps, with noise, with tails,
//! and supports that move, with statistics in closed form or by quadrature.

use loosepin::bounds::Statistic;
use loosepin::uncertainty::{
    Distribution, EpistemicParameter, EpistemicVariable, Interval, Members, Parameter, hash, normal_cdf,
};
use std::f64::consts::TAU;
use std::sync::Arc;

use super::known_bounds::{Function, KnownCase, extremes};

/// A number that the parameters determine.
type OfParameters = Box<dyn Fn(&[f64]) -> f64>;
/// P(Y <= y), of y and the parameters.
type DistributionFunction = Box<dyn Fn(f64, &[f64]) -> f64>;

/// What is known of the response for all values of the parameters.
struct Known {
    mean: OfParameters,
    variance: OfParameters,
    distribution: DistributionFunction,
}

/// A normal variable with mean and deviation in intervals; a fixed one.
const MEAN: (f64, f64) = (-0.2, 0.4);
const DEVIATION: (f64, f64) = (0.5, 0.9);
const FIXED: [f64; 2] = [0.1, 0.5];
const NORMAL: Distribution = Distribution::Normal { mean: 0.1, standard_deviation: 0.6 };
const BESIDE: Distribution = Distribution::Normal { mean: FIXED[0], standard_deviation: FIXED[1] };
/// Where and how far responses jump.
const JUMP: [f64; 2] = [0.6, 2.0];
/// Full width of the noise.
const NOISE: f64 = 0.6;

/// All of them.
pub fn weighted() -> Vec<KnownCase> {
    vec![jump(), jump_of_two(), product(), square(), noisy(), waves(), uniform(), triangular(), listed(), six()]
}

fn density(z: f64) -> f64 {
    libm::exp(-0.5 * z * z) / TAU.sqrt()
}

/// A number in [-1/2, 1/2) that nothing tells from the next one's.
fn noise(x: f64) -> f64 {
    (hash(x.to_bits(), 0x6e6f) >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
}

/// E f(Z) over the fixed variable: by the trapezoidal rule, since f may have kinks.
fn beside(f: impl Fn(f64) -> f64) -> f64 {
    const STEP: f64 = 0.02;
    (-400..=400).map(|k| STEP * f64::from(k)).map(|z| STEP * density(z) * f(FIXED[0] + FIXED[1] * z)).sum()
}

/// Mean of f over offsets that are spread as `of` is over a period.
fn spread(of: impl Fn(f64) -> f64, f: impl Fn(f64) -> f64) -> f64 {
    const STEPS: i32 = 128;
    (0..STEPS).map(|k| f(of((f64::from(k) + 0.5) / f64::from(STEPS)))).sum::<f64>() / f64::from(STEPS)
}

fn within(intervals: &[(f64, f64)]) -> Vec<EpistemicVariable> {
    let interval = |&(lower, upper): &(f64, f64)| match Interval::try_new(lower, upper) {
        Ok(interval) => interval.into(),
        Err(error) => panic!("[{lower}, {upper}]: {error}"),
    };
    intervals.iter().map(interval).collect()
}

/// A case with the extremes of what is known of it over `intervals`.
fn case(
    name: &str,
    (random, parameters): (Vec<Distribution>, &[(usize, Parameter)]),
    intervals: &[(f64, f64)],
    statistics: &[Statistic],
    known: Known,
    function: Function,
) -> KnownCase {
    let exact = |statistic: Statistic| match statistic {
        Statistic::Mean => extremes(&known.mean, intervals),
        Statistic::StandardDeviation => {
            let (least, most) = extremes(&known.variance, intervals);
            (least.sqrt(), most.sqrt())
        }
        Statistic::ProbabilityAbove(limit) => extremes(&|u: &[f64]| 1.0 - (known.distribution)(limit, u), intervals),
        Statistic::Quantile(probability) => {
            let quantile = |u: &[f64]| {
                let (mut low, mut high) = (-9.0, 16.0);
                for _ in 0..46 {
                    let middle = 0.5 * (low + high);
                    if (known.distribution)(middle, u) < probability { low = middle } else { high = middle }
                }
                high
            };
            extremes(&quantile, intervals)
        }
        other => panic!("no closed form of {other:?}"),
    };
    let parameter = |(epistemic, &(random, parameter)): (usize, &(usize, Parameter))| EpistemicParameter {
        random,
        parameter,
        epistemic,
    };
    KnownCase {
        name: format!("{name}, weighted"),
        random,
        epistemic: within(intervals),
        parameters: parameters.iter().enumerate().map(parameter).collect(),
        statistics: statistics.iter().map(|&statistic| (statistic, exact(statistic))).collect(),
        levels: Vec::new(),
        function,
        sampling: [64, 256],
        is_weighted: true,
    }
}

const OF_NORMAL: [(usize, Parameter); 2] = [(0, Parameter::Mean), (0, Parameter::StandardDeviation)];

/// Y = X, and 2 more above 0.6: the quantile at 0.9 jumps with the parameters.
fn jump() -> KnownCase {
    let [at, height] = JUMP;
    let share = move |u: &[f64]| normal_cdf((u[0] - at) / u[1]);
    let mean = move |u: &[f64]| u[0] + height * share(u);
    let known = Known {
        mean: Box::new(mean),
        variance: Box::new(move |u| {
            let above = u[0] * share(u) + u[1] * density((at - u[0]) / u[1]);
            let square = u[0] * u[0] + u[1] * u[1] + 2.0 * height * above + height * height * share(u);
            square - mean(u) * mean(u)
        }),
        distribution: Box::new(move |y, u| normal_cdf((y.min(at.max(y - height)) - u[0]) / u[1])),
    };
    let statistics = [
        Statistic::Mean,
        Statistic::StandardDeviation,
        Statistic::Quantile(0.9),
        Statistic::Quantile(0.99),
        Statistic::ProbabilityAbove(3.3),
        Statistic::ProbabilityAbove(4.4),
    ];
    let function = Arc::new(move |x: &[f64], _: &[f64]| x[0] + if x[0] > at { height } else { 0.0 });
    case("a jump", (vec![NORMAL], &OF_NORMAL), &[MEAN, DEVIATION], &statistics, known, function)
}

/// Y = X + Z, and 2 more where X + 0.7 Z is above 0.6.
fn jump_of_two() -> KnownCase {
    let [at, height] = JUMP;
    let edge = move |z: f64| at - 0.7 * z;
    let share = move |z: f64, u: &[f64]| normal_cdf((u[0] - edge(z)) / u[1]);
    let mean = move |u: &[f64]| u[0] + FIXED[0] + height * beside(|z| share(z, u));
    let known = Known {
        mean: Box::new(mean),
        variance: Box::new(move |u| {
            let square = |z: f64| {
                let above = u[0] * share(z, u) + u[1] * density((edge(z) - u[0]) / u[1]);
                let (shifted, more) =
                    (u[0] + z, 2.0 * height * (above + z * share(z, u)) + height * height * share(z, u));
                shifted * shifted + u[1] * u[1] + more
            };
            beside(square) - mean(u) * mean(u)
        }),
        distribution: Box::new(move |y, u| {
            beside(|z| normal_cdf(((y - z).min(edge(z).max(y - z - height)) - u[0]) / u[1]))
        }),
    };
    let statistics = [
        Statistic::Mean,
        Statistic::StandardDeviation,
        Statistic::Quantile(0.95),
        Statistic::ProbabilityAbove(3.6),
        Statistic::ProbabilityAbove(4.8),
    ];
    let function = Arc::new(move |x: &[f64], _: &[f64]| x[0] + x[1] + if x[0] > edge(x[1]) { height } else { 0.0 });
    case("a jump of two", (vec![NORMAL, BESIDE], &OF_NORMAL), &[MEAN, DEVIATION], &statistics, known, function)
}

/// Y = X Z, the mean of X known to an interval, and mean and deviation of Z.
fn product() -> KnownCase {
    let known = Known {
        mean: Box::new(|u| FIXED[0] * u[0]),
        variance: Box::new(|u| {
            let (square, fixed) = (u[0] * u[0] + u[1] * u[1], FIXED[0] * FIXED[0] + FIXED[1] * FIXED[1]);
            square * fixed - (FIXED[0] * u[0]).powi(2)
        }),
        distribution: Box::new(|y, u| {
            beside(|z| {
                let below = normal_cdf((y / z - u[0]) / u[1]);
                if z > 0.0 { below } else { 1.0 - below }
            })
        }),
    };
    let statistics = [
        Statistic::Mean,
        Statistic::StandardDeviation,
        Statistic::Quantile(0.95),
        Statistic::ProbabilityAbove(0.5),
        Statistic::ProbabilityAbove(1.1),
    ];
    let function = Arc::new(|x: &[f64], _: &[f64]| x[0] * x[1]);
    case("a product", (vec![NORMAL, BESIDE], &OF_NORMAL), &[MEAN, DEVIATION], &statistics, known, function)
}

/// Y = X² and noise: the mean is least inside the box, m² + s²; that of the variance 2 s⁴ + 4 m² s² too.
fn square() -> KnownCase {
    let within = |y: f64, u: &[f64]| {
        let root = y.max(0.0).sqrt();
        normal_cdf((root - u[0]) / u[1]) - normal_cdf((-root - u[0]) / u[1])
    };
    let known = Known {
        mean: Box::new(|u| u[0] * u[0] + u[1] * u[1]),
        variance: Box::new(|u| 2.0 * u[1].powi(4) + 4.0 * (u[0] * u[1]).powi(2) + NOISE * NOISE / 12.0),
        distribution: Box::new(move |y, u| spread(|s| NOISE * (s - 0.5), |offset| within(y - offset, u))),
    };
    let statistics = [
        Statistic::Mean,
        Statistic::StandardDeviation,
        Statistic::Quantile(0.9),
        Statistic::ProbabilityAbove(1.2),
        Statistic::ProbabilityAbove(3.5),
    ];
    let function = Arc::new(|x: &[f64], _: &[f64]| x[0] * x[0] + NOISE * noise(x[0]));
    case("a noisy square", (vec![NORMAL], &OF_NORMAL), &[MEAN, DEVIATION], &statistics, known, function)
}

const OF_A_SUM: [Statistic; 6] = [
    Statistic::Mean,
    Statistic::StandardDeviation,
    Statistic::Quantile(0.9),
    Statistic::Quantile(0.99),
    Statistic::ProbabilityAbove(1.2),
    Statistic::ProbabilityAbove(2.2),
];

/// A normal variable and offsets.
fn with_offsets(variance: f64, of: impl Fn(f64) -> f64 + 'static) -> Known {
    Known {
        mean: Box::new(|u| u[0]),
        variance: Box::new(move |u| u[1] * u[1] + variance),
        distribution: Box::new(move |y, u| spread(&of, |offset| normal_cdf((y - offset - u[0]) / u[1]))),
    }
}

/// Y = X and noise.
fn noisy() -> KnownCase {
    let known = with_offsets(NOISE * NOISE / 12.0, |s| NOISE * (s - 0.5));
    let function = Arc::new(|x: &[f64], _: &[f64]| x[0] + NOISE * noise(x[0]));
    case("noise", (vec![NORMAL], &OF_NORMAL), &[MEAN, DEVIATION], &OF_A_SUM, known, function)
}

/// Y = X + sin(40 Z)/2, many turns within the scatter.
fn waves() -> KnownCase {
    let known = with_offsets(0.125, |s| 0.5 * libm::sin(TAU * s));
    let function = Arc::new(|x: &[f64], _: &[f64]| x[0] + 0.5 * libm::sin(40.0 * x[1]));
    case("waves", (vec![NORMAL, BESIDE], &OF_NORMAL), &[MEAN, DEVIATION], &OF_A_SUM, known, function)
}

/// Y = X and noise, X uniform with both ends in intervals: the support moves.
fn uniform() -> KnownCase {
    let below = |y: f64, u: &[f64]| ((y - u[0]) / (u[1] - u[0])).clamp(0.0, 1.0);
    let known = Known {
        mean: Box::new(|u| 0.5 * (u[0] + u[1])),
        variance: Box::new(|u| ((u[1] - u[0]).powi(2) + NOISE * NOISE) / 12.0),
        distribution: Box::new(move |y, u| spread(|s| NOISE * (s - 0.5), |offset| below(y - offset, u))),
    };
    let statistics =
        [Statistic::Mean, Statistic::StandardDeviation, Statistic::Quantile(0.95), Statistic::ProbabilityAbove(1.1)];
    let function = Arc::new(|x: &[f64], _: &[f64]| x[0] + NOISE * noise(x[0]));
    let random = Distribution::Uniform { lower: 0.2, upper: 1.0 };
    let parameters = [(0, Parameter::Lower), (0, Parameter::Upper)];
    case("a support that moves", (vec![random], &parameters), &[(0.1, 0.4), (0.9, 1.4)], &statistics, known, function)
}

/// Y = X and noise, X triangular with mode and upper end in intervals.
fn triangular() -> KnownCase {
    const LOWER: f64 = -0.5;
    let below = |y: f64, u: &[f64]| {
        let (mode, upper) = (u[0], u[1]);
        if y <= LOWER {
            0.0
        } else if y <= mode {
            (y - LOWER).powi(2) / ((upper - LOWER) * (mode - LOWER))
        } else if y < upper {
            1.0 - (upper - y).powi(2) / ((upper - LOWER) * (upper - mode))
        } else {
            1.0
        }
    };
    let known = Known {
        mean: Box::new(|u| (LOWER + u[0] + u[1]) / 3.0),
        variance: Box::new(|u| {
            let squares = LOWER * LOWER + u[0] * u[0] + u[1] * u[1] - LOWER * (u[0] + u[1]) - u[0] * u[1];
            squares / 18.0 + NOISE * NOISE / 12.0
        }),
        distribution: Box::new(move |y, u| spread(|s| NOISE * (s - 0.5), |offset| below(y - offset, u))),
    };
    let statistics =
        [Statistic::Mean, Statistic::StandardDeviation, Statistic::Quantile(0.95), Statistic::ProbabilityAbove(0.9)];
    let function = Arc::new(|x: &[f64], _: &[f64]| x[0] + NOISE * noise(x[0]));
    let random = Distribution::Triangular { lower: LOWER, mode: 0.3, upper: 1.2 };
    let parameters = [(0, Parameter::Mode), (0, Parameter::Upper)];
    case("a triangle", (vec![random], &parameters), &[(0.1, 0.6), (0.9, 1.5)], &statistics, known, function)
}

/// Y = X and noise, the mean of X one of a list.
fn listed() -> KnownCase {
    let members = [-0.2, 0.15, 0.4];
    let of = noisy();
    let list = Members::try_new(members.to_vec()).unwrap_or_else(|error| panic!("{error}"));
    // The extremes are at the ends of the interval, which are members.
    KnownCase {
        name: "a list, weighted".into(),
        epistemic: vec![list.into(), of.epistemic[1].clone()],
        sampling: [66, 256],
        ..of
    }
}

/// Y = A + B + C and noise, each with mean and deviation in intervals: all statistics rise with both from corner to corner.
fn six() -> KnownCase {
    const MEANS: [f64; 2] = [0.1, 0.3];
    const DEVIATIONS: [f64; 2] = [0.3, 0.4];
    let known = with_offsets(NOISE * NOISE / 12.0, |s| NOISE * (s - 0.5));
    let corner = |end: usize| {
        [(3.0 * MEANS[end], 3.0 * MEANS[end]), (3.0_f64.sqrt() * DEVIATIONS[end], 3.0_f64.sqrt() * DEVIATIONS[end])]
    };
    let of_sum = [corner(0), corner(1)].map(|intervals| {
        let none = Arc::new(|_: &[f64], _: &[f64]| f64::NAN);
        let known = with_offsets(NOISE * NOISE / 12.0, |s| NOISE * (s - 0.5));
        case("", (vec![NORMAL], &OF_NORMAL), &intervals, &OF_A_SUM, known, none).statistics
    });
    let ends = of_sum[0].iter().zip(&of_sum[1]).map(|(low, high)| (low.0, (low.1.0, high.1.1)));
    let parameters: Vec<(usize, Parameter)> =
        (0..3).flat_map(|input| [(input, Parameter::Mean), (input, Parameter::StandardDeviation)]).collect();
    let boxes = [(MEANS[0], MEANS[1]), (DEVIATIONS[0], DEVIATIONS[1])].repeat(3);
    let function = Arc::new(|x: &[f64], _: &[f64]| x[0] + x[1] + x[2] + NOISE * noise(x[0] + x[1] + x[2]));
    let random = vec![Distribution::Normal { mean: 0.2, standard_deviation: 0.35 }; 3];
    KnownCase {
        statistics: ends.collect(),
        ..case("six parameters", (random, &parameters), &boxes, &[], known, function)
    }
}
