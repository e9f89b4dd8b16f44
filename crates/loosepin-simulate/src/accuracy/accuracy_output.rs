//! Outputs of the quasi-static answer: positions, and the errors of paths that they make.

use super::position::PositionOutput;
use loosepin_mechanics::model::{Axis, Position};
use loosepin_result::motion::PathMotion;
use loosepin_result::study::PathError;
use loosepin_text::units::SiUnit;

/// A point that is somewhere slower than this share of its mean speed has no direction there.
const MIN_SHARE_OF_SPEED: f64 = 0.01;
/// Speeds below this share of the speed of the cycle times the size of the mechanism are round-off of a point that stands still.
const ROUND_OFF_OF_SPEED: f64 = 1e-9;

/// The speed up to which a motion is round-off, m/s, of a mechanism of this size in a cycle of this speed.
pub(super) fn round_off_m_s(speed_rad_s: f64, size_m: f64) -> f64 {
    ROUND_OFF_OF_SPEED * speed_rad_s.abs() * size_m
}

/// The speed up to which a point has no direction, m/s, by all of its speeds.
pub(super) fn speed_of_no_direction_m_s(speeds_m_s: &[f64], round_off_m_s: f64) -> f64 {
    let mean_m_s = speeds_m_s.iter().sum::<f64>() / speeds_m_s.len() as f64;
    round_off_m_s.max(MIN_SHARE_OF_SPEED * mean_m_s)
}

/// One number of the quasi-static answer: a position, or a part of the error of a path.
pub(super) struct AccuracyOutput {
    pub name: String,
    pub words: String,
    pub unit: SiUnit,
    pub kind: AccuracyOutputKind,
    /// The path that it is a coordinate of.
    pub coordinate_of: Option<String>,
    pub path_error: Option<PathMotion>,
}

/// Its value in terms of positions, by their places in a list.
#[derive(Clone, Copy)]
pub(super) enum AccuracyOutputKind {
    /// A position itself.
    Position(usize),
    /// t·e, the error along the path whose coordinates are at these places.
    Along([usize; 2]),
    /// n·e, the error across it, n is t turned by 90°. To first order also the distance from the path.
    Normal([usize; 2]),
}

impl AccuracyOutput {
    /// The positions, and behind the coordinates of a path the parts of its error, where its direction is known all the way.
    /// `speeds_m_s` gives the speeds of a point by the places of its coordinates.
    pub fn all(
        outputs: &[PositionOutput],
        speeds_m_s: impl Fn([usize; 2]) -> Vec<f64>,
        round_off_m_s: f64,
    ) -> Vec<AccuracyOutput> {
        let mut parts = Vec::new();
        for (place, output) in outputs.iter().enumerate() {
            let PositionOutput { name, words, unit, .. } = output.clone();
            parts.push(AccuracyOutput {
                name,
                words,
                unit,
                kind: AccuracyOutputKind::Position(place),
                coordinate_of: output.path.as_ref().map(|path| path.name.clone()),
                path_error: None,
            });
            // Behind y, the second coordinate of a path.
            let (Some(path), Position::Point(_, Axis::Y)) = (&output.path, output.reading) else { continue };
            let coordinates = [place - 1, place];
            if !has_direction(&speeds_m_s(coordinates), round_off_m_s) {
                continue;
            }
            for (error, kind) in [
                (PathError::Along, AccuracyOutputKind::Along(coordinates)),
                (PathError::Normal, AccuracyOutputKind::Normal(coordinates)),
            ] {
                let (name, unit) = (format!("{} {}", path.name, error.word()), output.unit.clone());
                let path_error = Some(PathMotion { path: path.name.clone(), part: error });
                let words = error.words(&path.point);
                parts.push(AccuracyOutput { name, words, unit, kind, coordinate_of: None, path_error });
            }
        }
        parts
    }
}

impl AccuracyOutputKind {
    /// Weight of each position for these `velocities`.
    pub fn weights(self, velocities: &[f64]) -> Vec<(usize, f64)> {
        match self {
            Self::Position(place) => vec![(place, 1.0)],
            Self::Along([x, y]) => {
                let speed = velocities[x].hypot(velocities[y]);
                vec![(x, velocities[x] / speed), (y, velocities[y] / speed)]
            }
            Self::Normal([x, y]) => {
                let speed = velocities[x].hypot(velocities[y]);
                vec![(x, -velocities[y] / speed), (y, velocities[x] / speed)]
            }
        }
    }
}

/// Whether a point moves all the way.
fn has_direction(speeds_m_s: &[f64], round_off_m_s: f64) -> bool {
    let least_m_s = speed_of_no_direction_m_s(speeds_m_s, round_off_m_s);
    speeds_m_s.iter().all(|speed_m_s| *speed_m_s > least_m_s)
}
