//! One row of the parameter table: all numbers of one sample of a mechanism.

use super::drive::Drives;
use super::error::SampleError;
use super::geometry::{Geometry, point_m};
use super::initial::initial_numbers;
use super::load::LoadGeometry;
use super::spring::SpringGeometry;
use super::{Mechanism, tree::points_of};
use crate::contact::{
    AmbrosioFriction, NormalContact, compliance_1_pa, cylinder_stiffness_n_m1_5, delivered_restitution,
    largest_valid_impact_speed_m_s,
};
use crate::math::{Real, Vec2};
use crate::model::{Contact, FrictionLaw, JointId, JointKind, SlidingVelocity, Stiffness, Values};

/// Numbers of a joint with play.
#[derive(Debug, Clone, Copy)]
pub struct PlayGeometry<T> {
    /// Centre of the bearing (hole) in its body's frame, m.
    pub bearing_arm_m: Vec2<T>,
    /// Centre of the journal (pin) in its body's frame, m.
    pub journal_arm_m: Vec2<T>,
    /// Radius R_i of the bearing, m.
    pub bearing_radius_m: T,
    /// Radial clearance c, m.
    pub clearance_m: T,
    /// Normal contact.
    pub normal: NormalContact<T>,
    /// Friction; coefficient zero where the contact has none.
    pub friction: AmbrosioFriction<T>,
    /// Whether friction acts at all.
    pub has_friction: bool,
    /// Reading of eq. (7).
    pub sliding_velocity: SlidingVelocity,
    /// Floor v_min of the impact speed, m/s.
    pub minimum_impact_speed_m_s: T,
    /// Impact speed beyond which the law is not meant to hold, m/s; infinite where no density is given.
    pub largest_valid_impact_speed_m_s: f64,
    /// Restitution that a free impact delivers under this χ.
    pub delivered_restitution: f64,
}

/// The numbers of one sample: the ideal mechanism, the real one, its contacts, springs, loads and drives.
#[derive(Debug, Clone)]
pub struct Sample<T> {
    /// For the tree in which every joint is ideal.
    pub ideal: Geometry<T>,
    /// For the tree in which joints with play are force elements.
    pub real: Geometry<T>,
    /// Joints with play, in the order of [`Mechanism::plays`].
    pub plays: Vec<PlayGeometry<T>>,
    /// Springs, in the order of the model.
    pub springs: Vec<SpringGeometry<T>>,
    /// Loads, in the order of the model.
    pub loads: Vec<LoadGeometry<T>>,
    /// Drives, in the order of the model.
    pub drives: Drives<T>,
    /// The given numbers of the initial state, in the order of the model.
    pub initial: Vec<f64>,
}

impl<T: Real> Sample<T> {
    /// Lays out `values` for `mechanism`.
    ///
    /// # Errors
    /// [`SampleError::ClearanceChangesTopology`] where a clearance is zero in one of the two only.
    pub fn new(mechanism: &Mechanism, values: &Values) -> Result<Self, SampleError> {
        let model = &mechanism.model;
        for (index, joint) in model.joints.iter().enumerate() {
            if let JointKind::Revolute { clearance: Some(clearance), .. } = &joint.kind {
                let clearance_m = values[clearance.radial_clearance_m];
                let compiled_with_play = mechanism.plays.contains(&JointId(index));
                if (clearance_m > 0.0) != compiled_with_play {
                    return Err(SampleError::ClearanceChangesTopology {
                        joint: joint.name.clone(),
                        clearance_m,
                        compiled_with_play,
                    });
                }
            }
        }
        let plays = mechanism.plays.iter().filter_map(|&joint| play(mechanism, values, joint)).collect();
        let drives = Drives::broadcast(&Drives::new(model, values));
        Ok(Self {
            ideal: Geometry::new(model, &mechanism.ideal, values),
            real: Geometry::new(model, &mechanism.real, values),
            plays,
            springs: model.springs.iter().map(|spring| SpringGeometry::new(model, spring, values)).collect(),
            loads: model.loads.iter().map(|load| LoadGeometry::new(model, load, values)).collect(),
            drives,
            initial: initial_numbers(model, values),
        })
    }
}

impl<T: Real> Sample<T> {
    /// The same sample of [`Mechanism::without_play`].
    pub fn without_play(self) -> Self {
        Self { real: self.ideal.clone(), plays: Vec::new(), ..self }
    }
}

fn play<T: Real>(mechanism: &Mechanism, values: &Values, joint: JointId) -> Option<PlayGeometry<T>> {
    let model = &mechanism.model;
    let kind = &model.joints[joint.0].kind;
    let JointKind::Revolute { clearance: Some(clearance), .. } = kind else { return None };
    let contact = &model.contacts[clearance.contact.0];
    let [bearing, journal] = points_of(kind);
    let bearing_radius_m = values[clearance.bearing_radius_m];
    let clearance_m = values[clearance.radial_clearance_m];
    let (stiffness_n_m_n, exponent) = stiffness(contact, values, bearing_radius_m, clearance_m);
    let damping_factor = contact.law.damping_factor(values[contact.restitution]);
    let friction = match &contact.friction {
        None => AmbrosioFriction { coefficient: T::zero(), lower_speed_m_s: T::zero(), upper_speed_m_s: T::one() },
        Some(friction) => match friction.law {
            FrictionLaw::Ambrosio => AmbrosioFriction {
                coefficient: T::from_f64(values[friction.coefficient]),
                lower_speed_m_s: T::from_f64(values[friction.lower_speed_m_s]),
                upper_speed_m_s: T::from_f64(values[friction.upper_speed_m_s]),
            },
        },
    };
    Some(PlayGeometry {
        bearing_arm_m: point_m(model, values, bearing),
        journal_arm_m: point_m(model, values, journal),
        bearing_radius_m: T::from_f64(bearing_radius_m),
        clearance_m: T::from_f64(clearance_m),
        normal: NormalContact {
            stiffness_n_m_n: T::from_f64(stiffness_n_m_n),
            exponent,
            damping_factor: T::from_f64(damping_factor),
        },
        friction,
        has_friction: contact.friction.is_some(),
        sliding_velocity: contact.friction.as_ref().map_or(SlidingVelocity::Material, |f| f.sliding_velocity),
        minimum_impact_speed_m_s: T::from_f64(values[contact.minimum_impact_speed_m_s]),
        largest_valid_impact_speed_m_s: validity_limit_m_s(contact, values),
        delivered_restitution: delivered_restitution(damping_factor),
    })
}

/// K, N/mⁿ, and n: from eq. (9) for this clearance, or as given.
fn stiffness(contact: &Contact, values: &Values, bearing_radius_m: f64, clearance_m: f64) -> (f64, f64) {
    match &contact.stiffness {
        Stiffness::Given { stiffness_n_m_n, exponent } => (values[*stiffness_n_m_n], values[*exponent]),
        Stiffness::Material { youngs_modulus_pa, poisson_ratio } => {
            let compliances =
                [0, 1].map(|side| compliance_1_pa(values[youngs_modulus_pa[side]], values[poisson_ratio[side]]));
            (cylinder_stiffness_n_m1_5(compliances, bearing_radius_m, clearance_m), 1.5)
        }
    }
}

fn validity_limit_m_s(contact: &Contact, values: &Values) -> f64 {
    match (&contact.stiffness, contact.density_kg_m3) {
        (Stiffness::Material { youngs_modulus_pa: [first, second], .. }, Some(density)) => {
            largest_valid_impact_speed_m_s(values[*first].min(values[*second]), values[density])
        }
        _ => f64::INFINITY,
    }
}
