//! Derivatives of an output by play and by what stands in the rows.

use crate::accuracy::play_set::PlacedBlock;
use crate::output::SpatialOutput;
use crate::play::block::PlayPart;

/// Gains of an output in a position, drives held.
#[derive(Debug, Clone, PartialEq)]
pub struct Gains {
    /// The output.
    pub output: SpatialOutput,
    /// The blocks of variables of play.
    pub blocks: Vec<PlacedBlock>,
    /// Derivative of the output by each variable of play, 1 or rad/m, before the planes of redundant rows: with them, any g + λ·h is as good.
    pub by_play: Vec<f64>,
    /// Change of the output for a change of each row, lengths over L and rad.
    pub(crate) by_rows: Vec<f64>,
}

/// Gains by the place of a journal in its bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JournalGain {
    /// g_e, by the displacement at mid-plane along x and y of the bearing.
    pub displacement: [f64; 2],
    /// g_w, by the slope of the journal's axis along x and y, m or rad.
    pub slope: [f64; 2],
    /// g_α, by the displacement along the axis; zero where it is no play.
    pub axial: f64,
}

impl Gains {
    /// The block of a part of the play of a joint.
    pub(crate) fn block(&self, joint: usize, is_it: &dyn Fn(PlayPart) -> bool) -> Option<&PlacedBlock> {
        self.blocks.iter().find(|block| block.joint == joint && is_it(block.part))
    }

    /// The gains of a joint with a bearing of length l, in terms of e = (u1 + u2)/2 and w = (u2 - u1)/l: g_e = g_1 + g_2,
    /// g_w = (g_2 - g_1) l/2. `None` for joints without end planes.
    pub fn journal(&self, joint: usize, bearing_length_m: f64) -> Option<JournalGain> {
        let of = |is_it: &dyn Fn(PlayPart) -> bool| self.by_play.get(self.block(joint, is_it)?.range());
        let of_end = |plane: usize| of(&|part| part.end_plane() == Some(plane));
        let (&[x1, y1], &[x2, y2]) = (of_end(0)?, of_end(1)?) else { return None };
        let half = 0.5 * bearing_length_m;
        Some(JournalGain {
            displacement: [x1 + x2, y1 + y2],
            slope: [(x2 - x1) * half, (y2 - y1) * half],
            axial: of(&PlayPart::is_axial).and_then(|axial| axial.first()).copied().unwrap_or(0.0),
        })
    }
}
