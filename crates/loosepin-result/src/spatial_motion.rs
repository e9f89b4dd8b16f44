//! The motion of a mechanism in space over a turn, and what play does to it, without dynamics. SI.

use crate::motion::{DimensionContributor, PoseEffect};
use crate::repeat::Repeat;
use crate::spatial_picture::SpatialPicture;
use loosepin_text::units::SiUnit;
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// What is said of a motion that begins elsewhere than the file places its bodies.
pub const OTHER_START: &str = "the joints do not close from where bodies are placed at the start; of the positions found near there, this is the \
                               nearest; [assembly] guess says where bodies are";

/// The motion over a turn, with the worst cases of each output.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SpatialMotionRecord {
    /// Name of the model.
    pub model: String,
    /// Name of the drive whose angle is the input, or `time`.
    pub input: String,
    /// How it is made again.
    pub repeat: Repeat,
    /// Speed of that drive; `None` where the input is the time.
    pub drive_speed_rad_s: Option<f64>,
    /// Unit of the input: rad or s.
    pub input_unit: SiUnit,
    /// The input at each position.
    pub inputs_si: Vec<f64>,
    /// Whether a joint has play.
    pub has_play: bool,
    /// Whether proven ends of worst cases were sought.
    #[serde(default)]
    pub is_proven: bool,
    /// Numbers of the positions in which a place of the journals was found that takes the loops to a dead centre. Worst cases of first order say
    /// nothing there.
    #[serde(default)]
    pub dead_centre_samples: Vec<usize>,
    /// Whether the motion begins elsewhere than the file places its bodies: [`OTHER_START`].
    #[serde(default)]
    pub is_other_start: bool,
    /// The outputs in their order.
    pub outputs: Vec<SpatialOutputRecord>,
    /// What scatter does at the poses that a study asks about: those of requirements first, then those of questions. Without joints.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub asked: Vec<PoseEffect>,
    /// The mechanism as it is drawn, in the same positions.
    pub picture: SpatialPicture,
}

impl SpatialMotionRecord {
    /// The output that an answer begins with: of those in the unit of the first one that with the largest worst case of first order.
    pub fn main_output(&self) -> Option<&SpatialOutputRecord> {
        let first = self.outputs.first()?;
        let alike = self.outputs.iter().filter(|output| output.unit == first.unit);
        // The first of several alike.
        alike.rev().max_by(|a, b| a.worst_case_si().total_cmp(&b.worst_case_si()))
    }

    /// The poses at which an output is asked about, those of requirements first.
    pub fn asked_of<'r>(&'r self, output: &'r str) -> impl Iterator<Item = &'r PoseEffect> {
        self.asked.iter().filter(move |asked| asked.output == output)
    }

    /// The angle of the drive at a position; of a cycle over time its phase, a whole turn over all of it.
    pub fn phase_rad(&self, position: usize) -> f64 {
        match self.drive_speed_rad_s {
            Some(_) => self.inputs_si.get(position).copied().unwrap_or(f64::NAN),
            None => TAU * position as f64 / (self.inputs_si.len().max(2) - 1) as f64,
        }
    }
}

impl SpatialOutputRecord {
    /// The largest worst case of first order over the turn; 0 where there is none.
    pub fn worst_case_si(&self) -> f64 {
        self.first_order_si.get(self.worst.sample).copied().unwrap_or_default()
    }
}

/// An output over the turn.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SpatialOutputRecord {
    /// Its name.
    pub name: String,
    /// What it is.
    pub words: String,
    /// Its unit: m or rad.
    pub unit: SiUnit,
    /// The ideal value at each position; empty of a path and of an orientation, which are no numbers. A turn counts from the first position.
    pub ideal_si: Vec<f64>,
    /// The worst case of first order at each position: the largest deviation to one side, which is that to the other; of a path the longest
    /// displacement, of an orientation the largest angle.
    pub first_order_si: Vec<f64>,
    /// Standard deviation with the journals anywhere in their play, all places alike; of a path the root of the mean square of the displacement,
    /// of an orientation that of the angle. Empty where the plays must meet conditions together, so that there is no closed form.
    pub standard_deviation_si: Vec<f64>,
    /// The worst position.
    pub worst: SpatialWorstCase,
    /// The worst of the positions in which play comes near no dead centre; `None` where the worst one is one of them, or none is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub worst_regular: Option<SpatialWorstCase>,
    /// What random dimensions of a study do to it.
    #[serde(default)]
    pub scatter: SpatialScatter,
}

/// What random dimensions do to an output over the turn, to first order; of a path the root of the mean square of the displacement. Empty where
/// none is random.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct SpatialScatter {
    /// Standard deviation at each position.
    pub standard_deviation_si: Vec<f64>,
    /// That of each random quantity alone.
    pub contributors: Vec<DimensionContributor>,
}

/// An output in the position in which its worst case of first order is largest.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SpatialWorstCase {
    /// Number of the position.
    pub sample: usize,
    /// Largest deviation that a search found, loops closed exactly; of a path along the direction of the longest displacement,
    /// of an orientation about the axis of the largest angle.
    pub largest_si: f64,
    /// Smallest deviation that a search found.
    pub smallest_si: f64,
    /// A number that no deviation is above; `None` where nothing is proven: where plays must meet conditions together or constraints repeat others,
    /// and near singular positions.
    #[serde(default)]
    pub proven_largest_si: Option<f64>,
    /// A number that no deviation is below.
    #[serde(default)]
    pub proven_smallest_si: Option<f64>,
    /// Conditions that the plays must meet together so that the loops close.
    pub conditions: usize,
    /// What each joint with play contributes.
    pub contributors: Vec<SpatialContributor>,
}

/// What the play of a joint contributes to a worst case of first order.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SpatialContributor {
    /// The joint.
    pub joint: String,
    /// Its part; the parts of all joints add up to the worst case.
    pub part_si: f64,
    /// The largest effect of an offset of the journal without a lean. With the next it adds up to more than the part, since both share the
    /// clearance.
    pub offset_si: f64,
    /// The largest effect of a lean of the journal without an offset; `None` of a ball.
    pub lean_si: Option<f64>,
    /// The effect of the axial clearance; `None` of a joint without stops.
    pub axial_si: Option<f64>,
}
