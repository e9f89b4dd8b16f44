//! The shapes of a beam: what of it does not depend on its length, section and material.

use super::functions::{Frame, axial, lateral};
use super::spectrum::{eigenvalues, root_damping};
use loosepin_math::legendre_rule;

/// Numbers that are round-off of a zero at an end of the beam.
const ROUND_OFF: f64 = 1e-12;

/// The shapes at one place along the beam, s = x/L.
#[derive(Debug, Clone, PartialEq)]
pub struct Station {
    /// s.
    pub share: f64,
    /// ψ of the axial shapes.
    pub axial: Vec<f64>,
    /// φ/L of the lateral shapes.
    pub lateral: Vec<f64>,
    /// φ' = dφ/dx of the lateral shapes.
    pub slopes: Vec<f64>,
    /// H/L of (F1), ∫₀ˢ φ_i' φ_j' ds, row by row.
    pub shortening: Vec<f64>,
}

/// A place that carries a share of the mass.
#[derive(Debug, Clone, PartialEq)]
pub struct MassPoint {
    /// The shapes there.
    pub station: Station,
    /// Share of the mass of the beam.
    pub weight: f64,
}

/// Shapes, and the matrices that follow from them, all without dimension.
///
/// Axial coordinates a are lengths: displacement ψ·a. Lateral coordinates b are angles: displacement φ·b with φ/L a function of s alone,
/// so that everything here is the same for all lengths. A sine sin(iπx/L) of amplitude w is the coordinate b_i = iπw/L.
#[derive(Debug, Clone, PartialEq)]
pub struct Shapes {
    axial: usize,
    lateral: usize,
    /// Where the mass sits: points of Gauss. Mass matrix and bias forces of finitely many points belong to one and the same kinetic
    /// energy, so that energy and momenta are exact whatever their number.
    pub points: Vec<MassPoint>,
    /// The end at s = 0.
    pub root: Station,
    /// The end at s = 1.
    pub tip: Station,
    /// ∫ψ'ψ'ᵀ, to be multiplied with EA/L.
    pub axial_stiffness: Vec<f64>,
    /// ∫φ''φ''ᵀ of φ' over s, to be multiplied with EI/L.
    pub bending_stiffness: Vec<f64>,
    /// Damping of a ratio of one half, to be multiplied with √(EA m/L).
    pub axial_damping: Vec<f64>,
    /// Damping of a ratio of one half, to be multiplied with √(EI m L).
    pub bending_damping: Vec<f64>,
}

/// Values of an axial shape by its index and s: ψ and dψ/ds.
pub type AxialFunction<'f> = &'f dyn Fn(usize, f64) -> [f64; 2];
/// Values of a lateral shape by its index and s: φ/L, φ' and dφ'/ds.
pub type LateralFunction<'f> = &'f dyn Fn(usize, f64) -> [f64; 3];

impl Shapes {
    /// The shapes of a frame: axial s, sin(πs), sin(2πs), …; lateral those of [`Frame`].
    ///
    /// Points: 8 and four for each further shape of the kind that has more of them, which leaves 1e-10 of the integrals for one shape
    /// and round-off from two on.
    pub fn new(frame: Frame, axial_count: usize, lateral_count: usize) -> Self {
        let points = point_count(axial_count, lateral_count);
        let lateral = |index, s| lateral(frame, index, s);
        Self::from_functions((axial_count, &axial), (lateral_count, &lateral), points)
    }

    /// Any shapes that vanish at the root, with the number of each kind, and a number of points of Gauss.
    pub fn from_functions(
        (axial_count, axial): (usize, AxialFunction<'_>),
        (lateral_count, lateral): (usize, LateralFunction<'_>),
        points: usize,
    ) -> Self {
        let gauss = gauss_points(points);
        let station = |share: f64| station(share, (axial_count, axial), (lateral_count, lateral), &gauss);
        let mass_points: Vec<MassPoint> =
            gauss.iter().map(|&[share, weight]| MassPoint { station: station(share), weight }).collect();
        let integral = |count: usize, value: &dyn Fn(usize, f64) -> f64| {
            let mut matrix = vec![0.0; count * count];
            for (place, entry) in matrix.iter_mut().enumerate() {
                let (i, j) = (place / count, place % count);
                *entry = gauss.iter().map(|&[s, weight]| weight * value(i, s) * value(j, s)).sum();
            }
            matrix
        };
        let axial_stiffness = integral(axial_count, &|i, s| axial(i, s)[1]);
        let bending_stiffness = integral(lateral_count, &|i, s| lateral(i, s)[2]);
        let axial_mass = integral(axial_count, &|i, s| axial(i, s)[0]);
        let lateral_mass = integral(lateral_count, &|i, s| lateral(i, s)[0]);
        Self {
            axial: axial_count,
            lateral: lateral_count,
            root: cleaned(station(0.0)),
            tip: cleaned(station(1.0)),
            axial_damping: root_damping(&axial_mass, &axial_stiffness, axial_count),
            bending_damping: root_damping(&lateral_mass, &bending_stiffness, lateral_count),
            points: mass_points,
            axial_stiffness,
            bending_stiffness,
        }
    }

    /// Number of axial shapes.
    pub fn axial(&self) -> usize {
        self.axial
    }

    /// Number of lateral shapes.
    pub fn lateral(&self) -> usize {
        self.lateral
    }

    /// Number of coordinates q: axial ones, then lateral ones.
    pub fn count(&self) -> usize {
        self.axial + self.lateral
    }

    /// Squares of the natural frequencies with the frame held, ascending: axial ones in units of EA/(m L), lateral ones in units of
    /// EI/(m L³).
    pub fn squared_frequencies(&self) -> [Vec<f64>; 2] {
        let mass = |count: usize, value: &dyn Fn(&Station, usize) -> f64| {
            let entry = |place: usize| {
                let product = |point: &MassPoint| {
                    point.weight * value(&point.station, place / count) * value(&point.station, place % count)
                };
                self.points.iter().map(product).sum()
            };
            (0..count * count).map(entry).collect::<Vec<f64>>()
        };
        let axial = mass(self.axial, &|station, k| station.axial[k]);
        let lateral = mass(self.lateral, &|station, k| station.lateral[k]);
        [
            eigenvalues(&axial, &self.axial_stiffness, self.axial),
            eigenvalues(&lateral, &self.bending_stiffness, self.lateral),
        ]
    }
}

/// The shapes of a frame at places along the beam.
pub fn stations(frame: Frame, axial_count: usize, lateral_count: usize, shares: &[f64]) -> Vec<Station> {
    let gauss = gauss_points(point_count(axial_count, lateral_count));
    let lateral = |index, s| lateral(frame, index, s);
    shares.iter().map(|share| station(*share, (axial_count, &axial), (lateral_count, &lateral), &gauss)).collect()
}

/// Points of Gauss for the shapes of a frame.
fn point_count(axial_count: usize, lateral_count: usize) -> usize {
    8 + 4 * axial_count.max(lateral_count)
}

/// Shares of a beam and their weights: the Gauss rule on [0, 1].
fn gauss_points(points: usize) -> Vec<[f64; 2]> {
    legendre_rule(points).into_iter().map(|(t, weight)| [0.5 * (1.0 + t), weight]).collect()
}

fn station(
    share: f64,
    (axial_count, axial): (usize, AxialFunction<'_>),
    (lateral_count, lateral): (usize, LateralFunction<'_>),
    gauss: &[[f64; 2]],
) -> Station {
    let mut shortening = vec![0.0; lateral_count * lateral_count];
    for &[within, weight] in gauss {
        let slopes: Vec<f64> = (0..lateral_count).map(|i| lateral(i, share * within)[1]).collect();
        for (place, entry) in shortening.iter_mut().enumerate() {
            *entry += share * weight * slopes[place / lateral_count] * slopes[place % lateral_count];
        }
    }
    Station {
        share,
        axial: (0..axial_count).map(|k| axial(k, share)[0]).collect(),
        lateral: (0..lateral_count).map(|i| lateral(i, share)[0]).collect(),
        slopes: (0..lateral_count).map(|i| lateral(i, share)[1]).collect(),
        shortening,
    }
}

/// Zeros and ones at an end, where they are off by round-off.
fn cleaned(mut station: Station) -> Station {
    for values in [&mut station.axial, &mut station.lateral, &mut station.slopes, &mut station.shortening] {
        for value in values.iter_mut() {
            if (*value - value.round()).abs() < ROUND_OFF {
                *value = value.round() + 0.0;
            }
        }
    }
    station
}
