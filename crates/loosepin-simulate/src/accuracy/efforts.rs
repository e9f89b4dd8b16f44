//! Efforts of drives for the ideal motion: inverse dynamics.

use crate::ideal::column::{Column, columns};
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_mechanics::mechanism::{Arms, IdealMotion, Mechanism, Sample};
use loosepin_result::motion::EffortMotion;

/// The outputs of `mechanism` that are torques, forces or powers of drives, at all `states` of its ideal motion: with inertia, weight,
/// springs, loads and friction in ideal joints, without play.
pub(super) fn ideal_efforts(
    mechanism: &Mechanism,
    sample: &Sample<f64>,
    states: &[IdealMotion<'_>],
) -> Vec<EffortMotion> {
    let is_effort = |column: &Column| column.reading.is_effort();
    let columns: Vec<Column> = columns(&mechanism.model).into_iter().filter(is_effort).collect();
    let ideal = mechanism.without_play();
    let mut dynamics = Dynamics::new(&ideal, &sample.clone().without_play());
    let mut values = vec![Vec::with_capacity(states.len()); columns.len()];
    for state in states {
        let (time_s, free) = (state.time_s(), ideal.real.free);
        let (coordinates, rates) = state.real_state();
        dynamics.sample_mut().take_pieces_at(time_s);
        dynamics.evaluate(time_s, &coordinates[..free], &rates[..free], &[]);
        for (values, column) in values.iter_mut().zip(&columns) {
            values.push(column.reading.value(&Arms::none(), &dynamics));
        }
    }
    let motions = columns.into_iter().zip(values);
    motions.map(|(Column { name, words, unit, .. }, value_si)| EffortMotion { name, words, unit, value_si }).collect()
}
