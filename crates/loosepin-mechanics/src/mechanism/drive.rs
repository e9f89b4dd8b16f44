//! The motions that drives prescribe: position, velocity and acceleration of the driven coordinates.

use super::table::{AtTime, TableMotion, TablePiece};
use crate::model::{DriveId, DriveLaw, Model, QuantityId, Values};
use loosepin_math::{Dual, Real, numbers};
use std::sync::Arc;

/// Second-order dual number over time: value, rate and acceleration at once.
pub type TimeDual<T> = Dual<Dual<T>>;

/// Numbers of the motion of a driven coordinate, m or rad.
#[derive(Debug, Clone)]
pub enum DriveMotion<T> {
    /// start + speed · t.
    Constant {
        /// At time zero.
        start: T,
        /// Rate, m/s or rad/s.
        speed: T,
    },
    /// Σ c_k (t - t0)^k: a polynomial, or the present piece of a table.
    Polynomial {
        /// t0, s.
        origin_s: T,
        /// c_0, c_1, ...
        coefficients: Vec<T>,
    },
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
    /// from + rise (τ - sin(2π τ)/2π), τ = (t - dwell)/duration cut to [0, 1].
    Cycloidal {
        /// Where it rests before.
        from: T,
        /// How far it rises.
        rise: T,
        /// Duration of the rise, s.
        duration_s: T,
        /// Rest before the rise, s.
        dwell_s: T,
    },
    /// The parameters of its function.
    Function(Vec<T>),
}

numbers!(enum DriveMotion {
    Constant { start, speed },
    Polynomial { origin_s, coefficients },
    Harmonic { mean, amplitude, angular_frequency_rad_s, phase_rad },
    Cycloidal { from, rise, duration_s, dwell_s },
    Function(parameters),
});

impl<T: Real> DriveMotion<T> {
    /// The motion by `law` with the numbers that `number` gives; a table is in the piece that holds `time_s`.
    pub fn new(law: &DriveLaw, number: &dyn Fn(QuantityId) -> T, time_s: f64) -> Self
    where
        T: AtTime,
    {
        match law {
            DriveLaw::Constant { speed, start } => Self::Constant { start: number(*start), speed: number(*speed) },
            DriveLaw::Polynomial { coefficients } => Self::Polynomial {
                origin_s: T::zero(),
                coefficients: coefficients.iter().map(|id| number(*id)).collect(),
            },
            DriveLaw::Harmonic { mean, amplitude, frequency, phase_rad } => Self::Harmonic {
                mean: number(*mean),
                amplitude: number(*amplitude),
                angular_frequency_rad_s: number(*frequency) * T::from_f64(std::f64::consts::TAU),
                phase_rad: number(*phase_rad),
            },
            DriveLaw::Cycloidal { from, to, duration_s, dwell_s } => Self::Cycloidal {
                from: number(*from),
                rise: number(*to) - number(*from),
                duration_s: number(*duration_s),
                dwell_s: number(*dwell_s),
            },
            DriveLaw::Table { points, is_periodic } => {
                let points = points.iter().map(|[time, value]| [number(*time), number(*value)]).collect();
                let table = TableMotion::new(points, *is_periodic);
                Self::piece(table.piece(table.index(time_s)))
            }
            DriveLaw::Function(function) => Self::Function(function.parameters.iter().map(|id| number(*id)).collect()),
        }
    }

    /// The motion within a piece of a table.
    fn piece(piece: TablePiece<T>) -> Self {
        Self::Polynomial { origin_s: piece.origin_s, coefficients: piece.coefficients.to_vec() }
    }

    /// Position, velocity and acceleration at `time_s`; `room` holds the steps of the function, where `law` is one.
    #[inline(always)]
    pub fn at(&self, law: &DriveLaw, time_s: T, room: &mut [TimeDual<T>]) -> [T; 3] {
        match self {
            Self::Constant { start, speed } => [*start + *speed * time_s, *speed, T::zero()],
            Self::Polynomial { origin_s, coefficients } => {
                let u = time_s - *origin_s;
                // Horner's scheme for the value and both derivatives.
                let [mut value, mut rate, mut half] = [T::zero(); 3];
                for coefficient in coefficients.iter().rev() {
                    half = half.mul_add(u, rate);
                    rate = rate.mul_add(u, value);
                    value = value.mul_add(u, *coefficient);
                }
                [value, rate, half + half]
            }
            Self::Harmonic { mean, amplitude, angular_frequency_rad_s, phase_rad } => {
                let (sine, cosine) = angular_frequency_rad_s.mul_add(time_s, *phase_rad).sin_cos();
                let speed = *amplitude * *angular_frequency_rad_s;
                [amplitude.mul_add(sine, *mean), speed * cosine, -(speed * *angular_frequency_rad_s * sine)]
            }
            Self::Cycloidal { from, rise, duration_s, dwell_s } => {
                let share = ((time_s - *dwell_s) / *duration_s).max(T::zero()).min(T::one());
                let turn = T::from_f64(std::f64::consts::TAU);
                let (sine, cosine) = (turn * share).sin_cos();
                let pace = *rise / *duration_s;
                [rise.mul_add(share - sine / turn, *from), pace * (T::one() - cosine), pace * turn * sine / *duration_s]
            }
            Self::Function(parameters) => {
                let DriveLaw::Function(function) = law else { return [T::zero(); 3] };
                let time = Dual { value: Dual::variable(time_s), derivative: Dual::constant(T::one()) };
                let found = function.value(
                    parameters,
                    &[time],
                    #[inline(always)]
                    |number| Dual::constant(Dual::constant(number)),
                    room,
                );
                [found.value.value, found.value.derivative, found.derivative.derivative]
            }
        }
    }
}

/// The motions of all drives of a model in one sample.
#[derive(Debug, Clone)]
pub struct Drives<T> {
    motions: Vec<DriveMotion<T>>,
    schedule: Arc<Schedule>,
}

numbers!(struct Drives { motions; schedule });

/// When motions that consist of pieces change from one to the next.
#[derive(Debug, Default)]
struct Schedule {
    /// Tables, with the indices of their drives.
    tables: Vec<(usize, TableMotion<f64>)>,
    /// Single breaks of other motions, s.
    breaks_s: Vec<f64>,
}

impl Drives<f64> {
    /// Lays out `values` for the drives of `model`, tables in their pieces at time zero.
    pub fn new(model: &Model, values: &Values) -> Self {
        Self::of_laws(model.drives.iter().map(|drive| &drive.law), values)
    }

    /// Lays out `values` for the references of the controls of `model`, in the same way.
    pub fn of_controls(model: &Model, values: &Values) -> Self {
        Self::of_laws(model.controls.iter().map(|control| &control.reference), values)
    }

    fn of_laws<'l>(laws: impl Iterator<Item = &'l DriveLaw>, values: &Values) -> Self {
        let number = |id: QuantityId| values[id];
        let mut motions = Vec::new();
        let mut schedule = Schedule::default();
        for (index, law) in laws.enumerate() {
            motions.push(DriveMotion::new(law, &number, 0.0));
            match law {
                DriveLaw::Table { points, is_periodic } => {
                    let points = points.iter().map(|[time, value]| [values[*time], values[*value]]).collect();
                    schedule.tables.push((index, TableMotion::new(points, *is_periodic)));
                }
                DriveLaw::Cycloidal { duration_s, dwell_s, .. } => {
                    let dwell_s = values[*dwell_s];
                    schedule.breaks_s.extend([dwell_s, dwell_s + values[*duration_s]]);
                }
                _ => {}
            }
        }
        Self { motions, schedule: Arc::new(schedule) }
    }

    /// The first time after `time_s` at which the pieces of a motion meet, s; infinite where there is none.
    pub fn next_break_s(&self, time_s: f64) -> f64 {
        let tables = self.schedule.tables.iter().map(|(_, table)| table.start_s(table.index(time_s) + 1));
        let single = self.schedule.breaks_s.iter().copied().filter(|at_s| *at_s > time_s);
        tables.chain(single).fold(f64::INFINITY, f64::min)
    }

    /// Puts every table into the piece that holds `time_s`. True where there are tables.
    pub fn take_pieces_at(&mut self, time_s: f64) -> bool {
        for (index, table) in &self.schedule.tables {
            self.motions[*index] = DriveMotion::piece(table.piece(table.index(time_s)));
        }
        self.has_pieces()
    }

    /// Whether any motion consists of pieces.
    pub fn has_pieces(&self) -> bool {
        !self.schedule.tables.is_empty()
    }

    /// Times and values of all tables: of their pieces only the present one is among the numbers that are shown.
    pub fn table_points(&self) -> impl Iterator<Item = f64> + '_ {
        self.schedule.tables.iter().flat_map(|(_, table)| table.points().iter().flatten().copied())
    }

    /// Position, velocity and acceleration of a drive at `time_s`, in the present piece.
    pub fn at(&self, model: &Model, drive: DriveId, time_s: f64) -> [f64; 3] {
        self.law_at(&model.drives[drive.0].law, drive.0, time_s)
    }

    /// Position, velocity and acceleration of the motion of index `index`, whose law is `law`.
    pub fn law_at(&self, law: &DriveLaw, index: usize, time_s: f64) -> [f64; 3] {
        self.motions[index].at(law, time_s, &mut vec![Dual::constant(Dual::constant(0.0)); steps(law)])
    }

    /// The constant speed of a drive, m/s or rad/s; none for any other motion.
    pub fn constant_speed(&self, drive: DriveId) -> Option<f64> {
        match self.motions[drive.0] {
            DriveMotion::Constant { speed, .. } => Some(speed),
            _ => None,
        }
    }

    /// How fast the motion of index `index` changes between time zero and `end_s`, 1/s: its velocity over `scale`, and what its acceleration and
    /// its frequency say about it.
    pub fn pace_1_s(&self, law: &DriveLaw, index: usize, end_s: f64, scale: f64) -> f64 {
        /// Instants at which a motion without closed form is looked at.
        const LOOKS: u32 = 256;
        match &self.motions[index] {
            DriveMotion::Constant { speed, .. } => speed.abs() / scale,
            DriveMotion::Harmonic { amplitude, angular_frequency_rad_s: frequency, .. } => {
                frequency * (amplitude.abs() / scale).max(1.0)
            }
            DriveMotion::Cycloidal { rise, duration_s, .. } => {
                (2.0 * rise.abs() / scale).max(std::f64::consts::TAU) / duration_s
            }
            DriveMotion::Polynomial { .. } | DriveMotion::Function(_) => {
                let mut drives = self.clone();
                let looks = (0..=LOOKS).map(|k| {
                    let time_s = end_s * f64::from(k) / f64::from(LOOKS);
                    drives.take_pieces_at(time_s);
                    let [_, rate, acceleration] = drives.law_at(law, index, time_s);
                    (rate.abs() / scale).max((acceleration.abs() / scale).sqrt())
                });
                // Where it has no value the run will end.
                looks.filter(|pace| pace.is_finite()).fold(0.0, f64::max)
            }
        }
    }
}

impl<T: Real> Drives<T> {
    /// Position, velocity and acceleration of a drive at `time_s`, in the present piece; `room` holds [`room`] numbers.
    #[inline(always)]
    pub fn motion(&self, model: &Model, drive: DriveId, time_s: T, room: &mut [TimeDual<T>]) -> [T; 3] {
        self.motions[drive.0].at(&model.drives[drive.0].law, time_s, room)
    }

    /// Position, velocity and acceleration of the motion of index `index`, whose law is `law`.
    #[inline(always)]
    pub fn law_motion(&self, law: &DriveLaw, index: usize, time_s: T, room: &mut [TimeDual<T>]) -> [T; 3] {
        self.motions[index].at(law, time_s, room)
    }
}

/// Numbers that the functions of the drives and references of `model` need as room.
pub fn room(model: &Model) -> usize {
    let drives = model.drives.iter().map(|drive| steps(&drive.law));
    drives.chain(model.controls.iter().map(|control| steps(&control.reference))).max().unwrap_or(0)
}

/// Steps of the function of a motion.
fn steps(law: &DriveLaw) -> usize {
    match law {
        DriveLaw::Function(function) => function.steps(),
        _ => 0,
    }
}
