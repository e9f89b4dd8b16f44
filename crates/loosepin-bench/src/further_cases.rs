//! Mechanisms beyond those in which integrators are compared: whether the tolerance of a study is kept where no constant was chosen.

use crate::precision::Case;
use crate::precision_cases::{CLEARANCE, RESTITUTION, RIGID};

/// The model in a folder, of which the clearances in some joints and the restitution of a contact vary.
macro_rules! case {
    ($name:literal, $folder:literal, $point:literal, [$($joint:literal),*], $contact:literal) => {
        Case {
            name: $name,
            file: concat!($folder, "/model.toml"),
            point: $point,
            varied: &[
                $((concat!("joint.", $joint, ".radial_clearance"), CLEARANCE),)*
                (concat!("contact.", $contact, ".restitution"), RESTITUTION),
            ],
            reference_m: 1e-12,
            samples: 32,
            methods: &[],
            ..RIGID
        }
    };
}

/// All other mechanisms of `cases/` with a drive and play, and the templates.
pub const FURTHER_CASES: [Case; 31] = [
    case!("backlash_test", "cases/backlash_test", "rocker.ear", ["crank_pin", "coupler_pin", "rocker_pivot"], "bush"),
    case!("eight_bar", "cases/eight_bar", "slider.pin", ["tip"], "steel"),
    case!("engine_indicator_diagram", "cases/engine_indicator_diagram", "piston.pin", ["gudgeon"], "steel_pin"),
    case!("five_bar_driven_slider", "cases/five_bar_driven_slider", "right_link.high", ["apex"], "steel"),
    case!("five_bar_elbow_drive", "cases/five_bar_elbow_drive", "right_link.high", ["apex"], "steel"),
    case!("five_bar_two_drives", "cases/five_bar_two_drives", "right_link.high", ["apex"], "steel"),
    case!("four_bar_bronze_bushing", "cases/four_bar_bronze_bushing", "rocker.tip", ["tip"], "bushing"),
    case!(
        "four_bar_coupler_path",
        "cases/four_bar_coupler_path",
        "rocker.pin",
        ["crank_pin", "coupler_pin"],
        "steel_pin"
    ),
    case!(
        "four_bar_floating_coupler",
        "cases/four_bar_floating_coupler",
        "bracket.load",
        ["crank_end", "rocker_end"],
        "crank_end"
    ),
    case!("four_bar_friction", "cases/four_bar_friction", "rocker.tip", ["tip"], "greased_steel"),
    case!("four_bar_ground_journal", "cases/four_bar_ground_journal", "rocker.tip", ["foot"], "bushing"),
    case!(
        "four_bar_three_clearances",
        "cases/four_bar_three_clearances",
        "rocker.tip",
        ["crank_pin", "tip", "foot"],
        "damped"
    ),
    case!("geared_four_bar_backlash", "cases/geared_four_bar_backlash", "rocker.tip", [], "teeth"),
    case!("inverted_slider_crank_literal", "cases/inverted_slider_crank_literal", "arm.tip", ["crank_pin"], "bushing"),
    case!(
        "inverted_slider_crank_material",
        "cases/inverted_slider_crank_material",
        "arm.tip",
        ["crank_pin"],
        "bushing"
    ),
    case!("scotch_yoke", "cases/scotch_yoke", "yoke.runner", ["pin"], "roller"),
    case!(
        "slider_crank_force_cut",
        "cases/slider_crank_force_cut",
        "slider.pin",
        ["crank_pin", "gudgeon"],
        "crank_pin"
    ),
    case!("slider_crank_given_stiffness", "cases/slider_crank_given_stiffness", "slider.pin", ["gudgeon"], "polymer"),
    case!("slider_crank_worn_pin", "cases/slider_crank_worn_pin", "slider.pin", ["gudgeon"], "steel_pin"),
    case!(
        "template double-slider",
        "crates/loosepin-import/templates/double-slider",
        "rod.pen",
        ["pin_along"],
        "steel_pin"
    ),
    case!("template four-bar", "crates/loosepin-import/templates/four-bar", "rocker.pin", ["rocker_pin"], "steel_pin"),
    case!(
        "template inverted-slider-crank",
        "crates/loosepin-import/templates/inverted-slider-crank",
        "arm.tip",
        ["crank_pin"],
        "bush"
    ),
    case!(
        "template offset-slider-crank",
        "crates/loosepin-import/templates/offset-slider-crank",
        "plunger.pin",
        ["crank_pin"],
        "steel_pin"
    ),
    case!("template pantograph", "crates/loosepin-import/templates/pantograph", "pen_bar.pen", ["side"], "brass_bush"),
    case!("template scotch-yoke", "crates/loosepin-import/templates/scotch-yoke", "yoke.rod", ["crank_pin"], "bush"),
    case!(
        "template slider-crank",
        "crates/loosepin-import/templates/slider-crank",
        "slider.pin",
        ["gudgeon"],
        "steel_pin"
    ),
    case!(
        "template stephenson-six-bar",
        "crates/loosepin-import/templates/stephenson-six-bar",
        "arm.pin",
        ["tracer"],
        "steel_pin"
    ),
    case!(
        "template toggle-press",
        "crates/loosepin-import/templates/toggle-press",
        "ram.pin",
        ["ram_pin"],
        "steel_pin"
    ),
    case!(
        "template watt-six-bar",
        "crates/loosepin-import/templates/watt-six-bar",
        "arm.pin",
        ["coupler_pin"],
        "steel_pin"
    ),
    case!(
        "template whitworth-quick-return",
        "crates/loosepin-import/templates/whitworth-quick-return",
        "ram.pin",
        ["ram_pin"],
        "steel_pin"
    ),
    case!("template worn-press", "crates/loosepin-import/templates/worn-press", "ram.pin", ["ram_pin"], "bushing"),
];
