//! How far flexible bodies bend under the loads of the rigid mechanism, and whether their formulation fits that.

use loosepin_mechanics::model::{Beam, Model};
use loosepin_result::simulation::OtherFormulation;
use loosepin_simulate::{BendingEstimate, other_formulation};
use loosepin_text::units::{Dimension, format_number, format_value};

/// Angle of a section from the frame at which foreshortening to second order is off by half a percent, rad.
const MAX_ANGLE_RAD: f64 = 0.1;
/// Angle beyond which M/(E I) along the straight link says only that it bends far, rad.
const MAX_TOLD_ANGLE_RAD: f64 = 1.0;
/// Angle below which absolute nodal coordinates are not needed, rad: impacts and ringing bend a beam by some times what its loads do.
const SMALL_ANGLE_RAD: f64 = 0.01;
/// Strain of the axis from which a floating frame is off by as much.
const MAX_STRAIN: f64 = 0.01;
/// Share of the buckling load from which a push counts: it doubles what bends the beam.
const MAX_PUSH: f64 = 0.5;
/// Share of the buckling load up to which axial forces may be left out of the bending, whose stiffness they change by as much.
const MAX_LEFT_OUT: f64 = 0.05;

/// Angles, rad, and shares of the buckling load that are round-off of zero.
const ROUND_OFF: f64 = 1e-12;

/// Bending of a body, as far as known before a run: numbers, then warnings with what to do.
pub fn bending_lines(model: &Model, estimate: &BendingEstimate, is_driven: bool) -> Vec<String> {
    let Some(beam) = &model.bodies[estimate.body.0].beam else { return Vec::new() };
    let force = |force_n: f64| {
        let is_round_off = force_n < ROUND_OFF * estimate.buckling_load_n;
        format_value(if is_round_off { 0.0 } else { two_digits(force_n) }, Dimension::FORCE)
    };
    let when = if is_driven { "over a turn" } else { "at the start" };
    let mut lines = vec![format!(
        "as a rigid link {when}: its loads {}pull by {}, push by {}",
        if estimate.largest_angle_rad.is_nan() {
            String::new()
        } else {
            format!("turn sections by {} rad, ", angle_in_words(estimate))
        },
        force(estimate.largest_tension_n),
        force(estimate.largest_compression_n),
    )];
    if estimate.largest_angle_rad.is_nan() {
        lines.push("both its ends are held: its bending is not estimated".to_owned());
    }
    for (warning, hint) in warnings(beam, other_formulation(model, estimate.body), estimate, is_driven) {
        lines.extend([format!("warning: {warning}"), format!("hint: {hint}")]);
    }
    lines
}

/// Warnings, each with a hint.
fn warnings(
    beam: &Beam,
    other: OtherFormulation,
    estimate: &BendingEstimate,
    is_driven: bool,
) -> Vec<(String, String)> {
    let angle = angle_in_words(estimate);
    let share = estimate.largest_compression_n / estimate.buckling_load_n;
    if beam.is_nodal() {
        let is_small = estimate.largest_angle_rad < SMALL_ANGLE_RAD && share < MAX_PUSH;
        let is_needless = is_driven && is_small && estimate.largest_strain < MAX_STRAIN;
        let found = other.floating_frame().filter(|_| is_needless).map(|keys| {
            let warning =
                format!("absolute nodal coordinates are not needed: its loads turn sections by {angle} rad only");
            (warning, format!("{keys} is valid up to 0.1 rad, with fewer coordinates and longer steps"))
        });
        return found.into_iter().collect();
    }
    let take_nodal = towards_nodal(other);
    let mut found = Vec::new();
    if estimate.largest_angle_rad > MAX_ANGLE_RAD {
        found.push((
            format!("its loads turn sections by {angle} rad, but a floating frame is valid up to 0.1 rad"),
            take_nodal.to_owned(),
        ));
    }
    if estimate.largest_strain > MAX_STRAIN {
        let strain = format_number(two_digits(100.0 * estimate.largest_strain));
        found.push((
            format!("its loads stretch it by {strain} %, but a floating frame is valid up to 1 %"),
            take_nodal.to_owned(),
        ));
    }
    if share > MAX_PUSH {
        let load = format_value(two_digits(estimate.buckling_load_n), Dimension::FORCE);
        let share = format_number(two_digits(share));
        found.push((format!("the push is {share} of the {load} under which it buckles"), take_nodal.to_owned()));
    }
    let axial = estimate.largest_tension_n.max(estimate.largest_compression_n) / estimate.buckling_load_n;
    if !beam.foreshortening && axial > MAX_LEFT_OUT {
        let percent = format_number(two_digits(100.0 * axial));
        let warning = format!(
            "foreshortening = \"none\" neglects that axial forces change its bending stiffness by about {percent} %"
        );
        found.push((warning, "leave foreshortening out".to_owned()));
    }
    found
}

/// The way to absolute nodal coordinates.
fn towards_nodal(other: OtherFormulation) -> &'static str {
    match other {
        OtherFormulation::AsItIs | OtherFormulation::TangentFrame | OtherFormulation::FreeAtTo => {
            "write formulation = \"absolute-nodal\""
        }
        OtherFormulation::RetardationTime => {
            "write formulation = \"absolute-nodal\", and retardation_time instead of damping_ratio"
        }
        OtherFormulation::EndsAlone => {
            "use absolute nodal coordinates without lumps, points between the ends and damping_ratio: remove these and write formulation = \"absolute-nodal\", or use a stiffer section"
        }
    }
}

fn angle_in_words(estimate: &BendingEstimate) -> String {
    let angle_rad = estimate.largest_angle_rad;
    if angle_rad > MAX_TOLD_ANGLE_RAD {
        return format!("more than {MAX_TOLD_ANGLE_RAD}");
    }
    format_number(if angle_rad < ROUND_OFF { 0.0 } else { two_digits(angle_rad) })
}

/// A number to two significant digits.
fn two_digits(number: f64) -> f64 {
    format!("{number:.1e}").parse().unwrap_or(number)
}

#[cfg(test)]
mod tests {
    use super::{angle_in_words, bending_lines, warnings};
    use loosepin_mechanics::model::{BodyId, Model};
    use loosepin_simulate::{BendingEstimate, other_formulation};

    fn model(from: &str, to: &str) -> Model {
        let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../cases/flexible_slider_crank/model.toml");
        let text = std::fs::read_to_string(path).expect("the case is there");
        assert!(text.contains(from), "{from}");
        Model::from_text("model.toml", &text.replace(from, to)).expect("a model")
    }

    fn estimate(largest_angle_rad: f64, push: f64, largest_strain: f64) -> BendingEstimate {
        BendingEstimate {
            body: BodyId(2),
            largest_angle_rad,
            largest_tension_n: 12.0,
            largest_compression_n: 1000.0 * push,
            buckling_load_n: 1000.0,
            largest_strain,
        }
    }

    fn found(model: &Model, estimate: &BendingEstimate, is_driven: bool) -> Vec<String> {
        let beam = model.bodies[2].beam.as_ref().expect("a beam");
        warnings(beam, other_formulation(model, BodyId(2)), estimate, is_driven)
            .into_iter()
            .map(|(warning, hint)| format!("{warning}; {hint}"))
            .collect()
    }

    #[test]
    fn warnings_of_a_floating_frame() {
        let model = model("axial_shapes = 2", "axial_shapes = 2");
        assert!(found(&model, &estimate(0.099, 0.4, 0.009), true).is_empty());
        let bent = found(&model, &estimate(0.2345, 0.1, 1e-4), true);
        assert_eq!(
            bent,
            [
                "its loads turn sections by 0.23 rad, but a floating frame is valid up to 0.1 rad; write formulation = \"absolute-nodal\""
            ]
        );
        let pushed = found(&model, &estimate(1e-3, 0.8, 0.02), false);
        assert_eq!(pushed.len(), 2);
        assert!(
            pushed[0].starts_with("its loads stretch it by 2 %, but a floating frame is valid up to 1 %;"),
            "{}",
            pushed[0]
        );
        assert!(pushed[1].starts_with("the push is 0.8 of the 1000 N under which it buckles;"), "{}", pushed[1]);
    }

    /// What is advised can be done: the file with the keys that the hint names is read, with all others of the floating frame left out.
    #[test]
    fn hints_towards_absolute_nodal_coordinates_can_be_followed() {
        let shapes = "lateral_shapes = 2\naxial_shapes = 2";
        let hint = |to: &str| found(&model(shapes, to), &estimate(0.2345, 0.1, 1e-4), true).swap_remove(0);
        let damped = hint(&format!("{shapes}\ndamping_ratio = 0.01"));
        assert!(
            damped.ends_with("; write formulation = \"absolute-nodal\", and retardation_time instead of damping_ratio"),
            "{damped}"
        );
        model(shapes, "formulation = \"absolute-nodal\"\nretardation_time = \"1 us\"");
        let points = "small_end = [\"rod_length\", \"0 mm\"] }";
        let with_point = model(points, &points.replace(" }", ", eye = [\"100 mm\", \"0 mm\"] }"));
        let lumped = hint(&format!("{shapes}\nlumps.bush = {{ at = \"small_end\", mass = \"1 g\" }}"));
        for hint in [lumped, found(&with_point, &estimate(0.2345, 0.1, 1e-4), true).swap_remove(0)] {
            assert!(
                hint.ends_with(
                    "; use absolute nodal coordinates without lumps, points between the ends and damping_ratio: remove these and write formulation = \"absolute-nodal\", or use a stiffer section"
                ),
                "{hint}"
            );
        }
    }

    #[test]
    fn warnings_of_a_linear_form() {
        let model = model("axial_shapes = 2", "axial_shapes = 2\nforeshortening = \"none\"");
        assert!(found(&model, &estimate(1e-3, 0.04, 1e-4), true).is_empty());
        let linear = found(&model, &estimate(1e-3, 0.12, 1e-4), true);
        assert_eq!(linear.len(), 1);
        assert!(
            linear[0].contains("change its bending stiffness by about 12 %; leave foreshortening out"),
            "{}",
            linear[0]
        );
    }

    #[test]
    fn warnings_of_absolute_nodal_coordinates_that_are_not_needed() {
        let model = model("lateral_shapes = 2\naxial_shapes = 2", "formulation = \"absolute-nodal\"");
        let needless = found(&model, &estimate(0.0042, 0.1, 1e-4), true);
        assert_eq!(needless.len(), 1);
        assert!(
            needless[0]
                .starts_with("absolute nodal coordinates are not needed: its loads turn sections by 0.0042 rad only; "),
            "{}",
            needless[0]
        );
        // What loads do at the start says little of a motion that drives do not prescribe.
        assert!(found(&model, &estimate(0.0042, 0.1, 1e-4), false).is_empty());
        for needed in [estimate(0.02, 0.1, 1e-4), estimate(1e-3, 0.6, 1e-4), estimate(1e-3, 0.1, 0.1)] {
            assert!(found(&model, &needed, true).is_empty(), "{needed:?}");
        }
        assert_eq!(angle_in_words(&estimate(250.0, 0.0, 0.0)), "more than 1");
        assert_eq!(
            bending_lines(&model, &estimate(0.02, 1e-15, 1e-4), true),
            ["as a rigid link over a turn: its loads turn sections by 0.02 rad, pull by 12 N, push by 0 N"]
        );
        assert_eq!(
            bending_lines(&model, &estimate(f64::NAN, 0.01, 1e-4), true),
            [
                "as a rigid link over a turn: its loads pull by 12 N, push by 10 N",
                "both its ends are held: its bending is not estimated"
            ]
        );
    }
}
