//! Positions of journals in their bearings at the start.

use crate::mechanism::error::{MechanismError, SampleError};
use crate::model::{Model, OffsetPlace, PlayId, QuantityId, Values};
use loosepin_math::Vec2;

/// Round-off of an offset that is as long as the clearance.
const ROUND_OFF: f64 = 1e-12;

/// Position of a journal in its bearing at time zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StartOffset {
    /// Index in `Mechanism::plays`.
    pub play: usize,
    /// e = r_journal - r_bearing, along the axes of the ground, m.
    pub offset_m: Vec2<f64>,
    /// ė, m/s.
    pub velocity_m_s: Vec2<f64>,
    /// Whether e is where forces hold the journal at rest; the one given here is zero then.
    pub is_resting: bool,
}

/// The offsets of a sample, in the order of the model.
///
/// # Errors
/// [`SampleError::OffsetBeyondPlay`].
pub fn start_offsets(model: &Model, plays: &[PlayId], values: &Values) -> Result<Vec<StartOffset>, SampleError> {
    let mut offsets = Vec::new();
    for written in &model.initial_offsets {
        let id = PlayId::Joint(written.joint);
        let clearance_m = model.play_clearance(id).map_or(0.0, |clearance| values[clearance]);
        let numbers = |ids: [QuantityId; 2]| Vec2::new(values[ids[0]], values[ids[1]]);
        let (offset_m, velocity_m_s, is_resting) = match written.place {
            OffsetPlace::Resting => (Vec2::zero(), Vec2::zero(), true),
            OffsetPlace::Given { offset_m, velocity_m_s } => {
                (offset_m.map_or(Vec2::zero(), numbers), velocity_m_s.map_or(Vec2::zero(), numbers), false)
            }
        };
        if !(offset_m.length() <= (1.0 + ROUND_OFF) * clearance_m) {
            let (path, offset_m) = (format!("{}.offset", written.path), offset_m.length());
            return Err(SampleError::OffsetBeyondPlay { path, offset_m, clearance_m });
        }
        // Without play there is nothing to be displaced.
        if let Some(play) = plays.iter().position(|known| *known == id) {
            offsets.push(StartOffset { play, offset_m, velocity_m_s, is_resting });
        }
    }
    Ok(offsets)
}

/// Refuses what can be given only where the drives determine the motion.
///
/// # Errors
/// [`MechanismError::OffsetOfFreeMotion`].
pub fn demand_drives(model: &Model) -> Result<(), MechanismError> {
    let needs_drives = |place: &OffsetPlace| match place {
        OffsetPlace::Resting => Some("start"),
        OffsetPlace::Given { velocity_m_s, .. } => velocity_m_s.map(|_| "offset_velocity"),
    };
    let found = model.initial_offsets.iter().find_map(|own| Some((own, needs_drives(&own.place)?)));
    found.map_or(Ok(()), |(own, key)| Err(MechanismError::OffsetOfFreeMotion { path: format!("{}.{key}", own.path) }))
}
