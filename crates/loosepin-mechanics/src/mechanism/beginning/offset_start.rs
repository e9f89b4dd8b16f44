//! The start of a mechanism whose journals are not all in the middle of their bearings.

use crate::mechanism::beginning::offset::StartOffset;
use crate::mechanism::compile::Mechanism;
use crate::mechanism::error::SampleError;
use crate::mechanism::ideal::IdealMotion;
use crate::mechanism::loops::constraints;
use crate::mechanism::sample::Sample;
use crate::mechanism::tree::kinematics::{Kinematics, Twist};
use crate::mechanism::tree::numbers::TreeNumbers;
use loosepin_math::{Dual, Numbers, Vec2, solve_square};

/// Pivot ratio of the loop equations below which the start is singular.
const SINGULAR_PIVOT_RATIO: f64 = 1e-9;

impl Mechanism {
    /// The numbers of the ideal tree with journals at `offsets`: e is a part of the loop equations, Φ(q, t, e) = 0.
    pub fn displaced(&self, ideal: &TreeNumbers<f64>, offsets: &[StartOffset]) -> TreeNumbers<f64> {
        let mut geometry = ideal.clone();
        for own in offsets {
            geometry.set_displacement(&self.ideal, self.plays[own.play], own.offset_m, ideal);
        }
        geometry
    }

    /// Coordinates and rates of the real tree at time zero, with journals at `offsets`, of a mechanism that its drives move:
    ///
    /// ```text
    /// Φ(q, t, e) = 0,    Φ_q q̇ = -Φ_t - Φ_e ė,    ṙ = r_q q̇ + r_e ė of every body
    /// ```
    ///
    /// # Errors
    /// The loops cannot close there, or only in a singular position.
    pub fn start_at(&self, sample: &Sample<f64>, offsets: &[StartOffset]) -> Result<(Vec<f64>, Vec<f64>), SampleError> {
        let geometry = self.displaced(&sample.ideal, offsets);
        let ideal = IdealMotion::new(self, &geometry, &sample.drives)?;
        let mut kinematics = ideal.kinematics().clone();
        if offsets.iter().any(|own| own.velocity_m_s != Vec2::zero()) {
            self.add_velocities(&ideal, &geometry, (&sample.ideal, offsets), &mut kinematics)?;
        }
        Ok(self.real_coordinates(&kinematics, &sample.real))
    }

    /// Puts the velocities with which the journals move in their bearings into `kinematics`.
    fn add_velocities(
        &self,
        ideal: &IdealMotion<'_>,
        geometry: &TreeNumbers<f64>,
        (centred, offsets): (&TreeNumbers<f64>, &[StartOffset]),
        kinematics: &mut Kinematics<f64>,
    ) -> Result<(), SampleError> {
        let tree = &self.ideal;
        let (n, columns, rows) = (tree.free, tree.coordinates(), tree.constraint_rows());
        let mut moving = TreeNumbers::<Dual<f64>>::broadcast(geometry);
        let centred = TreeNumbers::<Dual<f64>>::broadcast(centred);
        for own in offsets {
            let [x, y] = [(own.offset_m.x, own.velocity_m_s.x), (own.offset_m.y, own.velocity_m_s.y)]
                .map(|(value, derivative)| Dual { value, derivative });
            moving.set_displacement(tree, self.plays[own.play], Vec2::new(x, y), &centred);
        }
        let (positions, rates) = ideal.real_state();
        let mut coordinates: Vec<Dual<f64>> = positions.iter().map(|q| Dual::constant(*q)).collect();
        for (coordinate, rate) in coordinates[n..].iter_mut().zip(&rates[n..]) {
            coordinate.derivative = *rate;
        }
        let mut duals = Kinematics::<Dual<f64>>::new(tree);
        duals.set_positions(tree, &moving, &coordinates);
        let mut residuals = vec![Dual::constant(0.0); rows];
        constraints::residuals(tree, &moving, &duals, &mut residuals);
        let mut jacobian = vec![0.0; rows * columns];
        constraints::jacobian(tree, geometry, kinematics, &mut jacobian);
        let independent = self.ideal_rows();
        let mut matrix: Vec<f64> =
            independent.iter().flat_map(|&row| jacobian[row * columns..row * columns + n].iter().copied()).collect();
        let mut change: Vec<f64> = independent.iter().map(|&row| -residuals[row].derivative).collect();
        if n > 0 && !(solve_square(&mut matrix, n, &mut change) > SINGULAR_PIVOT_RATIO) {
            return Err(SampleError::Singular { time_s: 0.0, at: None });
        }
        for (coordinate, rate) in coordinates[..n].iter_mut().zip(change) {
            coordinate.derivative = rate;
        }
        duals.set_positions(tree, &moving, &coordinates);
        for (twist, pose) in kinematics.twists.iter_mut().zip(&duals.poses) {
            *twist = Twist {
                linear: Vec2::new(pose.position_m.x.derivative, pose.position_m.y.derivative),
                angular: pose.angle_rad().derivative,
            };
        }
        Ok(())
    }
}
