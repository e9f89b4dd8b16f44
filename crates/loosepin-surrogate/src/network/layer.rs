//! A feed-forward neural network with one hidden layer, y = v_0 + Σ_j v_j tanh(b_j + Σ_k w_jk x_k).

use loosepin_math::dense::dot;
use serde::{Deserialize, Serialize};

/// A network of an output that was scaled to mean 0 and standard deviation 1.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Network {
    /// d
    inputs: usize,
    /// h
    neurons: usize,
    /// For each neuron b_j and w_jk; then v_0 and v_j.
    weights: Vec<f64>,
}

impl Network {
    /// A network with these weights: for each neuron b_j and w_jk, then v_0 and v_j.
    pub(crate) fn new(inputs: usize, neurons: usize, weights: Vec<f64>) -> Self {
        debug_assert_eq!(weights.len(), Self::size(inputs, neurons));
        Self { inputs, neurons, weights }
    }

    /// How many weights there are.
    pub(crate) fn size(inputs: usize, neurons: usize) -> usize {
        neurons * (inputs + 2) + 1
    }

    /// h
    pub fn neurons(&self) -> usize {
        self.neurons
    }

    pub(crate) fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// y at x.
    pub(crate) fn value(&self, point: &[f64]) -> f64 {
        let (hidden, outer) = self.weights.split_at(self.neurons * (self.inputs + 1));
        let layer = hidden.chunks(self.inputs + 1).zip(&outer[1..]);
        outer[0] + layer.map(|(row, v)| v * libm::tanh(row[0] + dot(&row[1..], point))).sum::<f64>()
    }

    /// y at x, and its derivatives with respect to the weights, written to `row`.
    pub(crate) fn value_and_row(&self, point: &[f64], row: &mut [f64]) -> f64 {
        let (hidden, outer) = self.weights.split_at(self.neurons * (self.inputs + 1));
        let (inner_row, outer_row) = row.split_at_mut(self.neurons * (self.inputs + 1));
        outer_row[0] = 1.0;
        let mut value = outer[0];
        for (j, weights) in hidden.chunks(self.inputs + 1).enumerate() {
            let t = libm::tanh(weights[0] + dot(&weights[1..], point));
            let v = outer[j + 1];
            value += v * t;
            outer_row[j + 1] = t;
            let slope = v * (1.0 - t * t);
            let entries = &mut inner_row[j * (self.inputs + 1)..(j + 1) * (self.inputs + 1)];
            entries[0] = slope;
            for (entry, x) in entries[1..].iter_mut().zip(point) {
                *entry = slope * x;
            }
        }
        value
    }
}

#[cfg(test)]
mod tests {
    use super::Network;

    #[test]
    fn identity_derivatives_are_difference_quotients() {
        // Central differences with a step of 1e-5 leave 1e-10 of truncation and 1e-11 of round-off.
        const TOLERANCE: f64 = 1e-8;
        const STEP: f64 = 1e-5;
        let weights: Vec<f64> = (0..Network::size(3, 4)).map(|k| libm::sin(2.3 * k as f64 + 0.4)).collect();
        let network = Network::new(3, 4, weights.clone());
        let point = [0.3, -0.8, 1.4];
        let mut row = vec![f64::NAN; weights.len()];
        assert!((network.value_and_row(&point, &mut row) - network.value(&point)).abs() < TOLERANCE);
        for k in 0..weights.len() {
            let moved = |step: f64| {
                let mut weights = weights.clone();
                weights[k] += step;
                Network::new(3, 4, weights).value(&point)
            };
            assert!((row[k] - (moved(STEP) - moved(-STEP)) / (2.0 * STEP)).abs() < TOLERANCE, "weight {k}");
        }
    }
}
