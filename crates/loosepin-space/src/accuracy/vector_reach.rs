//! How far play takes a vector in a direction, for many directions.

use crate::accuracy::error::AccuracyError;
use crate::accuracy::gains::Gains;
use crate::accuracy::linear::slice::{Largest, largest};
use crate::accuracy::linear::vectors::dot;
use crate::accuracy::play_set::PlaySet;
use crate::accuracy::pose_accuracy::PoseAccuracy;
use loosepin_math::RealLu;
use loosepin_math::dense::factor_definite;

/// Part of a length that a proof may leave open, relative to it.
const PROVEN: f64 = 1e-10;

/// Most components of a vector.
const MAX_SIZE: usize = 3;

/// Displacements G p of a vector by the plays p, to first order, in variables in units of their radii.
pub(crate) struct VectorReach<'a, 'b> {
    accuracy: &'a PoseAccuracy<'b>,
    /// Rows of G, the scaled gains of each component.
    gains: Vec<Vec<f64>>,
    /// Columns of G, with zeros behind.
    columns: Vec<[f64; MAX_SIZE]>,
    /// What stands against the redundant rows: nothing.
    zero: Vec<f64>,
    /// With planes, what their multipliers leave of the gains along the last direction, and where it is largest.
    found: Option<Largest>,
}

impl<'a, 'b> VectorReach<'a, 'b> {
    /// Of a vector with these components, up to three.
    ///
    /// # Errors
    ///
    /// [`AccuracyError::OutputDoesNotFit`] with more components.
    pub(crate) fn new(accuracy: &'a PoseAccuracy<'b>, components: &[Gains]) -> Result<Self, AccuracyError> {
        if components.len() > MAX_SIZE {
            return Err(AccuracyError::OutputDoesNotFit);
        }
        let gains: Vec<Vec<f64>> = components.iter().map(|own| accuracy.scaled_gains(own)).collect();
        let column = |variable: usize| {
            let mut column = [0.0; MAX_SIZE];
            column.iter_mut().zip(&gains).for_each(|(entry, own)| *entry = own[variable]);
            column
        };
        let columns = (0..accuracy.set.variables()).map(column).collect();
        Ok(Self { accuracy, gains, columns, zero: vec![0.0; accuracy.redundant.len()], found: None })
    }

    /// The displacement that goes farthest in a direction.
    ///
    /// # Errors
    ///
    /// [`AccuracyError::NoPlace`], as for [`PoseAccuracy::first_order`].
    pub(crate) fn farthest(&mut self, direction: [f64; MAX_SIZE]) -> Result<[f64; MAX_SIZE], AccuracyError> {
        let accuracy = self.accuracy;
        if accuracy.planes.count() > 0 {
            let along: Vec<f64> = self.columns.iter().map(|column| dot(column, &direction)).collect();
            let found = largest(&accuracy.set, &along, None, &accuracy.planes, &self.zero);
            let found = self.found.insert(found.ok_or(AccuracyError::NoPlace)?);
            let mut vector = [0.0; MAX_SIZE];
            vector.iter_mut().zip(&self.gains).for_each(|(entry, own)| *entry = dot(own, &found.place));
            return Ok(vector);
        }
        // Σ G_k G_kᵀn/|G_kᵀn| over the blocks k.
        let mut vector = [0.0; MAX_SIZE];
        for block in accuracy.set.blocks() {
            let columns = &self.columns[block.range()];
            let (mut sum, mut square) = ([0.0; MAX_SIZE], 0.0);
            for [x, y, z] in columns {
                let along = x * direction[0] + y * direction[1] + z * direction[2];
                square += along * along;
                sum = [sum[0] + x * along, sum[1] + y * along, sum[2] + z * along];
            }
            if square > 0.0 {
                let inverse = 1.0 / square.sqrt();
                vector.iter_mut().zip(sum).for_each(|(entry, part)| *entry += part * inverse);
            }
        }
        Ok(vector)
    }

    /// The gains along the last direction, less the multipliers of planes, and the place where they are largest.
    pub(crate) fn gains_and_place(&self, direction: [f64; MAX_SIZE]) -> (Vec<f64>, Vec<f64>) {
        if let Some(found) = &self.found {
            return (found.rest.clone(), found.place.clone());
        }
        let along: Vec<f64> = self.columns.iter().map(|column| dot(column, &direction)).collect();
        let mut place = along.clone();
        for block in self.accuracy.set.blocks() {
            let own = &mut place[block.range()];
            let length = dot(own, own).sqrt();
            if length > 0.0 {
                own.iter_mut().for_each(|value| *value /= length);
            }
        }
        (along, place)
    }

    /// Whether no displacement is longer than `length`, to round-off; `along` are the gains along that direction, less the multipliers of planes.
    ///
    /// With D = diag(μ_k), μ_k > 0 of each block, |G p|² <= pᵀD p <= Σ μ_k for all plays if GᵀG <= D, which is G D⁻¹Gᵀ <= 1; with planes H p = 0
    /// any G - Λ H does as well as G, best with Λ = G D⁻¹Hᵀ(H D⁻¹Hᵀ)⁻¹. The lengths of the gains along a longest displacement v, over |v|, add up
    /// to |v|: with μ = |v| times them the bound is |v|² itself, wherever it holds.
    pub(crate) fn is_longest(&self, length: f64, along: &[f64]) -> bool {
        let planes = &self.accuracy.planes.rows;
        let size = self.gains.len();
        let rows: Vec<&Vec<f64>> = self.gains.iter().chain(planes).collect();
        // G D⁻¹Gᵀ, G D⁻¹Hᵀ and H D⁻¹Hᵀ in one, with μ over |v|.
        let order = rows.len();
        let mut products = vec![0.0; order * order];
        for block in self.accuracy.set.blocks() {
            let weight = PlaySet::length(block, along);
            for (i, first) in rows.iter().enumerate() {
                for (k, second) in rows.iter().enumerate().take(i + 1) {
                    let product = dot(&first[block.range()], &second[block.range()]);
                    if product != 0.0 {
                        products[i * order + k] += product / weight;
                    }
                }
            }
        }
        let count = planes.len();
        let mut own = RealLu::new(count);
        for i in 0..count {
            for k in 0..count {
                own.matrix[i * count + k] = products[(size + i.max(k)) * order + size + i.min(k)];
            }
        }
        own.factor();
        // (1 + ε) |v| - S is positive: S = G D⁻¹Gᵀ less what planes take.
        let mut rest = vec![0.0; size * size];
        for i in 0..size {
            let mut across: Vec<f64> = (0..count).map(|k| products[(size + k) * order + i]).collect();
            own.solve(&mut across);
            for k in 0..=i {
                let taken: f64 = across.iter().enumerate().map(|(m, own)| own * products[(size + m) * order + k]).sum();
                rest[i * size + k] = taken - products[i * order + k];
            }
            rest[i * size + i] += (1.0 + PROVEN) * length;
        }
        factor_definite(&mut rest, size, |pivot| pivot > 0.0)
    }
}
