//! Wear of joints by Archard's law.

use super::quantity::QuantityId;
use loosepin_text::units::Dimension;

/// Wear of a revolute joint: dV = k F_N |v_T| dt on each surface.
#[derive(Debug, Clone)]
pub struct JointWear {
    /// Wear coefficients k_i of the bearing and k_j of the journal, m²/N, >= 0; none where the surface does not wear.
    pub coefficients_m2_n: [Option<QuantityId>; 2],
    /// Length L_b of the bearing, m.
    pub bearing_length_m: QuantityId,
    /// Sectors of each surface.
    pub sectors: usize,
    /// How the pressure is distributed over them.
    pub pressure: WearPressure,
}

/// How the pressure of a contact is distributed over the sectors of a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WearPressure {
    /// Hertz's semi-ellipse of a line contact over the length of the bearing.
    HertzLine,
    /// All of it in the sector of the contact point.
    Concentrated,
}

/// The wear that is stated of a whole life: `[wear]`.
#[derive(Debug, Clone, Copy)]
pub struct WearLife {
    /// Cycles over which wear is stated; a cycle is the recorded part of the run.
    pub cycles: QuantityId,
}

/// A measure of the wear of a joint after all cycles.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum WearMeasure {
    /// Friction path ∫F_N |v_T| dt, J.
    FrictionPath,
    /// Worn volume of the bearing, m³.
    BearingVolume,
    /// Worn volume of the journal, m³.
    JournalVolume,
    /// Greatest depth of wear of the bearing, m.
    BearingDepth,
    /// Greatest depth of wear of the journal, m.
    JournalDepth,
}

impl WearMeasure {
    /// All of them, in the order in which files name them.
    pub const ALL: [Self; 5] =
        [Self::FrictionPath, Self::BearingVolume, Self::JournalVolume, Self::BearingDepth, Self::JournalDepth];

    /// Word in model files.
    pub const fn word(self) -> &'static str {
        match self {
            Self::FrictionPath => "friction_path",
            Self::BearingVolume => "bearing_volume",
            Self::JournalVolume => "journal_volume",
            Self::BearingDepth => "bearing_depth",
            Self::JournalDepth => "journal_depth",
        }
    }

    /// The measure of a joint in words.
    pub fn words(self, joint: &str) -> String {
        let measure = match self {
            Self::FrictionPath => "friction path",
            Self::BearingVolume => "worn volume of the bearing",
            Self::JournalVolume => "worn volume of the journal",
            Self::BearingDepth => "greatest depth of wear of the bearing",
            Self::JournalDepth => "greatest depth of wear of the journal",
        };
        format!("{measure} of {joint}")
    }

    /// Its dimension.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::FrictionPath => Dimension::TORQUE,
            Self::BearingVolume | Self::JournalVolume => Dimension::VOLUME,
            Self::BearingDepth | Self::JournalDepth => Dimension::LENGTH,
        }
    }

    /// Whether it needs the depths of all sectors, not the friction path alone.
    pub const fn is_depth(self) -> bool {
        matches!(self, Self::BearingDepth | Self::JournalDepth)
    }
}
