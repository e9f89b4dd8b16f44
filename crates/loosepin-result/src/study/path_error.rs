//! Parts of the error of a point from its ideal path.

use serde::{Deserialize, Serialize};

/// A part of the error of a point from its ideal path, m.
///
/// ```text
/// e = actual - ideal position at the same instant;   t: unit tangent of the ideal path there, n: t turned by +90°, κ: its curvature
/// along      e·t               ahead of the ideal point, or behind it
/// normal     e·n               to the left of the direction in which it moves
/// magnitude  |e|
/// contour    (2 e·n - κ|e|²)/(1 + √((1 - κ e·n)² + κ² (e·t)²))
/// ```
///
/// The contour error is the distance from the path, whatever the timing: from the circle that touches it where the ideal point is, to its
/// left. It is e·n where the path is straight; what it leaves out is (e·t)³/6 times the change of κ along the path.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PathError {
    /// Along the path, in the direction of motion.
    Along,
    /// Across the path, to the left.
    Normal,
    /// The distance from where the point should be.
    Magnitude,
    /// The distance from the path, to the left.
    Contour,
}

impl PathError {
    /// Every part, in the order in which study files name them.
    pub const ALL: [Self; 4] = [Self::Along, Self::Normal, Self::Magnitude, Self::Contour];

    /// Word in study files, results and tables.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Along => "along",
            Self::Normal => "normal",
            Self::Magnitude => "magnitude",
            Self::Contour => "contour",
        }
    }

    /// The part of the error of `point` in words.
    pub fn words(self, point: &str) -> String {
        match self {
            Self::Along => format!("error of {point} along its path"),
            Self::Normal => format!("error of {point} across its path"),
            Self::Magnitude => format!("distance of {point} from where it should be"),
            Self::Contour => format!("distance of {point} from its path"),
        }
    }
}
