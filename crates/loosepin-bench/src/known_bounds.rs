//! Responses whose bounds are known: closed forms, or quadrature and a search that share nothing with [`loosepin::bounds`].

use loosepin::bounds::Statistic;
use loosepin::uncertainty::{Distribution, EpistemicVariable, normal_cdf};
use std::f64::consts::{E, FRAC_PI_3, PI, TAU};
use std::sync::Arc;

use super::known_case::{DEFAULT_MAX_EXCESS, KnownCase, interval};
use super::known_pairings::pairings;

/// Between two points on either side of a jump the search concedes all of it; the median of a thousand seeds is 1.3.
const EXCESS_AT_A_JUMP: f64 = 2.0;

/// All cases.
pub fn all() -> Vec<KnownCase> {
    let slider_crank = || slider_crank_with_play(FRAC_PI_3);
    let own = [sum(), product(), power(), challenge(), inside_four(), ridge(), jump()];
    let own = own.into_iter().chain([slider_crank(), slider_crank().without_periodic_inputs()]);
    own.chain(pairings()).collect()
}

/// Y = X + u.
fn sum() -> KnownCase {
    let quantile = 1.959_963_984_540_054;
    let beyond = |u: f64| normal_cdf(-2.0 - u) + normal_cdf(u - 2.0);
    KnownCase::new(
        "X + u",
        &[(-1.0, 1.0)],
        vec![
            (Statistic::Mean, (-1.0, 1.0)),
            (Statistic::StandardDeviation, (1.0, 1.0)),
            (Statistic::Quantile(0.975), (quantile - 1.0, quantile + 1.0)),
            (Statistic::ProbabilityAbove(2.0), (normal_cdf(-3.0), normal_cdf(-1.0))),
            (Statistic::ProbabilityBeyond(2.0), (beyond(0.0), beyond(1.0))),
        ],
        |x, u| x[0] + u[0],
    )
}

/// Y = u X: the least deviation lies inside, off the centre.
fn product() -> KnownCase {
    KnownCase::new(
        "u X",
        &[(-0.37, 1.0)],
        vec![
            (Statistic::Mean, (0.0, 0.0)),
            (Statistic::StandardDeviation, (0.0, 1.0)),
            (Statistic::Quantile(0.975), (0.0, 1.959_963_984_540_054)),
            (Statistic::ProbabilityAbove(1.0), (0.0, normal_cdf(-1.0))),
        ],
        |x, u| u[0] * x[0],
    )
}

/// Y = (a + b)^a with two intervals (Oberkampf and others 2004, first problem): \[e^(-1/e), 2\].
fn power() -> KnownCase {
    KnownCase {
        random: Vec::new(),
        ..KnownCase::new(
            "(a + b)^a, two intervals",
            &[(0.1, 1.0), (0.0, 1.0)],
            vec![(Statistic::Mean, (libm::exp(-1.0 / E), 2.0))],
            |_, u| libm::pow(u[0] + u[1], u[0]),
        )
    }
}

/// Y = (a + b)^a, a in an interval, ln b normal with mean and deviation in intervals (their problem of a probability box).
fn challenge() -> KnownCase {
    const LIMIT: f64 = 2.5;
    let intervals = vec![(0.1, 1.0), (0.0, 1.0), (0.1, 0.5)];
    // Y rises with b: every quantile is the value at that quantile of b, every probability one of b.
    let quantile = |u: &[f64]| libm::pow(u[0] + libm::exp(u[1] + u[2] * 1.644_853_626_951_472_6), u[0]);
    let above = |u: &[f64]| normal_cdf((u[1] - libm::log(libm::pow(LIMIT, 1.0 / u[0]) - u[0])) / u[2]);
    let mean = |u: &[f64]| expectation(|z| libm::pow(u[0] + libm::exp(u[1] + u[2] * z), u[0]));
    let variance = |u: &[f64]| {
        let mean = mean(u);
        expectation(|z| (libm::pow(u[0] + libm::exp(u[1] + u[2] * z), u[0]) - mean).powi(2))
    };
    let deviations = extremes(&variance, &intervals);
    KnownCase {
        sampling: [96, 256],
        ..KnownCase::new(
            "(a + b)^a, b a probability box",
            &intervals,
            vec![
                (Statistic::Mean, extremes(&mean, &intervals)),
                (Statistic::StandardDeviation, (deviations.0.sqrt(), deviations.1.sqrt())),
                (Statistic::Quantile(0.95), extremes(&quantile, &intervals)),
                (Statistic::ProbabilityAbove(LIMIT), extremes(&above, &intervals)),
            ],
            |x, u| libm::pow(u[0] + libm::exp(u[1] + u[2] * x[0]), u[0]),
        )
    }
}

/// A hill inside four intervals: mean exp(-2 |u - m|²).
fn inside_four() -> KnownCase {
    const TOP: [f64; 4] = [0.31, 0.62, 0.45, 0.58];
    let furthest: f64 = TOP.iter().map(|m: &f64| m.max(1.0 - m).powi(2)).sum();
    KnownCase {
        sampling: [96, 256],
        ..KnownCase::new(
            "a hill inside four intervals",
            &[(0.0, 1.0); 4],
            vec![(Statistic::Mean, (libm::exp(-2.0 * furthest), 1.0)), (Statistic::StandardDeviation, (0.1, 0.1))],
            |x, u| {
                let square: f64 = u.iter().zip(TOP).map(|(u, m)| (u - m) * (u - m)).sum();
                0.1 * x[0] + libm::exp(-2.0 * square)
            },
        )
    }
}

/// Along a curved ridge: minus a hundredth of Rosenbrock's valley on \[-2, 2\]², greatest at (1, 1), least at (-2, -2).
fn ridge() -> KnownCase {
    KnownCase {
        sampling: [96, 256],
        ..KnownCase::new("a curved ridge", &[(-2.0, 2.0); 2], vec![(Statistic::Mean, (-36.09, 0.0))], |x, u| {
            let across = u[1] - u[0] * u[0];
            0.1 * x[0] - (across * across + 0.01 * (1.0 - u[0]) * (1.0 - u[0]))
        })
    }
}

/// Y = X + 2 where u1 + u2 > 1.2, else X.
fn jump() -> KnownCase {
    KnownCase {
        max_excess: EXCESS_AT_A_JUMP,
        ..KnownCase::new(
            "a jump",
            &[(0.0, 1.0); 2],
            vec![
                (Statistic::Mean, (0.0, 2.0)),
                (Statistic::ProbabilityAbove(1.0), (normal_cdf(-1.0), normal_cdf(1.0))),
            ],
            |x, u| x[0] + if u[0] + u[1] > 1.2 { 2.0 } else { 0.0 },
        )
    }
}

const CRANK_MM: [f64; 2] = [50.0, 0.02];
const ROD_MM: [f64; 2] = [120.0, 0.03];
const CLEARANCE_MM: (f64, f64) = (0.1, 0.5);

/// The slider-crank with play at a crank angle: lengths r and l normal, the clearance in an interval, its
/// direction anywhere in the turn.
///
/// The crank angle is an interval of no width, so that one function serves all poses.
pub fn slider_crank_with_play(crank_angle_rad: f64) -> KnownCase {
    let (sine, cosine) = (libm::sin(crank_angle_rad), libm::cos(crank_angle_rad));
    let nominal_mm = CRANK_MM[0] * cosine + (ROD_MM[0].powi(2) - (CRANK_MM[0] * sine).powi(2)).sqrt();
    let height = move |crank: f64, u: &[f64]| crank * sine + u[0] * libm::sin(u[1]);
    let length = move |z: f64, of: [f64; 2]| of[0] + of[1] * z;
    let value = move |z: f64, w: f64, u: &[f64]| {
        let (crank, rod) = (length(z, CRANK_MM), length(w, ROD_MM));
        crank * cosine + (rod * rod - height(crank, u).powi(2)).sqrt() + u[0] * libm::cos(u[1]) - nominal_mm
    };
    let mean = move |u: &[f64]| expectation(|z| expectation(|w| value(z, w, u)));
    let variance = move |u: &[f64]| {
        let mean = mean(u);
        expectation(|z| expectation(|w| (value(z, w, u) - mean).powi(2)))
    };
    // Y rises with the rod: at a given crank it is above y where the rod is longer than this.
    let above = move |y: f64, u: &[f64]| {
        expectation(|z| {
            let crank = length(z, CRANK_MM);
            let foot = y + nominal_mm - crank * cosine - u[0] * libm::cos(u[1]);
            let rod = (foot * foot + height(crank, u).powi(2)).sqrt();
            normal_cdf((ROD_MM[0] - rod) / ROD_MM[1])
        })
    };
    let quantile = move |p: f64, u: &[f64]| {
        let (mut low, mut high) = (mean(u) - 1.0, mean(u) + 1.0);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if 1.0 - above(middle, u) < p { low = middle } else { high = middle }
        }
        0.5 * (low + high)
    };
    let beyond = move |limit: f64, u: &[f64]| above(limit, u) + 1.0 - above(-limit, u);
    // The search of the exact extremes does not know that the direction goes round. They lie near 0, ±π/2 and π, so it is given a
    // little more than a turn, with ends away from these.
    let intervals = [CLEARANCE_MM, (-0.7 * PI, 1.8 * PI)];
    let deviations = extremes(&variance, &intervals);
    KnownCase {
        name: format!("slider-crank with play, {:.0}°", crank_angle_rad.to_degrees()),
        random: [CRANK_MM, ROD_MM]
            .map(|[mean, standard_deviation]| Distribution::Normal { mean, standard_deviation })
            .to_vec(),
        statistics: vec![
            (Statistic::Mean, extremes(&mean, &intervals)),
            (Statistic::StandardDeviation, (deviations.0.sqrt(), deviations.1.sqrt())),
            (Statistic::Quantile(0.025), extremes(&|u: &[f64]| quantile(0.025, u), &intervals)),
            (Statistic::Quantile(0.975), extremes(&|u: &[f64]| quantile(0.975, u), &intervals)),
            (Statistic::ProbabilityBeyond(0.45), extremes(&|u: &[f64]| beyond(0.45, u), &intervals)),
            (Statistic::ProbabilityBeyond(0.60), extremes(&|u: &[f64]| beyond(0.60, u), &intervals)),
        ],
        epistemic: vec![
            interval(CLEARANCE_MM).into(),
            EpistemicVariable::Periodic(interval((0.0, TAU))),
            interval((crank_angle_rad, crank_angle_rad)).into(),
        ],
        function: Arc::new(|x, u| {
            let (sine, cosine) = (libm::sin(u[2]), libm::cos(u[2]));
            let height = x[0] * sine + u[0] * libm::sin(u[1]);
            let nominal = CRANK_MM[0] * cosine + (ROD_MM[0].powi(2) - (CRANK_MM[0] * sine).powi(2)).sqrt();
            x[0] * cosine + (x[1] * x[1] - height * height).sqrt() + u[0] * libm::cos(u[1]) - nominal
        }),
        parameters: Vec::new(),
        levels: Vec::new(),
        sampling: [110, 128],
        compared_columns: Vec::new(),
        max_excess: DEFAULT_MAX_EXCESS,
    }
}

/// E f(Z) of a standard normal Z by the trapezoidal rule, whose error for smooth f is e^(-2π²/h²).
fn expectation(f: impl Fn(f64) -> f64) -> f64 {
    const STEP: f64 = 0.25;
    const STEPS: i32 = 34;
    (-STEPS..=STEPS)
        .map(|k| {
            let z = STEP * f64::from(k);
            STEP / TAU.sqrt() * libm::exp(-0.5 * z * z) * f(z)
        })
        .sum()
}

/// Number of places of the grid, no two of them near each other, from which an extreme is sought: two hills may be nearly as high.
const STARTS: usize = 2;
/// Places that are nearer than this share of the box are near each other.
const NEAR: f64 = 0.15;

/// The least and the greatest value of `f` over a box of up to three intervals: a grid, then around its best places grids, each
/// half as large as the one before.
pub(crate) fn extremes(f: &dyn Fn(&[f64]) -> f64, intervals: &[(f64, f64)]) -> (f64, f64) {
    let per_axis = if intervals.len() > 2 { 21 } else { 37 };
    // Places around a centre, a share of the box wide.
    let grid = |centre: &[f64], share: f64, points: usize| -> Vec<Vec<f64>> {
        let place = |index: usize| {
            let along = |(axis, (&(low, high), centre)): (usize, (&(f64, f64), &f64))| {
                let step = index / usize::pow(points, axis as u32) % points;
                let fraction = step as f64 / (points - 1) as f64 - 0.5;
                (centre + share * fraction * (high - low)).clamp(low, high)
            };
            intervals.iter().zip(centre).enumerate().map(along).collect()
        };
        (0..usize::pow(points, intervals.len() as u32)).map(place).collect()
    };
    let are_near = |a: &[f64], b: &[f64]| {
        a.iter().zip(b).zip(intervals).all(|((a, b), (low, high))| (a - b).abs() <= NEAR * (high - low))
    };
    let search = |sign: f64| {
        let best = |places: Vec<Vec<f64>>| {
            let mut valued: Vec<(f64, Vec<f64>)> = places.into_iter().map(|place| (sign * f(&place), place)).collect();
            valued.sort_by(|a, b| b.0.total_cmp(&a.0));
            valued
        };
        let middle: Vec<f64> = intervals.iter().map(|(low, high)| 0.5 * (low + high)).collect();
        let mut starts: Vec<(f64, Vec<f64>)> = Vec::new();
        for start in best(grid(&middle, 1.0, per_axis)) {
            if starts.len() < STARTS && starts.iter().all(|other| !are_near(&other.1, &start.1)) {
                starts.push(start);
            }
        }
        let refined = starts.into_iter().map(|(mut most, mut centre)| {
            let mut share = 4.0 / per_axis as f64;
            for _ in 0..31 {
                let (value, place) = best(grid(&centre, share, 5)).swap_remove(0);
                if value > most {
                    (most, centre) = (value, place);
                }
                share *= 0.5;
            }
            most
        });
        sign * refined.fold(f64::NEG_INFINITY, f64::max)
    };
    (search(-1.0), search(1.0))
}
