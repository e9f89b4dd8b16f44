//! Keys of wear.

use crate::model::wear::MOST_JUMPS;
use loosepin_text::document::{Key, Keys, Kind, optional, quantity};
use loosepin_text::units::{Dimension as D, Rule};

/// Sectors of a surface, at least and at most.
const SECTORS: [u64; 2] = [4, 3600];

pub(in crate::model) static SURFACE_KEYS: Keys = Keys::new(
    "wear of one surface: its coefficient, or Archard's number with the hardness of the softer part",
    &[
        optional(
            "coefficient",
            quantity(D::WEAR_COEFFICIENT, Rule::NonNegative),
            "\"1e-15 m^2/N\"",
            "wear coefficient k: worn volume over normal force and sliding distance",
        ),
        optional(
            "archard",
            quantity(D::NUMBER, Rule::NonNegative),
            "1e-4",
            "Archard's number K of k = K/H, in place of the coefficient; no further factor 1/3",
        ),
        optional("hardness", quantity(D::PRESSURE, Rule::Positive), "\"2 GPa\"", "hardness H of the softer part"),
    ],
)
.with_exactly_one(&[&["coefficient", "archard"]]);

pub(in crate::model) static JOINT_WEAR_KEYS: Keys = Keys::new(
    "wear of bearing and journal by Archard's law",
    &[
        optional(
            "bearing",
            Kind::Table(&SURFACE_KEYS),
            "{ coefficient = \"2e-15 m^2/N\" }",
            "wear of the bearing; it does not wear if left out",
        ),
        optional(
            "journal",
            Kind::Table(&SURFACE_KEYS),
            "{ archard = 1e-6, hardness = \"2 GPa\" }",
            "wear of the journal; it does not wear if left out",
        ),
        optional(
            "sectors",
            Kind::Count { least: SECTORS[0], most: SECTORS[1] },
            "360",
            "equal sectors of each surface in which depths are counted; 360 if left out",
        ),
        optional(
            "pressure",
            Kind::Choice(&["hertz-line", "concentrated"]),
            "\"hertz-line\"",
            "distribution of the pressure: Hertz's line contact (hertz-line, if left out) or all in one sector (concentrated)",
        ),
        optional(
            "foundation",
            Kind::Choice(&["liu", "law"]),
            "\"liu\"",
            "stiffness of the elastic foundation with geometry = \"worn\": of the line law of Liu (liu, if left out), or of the point law of the contact (law)",
        ),
        optional(
            "foundation_stiffness",
            quantity(D::FOUNDATION, Rule::Positive),
            "\"6.7e12 Pa/m\"",
            "stiffness of the elastic foundation, pressure over penetration, in place of foundation",
        ),
    ],
);

/// `wear` of a revolute joint.
pub(in crate::model) const JOINT_WEAR: Key = optional(
    "wear",
    Kind::Table(&JOINT_WEAR_KEYS),
    "{ bearing = { coefficient = \"2e-15 m^2/N\" } }",
    "wear of bearing and journal; needs a clearance and a bearing_length",
);

pub(in crate::model) static LIFE_KEYS: Keys = Keys::new(
    "for how long wear is stated",
    &[
        optional(
            "cycles",
            quantity(D::NUMBER, Rule::Positive),
            "4000",
            "cycles after which wear is stated; a cycle is the recorded part of the run; 1 if left out",
        ),
        optional(
            "geometry",
            Kind::Choice(&["fixed", "worn"]),
            "\"worn\"",
            "fixed, if left out: the joint keeps its unworn shape, so that wear grows evenly with the cycles; worn: the worn shape acts back on forces and pressure",
        ),
        optional(
            "jumps",
            Kind::Count { least: 1, most: MOST_JUMPS as u64 },
            "16",
            "equal jumps over the cycles with geometry = \"worn\"; chosen by the tolerance if left out",
        ),
        optional(
            "tolerance",
            quantity(D::LENGTH, Rule::Positive),
            "\"0.05 um\"",
            "error of a jump in the depth of any sector; 0.05 um if left out",
        ),
        optional(
            "limit_of",
            Kind::Reference("output"),
            "\"slider\"",
            "the output whose largest deviation from the ideal motion ends the life of the mechanism",
        ),
        optional("limit", Kind::AnyQuantity, "\"0.2 mm\"", "its largest deviation, in either direction"),
    ],
);
