//! How much each play moves the dead travel of a reading, and what may add to or take from that.

use super::friction::{Friction, turned_products};
use super::locked::{Test, UNLOADED, exact_travel, gradient, largest_load, locked_at, pushed, reaches};
use super::rig::Rig;
use super::yielding::yields_m;
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::{Position, Values};
use loosepin_simulate::accuracy::{AccuracyError, DisplacedLoops, PlayReach};

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
    /// What the exact loops differ by from Σ |nominal| · (clearance + yield), as a share, at most.
    pub linearisation_share: f64,
}

impl Influence {
    /// The influence of all plays on a reading, where the play inputs lie in the box `plays_si`.
    ///
    /// # Errors
    /// The mechanism cannot be locked there, or a dead point lies within the play.
    pub fn new(rig: &Rig<'_>, test: &Test, plays_si: &[[f64; 2]]) -> Result<Self, AccuracyError> {
        let nominal = Nominal::at(&rig.mechanism, &rig.values, test)?;
        let friction = Friction::new(rig, &nominal.coordinates, &nominal.loads, test.friction)?;
        let mut factors = nominal.factors_with_friction(&friction);
        for other in &rig.others {
            let mut moved = Vec::new();
            for end_si in other.interval_si {
                let values = rig.values_with(&[(other.quantity, end_si)])?;
                moved.push(Nominal::at(&rig.mechanism, &values, test)?);
            }
            widen(&mut factors, &nominal, &moved);
        }
        if test.pose_error_rad > 0.0 {
            let mut moved = Vec::new();
            for pose_rad in [test.pose_rad - test.pose_error_rad, test.pose_rad + test.pose_error_rad] {
                moved.push(Nominal::at(&rig.mechanism, &rig.values, &Test { pose_rad, ..*test })?);
            }
            widen(&mut factors, &nominal, &moved);
        }
        let yields_m = yields_m(rig, &nominal.loads, &friction, test, plays_si)?;
        let together = nominal.least_together(&friction, rig, plays_si, &yields_m);
        let least_alone: Vec<f64> = nominal.factors_with_friction(&friction).iter().map(|factors| factors[0]).collect();
        let mut influence = Self { coordinates: nominal.coordinates, factors, yields_m, linearisation_share: 0.0 };
        if let Some(together) = together {
            // Either holds; the one that says more in the middle of the box is kept.
            let middle: Vec<f64> = plays_si.iter().map(|[low, high]| 0.5 * (low + high)).collect();
            let middle_m = rig.clearances_m(&middle);
            let sum = |factors: &[f64]| factors.iter().zip(&middle_m).map(|(f, c)| f * c).sum::<f64>();
            if sum(&together) > sum(&least_alone) {
                for (factors, (together, alone)) in influence.factors.iter_mut().zip(together.iter().zip(&least_alone))
                {
                    factors[0] += together - alone;
                }
            }
        }
        for corner in Rig::corners(plays_si) {
            let missed = influence.missed_share(rig, test, &corner)?;
            influence.linearisation_share = influence.linearisation_share.max(MISSED_TIMES * missed);
        }
        Ok(influence)
    }

    /// By what share of Σ |factor| · (clearance + yield) the exact loops miss the linear model at some plays.
    pub fn missed_share(&self, rig: &Rig<'_>, test: &Test, plays_si: &[f64]) -> Result<f64, AccuracyError> {
        let clearances_m = rig.clearances_m(plays_si);
        let radii_m: Vec<f64> =
            clearances_m.iter().zip(&self.yields_m).map(|(clearance_m, [_, most_m])| clearance_m + most_m).collect();
        let exact = exact_travel(rig, &self.coordinates, &pushed(&test.push), test.travel, &radii_m)?;
        let terms = || self.factors.iter().zip(&radii_m).map(|([_, nominal, _], radius_m)| nominal * radius_m);
        let (sum, size): (f64, f64) = (terms().sum(), terms().map(f64::abs).sum());
        Ok(if size > 0.0 { (exact - sum).abs() / size } else { 0.0 })
    }

    /// Whether a push makes any play move what is read, friction apart.
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
}

/// Widens factors by the largest change among `moved`, where one input is at either end of its interval: one at a time. That two act
/// together is of second order, and covered by a hundredth more.
fn widen(factors: &mut [[f64; 3]], nominal: &Nominal, moved: &[Nominal]) {
    for (joint, [least, _, largest]) in factors.iter_mut().enumerate() {
        let changes = moved.iter().map(|moved| (moved.factors[joint] - nominal.factors[joint]).abs());
        let spread = 1.01 * changes.fold(0.0, f64::max);
        *least -= spread;
        *largest += spread;
    }
}

/// The linear model at one set of values, without friction.
pub(crate) struct Nominal {
    pub coordinates: Vec<f64>,
    /// h_k: gradients of the pushed position, which are the loads of the joints under a unit push.
    pub loads: Vec<Vec2<f64>>,
    /// g_k: gradients of the position that is read.
    pub travels: Vec<Vec2<f64>>,
    pub factors: Vec<f64>,
    reaches: Vec<PlayReach>,
}

impl Nominal {
    pub fn at(mechanism: &Mechanism, values: &Values, test: &Test) -> Result<Self, AccuracyError> {
        let coordinates = locked_at(mechanism, values, test.pose_rad)?;
        Self::of_position(mechanism, values, coordinates, &pushed(&test.push), &[(test.travel, 1.0)])
    }

    /// The same where the locked position is known.
    pub fn of_position(
        mechanism: &Mechanism,
        values: &Values,
        coordinates: Vec<f64>,
        push: &[(Position, f64)],
        travel: &[(Position, f64)],
    ) -> Result<Self, AccuracyError> {
        let sample = Sample::new(mechanism, values)?;
        let clearances_m: Vec<f64> = sample.plays.iter().map(|play| play.clearance_m).collect();
        let reaches = reaches(mechanism, &sample, &clearances_m)?;
        let mut loops = DisplacedLoops::new(mechanism, values);
        loops.set_position(&coordinates);
        let (loads, travels) = (gradient(&mut loops, push)?, gradient(&mut loops, travel)?);
        let least = UNLOADED * largest_load(&loads);
        let factors = (0..reaches.len())
            .map(|k| match reaches[k].furthest(loads[k]) {
                Some(end) if loads[k].length() > least => 2.0 * travels[k].dot(end) / clearances_m[k],
                _ => 0.0,
            })
            .collect();
        Ok(Self { coordinates, loads, travels, factors, reaches })
    }

    /// Least factors with friction where it is read where it is pushed: the same share of all nominal ones. Friction does not turn
    /// all joints furthest at once, so that the sum falls by less than its terms may. The share is the least of
    /// Σ A_j cos t_j r_j / Σ A_j r_j over the corners of the radii r, where a ratio of linear functions is least.
    fn least_together(
        &self,
        friction: &Friction,
        rig: &Rig<'_>,
        plays_si: &[[f64; 2]],
        yields_m: &[[f64; 2]],
    ) -> Option<Vec<f64>> {
        /// Round-off of 2 |g| beside the factor.
        const SAME: f64 = 1e-9;
        let is_same = |k: usize| {
            let due = 2.0 * self.travels[k].length();
            matches!(self.reaches[k], PlayReach::Disc { .. }) && (self.factors[k] - due).abs() <= SAME * due
        };
        if !Rig::takes_all_corners(plays_si) {
            return None;
        }
        let rows = friction.least_cosines().filter(|_| (0..self.factors.len()).all(is_same))?;
        let mut share = 1.0_f64;
        for corner in Rig::corners(plays_si) {
            let clearances_m = rig.clearances_m(&corner);
            for end in [0, 1] {
                let terms: Vec<f64> =
                    (0..self.factors.len()).map(|k| self.factors[k] * (clearances_m[k] + yields_m[k][end])).collect();
                let sum: f64 = terms.iter().sum();
                for row in &rows {
                    share = share.min(row.iter().zip(&terms).map(|(cosine, term)| cosine * term).sum::<f64>() / sum);
                }
            }
        }
        Some(self.factors.iter().map(|factor| share * factor).collect())
    }

    /// Least, nominal and largest factors with the friction of the joints.
    fn factors_with_friction(&self, friction: &Friction) -> Vec<[f64; 3]> {
        let least_load = UNLOADED * largest_load(&self.loads);
        let of = |k: usize| {
            let (load, travel, nominal) = (self.loads[k], self.travels[k], self.factors[k]);
            let is_loaded = load.length() > least_load;
            let ends = match self.reaches[k] {
                PlayReach::Disc { .. } if is_loaded => turned_products(load, travel, friction.turns_rad[k]),
                PlayReach::Disc { .. } => [-travel.length(), travel.length()],
                PlayReach::Slot { .. } if is_loaded => return [nominal; 3],
                PlayReach::Slot { .. } => [-travel.x.abs(), travel.x.abs()],
                PlayReach::Guide { clearance_m, largest_tilt_rad, .. } => {
                    // With friction the block may stay at the end across or at the end of its tilt, whichever it comes to first.
                    let across = travel.x * load.x.signum();
                    let tilted = travel.y * load.y.signum() * largest_tilt_rad / clearance_m;
                    if friction.coefficients[k] == 0.0 {
                        return [nominal; 3];
                    }
                    [across.min(tilted), across.max(tilted)]
                }
            };
            [f64::min(2.0 * ends[0], nominal), nominal, f64::max(2.0 * ends[1], nominal)]
        };
        (0..self.factors.len()).map(of).collect()
    }
}
