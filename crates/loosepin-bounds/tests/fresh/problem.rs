//! A problem: its response, its question, its exact bounds, what may be overlooked in it.

use super::brute::extremes;
use super::draw::Draw;
use super::feature::Feature;
use super::group::{Group, Shape, add_features};
use super::law::Law;
use super::shapes::{Character, draw_shape, draw_terms};
use super::statistics::{Corners, Exact};
use super::term::Term;
use loosepin_bounds::{Failure, Problem as Question, Request, Response, Sampling};
use loosepin_uncertainty::{Interval, RandomVariable, hash, normal_cdf, uniform};

/// Runs of the mixture, at random u and X, which may be read beside those of the double loop, with the usual sampling.
const MIXTURE: usize = 1024;
/// Points of low discrepancy that the first round has.
const FIRST_OUTER: usize = 32;
/// At each of them so many runs show a height of this share of the scatter of one run: four standard errors of a mean of 256.
const SHARE_OF_SCATTER: f64 = 4.0 / 16.0;
/// With so many independent runs in a volume on the average, there is one in 99 %.
const EXPECTED_RUNS: f64 = 4.6;
/// A volume that a run of the mixture is in.
const MIN_VOLUME: f64 = EXPECTED_RUNS / MIXTURE as f64;

/// A branch with this probability changes no statistic by more than round-off.
const NEVER: f64 = 1e-13;

/// A response whose exact bounds are known.
#[derive(Debug, Clone)]
pub struct Problem {
    seed: u64,
    index: u64,
    /// Ends of the intervals of u.
    box_ends: Vec<(f64, f64)>,
    law: Law,
    /// m is the sum of these and `middle`.
    location: Vec<Group>,
    middle: f64,
    spread: Spread,
    /// k at its two ends, and what goes from one to the other; nothing where k is constant.
    shape: ([f64; 2], Option<Group>),
    /// Whether Y is the absolute value.
    is_absolute: bool,
    /// Every feature that sets an extreme, with its height against the scatter of one run: where that is largest for one of m, beside
    /// it for one of s.
    pub features: Vec<(Feature, f64)>,
    /// Whether m and s depend on the same coordinates.
    is_coupled: bool,
    /// What is asked, with the answers.
    pub exact: Vec<Exact>,
}

/// s, what multiplies Z.
#[derive(Debug, Clone)]
enum Spread {
    Constant(f64),
    /// base · (1 + rise · share), the share of a group from its least value, 0, to its greatest, 1.
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

impl Spread {
    fn value(&self, t: &[f64]) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Varying { base, rise, group } => base * (1.0 + rise * group.share(t)),
            Self::Through { axis, slope, zero } => slope * (t[*axis] - zero),
        }
    }

    /// The least and the greatest of its absolute value.
    fn ends(&self) -> [f64; 2] {
        match self {
            Self::Constant(value) => [*value; 2],
            Self::Varying { base, rise, .. } => [*base, base * (1.0 + rise)],
            Self::Through { slope, zero, .. } => [0.0, slope * zero.max(1.0 - zero)],
        }
    }

    fn group(&self) -> Option<&Group> {
        match self {
            Self::Varying { group, .. } => Some(group),
            Self::Constant(_) | Self::Through { .. } => None,
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
            f if f < 0.75 => Character::Featured,
            _ => Character::Rough,
        };
        let box_ends = (0..dimensions).map(|_| {
            let low = draw.sign() * draw.of_size(0.1, 10.0);
            (low, low + draw.of_size(0.1, 10.0))
        });
        let box_ends: Vec<(f64, f64)> = box_ends.collect();
        let law = Law::draw(draw, character == Character::Rough);
        let mut parts = partition(draw, dimensions);
        let mut take = |draw: &mut Draw, probability: f64| {
            if parts.len() > 1 && draw.chance(probability) { parts.pop() } else { None }
        };
        let of_spread = take(draw, 0.5);
        let k = law.shape(draw);
        let of_shape = if k.is_some() { take(draw, 0.6) } else { None };
        let shape = match (k, of_shape) {
            (Some(k), Some(axes)) => {
                let other = law.shape(draw).unwrap_or(k);
                let group = Group::new(axes.clone(), draw_shape(draw, axes.len(), Character::Smooth));
                ([k.min(other), k.max(other)], Some(group))
            }
            (k, _) => ([k.unwrap_or(0.0); 2], None),
        };
        // One group has the character; the others are smooth or have it too.
        let new_group = |draw: &mut Draw, axes: Vec<usize>, is_first: bool| {
            let own = if is_first || draw.chance(0.4) { character } else { Character::Smooth };
            let shape = draw_shape(draw, axes.len(), own);
            Group::new(axes, shape)
        };
        let location: Vec<Group> =
            parts.into_iter().enumerate().map(|(place, axes)| new_group(draw, axes, place == 0)).collect();
        let width: f64 = location.iter().map(Group::width).sum();
        let base = draw.of_size(0.01, 1.0) * width / law.standard_deviation(shape.0[1]);
        let spread = match of_spread {
            Some(axes) if axes.len() == 1 && law.is_symmetric() && draw.chance(0.25) => {
                Spread::Through { axis: axes[0], slope: 2.0 * base, zero: draw.between(0.05, 0.95) }
            }
            Some(axes) => {
                let group = new_group(draw, axes, false);
                Spread::Varying { base, rise: draw.of_size(0.2, 4.0), group }
            }
            None => Spread::Constant(base),
        };
        // About zero in half of the problems.
        let centre: f64 = location.iter().map(|group| 0.5 * (group.ends[0] + group.ends[1])).sum();
        let middle = if draw.chance(0.5) { width * draw.between(-0.5, 0.5) - centre } else { draw.between(-2.0, 2.0) };
        let mut problem = Self {
            seed,
            index,
            box_ends,
            law,
            location,
            middle,
            spread,
            shape,
            is_absolute: false,
            features: Vec::new(),
            is_coupled: false,
            exact: Vec::new(),
        };
        let corners = problem.corners();
        let is_absolute = corners.is_continuous && corners.law.has_folded() && draw.chance(0.2);
        let exact = if is_absolute { corners.of_absolute(draw) } else { corners.of_sum(draw) };
        let of_location: Vec<Feature> = problem.location.iter().flat_map(|group| group.features.clone()).collect();
        let of_spread = problem.spread.group().map_or_else(Vec::new, |group| group.features.clone());
        problem.features = problem.against_scatter(&of_location, &of_spread);
        (problem.is_absolute, problem.exact) = (is_absolute, exact);
        // Where there are few coordinates, in some problems m and s depend on the same ones.
        if dimensions <= 2 && character != Character::Rough && problem.shape.1.is_none() && draw.chance(0.4) {
            problem.couple(draw, character);
        }
        problem
    }

    /// Lets m and s depend on all coordinates: both are sums of terms.
    fn couple(&mut self, draw: &mut Draw, character: Character) {
        let axes: Vec<usize> = (0..self.dimensions()).collect();
        let new_group =
            |draw: &mut Draw| Group::new(axes.clone(), Shape::Terms(draw_terms(draw, axes.len(), character)));
        let group = new_group(draw);
        let base = draw.of_size(0.02, 0.5) * group.width() / self.law.standard_deviation(self.shape.0[1]);
        self.location = vec![group];
        self.spread = Spread::Varying { base, rise: draw.of_size(0.2, 4.0), group: new_group(draw) };
        (self.is_absolute, self.is_coupled) = (false, true);
        let Spread::Varying { group: of_spread, .. } = &self.spread else { unreachable!("made above") };
        let (m, s) = (self.location[0].shape.terms(), of_spread.shape.terms());
        let known = m.iter().chain(s).flat_map(Term::places).collect::<Vec<_>>();
        let curves: Vec<_> = m.iter().chain(s).filter_map(Term::curve).collect();
        let mut features = [Vec::new(), Vec::new()];
        self.exact = self.corners().of_place(draw, |value| {
            let at = |t: &[f64]| {
                let [m, s, k] = self.parts(t);
                value(m, s, k)
            };
            let found = extremes(&at, axes.len(), &known, &curves);
            for (features, terms) in features.iter_mut().zip([m, s]) {
                add_features(terms, &found, axes.len(), features);
            }
            found.map(|end| end.value)
        });
        self.features = self.against_scatter(&features[0], &features[1]);
    }

    /// Ends of m, s and k.
    fn corners(&self) -> Corners<'_> {
        let end = |end: usize| self.middle + self.location.iter().map(|group| group.ends[end]).sum::<f64>();
        let is_continuous = !self.location.iter().chain(self.spread.group()).any(|group| group.shape.has_jump());
        let (location, spread, shape) = ([end(0), end(1)], self.spread.ends(), self.shape.0);
        Corners { law: &self.law, location, spread, shape, is_continuous }
    }

    /// How many numbers are not known.
    pub fn dimensions(&self) -> usize {
        self.box_ends.len()
    }

    /// Features of m and of s with their heights against the scatter of one run.
    fn against_scatter(&self, of_location: &[Feature], of_spread: &[Feature]) -> Vec<(Feature, f64)> {
        let deviations = self.shape.0.map(|k| self.law.standard_deviation(k));
        let scatter = self.spread.ends()[1] * deviations[0].max(deviations[1]);
        let mut features: Vec<(Feature, f64)> =
            of_location.iter().map(|feature| (feature.clone(), feature.height / scatter)).collect();
        if let Spread::Varying { rise, group, .. } = &self.spread {
            features.extend(of_spread.iter().map(|feature| (feature.clone(), feature.height * rise / group.width())));
        }
        features
    }

    /// Share of the box in which all features of m at the rarer one of its ends are together.
    pub fn volume_together(&self) -> f64 {
        let of_group = |group: &Group, end: usize| {
            let at_end = group.features.iter().filter(|feature| feature.ends[end]);
            at_end.map(|feature| feature.volume).fold(1.0, f64::min)
        };
        let of_end = |end: usize| self.location.iter().map(|group| of_group(group, end)).product::<f64>();
        of_end(0).min(of_end(1))
    }

    /// Whether every feature that sets an extreme can be seen: one run of the mixture is in it and stands out of the scatter, or a point
    /// of the first round is in it and the mean of its runs stands out; and a rare branch of X, or the fold of an absolute value, has a run of the mixture.
    pub fn is_visible(&self) -> bool {
        let is_seen = |(feature, height): &(Feature, f64)| {
            let by_mixture = feature.volume >= MIN_VOLUME && *height > 1.0;
            let by_outer = feature.volume >= EXPECTED_RUNS / FIRST_OUTER as f64 && *height > SHARE_OF_SCATTER;
            by_mixture || by_outer
        };
        let branch = match self.law {
            Law::RareBranch { .. } => normal_cdf(-self.shape.0[1]),
            _ if self.is_absolute => self.corners().folded_share(),
            _ => 1.0,
        };
        let is_branch_seen = branch >= MIN_VOLUME || branch <= NEVER;
        is_branch_seen && self.features.iter().all(is_seen)
    }

    /// Whether a run of the mixture is where all features at an end of m are together.
    pub fn is_seen_together(&self) -> bool {
        self.volume_together() >= MIN_VOLUME
    }

    /// Whether the statistics over u or the motion is rough.
    pub fn is_rough(&self) -> bool {
        let mut groups = self.location.iter().chain(self.spread.group());
        matches!(self.law, Law::Chaotic { .. }) || groups.any(|group| group.shape.is_rough())
    }

    /// Words for what it is made of, without trends.
    pub fn kinds(&self) -> Vec<String> {
        let words = |group: &Group, prefix: &str| -> Vec<String> {
            let names = group.shape.names().into_iter().filter(|name| !["linear", "square"].contains(name));
            names.map(|name| format!("{prefix}{name}")).collect()
        };
        let mut kinds: Vec<String> = self.location.iter().flat_map(|group| words(group, "")).collect();
        kinds.extend(self.spread.group().map(|group| words(group, "s:")).unwrap_or_default());
        if matches!(self.spread, Spread::Through { .. }) {
            kinds.push("s:through-zero".to_owned());
        }
        let folded = if self.is_absolute { "|Y| " } else { "" };
        if self.is_coupled {
            kinds.push("coupled".to_owned());
        }
        let moving = if self.shape.1.is_some() { " moving" } else { "" };
        kinds.push(format!("{folded}Z:{}{moving}", self.law.name()));
        kinds.sort();
        kinds.dedup();
        kinds
    }

    /// The question, with so many runs and a seed of its own for each repetition.
    ///
    /// # Panics
    /// If the problem itself is wrong.
    pub fn question(&self, repetition: u64, sampling: Sampling) -> Question {
        let random = self.law.inputs().into_iter().map(|input| RandomVariable::try_new(input).expect("a distribution"));
        let interval = |&(low, high): &(f64, f64)| Interval::try_new(low, high).expect("an interval").into();
        let requests = self.exact.iter().map(|exact| Request { column: 0, statistic: exact.statistic }).collect();
        let seed = hash(hash(self.seed, self.index), repetition) >> 32;
        Question {
            compared_columns: vec![0],
            sampling: Sampling { seed, ..sampling },
            ..Question::new(random.collect(), self.box_ends.iter().map(interval).collect(), requests)
        }
    }

    /// Ends of m, s (with its sign) and k.
    pub fn part_ends(&self) -> [[f64; 2]; 3] {
        let corners = self.corners();
        let spread = match self.spread {
            Spread::Through { slope, zero, .. } => [-slope * zero, slope * (1.0 - zero)],
            _ => corners.spread,
        };
        [corners.location, spread, corners.shape]
    }

    /// Where m, s and k are at these of their ends, 0 or 1 each; `None` if they depend on each other.
    pub fn corner(&self, [m, s, k]: [usize; 3]) -> Option<Vec<f64>> {
        if self.is_coupled {
            return None;
        }
        let mut t = vec![0.5; self.dimensions()];
        let of_location = self.location.iter().map(|group| (group, m));
        let of_others = self.spread.group().map(|group| (group, s)).into_iter();
        for (group, end) in of_location.chain(of_others).chain(self.shape.1.iter().map(|group| (group, k))) {
            for (axis, at) in group.axes.iter().zip(&group.places[end]) {
                t[*axis] = *at;
            }
        }
        if let Spread::Through { axis, .. } = self.spread {
            t[axis] = s as f64;
        }
        Some(t)
    }

    /// Responses of so many random X at a place of the unit box.
    ///
    /// # Panics
    /// If the problem itself is wrong.
    pub fn runs(&self, t: &[f64], count: u64) -> Vec<f64> {
        let inputs = self.law.inputs().into_iter().map(|input| RandomVariable::try_new(input).expect("a distribution"));
        let inputs: Vec<RandomVariable> = inputs.collect();
        let u: Vec<f64> = t.iter().zip(&self.box_ends).map(|(t, (low, high))| low + (high - low) * t).collect();
        let run = |run: u64| {
            let of_input =
                |(place, input): (u64, &RandomVariable)| input.quantile(uniform(hash(self.seed, run), place));
            let x: Vec<f64> = (0..).zip(&inputs).map(of_input).collect();
            let mut columns = [f64::NAN];
            self.evaluate(&x, &u, &mut columns).expect("no run fails");
            columns[0]
        };
        (0..count).map(run).collect()
    }

    /// Whether a few runs do not tell their own deviation.
    pub fn has_heavy_tail(&self) -> bool {
        matches!(self.law, Law::Lognormal | Law::RareBranch { .. })
    }

    /// m, s and k at a place of the unit box.
    pub fn parts(&self, t: &[f64]) -> [f64; 3] {
        let m = self.middle + self.location.iter().map(|group| group.value(t)).sum::<f64>();
        let (shape, group) = &self.shape;
        let share = group.as_ref().map_or(0.0, |group| group.share(t));
        [m, self.spread.value(t), shape[0] + (shape[1] - shape[0]) * share]
    }
}

impl Group {
    /// How far it is from its least value, 0, to its greatest, 1.
    fn share(&self, t: &[f64]) -> f64 {
        (self.value(t) - self.ends[0]) / self.width()
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
        let mut t = [0.0; 6];
        for ((t, u), (low, high)) in t.iter_mut().zip(epistemic).zip(&self.box_ends) {
            *t = ((u - low) / (high - low)).clamp(0.0, 1.0);
        }
        let [m, s, k] = self.parts(&t);
        let y = m + s * self.law.value(k, random, epistemic);
        columns[0] = if self.is_absolute { y.abs() } else { y };
        Ok(())
    }
}
