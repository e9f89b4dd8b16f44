//! How much each play moves the dead travel of a reading, and what may add to or take from that.

use super::error::Failure;
use super::locked::{Test, exact_travel, pushed};
use super::rig::Rig;
use super::states::{State, States};
use super::yielding::yields_m;
use loosepin_simulate::accuracy::AccuracyError;

/// What the exact loops miss at the corners of the plays is taken twice: between the corners, and where fifth powers of
/// clearance over length begin to count, it may be more.
const MISSED_TIMES: f64 = 2.0;

/// The dead travel of a reading as a sum over the joints with play: Σ factor_k · (clearance_k + yield_k).
#[derive(Debug, Clone)]
pub(crate) struct Influence {
    /// Coordinates of the ideal mechanism, locked.
    pub coordinates: Vec<f64>,
    /// Factors: least, nominal, largest. Nominal is 2 g·e for the displacement e that a clearance of one allows and the push chooses.
    pub factors: Vec<[f64; 3]>,
    /// How far each contact gives way under the push, m: least and largest.
    pub yields_m: Vec<[f64; 2]>,
    /// 2 max(|g_y|, |g_θ|/a) at guides, where one corner may give way further than the other: the block then lies across and tilted. Zero
    /// at other joints.
    guide_factors: Vec<f64>,
    /// Largest difference of the exact loops from Σ |nominal| · (clearance + yield), as a share.
    pub linearisation_share: f64,
}

impl Influence {
    /// The influence of all plays on a reading, where the play inputs lie in the box `plays_si` and all else in `states`.
    ///
    /// # Errors
    /// A dead point lies within the play, or a contact does not carry the push.
    pub fn new(rig: &Rig<'_>, test: &Test, states: &States, plays_si: &[[f64; 2]]) -> Result<Self, Failure> {
        let yields_m = yields_m(rig, states, test, plays_si)?;
        let alone = |state: &State, which: usize| -> Vec<f64> {
            let factors = state.nominal.factors_with_friction(&state.friction);
            factors.iter().map(|factors| factors[which]).collect()
        };
        let clearances_m = rig.clearance_ends_m(plays_si);
        let radii_m: Vec<[f64; 2]> =
            (0..yields_m.len()).map(|k| [0, 1].map(|end| (clearances_m[k][end] + yields_m[k][end]).max(0.0))).collect();
        let together = |state: &State| {
            let least = state.nominal.uniformly_reduced_factors(&state.friction, &radii_m);
            least.unwrap_or_else(|| alone(state, 0))
        };
        // Either holds; the one that says more in the middle of the box is kept.
        let sum = |factors: &[f64]| -> f64 {
            factors.iter().zip(&radii_m).map(|(factor, [low, high])| factor * 0.5 * (low + high)).sum()
        };
        let [least_alone, uniformly_reduced_factors] =
            [states.furthest(-1.0, |state| alone(state, 0)), states.furthest(-1.0, together)];
        let least =
            if sum(&uniformly_reduced_factors) > sum(&least_alone) { uniformly_reduced_factors } else { least_alone };
        let largest = states.furthest(1.0, |state| alone(state, 2));
        let nominal = &states.middle.nominal;
        let factors = (0..least.len()).map(|k| [least[k], nominal.factors[k], largest[k]]).collect();
        let guide_factors = states.furthest(1.0, |state| state.nominal.guide_factors());
        let coordinates = nominal.coordinates.clone();
        let mut influence = Self { coordinates, factors, yields_m, guide_factors, linearisation_share: 0.0 };
        for corner in Rig::corners(plays_si) {
            let missed = influence.missed_share(rig, test, &corner)?;
            influence.linearisation_share = influence.linearisation_share.max(MISSED_TIMES * missed);
        }
        Ok(influence)
    }

    /// Share of Σ |factor| · (clearance + yield) by which the exact loops miss the linear model at some plays.
    pub fn missed_share(&self, rig: &Rig<'_>, test: &Test, plays_si: &[f64]) -> Result<f64, AccuracyError> {
        let clearances_m = rig.clearances_m(plays_si);
        let radii_m: Vec<f64> =
            clearances_m.iter().zip(&self.yields_m).map(|(clearance_m, [_, most_m])| clearance_m + most_m).collect();
        let exact = exact_travel(rig, &self.coordinates, &pushed(&test.push), test.travel, &radii_m)?;
        let terms = || self.factors.iter().zip(&radii_m).map(|([_, nominal, _], radius_m)| nominal * radius_m);
        let (sum, size): (f64, f64) = (terms().sum(), terms().map(f64::abs).sum());
        Ok(if size > 0.0 { (exact - sum).abs() / size } else { 0.0 })
    }

    /// Whether a push makes any play move the reading, friction apart.
    pub fn is_moved(&self) -> bool {
        self.factors.iter().any(|[_, nominal, _]| *nominal != 0.0)
    }

    /// Takes the exact loops to differ by `share` at least.
    pub fn widen(&mut self, missed_share: f64) {
        self.linearisation_share = self.linearisation_share.max(MISSED_TIMES * missed_share);
    }

    /// Least and largest factor of a joint with what linearisation may add.
    pub fn limits(&self, joint: usize) -> [f64; 2] {
        let [least, nominal, largest] = self.factors[joint];
        let missed = self.linearisation_share * nominal.abs();
        [least - missed, largest + missed]
    }

    /// Least and largest travel by a contact that gives way.
    pub fn yield_si(&self, joint: usize) -> [f64; 2] {
        let [least, largest] = self.limits(joint);
        let [least_m, most_m] = self.yields_m[joint];
        let ends = [f64::min(least * least_m, least * most_m), f64::max(largest * least_m, largest * most_m)];
        // The corners of a guide give way by δ_1 and δ_2 on top of the end that is pushed to: across by their mean, tilted by
        // (δ_1 - δ_2)/2a, or the other way about, |y| + a |θ| <= max δ.
        match self.guide_factors[joint] * most_m {
            0.0 => ends,
            by_corners => [ends[0].min(-by_corners), ends[1].max(by_corners)],
        }
    }
}
