//! The numbers of controls, and the open chain along which torques are fed forward.

use crate::mechanism::error::MechanismError;
use crate::mechanism::loops::joint_geometry::JointGeometry;
use crate::mechanism::parts::load::CourseNumbers;
use crate::mechanism::tree::numbers::TreeNumbers;
use crate::mechanism::tree::spanning_tree::Tree;
use crate::model::{Control, FeedForward, JointId, Model, QuantityId, Values};
use loosepin_math::{Real, numbers};

/// Numbers of a control.
#[derive(Debug, Clone)]
pub struct ControlGeometry<T> {
    /// k_p.
    pub proportional: T,
    /// k_i, where there is one.
    pub integral: Option<T>,
    /// k_d, where there is one.
    pub derivative: Option<T>,
    /// Largest torque or force, N m or N, where there is one.
    pub limit: Option<T>,
    /// Numbers of the torque or force that is fed forward by a course.
    pub feed_forward: Option<CourseNumbers<T>>,
    /// The joint of the actuator.
    pub actuated: JointGeometry<T>,
    /// The measured joint.
    pub measured: JointGeometry<T>,
}

numbers!(struct ControlGeometry {
    proportional, integral, derivative, limit, feed_forward, actuated, measured
});

impl<T: Real> ControlGeometry<T> {
    /// Lays out `values` for a control of `model`.
    pub fn new(model: &Model, control: &Control, values: &Values) -> Self {
        let number = |id: QuantityId| T::from_f64(values[id]);
        Self {
            proportional: number(control.proportional),
            integral: control.integral.map(number),
            derivative: control.derivative.map(number),
            limit: control.limit.map(number),
            feed_forward: match &control.feed_forward {
                // What is fed forward is no table.
                FeedForward::TimeCourse(course) => CourseNumbers::new(course, values).ok(),
                FeedForward::None | FeedForward::InverseDynamics => None,
            },
            actuated: JointGeometry::new(model, control.joint, &number),
            measured: JointGeometry::new(model, control.measured, &number),
        }
    }
}

/// The mechanism as its controllers know it: an open chain without play whose joints all follow drives and references, with
/// the values that the mechanism was compiled with.
///
/// Its motion is known without solving anything, and with it the torques and forces that inertia and weight need.
#[derive(Debug, Clone)]
pub struct KnownChain {
    /// Its tree. Driven coordinates are numbered over the drives of the model, then over its controls.
    pub tree: Tree,
    /// Its numbers.
    pub geometry: TreeNumbers<f64>,
}

impl KnownChain {
    /// The chain of `model`, where a control feeds inverse dynamics forward.
    ///
    /// # Errors
    /// Something of the mechanism neither drives nor controls move, or it has closed loops.
    pub fn new(model: &Model, values: &Values) -> Result<Option<Self>, MechanismError> {
        let is_inverse = |control: &&Control| matches!(control.feed_forward, FeedForward::InverseDynamics);
        let Some(control) = model.controls.iter().find(is_inverse) else { return Ok(None) };
        let refused = |reason| MechanismError::NoInverseDynamics { control: control.name.clone(), reason };
        let drives = model.drives.iter().map(|drive| drive.joint);
        let moved: Vec<JointId> = drives.chain(model.controls.iter().map(|control| control.joint)).collect();
        let tree = Tree::with_driven(model, |_| true, &moved).map_err(|_| refused(HAS_LOOPS))?;
        if tree.constraint_rows() > 0 {
            return Err(refused(HAS_LOOPS));
        }
        if tree.free > 0 {
            return Err(refused(HAS_FREE_JOINTS));
        }
        let geometry = TreeNumbers::new(model, &tree, values);
        Ok(Some(Self { tree, geometry }))
    }

    /// The control of driven coordinate `k`, as an index of the model's list; `None` for a drive.
    pub fn control_of(&self, model: &Model, k: usize) -> Option<usize> {
        self.tree.drives[k].0.checked_sub(model.drives.len())
    }
}

/// Why there is no chain.
pub(in crate::mechanism) const HAS_LOOPS: &str = "the mechanism has closed loops or couplings";
/// Why there is no chain.
pub(in crate::mechanism) const HAS_FREE_JOINTS: &str = "not every joint is driven or controlled";
