//! Probabilities of responses that hardly scatter at some values of the unknown inputs, against exact ones: there a distance in standard
//! deviations has a spike, and its model concedes anything.

#[allow(dead_code, reason = "the campaigns read the rest of it")]
mod exact;

use exact::{Case, NORMAL, UNIT, most_misses};
use loosepin_bounds::{Bound, Problem, Sampling, Statistic, evaluate};
use loosepin_uncertainty::{hash, normal_cdf, uniform};
use rayon::prelude::*;

/// Chance that a test fails where ends are missed as often as stated.
const LEVEL: f64 = 0.001;

fn upper(case: &Case, sampling: Sampling) -> Bound {
    let question = Problem { sampling, ..case.question(sampling.seed) };
    evaluate(question, case).expect("the case can be planned").pairs.swap_remove(0).upper
}

/// The largest deviation of a coupler with a ball at each end: its middle scatters by σ|x|, play of the size c takes it by g c either way, and
/// the place of the journals, q in [-1, 1], is anywhere between the ends that play makes. Where g c is beyond all scatter the least
/// deviation is 0 in every mechanism.
fn play_in_two_balls(limit: f64, plays: [f64; 2]) -> (Case, f64) {
    const SIGMA: f64 = 0.169;
    const GAIN: f64 = 0.755;
    let largest = |x: &[f64], u: &[f64]| {
        let (middle, reach) = (SIGMA * x[0].abs(), GAIN * u[0]);
        let ends = [(middle - reach).max(0.0), middle + reach];
        ends[0] + (ends[1] - ends[0]) * 0.5 * (1.0 + u[1])
    };
    let most = 2.0 * normal_cdf((GAIN * plays[1] - limit) / SIGMA);
    let case = Case::new("play in two balls", &[NORMAL], &[plays, [-1.0, 1.0]], largest);
    (case.with(Statistic::ProbabilityAbove(limit), [0.0, most]), most)
}

/// Before, up to 40 % more were conceded to the search at every limit but the last.
#[test]
fn analytic_play_that_reaches_every_deviation_leaves_the_search_next_to_nothing() {
    /// Nothing is outside of 1,024: 0.52 % are what counting leaves, and an order statistic has a share of 0.1 %.
    const FEW: f64 = 0.0065;
    const SEEDS: u64 = 3;
    let limits = [1.3, 1.5, 2.0, 2.5, 3.0].map(|limit| (limit, [0.2, 1.0]));
    let plays = [0.9, 0.5, 0.3, 0.05].map(|least| (2.0, [least, 1.0]));
    for (limit, plays) in limits.into_iter().chain(plays) {
        let (case, most) = play_in_two_balls(limit, plays);
        for seed in 1..=SEEDS {
            let found = upper(&case, Sampling { outer: 16, inner: 1024, seed, ..Sampling::default() });
            assert!(found.widened >= most, "{limit} {plays:?}: {most}, {found:?}");
            assert!(found.widened <= found.value + found.error.sampling + 0.002, "{limit} {plays:?}: {found:?}");
            assert!(limit < 1.5 || found.widened <= FEW, "{limit} {plays:?}: {found:?}");
        }
    }
}

/// Problems on which a share of 1 was stated before (`x(u - v) + 0.3u`, a steep stop): now within what their kinks leave.
#[test]
fn analytic_probabilities_beside_a_diagonal_without_scatter_and_above_a_steep_stop() {
    const SEEDS: u64 = 8;
    let stop = |x: &[f64], u: &[f64]| {
        let d = u[0] + 0.2 * x[0] + 0.1 * x[1];
        d + 50.0 * (d - u[1]).max(0.0)
    };
    let diagonal = Case::new("x(u - v) + 0.3u", &[NORMAL], &[UNIT, UNIT], |x, u| x[0] * (u[0] - u[1]) + 0.3 * u[0]);
    let stop = Case::new("a steep stop", &[NORMAL, NORMAL], &[[0.0, 0.6], [0.8, 1.2]], stop);
    let above = normal_cdf(-(45.0 / 51.0 - 0.6) / 0.05_f64.sqrt());
    for (case, exact, limit, most) in [(diagonal, normal_cdf(-0.7), 1.0, 0.3), (stop, above, 5.0, 0.25)] {
        let case = case.with(Statistic::ProbabilityAbove(limit), [0.0, exact]);
        let found: Vec<Bound> =
            (1..=SEEDS).map(|seed| upper(&case, Sampling { seed, ..Sampling::default() })).collect();
        assert!(found.iter().all(|bound| bound.widened >= exact), "{}: {exact}, {found:?}", case.name);
        let widened = exact::median(found.iter().map(|bound| bound.widened).collect());
        assert!(widened < most, "{}: {widened}, {found:?}", case.name);
    }
}

/// How the scatter of a drawn problem is distributed, and P(it exceeds z).
#[derive(Debug, Clone, Copy)]
enum Law {
    /// x: polynomials follow it.
    Normal,
    /// |x|: counted.
    Magnitude,
}

/// Y = m(u) + s(u) X, u in the unit box, whose s vanishes on a plane through it or comes near to 0 there.
#[derive(Debug, Clone)]
struct Drawn {
    law: Law,
    slopes: Vec<f64>,
    product: f64,
    normal: Vec<f64>,
    through: f64,
    least: f64,
    limit: f64,
    /// The greatest P(Y > limit) over u, from below: that of the best of many places.
    most: f64,
}

impl Drawn {
    fn draw(seed: u64, index: u64) -> Self {
        let key = hash(seed, index);
        let number = |place: u64| uniform(key, place);
        let dimensions = 1 + (index % 3) as usize;
        let own = |first: u64| -> Vec<f64> { (0..dimensions as u64).map(|k| 2.0 * number(first + k) - 1.0).collect() };
        let (slopes, normal) = (own(0), own(10));
        let middle: f64 = normal.iter().map(|b| b * (0.2 + 0.6 * number(20))).sum();
        let law = if index.is_multiple_of(2) { Law::Magnitude } else { Law::Normal };
        let least = [0.0, 0.0, 0.003, 0.03][(number(21) * 4.0) as usize];
        let mut drawn = Self {
            law,
            slopes,
            product: 2.0 * number(22) - 1.0,
            normal,
            through: middle,
            least,
            limit: 0.0,
            most: 0.0,
        };
        let share = [0.002, 0.01, 0.05, 0.25][(number(23) * 4.0) as usize];
        let places = drawn.places();
        let (mut low, mut high) = (-20.0, 20.0);
        for _ in 0..60 {
            drawn.limit = 0.5 * (low + high);
            if drawn.most_of(&places) > share { low = drawn.limit } else { high = drawn.limit }
        }
        drawn.most = drawn.most_of(&places);
        drawn
    }

    /// Corners, and places that fill the box and its faces.
    fn places(&self) -> Vec<Vec<f64>> {
        let each: u64 = [2000, 120, 30][self.slopes.len() - 1];
        let count = (each + 1).pow(self.slopes.len() as u32);
        let place = |index: u64| -> Vec<f64> {
            (0..self.slopes.len() as u32)
                .map(|k| (index / (each + 1).pow(k) % (each + 1)) as f64 / each as f64)
                .collect()
        };
        (0..count).map(place).collect()
    }

    fn parts(&self, u: &[f64]) -> [f64; 2] {
        let linear: f64 = u.iter().zip(&self.slopes).map(|(u, a)| u * a).sum();
        let across: f64 = u.iter().zip(&self.normal).map(|(u, b)| u * b).sum::<f64>() - self.through;
        [linear + self.product * u[0] * u[u.len() - 1], 0.4 * across.abs() + self.least]
    }

    fn probability(&self, u: &[f64]) -> f64 {
        let [mean, spread] = self.parts(u);
        let z = (self.limit - mean) / spread.max(1e-300);
        match self.law {
            Law::Normal => normal_cdf(-z),
            Law::Magnitude if z <= 0.0 => 1.0,
            Law::Magnitude => 2.0 * normal_cdf(-z),
        }
    }

    fn most_of(&self, places: &[Vec<f64>]) -> f64 {
        places.iter().map(|u| self.probability(u)).fold(0.0, f64::max)
    }

    fn case(&self) -> Case {
        let own = self.clone();
        let value = move |x: &[f64], u: &[f64]| {
            let [mean, spread] = own.parts(u);
            mean + spread * if matches!(own.law, Law::Normal) { x[0] } else { x[0].abs() }
        };
        let intervals = vec![UNIT; self.slopes.len()];
        Case::new("drawn", &[NORMAL], &intervals, value).with(Statistic::ProbabilityAbove(self.limit), [0.0, self.most])
    }
}

/// Missed ones of `count` drawn problems, and the sum of what was stated too much.
fn missed(seed: u64, count: u64) -> (u64, f64) {
    let of = |index: u64| {
        let drawn = Drawn::draw(seed, index);
        let found = upper(&drawn.case(), Sampling { seed: hash(seed, index), ..Sampling::default() });
        let is_missed = found.widened < drawn.most * (1.0 - 1e-6);
        if is_missed {
            println!("{index}: {} stated at most {}: {drawn:?} {found:?}", drawn.most, found.widened);
        }
        (u64::from(is_missed), found.widened - drawn.most)
    };
    (0..count).into_par_iter().map(of).reduce(|| (0, 0.0), |a, b| (a.0 + b.0, a.1 + b.1))
}

#[test]
fn analytic_drawn_probabilities_where_the_scatter_vanishes_hold() {
    const SEED: u64 = 20_261_130;
    const COUNT: u64 = 48;
    /// Mean of what is stated too much, of all mechanisms: 0.53 before.
    const MOST_WIDE: f64 = 0.1;
    let (missed, wide) = missed(SEED, COUNT);
    assert!(missed <= most_misses(COUNT, LEVEL), "{missed} of {COUNT} missed");
    assert!(wide / (COUNT as f64) < MOST_WIDE, "{}", wide / COUNT as f64);
}

/// Seed and number of problems: `LOOSEPIN_SEED=7 LOOSEPIN_PROBLEMS=600`.
#[test]
#[ignore = "minutes: just campaign vanishing-scatter"]
fn analytic_campaign_of_probabilities_where_the_scatter_vanishes() {
    let number = |name: &str, usual: u64| std::env::var(name).ok().and_then(|text| text.parse().ok()).unwrap_or(usual);
    let (seed, count) = (number("LOOSEPIN_SEED", 1), number("LOOSEPIN_PROBLEMS", 600));
    let (missed, wide) = missed(seed, count);
    println!("seed {seed}: {missed} of {count} missed, {} too much on average", wide / count as f64);
    assert!(missed <= most_misses(count, LEVEL), "{missed} of {count} missed");
}
