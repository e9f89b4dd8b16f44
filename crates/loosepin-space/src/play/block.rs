//! Variables of play that are bounded together.

/// What the variables of a block are, in axes of the bearing's marker.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PlayPart {
    /// Displacement of a ball's centre: three numbers.
    Ball,
    /// Place of the journal's axis in the end plane at z = -l/2: two numbers.
    FirstEnd,
    /// Place of the journal's axis in the end plane at z = +l/2: two numbers.
    SecondEnd,
    /// Displacement of a journal that does not lean: two numbers.
    Across,
    /// Displacement along the bearing's axis: one number.
    Axial,
    /// Slope of the journal's axis along x and y, tangent of its lean: two numbers without a unit.
    Lean,
}

impl PlayPart {
    /// Whether its radius is a radial clearance.
    pub fn is_radial(self) -> bool {
        matches!(self, Self::Ball | Self::FirstEnd | Self::SecondEnd | Self::Across)
    }

    /// Whether it displaces the middle of the journal alone, across the axis or in any direction.
    pub(crate) fn is_offset(self) -> bool {
        matches!(self, Self::Ball | Self::Across)
    }

    /// Whether it displaces the journal along the bearing's axis.
    pub(crate) fn is_axial(self) -> bool {
        matches!(self, Self::Axial)
    }

    /// Whether it turns the journal's axis alone.
    pub(crate) fn is_lean(self) -> bool {
        matches!(self, Self::Lean)
    }

    /// Number of the end plane of the bearing in which it displaces the journal's axis: 0 at z = -l/2, 1 at z = +l/2.
    pub(crate) fn end_plane(self) -> Option<usize> {
        match self {
            Self::FirstEnd => Some(0),
            Self::SecondEnd => Some(1),
            _ => None,
        }
    }

    /// How many numbers it has.
    pub fn size(self) -> usize {
        match self {
            Self::Ball => 3,
            Self::FirstEnd | Self::SecondEnd | Self::Across | Self::Lean => 2,
            Self::Axial => 1,
        }
    }
}

/// Variables whose length is at most a radius.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// What they are.
    pub part: PlayPart,
    /// How long they may be together, in their unit: m, and 1 of slopes.
    pub radius: f64,
}

impl Block {
    /// The centre of a ball is anywhere within this radius.
    pub fn ball(radius_m: f64) -> Self {
        Self { part: PlayPart::Ball, radius: radius_m }
    }

    /// The axis of a journal is anywhere within this radius in both end planes of its bearing.
    pub fn end_planes(radius_m: f64) -> [Self; 2] {
        [PlayPart::FirstEnd, PlayPart::SecondEnd].map(|part| Self { part, radius: radius_m })
    }

    /// A journal that does not lean is anywhere within this radius across its axis.
    pub fn across(radius_m: f64) -> Self {
        Self { part: PlayPart::Across, radius: radius_m }
    }

    /// A journal is up to this length from its middle, along its axis.
    pub fn axial(length_m: f64) -> Self {
        Self { part: PlayPart::Axial, radius: length_m }
    }

    /// A journal leans by up to this slope in any direction.
    pub fn lean(slope: f64) -> Self {
        Self { part: PlayPart::Lean, radius: slope }
    }

    /// One number up to this magnitude.
    pub(crate) fn single(magnitude: f64) -> Self {
        Self::axial(magnitude)
    }
}

#[cfg(test)]
mod tests {
    use super::Block;

    #[test]
    fn analytic_each_part_moves_a_journal_in_one_way_alone() {
        let [first, second] = Block::end_planes(0.25);
        // The way of each, and its freedoms: a ball has three, a plane two, a line one.
        let blocks = [
            (Block::ball(0.25), [true, false, false, false], 3),
            (first, [false, false, false, true], 2),
            (second, [false, false, false, true], 2),
            (Block::across(0.25), [true, false, false, false], 2),
            (Block::axial(0.25), [false, true, false, false], 1),
            (Block::lean(0.25), [false, false, true, false], 2),
            (Block::single(0.25), [false, true, false, false], 1),
        ];
        for (Block { part, radius }, ways, size) in blocks {
            let own = [part.is_offset(), part.is_axial(), part.is_lean(), part.end_plane().is_some()];
            assert_eq!(own, ways, "{part:?}");
            assert_eq!((part.size(), radius), (size, 0.25), "{part:?}");
        }
        assert_eq!([first, second].map(|block| block.part.end_plane()), [Some(0), Some(1)]);
    }
}
