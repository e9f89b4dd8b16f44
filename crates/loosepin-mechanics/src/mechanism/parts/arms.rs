//! Positions of all points in their bodies.

use crate::mechanism::compile::Mechanism;
use crate::model::{Body, PointId, Values};
use loosepin_math::{Numbers, Real, Vec2};

/// Positions of all points of a model in their body frames, for one sample or one a lane.
#[derive(Debug, Clone)]
pub struct Arms<T = f64>(Vec<Vec<Vec2<T>>>);

impl Arms {
    /// Reads the points of `mechanism` from `values`.
    pub fn new(mechanism: &Mechanism, values: &Values) -> Self {
        let model = &mechanism.model;
        let of_body = |body: &Body| {
            body.points.iter().map(|p| Vec2::new(values[p.position_m[0]], values[p.position_m[1]])).collect()
        };
        Self(model.bodies.iter().map(of_body).collect())
    }

    /// Every coordinate, in the order of [`Arms::visit`].
    pub fn numbers(&self) -> Vec<f64> {
        self.0.iter().flatten().flat_map(|point| [point.x, point.y]).collect()
    }

    /// No points: for runs whose outputs are not followed.
    pub fn none() -> Self {
        Self(Vec::new())
    }
}

impl<T: Real> Arms<T> {
    /// Position of `point` in its body's frame, m.
    #[inline(always)]
    pub fn of(&self, point: PointId) -> Vec2<T> {
        self.0[point.body.0][point.point]
    }

    /// Shows every coordinate, in the order of the model.
    pub fn visit(&mut self, visit: &mut impl FnMut(&mut T)) {
        self.0.iter_mut().flatten().for_each(|point| point.visit(visit));
    }

    /// The points of `from` as constants of `T`.
    pub fn broadcast(arms: &Arms) -> Self {
        Self(arms.0.iter().map(|body| body.iter().map(|point| Vec2::from_f64(*point)).collect()).collect())
    }
}
