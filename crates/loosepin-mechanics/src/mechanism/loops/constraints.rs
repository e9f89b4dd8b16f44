//! The constraints of ideal joints that close loops and of couplings: residual, Jacobian and acceleration bias.

use crate::mechanism::row::{cut_biases, cut_gradient, cut_jacobian, cut_residuals, turn_rad};
use crate::mechanism::tree::kinematics::Kinematics;
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::Tree;
use crate::model::{JointId, Model, Row, describe_path};
use loosepin_math::{Real, Vec2};
use loosepin_text::units::{Dimension, format_value};
use std::fmt;

/// Residuals Φ of all cut joints, in their order: m for points that should coincide or lie on a line or a circle, sine of the
/// angle for bodies that should not turn against each other. Then those of all couplings, rad or m.
#[inline(never)]
pub fn residuals<T: Real>(tree: &Tree, geometry: &TreeNumbers<T>, kinematics: &Kinematics<T>, out: &mut [T]) {
    let cut_rows = cut_residuals(tree, geometry, kinematics, out);
    for ((places, numbers), out) in tree.couplings.iter().zip(&geometry.couplings).zip(&mut out[cut_rows..]) {
        *out = numbers.residual(places, kinematics);
    }
}

/// The Jacobian dΦ/dz, row-major, `tree.constraint_rows()` × `tree.coordinates()` (driven coordinates last).
#[inline(never)]
pub fn jacobian<T: Real>(tree: &Tree, geometry: &TreeNumbers<T>, kinematics: &Kinematics<T>, out: &mut [T]) {
    let columns = tree.coordinates();
    out.fill(T::zero());
    let cut_rows = cut_jacobian(tree, geometry, kinematics, out);
    let of_couplings = out[cut_rows * columns..].chunks_exact_mut(columns.max(1));
    for ((places, numbers), out) in tree.couplings.iter().zip(&geometry.couplings).zip(of_couplings) {
        numbers.add_gradient(places, tree, kinematics, out);
    }
}

/// dΦ for a motion of the bodies that `moves` names, each with a velocity of the origin of its frame and an angular velocity.
/// A cut both of whose bodies move does not feel it where they move as one.
#[inline(never)]
pub fn gradient<T: Real>(
    tree: &Tree,
    geometry: &TreeNumbers<T>,
    kinematics: &Kinematics<T>,
    moves: impl Fn(usize) -> bool,
    motion: impl Fn(usize) -> (Vec2<T>, T),
    out: &mut [T],
) {
    out.fill(T::zero());
    let cut_rows = cut_gradient(tree, geometry, kinematics, &moves, &motion, out);
    let of = |slot: usize| if moves(slot) { motion(slot) } else { (Vec2::zero(), T::zero()) };
    for ((places, numbers), out) in tree.couplings.iter().zip(&geometry.couplings).zip(&mut out[cut_rows..]) {
        let [first, second] =
            [0, 1].map(|side| numbers.joints[side].rate(&places[side], kinematics, places[side].slots.map(of)));
        *out = second - numbers.slope(places, kinematics) * first;
    }
}

/// Cosine of the angle between the bodies of the cut whose rows begin at `row`, which may be ±1 where they do not turn against
/// each other: its multiplier is a moment over it.
#[inline(always)]
pub fn turn_cosine<T: Real>(tree: &Tree, geometry: &TreeNumbers<T>, kinematics: &Kinematics<T>, row: usize) -> T {
    let mut first = 0;
    let index = tree.cuts.iter().position(|cut| {
        first += cut.count();
        row < first
    });
    let Some(index) = index else { return T::one() };
    let poses = tree.cuts[index].slots.map(|slot| &kinematics.poses[slot]);
    turn_rad(&geometry.cuts[index], poses).sin_cos().1
}

/// d²Φ/dt² when the free coordinates have no acceleration. Needs the biases of `kinematics`.
#[inline(never)]
pub fn biases<T: Real>(tree: &Tree, geometry: &TreeNumbers<T>, kinematics: &Kinematics<T>, out: &mut [T]) {
    let cut_rows = cut_biases(tree, geometry, kinematics, out);
    for ((places, numbers), out) in tree.couplings.iter().zip(&geometry.couplings).zip(&mut out[cut_rows..]) {
        *out = numbers.bias(places, kinematics);
    }
}

/// The joint or coupling that imposes a constraint row.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RowOwner {
    /// A cut joint.
    Joint(JointId),
    /// A coupling, by its index in the model.
    Coupling(usize),
}

impl RowOwner {
    /// The owner of constraint row `row` of `tree`.
    pub fn of(tree: &Tree, row: usize) -> Self {
        let mut first = 0;
        for cut in &tree.cuts {
            first += cut.count();
            if row < first {
                return Self::Joint(cut.joint);
            }
        }
        Self::Coupling(tree.coupling_indices[row - first])
    }

    /// Path of its table in the file.
    pub fn path(self, model: &Model) -> String {
        match self {
            Self::Joint(joint) => format!("joint.{}", model.joints[joint.0].name),
            Self::Coupling(index) => model.couplings[index].path.clone(),
        }
    }

    /// Its name in words, for example `joint 'rod'`.
    pub fn words(self, model: &Model) -> String {
        describe_path(&self.path(model))
    }

    /// Dimension of its residual. Rows that say that two bodies do not turn against each other count as lengths here.
    pub fn dimension(self, model: &Model) -> Dimension {
        match self {
            Self::Joint(_) => Dimension::LENGTH,
            Self::Coupling(index) => {
                model.joints[model.couplings[index].second.0].kind.coordinate().unwrap_or(Dimension::ANGLE)
            }
        }
    }
}

/// The constraint that is furthest from being met.
#[derive(Debug, Clone, PartialEq)]
pub struct LargestResidual {
    /// Path of the joint or coupling.
    pub path: String,
    /// How far it stays open, m or rad; NaN if lengths are so large that none holds it.
    pub gap: f64,
    /// Dimension of the residual.
    pub dimension: Dimension,
}

impl LargestResidual {
    /// The worst of `residuals` of the constraint rows of `tree`; zero if there are none. The rows of points that should coincide are one
    /// gap: the distance of the points.
    pub fn worst(model: &Model, tree: &Tree, residuals: &[f64]) -> Self {
        let mut gaps: Vec<(usize, f64)> = Vec::with_capacity(residuals.len());
        let mut row = 0;
        for cut in &tree.cuts {
            for kept in cut.rows {
                let distance = |gap: f64, row: &f64| gap.hypot(*row);
                gaps.push((row, residuals[row..row + kept.count()].iter().fold(0.0, distance)));
                row += kept.count();
            }
        }
        gaps.extend((row..residuals.len()).map(|row| (row, residuals[row].abs())));
        let Some((row, gap)) = gaps.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)) else {
            return Self { path: "joint".to_owned(), gap: 0.0, dimension: Dimension::LENGTH };
        };
        let owner = RowOwner::of(tree, row);
        Self { path: owner.path(model), gap, dimension: owner.dimension(model) }
    }
}

/// Path of the joint or coupling that is furthest from being met, and how far as a share of `size_m` for lengths and in rad for angles: the
/// worst of `residuals` of the constraint rows of `tree`; 0 where there are none.
pub fn largest_relative_residual(model: &Model, tree: &Tree, residuals: &[f64], size_m: f64) -> (String, f64) {
    let mut units = Vec::with_capacity(residuals.len());
    for cut in &tree.cuts {
        units.extend((0..cut.count()).map(|row| if cut.is_angle(row) { 1.0 } else { size_m }));
    }
    for index in &tree.coupling_indices {
        let is_length = RowOwner::Coupling(*index).dimension(model) == Dimension::LENGTH;
        units.push(if is_length { size_m } else { 1.0 });
    }
    let gap = |row: usize| (residuals[row] / units[row]).abs();
    let worst = (0..residuals.len()).max_by(|&a, &b| gap(a).total_cmp(&gap(b)));
    worst.map_or_else(|| ("joint".to_owned(), 0.0), |row| (RowOwner::of(tree, row).path(model), gap(row)))
}

impl fmt::Display for LargestResidual {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let path = describe_path(&self.path);
        if self.gap.is_finite() {
            write!(f, "{path} stays {} open", format_value(self.gap, self.dimension))
        } else {
            write!(f, "the gap of {path} is too large for a number")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::LargestResidual;
    use loosepin_text::units::Dimension;

    #[test]
    fn a_gap_that_no_number_holds_is_not_shown_as_one() {
        let said = |gap: f64| {
            LargestResidual { path: "joint.guide".to_owned(), gap, dimension: Dimension::LENGTH }.to_string()
        };
        assert_eq!(said(1.5e-3), "joint 'guide' stays 1.5 mm open");
        for gap in [f64::NAN, f64::INFINITY] {
            assert_eq!(said(gap), "the gap of joint 'guide' is too large for a number");
        }
    }
}
