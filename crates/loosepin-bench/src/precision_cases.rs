//! The cases in which integrators are compared, and the methods.

use crate::precision::{Case, Method};
use loosepin::integrate::{DOP853, DORMAND_PRINCE_5, TSITOURAS_5};
use loosepin::simulate::Integrator;

/// Scatter from one sample to the next, as a share of the nominal value: enough for other sequences of contacts.
pub const CLEARANCE: f64 = 0.05;
/// Likewise.
pub const RESTITUTION: f64 = 0.02;
/// Young's modulus: other frequencies and another deflection.
const MODULUS: f64 = 0.05;

const DOP: Method =
    Method { name: "DOP853", pair: &DOP853, integrator: Integrator::Explicit, half_decades: (10, 22, 1) };
const DORMAND_PRINCE: Method = Method { name: DORMAND_PRINCE_5.name, pair: &DORMAND_PRINCE_5, ..DOP };
const TSITOURAS: Method = Method { name: TSITOURAS_5.name, pair: &TSITOURAS_5, ..DOP };
/// Whole decades from 1e-3 to 1e-8 m: a mesh limits explicit steps, and errors are small at loose tolerances already.
const LOOSE: (i32, i32, usize) = (6, 16, 2);
const RADAU: Method = Method { name: "Radau IIA 5", integrator: Integrator::Implicit, half_decades: LOOSE, ..DOP };

static EXPLICIT: [Method; 3] = [DOP, DORMAND_PRINCE, TSITOURAS];
static EXPLICIT_AND_IMPLICIT: [Method; 4] = [
    Method { half_decades: LOOSE, ..DOP },
    Method { half_decades: LOOSE, ..DORMAND_PRINCE },
    Method { half_decades: LOOSE, ..TSITOURAS },
    RADAU,
];

/// A rigid mechanism of `cases/`, whose clearance and restitution vary.
pub const RIGID: Case = Case {
    name: "",
    file: "",
    changes: &[],
    about: "",
    point: "",
    varied: &[],
    reference_m: 1e-13,
    samples: 64,
    methods: &EXPLICIT,
};

/// Rigid mechanisms.
pub const RIGID_CASES: [Case; 8] = [
    Case {
        name: "slider_crank_5000",
        file: "cases/slider_crank_5000/model.toml",
        about: "one clearance, 5000 rpm; the slider",
        point: "slider.pin",
        varied: &[("joint.gudgeon.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
        ..RIGID
    },
    Case {
        name: "slider_crank_two_clearances",
        file: "cases/slider_crank_two_clearances/model.toml",
        about: "contacts in two joints at a time; the slider",
        point: "slider.pin",
        varied: &[
            ("joint.crank_pin.radial_clearance", CLEARANCE),
            ("joint.gudgeon.radial_clearance", CLEARANCE),
            ("contact.gudgeon.restitution", RESTITUTION),
        ],
        ..RIGID
    },
    Case {
        name: "slider_crank_friction",
        file: "cases/slider_crank_friction/model.toml",
        about: "dry friction in the clearance; the slider",
        point: "slider.pin",
        varied: &[("joint.gudgeon.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
        ..RIGID
    },
    Case {
        name: "four_bar_600",
        file: "cases/four_bar_600/model.toml",
        about: "one clearance, 600 rpm; the rocker's pin",
        point: "rocker.pin",
        varied: &[("joint.coupler_pin.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
        ..RIGID
    },
    Case {
        name: "four_bar_linear_contact",
        file: "cases/four_bar_linear_contact/model.toml",
        about: "contact force linear in the penetration; the rocker's tip",
        point: "rocker.tip",
        varied: &[("joint.crank_pin.radial_clearance", CLEARANCE), ("contact.liner.restitution", RESTITUTION)],
        ..RIGID
    },
    Case {
        name: "six_bar",
        file: "cases/six_bar/model.toml",
        about: "a loop of ideal joints; the end of the link",
        point: "link.head",
        varied: &[("joint.coupler_pin.radial_clearance", CLEARANCE), ("contact.bronze_bush.restitution", RESTITUTION)],
        ..RIGID
    },
    Case {
        name: "six_bar_stephenson",
        file: "cases/six_bar_stephenson/model.toml",
        about: "a loop of ideal joints, and friction; the end of the arm",
        point: "arm.end",
        varied: &[("joint.tip.radial_clearance", CLEARANCE), ("contact.steel.restitution", RESTITUTION)],
        ..RIGID
    },
    Case {
        name: "four_bar_settling",
        file: "cases/four_bar_settling/model.toml",
        about: "contacts that begin gently, 45 rpm; the rocker's tip",
        point: "rocker.tip",
        varied: &[("joint.tip.radial_clearance", CLEARANCE), ("contact.steel.restitution", RESTITUTION)],
        reference_m: 1e-11,
        ..RIGID
    },
];

const SLIDER_CRANK: &str = "cases/flexible_slider_crank/model.toml";
const SHAPES_OF_THE_ROD: &str = "lateral_shapes = 2\naxial_shapes = 2";
const TEN_MS: &str = "duration = \"10 ms\"";
const PLAY: &str = "radial_clearance = \"0.2 mm\"";
const NO_PLAY: (&str, &str) = (PLAY, "radial_clearance = \"0 mm\"");

/// Mechanisms with a flexible link.
pub const FLEXIBLE_CASES: [Case; 6] = [
    Case {
        name: "flexible_slider_crank",
        file: SLIDER_CRANK,
        changes: &[(TEN_MS, "duration = \"4 ms\"")],
        about: "floating frame, 2 + 2 shapes, clearance, 2 ms; the slider",
        point: "slider.pin",
        varied: &[("joint.gudgeon.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
        ..RIGID
    },
    Case {
        name: "flexible_four_bar",
        file: "cases/flexible_four_bar/model.toml",
        changes: &[("duration = \"20 ms\"", "duration = \"10 ms\"")],
        about: "floating frame, 2 + 3 shapes, clearance, 5 ms; the rocker's pin",
        point: "rocker.pin",
        varied: &[("joint.coupler_pin.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
        ..RIGID
    },
    Case {
        name: "flexible_slider_crank_ideal",
        file: SLIDER_CRANK,
        changes: &[NO_PLAY],
        about: "floating frame, 2 + 2 shapes that ring, no clearance, 5 ms; the slider",
        point: "slider.pin",
        varied: &[("body.rod.beam.youngs_modulus", MODULUS)],
        ..RIGID
    },
    Case {
        name: "nodal_slider_crank_ideal",
        file: SLIDER_CRANK,
        changes: &[
            NO_PLAY,
            (SHAPES_OF_THE_ROD, "formulation = \"absolute-nodal\"\nelements = 8\nstart = \"settled\""),
            (TEN_MS, "duration = \"4 ms\""),
            // At the dead centre the slider would hardly move.
            ("start_angle = \"0 deg\"", "start_angle = \"70 deg\""),
        ],
        about: "8 elements of steel, settled, no clearance, 2 ms; the slider",
        point: "slider.pin",
        varied: &[("body.rod.beam.youngs_modulus", MODULUS)],
        reference_m: 1e-11,
        samples: 3,
        methods: &EXPLICIT_AND_IMPLICIT,
    },
    Case {
        name: "nodal_slider_crank",
        file: SLIDER_CRANK,
        changes: &[
            (SHAPES_OF_THE_ROD, "formulation = \"absolute-nodal\"\nelements = 4"),
            (TEN_MS, "duration = \"4 ms\""),
        ],
        about: "4 elements of steel, clearance, 2 ms; the slider",
        point: "slider.pin",
        varied: &[("joint.gudgeon.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
        reference_m: 1e-11,
        samples: 3,
        methods: &EXPLICIT_AND_IMPLICIT,
    },
    Case {
        name: "nodal_pendulum",
        file: "crates/loosepin-simulate/tests/files/nodal_pendulum.toml",
        changes: &[],
        about: "12 elements of rubber that swing down, 0.6 s; the tip",
        point: "rope.tip",
        varied: &[("body.rope.beam.youngs_modulus", MODULUS)],
        reference_m: 1e-11,
        samples: 3,
        methods: &EXPLICIT_AND_IMPLICIT,
    },
];
