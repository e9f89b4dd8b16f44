//! Promises and searched bounds on random problems with hidden features, whose volume beyond any bound is known in closed form.
//!
//! Y = X + h(u), X uniform on [0, 1]. h is the highest of a few pyramids and of a few steps, all of them cubes, so that {h > t} is a union
//! of boxes. Each cube takes a random share of the box between 0.02 % and 10 %: some are wider than what a promise may leave out, most are
//! narrower than the distance of 64 points. A promise is broken where more than its share of the box lies beyond.
//!
//! Usage: `promise_campaign [PROBLEMS] [SEED]`

use loosepin::bounds::{
    Function, Problem, PromisePlan, PromiseRequest, PromiseSettings, Request, SampleTable, Sampling, Side, Statistic,
    evaluate, execute,
};
use loosepin::uncertainty::{Distribution, Interval, RandomVariable, hash, uniform};

const MAX_DIMENSIONS: u64 = 6;
const MAX_FEATURES: u64 = 4;
/// Shares of the box that a feature takes, at its foot: least and most.
const SHARES: [f64; 2] = [2e-4, 0.1];
/// Heights of features; X scatters by 1.
const HEIGHTS: [f64; 2] = [0.2, 4.0];
const PROBABILITY: f64 = 0.9;
const LIMIT: f64 = 1.0;
const SETTINGS: PromiseSettings = PromiseSettings { share: 0.99, confidence: 0.99, inner: 64 };

/// A cube, cut at the faces of the box, over which the statistic rises.
struct Feature {
    centre: Vec<f64>,
    half_edge: f64,
    height: f64,
    is_step: bool,
}

impl Feature {
    fn new(key: u64, dimensions: u64) -> Self {
        let between = |[low, high]: [f64; 2], fraction: f64| low * (high / low).powf(fraction);
        let share = between(SHARES, uniform(key, 100));
        Self {
            centre: (0..dimensions).map(|axis| uniform(key, axis)).collect(),
            half_edge: 0.5 * share.powf(1.0 / dimensions as f64),
            height: between(HEIGHTS, uniform(key, 101)),
            is_step: uniform(key, 102) < 0.5,
        }
    }

    fn at(&self, u: &[f64]) -> f64 {
        let furthest = u.iter().zip(&self.centre).map(|(u, centre)| (u - centre).abs()).fold(0.0, f64::max);
        match furthest / self.half_edge {
            inside if inside > 1.0 => 0.0,
            _ if self.is_step => self.height,
            inside => self.height * (1.0 - inside),
        }
    }

    /// The part of the box above `level`: lower and upper ends; `None` if there is none.
    fn above(&self, level: f64) -> Option<Vec<[f64; 2]>> {
        if level >= self.height {
            return None;
        }
        let half = if self.is_step { self.half_edge } else { self.half_edge * (1.0 - level.max(0.0) / self.height) };
        Some(self.centre.iter().map(|centre| [(centre - half).max(0.0), (centre + half).min(1.0)]).collect())
    }
}

/// Volume of the union of boxes, by inclusion and exclusion.
fn union_volume(boxes: &[Vec<[f64; 2]>]) -> f64 {
    (1..1_u32 << boxes.len())
        .map(|chosen| {
            let of = |index: &usize| chosen >> index & 1 == 1;
            let parts: Vec<&Vec<[f64; 2]>> = (0..boxes.len()).filter(of).map(|index| &boxes[index]).collect();
            let edge = |axis: usize| {
                let low = parts.iter().map(|part| part[axis][0]).fold(0.0, f64::max);
                let high = parts.iter().map(|part| part[axis][1]).fold(1.0, f64::min);
                (high - low).max(0.0)
            };
            let volume: f64 = (0..parts[0].len()).map(edge).product();
            if parts.len() % 2 == 1 { volume } else { -volume }
        })
        .sum()
}

/// Share of the box in which h exceeds `level`.
fn volume_above(features: &[Feature], level: f64) -> f64 {
    if level < 0.0 {
        return 1.0;
    }
    union_volume(&features.iter().filter_map(|feature| feature.above(level)).collect::<Vec<_>>())
}

/// A statistic: its request, and the level of h at which it has a value.
struct Asked {
    name: &'static str,
    statistic: Statistic,
    level: fn(f64) -> f64,
}

const ASKED: [Asked; 2] = [
    Asked { name: "quantile 0.9", statistic: Statistic::Quantile(PROBABILITY), level: |value| value - PROBABILITY },
    // P(X + h > 1) = h for h in [0, 1], and 1 above.
    Asked {
        name: "P(Y > 1)",
        statistic: Statistic::ProbabilityAbove(LIMIT),
        level: |value| if value >= 1.0 { f64::INFINITY } else { value },
    },
];

#[derive(Default)]
struct Counts {
    broken: [u64; ASKED.len()],
    missed: [u64; ASKED.len()],
    hidden: [u64; ASKED.len()],
    beyond: [f64; ASKED.len()],
}

fn main() {
    let mut arguments = std::env::args().skip(1).map(|text| text.parse::<u64>().expect("a whole number"));
    let problems = arguments.next().unwrap_or(1000);
    let seed = arguments.next().unwrap_or(1);
    let mut counts = Counts::default();
    for index in 0..problems {
        count(hash(seed, index), &mut counts);
    }
    println!("{problems} problems, seed {seed}; share 0.99, confidence 0.99, inner 64; search 64 outer, 64 inner");
    let due = 0.01 * problems as f64;
    println!("broken promises of each: {due} expected at most, {:.0} with four deviations", due + 4.0 * due.sqrt());
    for (place, asked) in ASKED.iter().enumerate() {
        println!(
            "{}: promise broken in {}; searched bound exceeded somewhere in {}, in more than 1 % of the box in {}; \
             largest share beyond a promise {:.4}",
            asked.name, counts.broken[place], counts.missed[place], counts.hidden[place], counts.beyond[place]
        );
    }
}

fn count(key: u64, counts: &mut Counts) {
    let dimensions = 1 + hash(key, 1) % MAX_DIMENSIONS;
    let features: Vec<Feature> =
        (0..1 + hash(key, 2) % MAX_FEATURES).map(|k| Feature::new(hash(key, 10 + k), dimensions)).collect();
    let respond = |x: &[f64], u: &[f64]| x[0] + features.iter().map(|feature| feature.at(u)).fold(0.0, f64::max);
    let x = RandomVariable::try_new(Distribution::Uniform { lower: 0.0, upper: 1.0 }).expect("a distribution");
    let interval = || Interval::try_new(0.0, 1.0).expect("an interval").into();
    let requests: Vec<Request> = ASKED.map(|asked| Request { column: 0, statistic: asked.statistic }).to_vec();
    let mut problem = Problem::new(vec![x], (0..dimensions).map(|_| interval()).collect(), requests.clone());
    problem.sampling =
        Sampling { outer: 64.max(2_usize.pow(dimensions as u32) + 16), inner: 64, seed: key >> 11, ..problem.sampling };
    let searched = evaluate(problem.clone(), &Function(respond)).expect("bounds");
    for (place, (asked, request)) in ASKED.iter().zip(requests).enumerate() {
        // By itself: the confidence is that of one promise.
        let wanted = vec![PromiseRequest { request, side: Side::Upper }];
        let plan = PromisePlan::try_new(problem.clone(), wanted, Vec::new(), SETTINGS).expect("a promise");
        let mut table = SampleTable::new(1);
        execute(plan.round(0), &Function(respond), &mut table).expect("rows of one column");
        let promised = plan.results(&table).expect("all runs")[0].bound;
        let beyond = |value: f64| volume_above(&features, (asked.level)(value));
        let beyond_search = beyond(searched.pairs[place].upper.widened);
        counts.broken[place] += u64::from(beyond(promised) > 1.0 - SETTINGS.share);
        counts.missed[place] += u64::from(beyond_search > 0.0);
        counts.hidden[place] += u64::from(beyond_search > 1.0 - SETTINGS.share);
        counts.beyond[place] = counts.beyond[place].max(beyond(promised));
    }
}
