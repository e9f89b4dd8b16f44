//! How all numbers of a model move with one of them.

use super::error::AccuracyError;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::{QuantityError, QuantityId, Values};
use loosepin_text::units::Dimension;

/// Step of the differences over the value of the quantity. Together with one extrapolation it leaves a truncation error
/// of 1e-12 and a round-off of 1e-12, relative to the derivative of a smooth expression.
const RELATIVE_STEP: f64 = 1e-3;
/// Step for a quantity whose value is zero and that is no length, SI.
const STEP_AT_ZERO: f64 = 1e-3;

/// The derivatives of all numbers of a model with respect to one of them.
#[derive(Debug, Clone, PartialEq)]
pub struct DimensionDirection {
    /// The quantity that moves.
    pub quantity: QuantityId,
    /// d(value)/d(quantity) for every quantity, SI.
    pub derivatives: Values,
}

impl DimensionDirection {
    /// Whether nothing that shapes or drives the mechanism follows: no point, no angle of a joint, no coupling, no drive.
    pub fn leaves_motion_alone(&self, mechanism: &Mechanism) -> bool {
        Self::shaping(mechanism).iter().all(|id| self.derivatives[*id] == 0.0)
    }

    /// The quantities that shape or drive a mechanism.
    pub(super) fn shaping(mechanism: &Mechanism) -> Vec<QuantityId> {
        let model = &mechanism.model;
        let points = model.bodies.iter().flat_map(|body| body.points.iter().flat_map(|point| point.position_m));
        let drives = model.drives.iter().flat_map(|drive| drive.law.quantities());
        let angles = model.joints.iter().flat_map(|joint| joint.kind.angles_rad().into_iter().flatten());
        let couplings = model.couplings.iter().flat_map(|coupling| coupling.kind.quantities());
        points.chain(drives).chain(angles).chain(couplings).collect()
    }
}

/// The direction in which all numbers of `mechanism` move when `quantity` grows, at `values`.
///
/// Central differences D(h) of the expressions, extrapolated once: (4 D(h/2) - D(h))/3, exact for polynomials up to the
/// fourth degree. Where a rule forbids one side, three points on the other one give the slope instead, exact up to the
/// second degree.
///
/// # Errors
/// A quantity that cannot be set, or one that no step on either side leaves within its rule.
pub fn dimension_direction(
    mechanism: &Mechanism,
    values: &Values,
    quantity: QuantityId,
) -> Result<DimensionDirection, AccuracyError> {
    let table = &mechanism.model.quantities;
    let settable: Vec<(QuantityId, f64)> =
        table.iter().filter(|(_, q)| q.is_settable()).map(|(id, _)| (id, values[id])).collect();
    let at = |step: f64| -> Result<Values, QuantityError> {
        let mut set = settable.clone();
        set.push((quantity, values[quantity] + step));
        table.evaluate(&set)
    };
    let step = if values[quantity] != 0.0 {
        RELATIVE_STEP * values[quantity].abs()
    } else if table[quantity].dimension == Dimension::TEMPERATURE {
        // Lengths are linear in it, with a slope of 1e-5: the longer the step, the less round-off.
        1.0
    } else if table[quantity].dimension == Dimension::LENGTH {
        RELATIVE_STEP * mechanism.size_m
    } else {
        STEP_AT_ZERO
    };
    let derivatives = match (at(step), at(-step)) {
        (Ok(above), Ok(below)) => {
            let (near_above, near_below) = (at(0.5 * step)?, at(-0.5 * step)?);
            each(values, |k| {
                let wide = (above.0[k] - below.0[k]) / (2.0 * step);
                let narrow = (near_above.0[k] - near_below.0[k]) / step;
                (4.0 * narrow - wide) / 3.0
            })
        }
        (Ok(far), Err(_)) => one_sided(values, &at(0.5 * step)?, &far, step),
        (Err(_), Ok(far)) => one_sided(values, &at(-0.5 * step)?, &far, -step),
        (Err(error), Err(_)) => return Err(error.into()),
    };
    Ok(DimensionDirection { quantity, derivatives })
}

/// Slope at the start from the start itself, half a step and a whole step.
fn one_sided(start: &Values, middle: &Values, far: &Values, step: f64) -> Values {
    each(start, |k| (4.0 * middle.0[k] - 3.0 * start.0[k] - far.0[k]) / step)
}

fn each(values: &Values, derivative: impl Fn(usize) -> f64) -> Values {
    Values((0..values.0.len()).map(derivative).collect())
}
