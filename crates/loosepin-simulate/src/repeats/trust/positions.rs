//! The positions that two runs are compared by.

use crate::observer::{Observer, Step};
use crate::settings::Window;
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::{Arms, Mechanism};
use loosepin_mechanics::model::{Axis, BodyId, Motion, PointId, Position, Reading, Relative, Values};

/// Instants a turn at which positions are compared, at least.
const INSTANTS_A_TURN: f64 = 360.0;
/// Instants at most: 16 MB for ten points.
const MAX_INSTANTS: usize = 100_000;

/// All named points of the moving bodies, and the angles of bodies whose points do not show how they turn.
#[derive(Debug, Clone)]
struct ComparedPositions {
    /// x and y of each point in turn.
    coordinates: Vec<Reading>,
    /// Angles of bodies with fewer than two named points.
    angles: Vec<Reading>,
    /// What a radian of such an angle counts as, m: the size of the mechanism, as for tolerances.
    lever_m: f64,
    arms: Arms,
}

impl ComparedPositions {
    fn new(mechanism: &Mechanism, values: &Values) -> Self {
        let bodies = &mechanism.model.bodies;
        let of_ground = |position| Reading::from(Motion::position(position));
        let points = (1..bodies.len()).flat_map(|body| {
            (0..bodies[body].points.len()).map(move |point| Relative::to_ground(PointId { body: BodyId(body), point }))
        });
        let coordinates = points.flat_map(|point| [Axis::X, Axis::Y].map(|axis| Position::Point(point, axis)));
        let turning = (1..bodies.len()).filter(|&body| bodies[body].points.len() < 2);
        Self {
            coordinates: coordinates.map(of_ground).collect(),
            angles: turning.map(|body| of_ground(Position::Angle(Relative::to_ground(BodyId(body))))).collect(),
            lever_m: mechanism.size_m,
            arms: Arms::new(mechanism, values),
        }
    }

    /// Lengths that stand for one instant.
    fn count(&self) -> usize {
        self.coordinates.len() + self.angles.len()
    }

    /// Adds the lengths of the state that was set, m.
    fn read(&self, dynamics: &Dynamics<'_, f64>, lengths_m: &mut Vec<f64>) {
        let value = |reading: &Reading| reading.value(&self.arms, dynamics);
        lengths_m.extend(self.coordinates.iter().map(value));
        lengths_m.extend(self.angles.iter().map(|angle| self.lever_m * value(angle)));
    }

    /// The largest distance between two places of a point, or of an angle times the lever, m.
    fn difference_m(&self, first_m: &[f64], second_m: &[f64]) -> f64 {
        let count = self.coordinates.len();
        let points = first_m[..count].chunks_exact(2).zip(second_m[..count].chunks_exact(2));
        let distances = points.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
        let turned = first_m[count..].iter().zip(&second_m[count..]).map(|(a, b)| (a - b).abs());
        distances.chain(turned).fold(0.0, f64::max)
    }
}

/// Positions of a run at equal distances in time.
#[derive(Debug, Clone)]
pub struct PositionHistory {
    positions: ComparedPositions,
    /// The instants, increasing, s.
    times_s: Vec<f64>,
    /// Lengths of the instants that the run came to, m.
    lengths_m: Vec<f64>,
}

impl PositionHistory {
    /// Settings for a run of `mechanism` with `values` over `window`, whose turns take `turn_s`, with at least `instants` instants.
    pub fn new(mechanism: &Mechanism, values: &Values, window: Window, turn_s: f64, instants: usize) -> Self {
        let span_s = window.end_s - window.start_s;
        let of_turns = (INSTANTS_A_TURN * span_s / turn_s).ceil().clamp(1.0, MAX_INSTANTS as f64) as usize;
        let count = of_turns.max(instants).min(MAX_INSTANTS);
        let at = |k: usize| if k == count { window.end_s } else { window.start_s + span_s * k as f64 / count as f64 };
        Self {
            positions: ComparedPositions::new(mechanism, values),
            times_s: (0..=count).map(at).collect(),
            lengths_m: Vec::new(),
        }
    }

    /// The instants, increasing, s.
    pub fn times_s(&self) -> &[f64] {
        &self.times_s
    }

    /// The largest distance between the positions of an instant and those of `step` there, m; zero beyond the last instant of the run.
    pub(super) fn difference_m(&self, instant: usize, step: &mut Step<'_, '_>, read_m: &mut Vec<f64>) -> Option<f64> {
        let count = self.positions.count();
        let own_m = self.lengths_m.get(instant * count..(instant + 1) * count)?;
        read_m.clear();
        self.positions.read(step.set_state(self.times_s[instant]), read_m);
        Some(self.positions.difference_m(own_m, read_m))
    }
}

impl Observer for PositionHistory {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        while let Some(&time_s) = self
            .times_s
            .get(self.lengths_m.len() / self.positions.count().max(1))
            .filter(|&&time_s| time_s <= step.end_s)
        {
            self.positions.read(step.set_state(time_s), &mut self.lengths_m);
        }
    }
}
