//! Functions of a few coordinates of the unit box with known extremes.

use super::brute::extremes;
use super::feature::{Feature, ball_volume, share};
use super::term::{Term, dot};
use loosepin_uncertainty::normal;

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
    /// Features at either of them.
    pub features: Vec<Feature>,
}

/// A feature sets an extreme where it is more than this share of its height there.
const LEAST_PART: f64 = 0.05;
/// Radius at which (1 - r²)² is a half.
pub const HALF_HEIGHT: f64 = 0.541_196_100_146_197;

impl Group {
    /// With extremes and features worked out.
    pub fn new(axes: Vec<usize>, shape: Shape) -> Self {
        let dimensions = axes.len();
        let (ends, features) = match &shape {
            Shape::Terms(terms) => of_terms(terms, dimensions),
            Shape::Hill { centre, height, .. } => {
                let corner: Vec<f64> = centre.iter().map(|c| if *c > 0.5 { 0.0 } else { 1.0 }).collect();
                let volume = share(dimensions, |t| shape.value(t) / height > 0.5);
                let feature = Feature { name: "hill", volume, height: height.abs() };
                (sorted([shape.value(&corner), *height]), vec![feature])
            }
            Shape::Hills(hills) => of_hills(hills),
            Shape::Cells { key, per_axis, height } => {
                let count = per_axis.pow(dimensions as u32);
                let heights = (0..count).map(|cell| height * normal(*key, cell as u64));
                let ends = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], h| [a.min(h), b.max(h)]);
                let feature = |end: f64| Feature { name: "cell", volume: 1.0 / count as f64, height: end.abs() };
                (ends, ends.map(feature).to_vec())
            }
            Shape::Sheet { along, height, profile } => of_sheet(&shape, along, *height, *profile),
        };
        Self { axes, shape, ends, features }
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
            Self::Wave { turns, phase } => libm::sin(std::f64::consts::TAU * turns * x + phase),
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

fn sorted([a, b]: [f64; 2]) -> [f64; 2] {
    [a.min(b), a.max(b)]
}

fn of_terms(terms: &[Term], dimensions: usize) -> ([f64; 2], Vec<Feature>) {
    let sum = |t: &[f64]| terms.iter().map(|term| term.value(t)).sum();
    let inside = |at: &Vec<f64>| at.len() == dimensions && at.iter().all(|t| (0.0..=1.0).contains(t));
    let known: Vec<Vec<f64>> = terms.iter().flat_map(Term::places).filter(inside).collect();
    let curves: Vec<_> = terms.iter().filter_map(Term::curve).collect();
    let found = extremes(&sum, dimensions, &known, &curves);
    let mut features = Vec::new();
    for term in terms {
        let at_ends = found.iter().map(|end| term.value(&end.at));
        if matches!(term, Term::Rough { .. }) {
            // Its height is what it adds to an extreme.
            for height in at_ends {
                let volume = share(dimensions, |t| term.value(t) / height > 0.5);
                features.push(Feature { name: term.name(), volume, height: height.abs() });
            }
        } else if let Some(height) = term.height() {
            let mut parts = at_ends.map(|value| (value / height).abs());
            if term.is_edge() || parts.any(|part| part > LEAST_PART) {
                let above = share(dimensions, |t| term.value(t) / height > 0.5);
                let volume = if term.is_edge() { above.min(1.0 - above) } else { above };
                features.push(Feature { name: term.name(), volume, height: height.abs() });
            }
        }
    }
    (found.map(|end| end.value), features)
}

fn of_hills(hills: &[Hill]) -> ([f64; 2], Vec<Feature>) {
    let heights = || hills.iter().map(|hill| hill.height);
    let ends = [heights().fold(0.0, f64::min), heights().fold(0.0, f64::max)];
    let feature = |hill: &Hill| Feature {
        name: if hill.height > 0.0 { "top" } else { "pit" },
        volume: ball_volume(&hill.centre, HALF_HEIGHT * hill.radius),
        height: hill.height.abs(),
    };
    (ends, hills.iter().filter(|hill| ends.contains(&hill.height)).map(feature).collect())
}

fn of_sheet(shape: &Shape, along: &[f64], height: f64, profile: Profile) -> ([f64; 2], Vec<Feature>) {
    let least: f64 = along.iter().map(|a| a.min(0.0)).sum();
    let most: f64 = along.iter().map(|a| a.max(0.0)).sum();
    let at_corners = [least, most].map(|x| profile.value(x));
    let ends = match profile {
        Profile::Ridge { .. } => [at_corners[0].min(at_corners[1]), 1.0],
        Profile::Kink { .. } => [at_corners[0].min(at_corners[1]), 0.0],
        Profile::Step { .. } => [0.0, 1.0],
        Profile::Wave { .. } => [-1.0, 1.0],
    };
    let above = share(along.len(), |t| shape.value(t) / height > 0.5);
    let volume = match profile {
        Profile::Step { .. } => above.min(1.0 - above),
        _ => above,
    };
    let feature = Feature { name: profile.name(), volume, height: height.abs() };
    let features = if matches!(profile, Profile::Kink { .. }) { Vec::new() } else { vec![feature] };
    (sorted(ends.map(|end| height * end)), features)
}
