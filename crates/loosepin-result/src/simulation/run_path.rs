//! Paths of points among the outputs of a run.

use super::{OutputHistory, SimulationRecord};
use serde::{Deserialize, Serialize};

/// A path of a point; its coordinates are two of the outputs of its run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RunPath {
    /// Name of the path; its coordinates are called `NAME x` and `NAME y`.
    pub name: String,
    /// The point in words: `coupler.tool`, or `coupler.tool relative to crank.pin`.
    pub point: String,
}

impl SimulationRecord {
    /// The coordinates of a path.
    pub fn coordinates(&self, path: &RunPath) -> Option<[&OutputHistory; 2]> {
        let of = |axis: &str| self.outputs.iter().find(|output| output.name == format!("{} {axis}", path.name));
        Some([of("x")?, of("y")?])
    }
}
