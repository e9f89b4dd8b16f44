//! The motion of a drive in words.

use loosepin_mechanics::model::{DriveLaw, Values};
use loosepin_text::units::{Dimension, format_value};

/// A motion in words, of a position or of an angle.
pub fn law_words(law: &DriveLaw, is_prismatic: bool, values: &Values) -> String {
    let (speed, start) = if is_prismatic {
        (Dimension::VELOCITY, Dimension::LENGTH)
    } else {
        (Dimension::ANGULAR_VELOCITY, Dimension::ANGLE)
    };
    let value = |id, dimension| format_value(values[id], dimension);
    match law {
        DriveLaw::Constant { speed: id, start: from } => {
            format!("at {} from {}", value(*id, speed), value(*from, start))
        }
        DriveLaw::Polynomial { coefficients } => format!("by a polynomial of degree {}", coefficients.len() - 1),
        DriveLaw::Harmonic { mean, amplitude, frequency, .. } => format!(
            "up and down by {} about {} at {}",
            value(*amplitude, start),
            value(*mean, start),
            value(*frequency, Dimension::FREQUENCY)
        ),
        DriveLaw::Cycloidal { from, to, duration_s, dwell_s } => format!(
            "from {} to {} within {} after a rest of {}",
            value(*from, start),
            value(*to, start),
            value(*duration_s, Dimension::TIME),
            value(*dwell_s, Dimension::TIME)
        ),
        DriveLaw::Table { points, is_periodic } => {
            format!("by a table of {} points, {}", points.len(), if *is_periodic { "again and again" } else { "once" })
        }
        DriveLaw::Function(_) => "by an expression over time".to_owned(),
    }
}
