//! Mechanisms beyond those in which integrators are compared: whether the tolerance of a study is kept where no constant was chosen.

use crate::precision::Case;
use crate::precision_cases::{CLEARANCE, RESTITUTION, RIGID};

const fn case(
    name: &'static str,
    file: &'static str,
    point: &'static str,
    varied: &'static [(&'static str, f64)],
) -> Case {
    Case { name, file, point, varied, reference_m: 1e-12, samples: 32, methods: &[], ..RIGID }
}

/// All other mechanisms of `cases/` with a drive and play, and the templates.
pub const FURTHER_CASES: [Case; 31] = [
    case(
        "backlash_test",
        "cases/backlash_test/model.toml",
        "rocker.ear",
        &[
            ("joint.crank_pin.radial_clearance", CLEARANCE),
            ("joint.coupler_pin.radial_clearance", CLEARANCE),
            ("joint.rocker_pivot.radial_clearance", CLEARANCE),
            ("contact.bush.restitution", RESTITUTION),
        ],
    ),
    case(
        "eight_bar",
        "cases/eight_bar/model.toml",
        "slider.pin",
        &[("joint.tip.radial_clearance", CLEARANCE), ("contact.steel.restitution", RESTITUTION)],
    ),
    case(
        "engine_indicator_diagram",
        "cases/engine_indicator_diagram/model.toml",
        "piston.pin",
        &[("joint.gudgeon.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
    ),
    case(
        "five_bar_driven_slider",
        "cases/five_bar_driven_slider/model.toml",
        "right_link.high",
        &[("joint.apex.radial_clearance", CLEARANCE), ("contact.steel.restitution", RESTITUTION)],
    ),
    case(
        "five_bar_elbow_drive",
        "cases/five_bar_elbow_drive/model.toml",
        "right_link.high",
        &[("joint.apex.radial_clearance", CLEARANCE), ("contact.steel.restitution", RESTITUTION)],
    ),
    case(
        "five_bar_two_drives",
        "cases/five_bar_two_drives/model.toml",
        "right_link.high",
        &[("joint.apex.radial_clearance", CLEARANCE), ("contact.steel.restitution", RESTITUTION)],
    ),
    case(
        "four_bar_bronze_bushing",
        "cases/four_bar_bronze_bushing/model.toml",
        "rocker.tip",
        &[("joint.tip.radial_clearance", CLEARANCE), ("contact.bushing.restitution", RESTITUTION)],
    ),
    case(
        "four_bar_coupler_path",
        "cases/four_bar_coupler_path/model.toml",
        "rocker.pin",
        &[
            ("joint.crank_pin.radial_clearance", CLEARANCE),
            ("joint.coupler_pin.radial_clearance", CLEARANCE),
            ("contact.steel_pin.restitution", RESTITUTION),
        ],
    ),
    case(
        "four_bar_floating_coupler",
        "cases/four_bar_floating_coupler/model.toml",
        "bracket.load",
        &[
            ("joint.crank_end.radial_clearance", CLEARANCE),
            ("joint.rocker_end.radial_clearance", CLEARANCE),
            ("contact.crank_end.restitution", RESTITUTION),
        ],
    ),
    case(
        "four_bar_friction",
        "cases/four_bar_friction/model.toml",
        "rocker.tip",
        &[("joint.tip.radial_clearance", CLEARANCE), ("contact.greased_steel.restitution", RESTITUTION)],
    ),
    case(
        "four_bar_ground_journal",
        "cases/four_bar_ground_journal/model.toml",
        "rocker.tip",
        &[("joint.foot.radial_clearance", CLEARANCE), ("contact.bushing.restitution", RESTITUTION)],
    ),
    case(
        "four_bar_three_clearances",
        "cases/four_bar_three_clearances/model.toml",
        "rocker.tip",
        &[
            ("joint.crank_pin.radial_clearance", CLEARANCE),
            ("joint.tip.radial_clearance", CLEARANCE),
            ("joint.foot.radial_clearance", CLEARANCE),
            ("contact.damped.restitution", RESTITUTION),
        ],
    ),
    case(
        "geared_four_bar_backlash",
        "cases/geared_four_bar_backlash/model.toml",
        "rocker.tip",
        &[("contact.teeth.restitution", RESTITUTION)],
    ),
    case(
        "inverted_slider_crank_literal",
        "cases/inverted_slider_crank_literal/model.toml",
        "arm.tip",
        &[("joint.crank_pin.radial_clearance", CLEARANCE), ("contact.bushing.restitution", RESTITUTION)],
    ),
    case(
        "inverted_slider_crank_material",
        "cases/inverted_slider_crank_material/model.toml",
        "arm.tip",
        &[("joint.crank_pin.radial_clearance", CLEARANCE), ("contact.bushing.restitution", RESTITUTION)],
    ),
    case(
        "scotch_yoke",
        "cases/scotch_yoke/model.toml",
        "yoke.runner",
        &[("joint.pin.radial_clearance", CLEARANCE), ("contact.roller.restitution", RESTITUTION)],
    ),
    case(
        "slider_crank_force_cut",
        "cases/slider_crank_force_cut/model.toml",
        "slider.pin",
        &[
            ("joint.crank_pin.radial_clearance", CLEARANCE),
            ("joint.gudgeon.radial_clearance", CLEARANCE),
            ("contact.crank_pin.restitution", RESTITUTION),
        ],
    ),
    case(
        "slider_crank_given_stiffness",
        "cases/slider_crank_given_stiffness/model.toml",
        "slider.pin",
        &[("joint.gudgeon.radial_clearance", CLEARANCE), ("contact.polymer.restitution", RESTITUTION)],
    ),
    case(
        "slider_crank_worn_pin",
        "cases/slider_crank_worn_pin/model.toml",
        "slider.pin",
        &[("joint.gudgeon.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
    ),
    case(
        "template double-slider",
        "crates/loosepin-import/templates/double-slider/model.toml",
        "rod.pen",
        &[("joint.pin_along.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
    ),
    case(
        "template four-bar",
        "crates/loosepin-import/templates/four-bar/model.toml",
        "rocker.pin",
        &[("joint.rocker_pin.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
    ),
    case(
        "template inverted-slider-crank",
        "crates/loosepin-import/templates/inverted-slider-crank/model.toml",
        "arm.tip",
        &[("joint.crank_pin.radial_clearance", CLEARANCE), ("contact.bush.restitution", RESTITUTION)],
    ),
    case(
        "template offset-slider-crank",
        "crates/loosepin-import/templates/offset-slider-crank/model.toml",
        "plunger.pin",
        &[("joint.crank_pin.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
    ),
    case(
        "template pantograph",
        "crates/loosepin-import/templates/pantograph/model.toml",
        "pen_bar.pen",
        &[("joint.side.radial_clearance", CLEARANCE), ("contact.brass_bush.restitution", RESTITUTION)],
    ),
    case(
        "template scotch-yoke",
        "crates/loosepin-import/templates/scotch-yoke/model.toml",
        "yoke.rod",
        &[("joint.crank_pin.radial_clearance", CLEARANCE), ("contact.bush.restitution", RESTITUTION)],
    ),
    case(
        "template slider-crank",
        "crates/loosepin-import/templates/slider-crank/model.toml",
        "slider.pin",
        &[("joint.gudgeon.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
    ),
    case(
        "template stephenson-six-bar",
        "crates/loosepin-import/templates/stephenson-six-bar/model.toml",
        "arm.pin",
        &[("joint.tracer.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
    ),
    case(
        "template toggle-press",
        "crates/loosepin-import/templates/toggle-press/model.toml",
        "ram.pin",
        &[("joint.ram_pin.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
    ),
    case(
        "template watt-six-bar",
        "crates/loosepin-import/templates/watt-six-bar/model.toml",
        "arm.pin",
        &[("joint.coupler_pin.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
    ),
    case(
        "template whitworth-quick-return",
        "crates/loosepin-import/templates/whitworth-quick-return/model.toml",
        "ram.pin",
        &[("joint.ram_pin.radial_clearance", CLEARANCE), ("contact.steel_pin.restitution", RESTITUTION)],
    ),
    case(
        "template worn-press",
        "crates/loosepin-import/templates/worn-press/model.toml",
        "ram.pin",
        &[("joint.ram_pin.radial_clearance", CLEARANCE), ("contact.bushing.restitution", RESTITUTION)],
    ),
];
