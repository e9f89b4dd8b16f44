//! Tables of wear.

use crate::model::part_reader::PartReader;
use crate::model::quantity::QuantityId;
use crate::model::wear::{FoundationChoice, MOST_JUMPS, WearPressure};
use loosepin_text::document::{Entry, Key, Kind, choice, count, optional, quantity};
use loosepin_text::units::{Dimension as D, Rule};
use loosepin_text::{choices, record};

choices!(WearPressure: "hertz-line" => Self::HertzLine, "concentrated" => Self::Concentrated);
choices!(FoundationChoice: "liu" => Self::Liu, "law" => Self::Law);
choices!(
    /// Whether the worn shape acts back.
    pub(in crate::model) struct ActsBack(bool): "fixed" => false, "worn" => true
);

record! {
    /// wear of one surface: its coefficient, or Archard's number with the hardness of the softer part
    pub(in crate::model) struct SurfaceWear for PartReader, exactly one of [coefficient, archard];
    /// wear coefficient k: worn volume over normal force and sliding distance
    optional coefficient: QuantityId = quantity(D::WEAR_COEFFICIENT, Rule::NonNegative), "\"1e-15 m^2/N\"";
    /// Archard's number K of k = K/H, in place of the coefficient; no further factor 1/3
    optional archard: QuantityId = quantity(D::NUMBER, Rule::NonNegative), "1e-4";
    /// hardness H of the softer part
    optional hardness: QuantityId = quantity(D::PRESSURE, Rule::Positive), "\"2 GPa\"";
}

record! {
    /// wear of bearing and journal by Archard's law
    pub(in crate::model) struct JointWearTable for PartReader;
    /// wear of the bearing; it does not wear if left out
    optional bearing: SurfaceWear<'t> = Kind::Table(&SurfaceWear::KEYS), "{ coefficient = \"2e-15 m^2/N\" }";
    /// wear of the journal; it does not wear if left out
    optional journal: SurfaceWear<'t> = Kind::Table(&SurfaceWear::KEYS), "{ archard = 1e-6, hardness = \"2 GPa\" }";
    /// equal sectors of each surface in which depths are counted
    optional sectors: usize = count(4, 3600), "360", or 360;
    /// distribution of the pressure: Hertz's line contact (hertz-line) or all in one sector (concentrated)
    optional pressure: WearPressure = choice::<WearPressure>(), "\"hertz-line\"", or "hertz-line";
    /// stiffness of the elastic foundation with geometry = "worn": of the line law of Liu (liu), or of the point law of the contact (law)
    optional foundation: FoundationChoice = choice::<FoundationChoice>(), "\"liu\"", or "liu";
    /// stiffness of the elastic foundation, pressure over penetration, in place of foundation
    optional foundation_stiffness: QuantityId = quantity(D::FOUNDATION, Rule::Positive), "\"6.7e12 Pa/m\"";
}

/// `wear` of a revolute joint.
pub(in crate::model) const JOINT_WEAR: Key = optional(
    "wear",
    Kind::Table(&JointWearTable::KEYS),
    "{ bearing = { coefficient = \"2e-15 m^2/N\" } }",
    "wear of bearing and journal; needs a clearance and a bearing_length",
);

record! {
    /// for how long wear is stated
    pub(in crate::model) struct LifeTable for PartReader;
    /// cycles after which wear is stated; a cycle is the recorded part of the run
    optional cycles: QuantityId = quantity(D::NUMBER, Rule::Positive), "4000", or "1";
    /// fixed: the joint keeps its unworn shape, so that wear grows evenly with the cycles; worn: the worn shape acts back on forces and pressure
    optional geometry: ActsBack = choice::<ActsBack>(), "\"worn\"", or "fixed";
    /// equal jumps over the cycles with geometry = "worn"; chosen by the tolerance if left out
    optional jumps: usize = count(1, MOST_JUMPS as u64), "16";
    /// error of a jump in the depth of any sector; 0.05 um if left out
    optional tolerance: QuantityId = quantity(D::LENGTH, Rule::Positive), "\"0.05 um\"";
    /// the output whose largest deviation from the ideal motion ends the life of the mechanism
    optional limit_of: Entry<'t> = Kind::Reference("output"), "\"slider\"";
    /// its largest deviation, in either direction
    optional limit: Entry<'t> = Kind::AnyQuantity, "\"0.2 mm\"";
}
