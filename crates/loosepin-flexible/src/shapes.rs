//! The shapes of a beam: what of it does not depend on its length, section and material.

use super::basis::Basis;
use super::functions::Frame;
use super::point_shapes::span_rule;
use super::spectrum::{eigenvalues, root_damping};
use super::station::{AxialFunction, LateralFunction, Station};

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
    /// Distribution of the mass: Gauss points. Mass matrix and bias forces of finitely many points belong to one and the same kinetic
    /// energy, so that energy and momenta are exact whatever their number.
    pub points: Vec<MassPoint>,
    /// The end at s = 0.
    pub root: Station,
    /// The end at s = 1.
    pub tip: Station,
    /// Places inside, as many as were asked for.
    pub inside: Vec<Station>,
    /// ∫ψ'ψ'ᵀ, to be multiplied with EA/L.
    pub axial_stiffness: Vec<f64>,
    /// ∫φ''φ''ᵀ of φ' over s, to be multiplied with EI/L.
    pub bending_stiffness: Vec<f64>,
    /// Damping of a ratio of one half, to be multiplied with √(EA m/L).
    pub axial_damping: Vec<f64>,
    /// Damping of a ratio of one half, to be multiplied with √(EI m L).
    pub bending_damping: Vec<f64>,
}

impl Shapes {
    /// The shapes of a frame without points inside: axial s, sin(πs), sin(2πs), …; lateral those of [`Frame`].
    pub fn new(frame: Frame, axial_count: usize, lateral_count: usize) -> Self {
        Self::of(&Basis::new(frame, [axial_count, lateral_count], &[]), &[])
    }

    /// The shapes of a basis, with their values at the shares `inside`.
    pub fn of(basis: &Basis, inside: &[f64]) -> Self {
        let spans = basis.spans();
        let rule: Vec<[f64; 2]> = spans.iter().flat_map(|span| span_rule(span.start, span.end, span.points)).collect();
        Self::assembled(
            [basis.axial_count(), basis.lateral_count()],
            (&|index, s| basis.axial(index, s), &|index, s| basis.lateral(index, s)),
            &|share| basis.station(share, &spans),
            &rule,
            inside,
        )
    }

    /// Any smooth shapes that vanish at the root, with the number of each kind, and a number of points of Gauss.
    pub fn from_functions(
        (axial_count, axial): (usize, AxialFunction<'_>),
        (lateral_count, lateral): (usize, LateralFunction<'_>),
        points: usize,
    ) -> Self {
        let rule: Vec<[f64; 2]> = span_rule(0.0, 1.0, points).collect();
        let station = |share: f64| {
            let up_to = rule.iter().map(|&[within, weight]| [share * within, share * weight]);
            Station::at(share, (axial_count, axial), (lateral_count, lateral), up_to)
        };
        Self::assembled([axial_count, lateral_count], (axial, lateral), &station, &rule, &[])
    }

    fn assembled(
        [axial_count, lateral_count]: [usize; 2],
        (axial, lateral): (AxialFunction<'_>, LateralFunction<'_>),
        station: &dyn Fn(f64) -> Station,
        rule: &[[f64; 2]],
        inside: &[f64],
    ) -> Self {
        let mass_points: Vec<MassPoint> =
            rule.iter().map(|&[share, weight]| MassPoint { station: station(share), weight }).collect();
        let integral = |count: usize, value: &dyn Fn(usize, f64) -> f64| {
            let mut matrix = vec![0.0; count * count];
            for (place, entry) in matrix.iter_mut().enumerate() {
                let (i, j) = (place / count, place % count);
                *entry = rule.iter().map(|&[s, weight]| weight * value(i, s) * value(j, s)).sum();
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
            root: station(0.0).cleaned(),
            tip: station(1.0).cleaned(),
            inside: inside.iter().map(|share| station(*share).cleaned()).collect(),
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
