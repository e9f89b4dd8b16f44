//! Friction in the joints while an output is pushed: how far from the frictionless place a journal may stop.
//!
//! A journal that is pressed into its bearing slides along it until the normal of the contact is within the angle of friction
//! φ_k = atan μ_k of the force in the joint: there it stays, its normal γ_k from the force, |γ_k| <= φ_k. The force in the joint is turned as
//! well, by the moments of friction M_k = R_k N_k sin γ_k at pins of radius R_k: by virtual work they add Σ_k M_k ∂θ_k/∂e_j to the
//! force F h_j in joint j, where θ_k is the angle by which the journal of joint k turns in its bearing. So the normal of joint j lies at
//!
//! ```text
//! t_j = γ_j + Σ_k B_jk sin γ_k,    B_jk = R_k N_k (ĥ_j × ∂θ_k/∂e_j)/N_j
//! |t_j| <= |φ_j + B_jj sin φ_j| + Σ_{k≠j} |B_jk| sin φ_k
//! ```
//!
//! from the direction of h_j, to first order in the moments; N_k is taken as large as they can make it.

use super::locked::{UNLOADED, largest_load};
use super::rig::Rig;
use loosepin_math::Vec2;
use loosepin_mechanics::mechanism::{PinShape, Sample};
use loosepin_mechanics::model::{BodyId, PlayId, Position, QuantityId, Relative, Values};
use loosepin_simulate::accuracy::{AccuracyError, DisplacedLoops, play_gradients};
use std::f64::consts::{PI, TAU};

/// Rounds in which forces grow by the moments that they make themselves; beyond, friction holds the mechanism.
const ROUNDS: usize = 30;

/// Friction of a reading.
pub(crate) struct Friction {
    /// Largest coefficient of each joint with play.
    pub coefficients: Vec<f64>,
    /// Angle by which the contact of each joint may lie off the frictionless place, rad: at most π, where friction may hold it anywhere.
    pub turns_rad: Vec<f64>,
    /// Share by which friction may change the load of each joint.
    load_shares: Vec<f64>,
    /// Largest change of that load under a unit push.
    pub load_changes: Vec<f64>,
    /// Largest change of each of its two components.
    pub component_changes: Vec<Vec2<f64>>,
    /// B_jk sin φ_k, rad: how the moment of joint k turns the force in joint j.
    across_rad: Vec<Vec<f64>>,
}

impl Friction {
    /// The friction under a unit push that loads the joints with `loads`, where the model has the values `values`.
    pub fn new(
        rig: &Rig<'_>,
        values: &Values,
        coordinates: &[f64],
        loads: &[Vec2<f64>],
        coefficients: &[f64],
    ) -> Result<Self, AccuracyError> {
        let coefficients = coefficients.to_vec();
        if coefficients.iter().all(|coefficient| *coefficient == 0.0) {
            let nothing = vec![0.0; coefficients.len()];
            return Ok(Self {
                component_changes: vec![Vec2::zero(); coefficients.len()],
                coefficients,
                turns_rad: nothing.clone(),
                load_shares: nothing.clone(),
                load_changes: nothing,
                across_rad: Vec::new(),
            });
        }
        let sample = Sample::new(&rig.mechanism, values)?;
        let mut loops = DisplacedLoops::new(&rig.mechanism, values);
        loops.set_position(coordinates);
        // How a unit force in joint k, turned by its whole angle of friction, changes the force in joint j.
        let mut changes = vec![vec![Vec2::zero(); loads.len()]; loads.len()];
        for (k, play) in rig.mechanism.plays.iter().enumerate() {
            let (Some(PinShape { bearing_radius_m }), Some((angle, sign))) =
                (sample.plays[k].shape.hole(), turn_in(rig, *play))
            else {
                continue;
            };
            let sine = coefficients[k] / (1.0 + coefficients[k] * coefficients[k]).sqrt();
            let turning = play_gradients(&mut loops, &[angle])?.swap_remove(0);
            for (j, turning) in turning.iter().enumerate() {
                changes[j][k] = *turning * (sign * sine * bearing_radius_m);
            }
        }
        let least = UNLOADED * largest_load(loads);
        let mut change = vec![0.0; loads.len()];
        for _ in 0..ROUNDS {
            let size = |k: usize| loads[k].length() + change[k];
            let sum = |row: &Vec<Vec2<f64>>| row.iter().enumerate().map(|(k, entry)| entry.length() * size(k)).sum();
            let next: Vec<f64> = changes.iter().map(sum).collect();
            change = next;
        }
        let component_changes = changes
            .iter()
            .map(|row| {
                let sizes = row.iter().enumerate().map(|(k, entry)| (entry, loads[k].length() + change[k]));
                sizes.fold(Vec2::zero(), |sum, (entry, size)| sum + Vec2::new(entry.x.abs(), entry.y.abs()) * size)
            })
            .collect();
        let load_shares: Vec<f64> =
            change.iter().zip(loads).map(|(change, load)| change / load.length().max(least)).collect();
        let turn_rad = |j: usize| {
            let own = loads[j].length().max(least);
            // Where moments may be as large as the force itself they may turn it anywhere.
            if load_shares[j] >= 1.0 {
                return PI;
            }
            let across = |k: usize| {
                let size = loads[k].length() + change[k];
                loads[j].cross(changes[j][k]) * size / (own * own * (1.0 - load_shares[j]))
            };
            let others: f64 = (0..loads.len()).filter(|k| *k != j).map(|k| across(k).abs()).sum();
            ((coefficients[j].atan() + across(j)).abs().max(coefficients[j].atan()) + others).min(PI)
        };
        let turns_rad = (0..loads.len()).map(turn_rad).collect();
        let across = |j: usize, k: usize| {
            let own = loads[j].length().max(least);
            loads[j].cross(changes[j][k]) * loads[k].length() / (own * own)
        };
        let across_rad = (0..loads.len()).map(|j| (0..loads.len()).map(|k| across(j, k)).collect()).collect();
        Ok(Self { coefficients, turns_rad, load_shares, load_changes: change, component_changes, across_rad })
    }
}

impl Friction {
    /// Cosines of the angles t_j where every γ_k is at an end ±φ_k, a row for each combination of signs: a sum Σ a_j cos t_j with a_j >= 0
    /// is least at one of them, since it is concave. What friction does to the loads themselves is added to each angle. Nothing without
    /// friction, where it may hold a joint anywhere, or for more than eight joints.
    pub fn least_cosines(&self) -> Option<Vec<Vec<f64>>> {
        const MAX_JOINTS: usize = 8;
        let joints = self.coefficients.len();
        let largest = self.load_shares.iter().fold(0.0_f64, |largest, share| largest.max(*share));
        if self.across_rad.is_empty() || joints > MAX_JOINTS || largest >= 0.5 {
            return None;
        }
        let slack = (1.0 + largest) / (1.0 - largest) - 1.0;
        let row = |bits: usize| {
            let sign = |k: usize| if (bits >> k) & 1 == 0 { 1.0 } else { -1.0 };
            let cosine = |j: usize| {
                let turned: f64 = (0..joints).map(|k| sign(k) * self.across_rad[j][k]).sum();
                let loose: f64 = self.across_rad[j].iter().map(|across| slack * across.abs()).sum();
                ((sign(j) * self.coefficients[j].atan() + turned).abs() + loose).min(PI).cos()
            };
            (0..joints).map(cosine).collect()
        };
        Some((0..1_usize << joints).map(row).collect())
    }
}

/// The largest coefficient of friction that the model and the study allow each joint; zero where its contact has no friction.
///
/// A coefficient may follow from other inputs: it is evaluated wherever they may be.
pub(crate) fn coefficients(rig: &Rig<'_>) -> Result<Vec<f64>, AccuracyError> {
    let (alone, together) = rig.other_values()?;
    let largest = |id: QuantityId| {
        let middle = rig.values[id];
        let added: f64 = alone.iter().map(|[low, high]| (low[id].max(high[id]) - middle).max(0.0)).sum();
        together.iter().map(|values| values[id]).fold(middle + added, f64::max)
    };
    Ok(rig.mechanism.plays.iter().map(|play| coefficient(rig, *play, largest)).collect())
}

/// The largest coefficient of friction of a joint, where `largest` is that of a quantity.
fn coefficient(rig: &Rig<'_>, play: PlayId, largest: impl Fn(QuantityId) -> f64) -> f64 {
    let model = &rig.mechanism.model;
    let Some(contact) = model.play_contact(play) else { return 0.0 };
    let table = format!("contact.{}.friction.", model.contacts[contact.0].name);
    let of_friction = model.quantities.iter().filter(|(_, quantity)| {
        let key = quantity.path.strip_prefix(&table);
        key.is_some_and(|key| key == "coefficient" || key == "static_coefficient")
    });
    of_friction.map(|(id, _)| largest(id)).fold(0.0, f64::max)
}

/// The angle by which the journal of a joint turns in its bearing, as an angle of bodies and its sign.
fn turn_in(rig: &Rig<'_>, play: PlayId) -> Option<(Position, f64)> {
    const GROUND: BodyId = BodyId(0);
    let PlayId::Joint(joint) = play else { return None };
    let [first, second] = rig.mechanism.model.joints[joint.0].kind.bodies();
    let (of, to, sign) = if second == GROUND { (first, second, -1.0) } else { (second, first, 1.0) };
    Some((Position::Angle(Relative { of, to: (to != GROUND).then_some(to) }), sign))
}

/// Least and largest travel·d for unit vectors d within `turn_rad` of the direction of `load`.
pub(crate) fn turned_products(load: Vec2<f64>, travel: Vec2<f64>, turn_rad: f64) -> [f64; 2] {
    let size = travel.length();
    if size == 0.0 {
        return [0.0; 2];
    }
    if turn_rad >= PI {
        return [-size, size];
    }
    // Angle from the travel to the load, -π to π.
    let between_rad = travel.cross(load).atan2(travel.dot(load));
    let ends = [between_rad - turn_rad, between_rad + turn_rad];
    let holds =
        |angle_rad: f64| [-TAU, 0.0, TAU].into_iter().any(|turn| (ends[0]..=ends[1]).contains(&(angle_rad + turn)));
    let [first, second] = ends.map(f64::cos);
    let least = if holds(PI) { -1.0 } else { first.min(second) };
    let largest = if holds(0.0) { 1.0 } else { first.max(second) };
    [size * least, size * largest]
}

#[cfg(test)]
mod tests {
    use super::turned_products;
    use loosepin_math::Vec2;

    #[test]
    fn analytic_products_within_the_angle_of_friction() {
        const TOLERANCE: f64 = 1e-15; // round-off
        let along = Vec2::new(0.3, 0.4);
        let [least, largest] = turned_products(along * 7.0, along, 0.1);
        assert!((largest - 0.5).abs() < TOLERANCE && (least - 0.5 * 0.1_f64.cos()).abs() < TOLERANCE);
        // Across: the sine of the angle, either way.
        let [least, largest] = turned_products(along.turned(), along, 0.1);
        assert!((largest - 0.5 * 0.1_f64.sin()).abs() < TOLERANCE && (least + largest).abs() < TOLERANCE);
        let [least, largest] = turned_products(along * -1.0, along, 0.1);
        assert!((least + 0.5).abs() < TOLERANCE && (largest + 0.5 * 0.1_f64.cos()).abs() < TOLERANCE);
        assert_eq!(turned_products(along, along, 4.0), [-0.5, 0.5]);
    }
}
