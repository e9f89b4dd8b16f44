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
    /// Stiffness of the elastic foundation, where the worn shape acts back.
    pub foundation: FoundationChoice,
}

/// Where the stiffness of an elastic foundation comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FoundationChoice {
    /// The line law of Liu and others 2006 with the materials of the contact.
    Liu,
    /// The point law of the contact.
    Law,
    /// k_f, Pa/m, as given.
    Given(QuantityId),
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
    /// Whether the worn shape acts back.
    pub geometry: WearGeometry,
    /// The deviation that ends the life of the mechanism, where one is given.
    pub limit: Option<LifeLimit>,
}

/// Shape of a wearing joint over its life.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WearGeometry {
    /// That of the unworn joint.
    Fixed,
    /// Worn, by jumps over many cycles.
    Worn(Jumps),
}

/// Jumps over the cycles of a life, at most.
pub const MOST_JUMPS: usize = 4096;

/// Jumps over cycles by Heun's method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Jumps {
    /// This many of equal length.
    Equal(usize),
    /// As long as this error of a jump in the depth of a sector allows, m.
    Controlled(QuantityId),
}

/// A largest deviation of an output from its ideal motion, in either direction, that a mechanism may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LifeLimit {
    /// Index in [`super::Model::outputs`].
    pub output: usize,
    /// The limit, SI.
    pub limit: QuantityId,
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
    /// Largest distance that the worn joint lets its journal go from the centre of the bearing, m.
    Clearance,
    /// Cycles until the mechanism does not meet its limit any more; all of them where it does to the end.
    Life,
}

impl WearMeasure {
    /// All of them, in the order in which files name them.
    pub const ALL: [Self; 7] = [
        Self::FrictionPath,
        Self::BearingVolume,
        Self::JournalVolume,
        Self::BearingDepth,
        Self::JournalDepth,
        Self::Clearance,
        Self::Life,
    ];

    /// Word in model files.
    pub const fn word(self) -> &'static str {
        match self {
            Self::FrictionPath => "friction_path",
            Self::BearingVolume => "bearing_volume",
            Self::JournalVolume => "journal_volume",
            Self::BearingDepth => "bearing_depth",
            Self::JournalDepth => "journal_depth",
            Self::Clearance => "clearance",
            Self::Life => "life",
        }
    }

    /// Their words, in the same order.
    pub const WORDS: [&'static str; 7] = {
        let (mut words, mut measure) = ([""; 7], 0);
        while measure < Self::ALL.len() {
            words[measure] = Self::ALL[measure].word();
            measure += 1;
        }
        words
    };

    /// The measure of a joint in words.
    pub fn words(self, joint: &str) -> String {
        let measure = match self {
            Self::FrictionPath => "friction path",
            Self::BearingVolume => "worn volume of the bearing",
            Self::JournalVolume => "worn volume of the journal",
            Self::BearingDepth => "greatest depth of wear of the bearing",
            Self::JournalDepth => "greatest depth of wear of the journal",
            Self::Clearance => "largest clearance after wear",
            Self::Life => return format!("cycles within the limit, with wear of {joint}"),
        };
        format!("{measure} of {joint}")
    }

    /// Its dimension.
    pub fn dimension(self) -> Dimension {
        match self {
            Self::FrictionPath => Dimension::TORQUE,
            Self::BearingVolume | Self::JournalVolume => Dimension::VOLUME,
            Self::BearingDepth | Self::JournalDepth | Self::Clearance => Dimension::LENGTH,
            Self::Life => Dimension::NUMBER,
        }
    }

    /// Whether it needs the depths of all sectors, not the friction path alone.
    pub const fn is_depth(self) -> bool {
        matches!(self, Self::BearingDepth | Self::JournalDepth)
    }
}
