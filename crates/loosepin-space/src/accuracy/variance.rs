//! How an output scatters where journals lie anywhere in their play.

use crate::accuracy::gains::Gains;
use crate::accuracy::play_set::PlaySet;
use crate::accuracy::pose_accuracy::PoseAccuracy;

/// Where the journals lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlayDistribution {
    /// Uniformly in the discs of both end planes, in the balls, and between the stops.
    Inside,
    /// Uniformly on the circles of both end planes and on the surfaces of the balls; still between the stops.
    OnTheRim,
}

impl PlayDistribution {
    /// Variance of one of `size` variables in units of the radius: of a ball in n dimensions 1/(n + 2), of its surface 1/n.
    fn variance(self, size: usize) -> f64 {
        match self {
            Self::OnTheRim if size > 1 => 1.0 / size as f64,
            _ => 1.0 / (size as f64 + 2.0),
        }
    }
}

impl PoseAccuracy<'_> {
    /// Standard deviation of an output to first order, m or rad, all plays independent:
    ///
    /// ```text
    /// σ² = Σ c² (|g_1|² + |g_2|²)/4 + c_a² g_α²/3 + c² |g|²/5  inside,  /2 and /3 on the rims and surfaces
    /// ```
    ///
    /// `None` where the plays must meet conditions together ([`Self::conditions`]): then they are not independent, and there is no closed form.
    pub fn standard_deviation(&self, gains: &Gains, distribution: PlayDistribution) -> Option<f64> {
        if self.conditions() > 0 {
            return None;
        }
        let scaled = self.scaled_gains(gains);
        let blocks = self.set.blocks().iter();
        let variance: f64 =
            blocks.map(|block| PlaySet::square(block, &scaled) * distribution.variance(block.part.size())).sum();
        Some(variance.sqrt())
    }
}
