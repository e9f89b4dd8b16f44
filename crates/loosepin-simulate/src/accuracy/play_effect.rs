//! What play does to an output at one position, to first order.

use super::play_reach::PlayReach;
use super::worst_case::{disc_standard_deviation_si, first_order_si, rim_standard_deviation_si};
use loosepin_math::Vec2;
use loosepin_result::motion::ClearanceAnswer;

/// What play does to an output at one position, to first order.
pub(super) struct PlayEffect {
    /// The worst case.
    pub worst_si: f64,
    /// The part of each joint with play in it.
    pub by_joint_si: Vec<f64>,
    /// Standard deviation with the journals anywhere in their play, where it has a closed form.
    pub disc_standard_deviation_si: Option<f64>,
    /// The same with the journals on the rims.
    pub rim_standard_deviation_si: Option<f64>,
    /// The worst case with pins that do not lean, where they do.
    pub held_si: Option<f64>,
}

impl PlayEffect {
    /// Of plays that do not depend on each other, with the gradient of the output by each.
    pub fn of_joints(joints: &[(PlayReach, Vec2<f64>)]) -> Self {
        Self {
            worst_si: first_order_si(joints),
            by_joint_si: joints.iter().map(|joint| first_order_si(&[*joint])).collect(),
            disc_standard_deviation_si: Some(disc_standard_deviation_si(joints)),
            rim_standard_deviation_si: Some(rim_standard_deviation_si(joints)),
            held_si: None,
        }
    }

    /// Adds it to an answer as its next position.
    pub fn add_to(self, answer: &mut ClearanceAnswer) {
        let known = answer.first_order_si.len();
        answer.first_order_si.push(self.worst_si);
        answer.held_first_order_si.extend(self.held_si);
        for (contributor, effect_si) in answer.contributors.iter_mut().zip(self.by_joint_si) {
            contributor.first_order_si.push(effect_si);
        }
        let deviations = [
            (&mut answer.disc_standard_deviation_si, self.disc_standard_deviation_si),
            (&mut answer.rim_standard_deviation_si, self.rim_standard_deviation_si),
        ];
        for (history, deviation_si) in deviations {
            // Without a closed form at one position there is no history.
            match deviation_si {
                Some(deviation_si) if history.len() == known => history.push(deviation_si),
                _ => history.clear(),
            }
        }
    }
}
