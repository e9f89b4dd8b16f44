//! Condensed shapes: static flexibility as before, slower waves as before, fewer evaluations.

use super::{apart, case_text, record, record_of, record_within, values};
use crate::elements::{build, file};

/// The four-bar with six lateral and eight axial shapes in its coupler: its first contact by another program. Above 40 kHz, where seven of
/// them are, its waves are not needed.
#[test]
fn peer_first_contact_of_a_coupler_with_condensed_shapes() {
    let shapes = |more: &str| {
        let text = case_text("flexible_four_bar").replace("lateral_shapes = 3", "lateral_shapes = 6");
        let text = text.replace("duration = \"20 ms\"", "duration = \"1.3 ms\"");
        let with = text.replace("axial_shapes = 2", &format!("axial_shapes = 8\n{more}"));
        assert_ne!(with, text);
        build(&with)
    };
    let all = record_of(&shapes(""), 1e-9);
    let built = shapes("condense_above = \"40 kHz\"");
    let condensed = record_of(&built, 1e-9);
    let numbers = built.sample().real.beams[0].condensed.clone().expect("shapes are condensed");
    assert!(numbers.were_hz.len() >= 3 && numbers.were_hz.iter().all(|hz| *hz > 4e4), "{:?}", numbers.were_hz);
    let told = condensed.bending[0].condensed.expect("it is told");
    assert_eq!((told.shapes, told.above_hz), (numbers.were_hz.len(), 4e4));
    // The other program: 9.942147e-4 s, 1411.5 N.
    for (record, time_s, peak) in [(&all, 1e-10, 5e-5), (&condensed, 5e-10, 2e-3)] {
        let first = &record.impacts[0];
        assert!((first.time_s - 9.942147e-4).abs() < time_s, "{:e}", first.time_s);
        assert!((first.peak_force_n / 1411.5 - 1.0).abs() < peak, "{}", first.peak_force_n);
    }
    let [all, condensed] = [&all, &condensed].map(|record| record.counters.evaluations as f64);
    assert!(condensed < 0.7 * all, "{condensed} evaluations, {all} before");
}

/// Bent and stretched by loads that do not change, a beam is where it was.
#[test]
fn identity_condensed_shapes_have_their_static_flexibility() {
    let text = case_text("flexible_slider_crank").replace("duration = \"10 ms\"", "duration = \"0.1 ms\"");
    let text = text.replace("axial_shapes = 2", "axial_shapes = 2\nstart = \"settled\"");
    let [all, condensed] = ["", "\ncondense_above = \"6 kHz\""]
        .map(|more| record(&text.replace("start = \"settled\"", &format!("start = \"settled\"{more}"))));
    let [one, other] = [&all, &condensed].map(|record| values(record, "small_end_x")[0]);
    let ideal = all.outputs.iter().find(|history| history.name == "small_end_x").expect("an output").ideal_si[0];
    assert!((one - ideal).abs() > 1e-7, "{:e}", one - ideal);
    assert!((one - other).abs() < 1e-13, "{:e}", one - other);
}

/// Where no shape is as fast as that, nothing changes.
#[test]
fn identity_nothing_is_condensed_below_the_frequency() {
    let text = case_text("flexible_slider_crank").replace("duration = \"10 ms\"", "duration = \"0.5 ms\"");
    let condensing = text.replace("axial_shapes = 2", "axial_shapes = 2\ncondense_above = \"1e6 Hz\"");
    assert_ne!(text, condensing);
    let [one, other] = [&text, &condensing].map(|text| record_within(text, 1e-9));
    assert_eq!(apart(&one, &other, "slider"), 0.0);
    // Lumps and condensed shapes in one file, whose momenta and energy other tests watch.
    let built = build(&file("flexible_lumps.toml"));
    let condensed = built.sample().real.beams[1].condensed.clone().expect("shapes are condensed");
    assert!(!condensed.were_hz.is_empty(), "{condensed:?}");
}
