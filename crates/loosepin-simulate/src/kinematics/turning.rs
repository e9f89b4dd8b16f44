//! Where quantities of a motion turn back, by their exact rates.

use std::f64::consts::TAU;

use loosepin_math::Bracket;
use loosepin_mechanics::mechanism::IdealMotion;
use loosepin_mechanics::model::CycleInput;

use super::quantity::Quantity;

/// Rates below this share of the largest one are round-off of zero.
const STILL: f64 = 1e-9;
/// Steps of the search for a sign change: halving alone reaches the resolution of a double in as many.
const MAX_STEPS: usize = 60;
/// How exactly a turning point is located, in turns.
const LOCATED_TURNS: f64 = 1e-13;

/// A motion that was walked through, in the order of the drive's angle.
pub struct Walked<'w, 'm> {
    pub states: &'w [IdealMotion<'m>],
    pub input: &'w CycleInput,
}

/// A value at an angle of the drive.
pub struct TurningPoint {
    pub value: f64,
    pub angle_rad: f64,
}

impl Walked<'_, '_> {
    /// Whether it ends where it began, one turn on.
    pub fn is_whole_turn(&self) -> bool {
        let [Some(first), Some(last)] = [self.states.first(), self.states.last()] else { return false };
        let turn_rad = self.input.angle_rad(last.time_s()) - self.input.angle_rad(first.time_s());
        (turn_rad.abs() - TAU).abs() < 1e-9
    }

    /// Where `quantity` stands still and turns back.
    pub fn turning_points(&self, quantity: &dyn Quantity) -> Vec<TurningPoint> {
        let at = |state: &IdealMotion<'_>| TurningPoint {
            value: quantity.value(state),
            angle_rad: self.input.angle_rad(state.time_s()),
        };
        crossings(self, &|state| quantity.rate(state)).iter().map(at).collect()
    }
}

/// States at which `of` changes its sign; over a whole turn each once.
pub fn crossings<'m>(walked: &Walked<'_, 'm>, of: &dyn Fn(&IdealMotion<'_>) -> f64) -> Vec<IdealMotion<'m>> {
    let values: Vec<f64> = walked.states.iter().map(of).collect();
    let least = STILL * values.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let clear: Vec<usize> = (0..values.len()).filter(|place| values[*place].abs() > least).collect();
    let mut found = Vec::new();
    for pair in clear.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        if (values[from] > 0.0) != (values[to] > 0.0) {
            found.extend(crossing(&walked.states[from], &walked.states[to], [values[from], values[to]], of));
        }
    }
    // First and last state of a whole turn are the same position: a sign that changes there changes once.
    if let (Some(first), Some(last)) = (clear.first(), clear.last())
        && walked.is_whole_turn()
        && (values[*first] > 0.0) != (values[*last] > 0.0)
    {
        found.push(walked.states[0].clone());
    }
    found
}

/// The sign change between two states.
fn crossing<'m>(
    from: &IdealMotion<'m>,
    to: &IdealMotion<'m>,
    values: [f64; 2],
    of: &dyn Fn(&IdealMotion<'_>) -> f64,
) -> Option<IdealMotion<'m>> {
    let mut bracket = Bracket::new([from.time_s(), to.time_s()], values);
    let least_s = LOCATED_TURNS * (to.time_s() - from.time_s()).max(f64::MIN_POSITIVE);
    let mut state = from.clone();
    for _ in 0..MAX_STEPS {
        let (next_s, [from_s, to_s]) = (bracket.next(), bracket.places());
        state.move_to(next_s).ok()?;
        let value = of(&state);
        let moved_s = if bracket.take(next_s, value) { next_s - from_s } else { to_s - next_s };
        if value == 0.0 || moved_s <= least_s {
            break;
        }
    }
    Some(state)
}
