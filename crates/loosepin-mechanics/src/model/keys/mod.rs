//! The keys of a model file.

pub(super) mod beam;
pub(super) mod control;
pub(super) mod drive;
pub(super) mod friction;
pub(super) mod spring;
pub(super) mod table;
pub(super) mod wear;

use crate::model::contact::CONTACT_KEYS;
use crate::model::coupling::{CAM, COUPLING_KINDS};
use crate::model::joint::JOINT_KINDS;
use crate::model::load::LOAD_KINDS;
use crate::model::output::OUTPUT_KEYS;
use beam::BEAM_KEYS;
use control::CONTROL_KEYS;
use drive::DRIVE_KEYS;
use loosepin_text::document::{Key, Keys, Kind, optional, quantity, required};
use loosepin_text::units::{Dimension as D, Rule};
use spring::SPRING_KINDS;
use wear::LifeTable;

const POINTS: Kind = Kind::Values(&Kind::Vector);
const POINTS_DOC: &str = "named points in the frame of the body";

const THERMAL_EXPANSION: Key = optional(
    "thermal_expansion",
    quantity(D::THERMAL_EXPANSION, Rule::Finite),
    "\"11.7e-6 1/K\"",
    "growth of all lengths of the part by its warmth; needs temperature_rise, here or at the top",
);
const TEMPERATURE_RISE_OF_BODY: Key = optional(
    "temperature_rise",
    quantity(D::TEMPERATURE, Rule::Finite),
    "\"60 K\"",
    "how much warmer than its drawing the part is; the one at the top if left out",
);

pub(in crate::model) static GROUND_KEYS: Keys = Keys::new(
    "the ground: points that do not move",
    &[
        optional("points", POINTS, "{ o = [\"0 mm\", \"0 mm\"] }", POINTS_DOC),
        THERMAL_EXPANSION,
        TEMPERATURE_RISE_OF_BODY,
    ],
);

pub(in crate::model) static BODY_KEYS: Keys = Keys::new(
    "a body: rigid with mass, inertia and centre of mass, or a flexible beam",
    &[
        optional("mass", quantity(D::MASS, Rule::Positive), "\"0.3 kg\"", "mass of a rigid body; needed for runs"),
        optional(
            "inertia",
            quantity(D::INERTIA, Rule::Positive),
            "\"1e-4 kg m^2\"",
            "moment of inertia about the centre of mass; needed for runs",
        ),
        optional(
            "centre_of_mass",
            Kind::Vector,
            "[\"25 mm\", \"0 mm\"]",
            "centre of mass in the frame of the body; needed for runs",
        ),
        optional("points", POINTS, "{ pin = [\"50 mm\", \"0 mm\"] }", POINTS_DOC),
        optional("beam", Kind::Table(&BEAM_KEYS), "", "a beam that bends and stretches, under [body.NAME.beam]"),
        THERMAL_EXPANSION,
        TEMPERATURE_RISE_OF_BODY,
    ],
);

pub(in crate::model) static ASSEMBLY_KEYS: Keys = Keys::new(
    "how loops close that can close in two ways",
    &[required(
        "guess",
        Kind::Values(&Kind::Quantity { dimension: D::ANGLE, rule: Rule::Finite }),
        "{ rocker = \"94 deg\" }",
        "about the angle of bodies at time zero",
    )],
);

/// Rows recorded in a turn, at most.
const MOST_SAMPLES_PER_TURN: u64 = 1_000_000;

/// Numbers of `[cycle]`, in model and study files alike.
pub const CYCLE_NUMBERS: [Key; 3] = [
    optional("transient_turns", Kind::Number { rule: Rule::Turns }, "2", "turns run before recording; 2 if left out"),
    optional("recorded_turns", Kind::Number { rule: Rule::SomeTurns }, "1", "turns recorded; 1 if left out"),
    optional(
        "samples_per_turn",
        Kind::Count { least: 1, most: MOST_SAMPLES_PER_TURN },
        "500",
        "rows recorded in a turn; 500 if left out",
    ),
];

pub(in crate::model) static CYCLE_KEYS: Keys = Keys::new(
    "what is run and recorded; every number can be overridden",
    &[
        optional(
            "drive",
            Kind::Reference("drive"),
            "\"crank\"",
            "the drive whose turns (constant speed) or periods (any other motion) are counted",
        ),
        optional(
            "duration",
            quantity(D::TIME, Rule::Positive),
            "\"0.2 s\"",
            "the time that counts as a turn, in place of a drive; transient_turns is then 0 if left out",
        ),
        CYCLE_NUMBERS[0],
        CYCLE_NUMBERS[1],
        CYCLE_NUMBERS[2],
    ],
)
.with_exactly_one(&[&["drive", "duration"]]);

pub(in crate::model) static INITIAL_BODY_KEYS: Keys = Keys::new(
    "where a body is at time zero and how it moves, seen from the ground",
    &[
        optional("angle", quantity(D::ANGLE, Rule::Finite), "\"90 deg\"", "angle of its x axis"),
        optional("angular_velocity", quantity(D::ANGULAR_VELOCITY, Rule::Finite), "\"2 rad/s\"", "rate of that"),
        optional("position", Kind::Vector, "[\"10 mm\", \"0 mm\"]", "origin of its frame"),
        optional("velocity", Kind::Vector, "[\"1 m/s\", \"0 m/s\"]", "velocity of that origin"),
    ],
);

pub(in crate::model) static INITIAL_JOINT_KEYS: Keys = Keys::new(
    "where a joint is at time zero and how it moves",
    &[
        optional(
            "angle",
            quantity(D::ANGLE, Rule::Finite),
            "\"30 deg\"",
            "angle of the journal's body from the bearing's",
        ),
        optional("angular_velocity", quantity(D::ANGULAR_VELOCITY, Rule::Finite), "\"2 rad/s\"", "rate of that"),
        optional("position", quantity(D::LENGTH, Rule::Finite), "\"5 mm\"", "position of the slider along the guide"),
        optional("velocity", quantity(D::VELOCITY, Rule::Finite), "\"1 m/s\"", "rate of that"),
        optional(
            "offset",
            Kind::Vector,
            "[\"0 mm\", \"-0.5 mm\"]",
            "of a joint with play: centre of the journal from that of the bearing, along the axes of the ground; none if left out",
        ),
        optional("offset_velocity", Kind::Vector, "[\"0 m/s\", \"0.1 m/s\"]", "rate of the offset; none if left out"),
        optional(
            "start",
            Kind::Choice(&["resting"]),
            "\"resting\"",
            "in place of an offset: the journal rests on the side on which the forces at the start press it",
        ),
    ],
);

pub(in crate::model) static INITIAL_KEYS: Keys = Keys::new(
    "the state at time zero: of a mechanism that its drives do not move alone, and of journals in their bearings",
    &[
        optional(
            "body",
            Kind::Tables { keys: &INITIAL_BODY_KEYS, except: &[] },
            "",
            "bodies, each under [initial.body.NAME]",
        ),
        optional(
            "joint",
            Kind::Tables { keys: &INITIAL_JOINT_KEYS, except: &[] },
            "",
            "joints, each under [initial.joint.NAME]",
        ),
    ],
);

pub(in crate::model) static MODEL_KEYS: Keys = Keys::new(
    "a planar mechanism with its nominal values",
    &[
        required("name", Kind::Text, "\"worn pin\"", "name of the mechanism"),
        optional(
            "gravity",
            quantity(D::ACCELERATION, Rule::Finite),
            "\"9.81 m/s^2\"",
            "acceleration along -y; \"0 m/s^2\" for none; needed for runs",
        ),
        optional(
            "temperature_rise",
            quantity(D::TEMPERATURE, Rule::Finite),
            "\"40 K\"",
            "how much warmer than their drawings parts with thermal_expansion are",
        ),
        optional("parameter", Kind::Values(&Kind::AnyQuantity), "", "named values for use in expressions"),
        required(
            "body",
            Kind::Tables { keys: &BODY_KEYS, except: &[("ground", &GROUND_KEYS)] },
            "",
            "the bodies, each under [body.NAME]",
        ),
        optional("contact", Kind::Tables { keys: &CONTACT_KEYS, except: &[] }, "", "contacts, shared by joints"),
        optional("joint", Kind::TaggedTables { tag: "kind", variants: JOINT_KINDS }, "", "the joints"),
        optional(
            "coupling",
            Kind::TaggedTables { tag: "kind", variants: COUPLING_KINDS },
            "",
            "gears, belts, racks and other ratios of two joints, each under [coupling.NAME]",
        ),
        optional(
            "cam",
            Kind::Tables { keys: CAM.1, except: &[] },
            "",
            "cams with a profile by points, each under [cam.NAME]",
        ),
        optional(
            "spring",
            Kind::TaggedTables { tag: "kind", variants: SPRING_KINDS },
            "",
            "springs with their dampers, each under [spring.NAME]",
        ),
        optional(
            "load",
            Kind::TaggedTables { tag: "kind", variants: LOAD_KINDS },
            "",
            "forces and torques from outside, each under [load.NAME]",
        ),
        optional("drive", Kind::Tables { keys: &DRIVE_KEYS, except: &[] }, "", "the drives, each under [drive.NAME]"),
        optional(
            "control",
            Kind::Tables { keys: &CONTROL_KEYS, except: &[] },
            "",
            "joints whose actuators follow a reference, each under [control.NAME]",
        ),
        optional("initial", Kind::Table(&INITIAL_KEYS), "", "the initial state of what the drives do not move alone"),
        optional("assembly", Kind::Table(&ASSEMBLY_KEYS), "", "how loops close that can close in two ways"),
        optional("wear", Kind::Table(&LifeTable::KEYS), "", "for how long the wear of joints is stated, under [wear]"),
        required("cycle", Kind::Table(&CYCLE_KEYS), "", "the turns to run and to record, under [cycle]"),
        optional("output", Kind::Tables { keys: &OUTPUT_KEYS, except: &[] }, "", "the outputs, in their order"),
    ],
);
