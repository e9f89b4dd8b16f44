//! Estimates of how far beams bend, against closed forms.

use super::case_text;
use crate::elements::build;
use loosepin_simulate::{BendingEstimate, estimate_bending};
use std::f64::consts::PI;

const LENGTH_M: f64 = 0.4;
const AREA_M2: f64 = 0.012 * 0.007;
const BENDING_N_M2: f64 = 207e9 * 0.012 * 0.007 * 0.007 * 0.007 / 12.0;
const BAR_KG: f64 = 7800.0 * AREA_M2 * LENGTH_M;

fn estimate(text: &str, span_s: f64) -> BendingEstimate {
    let built = build(text);
    let estimates =
        estimate_bending(&built.mechanism, &built.values, span_s).unwrap_or_else(|failure| panic!("{failure}"));
    assert_eq!(estimates.len(), 1);
    estimates[0]
}

/// A bar with a drive at its root.
fn bar(gravity: &str, drive: &str, formulation: &str, more: &str) -> String {
    format!(
        "name = \"bar\"\ngravity = \"{gravity}\"\n\
         [body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"] }}\n\
         [body.bar]\npoints = {{ root = [\"30 mm\", \"-20 mm\"], tip = [\"430 mm\", \"-20 mm\"] }}\n\
         [body.bar.beam]\nfrom = \"root\"\nto = \"tip\"\nsection = {{ width = \"12 mm\", height = \"7 mm\" }}\n\
         youngs_modulus = \"207 GPa\"\ndensity = \"7800 kg/m^3\"\n{formulation}\n\
         [joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"bar.root\"\n\
         [drive.bar]\njoint = \"main\"\n{drive}\n[cycle]\nduration = \"2 ms\"\n{more}\n"
    )
}

fn near(found: f64, due: f64) {
    assert!((found - due).abs() < 1e-3 * due.abs().max(1e-12), "{found:e} for {due:e}");
}

/// P L²/2EI and q L³/6EI of a cantilever in its tangent frame; P L²/3EI and q L³/8EI of them from the line through its ends.
#[test]
fn analytic_slopes_of_a_cantilever() {
    let still = "motion = { kind = \"expression\", position = \"0 rad + 0 rad/s * time\" }";
    let push = "[load.push]\nkind = \"force\"\npoint = \"bar.tip\"\nforce = \"20 N\"\ndirection = \"-90 deg\"\n";
    let weight_n = BAR_KG * 9.81;
    let square = LENGTH_M * LENGTH_M / BENDING_N_M2;
    near(estimate(&bar("0 m/s^2", still, "frame = \"tangent\"", push), 0.0).largest_angle_rad, 20.0 * square / 2.0);
    near(
        estimate(&bar("9.81 m/s^2", still, "frame = \"tangent\"", ""), 0.0).largest_angle_rad,
        weight_n * square / 6.0,
    );
    // The root turns most from the chord: w(L)/L.
    let nodal = "formulation = \"absolute-nodal\"";
    near(estimate(&bar("0 m/s^2", still, nodal, push), 0.0).largest_angle_rad, 20.0 * square / 3.0);
    near(estimate(&bar("9.81 m/s^2", still, nodal, ""), 0.0).largest_angle_rad, weight_n * square / 8.0);
    // Pushed along: its buckling load is a quarter of that between pins.
    let along = push.replace("-90 deg", "180 deg");
    let pushed = estimate(&bar("0 m/s^2", still, "frame = \"tangent\"", &along), 0.0);
    near(pushed.largest_compression_n, 20.0);
    near(pushed.largest_strain, 20.0 / (207e9 * AREA_M2));
    near(pushed.buckling_load_n, 0.25 * PI.powi(2) * BENDING_N_M2 / LENGTH_M.powi(2));
    assert!(pushed.largest_tension_n < 1e-9 && pushed.largest_angle_rad < 1e-12, "{pushed:?}");
    let mass = "[body.bar.beam.lumps]\nhead = { at = \"tip\", mass = \"0.5 kg\" }\n";
    let loaded = estimate(&bar("9.81 m/s^2", still, "frame = \"tangent\"", mass), 0.0);
    near(loaded.largest_angle_rad, (weight_n / 6.0 + 0.5 * 9.81 / 2.0) * square);
}

/// In absolute nodal coordinates a drive or a rigid joint may hold a beam at `to`: the couple there belongs to it, and a cantilever is as bent.
#[test]
fn analytic_slopes_of_a_cantilever_that_is_held_at_its_to() {
    let still = "motion = { kind = \"expression\", position = \"0 rad + 0 rad/s * time\" }";
    let push = "[load.push]\nkind = \"force\"\npoint = \"bar.tip\"\nforce = \"20 N\"\ndirection = \"-90 deg\"\n";
    let (weight_n, square) = (BAR_KG * 9.81, LENGTH_M * LENGTH_M / BENDING_N_M2);
    let turned = |gravity: &str, drive: &str, more: &str| {
        let text = bar(gravity, drive, "formulation = \"absolute-nodal\"", more);
        let ends = "from = \"root\"\nto = \"tip\"";
        assert!(text.contains(ends));
        text.replace(ends, "from = \"tip\"\nto = \"root\"")
    };
    near(estimate(&turned("0 m/s^2", still, push), 0.0).largest_angle_rad, 20.0 * square / 3.0);
    near(estimate(&turned("9.81 m/s^2", still, ""), 0.0).largest_angle_rad, weight_n * square / 8.0);
    let turning = "speed = \"300 rad/s\"\nstart_angle = \"0 deg\"";
    let found = estimate(&turned("0 m/s^2", turning, ""), 0.01);
    near(found.largest_tension_n, 0.5 * BAR_KG * 300.0_f64.powi(2) * LENGTH_M);
    assert!(found.largest_compression_n < 1e-9 && found.largest_angle_rad < 1e-9, "{found:?}");
}

/// ½ m ω² L of a bar that turns, whose largest pull is at its root.
#[test]
fn analytic_pull_of_a_turning_bar() {
    let drive = "speed = \"300 rad/s\"\nstart_angle = \"0 deg\"";
    let found = estimate(&bar("0 m/s^2", drive, "frame = \"tangent\"", ""), 0.01);
    near(found.largest_tension_n, 0.5 * BAR_KG * 300.0_f64.powi(2) * LENGTH_M);
    assert!(found.largest_compression_n < 1e-9 && found.largest_angle_rad < 1e-9, "{found:?}");
}

/// The rod of a slider-crank at its dead centre, where its inertia bends it not at all, and in a turn: another way to the angle by the load
/// ρA a_n across it, that of the points of a rigid rod.
#[test]
fn analytic_whip_of_a_connecting_rod() {
    let found = estimate(&case_text("flexible_slider_crank"), 2.0 * std::f64::consts::PI / 150.0);
    let (crank_m, rod_m, spin) = (0.15_f64, 0.3_f64, 150.0_f64);
    let bending_n_m2 = 200e9 * 0.008_f64.powi(4) / 12.0;
    let line_kg_m = 7870.0 * 0.008 * 0.008;
    let mut largest = 0.0_f64;
    for position in 0..=72 {
        let turn = f64::from(position) / 72.0 * 2.0 * std::f64::consts::PI;
        // sin φ = -(r/l) sin θ; acceleration across the rod at both ends, linear between.
        let sine = -crank_m / rod_m * turn.sin();
        let cosine = (1.0 - sine * sine).sqrt();
        let rate = -crank_m / rod_m * turn.cos() * spin / cosine;
        let change = (crank_m / rod_m * turn.sin() * spin * spin + sine * rate * rate) / cosine;
        let root = [-crank_m * spin * spin * turn.cos(), -crank_m * spin * spin * turn.sin() + 9.81];
        let across = -sine * root[0] + cosine * root[1];
        let [at_root, at_tip] = [across, across + change * rod_m].map(|acceleration| -line_kg_m * acceleration);
        // Slopes of a beam on two pins under a load that goes evenly from one value to another.
        let third = rod_m.powi(3) / (360.0 * bending_n_m2);
        for slope in [8.0 * at_root + 7.0 * at_tip, 7.0 * at_root + 8.0 * at_tip] {
            largest = largest.max((slope * third).abs());
        }
    }
    assert!(largest > 1e-3, "{largest}");
    near(found.largest_angle_rad, largest);
}

/// Euler's columns as their ends are held: clamped and free, clamped and pinned to the ground or to a slider along or across,
/// clamped at both ends, or to a slider across, and between pins.
#[test]
fn analytic_buckling_loads_of_supported_columns() {
    let own = BENDING_N_M2 / LENGTH_M.powi(2);
    // tan β = β between π and 3π/2, by halving.
    let (mut below, mut above) = (4.0_f64, 4.7_f64);
    for _ in 0..60 {
        let middle = 0.5 * (below + above);
        if middle.tan() < middle { below = middle } else { above = middle }
    }
    let pinned = below * below * own;
    // The bar is welded to the ground; the drive of the cycle turns a wheel beside it.
    let welded_bar = |formulation: &str, more: &str| {
        let text = bar("0 m/s^2", "speed = \"1 rad/s\"\nstart_angle = \"0 rad\"", formulation, more);
        let main = "[joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"bar.root\"\n";
        let weld = "[joint.weld]\nkind = \"rigid\"\nfirst = \"ground.o\"\nsecond = \"bar.root\"\nangle = \"0 deg\"\n\
                    [body.wheel]\nmass = \"0.1 kg\"\ninertia = \"1e-5 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
                    points = { axle = [\"0 mm\", \"0 mm\"] }\n\
                    [joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"wheel.axle\"\n";
        assert!(text.contains(main));
        text.replace(main, weld)
            .replace("o = [\"0 mm\", \"0 mm\"]", "o = [\"0 mm\", \"0 mm\"], far = [\"400 mm\", \"0 mm\"]")
    };
    let to_ground = "[joint.far]\nkind = \"revolute\"\nbearing = \"ground.far\"\njournal = \"bar.tip\"\n";
    let to_slider = "[body.foot]\nmass = \"0.1 kg\"\ninertia = \"1e-5 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
                     points = { pin = [\"0 mm\", \"0 mm\"] }\n\
                     [joint.far]\nkind = \"KIND\"\nbearing = \"bar.tip\"\njournal = \"foot.pin\"\n\
                     [joint.guide]\nkind = \"prismatic\"\nguide = { point = \"ground.o\", angle = \"0 deg\" }\nslider = \"foot.pin\"\n";
    let to_slider = to_slider.replace("KIND", "revolute");
    let welded = to_slider.replace(
        "kind = \"revolute\"\nbearing = \"bar.tip\"\njournal",
        "kind = \"rigid\"\nfirst = \"bar.tip\"\nangle = \"0 deg\"\nsecond",
    );
    // Through the tip of the bar.
    let across = |text: &str| {
        let along = "guide = { point = \"ground.o\", angle = \"0 deg\" }";
        assert!(text.contains(along));
        text.replace(along, "guide = { point = \"ground.far\", angle = \"90 deg\" }")
            .replace("slider = \"foot.pin\"", "slider = { point = \"foot.pin\", angle = \"90 deg\" }")
    };
    // On a link that moves otherwise the pin holds nothing sideways.
    let link = "[body.link]\nmass = \"0.1 kg\"\ninertia = \"1e-5 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
                points = { pin = [\"0 mm\", \"0 mm\"] }\n\
                [joint.far]\nkind = \"revolute\"\nbearing = \"bar.tip\"\njournal = \"link.pin\"\n\
                [initial.body.link]\nangle = \"0 deg\"\nangular_velocity = \"0 rad/s\"\n";
    let load_of = |text: String| {
        let built = build(&text);
        estimate_bending(&built.mechanism, &built.values, 0.0).unwrap_or_else(|failure| panic!("{failure}"))[0]
            .buckling_load_n
    };
    for formulation in ["formulation = \"absolute-nodal\"", "frame = \"tangent\""] {
        let clamped = |more: &str| load_of(welded_bar(formulation, more));
        near(clamped(""), 0.25 * PI.powi(2) * own);
        near(clamped(link), 0.25 * PI.powi(2) * own);
        near(clamped(to_ground), pinned);
        near(clamped(&to_slider), pinned);
        // A guide across the beam lets the end go sideways.
        near(clamped(&across(&to_slider)), 0.25 * PI.powi(2) * own);
        if formulation.starts_with("formulation") {
            near(clamped(&welded), 4.0 * PI.powi(2) * own);
            near(clamped(&across(&welded)), PI.powi(2) * own);
        }
    }
    let rod = "formulation = \"absolute-nodal\"";
    let text = case_text("flexible_slider_crank").replace("lateral_shapes = 2\naxial_shapes = 2", rod);
    near(load_of(text), PI.powi(2) * 200e9 * 0.008_f64.powi(4) / 12.0 / 0.09);
}
