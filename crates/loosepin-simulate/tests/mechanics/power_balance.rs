//! That energies change by what losses, drives and loads take and give, at any state: the derivatives by time are exact, of dual numbers.

use loosepin_math::Dual;
use loosepin_mechanics::dynamics::{MechanicalEnergy, Powers};

/// Coordinates, and their rates, each with its derivative by time: `state` is coordinates, rates and accelerations. There may be more
/// accelerations than coordinates.
pub(crate) fn with_rates(state: [&[f64]; 3]) -> [Vec<Dual<f64>>; 2] {
    let [q, rates, accelerations] = state;
    [(q, rates), (rates, accelerations)].map(|(values, derivatives)| {
        assert!(derivatives.len() >= values.len());
        values.iter().zip(derivatives).map(|(&value, &derivative)| Dual { value, derivative }).collect()
    })
}

/// The rates of all energies, the losses, and what drives and loads give, add up to nothing: to `round_off` of the largest of them.
pub(crate) fn assert_powers_balance(
    energy: &MechanicalEnergy<Dual<f64>>,
    powers: &Powers<f64>,
    round_off: f64,
    of: &str,
) {
    let terms = [
        energy.kinetic_j.derivative,
        energy.potential_j.derivative,
        energy.stored_j.derivative,
        powers.contact_loss_w,
        powers.friction_loss_w,
        -powers.drives_w,
        -powers.loads_w,
    ];
    let largest = terms.iter().fold(0.0_f64, |largest, term| largest.max(term.abs()));
    let balance: f64 = terms.iter().sum();
    assert!(balance.abs() <= round_off * largest, "{of}: {balance:e} of {terms:?}");
}
