//! Positions along a cycle of the drives.

use crate::closure::assembly::{Starts, assembled, check_drives};
use crate::closure::error::ClosureError;
use crate::closure::loops::Loops;
use crate::closure::position::Position;
use crate::closure::step::{Place, check_way, follow};
use crate::mechanism::drive::DriveValue;
use crate::mechanism::spatial_mechanism::SpatialMechanism;
use crate::stop::{IsStopped, NEVER};

/// The positions that were reached, and why there are not more.
#[derive(Debug, Clone)]
pub struct Cycle {
    /// Positions at the inputs in their order.
    pub positions: Vec<Position>,
    /// Why the cycle ends before the last input; `None` if it does not.
    pub stopped: Option<ClosureError>,
}

impl Cycle {
    /// All positions, if the loops close at every input.
    pub(crate) fn whole(self) -> Result<Vec<Position>, ClosureError> {
        self.stopped.map_or(Ok(self.positions), Err)
    }
}

/// Closes the loops at each of `inputs` in their order, from the assembly of the start poses.
///
/// Between two inputs the motion is followed: a step along the tangent, then Newton's method. A step is halved until what Newton's method adds
/// is a small part of it and the determinant of the bordered loop equations has kept its sign. So no other branch is taken unseen; where two
/// meet, or a drive comes to its end, the cycle stops with the place. A way of the drives that takes more than 21,000 steps is not begun.
pub fn cycle(mechanism: &SpatialMechanism, inputs: &[f64], drives: &dyn Fn(f64) -> Vec<DriveValue>) -> Cycle {
    cycle_from(mechanism, inputs, drives, Starts::Nearby, NEVER)
}

/// The same with a choice of starts, until it is stopped.
pub(crate) fn cycle_from(
    mechanism: &SpatialMechanism,
    inputs: &[f64],
    drives: &dyn Fn(f64) -> Vec<DriveValue>,
    starts: Starts,
    is_stopped: IsStopped,
) -> Cycle {
    let mut positions = Vec::with_capacity(inputs.len());
    let stopped = collect(mechanism, (inputs, drives), starts, is_stopped, &mut positions).err();
    Cycle { positions, stopped }
}

fn collect(
    mechanism: &SpatialMechanism,
    (inputs, drives): (&[f64], &dyn Fn(f64) -> Vec<DriveValue>),
    starts: Starts,
    is_stopped: IsStopped,
    positions: &mut Vec<Position>,
) -> Result<(), ClosureError> {
    let Some(first) = inputs.first() else { return Ok(()) };
    let loops = Loops::new(mechanism);
    for input in inputs {
        check_drives(mechanism, &drives(*input))?;
    }
    let values = |input: f64| drives(input).iter().map(|drive| drive.value).collect::<Vec<f64>>();
    check_way(&loops, inputs.iter().map(|input| values(*input)))?;
    let start = assembled(&loops, &drives(*first), starts, is_stopped)?;
    let mut place = Place { input: *first, ..start };
    positions.push(Position::new(&loops, &drives(*first), &place));
    for input in inputs.iter().skip(1) {
        place = follow(&loops, &place, *input, &values, is_stopped)?;
        positions.push(Position::new(&loops, &drives(*input), &place));
    }
    Ok(())
}
