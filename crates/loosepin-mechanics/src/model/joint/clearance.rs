//! Parts of a play: a pin in a hole, a block in a guide, a pin in a straight or a circular slot.

use crate::model::ids::ContactId;
use loosepin_text::numbers::QuantityId;

/// The play of a revolute joint.
#[derive(Debug, Clone)]
pub struct Clearance {
    /// Radius R_i of the bearing (hole), m, > 0.
    pub bearing_radius_m: QuantityId,
    /// Whether the file states it: else the model is complete for its motion only, and the number stands for nothing.
    pub has_radius: bool,
    /// Radial clearance c = R_i - R_j, m, >= 0 and < R_i; zero makes the joint ideal.
    pub radial_clearance_m: QuantityId,
    /// Length L of the bearing, m, > 0; there where the contact is a line contact, and where pins lean.
    pub bearing_length_m: Option<QuantityId>,
    /// How far the pin moves along its axis from the middle to either stop, m, >= 0; zero if absent. Matters where pins lean.
    pub axial_clearance_m: Option<QuantityId>,
    /// The contact between pin and hole.
    pub contact: ContactId,
}

/// The play of a slider in its guide: a block whose centre is the slider point and whose length lies along the line.
#[derive(Debug, Clone)]
pub struct GuideClearance {
    /// Half-length a of the block along the line, m, > 0.
    pub half_length_m: QuantityId,
    /// Half-height b of the block across the line, m, > 0.
    pub half_height_m: QuantityId,
    /// Gap c between the block and each face, m, >= 0; zero makes the joint ideal.
    pub clearance_m: QuantityId,
    /// Radius ρ of the corners, m, > 0; there where the stiffness comes from the materials.
    pub corner_radius_m: Option<QuantityId>,
    /// Ends of the faces, from the guide's point along the line, m; absent for faces without ends.
    pub ends_m: Option<[QuantityId; 2]>,
    /// The contact between corners and faces; its bearing is the guide, its journal the slider.
    pub contact: ContactId,
}

/// The play of a pin in a straight slot with round ends.
#[derive(Debug, Clone)]
pub struct SlotClearance {
    /// Half-length h from the middle of the slot to the centre of each round end, m, > 0.
    pub half_length_m: QuantityId,
    /// Radius R_i of the ends, half the width of the slot, m, > 0.
    pub end_radius_m: QuantityId,
    /// Clearance c = R_i - R_j, m, >= 0 and < R_i; zero makes the joint ideal.
    pub clearance_m: QuantityId,
    /// The contact between pin and slot.
    pub contact: ContactId,
}

/// The play of a pin in a slot along a circle.
#[derive(Debug, Clone)]
pub struct CircularSlotClearance {
    /// Half the width of the slot b, m, > 0 and < its radius.
    pub half_width_m: QuantityId,
    /// Clearance c = b - R_j, m, >= 0 and < b; zero makes the joint ideal.
    pub clearance_m: QuantityId,
    /// The contact between pin and slot.
    pub contact: ContactId,
}
