//! Lumped masses on flexible links: against bodies on pins, closed forms of stress, and the matrices of a held beam.

use super::{POWER_OUTPUTS, apart, assert_power_of_the_drive, case_text, record, record_within, values};
use crate::elements::build;
use loosepin_math::solve_square;
use loosepin_mechanics::dynamics::Dynamics;
use loosepin_simulate::{Plan, simulate};

/// A body whose centre of mass lies in a revolute joint does not turn: it is a point mass. The rod of the case with such bodies on pins at its
/// small end, beside its axis and at its big end.
#[test]
fn identity_point_masses_are_bodies_on_pins() {
    let points = "small_end = [\"rod_length\", \"0 mm\"] }";
    let text = case_text("flexible_slider_crank")
        .replace(points, "small_end = [\"rod_length\", \"0 mm\"], eye = [\"110 mm\", \"7 mm\"] }")
        .replace("duration = \"10 ms\"", "duration = \"1.5 ms\"");
    let lumps = "[body.rod.beam.lumps]\nfirst = { at = \"eye\", mass = \"40 g\" }\n\
                 second = { at = \"small_end\", mass = \"25 g\" }\nthird = { at = \"big_end\", mass = \"60 g\" }\n";
    let pinned = |name: &str, point: &str, mass: &str| {
        format!(
            "\n[body.{name}]\nmass = \"{mass}\"\ninertia = \"1e-5 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
             points = {{ pin = [\"0 mm\", \"0 mm\"] }}\n\
             [joint.{name}_pin]\nkind = \"revolute\"\nbearing = \"rod.{point}\"\njournal = \"{name}.pin\"\n\
             [initial.body.{name}]\nangle = \"0 deg\"\nangular_velocity = \"0 rad/s\"\n"
        )
    };
    let more = "\n[output.pin_force]\nforce_in = \"joint.crank_pin\"\ncomponent = \"magnitude\"\n\
                [output.stress]\nstress_in = \"rod\"\n";
    for exchanged in [false, true] {
        let text = match exchanged {
            false => format!("{text}{more}"),
            true => format!("{text}{more}")
                .replace("from = \"big_end\"\nto = \"small_end\"", "from = \"small_end\"\nto = \"big_end\""),
        };
        let with_lumps = record_within(&format!("{text}{lumps}"), 1e-12);
        let bodies = pinned("a", "eye", "40 g") + &pinned("b", "small_end", "25 g") + &pinned("c", "big_end", "60 g");
        let with_bodies = record_within(&format!("{text}{bodies}"), 1e-12);
        assert!(with_lumps.impacts.len() > 2);
        assert_eq!(with_lumps.impacts.len(), with_bodies.impacts.len());
        for output in ["slider", "rod", "small_end_x", "small_end_y"] {
            let apart = apart(&with_lumps, &with_bodies, output);
            assert!(apart < 1e-11, "{output}: {apart:e}");
        }
        for output in ["gudgeon_force", "pin_force", "stress"] {
            let largest = values(&with_lumps, output).iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
            let apart = apart(&with_lumps, &with_bodies, output);
            assert!(largest > 0.0 && apart < 1e-6 * largest, "{output}: {apart:e} of {largest}");
        }
    }
}

/// Mass, centre and inertia of the straight body, by hand; two lumps at one section and one off the axis.
#[test]
fn analytic_mass_and_inertia_of_a_beam_with_lumps() {
    let built = build(&held(0.0, ""));
    let body = built.mechanism.model.bodies.iter().find(|body| body.name == "bar").expect("the bar");
    let centre = body.centre_of_mass_m.expect("a centre of mass");
    let found = [body.mass_kg.expect("a mass"), body.inertia_kg_m2.expect("an inertia"), centre[0], centre[1]]
        .map(|id| built.values[id]);
    // Mass, x, y, own inertia.
    let parts = [
        (BAR_KG, 0.23, -0.02, BAR_KG * LENGTH_M * LENGTH_M / 12.0),
        (0.05, 0.15, -0.005, 3e-5),
        (0.02, 0.15, -0.03, 0.0),
        (0.3, 0.43, -0.02, 2e-4),
        (0.1, 0.03, -0.01, 5e-5),
    ];
    let mass: f64 = parts.iter().map(|part| part.0).sum();
    let x = parts.iter().map(|part| part.0 * part.1).sum::<f64>() / mass;
    let y = parts.iter().map(|part| part.0 * part.2).sum::<f64>() / mass;
    let inertia: f64 = parts.iter().map(|part| part.3 + part.0 * ((part.1 - x).powi(2) + (part.2 - y).powi(2))).sum();
    for (found, due) in found.into_iter().zip([mass, inertia, x, y]) {
        assert!((found - due).abs() < 1e-14 * due.abs().max(0.1), "{found} for {due}");
    }
}

/// Accelerations of the shapes of a held bar: -M_f⁻¹ K q where it is bent a little, -M_f⁻¹ C q̇ where it moves.
#[test]
fn identity_accelerations_of_a_held_bar_with_lumps() {
    for text in [held(0.0, ""), held(0.02, "")] {
        let built = build(&text);
        let sample = built.sample();
        let tree = &built.mechanism.real;
        let (place, beam) = (&tree.beams[0], sample.real.held_beam(tree, 0));
        let n = place.coordinates.len();
        assert_eq!(n, 6);
        let damping = sample.real.beams[0].damping.clone();
        assert_eq!(
            damping.is_empty(),
            built.mechanism.model.bodies[1].beam.as_ref().is_none_or(|b| b.damping_ratio.is_none())
        );
        let mut dynamics = Dynamics::new(&built.mechanism, &sample);
        let mut evaluate = |q: &[f64], rates: &[f64]| {
            dynamics.evaluate(0.0, q, rates, &[]);
            dynamics.accelerations().to_vec()
        };
        let zero = vec![0.0; tree.free];
        assert_eq!(tree.free, n);
        for column in 0..n {
            let mut moved = zero.clone();
            moved[column] = 1e-9;
            let due = |matrix: &[f64]| {
                let mut right: Vec<f64> = (0..n).map(|row| -1e-9 * matrix[row * n + column]).collect();
                solve_square(&mut beam.mass().to_vec(), n, &mut right);
                right
            };
            demand_near(&evaluate(&moved, &zero), &due(beam.stiffness()));
            if !damping.is_empty() {
                demand_near(&evaluate(&zero, &moved), &due(&damping));
            }
        }
    }
}

fn demand_near(found: &[f64], due: &[f64]) {
    let size = due.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
    for (found, due) in found.iter().zip(due) {
        assert!((found - due).abs() < 1e-6 * size, "{found:e} for {due:e} of {size:e}");
    }
}

const LENGTH_M: f64 = 0.4;
const BAR_KG: f64 = 7800.0 * 0.012 * 0.007 * LENGTH_M;

/// A bar that a drive holds still at its root, with lumps at both ends, at a point beside its axis and below it.
fn held(damping_ratio: f64, more: &str) -> String {
    let damping = if damping_ratio > 0.0 { format!("damping_ratio = {damping_ratio}\n") } else { String::new() };
    format!(
        "name = \"bar\"\ngravity = \"0 m/s^2\"\n\
         [body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"] }}\n\
         [body.bar]\npoints = {{ root = [\"30 mm\", \"-20 mm\"], top = [\"150 mm\", \"-5 mm\"], below = [\"150 mm\", \"-30 mm\"], \
         tip = [\"430 mm\", \"-20 mm\"], hub = [\"30 mm\", \"-10 mm\"] }}\n\
         [body.bar.beam]\nfrom = \"root\"\nto = \"tip\"\nsection = {{ width = \"12 mm\", height = \"7 mm\" }}\n\
         youngs_modulus = \"207 GPa\"\ndensity = \"7800 kg/m^3\"\nframe = \"tangent\"\n{damping}\
         lateral_shapes = 2\naxial_shapes = 2\n\
         [body.bar.beam.lumps]\ntop = {{ at = \"top\", mass = \"50 g\", inertia = \"3e-5 kg m^2\" }}\n\
         below = {{ at = \"below\", mass = \"20 g\" }}\ntip = {{ at = \"tip\", mass = \"0.3 kg\", inertia = \"2e-4 kg m^2\" }}\n\
         hub = {{ at = \"hub\", mass = \"100 g\", inertia = \"5e-5 kg m^2\" }}\n\
         [joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"bar.root\"\n\
         [drive.bar]\njoint = \"main\"\nmotion = {{ kind = \"expression\", position = \"0 rad + 0 rad/s * time\" }}\n\
         [cycle]\nduration = \"2 ms\"\nsamples_per_turn = 4\n{more}\n"
    )
}

/// Weight of a bar and of a body at its tip, from a settled start: M c/I at the root, of the ideal bar too.
#[test]
fn analytic_stress_of_a_bar_with_a_body_at_its_tip() {
    let plain = |gravity: &str, drive: &str, more: &str| {
        let text = held(0.0, more).replace("gravity = \"0 m/s^2\"", &format!("gravity = \"{gravity}\""));
        let start = text.find("top = { at").expect("the lumps");
        let end = text.find("tip = { at").expect("the tip");
        let text = format!("{}{}", &text[..start], &text[end..]);
        let text = text.replace("frame = \"tangent\"", "frame = \"tangent\"\nstart = \"settled\"");
        text.replace("motion = { kind = \"expression\", position = \"0 rad + 0 rad/s * time\" }", drive)
    };
    let still = "motion = { kind = \"expression\", position = \"0 rad + 0 rad/s * time\" }";
    let modulus_m3 = 0.012 * 0.007_f64.powi(2) / 6.0;
    let due_pa = (0.5 * BAR_KG + 0.3) * 9.81 * LENGTH_M / modulus_m3;
    let stress = "[output.stress]\nstress_in = \"bar\"\n";
    // Second order of the slope of the tip, 0.009.
    demand_stress(&plain("9.81 m/s^2", still, stress), due_pa, 1e-4, 1e-9);
    // Turning: the body pulls by m ω² L, the bar by half of its own; its stretch of 1e-3 adds as much.
    let speed = 120.0_f64;
    let pull_n = speed.powi(2) * LENGTH_M * (0.3 + 0.5 * BAR_KG);
    let drive = format!("speed = \"{speed} rad/s\"\nstart_angle = \"0 deg\"");
    let stretch = pull_n / (207e9 * 0.012 * 0.007);
    assert!(stretch < 2e-4, "{stretch}");
    demand_stress(&plain("0 m/s^2", &drive, stress), pull_n / (0.012 * 0.007), 2e-4, 1e-9);
    // Starting to turn: inertia of the body too, J α + m α L², and α of the bar.
    let drive = "motion = { kind = \"expression\", position = \"0 rad + 0.5 * 300 rad/s^2 * time^2\" }";
    let couple_n_m = 300.0 * (2e-4 + (0.3 + BAR_KG / 3.0) * LENGTH_M * LENGTH_M);
    let record = record(&plain("0 m/s^2", drive, stress));
    let history = record.outputs.iter().find(|history| history.name == "stress").expect("an output");
    assert!((history.value_si[0] / (couple_n_m / modulus_m3) - 1.0).abs() < 2e-3, "{:e}", history.value_si[0]);
    assert!((history.ideal_si[0] / (couple_n_m / modulus_m3) - 1.0).abs() < 1e-9, "{:e}", history.ideal_si[0]);
}

fn demand_stress(text: &str, due_pa: f64, relative: f64, ideal: f64) {
    let record = record(text);
    let history = record.outputs.iter().find(|history| history.name == "stress").expect("an output");
    for (found_pa, ideal_pa) in history.value_si.iter().zip(&history.ideal_si) {
        assert!((found_pa / due_pa - 1.0).abs() < relative, "{found_pa:e} Pa for {due_pa:e} Pa");
        assert!((ideal_pa / due_pa - 1.0).abs() < ideal, "ideal {ideal_pa:e} Pa for {due_pa:e} Pa");
    }
}

/// The crank pin carries the lumps of the rod: the power of the drive is that of its force.
#[test]
fn identity_the_force_that_a_rod_with_lumps_needs_has_the_power_of_the_drive() {
    let lumps = "[body.rod.beam.lumps]\nbush = { at = \"small_end\", mass = \"50 g\", inertia = \"2e-6 kg m^2\" }\n\
                end = { at = \"big_end\", mass = \"80 g\", inertia = \"4e-6 kg m^2\" }\n";
    let text = case_text("flexible_slider_crank").replace("duration = \"10 ms\"", "duration = \"3 ms\"");
    let built =
        build(&(text.replace("axial_shapes = 2", "axial_shapes = 2\ndamping_ratio = 0.02") + POWER_OUTPUTS + lumps));
    let record = simulate(&built.mechanism, &built.values, &Plan::of_model(&built.mechanism.model))
        .unwrap_or_else(|failure| panic!("{failure}"))
        .record;
    assert_power_of_the_drive(&record);
    assert!(record.energy.relative_residual < 1e-9, "{:e}", record.energy.relative_residual);
    assert!(
        record.energy.damping_loss_j.last().is_some_and(|loss| *loss > 1e-4),
        "{:?}",
        record.energy.damping_loss_j.last()
    );
}
