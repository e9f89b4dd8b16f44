//! The ideal motion of a mechanism that its drives do not move alone: a run of its own, kept to be read at any time.

use crate::engine::run;
use crate::failure::RunFailure;
use crate::observer::{Observer, Step};
use crate::settings::{Settings, Window};
use loosepin_math::Quintic;
use loosepin_mechanics::mechanism::{Mechanism, Sample};

/// A step: its start, its end, and value, rate and acceleration of every free coordinate at both;
/// integral of the error of every control, and the error; deflection of the bristles of every joint with friction, and its rate.
#[derive(Debug)]
struct Piece {
    start_s: f64,
    end_s: f64,
    jets: Vec<[[f64; 3]; 2]>,
    error_integrals: Vec<[[f64; 2]; 2]>,
    joint_bristles: Vec<[[f64; 2]; 2]>,
}

/// The state at an instant.
#[derive(Debug, Default)]
pub struct FreeState {
    /// Free coordinates.
    pub coordinates: Vec<f64>,
    /// Rates of the coordinates.
    pub rates: Vec<f64>,
    /// Integrals of the errors of all controls.
    pub error_integrals: Vec<f64>,
    /// Deflections of the bristles of all joints with friction, m; zero where a law has none.
    pub joint_bristles_m: Vec<f64>,
}

/// The motion from time zero on, as polynomials of degree five over the steps of the run.
#[derive(Debug)]
pub struct FreeMotion {
    pieces: Vec<Piece>,
}

impl FreeMotion {
    /// Runs `mechanism`, which has no play, to `end_s`.
    ///
    /// # Errors
    /// The one reason why the run failed.
    pub fn new(
        mechanism: &Mechanism,
        sample: &Sample<f64>,
        end_s: f64,
        settings: &Settings,
    ) -> Result<Self, RunFailure> {
        let mut motion = Self { pieces: Vec::new() };
        run(mechanism, sample, &Window { start_s: 0.0, end_s }, settings, &mut motion)?;
        Ok(motion)
    }

    /// Numbers that it is kept in, those of the three lists of a step among them.
    pub fn numbers(&self) -> usize {
        let of =
            |piece: &Piece| 11 + 6 * piece.jets.len() + 4 * (piece.error_integrals.len() + piece.joint_bristles.len());
        self.pieces.iter().map(of).sum()
    }

    /// The state at `time_s`.
    pub fn state(&self, time_s: f64) -> FreeState {
        let index = self.pieces.partition_point(|piece| piece.end_s < time_s).min(self.pieces.len().saturating_sub(1));
        let Some(piece) = self.pieces.get(index) else { return FreeState::default() };
        let h = piece.end_s - piece.start_s;
        let share = ((time_s - piece.start_s) / h).clamp(0.0, 1.0);
        let motions = piece.jets.iter().map(|[start, end]| {
            let quintic = Quintic::new(*start, *end, h);
            (quintic.value(share), quintic.slope(share) / h)
        });
        let (coordinates, rates) = motions.unzip();
        let cubics = |ends: &[[[f64; 2]; 2]]| ends.iter().map(|[start, end]| cubic(*start, *end, h, share)).collect();
        let (error_integrals, joint_bristles_m) = (cubics(&piece.error_integrals), cubics(&piece.joint_bristles));
        FreeState { coordinates, rates, error_integrals, joint_bristles_m }
    }
}

/// The cubic with value and slope `start` at share 0 of a step `h` and `end` at share 1.
fn cubic(start: [f64; 2], end: [f64; 2], h: f64, share: f64) -> f64 {
    let (rise, left) = (end[0] - start[0], 1.0 - share);
    let bend = left * (h * start[1] - rise) - share * (h * end[1] - rise);
    start[0] + share * (rise + left * bend)
}

impl Observer for FreeMotion {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let (mut jets, mut error_integrals, mut joint_bristles) = (Vec::new(), Vec::new(), Vec::new());
        for (side, time_s) in [(0, step.start_s), (1, step.end_s)] {
            let dynamics = step.evaluate(time_s);
            let (coordinates, rates) = dynamics.free_state();
            jets.resize(coordinates.len(), [[0.0; 3]; 2]);
            for (k, jet) in jets.iter_mut().enumerate() {
                jet[side] = [coordinates[k], rates[k], dynamics.accelerations()[k]];
            }
            error_integrals.resize(dynamics.actuators().len(), [[0.0; 2]; 2]);
            for (k, jet) in error_integrals.iter_mut().enumerate() {
                jet[side] = [dynamics.error_integrals()[k], dynamics.actuators()[k].error];
            }
            joint_bristles.resize(dynamics.sample().frictions.len(), [[0.0; 2]; 2]);
            for (k, jet) in joint_bristles.iter_mut().enumerate() {
                jet[side] = [dynamics.joint_bristle_m(k).unwrap_or(0.0), dynamics.joint_bristle_rate_m_s(k)];
            }
        }
        self.pieces.push(Piece { start_s: step.start_s, end_s: step.end_s, jets, error_integrals, joint_bristles });
    }
}
