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
