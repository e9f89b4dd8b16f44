//! Planar mechanisms whose pins lean in their bearings.

use super::motion::plan;
use super::{Built, build_text};
use loosepin_result::motion::{ClearanceAnswer, MotionRecord};
use loosepin_result::study::Deviation;
use loosepin_simulate::accuracy::{DeviationQuestion, deviation_ends, motion_with_worst_cases, position_outputs};

const OVERHUNG: &str = include_str!("../../../../../docs/examples/overhung-tool.toml");

/// Radial clearance of both pins, half of the rod carries the tool, which stands off by this, m.
const CLEARANCE_M: f64 = 0.05e-3;
const OFFSET_M: f64 = 0.04;

/// The slider-crank with an overhung tool, with changes of its text.
fn changed(changes: &[(&str, &str)]) -> Built {
    let text = changes.iter().fold(OVERHUNG.to_owned(), |text, (old, new)| {
        assert!(text.contains(old), "{old}");
        text.replace(old, new)
    });
    build_text(&text)
}

fn recorded(built: &Built) -> MotionRecord {
    motion_with_worst_cases(&built.mechanism, &built.values, &plan(built, 36)).expect("a motion")
}

fn answer<'r>(record: &'r MotionRecord, output: &str) -> &'r ClearanceAnswer {
    &record.outputs.iter().find(|own| own.name == output).expect("an output").clearance
}

/// With crank and rod in line the tool moves across the rod by e + h φ, e of the rod where the tool is, φ of the rod about its own line. In a
/// bearing of length l the pin has (u1 + u2)/2 for e and (u2 - u1)/l for φ, |u1| <= c, |u2| <= c: |e| <= c - |φ| l/2. So φ = 2c/l is worst where h
/// is above l/2, and then e is 0: 2 c h/l. With pins that do not lean it is c.
#[test]
fn analytic_tool_off_the_plane_of_a_rod_in_line_with_its_crank() {
    let record = recorded(&changed(&[]));
    let tool = answer(&record, "tool_y");
    let expected_m = 2.0 * CLEARANCE_M * OFFSET_M / 0.02;
    assert!((tool.first_order_si[0] / expected_m - 1.0).abs() < 1e-9, "{}", tool.first_order_si[0]);
    assert!((tool.held_first_order_si[0] / CLEARANCE_M - 1.0).abs() < 1e-9, "{}", tool.held_first_order_si[0]);
    // In the plane of the pins lean moves nothing, to first order.
    let rod = answer(&record, "rod_y");
    for (leaning, held) in rod.first_order_si.iter().zip(&rod.held_first_order_si) {
        assert!((leaning / held - 1.0).abs() < 1e-9, "{leaning} {held}");
    }
    // Loops closed exactly: of second order, φ² L, from it.
    let [low, high] = tool.searched[0].found_si;
    assert!((high / expected_m - 1.0).abs() < 1e-3 && (low / expected_m + 1.0).abs() < 1e-3, "{low} {high}");
}

/// Both pins turn with the rod, so that the longer bearing holds it: φ = 2c/l₂, where the pin of the shorter one, l₁, has c - φ l₁/2 left.
#[test]
fn analytic_the_longer_bearing_holds_the_rod() {
    let longer = "journal = \"slider.pin\"\nradial_clearance = \"0.05 mm\"\nbearing_length = \"20 mm\"";
    let record = recorded(&changed(&[(longer, &longer.replace("20 mm", "40 mm"))]));
    let turn_rad = 2.0 * CLEARANCE_M / 0.04;
    let expected_m = 0.5 * (CLEARANCE_M - turn_rad * 0.01) + turn_rad * OFFSET_M;
    let found_m = answer(&record, "tool_y").first_order_si[0];
    assert!((found_m / expected_m - 1.0).abs() < 1e-9, "{found_m} {expected_m}");
}

/// Only what stands off from the bearings counts.
#[test]
fn metamorphic_a_mechanism_that_is_moved_along_z_as_a_whole_is_the_same() {
    let all = ["crank", "rod", "slider"]
        .map(|body| (format!("[body.{body}]\n"), format!("[body.{body}]\noffset = \"15 mm\"\n")));
    let mut changes: Vec<(&str, &str)> = all.iter().map(|(old, new)| (old.as_str(), new.as_str())).collect();
    changes.push(("offset = \"40 mm\" ", "offset = \"55 mm\" "));
    changes.push(("[body.ground]\n", "[body.ground]\noffset = \"15 mm\"\n"));
    let [moved, plain] = [changed(&changes), changed(&[])].map(|built| recorded(&built));
    for (moved, plain) in answer(&moved, "tool_y").first_order_si.iter().zip(&answer(&plain, "tool_y").first_order_si) {
        assert!((moved / plain - 1.0).abs() < 1e-9, "{moved} {plain}");
    }
}

/// With lean held the answer is that of a planar program, to the last bit, and it is what stands beside the one with lean.
#[test]
fn metamorphic_with_lean_held_it_is_the_plane() {
    let without = recorded(&changed(&[("lean = \"free\"\n", "")]));
    assert_eq!(recorded(&changed(&[("lean = \"free\"", "lean = \"held\"")])), without);
    let leaning = recorded(&changed(&[]));
    for output in ["tool_y", "rod_y", "slider"] {
        let [held, plane] = [&answer(&leaning, output).held_first_order_si, &answer(&without, output).first_order_si];
        assert_eq!(held.len(), plane.len());
        for (held, plane) in held.iter().zip(plane) {
            assert!((held - plane).abs() <= 1e-9 * plane.abs(), "{output}: {held} {plane}");
        }
        assert!(answer(&without, output).held_first_order_si.is_empty());
    }
}

/// The proof of the plane knows no lean, and its searches do not: what is found is what leaning pins do.
#[test]
fn deviations_with_play_are_found_in_space_where_pins_lean() {
    let ends = |built: &Built| {
        let reading = position_outputs(&built.mechanism)[0].reading;
        let questions = [Deviation::Clearance, Deviation::Total].map(|of| DeviationQuestion { reading, of });
        let turn = (built.mechanism.model.cycle.span, 36);
        deviation_ends(&built.mechanism, &built.values, turn, &[], &questions).expect("it moves").of_questions
    };
    let expected_m = 2.0 * CLEARANCE_M * OFFSET_M / 0.02;
    for own in ends(&changed(&[])) {
        let [low, high] = own.found.map(|found| found.deviation_si / expected_m);
        assert!((high - 1.0).abs() < 1e-3 && (low + 1.0).abs() < 1e-3, "{low} {high}");
        assert!(own.unproven.iter().all(Option::is_some));
    }
    for own in ends(&changed(&[("lean = \"free\"", "lean = \"held\"")])) {
        assert!(own.found.iter().all(|found| found.deviation_si.is_finite()), "{:?}", own.found);
        assert!(own.unproven.iter().all(Option::is_none));
    }
}

/// A mechanism is asked in space where a pin leans, not where the key stands alone. Without it what has a meaning beside it alone is not used.
#[test]
fn lean_without_a_pin_that_leans_changes_nothing() {
    let clearance = "radial_clearance = \"0.05 mm\"\nbearing_length = \"20 mm\"\n";
    let ideal = [(clearance, "")];
    let [free, held] = ["free", "held"].map(|lean| {
        let mut changes = ideal.to_vec();
        let key = format!("lean = \"{lean}\"");
        changes.push(("lean = \"free\"", &key));
        recorded(&changed(&changes))
    });
    assert_eq!(free, held);
    let warnings = changed(&[("lean = \"free\"\n", "")]).mechanism.model.warnings;
    let words: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert!(words.iter().any(|own| own.contains("offset")), "{words:?}");
}

/// What space does not know is said, and not shown as nothing.
#[test]
fn play_of_a_guide_is_not_known_where_pins_lean() {
    let guide = "kind = \"prismatic\"\n";
    let with_play = format!("{guide}clearance = \"0.05 mm\"\nhalf_length = \"15 mm\"\nhalf_height = \"8 mm\"\n");
    let record = recorded(&changed(&[(guide, &with_play)]));
    assert!(
        record.remarks.iter().any(|remark| remark.contains("'guide'") && remark.contains("not known")),
        "{:?}",
        record.remarks
    );
    assert!(answer(&record, "slider").first_order_si.is_empty());
}
