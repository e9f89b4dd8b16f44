//! The numbers of loads.

use super::joint_geometry::JointGeometry;
use super::points::point_m;
use crate::model::{Course, Load, LoadKind, Model, QuantityId, Values};
use loosepin_math::{Real, Vec2, numbers, sin_cos};

/// Numbers of a load.
#[derive(Debug, Clone)]
pub struct LoadGeometry<T> {
    /// Point of attack in the frame of the body, m; zero for a torque.
    pub arm_m: Vec2<T>,
    /// Direction of a force, of length one, in the frame of the ground or of the body.
    pub direction: Vec2<T>,
    /// Numbers of its course.
    pub course: CourseNumbers<T>,
    /// The joint that it reads.
    pub joint: JointGeometry<T>,
}

numbers!(struct LoadGeometry { arm_m, direction, joint, course });

/// Numbers of a course.
#[derive(Debug, Clone)]
pub enum CourseNumbers<T> {
    /// A constant.
    Constant(T),
    /// mean + amplitude sin(ω t + φ).
    Harmonic {
        /// Its middle.
        mean: T,
        /// Largest departure from the middle.
        amplitude: T,
        /// ω, rad/s.
        angular_frequency_rad_s: T,
        /// φ, rad.
        phase_rad: T,
    },
    /// The parameters of its function.
    Function(Vec<T>),
}

numbers!(enum CourseNumbers {
    Constant(value),
    Harmonic { mean, amplitude, angular_frequency_rad_s, phase_rad },
    Function(parameters),
});

impl<T: Real> CourseNumbers<T> {
    /// Lays out the numbers that `number` gives for the quantities of `course`.
    pub fn new(course: &Course, number: &dyn Fn(QuantityId) -> T) -> Self {
        match course {
            Course::Constant(id) => Self::Constant(number(*id)),
            Course::Harmonic { mean, amplitude, frequency, phase_rad } => Self::Harmonic {
                mean: number(*mean),
                amplitude: number(*amplitude),
                angular_frequency_rad_s: number(*frequency) * T::from_f64(std::f64::consts::TAU),
                phase_rad: number(*phase_rad),
            },
            Course::Function(function) => Self::Function(function.parameters.iter().map(|id| number(*id)).collect()),
        }
    }

    /// The value at the time `variables[0]`, for a function at all `variables`; `room` is as [`crate::model::Function::value`]
    /// needs it.
    #[inline(always)]
    pub fn value(&self, course: &Course, variables: &[T], room: &mut [T]) -> T {
        match (self, course) {
            (Self::Constant(value), _) => *value,
            (Self::Harmonic { mean, amplitude, angular_frequency_rad_s, phase_rad }, _) => {
                let (sine, _) = angular_frequency_rad_s.mul_add(variables[0], *phase_rad).sin_cos();
                amplitude.mul_add(sine, *mean)
            }
            (Self::Function(parameters), Course::Function(function)) => function.value(
                parameters,
                variables,
                #[inline(always)]
                |number| number,
                room,
            ),
            // Numbers are laid out for their own course.
            (Self::Function(_), _) => T::zero(),
        }
    }
}

impl<T: Real> LoadGeometry<T> {
    /// Lays out `values` for a load of `model`.
    pub fn new(model: &Model, load: &Load, values: &Values) -> Self {
        let number = |id| T::from_f64(values[id]);
        let along = |angle_rad: f64| {
            let (sine, cosine) = sin_cos(angle_rad);
            Vec2::from_f64(Vec2::new(cosine, sine))
        };
        let (arm_m, direction) = match load.kind {
            LoadKind::Force { point, direction_rad, .. } => {
                (point_m(model, values, point), along(values[direction_rad]))
            }
            LoadKind::Torque { .. } => (Vec2::zero(), Vec2::zero()),
        };
        Self {
            arm_m,
            direction,
            course: CourseNumbers::new(&load.course, &number),
            joint: load.joint.map_or(JointGeometry::none(), |joint| JointGeometry::new(model, joint, &number)),
        }
    }
}
