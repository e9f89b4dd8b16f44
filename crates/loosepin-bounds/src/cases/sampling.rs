//! How often the sampling errors at one u are too small, over families of distributions and many seeds of scrambled replicates: every end of
//! every statistic may be missed as often as its confidence allows.

use crate::data::points::inner_points;
use crate::data::problem::Sampling;
use crate::estimators::estimate::{Confidence, Estimate, standard_deviation};
use crate::estimators::moments::{mean, variance};
use crate::estimators::probability::{ShareLimits, probability};
use crate::estimators::quantile::quantile;
use crate::estimators::sample::Sample;
use loosepin_terms::Event;
use loosepin_uncertainty::{ScrambledSobol, binomial_tail, hash, normal_quantile, uniform};
use rayon::prelude::*;

/// Inputs of a family, at most.
const INPUTS: usize = 4;
/// Points of which the exact statistics are taken where no closed form is given: of a scrambled net of their own.
const EXACT_POINTS: u32 = 1 << 18;
const MORE_EXACT_POINTS: u32 = 1 << 20;
const QUANTILES: [f64; 3] = [0.025, 0.5, 0.975];
/// Probabilities to exceed a limit.
const TAILS: [f64; 4] = [0.5, 0.05, 1e-3, 1e-4];
const STATISTICS: usize = 2 + QUANTILES.len() + TAILS.len();
/// Of numbers about 1: what the sums of the exact statistics leave.
const ROUND_OFF: f64 = 1e-9;

type Response = Box<dyn Fn(&[f64]) -> f64 + Sync>;

/// A response of independent uniform numbers.
struct Family {
    name: String,
    /// Kinds of the parts of a drawn one.
    parts: Vec<&'static str>,
    response: Response,
    /// Whether every run draws numbers of its own, as where motion is chaotic: replicates are then no better than independent runs.
    is_rough: bool,
    /// Mean and standard deviation in closed form.
    moments: Option<[f64; 2]>,
}

fn family(name: &str, is_rough: bool, response: impl Fn(&[f64]) -> f64 + Sync + 'static) -> Family {
    Family {
        name: format!("{name}{}", if is_rough { ", rough" } else { "" }),
        parts: Vec::new(),
        response: Box::new(response),
        is_rough,
        moments: None,
    }
}

/// Normal, skewed, bounded, in steps, with two humps; each smooth and rough in the random inputs.
fn families() -> Vec<Family> {
    let z = normal_quantile;
    let both = [false, true];
    let mut families: Vec<Family> = Vec::new();
    for rough in both {
        families.push(family("normal", rough, move |w| z(w[0])));
        families.push(family("uniform", rough, |w| w[0]));
        families.push(family("exponential", rough, |w| -libm::log1p(-w[0])));
        families.push(family("magnitude", rough, move |w| (z(w[0]) + 0.3 * z(w[1])).abs()));
        families.push(family("square", rough, move |w| z(w[0]).powi(2)));
        families.push(family("two humps", rough, move |w| 0.3 * z(w[1]) + if w[0] < 0.37 { -2.0 } else { 2.0 }));
        families.push(family("coin", rough, |w| f64::from(w[0] < 0.5)));
        families.push(family("one of fifty", rough, |w| f64::from(w[0] < 0.02)));
        families.push(family("steps", rough, |w| {
            f64::from(w[0] > 0.5) + f64::from(w[0] > 0.8) + 3.0 * f64::from(w[0] > 0.97)
        }));
        families.push(family("rare branch", rough, move |w| z(w[0]) + 4.0 * f64::from(w[1] < 0.05)));
        for deviation in [0.5, 1.0] {
            let response = move |w: &[f64]| libm::exp(deviation * z(w[0]));
            families.push(lognormal(deviation, family(&format!("lognormal {deviation}"), rough, response)));
        }
    }
    families
}

/// A lognormal distribution without a fourth moment, or nearly so.
fn heavy_lognormal(is_rough: bool) -> Family {
    lognormal(1.5, family("lognormal 1.5", is_rough, |w| libm::exp(1.5 * normal_quantile(w[0]))))
}

/// One without a third moment.
fn heavy_student(is_rough: bool) -> Family {
    let family = family("Student, 3 degrees", is_rough, |w| student_3(w[0]));
    Family { moments: Some([0.0, 3.0_f64.sqrt()]), ..family }
}

fn lognormal(deviation: f64, family: Family) -> Family {
    let square = deviation * deviation;
    let mean = libm::exp(0.5 * square);
    Family { moments: Some([mean, mean * libm::expm1(square).sqrt()]), ..family }
}

/// Quantile of Student's distribution with three degrees of freedom, from its distribution function by bisection in t/(1 + t).
fn student_3(probability: f64) -> f64 {
    if probability < 0.5 {
        return -student_3(1.0 - probability);
    }
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    for _ in 0..52 {
        let middle = 0.5 * (low + high);
        let x = middle / (1.0 - middle) / 3.0_f64.sqrt();
        let below = 0.5 + (x / (1.0 + x * x) + libm::atan(x)) / core::f64::consts::PI;
        if below < probability { low = middle } else { high = middle }
    }
    low / (1.0 - low)
}

/// A sum of one to four functions of one input each, drawn from `seed`.
fn drawn_family(seed: u64) -> Family {
    let at = |index: u64| uniform(seed, index);
    let count = 1 + (at(0) * INPUTS as f64) as usize;
    let mut words: Vec<&'static str> = Vec::new();
    let mut parts: Vec<(f64, Response)> = Vec::new();
    for part in 0..count as u64 {
        let (size, shape, kind) = (4.0 * at(8 * part + 8) - 2.0, at(8 * part + 9), (at(8 * part + 10) * 7.0) as usize);
        let z = normal_quantile;
        let (word, response): (&'static str, Response) = match kind {
            0 => ("normal", Box::new(move |w| z(w[0]))),
            1 => ("magnitude", Box::new(move |w| (z(w[0]) - shape).abs())),
            2 => ("lognormal", Box::new(move |w| libm::exp((0.2 + shape) * z(w[0])))),
            3 => {
                ("branch", Box::new(move |w| if w[0] < 0.5 * libm::pow(0.1, shape) { 1.0 + 2.0 * shape } else { 0.0 }))
            }
            4 => ("square", Box::new(move |w| (z(w[0]) + shape).powi(2))),
            5 => ("steps", Box::new(move |w| ((2.0 + 4.0 * shape).floor() * w[0]).floor())),
            _ => ("kink", Box::new(move |w| (z(w[0]) - shape).max(0.0))),
        };
        words.push(word);
        parts.push((size, response));
    }
    let is_rough = at(1) < 0.3;
    let name = format!("drawn {seed}: {}", words.join(" "));
    let drawn = family(&name, is_rough, move |w| parts.iter().zip(w).map(|((size, of), &w)| size * of(&[w])).sum());
    Family { parts: words, ..drawn }
}

impl Family {
    fn sample(&self, points: &[Vec<Vec<f64>>], seed: u64) -> Sample {
        let value = |(replicate, index): (usize, usize)| {
            if !self.is_rough {
                return (self.response)(&points[replicate][index]);
            }
            let run = hash(hash(seed, replicate as u64), index as u64);
            (self.response)(&(0..INPUTS as u64).map(|input| uniform(run, input)).collect::<Vec<f64>>())
        };
        Sample::new(
            (0..points.len())
                .map(|replicate| (0..points[replicate].len()).map(move |index| (replicate, index)).map(&value)),
        )
    }

    /// Exact statistics in their order, and the limits.
    fn exact(&self, points: &[Vec<f64>]) -> ([f64; STATISTICS], [f64; TAILS.len()]) {
        let mut values: Vec<f64> = points.iter().map(|point| (self.response)(point)).collect();
        values.sort_unstable_by(f64::total_cmp);
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let variance = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / count;
        let [mean, deviation] = self.moments.unwrap_or([mean, variance.sqrt()]);
        let at = |probability: f64| values[(probability * count) as usize];
        let limits = TAILS.map(|tail| at(1.0 - tail));
        let beyond = limits.map(|limit| 1.0 - values.partition_point(|value| *value <= limit) as f64 / count);
        let exact = [mean, deviation].into_iter().chain(QUANTILES.map(at)).chain(beyond).collect::<Vec<f64>>();
        (exact.try_into().unwrap(), limits)
    }
}

fn estimates(sample: &Sample, limits: &[f64], confidence: &Confidence) -> Vec<Estimate> {
    let moments = [mean(sample, confidence), standard_deviation(variance(sample, confidence))];
    let quantiles = QUANTILES.map(|probability| quantile(sample, confidence, probability).low);
    let shares =
        limits.iter().map(|&limit| probability(sample, Event::Above(limit), confidence, &ShareLimits::default()).low);
    moments.into_iter().chain(quantiles).chain(shares).collect()
}

/// Misses of both ends of every statistic, family by family, with a table of them. An end may be missed in 0.5 % of the seeds.
fn misses(
    families: &[Family],
    statistics: usize,
    exact_points: u32,
    [inner, replicates]: [usize; 2],
    seeds: u64,
) -> (Vec<Vec<[u64; 2]>>, String) {
    let confidence = Confidence::new(0.99, replicates);
    let exact = {
        let sobol = ScrambledSobol::try_new(0x6578_6163, INPUTS).unwrap();
        let point = |index| (0..INPUTS).map(|input| sobol.point(0, index, input)).collect::<Vec<f64>>();
        let points: Vec<Vec<f64>> = (0..exact_points).into_par_iter().map(point).collect();
        families.par_iter().map(|family| family.exact(&points)).collect::<Vec<_>>()
    };
    let of_seed = |seed: u64| {
        let sobol = ScrambledSobol::try_new(hash(seed, 0x7361_6d70), INPUTS).unwrap();
        let mut points = vec![Vec::new(); replicates];
        let sampling = Sampling { inner, replicates, ..Sampling::default() };
        inner_points(&sampling, &sobol).for_each(|(replicate, _, point)| points[replicate as usize].push(point));
        let of_family = |(family, (_, limits)): (&Family, &([f64; STATISTICS], [f64; TAILS.len()]))| {
            estimates(&family.sample(&points, seed), limits, &confidence)
        };
        families.iter().zip(&exact).map(of_family).collect::<Vec<_>>()
    };
    let found: Vec<Vec<Vec<Estimate>>> = (0..seeds).into_par_iter().map(of_seed).collect();
    let mut report = Vec::new();
    let mut counts = Vec::new();
    for (of, (family, (exact, _))) in families.iter().zip(&exact).enumerate() {
        let mut line = format!("{:32}", family.name);
        let mut own_counts = Vec::new();
        for (statistic, exact) in exact.iter().enumerate().take(statistics) {
            let own = || found.iter().map(|seed| seed[of][statistic]);
            let below = own().filter(|at| at.lower_limit() > exact + ROUND_OFF).count() as u64;
            let above = own().filter(|at| at.value + at.above < exact - ROUND_OFF).count() as u64;
            let sorted = |of: &dyn Fn(Estimate) -> f64| {
                let mut values: Vec<f64> = own().map(of).collect();
                values.sort_unstable_by(f64::total_cmp);
                values
            };
            let stated = sorted(&|at| 0.5 * (at.below + at.above))[found.len() / 2];
            let actual = sorted(&|at| (at.value - exact).abs())[found.len() * 99 / 100];
            line += &format!(" {below:2}/{above:2} ({:4.1})", stated / actual);
            own_counts.push([below, above]);
        }
        counts.push(own_counts);
        report.push(line);
    }
    let report = report.join("\n");
    let head = format!(
        "{inner} runs, {replicates} replicates, {seeds} seeds: misses below/above (median stated error / 99 % of actual ones)"
    );
    (counts, format!("{head}\n{report}"))
}

/// Fails where an end of a statistic of a family is missed too often in 200 seeds.
#[track_caller]
fn check_families(families: &[Family], statistics: usize) {
    let (counts, report) = misses(families, statistics, EXACT_POINTS, [256, 8], 200);
    assert!(counts.iter().flatten().flatten().all(|&misses| misses <= MAX_OF_200), "more than {MAX_OF_200}\n{report}");
}

/// The least m with P(Binomial(200, 0.005) > m) < 1e-4: hundreds of ends are counted.
const MAX_OF_200: u64 = 6;
/// So often an end may be missed.
const STATED_MISS: f64 = 0.005;

#[test]
fn analytic_sampling_errors_hold_at_their_confidence_for_skewed_and_stepped_responses() {
    check_families(&families(), STATISTICS);
}

/// The upper half of a lognormal sample shows its tail, that of a Student sample does not.
#[test]
fn analytic_errors_of_means_and_deviations_hold_at_their_confidence_for_heavy_tails() {
    check_families(&[false, true].map(heavy_lognormal), 2);
    check_families(&[false, true].map(heavy_student), 1);
}

/// LOOSEPIN_SEED draws other families. A table tells how often ends are missed where a family has a part of each kind: `just campaign
/// sampling-errors [SEED]`.
#[test]
#[ignore = "a campaign: minutes"]
fn analytic_sampling_errors_hold_at_their_confidence_for_families_drawn_from_a_seed() {
    const FAMILIES: u64 = 500;
    const SEEDS: u64 = 60;
    /// Level of all statistics, ends and plans together.
    const LEVEL: f64 = 0.01;
    let seed = std::env::var("LOOSEPIN_SEED").ok().map_or(2611, |seed| seed.parse().unwrap());
    let drawn: Vec<Family> = (0..FAMILIES).map(|index| drawn_family(hash(seed, index))).collect();
    let plans = [[256, 8], [1024, 8]];
    let tests = (2 * STATISTICS * plans.len()) as f64;
    let is_last = |misses: &u64| binomial_tail(FAMILIES * SEEDS, misses + 1, STATED_MISS) < LEVEL / tests;
    let allowed = (0..).find(is_last).unwrap();
    let mut failed = Vec::new();
    for plan in plans {
        let (counts, _) = misses(&drawn, STATISTICS, MORE_EXACT_POINTS, plan, SEEDS);
        println!("{plan:?} runs and replicates, {FAMILIES} families, {SEEDS} seeds: per cent missed below/above");
        const HEAD: &str = "mean, deviation, quantiles 0.025 0.5 0.975, exceeded in 0.5 0.05 1e-3 1e-4";
        println!("{:10} {:>8}  {HEAD}", "", "families");
        assert_eq!(counts.len(), drawn.len(), "counts of each family");
        let tell = |class: &str, is_meant: &dyn Fn(&Family) -> bool| {
            let own = drawn.iter().zip(&counts).filter(|(family, _)| is_meant(family)).map(|(_, counts)| counts);
            let own: Vec<&Vec<[u64; 2]>> = own.collect();
            let share = |statistic: usize, end: usize| {
                let missed: u64 = own.iter().map(|counts| counts[statistic][end]).sum();
                100.0 * missed as f64 / (own.len() as u64 * SEEDS) as f64
            };
            let shares: Vec<String> =
                (0..STATISTICS).map(|k| format!("{:5.2}/{:4.2}", share(k, 0), share(k, 1))).collect();
            println!("{class:10} {:8} {}", own.len(), shares.join(" "));
        };
        tell("all", &|_| true);
        for part in ["normal", "magnitude", "lognormal", "branch", "square", "steps", "kink"] {
            tell(part, &|family| family.parts.contains(&part));
        }
        tell("rough", &|family| family.is_rough);
        for (statistic, end) in (0..STATISTICS).flat_map(|statistic| [(statistic, 0), (statistic, 1)]) {
            let missed: u64 = counts.iter().map(|family| family[statistic][end]).sum();
            if missed > allowed {
                failed.push(format!("{plan:?}, statistic {statistic}, end {end}: {missed}, more than {allowed}"));
            }
        }
    }
    assert!(failed.is_empty(), "{failed:?}");
}
