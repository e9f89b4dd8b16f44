//! Planes that variables of play lie on.

use crate::accuracy::linear::vectors::{add, dot};
use loosepin_math::SingularValues;

/// Planes H v = b in orthonormal rows.
#[derive(Debug, Clone)]
pub(crate) struct Planes {
    /// Orthonormal rows.
    pub rows: Vec<Vec<f64>>,
    /// Takes multipliers of these rows to those of H, and right-hand sides of H to those of these rows: U/σ.
    back: Vec<Vec<f64>>,
    /// U: what of right-hand sides of H is reached.
    left: Vec<Vec<f64>>,
}

impl Planes {
    /// From the rows of H. What is smaller than `negligible` is no plane.
    pub(crate) fn new(rows: &[Vec<f64>], variables: usize, negligible: f64) -> Self {
        let matrix: Vec<f64> = rows.iter().flatten().copied().collect();
        let values = SingularValues::thin(&matrix, rows.len(), variables);
        let round_off = values.values().first().map_or(0.0, |largest| largest * f64::EPSILON);
        let kept = values.values().iter().take_while(|value| **value > negligible.max(round_off)).count();
        let back = (0..kept).map(|k| values.left(k).iter().map(|entry| entry / values.values()[k]).collect());
        Self {
            back: back.collect(),
            rows: (0..kept).map(|k| values.right(k).to_vec()).collect(),
            left: (0..kept).map(|k| values.left(k).to_vec()).collect(),
        }
    }

    /// Number of planes.
    pub(crate) fn count(&self) -> usize {
        self.rows.len()
    }

    /// The shortest v with H v = b.
    pub(crate) fn shortest(&self, b: &[f64], variables: usize) -> Vec<f64> {
        let mut shortest = vec![0.0; variables];
        for (row, value) in self.rows.iter().zip(self.right_hand_side(b)) {
            add(&mut shortest, row, value);
        }
        shortest
    }

    /// A vector without its parts across the planes.
    pub(crate) fn along(&self, vector: &[f64]) -> Vec<f64> {
        let mut along = vector.to_vec();
        for row in &self.rows {
            let share = dot(row, &along);
            add(&mut along, row, -share);
        }
        along
    }

    /// The part of b that no v makes.
    pub(crate) fn rest(&self, b: &[f64]) -> Vec<f64> {
        let mut rest = b.to_vec();
        for left in &self.left {
            let share = dot(left, &rest);
            add(&mut rest, left, -share);
        }
        rest
    }

    /// The largest entry of that part.
    pub(crate) fn unreached(&self, b: &[f64]) -> f64 {
        self.rest(b).iter().fold(0.0, |largest: f64, value| largest.max(value.abs()))
    }

    /// b in the orthonormal rows.
    pub(crate) fn right_hand_side(&self, b: &[f64]) -> Vec<f64> {
        self.back.iter().map(|column| dot(column, b)).collect()
    }

    /// Multipliers of H.
    pub(crate) fn multipliers(&self, own: &[f64], count: usize) -> Vec<f64> {
        let mut multipliers = vec![0.0; count];
        for (column, value) in self.back.iter().zip(own) {
            multipliers.iter_mut().zip(column).for_each(|(sum, entry)| *sum += entry * value);
        }
        multipliers
    }

    /// g - Hᵀλ for multipliers of H.
    pub(crate) fn less(&self, gains: &[f64], own: &[f64]) -> Vec<f64> {
        let mut rest = gains.to_vec();
        for (row, value) in self.rows.iter().zip(own) {
            rest.iter_mut().zip(row).for_each(|(entry, part)| *entry -= part * value);
        }
        rest
    }
}
