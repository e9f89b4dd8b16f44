//! Functions of a few coordinates of the unit box with known extremes.

use super::brute::{Extreme, extremes};
use super::feature::{Feature, ball_volume, share};
use super::term::{Term, dot};
use loosepin_uncertainty::normal;
use std::f64::consts::TAU;

/// A function of its coordinates in the unit box; each variant says why its extremes are exact.
#[derive(Debug, Clone)]
pub enum Shape {
    /// A sum over one or two coordinates; extremes by brute force, with every known centre, edge, crease and crest looked at by itself.
    Terms(Vec<Term>),
    /// height · exp(-Σ ((t - centre)/width)²): its top is the centre, and it falls along each coordinate, so it is least in the furthest corner.
    Hill { centre: Vec<f64>, widths: Vec<f64>, height: f64 },
    /// Tops and pits height · (1 - r²/radius²)² inside of balls that have nothing in common, 0 outside of all: extremes are the heights.
    Hills(Vec<Hill>),
    /// Constant in each of `per_axis` to the power of the dimension cells, normal heights: all of them are looked at.
    Cells { key: u64, per_axis: usize, height: f64 },
    /// A function of a·t, a of length 1, which takes every value between those at two corners.
    Sheet { along: Vec<f64>, height: f64, profile: Profile },
}

/// A function of one number x = a·t.
#[derive(Debug, Clone, Copy)]
pub enum Profile {
    /// exp(-(x - at)²/width²).
    Ridge { at: f64, width: f64 },
    /// -|x - at|.
    Kink { at: f64 },
    /// 1 where x > at.
    Step { at: f64 },
    /// sin(2π turns x + phase); over the box it makes at least one turn.
    Wave { turns: f64, phase: f64 },
}

/// A ball in which the surface rises, or falls where the height is negative.
#[derive(Debug, Clone)]
pub struct Hill {
    pub centre: Vec<f64>,
    pub radius: f64,
    pub height: f64,
}

/// A function of some coordinates, with its extremes.
#[derive(Debug, Clone)]
pub struct Group {
    /// The coordinates.
    pub axes: Vec<usize>,
    pub shape: Shape,
    /// Least and greatest value.
    pub ends: [f64; 2],
    /// Where they are attained, or come as near as round-off.
    pub places: [Vec<f64>; 2],
    /// Features at either of them.
    pub features: Vec<Feature>,
}

/// A feature sets an extreme where it is more than this share of its height there.
const MIN_PART: f64 = 0.05;
/// Radius at which (1 - r²)² is a half.
pub const HALF_HEIGHT: f64 = 0.541_196_100_146_197;

impl Group {
    /// With extremes and features worked out.
    pub fn new(axes: Vec<usize>, shape: Shape) -> Self {
        let dimensions = axes.len();
        let (found, features) = match &shape {
            Shape::Terms(terms) => of_terms(terms, dimensions),
            Shape::Hill { centre, height, .. } => {
                let corner: Vec<f64> = centre.iter().map(|c| if *c > 0.5 { 0.0 } else { 1.0 }).collect();
                let volume = share(dimensions, |t| shape.value(t) / height > 0.5);
                let feature =
                    Feature { name: "hill", volume, height: height.abs(), ends: [*height < 0.0, *height > 0.0] };
                let ends = [
                    Extreme { value: shape.value(&corner), at: corner },
                    Extreme { value: *height, at: centre.clone() },
                ];
                (sorted(ends), vec![feature])
            }
            Shape::Hills(hills) => of_hills(hills),
            Shape::Cells { key, per_axis, height } => of_cells(*key, *per_axis, *height, dimensions),
            Shape::Sheet { along, height, profile } => of_sheet(&shape, along, *height, *profile),
        };
        let [least, greatest] = found;
        Self { axes, shape, ends: [least.value, greatest.value], places: [least.at, greatest.at], features }
    }

    /// Its value at a place of the whole unit box.
    pub fn value(&self, t: &[f64]) -> f64 {
        let mut own = [0.0; 6];
        for (own, axis) in own.iter_mut().zip(&self.axes) {
            *own = t[*axis];
        }
        self.shape.value(&own[..self.axes.len()])
    }

    /// From the least to the greatest value.
    pub fn width(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }
}

impl Shape {
    /// Its value at a place of the unit box of its own coordinates.
    pub fn value(&self, t: &[f64]) -> f64 {
        match self {
            Self::Terms(terms) => terms.iter().map(|term| term.value(t)).sum(),
            Self::Hill { centre, widths, height } => {
                let square: f64 = t.iter().zip(centre).zip(widths).map(|((t, c), w)| ((t - c) / w).powi(2)).sum();
                height * libm::exp(-square)
            }
            Self::Hills(hills) => hills.iter().map(|hill| hill.value(t)).sum(),
            Self::Cells { key, per_axis, height } => {
                let place = |t: &f64| ((t * *per_axis as f64) as usize).min(per_axis - 1);
                let cell = t.iter().rev().fold(0, |cell, t| cell * per_axis + place(t));
                height * normal(*key, cell as u64)
            }
            Self::Sheet { along, height, profile } => height * profile.value(dot(along, t)),
        }
    }

    /// The terms of a sum; none of another shape.
    pub fn terms(&self) -> &[Term] {
        match self {
            Self::Terms(terms) => terms,
            _ => &[],
        }
    }

    /// Words for what it is made of.
    pub fn names(&self) -> Vec<&'static str> {
        match self {
            Self::Terms(terms) => terms.iter().map(Term::name).collect(),
            Self::Hill { .. } => vec!["hill"],
            Self::Hills(_) => vec!["hills"],
            Self::Cells { .. } => vec!["cells"],
            Self::Sheet { profile, .. } => vec![profile.name()],
        }
    }

    /// Whether it rises and falls many times.
    pub fn is_rough(&self) -> bool {
        match self {
            Self::Terms(terms) => terms.iter().any(Term::is_rough),
            Self::Sheet { profile: Profile::Wave { turns, .. }, .. } => *turns > 3.0,
            Self::Cells { .. } => true,
            _ => false,
        }
    }

    /// Whether it leaves out values between its ends.
    pub fn has_jump(&self) -> bool {
        match self {
            Self::Terms(terms) => terms.iter().any(Term::has_jump),
            Self::Cells { .. } | Self::Sheet { profile: Profile::Step { .. }, .. } => true,
            _ => false,
        }
    }
}

impl Hill {
    fn value(&self, t: &[f64]) -> f64 {
        let square: f64 = t.iter().zip(&self.centre).map(|(t, c)| (t - c) * (t - c)).sum();
        let inside = (1.0 - square / (self.radius * self.radius)).max(0.0);
        self.height * inside * inside
    }
}

impl Profile {
    fn value(self, x: f64) -> f64 {
        match self {
            Self::Ridge { at, width } => libm::exp(-((x - at) / width).powi(2)),
            Self::Kink { at } => -(x - at).abs(),
            Self::Step { at } => f64::from(u8::from(x > at)),
            Self::Wave { turns, phase } => libm::sin(TAU * turns * x + phase),
        }
    }

    fn name(self) -> &'static str {
        match self {
            Self::Ridge { .. } => "sheet-ridge",
            Self::Kink { .. } => "sheet-kink",
            Self::Step { .. } => "sheet-step",
            Self::Wave { .. } => "sheet-wave",
        }
    }
}

/// The lower one first.
fn sorted([a, b]: [Extreme; 2]) -> [Extreme; 2] {
    if a.value <= b.value { [a, b] } else { [b, a] }
}

fn of_terms(terms: &[Term], dimensions: usize) -> ([Extreme; 2], Vec<Feature>) {
    let sum = |t: &[f64]| terms.iter().map(|term| term.value(t)).sum();
    let inside = |at: &Vec<f64>| at.len() == dimensions && at.iter().all(|t| (0.0..=1.0).contains(t));
    let known: Vec<Vec<f64>> = terms.iter().flat_map(Term::places).filter(inside).collect();
    let curves: Vec<_> = terms.iter().filter_map(Term::curve).collect();
    let found = extremes(&sum, dimensions, &known, &curves);
    let mut features = Vec::new();
    add_features(terms, &found, dimensions, &mut features);
    (found, features)
}

/// Adds those of `terms` that set these extremes, a least and a greatest value, and are not there yet.
pub fn add_features(terms: &[Term], found: &[Extreme; 2], dimensions: usize, features: &mut Vec<Feature>) {
    for term in terms {
        let name = term.name();
        let at_ends = [0, 1].map(|end| term.value(&found[end].at));
        let above = |height: f64| share(dimensions, |t| term.value(t) / height > 0.5);
        let mut add = |height: f64, ends: [bool; 2]| {
            if features.iter().all(|other| other.name != name || other.height != height.abs()) {
                let above = above(height);
                let volume = if term.is_edge() { above.min(1.0 - above) } else { above };
                features.push(Feature { name, volume, height: height.abs(), ends });
            }
        };
        if matches!(term, Term::Rough { .. }) {
            // Its height is what it adds to an extreme.
            add(at_ends[0], [true, false]);
            add(at_ends[1], [false, true]);
        } else if let Some(height) = term.height() {
            let ends = at_ends.map(|value| term.is_edge() || (value / height).abs() > MIN_PART);
            if ends != [false; 2] {
                add(height, ends);
            }
        }
    }
}

fn of_hills(hills: &[Hill]) -> ([Extreme; 2], Vec<Feature>) {
    let dimensions = hills[0].centre.len();
    // A corner outside of all balls.
    let corners = (0..1_usize << dimensions)
        .map(|corner| (0..dimensions).map(|axis| if corner >> axis & 1 == 1 { 1.0 } else { 0.0 }).collect());
    let is_flat = |at: &Vec<f64>| hills.iter().all(|hill| hill.value(at) == 0.0);
    let flat = Extreme { value: 0.0, at: corners.into_iter().find(is_flat).expect("hills leave a corner of the box") };
    let tops = hills.iter().map(|hill| Extreme { value: hill.height, at: hill.centre.clone() });
    let all: Vec<Extreme> = tops.chain([flat]).collect();
    let least = all.iter().min_by(|a, b| a.value.total_cmp(&b.value)).expect("not empty").clone();
    let greatest = all.iter().max_by(|a, b| a.value.total_cmp(&b.value)).expect("not empty").clone();
    let feature = |hill: &Hill| Feature {
        name: if hill.height > 0.0 { "top" } else { "pit" },
        volume: ball_volume(&hill.centre, HALF_HEIGHT * hill.radius),
        height: hill.height.abs(),
        ends: [hill.height == least.value, hill.height == greatest.value],
    };
    let is_end = |hill: &&Hill| [least.value, greatest.value].contains(&hill.height);
    let features = hills.iter().filter(is_end).map(feature).collect();
    ([least, greatest], features)
}

fn of_cells(key: u64, per_axis: usize, height: f64, dimensions: usize) -> ([Extreme; 2], Vec<Feature>) {
    let count = per_axis.pow(dimensions as u32);
    let heights = || (0..count).map(|cell| (height * normal(key, cell as u64), cell));
    let least = heights().min_by(|a, b| a.0.total_cmp(&b.0)).expect("cells");
    let greatest = heights().max_by(|a, b| a.0.total_cmp(&b.0)).expect("cells");
    let middle = |cell: usize| {
        let along = |axis: usize| (cell / per_axis.pow(axis as u32) % per_axis) as f64 + 0.5;
        (0..dimensions).map(|axis| along(axis) / per_axis as f64).collect()
    };
    let ends = [least, greatest].map(|(value, cell)| Extreme { value, at: middle(cell) });
    let feature = |end: usize| {
        let (volume, height) = (1.0 / count as f64, ends[end].value.abs());
        Feature { name: "cell", volume, height, ends: [end == 0, end == 1] }
    };
    let features = [0, 1].map(feature).to_vec();
    (ends, features)
}

fn of_sheet(shape: &Shape, along: &[f64], height: f64, profile: Profile) -> ([Extreme; 2], Vec<Feature>) {
    let least: f64 = along.iter().map(|a| a.min(0.0)).sum();
    let most: f64 = along.iter().map(|a| a.max(0.0)).sum();
    let furthest = |at: f64| if at - least > most - at { least } else { most };
    // Where the profile is least and greatest.
    let ends = match profile {
        Profile::Ridge { at, .. } | Profile::Kink { at } => [furthest(at), at],
        Profile::Step { .. } => [least, most],
        Profile::Wave { turns, phase } => [0.75, 0.25].map(|turn| {
            // The first such place above the corner; over the box there is at least one turn.
            let start = turns * least + phase / TAU;
            (least * turns + (turn - start).rem_euclid(1.0)) / turns
        }),
    };
    // Along the diagonal from the one corner to the other.
    let place = |x: f64| {
        let share = ((x - least) / (most - least)).clamp(0.0, 1.0);
        along.iter().map(|a| if *a > 0.0 { share } else { 1.0 - share }).collect()
    };
    let ends = ends.map(|x| Extreme { value: height * profile.value(x), at: place(x) });
    let above = share(along.len(), |t| shape.value(t) / height > 0.5);
    let volume = match profile {
        Profile::Step { .. } => above.min(1.0 - above),
        _ => above,
    };
    let ends_set = match profile {
        Profile::Ridge { .. } => [height < 0.0, height > 0.0],
        _ => [true; 2],
    };
    let feature = Feature { name: profile.name(), volume, height: height.abs(), ends: ends_set };
    let features = if matches!(profile, Profile::Kink { .. }) { Vec::new() } else { vec![feature] };
    (sorted(ends), features)
}
