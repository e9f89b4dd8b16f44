//! Elements, nodes and points of integration: what does not depend on length, section and material.

use loosepin_math::{Real, Vec2, legendre_rule, numbers};

/// Two vectors at a node: its position r, m, and slope r' = ∂r/∂x; or their rates, their accelerations, or the forces on them (N, N m).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nodal<T> {
    /// Vector of the position.
    pub position: Vec2<T>,
    /// Vector of the slope.
    pub slope: Vec2<T>,
}

numbers!(struct Nodal { position, slope });

impl<T: Real> Nodal<T> {
    /// Both vectors zero.
    pub fn zero() -> Self {
        Self { position: Vec2::zero(), slope: Vec2::zero() }
    }
}

/// Points of Gauss in each element. The rule belongs to the model: |r'| is no polynomial, so that another rule is another beam.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rule {
    /// 5 points for the stretch, 3 for the bending.
    #[default]
    Full,
    /// 3 and 2 points: coarse meshes are less stiff (membrane locking). Two for the stretch would leave a motion without stiffness.
    Reduced,
}

impl Rule {
    /// Points for the stretch and for the bending.
    pub fn points(self) -> [usize; 2] {
        match self {
            Self::Full => [5, 3],
            Self::Reduced => [3, 2],
        }
    }
}

/// The functions of an element at one of its points ξ = x/l.
///
/// ```text
/// r'    = chord (r1 - r0)/l + first r0' + last r1'
/// l r'' = bend_chord (r1 - r0)/l + bend_first r0' + bend_last r1'
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Point {
    /// Weight of the point; those of an element add to one.
    pub(super) weight: f64,
    /// 6ξ - 6ξ².
    pub(super) chord: f64,
    /// 1 - 4ξ + 3ξ².
    pub(super) first: f64,
    /// -2ξ + 3ξ².
    pub(super) last: f64,
    /// 6 - 12ξ.
    pub(super) bend_chord: f64,
    /// -4 + 6ξ.
    pub(super) bend_first: f64,
    /// -2 + 6ξ.
    pub(super) bend_last: f64,
}

impl Point {
    pub(super) fn at(xi: f64, weight: f64) -> Self {
        Self {
            weight,
            chord: 6.0 * xi * (1.0 - xi),
            first: (1.0 - xi) * (1.0 - 3.0 * xi),
            last: xi * (3.0 * xi - 2.0),
            bend_chord: 6.0 - 12.0 * xi,
            bend_first: 6.0 * xi - 4.0,
            bend_last: 6.0 * xi - 2.0,
        }
    }
}

/// Elements of equal length along a beam.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    elements: usize,
    /// Points for the stretch.
    pub(super) axial: Vec<Point>,
    /// Points for the bending.
    pub(super) bending: Vec<Point>,
}

impl Mesh {
    /// `elements` >= 1 elements with a rule.
    pub fn new(elements: usize, rule: Rule) -> Self {
        let [axial, bending] = rule.points();
        Self::with_points(elements, axial, bending)
    }

    /// As [`Mesh::new`], with any numbers of points for stretch and bending.
    pub fn with_points(elements: usize, axial: usize, bending: usize) -> Self {
        let points = |count: usize| {
            let rule = legendre_rule(count).into_iter();
            rule.map(|(t, weight)| Point::at(0.5 * (1.0 + t), weight)).collect()
        };
        Self { elements, axial: points(axial), bending: points(bending) }
    }

    /// Number of elements.
    pub fn elements(&self) -> usize {
        self.elements
    }

    /// Element at the share `s` of the length, and the place ξ in it, from 0 to 1.
    pub(super) fn place(&self, s: f64) -> (usize, f64) {
        let at = s * self.elements as f64;
        let element = (at.max(0.0) as usize).min(self.elements - 1);
        (element, at - element as f64)
    }

    /// Number of nodes: one more.
    pub fn nodes(&self) -> usize {
        self.elements + 1
    }
}
