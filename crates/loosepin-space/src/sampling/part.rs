//! What is read off a sample, and what play may do in it.

/// What play may do in a sample.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum PlaySide {
    /// Nothing: joints are ideal, and loops with redundant rows must close without play.
    None,
    /// All that it can to first order, by the closed form; loops with redundant rows by duality.
    #[default]
    FirstOrder,
    /// All that one climb with exactly closed loops finds from the place that is worst to first order, or ideal joints if that is more. It is
    /// reached by a place of the journals; that no other place makes more is not proven. The smallest length from the nominal motion stays of
    /// first order.
    Exact,
}

/// A number of an output.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PartOfOutput {
    /// The number of `position_of` and `turn_of`, m or rad.
    Number,
    /// Place of the point of `path_of` along x of the ground, m; component of the rotation vector of `orientation_of` from the nominal orientation,
    /// along x of the body, rad.
    X,
    /// Along y.
    Y,
    /// Along z.
    Z,
    /// Displacement d·t of the point along its nominal path, t the unit vector of its velocity there, m. Where the point turns back, t is
    /// along its acceleration: the direction in which it leaves.
    Along,
    /// Displacement across the nominal path, |d - t (d·t)|, m.
    Across,
    /// Displacement in any direction, |d|, m; angle of the rotation from the nominal orientation, about any axis, rad.
    Magnitude,
}

impl PartOfOutput {
    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Number => "number",
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
            Self::Along => "along",
            Self::Across => "across",
            Self::Magnitude => "magnitude",
        }
    }

    /// The component of its output that it is the number of, where it is one.
    pub(crate) fn component(self) -> Option<usize> {
        match self {
            Self::Number | Self::X => Some(0),
            Self::Y => Some(1),
            Self::Z => Some(2),
            Self::Along | Self::Across | Self::Magnitude => None,
        }
    }

    /// Whether it is the length of a vector.
    pub fn is_never_negative(self) -> bool {
        matches!(self, Self::Across | Self::Magnitude)
    }

    /// The numbers that make it, with factors: to first order in small displacements its mean square is the sum of their mean squares times these.
    pub fn mean_square_of(self) -> &'static [(Self, f64)] {
        match self {
            Self::Number => &[(Self::Number, 1.0)],
            Self::X => &[(Self::X, 1.0)],
            Self::Y => &[(Self::Y, 1.0)],
            Self::Z => &[(Self::Z, 1.0)],
            Self::Along => &[(Self::Along, 1.0)],
            Self::Across => &[(Self::X, 1.0), (Self::Y, 1.0), (Self::Z, 1.0), (Self::Along, -1.0)],
            Self::Magnitude => &[(Self::X, 1.0), (Self::Y, 1.0), (Self::Z, 1.0)],
        }
    }

    /// Whether it is read off by the direction of the path.
    pub(crate) fn needs_path(self) -> bool {
        matches!(self, Self::Along | Self::Across)
    }
}

/// A number that is read off at each place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SampledPart {
    /// Number of the output in [`crate::SpatialModel::outputs`].
    pub output: usize,
    /// What is read off of it.
    pub part: PartOfOutput,
}
