//! Bounds of curves that are drawn afresh from a seed, against the exact ones: `just campaign curve-bounds PROBLEMS SEED [SAMPLING_SEEDS [KIND]]`.
//!
//! Three curves of 180 poses, of which four statistics each are asked, 2,160 in all. With θ the pose, u in the unit square, X and N standard normal,
//! N another number for each run and pose,
//!
//! ```text
//! Y = a(θ, u) + b(θ, u) X + c(θ) N,    a: three waves in θ whose phases depend on u;  or with a kink whose place depends on θ
//!                                      b: a wave;   c: 0, or growing with θ
//! ```
//!
//! so that mean a, deviation s = √(b² + c²) and quantiles a + z s are known at every u, and their extremes are sought on a fine grid, from
//! the best place of which on by ever smaller steps. Steep waves turn twice as far over the square. Where four numbers are unknown each wave
//! depends on one of them alone, so that its ends add up. Kinks come alone and together with the scatter c N.
//!
//! An end is what is stated at one pose. A curve is whole where no pose of the end of a statistic is missed. Where two numbers are unknown
//! the distribution function of Y at the first pose of each curve is asked for as well: it is whole where at none of its values an end
//! is missed, that is where min and max over u of Φ((y - a)/s) lie within the bounds.

use loosepin_bounds::{Failure, Problem, Request, Response, Sampling, Statistic, evaluate};
use loosepin_uncertainty::{Distribution, Interval, RandomVariable, hash, normal, normal_cdf, normal_quantile};
use rayon::prelude::*;
use std::f64::consts::TAU;

const CURVES: usize = 3;
const POSES: usize = 180;
const WAVES: usize = 3;
/// A wave for each, and the scatter.
const MAX_UNKNOWN: usize = WAVES + 1;
const INNER: usize = 64;
/// Probabilities of both quantiles.
const PROBABILITIES: [f64; 2] = [0.025, 0.975];
/// Places of the grid along each axis.
const GRID: usize = 81;
/// A miss is more than this share of the true width of its bounds and of the largest deviation together.
const ROUND_OFF: f64 = 1e-6;

/// What is drawn for one curve.
struct Curve {
    waves: [Wave; WAVES],
    scatter: Wave,
    /// Deviation of the scatter that no model foresees, at the end of the turn.
    unforeseen: f64,
    kink: Option<Wave>,
}

/// amplitude sin(order θ + phase + slopes · u)
struct Wave {
    amplitude: f64,
    order: f64,
    phase: f64,
    slopes: [f64; MAX_UNKNOWN],
}

impl Wave {
    fn at(&self, angle: f64, u: &[f64]) -> f64 {
        let phase = self.slopes.iter().zip(u).fold(self.phase, |phase, (slope, x)| phase + slope * x);
        self.amplitude * (self.order * angle + phase).sin()
    }

    /// The ends of a wave that depends on one unknown number alone.
    fn ends(&self, angle: f64) -> [f64; 2] {
        let from = self.order * angle + self.phase;
        let to = from + self.slopes.iter().sum::<f64>();
        let (from, to) = (from.min(to), from.max(to));
        // Whether a phase of 2πk + `summit` lies between them.
        let holds = |summit: f64| ((to - summit) / TAU).floor() >= ((from - summit) / TAU).ceil();
        let (low, high) = (from.sin().min(to.sin()), from.sin().max(to.sin()));
        let ends = [if holds(-0.25 * TAU) { -1.0 } else { low }, if holds(0.25 * TAU) { 1.0 } else { high }];
        let ends = ends.map(|end| self.amplitude * end);
        [ends[0].min(ends[1]), ends[0].max(ends[1])]
    }
}

impl Curve {
    fn draw(seed: u64, kind: Kind) -> Self {
        let uniform = |place: u64| (hash(seed, place) >> 11) as f64 / (1_u64 << 53) as f64;
        let wave = |place: u64, amplitude: f64, order: f64| {
            let slope = |axis: u64| kind.steepness() * (uniform(place + 2 + axis) - 0.5);
            // Waves stand at 0, 10, 20 and 100.
            let own = (place / 10).min(3) as usize;
            let mut slopes = [0.0; MAX_UNKNOWN];
            match kind {
                Kind::Four => slopes[own] = slope(0),
                _ => slopes[..2].copy_from_slice(&[slope(0), slope(1)]),
            }
            Wave { amplitude: amplitude * (0.5 + uniform(place)), order, phase: TAU * uniform(place + 1), slopes }
        };
        Self {
            waves: [0, 1, 2].map(|k| wave(10 * k, 1.0 / (k + 1) as f64, (k + 1) as f64)),
            scatter: wave(100, 0.05, 1.0),
            unforeseen: if matches!(kind, Kind::Impacts | Kind::KinksAndImpacts) {
                0.3 * (0.5 + uniform(200))
            } else {
                0.0
            },
            kink: matches!(kind, Kind::Kinks | Kind::KinksAndImpacts).then(|| wave(110, 0.5, 1.0)),
        }
    }

    /// The least and the greatest of each statistic.
    fn ends(&self, angle: f64, kind: Kind) -> [[f64; 2]; 4] {
        if kind == Kind::Four { self.added_ends(angle) } else { self.exact(angle) }
    }

    /// The same where each wave depends on one unknown number alone.
    fn added_ends(&self, angle: f64) -> [[f64; 2]; 4] {
        let own: Vec<[f64; 2]> = self.waves.iter().map(|wave| wave.ends(angle)).collect();
        let mean = [0, 1].map(|end| own.iter().map(|ends| ends[end]).sum::<f64>());
        let deviation = self.scatter.ends(angle).map(|end| 0.1 + end);
        let quantile = |probability: f64| {
            let z = normal_quantile(probability);
            let moved = [0, 1].map(|end| z * deviation[end]);
            [mean[0] + moved[0].min(moved[1]), mean[1] + moved[0].max(moved[1])]
        };
        let [low, high] = PROBABILITIES.map(quantile);
        [mean, deviation, low, high]
    }

    /// a, b and c.
    fn at(&self, angle: f64, u: &[f64]) -> [f64; 3] {
        let kink = self.kink.as_ref().map_or(0.0, |kink| kink.at(angle, u).abs());
        let mean = self.waves.iter().map(|wave| wave.at(angle, u)).sum::<f64>() + kink;
        // Never without scatter.
        [mean, 0.1 + self.scatter.at(angle, u), self.unforeseen * angle / TAU]
    }

    /// Mean, deviation and both quantiles.
    fn statistics(&self, angle: f64, u: &[f64]) -> [f64; 4] {
        let [mean, scatter, unforeseen] = self.at(angle, u);
        let deviation = scatter.hypot(unforeseen);
        let [low, high] = PROBABILITIES.map(|probability| mean + normal_quantile(probability) * deviation);
        [mean, deviation, low, high]
    }

    /// The extremes of each statistic over the unit square.
    fn exact(&self, angle: f64) -> [[f64; 2]; 4] {
        extremes(|u| self.statistics(angle, u))
    }

    /// The extremes of P(Y <= y) over the unit square.
    fn exact_share(&self, angle: f64, y: f64) -> [f64; 2] {
        let share = |u: &[f64]| {
            let [mean, scatter, unforeseen] = self.at(angle, u);
            [normal_cdf((y - mean) / scatter.hypot(unforeseen))]
        };
        extremes(share)[0]
    }
}

/// The least and the greatest of each of `of` over the unit square: from the best places of a grid on by ever smaller steps.
fn extremes<const N: usize>(of: impl Fn(&[f64]) -> [f64; N]) -> [[f64; 2]; N] {
    let step = 1.0 / (GRID - 1) as f64;
    let mut best = [[(f64::INFINITY, [0.0; 2]); 2]; N];
    for place in 0..GRID * GRID {
        let u = [step * (place % GRID) as f64, step * (place / GRID) as f64];
        for (own, value) in best.iter_mut().zip(of(&u)) {
            for (end, sign) in own.iter_mut().zip([1.0, -1.0]) {
                if sign * value < end.0 {
                    *end = (sign * value, u);
                }
            }
        }
    }
    std::array::from_fn(|index| {
        let [low, high] = [0, 1].map(|end| (best[index][end], [1.0, -1.0][end]));
        [low, high].map(|((least, u), sign)| sign * descend(|u| sign * of(u)[index], least, u, step))
    })
}

/// The least of `of` from `u` on, where it is `least`.
fn descend(of: impl Fn(&[f64]) -> f64, mut least: f64, mut u: [f64; 2], mut step: f64) -> f64 {
    while step > 1e-7 {
        let ways = [
            [step, 0.0],
            [-step, 0.0],
            [0.0, step],
            [0.0, -step],
            [step, step],
            [step, -step],
            [-step, step],
            [-step, -step],
        ];
        let trials = ways.map(|way| [0, 1].map(|axis| (u[axis] + way[axis]).clamp(0.0, 1.0)));
        let better = trials.into_iter().map(|trial| (of(&trial), trial)).find(|(value, _)| *value < least);
        match better {
            Some(better) => (least, u) = better,
            None => step *= 0.5,
        }
    }
    least
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    Smooth,
    Impacts,
    Kinks,
    Steep,
    Four,
    KinksAndImpacts,
}

impl Kind {
    const ALL: [Self; 6] = [Self::Smooth, Self::Impacts, Self::Kinks, Self::Steep, Self::Four, Self::KinksAndImpacts];

    /// Twice the furthest that the phase of a wave goes along one unknown number, rad.
    fn steepness(self) -> f64 {
        if self == Self::Steep { 10.0 } else { 5.0 }
    }

    /// How many numbers are unknown.
    fn unknown(self) -> usize {
        if self == Self::Four { MAX_UNKNOWN } else { 2 }
    }

    /// Outer points.
    fn outer(self) -> usize {
        if matches!(self, Self::Steep | Self::Four) { 64 } else { 32 }
    }
}

struct Curves {
    curves: Vec<Curve>,
    seed: u64,
}

impl Response for Curves {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        let key = random.iter().chain(epistemic).fold(self.seed, |key, number| hash(key, number.to_bits()));
        for (column, value) in columns.iter_mut().enumerate() {
            let angle = TAU * (column % POSES) as f64 / POSES as f64;
            let [mean, scatter, unforeseen] = self.curves[column / POSES].at(angle, epistemic);
            let beside = if unforeseen > 0.0 { unforeseen * normal(key, column as u64) } else { 0.0 };
            *value = mean + scatter * random[0] + beside;
        }
        Ok(())
    }
}

/// What the bounds of one problem were.
#[derive(Default)]
struct Tally {
    ends: usize,
    missed: usize,
    /// Ends of statistics over all poses, and those with a missed pose.
    curves: [usize; 2],
    /// Distribution functions, and those with a missed end.
    functions: [usize; 2],
    furthest: f64,
    /// Ends at infinity: quantiles beyond the sample.
    endless: usize,
    /// Widened beyond the exact ends, as a share of the true width, over all other ends.
    excess: f64,
    widths: f64,
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let only = words.get(3).cloned();
    let words: Vec<u64> = words.iter().take(3).map(|word| word.parse().expect("a number")).collect();
    let [problems, seed] = [0, 1].map(|place| *words.get(place).expect("PROBLEMS SEED [SAMPLING_SEEDS]"));
    let sampling_seeds = words.get(2).copied().unwrap_or(4);
    println!(
        "{:15} {:>8} {:>8} {:>9} {:>14} {:>10} {:>8} {:>16} {:>16}",
        "curves", "studies", "ends", "missed", "furthest miss", "too wide", "no end", "not whole curves", "functions"
    );
    let is_meant = |kind: &Kind| only.as_ref().is_none_or(|only| *only == format!("{kind:?}"));
    assert!(Kind::ALL.iter().any(is_meant), "KIND is one of {:?}", Kind::ALL);
    for kind in Kind::ALL.into_iter().filter(is_meant) {
        let mut all = Tally::default();
        for problem in 0..problems {
            let seed = hash(hash(seed, problem), kind as u64);
            let curves: Vec<Curve> = (0..CURVES as u64).map(|curve| Curve::draw(hash(seed, curve), kind)).collect();
            let response = Curves { curves, seed };
            let angles = (0..CURVES * POSES).into_par_iter();
            let exact: Vec<[[f64; 2]; 4]> = angles
                .map(|column| response.curves[column / POSES].ends(TAU * (column % POSES) as f64 / POSES as f64, kind))
                .collect();
            for sampling_seed in 0..sampling_seeds {
                count(&response, (kind, &exact), hash(seed, 1000 + sampling_seed), &mut all);
            }
        }
        println!(
            "{:15} {:8} {:8} {:8.3}% {:14.2e} {:9.3}% {:8} {:>16} {:>16}",
            format!("{kind:?}"),
            problems * sampling_seeds,
            all.ends,
            100.0 * all.missed as f64 / all.ends as f64,
            all.furthest,
            100.0 * all.excess / all.widths,
            all.endless,
            format!("{} of {}", all.curves[1], all.curves[0]),
            format!("{} of {}", all.functions[1], all.functions[0]),
        );
    }
}

/// Solves a problem and adds what its bounds are to `all`.
fn count(response: &Curves, (kind, exact): (Kind, &[[[f64; 2]; 4]]), seed: u64, all: &mut Tally) {
    let [low, high] = PROBABILITIES.map(Statistic::Quantile);
    let statistics = [Statistic::Mean, Statistic::StandardDeviation, low, high];
    let columns = 0..CURVES * POSES;
    let mut requests: Vec<Request> =
        columns.flat_map(|column| statistics.map(|statistic| Request { column, statistic })).collect();
    if kind.unknown() == 2 {
        let first_poses = (0..CURVES).map(|curve| curve * POSES);
        requests.extend(first_poses.map(|column| Request { column, statistic: Statistic::Cdf }));
    }
    let normal = RandomVariable::try_new(Distribution::Normal { mean: 0.0, standard_deviation: 1.0 });
    let unit = Interval::try_new(0.0, 1.0).expect("an interval");
    let unknown = vec![unit.into(); kind.unknown()];
    let mut problem = Problem::new(vec![normal.expect("a distribution")], unknown, requests);
    problem.sampling = Sampling { outer: kind.outer(), inner: INNER, seed, ..Sampling::default() };
    let bounds = evaluate(problem, response).expect("bounds");
    assert_eq!(bounds.pairs.len(), exact.len() * statistics.len(), "a pair for each statistic");
    let mut is_missed = vec![[false; 2]; CURVES * statistics.len()];
    for (place, (pair, [least, greatest])) in bounds.pairs.iter().zip(exact.iter().flatten()).enumerate() {
        let (column, statistic) = (place / statistics.len(), place % statistics.len());
        // Of what hardly depends on u the scale is its scatter.
        let width = greatest - least + 0.1;
        for (end, beyond) in [least - pair.lower.widened, pair.upper.widened - greatest].into_iter().enumerate() {
            let missed = beyond < -ROUND_OFF * width;
            all.ends += 1;
            all.missed += usize::from(missed);
            is_missed[column / POSES * statistics.len() + statistic][end] |= missed;
            all.furthest = all.furthest.max(-beyond / width);
            if beyond.is_finite() {
                all.excess += beyond.max(0.0);
                all.widths += 0.5 * (greatest - least);
            } else {
                all.endless += 1;
            }
        }
    }
    all.curves[0] += 2 * is_missed.len();
    all.curves[1] += is_missed.iter().flatten().filter(|&&missed| missed).count();
    for function in &bounds.boxes {
        let angle = TAU * (function.column % POSES) as f64 / POSES as f64;
        let is_short = |index: usize| {
            let [least, greatest] = response.curves[function.column / POSES].exact_share(angle, function.values[index]);
            function.lower[index].widened > least + ROUND_OFF || function.upper[index].widened < greatest - ROUND_OFF
        };
        all.functions[0] += 1;
        all.functions[1] += usize::from((0..function.values.len()).into_par_iter().any(is_short));
    }
}
