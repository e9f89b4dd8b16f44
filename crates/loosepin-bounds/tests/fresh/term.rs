//! What functions of one or two coordinates in the unit box are sums of.

use super::brute::Curve;

/// A summand; places are in the unit box, heights in the unit of the response.
#[derive(Debug, Clone)]
pub enum Term {
    /// slope · t.
    Linear { axis: usize, slope: f64 },
    /// height · (t - centre)².
    Square { axis: usize, centre: f64, height: f64 },
    /// height · (2 t1 - 1)(2 t2 - 1).
    Saddle { height: f64 },
    /// height · sin(2π · turns · a·t + phase), a of length 1.
    Wave { along: Vec<f64>, height: f64, turns: f64, phase: f64 },
    /// Many waves of one coordinate.
    Rough { waves: Vec<[f64; 3]> },
    /// height · exp(-|t - centre|²/width²).
    Bump { centre: Vec<f64>, width: f64, height: f64 },
    /// height · max(0, 1 - |t - centre|/width).
    Tent { centre: Vec<f64>, width: f64, height: f64 },
    /// height · exp(-(t2 - c(t1))²/width²) (1 - fall (t1 - top)²), c a parabola: its line is bent where the last coefficient is not 0.
    Ridge { line: [f64; 3], width: f64, height: f64, top: f64, fall: f64 },
    /// height where a·t > edge.
    Step { along: Vec<f64>, edge: f64, height: f64 },
    /// height where the coordinate is in the strip.
    Strip { axis: usize, from: f64, to: f64, height: f64 },
    /// -height · |a·t - edge|, a of length 1.
    Kink { along: Vec<f64>, edge: f64, height: f64 },
}

/// a·b.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

impl Term {
    /// Its value at a place of the unit box.
    pub fn value(&self, t: &[f64]) -> f64 {
        match self {
            Self::Linear { axis, slope } => slope * t[*axis],
            Self::Square { axis, centre, height } => height * (t[*axis] - centre) * (t[*axis] - centre),
            Self::Saddle { height } => height * (2.0 * t[0] - 1.0) * (2.0 * t[1] - 1.0),
            Self::Wave { along, height, turns, phase } => {
                height * libm::sin(std::f64::consts::TAU * turns * dot(along, t) + phase)
            }
            Self::Rough { waves } => {
                waves.iter().map(|[height, turns, phase]| height * libm::sin(turns * t[0] + phase)).sum()
            }
            Self::Bump { centre, width, height } => {
                let r = distance(t, centre) / width;
                height * libm::exp(-r * r)
            }
            Self::Tent { centre, width, height } => height * (1.0 - distance(t, centre) / width).max(0.0),
            Self::Ridge { line: [a, b, c], width, height, top, fall } => {
                let across = (t[1] - (a + b * t[0] + c * t[0] * t[0])) / width;
                height * libm::exp(-across * across) * (1.0 - fall * (t[0] - top) * (t[0] - top))
            }
            Self::Step { along, edge, height } => {
                if dot(along, t) > *edge {
                    *height
                } else {
                    0.0
                }
            }
            Self::Strip { axis, from, to, height } => {
                if (*from..=*to).contains(&t[*axis]) {
                    *height
                } else {
                    0.0
                }
            }
            Self::Kink { along, edge, height } => -height * (dot(along, t) - edge).abs(),
        }
    }

    /// In one word.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Linear { .. } => "linear",
            Self::Square { .. } => "square",
            Self::Saddle { .. } => "saddle",
            Self::Wave { turns, .. } if *turns > 40.0 => "fast-ripple",
            Self::Wave { .. } => "wave",
            Self::Rough { .. } => "rough",
            Self::Bump { .. } => "bump",
            Self::Tent { .. } => "tent",
            Self::Ridge { line, .. } if line[2] != 0.0 => "curved-ridge",
            Self::Ridge { .. } => "ridge",
            Self::Step { .. } => "step",
            Self::Strip { .. } => "strip",
            Self::Kink { .. } => "kink",
        }
    }

    /// Its height where it is a feature, something that may be overlooked; `None` if it is a trend, or where that depends on the extreme.
    pub fn height(&self) -> Option<f64> {
        match self {
            Self::Linear { .. }
            | Self::Square { .. }
            | Self::Saddle { .. }
            | Self::Kink { .. }
            | Self::Rough { .. } => None,
            Self::Wave { turns, .. } if *turns <= 3.0 => None,
            Self::Wave { height, .. }
            | Self::Bump { height, .. }
            | Self::Tent { height, .. }
            | Self::Ridge { height, .. }
            | Self::Step { height, .. }
            | Self::Strip { height, .. } => Some(*height),
        }
    }

    /// Whether both sides of it must be seen.
    pub fn is_edge(&self) -> bool {
        matches!(self, Self::Step { .. })
    }

    /// Whether it rises and falls many times.
    pub fn is_rough(&self) -> bool {
        matches!(self, Self::Rough { .. }) || matches!(self, Self::Wave { turns, .. } if *turns > 3.0)
    }

    /// Whether it has jumps.
    pub fn has_jump(&self) -> bool {
        matches!(self, Self::Step { .. } | Self::Strip { .. })
    }

    /// Places where a sum with this term may have a sharp extreme.
    pub fn places(&self) -> Vec<Vec<f64>> {
        /// So near to either side of an edge, a function has its limit there within the tolerance of exact bounds.
        const BESIDE: f64 = 1e-14;
        match self {
            Self::Bump { centre, .. } | Self::Tent { centre, .. } => vec![centre.clone()],
            Self::Strip { from, to, .. } => {
                [*from, *to].iter().flat_map(|edge| [*edge, edge - BESIDE, edge + BESIDE]).map(|at| vec![at]).collect()
            }
            Self::Step { along, edge, .. } if along.len() == 1 => {
                [*edge, edge - BESIDE, edge + BESIDE].iter().map(|at| vec![*at]).collect()
            }
            Self::Kink { along, edge, .. } if along.len() == 1 => vec![vec![*edge]],
            _ => Vec::new(),
        }
    }

    /// The line in the unit square on which a sum with this term may have a sharp extreme; along it goes a number in \[0, 1\].
    pub fn curve(&self) -> Option<Curve> {
        match self {
            Self::Ridge { line: [a, b, c], .. } => {
                let [a, b, c] = [*a, *b, *c];
                Some(Box::new(move |s| vec![s, (a + b * s + c * s * s).clamp(0.0, 1.0)]))
            }
            Self::Kink { along, edge, .. } if along.len() == 2 => {
                // a·t = edge, by the coordinate along which it is less steep.
                let (a, edge) = (along.clone(), *edge);
                let first = usize::from(a[0].abs() > a[1].abs());
                Some(Box::new(move |s| {
                    let mut t = vec![s; 2];
                    t[1 - first] = ((edge - a[first] * s) / a[1 - first]).clamp(0.0, 1.0);
                    t
                }))
            }
            _ => None,
        }
    }
}
