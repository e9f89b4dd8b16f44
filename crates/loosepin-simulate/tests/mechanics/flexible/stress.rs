//! Stress along a beam against closed forms.

use super::{case_text, record, record_within, values};
use crate::elements::{build, file};
use loosepin_mechanics::model::Model;
use loosepin_result::simulation::SimulationRecord;

const YOUNGS_MODULUS_PA: f64 = 207e9;
const DENSITY_KG_M3: f64 = 7800.0;
const LENGTH_M: f64 = 0.4;
const WIDTH_M: f64 = 0.012;
const HEIGHT_M: f64 = 0.007;
const AREA_M2: f64 = WIDTH_M * HEIGHT_M;
/// Spin of a bar that turns, rad/s.
const SPIN_RAD_S: f64 = 1500.0;
const MODULUS_M3: f64 = WIDTH_M * HEIGHT_M * HEIGHT_M / 6.0;

/// A bar that a drive holds at its root, from a settled start.
fn bar(gravity: &str, drive: &str, shapes: [usize; 2], more: &str) -> String {
    format!(
        "name = \"bar\"\ngravity = \"{gravity}\"\n\
         [body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"] }}\n\
         [body.bar]\npoints = {{ root = [\"30 mm\", \"-20 mm\"], tip = [\"430 mm\", \"-20 mm\"] }}\n\
         [body.bar.beam]\nfrom = \"root\"\nto = \"tip\"\nsection = {{ width = \"12 mm\", height = \"7 mm\" }}\n\
         youngs_modulus = \"207 GPa\"\ndensity = \"7800 kg/m^3\"\nframe = \"tangent\"\nstart = \"settled\"\n\
         lateral_shapes = {}\naxial_shapes = {}\n\
         [joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"bar.root\"\n\
         [drive.bar]\njoint = \"main\"\n{drive}\n[cycle]\nduration = \"2 ms\"\nsamples_per_turn = 4\n\
         [output.stress]\nstress_in = \"bar\"\n{more}\n",
        shapes[0], shapes[1]
    )
}

/// A drive that holds the bar at an angle.
fn held(angle_deg: f64) -> String {
    format!("motion = {{ kind = \"expression\", position = \"{angle_deg} deg + 0 rad/s * time\" }}")
}

/// The bar in absolute nodal coordinates, of eight elements.
fn nodal(gravity: &str, drive: &str, more: &str) -> String {
    let shapes = "frame = \"tangent\"\nstart = \"settled\"\nlateral_shapes = 1\naxial_shapes = 1\n";
    let text = bar(gravity, drive, [1, 1], more);
    assert!(text.contains(shapes));
    text.replace(shapes, "formulation = \"absolute-nodal\"\nelements = 8\nstart = \"settled\"\n")
        .replace("duration = \"2 ms\"", "duration = \"0.2 ms\"")
}

/// Tighter steps drown in the round-off of the accelerations of short elements.
const TOLERANCE_OF_NODES_M: f64 = 1e-9;

fn demand(text: &str, due_pa: f64, relative: f64) {
    demand_of(&record(text), due_pa, relative);
}

fn demand_of(record: &SimulationRecord, due_pa: f64, relative: f64) {
    let stress = record.outputs.iter().find(|history| history.name == "stress").expect("an output");
    for found_pa in &stress.value_si {
        assert!((found_pa / due_pa - 1.0).abs() < relative, "{found_pa:e} Pa for {due_pa:e} Pa");
    }
}

/// Own weight and a force across the tip: M c/I at the root; a force along the bar: N/A. Two shapes are as good as eight.
#[test]
fn analytic_stress_of_a_cantilever() {
    /// Second order of the slope of the tip, which is below 0.004.
    const RELATIVE: f64 = 2e-5;
    let weight_n = DENSITY_KG_M3 * AREA_M2 * LENGTH_M * 9.81;
    for shapes in [[2, 1], [8, 2]] {
        let due_pa = 0.5 * weight_n * LENGTH_M / MODULUS_M3;
        demand(&bar("9.81 m/s^2", &held(0.0), shapes, ""), due_pa, RELATIVE);
        let load = |force_n: f64, direction: &str| {
            format!(
                "[load.push]\nkind = \"force\"\npoint = \"bar.tip\"\nforce = \"{force_n} N\"\ndirection = \"{direction}\"\n"
            )
        };
        let due_pa = (0.5 * weight_n + 2.0) * LENGTH_M / MODULUS_M3;
        demand(&bar("9.81 m/s^2", &held(0.0), shapes, &load(2.0, "-90 deg")), due_pa, RELATIVE);
        demand(&bar("0 m/s^2", &held(0.0), shapes, &load(700.0, "0 deg")), 700.0 / AREA_M2, 1e-9);
    }
}

/// A bar that turns about its root: E (1/cos κL - 1) there, κ = ω√(ρ/E); and the rigid one beside it, ½ ρ ω² L².
#[test]
fn analytic_stress_of_a_turning_bar() {
    let drive = format!("speed = \"{SPIN_RAD_S} rad/s\"\nstart_angle = \"0.7 rad\"");
    let angle = SPIN_RAD_S * (DENSITY_KG_M3 / YOUNGS_MODULUS_PA).sqrt() * LENGTH_M;
    let text = bar("0 m/s^2", &drive, [1, 2], "");
    // The stretch adds 0.57 % to the lever arms; two shapes miss 0.3 % of that.
    for (text, relative) in [(text.clone(), 3e-5), (bar("0 m/s^2", &drive, [1, 8], ""), 1e-6)] {
        demand(&text, YOUNGS_MODULUS_PA * (1.0 / angle.cos() - 1.0), relative);
    }
    let record = record(&text);
    let rigid_pa = 0.5 * DENSITY_KG_M3 * (SPIN_RAD_S * LENGTH_M).powi(2);
    for ideal_pa in &record.outputs[0].ideal_si {
        assert!((ideal_pa / rigid_pa - 1.0).abs() < 1e-9, "{ideal_pa:e} Pa for {rigid_pa:e} Pa");
    }
}

/// Absolute nodal coordinates: weight, a force across and a force along the bar, and a bar that turns; over 0.2 ms from a settled start.
#[test]
fn analytic_stress_of_a_bar_in_absolute_nodal_coordinates() {
    let load = |force_n: f64, direction: &str| {
        format!(
            "[load.push]\nkind = \"force\"\npoint = \"bar.tip\"\nforce = \"{force_n} N\"\ndirection = \"{direction}\"\n"
        )
    };
    let weight_n = DENSITY_KG_M3 * AREA_M2 * LENGTH_M * 9.81;
    let across = nodal("9.81 m/s^2", &held(0.0), &load(2.0, "-90 deg"));
    let spin = format!("speed = \"{SPIN_RAD_S} rad/s\"\nstart_angle = \"0.7 rad\"");
    let angle = SPIN_RAD_S * (DENSITY_KG_M3 / YOUNGS_MODULUS_PA).sqrt() * LENGTH_M;
    let cases = [
        (across, (0.5 * weight_n + 2.0) * LENGTH_M / MODULUS_M3, 2e-5),
        (nodal("0 m/s^2", &held(0.0), &load(700.0, "0 deg")), 700.0 / AREA_M2, 1e-6),
        (nodal("0 m/s^2", &spin, ""), YOUNGS_MODULUS_PA * (1.0 / angle.cos() - 1.0), 1e-6),
    ];
    for (text, due_pa, relative) in cases {
        demand_of(&record_within(&text, TOLERANCE_OF_NODES_M), due_pa, relative);
    }
}

/// A cantilever that bends by 1.43 rad: the moment at its root is that of the force on the lever arm of the extensible elastica, α = 10.
#[test]
fn analytic_stress_of_a_cantilever_that_bends_far() {
    // EI = 71 N m² over L²; EA L²/EI is 3.9e4, where the table has 1.2e5: the lever arm differs by a part in 2e4.
    let bending_n_m2 = YOUNGS_MODULUS_PA * 0.5 * HEIGHT_M * MODULUS_M3;
    let force_n = 10.0 * bending_n_m2 / LENGTH_M.powi(2);
    let load = format!(
        "[load.push]\nkind = \"force\"\npoint = \"bar.tip\"\nforce = \"{force_n} N\"\ndirection = \"90 deg\"\n"
    );
    let text = nodal("0 m/s^2", &held(0.0), &load).replace("elements = 8", "elements = 16");
    let due_pa = force_n * 0.445014107456 * LENGTH_M / MODULUS_M3;
    demand_of(&record_within(&text, TOLERANCE_OF_NODES_M), due_pa, 2e-4);
}

/// In motion: the coupler of the four-bar as a closed loop, eight elements against eight shapes of each kind of the floating frame.
#[test]
fn identity_stress_in_absolute_nodal_coordinates_is_that_in_the_floating_frame() {
    let run = |keys: &str| {
        case_text("flexible_four_bar")
            .replace("duration = \"20 ms\"", "duration = \"0.5 ms\"")
            .replace("radial_clearance = \"0.2 mm\"", "radial_clearance = \"0 mm\"")
            .replace("lateral_shapes = 3\naxial_shapes = 2", &format!("{keys}\nstart = \"settled\""))
            + "\n[output.stress]\nstress_in = \"coupler\"\n"
    };
    let nodes = run("formulation = \"absolute-nodal\"\nelements = 8");
    let exchanged = nodes.replace("from = \"tail\"\nto = \"head\"", "from = \"head\"\nto = \"tail\"");
    assert_ne!(nodes, exchanged);
    let shapes = record_within(&run("lateral_shapes = 8\naxial_shapes = 4"), TOLERANCE_OF_NODES_M);
    for text in [nodes, exchanged] {
        let record = record_within(&text, TOLERANCE_OF_NODES_M);
        let [nodes, shapes] = [&record, &shapes].map(|record| values(record, "stress"));
        assert_eq!(nodes.len(), shapes.len());
        for (found, due) in nodes.iter().zip(shapes) {
            assert!((found / due - 1.0).abs() < 5e-5, "{found:e} Pa for {due:e} Pa");
        }
    }
}

/// A bar in absolute nodal coordinates that is held at the end called `to`: the same closed forms.
#[test]
fn analytic_stress_of_a_bar_that_is_held_at_either_end() {
    let load = |force_n: f64, direction: &str| {
        format!(
            "[load.push]\nkind = \"force\"\npoint = \"bar.tip\"\nforce = \"{force_n} N\"\ndirection = \"{direction}\"\n"
        )
    };
    let weight_n = DENSITY_KG_M3 * AREA_M2 * LENGTH_M * 9.81;
    let exchanged = |text: String| {
        let with = text.replace("from = \"root\"\nto = \"tip\"", "from = \"tip\"\nto = \"root\"");
        assert_ne!(text, with);
        with
    };
    let cases = [
        (nodal("9.81 m/s^2", &held(0.0), &load(2.0, "-90 deg")), (0.5 * weight_n + 2.0) * LENGTH_M / MODULUS_M3, 2e-5),
        (nodal("0 m/s^2", &held(0.0), &load(700.0, "0 deg")), 700.0 / AREA_M2, 1e-6),
    ];
    for (text, due_pa, relative) in cases {
        demand_of(&record_within(&exchanged(text), TOLERANCE_OF_NODES_M), due_pa, relative);
    }
}

/// A pendulum with a heavy body welded to its far end, the one called `from`, whose couple bends it: in absolute nodal coordinates, and as a lump of a floating frame that hangs by
/// its `from`.
#[test]
fn identity_stress_of_a_pendulum_with_a_body_welded_to_it() {
    /// Of a hundredth that the couple makes.
    const RELATIVE: f64 = 2e-4;
    let pendulum = |beam: &str, more: &str| {
        let drive = "[drive.bar]\njoint = \"main\"\n";
        let text = bar("9.81 m/s^2", "", [1, 1], more);
        assert!(text.contains(drive) && text.contains("frame = \"tangent\"\n"));
        text.replace(drive, "[initial.body.bar]\nangle = \"0 deg\"\n")
            .replace("frame = \"tangent\"\nstart = \"settled\"\nlateral_shapes = 1\naxial_shapes = 1\n", beam)
            .replace("duration = \"2 ms\"", "duration = \"0.3 ms\"")
    };
    let head = "[body.head]\nmass = \"0.4 kg\"\ninertia = \"2e-2 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
                points = { weld = [\"0 mm\", \"0 mm\"] }\n\
                [joint.weld]\nkind = \"rigid\"\nfirst = \"bar.tip\"\nsecond = \"head.weld\"\nangle = \"0 deg\"\n";
    let nodal = pendulum("formulation = \"absolute-nodal\"\nelements = 8\nstart = \"settled\"\n", head)
        .replace("from = \"root\"\nto = \"tip\"", "from = \"tip\"\nto = \"root\"");
    let lump = "start = \"settled\"\nlateral_shapes = 8\naxial_shapes = 2\n\
                lumps.head = { at = \"tip\", mass = \"0.4 kg\", inertia = \"2e-2 kg m^2\" }\n";
    let floating = pendulum(lump, "");
    let built = build(&nodal);
    assert!(built.mechanism.real.nodal_beams[0].is_reversed && built.mechanism.stressed[0].is_turned);
    let [nodal, floating] = [&nodal, &floating].map(|text| record_within(text, TOLERANCE_OF_NODES_M));
    let [nodal, floating] = [&nodal, &floating].map(|record| values(record, "stress"));
    assert_eq!(nodal.len(), floating.len());
    for (found, due) in nodal.iter().zip(floating) {
        assert!((found / due - 1.0).abs() < RELATIVE, "{found:e} Pa for {due:e} Pa");
    }
}

/// A bar on two pins, the second on a slider: q L²/8 in the middle, under the weight across it.
#[test]
fn analytic_stress_of_a_bar_on_two_supports() {
    let text = bar("9.81 m/s^2", "", [2, 1], "")
        .replace("frame = \"tangent\"\n", "frame = \"secant\"\n")
        .replace("[drive.bar]\njoint = \"main\"\n", "")
        .replace(
            "[cycle]",
            "[body.foot]\nmass = \"0.1 kg\"\ninertia = \"1e-5 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
             points = { pin = [\"0 mm\", \"0 mm\"] }\n\
             [joint.far]\nkind = \"revolute\"\nbearing = \"bar.tip\"\njournal = \"foot.pin\"\n\
             [joint.guide]\nkind = \"prismatic\"\nguide = { point = \"ground.o\", angle = \"0 deg\" }\nslider = \"foot.pin\"\n\
             [assembly]\nguess = { bar = \"0 deg\" }\n[cycle]",
        );
    let due_pa = DENSITY_KG_M3 * AREA_M2 * 9.81 * LENGTH_M * LENGTH_M / 8.0 / MODULUS_M3;
    demand(&text, due_pa, 1e-5);
}

/// In motion: the stress of a stiff coupler with play comes to that of the rigid one as 1/E until the first contact.
#[test]
fn identity_stress_of_a_stiff_link_is_that_of_the_rigid_one() {
    let largest = |modulus: &str| {
        let text = case_text("flexible_four_bar")
            .replace("duration = \"20 ms\"", "duration = \"1 ms\"")
            .replace("radial_clearance = \"0.2 mm\"", "radial_clearance = \"0 mm\"")
            .replace(
                "lateral_shapes = 3\naxial_shapes = 2",
                "lateral_shapes = 1\naxial_shapes = 1\nstart = \"settled\"",
            )
            .replace("youngs_modulus = \"207 GPa\"\ndensity", &format!("youngs_modulus = \"{modulus}\"\ndensity"))
            + "\n[output.stress]\nstress_in = \"coupler\"\n";
        let record = record(&text);
        let stress = record.outputs.iter().find(|history| history.name == "stress").expect("an output");
        let most = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        most(&stress.deviation_si) / most(&stress.ideal_si)
    };
    let apart = ["2070 GPa", "207000 GPa"].map(largest);
    assert!(apart[0] < 0.05 && apart[0] / apart[1] > 50.0, "{apart:?}");
}

/// What has no stress is refused where it is asked for.
#[test]
fn messages_of_stress_that_cannot_be_computed() {
    let said = |text: &str| Model::from_text("model.toml", text).expect_err("it is refused").to_string();
    let blade = file("flexible_spin_up.toml");
    let found = said(&format!("{blade}\n[output.stress]\nstress_in = \"blade\"\n"));
    assert!(
        found.contains(
            "the section of body 'blade' is given by area and second moment, but the stress needs its height"
        ),
        "{found}"
    );
    let found = said(&format!("{blade}\n[output.stress]\nstress_in = \"hub\"\n"));
    assert!(found.contains("body 'hub' is rigid; stress is computed along flexible bodies"), "{found}");
    let built = build(&bar("9.81 m/s^2", &held(0.0), [2, 1], ""));
    assert_eq!(built.mechanism.stressed.len(), 1);
}
