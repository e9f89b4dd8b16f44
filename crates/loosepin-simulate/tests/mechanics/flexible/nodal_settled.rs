//! Beams in absolute nodal coordinates that start settled: the elastica, a turning bar, and the floating frame.

use super::{case_text, outcome, record, record_within, values};
use crate::elements::file;
use loosepin_result::simulation::SimulationRecord;
use loosepin_simulate::RunFailure;

/// A soft bar of 1 m that a drive holds at its root, with EA L²/EI = 1.2e5 and EI = 1 N m² of itself.
fn bar(gravity: &str, drive: &str, elements: usize, more: &str) -> String {
    format!(
        "name = \"bar\"\ngravity = \"{gravity}\"\n\
         [body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"] }}\n\
         [body.bar]\npoints = {{ root = [\"30 mm\", \"-20 mm\"], tip = [\"1030 mm\", \"-20 mm\"] }}\n\
         [body.bar.beam]\nfrom = \"root\"\nto = \"tip\"\nsection = {{ area = \"1200 mm^2\", second_moment = \"10000 mm^4\" }}\n\
         youngs_modulus = \"0.1 GPa\"\ndensity = \"1000 kg/m^3\"\nformulation = \"absolute-nodal\"\nelements = {elements}\n\
         start = \"settled\"\n\
         [joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"bar.root\"\n\
         [drive.bar]\njoint = \"main\"\n{drive}\n[cycle]\nduration = \"2 ms\"\nsamples_per_turn = 4\n\
         [output.x]\nposition_of = \"bar.tip\"\nalong = \"x\"\n[output.y]\nposition_of = \"bar.tip\"\nalong = \"y\"\n{more}\n",
    )
}

/// A drive that holds the bar at an angle.
fn held(angle_deg: f64) -> String {
    format!("motion = {{ kind = \"expression\", position = \"{angle_deg} deg + 0 rad/s * time\" }}")
}

fn force(force_n: f64, direction_deg: f64) -> String {
    format!(
        "[load.push]\nkind = \"force\"\npoint = \"bar.tip\"\nforce = \"{force_n} N\"\ndirection = \"{direction_deg} deg\"\n"
    )
}

/// The extensible elastica: as far off as 16 elements are in statics (docs/theory/absolute-nodal.md), and at rest from the start on.
#[test]
fn analytic_a_cantilever_with_a_force_across_starts_as_the_elastica() {
    let known = [(2.0, [0.839362878780, 0.493464907594], "4.9e-6"), (10.0, [0.445014107456, 0.810675624870], "6.1e-5")];
    for (alpha, [along, across], error) in known {
        let record = record(&bar("0 m/s^2", &held(0.0), 16, &force(alpha, 90.0)));
        assert!(record.bending[0].starts_settled && record.bending[0].is_nodal);
        for (x, y) in values(&record, "x").iter().zip(values(&record, "y")) {
            let found = format!("{:.1e}", (x - along).hypot(y - across));
            assert_eq!(found, error, "{alpha}: {x}, {y}");
        }
    }
}

/// A column that stands on its root bears its own weight up to ρA g L³/EI = 7.8373 (Greenhill); beyond, its start is refused.
#[test]
fn analytic_a_column_that_buckles_by_its_own_weight_has_no_settled_start() {
    let standing = |share: f64| bar(&format!("{} m/s^2", share * 7.83735 / 1.2), &held(90.0), 8, "");
    let straight = outcome(&standing(0.999)).unwrap_or_else(|failure| panic!("{failure}"));
    assert!(straight.bending[0].largest_angle_rad < 1e-7, "{:?}", straight.bending);
    assert_eq!(outcome(&standing(1.001)).expect_err("it buckles"), RunFailure::NotSettled);
}

/// A rod that turns about its end at 1000 rad/s is longer by tan(κL)/κ - L, κ = ω√(ρ/E).
#[test]
fn analytic_a_turning_rod_starts_stretched() {
    let text = bar("0 m/s^2", "speed = \"1000 rad/s\"\nstart_angle = \"0 rad\"", 8, "")
        .replace("1030 mm", "330 mm")
        .replace("0.1 GPa", "200 GPa")
        .replace("1000 kg/m^3", "7870 kg/m^3")
        .replace("duration = \"2 ms\"", "duration = \"20 us\"");
    let record = record(&text);
    for (x, y) in values(&record, "x").iter().zip(values(&record, "y")) {
        let stretch_m = x.hypot(*y) - 0.3;
        assert!((stretch_m - 3.546524091e-4).abs() < 2e-11, "{stretch_m:e}");
    }
}

/// A rod that floats and turns is longer by 2 tan(κL/2)/κ - L; its frame goes through both ends, beside the origin of its body.
#[test]
fn analytic_a_floating_rod_that_turns_starts_stretched() {
    let outputs = ["head", "tail"].map(|point| {
        ["x", "y"].map(|axis| {
            format!("[output.{point}_{axis}_of_first]\nposition_of = \"first.{point}\"\nalong = \"{axis}\"\n")
        })
    });
    let text = file("nodal_two_floating_links.toml")
        .replacen("elements = 3", "elements = 8\nstart = \"settled\"", 1)
        .replace("31 rad/s", "3000 rad/s")
        .replace("duration = \"6 ms\"", "duration = \"2 us\"")
        + "\n"
        + &outputs.concat().concat();
    let record = record(&text);
    let length_m = 0.2_f64.hypot(0.03);
    let factor_1_m = 3000.0 * (2700.0_f64 / 70e9).sqrt();
    let due_m = 2.0 * (0.5 * factor_1_m * length_m).tan() / factor_1_m - length_m;
    for row in 0..record.time_s.len() {
        let [x, y] = ["x", "y"].map(|axis| {
            let [head, tail] = ["head", "tail"].map(|point| values(&record, &format!("{point}_{axis}_of_first"))[row]);
            head - tail
        });
        let stretch_m = x.hypot(y) - length_m;
        assert!((stretch_m / due_m - 1.0).abs() < 1e-10, "{stretch_m:e} m for {due_m:e} m");
    }
}

/// The slider-crank as a closed loop without play: what elasticity adds to the motion of the slider from a settled start goes as 1/E, and is that
/// which many shapes of the floating frame find.
#[test]
fn identity_a_rod_that_starts_settled_does_not_ring() {
    let run = |keys: &str, modulus: &str| {
        let text = case_text("flexible_slider_crank")
            .replace("duration = \"10 ms\"", "duration = \"0.3 ms\"")
            .replace("radial_clearance = \"0.2 mm\"", "radial_clearance = \"0 mm\"")
            .replace("lateral_shapes = 2\naxial_shapes = 2", &format!("{keys}\nstart = \"settled\""))
            .replace("youngs_modulus = \"200 GPa\"\ndensity", &format!("youngs_modulus = \"{modulus}\"\ndensity"));
        // Tighter steps drown in the round-off of short elements.
        record_within(&text, 1e-10)
    };
    let deviation = |record: &SimulationRecord| {
        let slider = record.outputs.iter().find(|history| history.name == "slider").expect("an output");
        slider.deviation_si.clone()
    };
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    let nodes = "formulation = \"absolute-nodal\"\nelements = 4";
    let [own, stiff] = ["200 GPa", "2000 GPa"].map(|modulus| deviation(&run(nodes, modulus)));
    let floating = deviation(&run("lateral_shapes = 6\naxial_shapes = 6", "200 GPa"));
    let apart: Vec<f64> = own.iter().zip(&floating).map(|(one, other)| one - other).collect();
    assert!((largest(&own) / largest(&stiff) / 10.0 - 1.0).abs() < 0.05);
    assert_eq!(own.len(), floating.len());
    assert!(largest(&apart) < 5e-5 * largest(&own), "{:e} of {:e}", largest(&apart), largest(&own));
}

/// Welded to the ground at one end and on a pivot at the other, a bar that its weight bends has nowhere to go: nothing else can close the loop.
#[test]
fn messages_of_a_settled_start_that_leaves_a_loop_open() {
    let pivot = "[joint.far]\nkind = \"revolute\"\nbearing = \"ground.far\"\njournal = \"bar.tip\"\n";
    let main = "[joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"bar.root\"\n";
    let weld = "[joint.weld]\nkind = \"rigid\"\nfirst = \"ground.o\"\nsecond = \"bar.root\"\nangle = \"0 deg\"\n\
                [body.wheel]\nmass = \"0.1 kg\"\ninertia = \"1e-5 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
                points = { axle = [\"0 mm\", \"0 mm\"] }\n\
                [joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"wheel.axle\"\n";
    let text = bar("9.81 m/s^2", "speed = \"1 rad/s\"\nstart_angle = \"0 rad\"", 8, pivot);
    assert!(text.contains(main));
    let text = text
        .replace(main, weld)
        .replace("o = [\"0 mm\", \"0 mm\"]", "o = [\"0 mm\", \"0 mm\"], far = [\"1000 mm\", \"0 mm\"]");
    let refusal = outcome(&text).expect_err("it stays open");
    assert_eq!(refusal.code(), "settled_open");
    assert_eq!(
        refusal.to_string(),
        "a flexible body with start = \"settled\" bends or stretches there, and the links cannot close at joint 'far'"
    );
    // The same in a floating frame.
    let nodal = "formulation = \"absolute-nodal\"\nelements = 8";
    assert!(text.contains(nodal));
    let floating = text.replace(nodal, "frame = \"tangent\"\nlateral_shapes = 2\naxial_shapes = 1");
    assert_eq!(outcome(&floating).expect_err("it stays open"), refusal);
}

/// The same at half a millimetre, where a change of a shape by 1e-7 rad opens the loop by less than 1e-10 m: an angle is compared with an angle, and a
/// gap with the size of the mechanism.
#[test]
fn a_small_mechanism_that_leaves_a_loop_open_is_told_so() {
    let text = "name = \"small\"\ngravity = \"0 m/s^2\"\n\
         [body.ground]\npoints = { o = [\"0 um\", \"0 um\"], far = [\"500 um\", \"0 um\"] }\n\
         [body.bar]\npoints = { root = [\"0 um\", \"0 um\"], middle = [\"250 um\", \"0 um\"], tip = [\"500 um\", \"0 um\"] }\n\
         [body.bar.beam]\nfrom = \"root\"\nto = \"tip\"\nsection = { width = \"10 um\", height = \"2 um\" }\n\
         youngs_modulus = \"160 GPa\"\ndensity = \"2330 kg/m^3\"\nframe = \"tangent\"\nlateral_shapes = 2\naxial_shapes = 0\n\
         start = \"settled\"\n\
         [joint.weld]\nkind = \"rigid\"\nfirst = \"ground.o\"\nsecond = \"bar.root\"\nangle = \"0 deg\"\n\
         [joint.far]\nkind = \"revolute\"\nbearing = \"ground.far\"\njournal = \"bar.tip\"\n\
         [load.push]\nkind = \"force\"\npoint = \"bar.middle\"\nforce = \"1e-6 N\"\ndirection = \"-90 deg\"\n\
         [body.wheel]\nmass = \"1e-9 kg\"\ninertia = \"1e-18 kg m^2\"\ncentre_of_mass = [\"0 um\", \"0 um\"]\n\
         points = { axle = [\"0 um\", \"0 um\"] }\n\
         [joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"wheel.axle\"\n\
         [drive.wheel]\njoint = \"main\"\nspeed = \"1 rad/s\"\nstart_angle = \"0 rad\"\n\
         [cycle]\nduration = \"1 us\"\n";
    let refusal = outcome(text).expect_err("it stays open");
    assert_eq!(refusal.code(), "settled_open", "{refusal}");
}
