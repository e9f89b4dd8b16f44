//! Functions of a few coordinates of the unit box with known extremes.

use super::brute::{Extreme, extremes};
use super::term::Term;
use loosepin_uncertainty::{hash, normal, uniform};

/// What a group does with its coordinates.
#[derive(Debug, Clone)]
pub enum Shape {
    /// A sum over one or two coordinates; extremes by brute force.
    Terms(Vec<Term>),
    /// exp(-Σ ((t - c)/w)²) times height: greatest at c, least in the furthest corner.
    Hill { centre: Vec<f64>, widths: Vec<f64>, height: f64 },
    /// Hills and pits height · (1 - |t - c|²/w²)² inside of balls that have nothing in common, 0 outside of all.
    Hills(Vec<Hill>),
    /// Constant in each of `per_axis` to the power of the dimension cells, normal heights: all are looked at.
    Cells { key: u64, per_axis: usize, height: f64 },
    /// height where a·t > edge: both sides are in the box.
    Halves { along: Vec<f64>, edge: f64, height: f64 },
}

/// A hill, or a pit where its height is negative.
#[derive(Debug, Clone)]
pub struct Hill {
    pub centre: Vec<f64>,
    pub radius: f64,
    pub height: f64,
}

/// Something that may be overlooked and that sets an extreme.
#[derive(Debug, Clone)]
pub struct Feature {
    pub name: &'static str,
    /// Share of the unit box in which it is above half of its height; of an edge the smaller side.
    pub volume: f64,
    /// Its height, > 0.
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
/// Points that volumes are measured with.
const VOLUME_POINTS: u64 = 40_000;
/// Radius at which (1 - r²)² is a half.
const HALF_HEIGHT: f64 = 0.541_196_100_146_197;

impl Group {
    pub fn new(axes: Vec<usize>, shape: Shape) -> Self {
        let dimensions = axes.len();
        let (ends, features) = match &shape {
            Shape::Terms(terms) => of_terms(terms, dimensions),
            Shape::Hill { centre, widths, height } => {
                let corner: Vec<f64> = centre.iter().map(|c| if *c > 0.5 { 0.0 } else { 1.0 }).collect();
                let (edge, top) = (shape.value(&corner), *height);
                let ends = [edge.min(top), edge.max(top)];
                let volume = share(dimensions, |t| {
                    let square: f64 = t.iter().zip(centre).zip(widths).map(|((t, c), w)| ((t - c) / w).powi(2)).sum();
                    square < std::f64::consts::LN_2
                });
                (ends, vec![Feature { name: "hill", volume, height: height.abs() }])
            }
            Shape::Hills(hills) => {
                let heights = || hills.iter().map(|hill| hill.height);
                let ends = [heights().fold(0.0, f64::min), heights().fold(0.0, f64::max)];
                let setting = hills.iter().filter(|hill| ends.contains(&hill.height));
                let features = setting.map(|hill| Feature {
                    name: if hill.height > 0.0 { "top" } else { "pit" },
                    volume: hill.volume(),
                    height: hill.height.abs(),
                });
                (ends, features.collect())
            }
            Shape::Cells { key, per_axis, height } => {
                let count = per_axis.pow(dimensions as u32);
                let heights = (0..count).map(|cell| height * normal(*key, cell as u64));
                let ends = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], h| [a.min(h), b.max(h)]);
                let feature = |end: f64| Feature { name: "cell", volume: 1.0 / count as f64, height: end.abs() };
                (ends, ends.map(feature).to_vec())
            }
            Shape::Halves { along, edge, height } => {
                let above = share(dimensions, |t| t.iter().zip(along).map(|(t, a)| t * a).sum::<f64>() > *edge);
                let feature = Feature { name: "halves", volume: above.min(1.0 - above), height: height.abs() };
                ([height.min(0.0), height.max(0.0)], vec![feature])
            }
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

    pub fn width(&self) -> f64 {
        self.ends[1] - self.ends[0]
    }
}

impl Hill {
    /// Share of the unit box in which it is above half of its height.
    fn volume(&self) -> f64 {
        // The ball of that radius by points of the cube around it.
        let (k, radius) = (self.centre.len(), HALF_HEIGHT * self.radius);
        let inside = (0..VOLUME_POINTS).filter(|&point| {
            let offsets: Vec<f64> =
                (0..k as u64).map(|axis| radius * (2.0 * uniform(hash(7, point), axis) - 1.0)).collect();
            let is_in_ball = offsets.iter().map(|offset| offset * offset).sum::<f64>() <= radius * radius;
            is_in_ball && offsets.iter().zip(&self.centre).all(|(offset, c)| (0.0..=1.0).contains(&(c + offset)))
        });
        inside.count() as f64 / VOLUME_POINTS as f64 * (2.0 * radius).powi(k as i32)
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
            Self::Hills(hills) => hills
                .iter()
                .map(|hill| {
                    let square: f64 = t.iter().zip(&hill.centre).map(|(t, c)| (t - c).powi(2)).sum();
                    let inside = (1.0 - square / (hill.radius * hill.radius)).max(0.0);
                    hill.height * inside * inside
                })
                .sum(),
            Self::Cells { key, per_axis, height } => {
                let cell = t
                    .iter()
                    .rev()
                    .fold(0, |cell, t| cell * per_axis + ((t * *per_axis as f64) as usize).min(per_axis - 1));
                height * normal(*key, cell as u64)
            }
            Self::Halves { along, edge, height } => {
                if t.iter().zip(along).map(|(t, a)| t * a).sum::<f64>() > *edge {
                    *height
                } else {
                    0.0
                }
            }
        }
    }

    /// Words for what it is made of.
    pub fn names(&self) -> Vec<&'static str> {
        match self {
            Self::Terms(terms) => terms.iter().map(Term::name).collect(),
            Self::Hill { .. } => vec!["hill"],
            Self::Hills(_) => vec!["hills"],
            Self::Cells { .. } => vec!["cells"],
            Self::Halves { .. } => vec!["halves"],
        }
    }

    pub fn is_rough(&self) -> bool {
        match self {
            Self::Terms(terms) => terms.iter().any(Term::is_rough),
            Self::Cells { .. } => true,
            _ => false,
        }
    }

    pub fn has_jump(&self) -> bool {
        match self {
            Self::Terms(terms) => terms.iter().any(Term::has_jump),
            Self::Cells { .. } | Self::Halves { .. } => true,
            _ => false,
        }
    }
}

/// Share of the unit box in which something holds.
fn share(dimensions: usize, holds: impl Fn(&[f64]) -> bool) -> f64 {
    let mut t = vec![0.0; dimensions];
    let held = (0..VOLUME_POINTS).filter(|&point| {
        for (axis, t) in t.iter_mut().enumerate() {
            *t = if axis == 0 {
                (point as f64 + 0.5) / VOLUME_POINTS as f64
            } else {
                uniform(hash(8, point), axis as u64)
            };
        }
        holds(&t)
    });
    held.count() as f64 / VOLUME_POINTS as f64
}

fn of_terms(terms: &[Term], dimensions: usize) -> ([f64; 2], Vec<Feature>) {
    let sum = |t: &[f64]| terms.iter().map(|term| term.value(t)).sum();
    let inside = |at: &Vec<f64>| at.len() == dimensions && at.iter().all(|t| (0.0..=1.0).contains(t));
    let known: Vec<Vec<f64>> = terms.iter().flat_map(Term::places).filter(inside).collect();
    let curves: Vec<_> = terms.iter().filter_map(Term::curve).collect();
    let found: [Extreme; 2] = extremes(&sum, dimensions, &known, &curves);
    let mut features = Vec::new();
    for term in terms {
        let Some(height) = term.height() else { continue };
        let part = |end: &Extreme| (term.value(&end.at) / height).abs();
        if term.is_edge() || found.iter().any(|end| part(end) > LEAST_PART) {
            let above = share(dimensions, |t| term.value(t) / height > 0.5);
            let volume = if term.is_edge() { above.min(1.0 - above) } else { above };
            features.push(Feature { name: term.name(), volume, height: height.abs() });
        }
    }
    (found.map(|end| end.value), features)
}
