//! A body at the end of a chain of driven joints.

use crate::accuracy::PlaySet;
use crate::chain::error::ChainError;
use crate::chain::joint_turn::{ChainPose, JointPlace};
use crate::chain::sample::ChainSample;
use crate::mechanism::body_tree::{BodyTree, TreeJoint};
use crate::mechanism::drive::JointCoordinate;
use crate::mechanism::marker::Marker;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use loosepin_math::sin_cos;

/// Where the angle and the slide of a joint come from.
#[derive(Debug, Clone, Copy)]
struct Held {
    angle: Option<usize>,
    slide: Option<usize>,
    /// Advance for each rad, m.
    advance_m_rad: f64,
}

/// The chain of joints from the ground to a body, all their coordinates held by drives. The body's pose is a product of transforms, exact with
/// play as [`crate::PoseAccuracy::displaced`] is, without equations to solve.
#[derive(Debug, Clone)]
pub struct OpenChain<'a> {
    mechanism: &'a SpatialMechanism,
    path: Vec<TreeJoint>,
    held: Vec<Held>,
    set: PlaySet,
}

impl<'a> OpenChain<'a> {
    /// The chain from the ground to `body`.
    ///
    /// # Errors
    ///
    /// [`ChainError`]: no such body, a loop, a joint that is not driven.
    pub fn new(mechanism: &'a SpatialMechanism, body: usize) -> Result<Self, ChainError> {
        let path = path_to(mechanism, body)?;
        let held = path.iter().map(|joint| held(mechanism, joint.joint)).collect::<Result<_, _>>()?;
        Ok(Self { mechanism, path, held, set: PlaySet::new(mechanism) })
    }

    /// The variables of play, in the order of [`Self::sample`].
    pub fn play_set(&self) -> &PlaySet {
        &self.set
    }

    /// The chain at values of all drives of the mechanism, rad and m. Drives that are not given are at zero.
    pub fn pose(&self, drives: &[f64]) -> ChainPose {
        let value = |drive: Option<usize>| drive.and_then(|drive| drives.get(drive)).copied().unwrap_or(0.0);
        let places = self.held.iter();
        let places = places.map(|held| {
            let angle = value(held.angle);
            let (sine, cosine) = sin_cos(angle);
            JointPlace { sine, cosine, slide_m: value(held.slide) + held.advance_m_rad * angle }
        });
        ChainPose { places: places.collect() }
    }

    /// One chain of a series: with given variables of play, m, and markers of each joint of the mechanism (bearing, journal) where they scatter.
    pub fn sample(&self, variables_m: &[f64], markers: Option<&[[Marker; 2]]>) -> ChainSample {
        ChainSample::new(self.mechanism, &self.path, &self.set.shifts(self.mechanism, variables_m), markers)
    }
}

/// The joints from the ground to `body`, if there is one way only.
fn path_to(mechanism: &SpatialMechanism, body: usize) -> Result<Vec<TreeJoint>, ChainError> {
    if body == 0 || body >= mechanism.bodies().len() {
        return Err(ChainError::NoBody { body });
    }
    let tree = BodyTree::of_short_branches(mechanism);
    let path = tree.branch(body);
    if path.is_empty() || path.iter().any(|joint| tree.is_in_loop(mechanism, joint)) {
        return Err(ChainError::NotAChain { body: mechanism.bodies()[body].name.clone() });
    }
    Ok(path)
}

/// Where the coordinates of a joint come from.
fn held(mechanism: &SpatialMechanism, joint: usize) -> Result<Held, ChainError> {
    let kind = &mechanism.joints()[joint].kind;
    let drive = |coordinate: JointCoordinate| {
        mechanism.drives().iter().position(|drive| drive.joint == joint && drive.coordinate == coordinate)
    };
    let (mut angle, mut slide) = (drive(JointCoordinate::Angle), drive(JointCoordinate::Slide));
    let pitch_m = kind.pitch_m();
    let advance_m_rad = pitch_m.map_or(0.0, |pitch_m| pitch_m / std::f64::consts::TAU);
    // Six rows and what is held leave nothing free; of a screw its angle is enough.
    let is_held = if pitch_m.is_some() {
        slide = None;
        angle.is_some()
    } else {
        if !kind.turns() {
            angle = None;
        }
        kind.freedoms() == usize::from(angle.is_some()) + usize::from(slide.is_some())
    };
    if !is_held {
        return Err(ChainError::NotDriven { joint: mechanism.joints()[joint].name.clone() });
    }
    Ok(Held { angle, slide, advance_m_rad })
}
