//! The same mechanism with another tree: other joints are cut, links hang by their other end.

use super::{apart, case_text, four_bar_with_rigid_coupler, record_within, reordered};
use crate::elements::build;
use loosepin_simulate::{Plan, simulate};

#[test]
fn identity_a_flexible_link_may_hang_by_either_end() {
    let text = case_text("flexible_slider_crank").replace("duration = \"10 ms\"", "duration = \"2 ms\"");
    let exchanged = text.replace("from = \"big_end\"\nto = \"small_end\"", "from = \"small_end\"\nto = \"big_end\"");
    assert_ne!(text, exchanged);
    let built = build(&exchanged);
    assert!(built.mechanism.real.beams[0].is_reversed);
    let [one, other] = [&text, &exchanged].map(|text| record_within(text, 1e-12));
    assert_eq!(one.impacts.len(), other.impacts.len());
    assert!(one.impacts.len() > 5);
    for output in ["slider", "rod", "small_end_x", "small_end_y"] {
        assert!(apart(&one, &other, output) < 1e-11, "{output}: {:e}", apart(&one, &other, output));
    }
}

/// A closed loop with a flexible rod and no play: the guide, the gudgeon or the crank pin is cut, the rod hangs by its big or by its small
/// end. Starts at rest in its frame; the rod rings.
#[test]
fn identity_whichever_joint_of_a_loop_is_cut() {
    let text = case_text("flexible_slider_crank")
        .replace("duration = \"10 ms\"", "duration = \"3 ms\"")
        .replace("radial_clearance = \"0.2 mm\"", "radial_clearance = \"0 mm\"");
    let by_gudgeon = reordered(&text, "guide", "gudgeon");
    let by_crank_pin = reordered(&reordered(&text, "gudgeon", "crank_pin"), "guide", "gudgeon");
    let cuts = [&text, &by_gudgeon, &by_crank_pin].map(|text| {
        let built = build(text);
        let cut = built.mechanism.real.cuts[0];
        assert_eq!(built.mechanism.real.cuts.len(), 1);
        assert!(!built.mechanism.is_ideal());
        let joint = &built.mechanism.model.joints[cut.joint.0];
        (joint.name.clone(), joint.kind.word(), built.mechanism.real.beams[0].is_reversed)
    });
    assert_eq!(cuts[0], ("guide".to_owned(), "prismatic", false));
    assert_eq!(cuts[1], ("gudgeon".to_owned(), "revolute", false));
    assert_eq!(cuts[2], ("crank_pin".to_owned(), "revolute", true));
    let [guide, gudgeon, crank_pin] = [&text, &by_gudgeon, &by_crank_pin].map(|text| record_within(text, 1e-12));
    for other in [&gudgeon, &crank_pin] {
        for output in ["slider", "rod"] {
            assert!(apart(&guide, other, output) < 1e-11, "{output}: {:e}", apart(&guide, other, output));
        }
        assert!(apart(&guide, other, "gudgeon_force") < 1e-4, "{:e} N", apart(&guide, other, "gudgeon_force"));
    }
    for run in [&guide, &gudgeon, &crank_pin] {
        assert!(run.energy.relative_residual < 1e-10, "{:e}", run.energy.relative_residual);
    }
    // It is not the rigid one: the slider is some micrometres off the ideal motion.
    let slider = guide.outputs.iter().find(|history| history.name == "slider").expect("an output");
    let largest = slider.deviation_si.iter().fold(0.0_f64, |largest, deviation| largest.max(deviation.abs()));
    assert!((2e-6..2e-4).contains(&largest), "{largest:e}");
}

/// The rigid coupler of the same mass: onset, speed and peak of the first contact by another program.
#[test]
fn peer_the_rigid_coupler_of_the_same_mass() {
    let texts = [case_text("flexible_four_bar"), four_bar_with_rigid_coupler()];
    let [flexible, rigid] = texts.map(|text| build(&text.replace("duration = \"20 ms\"", "duration = \"2 ms\"")));
    // A beam has the mass, the inertia and the centre of mass of a line.
    let [of_beam, of_body] = [&flexible, &rigid].map(|built| {
        let body = built.mechanism.model.bodies.iter().find(|body| body.name == "coupler").expect("the coupler");
        let centre = body.centre_of_mass_m.expect("a centre of mass");
        [body.mass_kg.expect("a mass"), body.inertia_kg_m2.expect("an inertia"), centre[0], centre[1]]
            .map(|id| built.values[id])
    });
    for (of_beam, of_body) in of_beam.iter().zip(of_body) {
        assert!((of_beam - of_body).abs() <= 1e-15 * of_body.abs(), "{of_beam} and {of_body}");
    }
    let plan = Plan::of_model(&rigid.mechanism.model);
    let record = simulate(&rigid.mechanism, &rigid.values, &plan).unwrap_or_else(|failure| panic!("{failure}")).record;
    let first = &record.impacts[0];
    assert!((first.time_s - 0.994406584e-3).abs() < 1e-12, "{:e}", first.time_s);
    assert!((first.speed_m_s - 0.40161717).abs() < 1e-8, "{}", first.speed_m_s);
    assert!((first.peak_force_n - 2759.725).abs() < 0.02, "{}", first.peak_force_n);
}
