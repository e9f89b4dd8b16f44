//! How far play takes a vector along directions.

use crate::accuracy::error::AccuracyError;
use crate::accuracy::gains::Gains;
use crate::accuracy::pose_accuracy::PoseAccuracy;
use crate::accuracy::slice::{dot, largest};
use crate::geometry::vector::Vec3;

impl PoseAccuracy<'_> {
    /// For each direction n the displacement d, to first order, that goes farthest along it: n·d is the worst case of the component along n. The
    /// components are those along x, y and z. All displacements lie in the convex set with this support function.
    ///
    /// # Errors
    ///
    /// [`AccuracyError::NoPlace`], as for [`Self::first_order`]; [`AccuracyError::OutputDoesNotFit`] without three components.
    pub fn farthest(&self, components: &[Gains], directions: &[Vec3]) -> Result<Vec<Vec3>, AccuracyError> {
        let [x, y, z] = components else { return Err(AccuracyError::OutputDoesNotFit) };
        let [x, y, z] = [x, y, z].map(|gains| self.scaled_gains(gains));
        let zero = vec![0.0; self.redundant.len()];
        let along = |n: &Vec3| {
            let gains: Vec<f64> = x.iter().zip(&y).zip(&z).map(|((x, y), z)| n.x * x + n.y * y + n.z * z).collect();
            let found = largest(&self.set, &gains, None, &self.planes, &zero).ok_or(AccuracyError::NoPlace)?;
            Ok(Vec3::from([&x, &y, &z].map(|own| dot(own, &found.place))))
        };
        directions.iter().map(along).collect()
    }
}
