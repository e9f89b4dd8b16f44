//! Several networks of one size, trained from different first weights: their mean and their spread.

use crate::design::Design;
use crate::network::layer::Network;
use crate::network::training::{Trained, train};
use loosepin_math::sort_by_number;
use loosepin_uncertainty::hash;
use serde::{Deserialize, Serialize};

/// First weights that are tried, and how many of the trained networks are kept: those with the largest evidence.
const STARTS: usize = 4;
const KEPT: usize = 2;
/// Numbers of neurons that are tried.
const SIZES: [usize; 4] = [3, 6, 10, 16];

/// Networks of an output that was scaled to mean 0 and standard deviation 1.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Ensemble {
    /// Networks with the largest evidence.
    pub networks: Vec<Network>,
}

impl Ensemble {
    /// Trains networks of `neurons` to `values` at the points of `design`.
    pub(crate) fn fit(design: &Design, values: &[f64], neurons: usize, seed: u64) -> Self {
        let mut trained: Vec<Trained> =
            (0..STARTS).map(|start| train(&design.scaled, values, neurons, hash(seed, start as u64))).collect();
        // Sorting is stable: of equal ones the first stays first.
        sort_by_number(&mut trained, |a| -a.evidence);
        Self { networks: trained.into_iter().take(KEPT).map(|trained| trained.network).collect() }
    }

    /// Sizes that are compared by their held-out error for that many inputs and runs, the smallest first and none above
    /// `most`.
    pub(crate) fn sizes(inputs: usize, runs: usize, most: usize) -> Vec<usize> {
        // More weights than three times the runs only cost time: most of them would be switched off.
        let largest = (3 * runs / (inputs + 2)).min(most);
        let sizes: Vec<usize> = SIZES.into_iter().filter(|neurons| *neurons <= largest).collect();
        if sizes.is_empty() { vec![SIZES[0]] } else { sizes }
    }

    /// Neurons of each network.
    pub fn neurons(&self) -> usize {
        self.networks.first().map_or(0, Network::neurons)
    }

    /// Mean and standard deviation over the networks.
    pub(crate) fn predict(&self, scaled: &[f64]) -> (f64, f64) {
        let values: Vec<f64> = self.networks.iter().map(|network| network.value(scaled)).collect();
        crate::design::mean_and_deviation(&values)
    }
}
