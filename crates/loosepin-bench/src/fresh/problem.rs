//! A problem: its response, its question, its exact bounds.

use super::draw::Draw;
use super::group::{Feature, Group};
use super::law::Law;
use super::shapes::{Character, draw_shape};
use loosepin_bounds::{Failure, Problem as Question, Request, Response, Sampling, Statistic};
use loosepin_uncertainty::{Interval, RandomVariable, hash};

/// Runs of the mixture, at random u, which may be read beside the outer points.
pub const MIXTURE: usize = 1024;
/// Outer points of low discrepancy that the first round has.
const FIRST_OUTER: usize = 32;
/// At each of them so many runs show a height of this share of the scatter of one run: four standard errors of a mean of 256.
const SHARE_OF_SCATTER: f64 = 4.0 / 16.0;
/// So many of independent runs are in a volume on the average, then there is one in 99 %.
const EXPECTED_RUNS: f64 = 4.6;

/// A response whose exact bounds are known.
#[derive(Debug, Clone)]
pub struct Problem {
    pub seed: u64,
    pub index: u64,
    /// Ends of the box.
    pub ends: Vec<(f64, f64)>,
    pub character: Character,
    pub law: Law,
    /// m is the sum of these and `middle`.
    pub location: Vec<Group>,
    pub middle: f64,
    pub spread: Spread,
    pub exact: Vec<Exact>,
}

/// What multiplies Z.
#[derive(Debug, Clone)]
pub enum Spread {
    Constant(f64),
    /// base · (1 + rise · (f - least f)/(greatest f - least f)), f a group.
    Varying {
        base: f64,
        rise: f64,
        group: Group,
    },
    /// slope · (t - zero) of one coordinate, which vanishes inside of the box; of symmetric Z alone.
    Through {
        axis: usize,
        slope: f64,
        zero: f64,
    },
}

/// A statistic with its exact bounds.
#[derive(Debug, Clone, Copy)]
pub struct Exact {
    pub statistic: Statistic,
    pub ends: [f64; 2],
    /// Of the response: round-off is a share of it.
    pub magnitude: f64,
}

impl Spread {
    fn value(&self, t: &[f64]) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Varying { base, rise, group } => {
                base * (1.0 + rise * (group.value(t) - group.ends[0]) / group.width())
            }
            Self::Through { axis, slope, zero } => slope * (t[*axis] - zero),
        }
    }

    /// The least and the greatest of its absolute value.
    pub fn ends(&self) -> [f64; 2] {
        match self {
            Self::Constant(value) => [*value; 2],
            Self::Varying { base, rise, .. } => [*base, base * (1.0 + rise)],
            Self::Through { slope, zero, .. } => [0.0, slope.abs() * zero.max(1.0 - zero)],
        }
    }

    fn group(&self) -> Option<&Group> {
        match self {
            Self::Varying { group, .. } => Some(group),
            _ => None,
        }
    }
}

impl Problem {
    /// Problem `index` of `seed`.
    pub fn draw(seed: u64, index: u64) -> Self {
        let draw = &mut Draw::new(seed, index);
        let dimensions = 1 + draw.below(6);
        let character = match draw.fraction() {
            f if f < 0.3 => Character::Smooth,
            f if f < 0.72 => Character::Featured,
            _ => Character::Rough,
        };
        let ends = (0..dimensions).map(|_| {
            let low = draw.sign() * draw.of_size(0.1, 10.0);
            (low, low + draw.of_size(0.1, 10.0))
        });
        let ends: Vec<(f64, f64)> = ends.collect();
        let law = Law::draw(draw, character == Character::Rough);
        let mut parts = partition(draw, dimensions);
        let has_spread = parts.len() > 1 && draw.chance(0.5);
        let of_spread = if has_spread { parts.pop() } else { None };
        let mut groups = |draw: &mut Draw, axes: Vec<usize>, is_first: bool| {
            // One group has the character; the others are smooth or have it too.
            let own = if is_first || draw.chance(0.4) { character } else { Character::Smooth };
            let shape = draw_shape(draw, axes.len(), own);
            Group::new(axes, shape)
        };
        let location: Vec<Group> =
            parts.into_iter().enumerate().map(|(place, axes)| groups(draw, axes, place == 0)).collect();
        let width: f64 = location.iter().map(Group::width).sum();
        let base = draw.of_size(0.01, 1.0) * width / law.standard_deviation();
        let spread = match of_spread {
            Some(axes) if axes.len() == 1 && law.is_symmetric() && draw.chance(0.25) => {
                Spread::Through { axis: axes[0], slope: 2.0 * base, zero: draw.between(0.05, 0.95) }
            }
            Some(axes) => {
                let group = groups(draw, axes, false);
                let rise = draw.of_size(0.2, 4.0);
                if group.width() > 0.0 { Spread::Varying { base, rise, group } } else { Spread::Constant(base) }
            }
            None => Spread::Constant(base),
        };
        // About zero in half of the problems.
        let centre: f64 = location.iter().map(|group| 0.5 * (group.ends[0] + group.ends[1])).sum();
        let middle = if draw.chance(0.5) { width * draw.between(-0.5, 0.5) - centre } else { draw.between(-2.0, 2.0) };
        let mut problem = Self { seed, index, ends, character, law, location, middle, spread, exact: Vec::new() };
        problem.exact = problem.exact_bounds(draw);
        problem
    }

    /// The least and the greatest m.
    pub fn location_ends(&self) -> [f64; 2] {
        [0, 1].map(|end| self.middle + self.location.iter().map(|group| group.ends[end]).sum::<f64>())
    }

    /// The greatest and the least standard deviation of Y at a u.
    pub fn scatter(&self) -> [f64; 2] {
        self.spread.ends().map(|s| s * self.law.standard_deviation())
    }

    fn exact_bounds(&self, draw: &mut Draw) -> Vec<Exact> {
        let (locations, spreads) = (self.location_ends(), self.spread.ends());
        let law = &self.law;
        let magnitude =
            locations.iter().fold(0.0, |most: f64, m| most.max(m.abs())) + spreads[1] * law.standard_deviation();
        let corners = |value: &dyn Fn(f64, f64) -> f64| {
            let all = locations.iter().flat_map(|m| spreads.iter().map(move |s| (*m, *s)));
            all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], (m, s)| {
                let value = value(m, s);
                [low.min(value), high.max(value)]
            })
        };
        // Of s = 0 too, where Z of symmetric laws is multiplied by it.
        let above = |limit: f64, m: f64, s: f64| match s > 0.0 {
            true => law.above((limit - m) / s),
            false if m > limit => 1.0,
            false => 0.0,
        };
        let mut exact = Vec::new();
        let mut add = |statistic, ends| exact.push(Exact { statistic, ends, magnitude });
        add(Statistic::Mean, corners(&|m, s| m + s * law.mean()));
        add(Statistic::StandardDeviation, corners(&|_, s| s * law.standard_deviation()));
        for p in [0.025, 0.5, 0.975] {
            add(Statistic::Quantile(p), corners(&|m, s| m + s * law.quantile(p)));
        }
        // A limit that is exceeded with this probability where m and s are somewhere between their ends.
        let p = draw.one_of(&[0.5, 0.1, 0.02, 0.003]);
        let between = |draw: &mut Draw, [low, high]: [f64; 2]| draw.between(low, high);
        let (m, s) = (between(draw, locations), between(draw, spreads));
        let limit = m + s * law.quantile(1.0 - p);
        add(Statistic::ProbabilityAbove(limit), corners(&|m, s| above(limit, m, s)));
        let furthest = locations[0].abs().max(locations[1].abs());
        let limit = furthest + spreads[1] * draw.between(0.0, 2.0) * law.quantile(0.9).abs();
        let has_jump = self.location.iter().any(|group| group.shape.has_jump());
        let straddles = locations[0] < 0.0 && locations[1] > 0.0;
        if law.is_symmetric() && !(has_jump && straddles) && limit > furthest {
            let nearest = if straddles { 0.0 } else { locations[0].abs().min(locations[1].abs()) };
            let beyond = |m: f64, s: f64| above(limit, m, s) + above(limit, -m, s);
            add(Statistic::ProbabilityBeyond(limit), [beyond(nearest, spreads[0]), beyond(furthest, spreads[1])]);
        }
        exact
    }

    /// Every feature that sets an extreme, with its height against the scatter of one run.
    pub fn features(&self) -> Vec<(Feature, f64)> {
        let scatter = self.scatter();
        let of_location = self.location.iter().flat_map(|group| &group.features);
        let mut features: Vec<(Feature, f64)> =
            of_location.map(|feature| (feature.clone(), feature.height / scatter[1])).collect();
        if let Spread::Varying { rise, group, .. } = &self.spread {
            // In units of the scatter beside it.
            let of_spread = group.features.iter();
            features.extend(of_spread.map(|feature| (feature.clone(), feature.height * rise / group.width())));
        }
        features
    }

    /// Whether every feature that sets an extreme can be seen by the runs that are made anyway.
    pub fn is_visible(&self) -> bool {
        let is_seen = |(feature, height): &(Feature, f64)| {
            let by_mixture = feature.volume >= EXPECTED_RUNS / MIXTURE as f64 && *height > 1.0;
            let by_outer = feature.volume >= EXPECTED_RUNS / FIRST_OUTER as f64 && *height > SHARE_OF_SCATTER;
            by_mixture || by_outer
        };
        self.features().iter().all(is_seen)
    }

    /// Whether S(u) or the motion is rough.
    pub fn is_rough(&self) -> bool {
        let mut groups = self.location.iter().chain(self.spread.group());
        matches!(self.law, Law::Chaotic { .. }) || groups.any(|group| group.shape.is_rough())
    }

    /// Words for what it is made of, without trends.
    pub fn kinds(&self) -> Vec<String> {
        let words = |group: &Group, prefix: &str| -> Vec<String> {
            group.shape.names().into_iter().map(|name| format!("{prefix}{name}")).collect()
        };
        let mut kinds: Vec<String> = self.location.iter().flat_map(|group| words(group, "")).collect();
        match &self.spread {
            Spread::Varying { group, .. } => kinds.extend(words(group, "s:")),
            Spread::Through { .. } => kinds.push("s:through-zero".to_owned()),
            Spread::Constant(_) => {}
        }
        kinds.push(format!("Z:{}", self.law.name()));
        kinds.retain(|kind| !["linear", "square", "s:linear", "s:square"].contains(&kind.as_str()));
        kinds.sort();
        kinds.dedup();
        kinds
    }

    /// The question with a seed of its own for each repetition.
    ///
    /// # Panics
    /// Where the problem itself is wrong.
    pub fn question(&self, repetition: u64, sampling: Sampling) -> Question {
        let random = self.law.inputs().into_iter().map(|input| RandomVariable::try_new(input).expect("a distribution"));
        let interval = |&(low, high): &(f64, f64)| Interval::try_new(low, high).expect("an interval").into();
        let requests = self.exact.iter().map(|exact| Request { column: 0, statistic: exact.statistic }).collect();
        let seed = hash(hash(self.seed, self.index), repetition) >> 32;
        Question {
            compared_columns: vec![0],
            sampling: Sampling { seed, mixture: MIXTURE, ..sampling },
            ..Question::new(random.collect(), self.ends.iter().map(interval).collect(), requests)
        }
    }

    /// m, s and Y at these inputs.
    pub fn value(&self, x: &[f64], u: &[f64]) -> [f64; 3] {
        let mut t = [0.0; 6];
        for ((t, u), (low, high)) in t.iter_mut().zip(u).zip(&self.ends) {
            *t = ((u - low) / (high - low)).clamp(0.0, 1.0);
        }
        let m = self.middle + self.location.iter().map(|group| group.value(&t)).sum::<f64>();
        let s = self.spread.value(&t);
        [m, s, m + s * self.law.value(x, u)]
    }
}

/// Coordinates in groups of one, two or many.
fn partition(draw: &mut Draw, dimensions: usize) -> Vec<Vec<usize>> {
    let mut axes: Vec<usize> = (0..dimensions).collect();
    for place in (1..dimensions).rev() {
        axes.swap(place, draw.below(place + 1));
    }
    let mut parts = Vec::new();
    if dimensions >= 3 && draw.chance(0.4) {
        let rest = axes.split_off(3 + draw.below(dimensions - 2));
        parts.push(axes);
        axes = rest;
    }
    while !axes.is_empty() {
        let rest = axes.split_off(if axes.len() > 1 && draw.chance(0.5) { 2 } else { 1 });
        parts.push(axes);
        axes = rest;
    }
    parts
}

impl Response for Problem {
    fn evaluate(&self, random: &[f64], epistemic: &[f64], columns: &mut [f64]) -> Result<(), Failure> {
        columns[0] = self.value(random, epistemic)[2];
        Ok(())
    }
}
