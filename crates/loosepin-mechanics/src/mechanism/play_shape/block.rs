//! A block between the two faces of a guide.

use super::form::{PlayForm, PlayFreedom};
use loosepin_math::{Real, Vec2, numbers};

/// A block between the two faces of a guide.
#[derive(Debug, Clone, Copy)]
pub struct SliderBlock<T> {
    /// Half-length a along its axis, m.
    pub half_length_m: T,
    /// Half-height b across its axis, m.
    pub half_height_m: T,
    /// Direction of the guide's line in the guide body's frame.
    pub line: Vec2<T>,
    /// Direction of the block's axis in the slider body's frame.
    pub axis: Vec2<T>,
    /// Ends of the faces along the line, m; `None` if they have no ends. The block may overhang an end; a run in which it leaves the faces
    /// altogether fails.
    pub ends_m: Option<[T; 2]>,
}

numbers!(struct SliderBlock { half_length_m, half_height_m, line, axis, ends_m });

impl<T: Real> PlayForm<T> for SliderBlock<T> {
    fn freedom(&self) -> PlayFreedom<T> {
        PlayFreedom::Tilting { half_length_m: self.half_length_m, half_height_m: self.half_height_m }
    }

    fn thickness_m(&self, _clearance_m: T) -> T {
        self.half_height_m
    }

    #[inline(always)]
    fn directions(&self) -> [Option<Vec2<T>>; 2] {
        [Some(self.line), Some(self.axis)]
    }

    fn has_walls(&self) -> bool {
        self.ends_m.is_some()
    }
}
