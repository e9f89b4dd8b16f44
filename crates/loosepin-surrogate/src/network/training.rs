//! Training a network: Levenberg-Marquardt with Bayesian regularisation.
//!
//! ```text
//! F(w) = β Σ e_i² + Σ_g α_g Σ_(k in g) w_k²,   H = β JᵀJ + diag(α),   (H + μ) Δw = -(β Jᵀe + α w)
//! γ_g = N_g - α_g tr_g(H⁻¹),   α_g = γ_g / Σ_g w²,   β = (N - Σ γ_g) / Σ e²
//! ```
//!
//! e: errors of the N runs; J: their derivatives with respect to the weights; γ: how many weights the runs have fixed. Groups
//! g: the weights of each input, the biases, the outer weights; so an input without influence loses its weights. Sources:
//! F. D. Foresee and M. T. Hagan, "Gauss-Newton approximation to Bayesian learning", ICNN 1997, 1930-1935; D. J. C. MacKay,
//! "A practical Bayesian framework for backpropagation networks", Neural Computation 4 (1992) 448-472, whose evidence tells
//! starts apart; the groups are automatic relevance determination of the same author (1994).

use crate::network::layer::Network;
use loosepin_math::dense::{Cholesky, dot};
use loosepin_uncertainty::normal;

const STEPS: usize = 120;
/// Steps before α and β begin to change, unless one gains less than this share of F: weights that have not found their place
/// would be taken for noise.
const FIRST_STEPS: usize = 40;
const FIRST_TOLERANCE: f64 = 1e-3;
const FIRST_ALPHA: f64 = 0.05;
const FIRST_BETA: f64 = 1e3;
/// Relative change of F and of the evidence at which training ends.
const TOLERANCE: f64 = 1e-4;
/// β is held below this: errors of 1e-4 of the output's standard deviation are as good as none.
const MAX_BETA: f64 = 1e8;
const ALPHA_BOUNDS: (f64, f64) = (1e-4, 1e6);

/// A trained network and the logarithm of its evidence.
pub(crate) struct Trained {
    pub network: Network,
    pub evidence: f64,
}

/// Trains a network of `neurons` from the random weights of `seed`.
pub(crate) fn train(points: &[Vec<f64>], values: &[f64], neurons: usize, seed: u64) -> Trained {
    let (count, inputs) = (points.len(), points[0].len());
    let size = Network::size(inputs, neurons);
    let group: Vec<usize> = (0..size).map(|k| group_of(k, inputs, neurons)).collect();
    let groups = inputs + 2;
    let mut network = Network::new(inputs, neurons, first_weights(inputs, neurons, seed));
    let mut state = State::at(&network, points, values);
    let (mut alpha, mut beta) = (vec![FIRST_ALPHA; groups], FIRST_BETA);
    let mut damping = 1e-2;
    let mut evidence = f64::NEG_INFINITY;
    let objective = |state: &State, weights: &[f64], alpha: &[f64], beta: f64| {
        beta * state.square + weights.iter().zip(&group).map(|(w, g)| alpha[*g] * w * w).sum::<f64>()
    };
    for step in 0..STEPS {
        let slope: Vec<f64> =
            (0..size).map(|k| beta * state.slope[k] + alpha[group[k]] * network.weights()[k]).collect();
        let value = objective(&state, network.weights(), &alpha, beta);
        let mut accepted = None;
        while damping < 1e10 {
            let change = Cholesky::new(state.hessian(&group, &alpha, beta, damping), size).map(|factor| {
                let mut change = slope.clone();
                factor.solve(&mut change);
                change
            });
            if let Some(change) = change {
                let weights = network.weights().iter().zip(&change).map(|(w, s)| w - s).collect();
                let trial = Network::new(inputs, neurons, weights);
                let found = State::at(&trial, points, values);
                let reached = objective(&found, trial.weights(), &alpha, beta);
                if reached < value {
                    accepted = Some((trial, found, value - reached));
                    damping = (damping * 0.2).max(1e-10);
                    break;
                }
            }
            damping *= 5.0;
        }
        let gain = if let Some((trial, found, gain)) = accepted {
            (network, state) = (trial, found);
            gain
        } else {
            damping = 1e-2;
            0.0
        };
        if step < FIRST_STEPS && gain > FIRST_TOLERANCE * value {
            continue;
        }
        let Some(factor) = Cholesky::new(state.hessian(&group, &alpha, beta, 0.0), size) else { break };
        let variances = factor.inverse_factor().column_squares();
        let mut squares = vec![0.0; groups];
        let mut known = vec![0.0; groups];
        for (k, weight) in network.weights().iter().enumerate() {
            squares[group[k]] += weight * weight;
            known[group[k]] += 1.0 - alpha[group[k]] * variances[k];
        }
        let before = evidence;
        let members = |g: usize| group.iter().filter(|other| **other == g).count() as f64;
        evidence = 0.5
            * (count as f64 * libm::log(beta) + (0..groups).map(|g| members(g) * libm::log(alpha[g])).sum::<f64>()
                - objective(&state, network.weights(), &alpha, beta)
                - factor.ln_determinant());
        for g in 0..groups {
            let next = known[g].max(1e-3) / squares[g].max(1e-30);
            alpha[g] = (alpha[g] * next).sqrt().clamp(ALPHA_BOUNDS.0, ALPHA_BOUNDS.1);
        }
        let free = (count as f64 - known.iter().sum::<f64>()).max(0.05 * count as f64);
        beta = (beta * free / state.square.max(1e-30)).sqrt().min(MAX_BETA);
        if gain < TOLERANCE * value && (evidence - before).abs() < TOLERANCE * evidence.abs().max(1.0) {
            break;
        }
    }
    Trained { network, evidence }
}

/// Errors and what the steps need of J.
struct State {
    /// Σ e²
    square: f64,
    /// Jᵀe
    slope: Vec<f64>,
    /// JᵀJ, its lower triangle, row by row.
    gram: Vec<f64>,
}

impl State {
    fn at(network: &Network, points: &[Vec<f64>], values: &[f64]) -> Self {
        let size = network.weights().len();
        let count = points.len();
        // Columns of J, so that the products run along memory.
        let mut columns = vec![0.0; size * count];
        let mut row = vec![0.0; size];
        let mut errors = Vec::with_capacity(count);
        for (i, (point, value)) in points.iter().zip(values).enumerate() {
            errors.push(network.value_and_row(point, &mut row) - value);
            for (k, entry) in row.iter().enumerate() {
                columns[k * count + i] = *entry;
            }
        }
        let column = |k: usize| &columns[k * count..(k + 1) * count];
        let mut gram = vec![0.0; size * size];
        for i in 0..size {
            for j in 0..=i {
                gram[i * size + j] = dot(column(i), column(j));
            }
        }
        Self { square: dot(&errors, &errors), slope: (0..size).map(|k| dot(column(k), &errors)).collect(), gram }
    }

    fn hessian(&self, group: &[usize], alpha: &[f64], beta: f64, damping: f64) -> Vec<f64> {
        let size = group.len();
        let mut hessian: Vec<f64> = self.gram.iter().map(|entry| beta * entry).collect();
        for k in 0..size {
            // Damping is relative, so that it does not matter how large β has become.
            hessian[k * size + k] = hessian[k * size + k] * (1.0 + damping) + alpha[group[k]] + damping * 1e-3;
        }
        hessian
    }
}

/// The group of weight `k`: its input, then biases and v_0, then v_j.
fn group_of(k: usize, inputs: usize, neurons: usize) -> usize {
    let hidden = neurons * (inputs + 1);
    if k > hidden {
        return inputs + 1;
    }
    if k == hidden { inputs } else { (k % (inputs + 1)).checked_sub(1).unwrap_or(inputs) }
}

/// Inner weights that spread the bends over the inputs (D. Nguyen and B. Widrow, IJCNN 1990), small outer ones.
fn first_weights(inputs: usize, neurons: usize, seed: u64) -> Vec<f64> {
    let size = Network::size(inputs, neurons);
    let mut weights: Vec<f64> = (0..size).map(|k| normal(seed, k as u64)).collect();
    let length = 0.7 * libm::pow(neurons as f64, 1.0 / inputs as f64);
    let hidden = neurons * (inputs + 1);
    for row in weights[..hidden].chunks_mut(inputs + 1) {
        let norm = dot(&row[1..], &row[1..]).sqrt().max(1e-12);
        row[1..].iter_mut().for_each(|w| *w *= length / norm);
        row[0] *= length;
    }
    weights[hidden..].iter_mut().for_each(|v| *v *= 0.3);
    weights
}
