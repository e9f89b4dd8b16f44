//! Wear of joints by Archard's law.

use crate::model::part_reader::{DeferredQuantity, PartReader};
use loosepin_text::document::{Entry, Key, Kind, choice, count, optional, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::{Dimension, Dimension as D, Rule};
use loosepin_text::{choices, record};

/// Wear of a revolute joint: dV = k F_N |v_T| dt on each surface.
#[derive(Debug, Clone)]
pub struct JointWear {
    /// Wear coefficients k_i of the bearing and k_j of the journal, m²/N, >= 0; `None` if the surface does not wear.
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

/// Source of the stiffness of an elastic foundation.
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
    /// Geometry of the unworn joint.
    Fixed,
    /// Worn, by jumps over many cycles.
    Worn(CycleJumps),
}

/// Jumps over the cycles of a life, at most.
pub const MAX_JUMPS: usize = 4096;

/// Jumps over cycles by Heun's method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CycleJumps {
    /// This many of equal length.
    Equal(usize),
    /// As long as this error of a jump in the depth of a sector allows, m.
    Controlled(QuantityId),
}

/// A largest deviation of an output from its ideal motion, in either direction, that a mechanism may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LifeLimit {
    /// Index in [`crate::model::Model::outputs`].
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

    /// Names of the measures, in the same order.
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

choices!(WearPressure: "hertz-line" => Self::HertzLine, "concentrated" => Self::Concentrated);
choices!(FoundationChoice: "liu" => Self::Liu, "law" => Self::Law);
choices!(
    /// Whether the worn shape acts back.
    pub(in crate::model) struct ActsBack(bool): "fixed" => false, "worn" => true
);

record! {
    /// wear of one surface: the wear coefficient, or Archard's number with the hardness of the softer part
    pub(in crate::model) struct SurfaceWear for PartReader, exactly one of [coefficient, archard];
    /// wear coefficient k: worn volume per normal force and sliding distance
    optional coefficient: Option<QuantityId> = quantity(D::WEAR_COEFFICIENT, Rule::NonNegative), "\"1e-15 m^2/N\"";
    /// Archard's number K in k = K/H, instead of the coefficient; without a further factor 1/3
    optional archard: Option<QuantityId> = quantity(D::NUMBER, Rule::NonNegative), "1e-4";
    /// hardness H of the softer part
    optional hardness: Option<QuantityId> = quantity(D::PRESSURE, Rule::Positive), "\"2 GPa\"";
}

record! {
    /// wear of bearing and journal by Archard's law
    pub(in crate::model) lenient struct JointWearTable for PartReader;
    /// wear of the bearing; it does not wear if omitted
    optional bearing: Entry<'t> = Kind::Table(&SurfaceWear::KEYS), "{ coefficient = \"2e-15 m^2/N\" }";
    /// wear of the journal; it does not wear if omitted
    optional journal: Entry<'t> = Kind::Table(&SurfaceWear::KEYS), "{ archard = 1e-6, hardness = \"2 GPa\" }";
    /// number of equal sectors of each surface; each has its own wear depth
    optional sectors: usize = count(4, 3600), "360", or 360;
    /// distribution of the pressure: Hertzian line contact (hertz-line), or all of it in one sector (concentrated)
    optional pressure: Option<WearPressure> = choice::<WearPressure>(), "\"hertz-line\"", or "hertz-line";
    /// stiffness of the elastic foundation with geometry = "worn": of the line law of Liu (liu), or of the point law of the contact (law)
    optional foundation: Option<FoundationChoice> = choice::<FoundationChoice>(), "\"liu\"", or "liu";
    /// stiffness of the elastic foundation (pressure per penetration), instead of foundation
    optional foundation_stiffness: Entry<'t> = quantity(D::FOUNDATION, Rule::Positive), "\"6.7e12 Pa/m\"";
}

/// `wear` of a revolute joint.
pub(in crate::model) const JOINT_WEAR: Key = optional(
    "wear",
    Kind::Table(&JointWearTable::KEYS),
    "{ bearing = { coefficient = \"2e-15 m^2/N\" } }",
    "wear of bearing and journal; needs a clearance and a bearing_length",
);

record! {
    /// the cycles over which wear is calculated
    pub(in crate::model) struct LifeTable for PartReader;
    /// number of cycles after which the wear is shown; one cycle is the recorded part of the run
    optional cycles: Option<QuantityId> = quantity(D::NUMBER, Rule::Positive), "4000", or "1";
    /// fixed: the joint keeps its unworn shape, so that wear is proportional to the cycles; worn: the worn shape changes forces and
    /// pressure
    optional geometry: Option<ActsBack> = choice::<ActsBack>(), "\"worn\"", or "fixed";
    /// with geometry = "worn": number of equal jumps over the cycles; chosen from the tolerance if omitted
    optional jumps: Option<usize> = count(1, MAX_JUMPS as u64), "16";
    /// largest error of one jump in the depth of any sector
    optional tolerance: DeferredQuantity<'t> = quantity(D::LENGTH, Rule::Positive), "\"0.05 um\"", or "0.05 um";
    /// the output whose largest deviation from the ideal motion ends the life of the mechanism
    optional limit_of: Entry<'t> = Kind::Reference("output"), "\"slider\"";
    /// largest deviation of this output, in either direction
    optional limit: Entry<'t> = Kind::AnyQuantity, "\"0.2 mm\"";
}
