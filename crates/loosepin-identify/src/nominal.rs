//! The linear model of a reading at one set of values: gradients, and the factor of each joint, without and with friction.

use super::friction::{Friction, turned_products};
use super::locked::{Test, UNLOADED, gradient, largest_load, locked_at, pushed, reaches};
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::{Mechanism, Sample};
use loosepin_mechanics::model::{Position, Values};
use loosepin_simulate::accuracy::{AccuracyError, DisplacedLoops, PlayReach};

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

    /// 2 max(|g_y|, |g_θ|/a) at guides, zero at other joints.
    pub fn guide_factors(&self) -> Vec<f64> {
        let of = |(reach, travel): (&PlayReach, &Vec2<f64>)| match reach {
            PlayReach::Guide { half_length_m, .. } => 2.0 * f64::max(travel.x.abs(), travel.y.abs() / half_length_m),
            PlayReach::Disc { .. } | PlayReach::Slot { .. } => 0.0,
        };
        self.reaches.iter().zip(&self.travels).map(of).collect()
    }

    /// Least factors with friction where it is read where it is pushed: the same share of all nominal ones. Friction does not turn
    /// all joints furthest at once, so that the sum falls by less than its terms may. The share is the least of
    /// Σ A_j cos t_j r_j / Σ A_j r_j over the corners of the radii r, where a ratio of linear functions is least.
    pub fn uniformly_reduced_factors(&self, friction: &Friction, radii_m: &[[f64; 2]]) -> Option<Vec<f64>> {
        /// Round-off of 2 |g| beside the factor.
        const SAME: f64 = 1e-9;
        let joints = self.factors.len();
        let is_same = |k: usize| {
            let due = 2.0 * self.travels[k].length();
            matches!(self.reaches[k], PlayReach::Disc { .. }) && (self.factors[k] - due).abs() <= SAME * due
        };
        // There are rows for eight joints at most.
        let rows = friction.least_cosines().filter(|_| (0..joints).all(is_same))?;
        let mut share = 1.0_f64;
        for bits in 0..1_usize << joints {
            let terms: Vec<f64> = (0..joints).map(|k| self.factors[k] * radii_m[k][(bits >> k) & 1]).collect();
            let sum: f64 = terms.iter().sum();
            for row in rows.iter().filter(|_| sum > 0.0) {
                share = share.min(row.iter().zip(&terms).map(|(cosine, term)| cosine * term).sum::<f64>() / sum);
            }
        }
        Some(self.factors.iter().map(|factor| share * factor).collect())
    }

    /// Least, nominal and largest factors with the friction of the joints.
    pub fn factors_with_friction(&self, friction: &Friction) -> Vec<[f64; 3]> {
        let least_load = UNLOADED * largest_load(&self.loads);
        let of = |k: usize| {
            let (load, travel, nominal) = (self.loads[k], self.travels[k], self.factors[k]);
            let is_loaded = load.length() > least_load;
            let change = friction.component_changes[k];
            let ends = match self.reaches[k] {
                PlayReach::Disc { .. } if is_loaded => turned_products(load, travel, friction.turns_rad[k]),
                PlayReach::Disc { .. } => [-travel.length(), travel.length()],
                // The moments of friction may turn the force about.
                PlayReach::Slot { .. } if is_loaded && load.x.abs() > change.x => return [nominal; 3],
                PlayReach::Slot { .. } => [-travel.x.abs(), travel.x.abs()],
                PlayReach::Guide { clearance_m, largest_tilt_rad, .. } => {
                    let tilt_per_m = largest_tilt_rad / clearance_m;
                    guide_ends(load, travel, change, tilt_per_m, is_loaded, friction.coefficients[k])
                }
            };
            [f64::min(2.0 * ends[0], nominal), nominal, f64::max(2.0 * ends[1], nominal)]
        };
        (0..self.factors.len()).map(of).collect()
    }
}

/// Half the least and the largest factor of a guide.
///
/// The block goes to the end, across or tilted, where the work is larger; with friction in the guide it may stay at either, whichever it
/// comes to first. Where nothing loads it, or friction of pins may load it by more, it may be at an end on either side.
fn guide_ends(
    load: Vec2<f64>,
    travel: Vec2<f64>,
    change: Vec2<f64>,
    tilt_per_m: f64,
    is_loaded: bool,
    coefficient: f64,
) -> [f64; 2] {
    let works = if is_loaded { [load.x.abs(), load.y.abs() * tilt_per_m] } else { [0.0; 2] };
    let changes = [change.x, change.y * tilt_per_m];
    let least = UNLOADED * works[0].max(works[1]);
    let ends = [(travel.x, load.x), (travel.y * tilt_per_m, load.y)];
    let mut found = [f64::INFINITY, f64::NEG_INFINITY];
    for (own, other) in [(0, 1), (1, 0)] {
        let (travel, load) = ends[own];
        if coefficient == 0.0 && works[own] + changes[own] < works[other] - changes[other] {
            continue;
        }
        let is_sure = works[own] > least.max(changes[own]);
        let [low, high] = if is_sure { [travel * load.signum(); 2] } else { [-travel.abs(), travel.abs()] };
        found = [found[0].min(low), found[1].max(high)];
    }
    found
}

#[cfg(test)]
mod tests {
    use super::guide_ends;
    use loosepin_math::Vec2;

    #[test]
    fn analytic_a_guide_without_load_is_free_either_way() {
        let (travel, nothing) = (Vec2::new(0.3, -0.02), Vec2::zero());
        for coefficient in [0.0, 0.1] {
            // Across 0.3, tilted 0.02 times 20 = 0.4.
            assert_eq!(guide_ends(nothing, travel, nothing, 20.0, false, coefficient), [-0.4, 0.4]);
        }
    }

    #[test]
    fn analytic_a_guide_that_is_pushed_across_only_may_tilt_either_way() {
        let (load, travel, nothing) = (Vec2::new(-2.0, 0.0), Vec2::new(0.3, 0.01), Vec2::zero());
        // Without friction it goes across, against the travel; with friction it may stay tilted by 0.01 times 20 either way.
        assert_eq!(guide_ends(load, travel, nothing, 20.0, true, 0.0), [-0.3, -0.3]);
        assert_eq!(guide_ends(load, travel, nothing, 20.0, true, 0.1), [-0.3, 0.2]);
        // Friction of pins that may load it by more than the push does.
        assert_eq!(guide_ends(load, travel, Vec2::new(3.0, 0.0), 20.0, true, 0.0), [-0.3, 0.3]);
    }
}
