//! Outputs of the quasi-static answer: positions, and the errors of paths that they make.

use super::position::PositionOutput;
use loosepin_mechanics::model::{Axis, Position};
use loosepin_result::motion::PathMotion;
use loosepin_result::study::PathError;
use loosepin_text::units::SiUnit;

/// A point that is somewhere slower than this share of its mean speed has no direction there.
pub(super) const MIN_SHARE_OF_SPEED: f64 = 0.01;

/// One number of the quasi-static answer: a position, or a part of the error of a path.
pub(super) struct AccuracyOutput {
    pub name: String,
    pub words: String,
    pub unit: SiUnit,
    pub kind: AccuracyOutputKind,
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
    /// `speeds` gives the speeds of a point by the places of its coordinates.
    pub fn all(outputs: &[PositionOutput], speeds: impl Fn([usize; 2]) -> Vec<f64>) -> Vec<AccuracyOutput> {
        let mut parts = Vec::new();
        for (place, output) in outputs.iter().enumerate() {
            let PositionOutput { name, words, unit, .. } = output.clone();
            parts.push(AccuracyOutput {
                name,
                words,
                unit,
                kind: AccuracyOutputKind::Position(place),
                path_error: None,
            });
            // Behind y, the second coordinate of a path.
            let (Some(path), Position::Point(_, Axis::Y)) = (&output.path, output.reading) else { continue };
            let coordinates = [place - 1, place];
            if !has_direction(&speeds(coordinates)) {
                continue;
            }
            for (error, kind) in [
                (PathError::Along, AccuracyOutputKind::Along(coordinates)),
                (PathError::Normal, AccuracyOutputKind::Normal(coordinates)),
            ] {
                let (name, unit) = (format!("{} {}", path.name, error.word()), output.unit.clone());
                let path_error = Some(PathMotion { path: path.name.clone(), part: error });
                parts.push(AccuracyOutput { name, words: error.words(&path.point), unit, kind, path_error });
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
fn has_direction(speeds: &[f64]) -> bool {
    let mean = speeds.iter().sum::<f64>() / speeds.len() as f64;
    speeds.iter().all(|speed| *speed > MIN_SHARE_OF_SPEED * mean)
}
