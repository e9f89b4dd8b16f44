//! The keys of couplings.

use super::table::CSV;
use loosepin_text::document::{Key, Keys, Kind, optional, quantity, required};
use loosepin_text::units::{Dimension as D, Rule};

const OFFSET: Key = optional(
    "offset",
    Kind::AnyOf(&[quantity(D::ANGLE, Rule::Finite), quantity(D::LENGTH, Rule::Finite)]),
    "\"12 deg\"",
    "angle or position of the second joint where the first is at zero; zero if left out",
);
const RADII: Key = optional(
    "radii",
    Kind::List(&quantity(D::LENGTH, Rule::Positive)),
    "[\"20 mm\", \"45 mm\"]",
    "pitch radii on the first and on the second joint",
);
const TEETH: Key = optional(
    "teeth",
    Kind::List(&quantity(D::NUMBER, Rule::Positive)),
    "[20, 45]",
    "numbers of teeth on the first and on the second joint, in place of radii",
);

const BACKLASH: Key = optional(
    "backlash",
    quantity(D::LENGTH, Rule::NonNegative),
    "\"0.1 mm\"",
    "way from flank to flank on the pitch circles; zero, or left out: none",
);
const CONTACT: Key = optional(
    "contact",
    Kind::Reference("contact"),
    "\"teeth\"",
    "contact between the flanks; with a backlash above zero",
);

const PRESSURE_ANGLE: Key = optional(
    "pressure_angle",
    quantity(D::ANGLE, Rule::PressureAngle),
    "\"20 deg\"",
    "pressure angle at the pitch circles: both joints feel the force of the teeth; torques alone act if left out",
);

const fn first(doc: &'static str) -> Key {
    required("first", Kind::Reference("joint"), "\"input\"", doc)
}

const fn second(doc: &'static str) -> Key {
    required("second", Kind::Reference("joint"), "\"output\"", doc)
}

static GEARS_KEYS: Keys = Keys::new(
    "two gears in mesh, on revolute joints with one body in common, which carries both",
    &[
        required("kind", Kind::Choice(&["gears"]), "\"gears\"", "the kind of coupling"),
        first("revolute joint of the first gear"),
        second("revolute joint of the second gear"),
        required(
            "mesh",
            Kind::Choice(&["external", "internal"]),
            "\"external\"",
            "external: they turn against each other on their carrier; internal: the same way",
        ),
        RADII,
        TEETH,
        PRESSURE_ANGLE,
        OFFSET,
        BACKLASH,
        CONTACT,
    ],
)
.with_exactly_one(&[&["radii", "teeth"]]);

static BELT_KEYS: Keys = Keys::new(
    "a belt or a chain without slip around two wheels, on revolute joints with one body in common, which carries both",
    &[
        required("kind", Kind::Choice(&["belt"]), "\"belt\"", "the kind of coupling"),
        first("revolute joint of the first wheel"),
        second("revolute joint of the second wheel"),
        optional(
            "run",
            Kind::Choice(&["open", "crossed"]),
            "\"open\"",
            "open, if left out: the wheels turn the same way; crossed: against each other",
        ),
        RADII,
        TEETH,
        OFFSET,
    ],
)
.with_exactly_one(&[&["radii", "teeth"]]);

static RACK_KEYS: Keys = Keys::new(
    "a rack and its pinion, on a prismatic and a revolute joint with one body in common, which carries both",
    &[
        required("kind", Kind::Choice(&["rack"]), "\"rack\"", "the kind of coupling"),
        first("revolute joint of the pinion"),
        second("prismatic joint of the rack"),
        required("radius", quantity(D::LENGTH, Rule::Positive), "\"12 mm\"", "pitch radius of the pinion"),
        required(
            "direction",
            Kind::Choice(&["forward", "backward"]),
            "\"forward\"",
            "how the rack goes along the line of its guide when the pinion turns from x towards y",
        ),
        PRESSURE_ANGLE,
        OFFSET,
        BACKLASH,
        CONTACT,
    ],
);

static RATIO_KEYS: Keys = Keys::new(
    "the angle or position of the second joint is a multiple of that of the first",
    &[
        required("kind", Kind::Choice(&["ratio"]), "\"ratio\"", "the kind of coupling"),
        first("a revolute or prismatic joint"),
        second("another one"),
        required("ratio", Kind::AnyQuantity, "-2.5", "coordinate of the second joint by that of the first"),
        OFFSET,
    ],
);

pub(in crate::model) static COUPLING_KINDS: &[(&str, &Keys)] =
    &[("gears", &GEARS_KEYS), ("belt", &BELT_KEYS), ("rack", &RACK_KEYS), ("ratio", &RATIO_KEYS)];

pub(in crate::model) static CAM_KEYS: Keys = Keys::new(
    "a cam: the follower goes along a smooth profile over the angle (or position) of the cam's joint, again and again, each time from \
     where the last one ended",
    &[
        required("joint", Kind::Reference("joint"), "\"cam\"", "the joint of the cam"),
        required("follower", Kind::Reference("joint"), "\"lifter\"", "the joint of the follower"),
        optional(
            "points",
            Kind::List(&Kind::List(&Kind::AnyQuantity)),
            "[[\"0 deg\", \"0 mm\"], [\"120 deg\", \"8 mm\"], [\"360 deg\", \"0 mm\"]]",
            "pairs of an angle (or position) of the cam and that of the follower there, the first ones increasing; from the first \
             to the last is a period",
        ),
        CSV,
        optional(
            "contact",
            Kind::Reference("contact"),
            "\"tappet\"",
            "contact between cam and follower, which may then lift off; if left out, the cam holds it both ways",
        ),
    ],
)
.with_exactly_one(&[&["points", "csv"]]);
