//! How far play takes a vector along directions.

use crate::accuracy::error::AccuracyError;
use crate::accuracy::gains::Gains;
use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::accuracy::vector_reach::VectorReach;
use loosepin_math::Vec3;

impl PoseAccuracy<'_> {
    /// For each direction n the displacement d, to first order, that goes farthest along it: n·d is the worst case of the component along n. The
    /// components are those along x, y and z. All displacements lie in the convex set with this support function.
    ///
    /// # Errors
    ///
    /// [`AccuracyError::NoPlace`], as for [`Self::first_order`]; [`AccuracyError::OutputDoesNotFit`] without three components.
    pub fn farthest(&self, components: &[Gains], directions: &[Vec3]) -> Result<Vec<Vec3>, AccuracyError> {
        if components.len() != 3 {
            return Err(AccuracyError::OutputDoesNotFit);
        }
        let mut reach = VectorReach::new(self, components)?;
        directions.iter().map(|n| reach.farthest(n.to_array()).map(Vec3::from)).collect()
    }
}
