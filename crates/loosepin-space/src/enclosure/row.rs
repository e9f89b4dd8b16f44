//! The rows of the loop equations, in a form that depends on the motion of both bodies against each other alone.
//!
//! d = 0 is written in the bearing's axes. A row of an angle, φ - f with φ = atan2(s, c), is zero where cos f s - sin f c is and
//! cos f c + sin f s is above zero: no arctangent is needed.

use crate::enclosure::jet::{Jet, Number};
use crate::enclosure::joint::{EnclosedJoint, number_of};
use crate::enclosure::vector::dot;
use crate::kind::row::ScalarRow;
use loosepin_math::{Interval, Real};

/// The residual over a box, lengths over L; every number where an angle may be on another branch.
pub(crate) fn residual<T: Number>(row: ScalarRow, at: &EnclosedJoint<T>, drive: f64, length_m: f64) -> Jet<T> {
    let over_length = |residual: Jet<T>| residual.times(Interval::from_f64(1.0) / Interval::from_f64(length_m));
    let drive = Jet::constant(Interval::from_f64(drive));
    match row {
        ScalarRow::Coincident(direction) => {
            let axis = direction.to_array().iter().position(|entry| *entry != 0.0).unwrap_or(0);
            over_length(dot(&at.bearing[axis], &at.separation))
        }
        ScalarRow::Perpendicular(a, b) => dot(&at.constrained[number_of(a)], &at.journal[number_of(b)]),
        ScalarRow::Across(axis) => over_length(dot(&at.constrained[number_of(axis)], &at.separation)),
        ScalarRow::DrivenSlide => over_length(at.slide_m() - &drive),
        ScalarRow::DrivenAngle => angle(at, &drive),
        ScalarRow::Helix { pitch_m } => {
            // p/2π to twice its round-off.
            let slope = pitch_m / std::f64::consts::TAU;
            let [low, high] = [slope * (1.0 - 4.0 * f64::EPSILON), slope * (1.0 + 4.0 * f64::EPSILON)];
            let slope = Interval::new(low.min(high), low.max(high));
            let turned = at.slide_m().times(Interval::from_f64(1.0) / slope);
            over_length(angle(at, &turned).times(-slope))
        }
    }
}

/// The sine of φ - f, times the length of (s, c).
fn angle<T: Number>(at: &EnclosedJoint<T>, f: &Jet<T>) -> Jet<T> {
    let [cosine, sine] = at.turn();
    let (sine_value, cosine_value) = f.range().sin_cos();
    let sine_of_f = f.function([sine_value, cosine_value, -sine_value, -cosine_value]);
    let cosine_of_f = f.function([cosine_value, -sine_value, -cosine_value, sine_value]);
    let is_on_this_branch = (&cosine_of_f * &cosine + &(&sine_of_f * &sine)).range().low() > 0.0;
    let residual = &cosine_of_f * &sine - &(&sine_of_f * &cosine);
    if is_on_this_branch { residual } else { residual.function([Interval::WHOLE; 4]) }
}
