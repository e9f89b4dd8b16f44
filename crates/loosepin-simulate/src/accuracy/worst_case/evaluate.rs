//! The loop equations and outputs of the ideal mechanism with displaced joints, over any number.

use loosepin_math::{Real, Vec2};
use loosepin_mechanics::mechanism::{Kinematics, Mechanism, TreeNumbers, constraints, numbered_point_m};
use loosepin_mechanics::model::{Position, QuantityId};

/// A mechanism of which positions are computed on numbers of one kind.
pub(super) struct Evaluator<'a, T: Real> {
    mechanism: &'a Mechanism,
    /// The numbers of the model, by quantity.
    numbers: Vec<T>,
    geometry: TreeNumbers<T>,
    centred: TreeNumbers<T>,
    kinematics: Kinematics<T>,
    residuals: Vec<T>,
}

impl<'a, T: Real> Evaluator<'a, T> {
    /// Evaluation of a mechanism with these numbers.
    pub fn new(mechanism: &'a Mechanism, numbers: Vec<T>) -> Self {
        let tree = &mechanism.ideal;
        let geometry = TreeNumbers::from_numbers(&mechanism.model, tree, &|id: QuantityId| numbers[id.0]);
        Self {
            mechanism,
            centred: geometry.clone(),
            geometry,
            kinematics: Kinematics::new(tree),
            residuals: vec![T::zero(); tree.constraint_rows()],
            numbers,
        }
    }

    /// Gives the mechanism other numbers.
    pub fn set_numbers(&mut self, numbers: impl Iterator<Item = T>) {
        self.numbers.clear();
        self.numbers.extend(numbers);
        let (model, numbers) = (&self.mechanism.model, &self.numbers);
        self.centred = TreeNumbers::from_numbers(model, &self.mechanism.ideal, &|id: QuantityId| numbers[id.0]);
        self.geometry = self.centred.clone();
    }

    /// Puts the bodies to the coordinates of the ideal tree, free ones first, with joints displaced.
    pub fn set(&mut self, coordinates: &[T], displacements: impl Iterator<Item = Vec2<T>>) {
        let tree = &self.mechanism.ideal;
        for (&id, displacement) in self.mechanism.plays.iter().zip(displacements) {
            self.geometry.set_displacement(tree, id, displacement, &self.centred);
        }
        self.kinematics.set_positions(tree, &self.geometry, coordinates);
        constraints::residuals(tree, &self.geometry, &self.kinematics, &mut self.residuals);
    }

    /// Φ of the independent rows, as many as there are free coordinates.
    pub fn residuals(&self) -> impl Iterator<Item = T> + '_ {
        self.mechanism.ideal_rows().iter().map(|row| self.residuals[*row])
    }

    /// The value of an output, m or rad.
    pub fn value(&self, reading: Position) -> T {
        let (model, numbers) = (&self.mechanism.model, &self.numbers);
        reading.value(&self.mechanism.ideal, &self.kinematics, |point| {
            numbered_point_m(model, &|id: QuantityId| numbers[id.0], point)
        })
    }
}
