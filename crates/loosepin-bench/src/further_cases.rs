//! Mechanisms beyond those in which integrators are compared: whether the tolerance of a study is kept where no constant was chosen.

use crate::precision::Case;
use crate::precision_cases::{CLEARANCE, RESTITUTION, RIGID};

/// A model of `cases/` or a template, of which the clearances in some joints and the restitution of a contact vary.
macro_rules! case {
    (case $name:literal, $($varied:tt)*) => {
        case!($name, concat!("cases/", $name, "/model.toml"), $($varied)*)
    };
    (template $name:literal, $($varied:tt)*) => {
        case!(
            concat!("template ", $name),
            concat!("crates/loosepin-import/templates/", $name, "/model.toml"),
            $($varied)*
        )
    };
    ($name:expr, $file:expr, $point:literal, [$($joint:literal),*], $contact:literal) => {
        Case {
            name: $name,
            file: $file,
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
    case!(case "backlash_test", "rocker.ear", ["crank_pin", "coupler_pin", "rocker_pivot"], "bush"),
    case!(case "eight_bar", "slider.pin", ["tip"], "steel"),
    case!(case "engine_indicator_diagram", "piston.pin", ["gudgeon"], "steel_pin"),
    case!(case "five_bar_driven_slider", "right_link.high", ["apex"], "steel"),
    case!(case "five_bar_elbow_drive", "right_link.high", ["apex"], "steel"),
    case!(case "five_bar_two_drives", "right_link.high", ["apex"], "steel"),
    case!(case "four_bar_bronze_bushing", "rocker.tip", ["tip"], "bushing"),
    case!(case "four_bar_coupler_path", "rocker.pin", ["crank_pin", "coupler_pin"], "steel_pin"),
    case!(case "four_bar_floating_coupler", "bracket.load", ["crank_end", "rocker_end"], "crank_end"),
    case!(case "four_bar_friction", "rocker.tip", ["tip"], "greased_steel"),
    case!(case "four_bar_ground_journal", "rocker.tip", ["foot"], "bushing"),
    case!(case "four_bar_three_clearances", "rocker.tip", ["crank_pin", "tip", "foot"], "damped"),
    case!(case "geared_four_bar_backlash", "rocker.tip", [], "teeth"),
    case!(case "inverted_slider_crank_literal", "arm.tip", ["crank_pin"], "bushing"),
    case!(case "inverted_slider_crank_material", "arm.tip", ["crank_pin"], "bushing"),
    case!(case "scotch_yoke", "yoke.runner", ["pin"], "roller"),
    case!(case "slider_crank_force_cut", "slider.pin", ["crank_pin", "gudgeon"], "crank_pin"),
    case!(case "slider_crank_given_stiffness", "slider.pin", ["gudgeon"], "polymer"),
    case!(case "slider_crank_worn_pin", "slider.pin", ["gudgeon"], "steel_pin"),
    case!(template "double-slider", "rod.pen", ["pin_along"], "steel_pin"),
    case!(template "four-bar", "rocker.pin", ["rocker_pin"], "steel_pin"),
    case!(template "inverted-slider-crank", "arm.tip", ["crank_pin"], "bush"),
    case!(template "offset-slider-crank", "plunger.pin", ["crank_pin"], "steel_pin"),
    case!(template "pantograph", "pen_bar.pen", ["side"], "brass_bush"),
    case!(template "scotch-yoke", "yoke.rod", ["crank_pin"], "bush"),
    case!(template "slider-crank", "slider.pin", ["gudgeon"], "steel_pin"),
    case!(template "stephenson-six-bar", "arm.pin", ["tracer"], "steel_pin"),
    case!(template "toggle-press", "ram.pin", ["ram_pin"], "steel_pin"),
    case!(template "watt-six-bar", "arm.pin", ["coupler_pin"], "steel_pin"),
    case!(template "whitworth-quick-return", "ram.pin", ["ram_pin"], "steel_pin"),
    case!(template "worn-press", "ram.pin", ["ram_pin"], "bushing"),
];
