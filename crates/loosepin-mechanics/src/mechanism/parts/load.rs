//! The numbers of loads.

use crate::mechanism::loops::joint_geometry::JointGeometry;
use crate::mechanism::parts::load_table::TableNumbers;
use crate::mechanism::tree::points::point_m;
use crate::model::{ActsOn, Load, LoadTable, Model, PeriodProblem, Steady, TimeCourse, Values};
use loosepin_math::{Numbers, Real, Vec2, numbers};

/// Numbers of a load.
#[derive(Debug, Clone)]
pub struct LoadGeometry<T> {
    /// Point of attack in the frame of the body, m; zero for a torque.
    pub arm_m: Vec2<T>,
    /// Numbers of its kind, in an order of its own.
    pub own: Vec<T>,
    /// Numbers of its course, where it has one.
    pub course: Option<CourseNumbers<T>>,
    /// The joint that it reads.
    pub joint: JointGeometry<T>,
    /// Start and rate of what a table is over, where that goes evenly with the time.
    pub clock: Option<[f64; 2]>,
}

numbers!(struct LoadGeometry { arm_m, own, joint, course; clock });

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
    /// The curve through its points.
    Table(TableNumbers<T>),
}

numbers!(enum CourseNumbers {
    Constant(value),
    Harmonic { mean, amplitude, angular_frequency_rad_s, phase_rad },
    Function(parameters),
    Table(table),
});

impl<T: Real> CourseNumbers<T> {
    /// Lays out `values` for `course`.
    ///
    /// # Errors
    /// The points of a table do not fit its period.
    pub fn new(course: &TimeCourse, values: &Values) -> Result<Self, PeriodProblem> {
        let number = |id| T::from_f64(values[id]);
        Ok(match course {
            TimeCourse::Constant(id) => Self::Constant(number(*id)),
            TimeCourse::Harmonic { mean, amplitude, frequency, phase_rad } => Self::Harmonic {
                mean: number(*mean),
                amplitude: number(*amplitude),
                angular_frequency_rad_s: number(*frequency) * T::from_f64(std::f64::consts::TAU),
                phase_rad: number(*phase_rad),
            },
            TimeCourse::Function(function) => {
                Self::Function(function.parameters.iter().map(|id| number(*id)).collect())
            }
            TimeCourse::Table(table) => Self::Table(TableNumbers::broadcast(&TableNumbers::new(table, values)?)),
        })
    }

    /// The value at the time `variables[0]`, of a function or a table at all `variables`; `workspace` is as [`crate::model::Function::value`]
    /// needs it.
    #[inline(always)]
    pub fn value(&self, course: &TimeCourse, variables: &[T], workspace: &mut [T]) -> T {
        match (self, course) {
            (Self::Constant(value), _) => *value,
            (Self::Harmonic { mean, amplitude, angular_frequency_rad_s, phase_rad }, _) => {
                let (sine, _) = angular_frequency_rad_s.mul_add(variables[0], *phase_rad).sin_cos();
                amplitude.mul_add(sine, *mean)
            }
            (Self::Function(parameters), TimeCourse::Function(function)) => function.value(
                parameters,
                variables,
                #[inline(always)]
                |number| number,
                workspace,
            ),
            (Self::Table(numbers), TimeCourse::Table(table)) => numbers.value(variables[table.variable]),
            // Numbers are laid out for their own course.
            (Self::Function(_) | Self::Table(_), _) => T::zero(),
        }
    }
}

impl<T: Real> LoadGeometry<T> {
    /// Lays out `values` for a load of `model`.
    ///
    /// # Errors
    /// As [`CourseNumbers::new`].
    pub fn new(model: &Model, load: &Load, values: &Values) -> Result<Self, PeriodProblem> {
        let number = |id| T::from_f64(values[id]);
        let arm_m = match load.kind.acts_on() {
            ActsOn::Point(point) => point_m(model, values, point),
            ActsOn::Body(_) => Vec2::zero(),
        };
        let own = load.kind.numbers(&|id| values[id]);
        let course = load.course.as_ref().map(|course| CourseNumbers::new(course, values));
        Ok(Self {
            arm_m,
            own: own.into_iter().map(T::from_f64).collect(),
            course: course.transpose()?,
            joint: load.joint.map_or(JointGeometry::none(), |joint| JointGeometry::new(model, joint, &number)),
            clock: clock(model, load, values),
        })
    }
}

impl LoadGeometry<f64> {
    /// The first time after `time_s` at which two pieces of its table meet, s; infinite where there is none, or where only the run
    /// will show when that is.
    pub fn next_break_s(&self, time_s: f64) -> f64 {
        match (&self.course, self.clock) {
            (Some(CourseNumbers::Table(table)), Some(clock)) => table.next_break_s(clock, time_s),
            _ => f64::INFINITY,
        }
    }
}

/// Start and rate of what the table of `load` is over, where that goes evenly with the time: the time itself, or the coordinate of a
/// joint that is driven at constant speed.
fn clock(model: &Model, load: &Load, values: &Values) -> Option<[f64; 2]> {
    let Some(TimeCourse::Table(LoadTable { variable, .. })) = &load.course else { return None };
    match variable {
        0 => Some([0.0, 1.0]),
        1 => {
            let mut of_joint = model.drives.iter().filter(|drive| Some(drive.joint) == load.joint);
            of_joint.find_map(|drive| {
                let Steady { speed, start } = drive.law.steady()?;
                (values[speed] != 0.0).then(|| [values[start], values[speed]])
            })
        }
        _ => None,
    }
}
