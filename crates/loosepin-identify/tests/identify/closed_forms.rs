//! Sets that are known in closed form: one joint, several in one loop, two loops.

use super::{answer, known, study};

/// What the ends may be off by, as a share of the width of the exact set.
const OF_THE_WIDTH: f64 = 0.01;
/// Crank, rod of the first slider and rod of the second one, m.
const CRANK_M: f64 = 0.043;
const ROD_M: f64 = 0.127;
const SECOND_ROD_M: f64 = 0.111;
/// Abscissa of the second guide, which stands upright, m.
const SECOND_GUIDE_M: f64 = 0.058;
/// Stiffness of the contacts, N/m^1.5, and the push, N.
const STIFFNESS_N_M1_5: f64 = 4.7e10;
const FORCE_N: f64 = 22.0;

/// A slider-crank whose slider carries a second rod to a slider in an upright guide; play at the pins that `plays` names.
fn model(plays: &[&str]) -> String {
    let joint = |name: &str, bearing: &str, journal: &str| {
        let play = if plays.contains(&name) {
            "bearing_radius = \"8 mm\"\nradial_clearance = \"0.1 mm\"\ncontact = \"pin\"\n"
        } else {
            ""
        };
        format!("[joint.{name}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"\n{play}\n")
    };
    let body = |name: &str, points: &str| {
        format!(
            "[body.{name}]\nmass = \"0.2 kg\"\ninertia = \"1e-4 kg m^2\"\ncentre_of_mass = [\"3 mm\", \"2 mm\"]\npoints = {{ {points} }}\n\n"
        )
    };
    let pins = [
        ("main", "ground.o", "crank.main"),
        ("crank_pin", "crank.pin", "rod.tail"),
        ("gudgeon", "rod.head", "slider.pin"),
        ("link", "slider.pin", "second_rod.tail"),
        ("upper", "second_rod.head", "second.pin"),
    ];
    let mut text = format!(
        "name = \"two sliders\"\ngravity = \"9.81 m/s^2\"\n\n[body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"], side = [\"{} mm\", \"0 mm\"] }}\n\n",
        SECOND_GUIDE_M * 1e3
    );
    text.push_str(&body("crank", &format!("main = [\"0 mm\", \"0 mm\"], pin = [\"{} mm\", \"0 mm\"]", CRANK_M * 1e3)));
    text.push_str(&body("rod", &format!("tail = [\"0 mm\", \"0 mm\"], head = [\"{} mm\", \"0 mm\"]", ROD_M * 1e3)));
    text.push_str(&body("slider", "pin = [\"0 mm\", \"0 mm\"]"));
    text.push_str(&body(
        "second_rod",
        &format!("tail = [\"0 mm\", \"0 mm\"], head = [\"{} mm\", \"0 mm\"]", SECOND_ROD_M * 1e3),
    ));
    text.push_str(&body("second", "pin = [\"0 mm\", \"0 mm\"]"));
    text.push_str(&format!(
        "[contact.pin]\nlaw = \"flores\"\nrestitution = 0.8\nstiffness = \"{STIFFNESS_N_M1_5} N/m^1.5\"\nexponent = 1.5\n\n"
    ));
    for (name, bearing, journal) in pins {
        text.push_str(&joint(name, bearing, journal));
    }
    text.push_str(
        "[joint.guide]\nkind = \"prismatic\"\nguide = { point = \"ground.o\", angle = \"0 deg\" }\nslider = \"slider.pin\"\n\n\
         [joint.upright]\nkind = \"prismatic\"\nguide = { point = \"ground.side\", angle = \"90 deg\" }\n\
         slider = { point = \"second.pin\", angle = \"90 deg\" }\n\n\
         [drive.crank]\njoint = \"main\"\nspeed = \"300 rpm\"\nstart_angle = \"20 deg\"\n\n\
         [assembly]\nguess = { rod = \"-5 deg\", second_rod = \"140 deg\" }\n\n\
         [cycle]\ndrive = \"crank\"\ntransient_turns = 1\nrecorded_turns = 1\nsamples_per_turn = 60\n\n\
         [output.slider]\nposition_of = \"slider.pin\"\nalong = \"x\"\n\n[output.second]\nposition_of = \"second.pin\"\nalong = \"y\"\n",
    );
    text
}

/// A study with plays from 0.01 to 0.4 mm.
fn study_text(plays: &[&str], readings: &str) -> String {
    let inputs: Vec<String> = plays
        .iter()
        .map(|play| format!("\"joint.{play}.radial_clearance\" = {{ interval = [\"0.01 mm\", \"0.4 mm\"] }}\n"))
        .collect();
    format!(
        "name = \"closed forms\"\nmodel = \"model.toml\"\n\n[epistemic]\n{}\n[[ask]]\noutput = \"slider\"\nof = \"clearance\"\n\
         reduce = \"rms\"\nstatistics = [\"mean\"]\n\n{readings}",
        inputs.concat()
    )
}

fn reading(output: &str, angle_deg: f64, travel_m: f64, error_m: f64) -> String {
    format!(
        "[[measured]]\noutput = \"{output}\"\npose = {{ crank = \"{angle_deg} deg\" }}\nforce = \"{FORCE_N} N\"\n\
         dead_travel = \"{travel_m:e} m\"\nerror = \"± {error_m:e} m\"\n\n"
    )
}

/// x of the first slider whose rod is longer by `longer_m`: the pins of a pushed rod lie in one line with it.
fn slider_m(angle: f64, longer_m: f64) -> f64 {
    let (height, length) = (CRANK_M * angle.sin(), ROD_M + longer_m);
    CRANK_M * angle.cos() + (length * length - height * height).sqrt()
}

/// Dead travel of the first slider where the plays of its pins and what they give way by sum to `sum_m`.
fn first_travel_m(angle: f64, sum_m: f64) -> f64 {
    slider_m(angle, sum_m) - slider_m(angle, -sum_m)
}

/// y of the second slider where the pins of the first loop let its rod be longer by `first_m` and its own by `own_m`.
fn second_m(angle: f64, first_m: f64, own_m: f64) -> f64 {
    let (across, length) = (slider_m(angle, first_m) - SECOND_GUIDE_M, SECOND_ROD_M + own_m);
    (length * length - across * across).sqrt()
}

/// Dead travel of the second slider. It stands left of the first one: pushed up, its rod is long and the first slider near.
fn second_travel_m(angle: f64, first_m: f64, own_m: f64) -> f64 {
    second_m(angle, -first_m, own_m) - second_m(angle, first_m, -own_m)
}

/// How far a contact gives way: K δ^1.5 = N.
fn yield_m(force_n: f64) -> f64 {
    (force_n / STIFFNESS_N_M1_5).powf(2.0 / 3.0)
}

/// The x from 0 to 2 mm at which the growing `f` is `value`.
fn inverse(value: f64, f: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (0.0, 2e-3);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if f(middle) < value { low = middle } else { high = middle }
    }
    low
}

fn assert_near(found: [f64; 2], exact: [f64; 2]) {
    let allowed = OF_THE_WIDTH * (exact[1] - exact[0]);
    let off = [found[0] - exact[0], found[1] - exact[1]];
    assert!(off.iter().all(|off| off.abs() <= allowed), "{found:?} {exact:?}: off by {off:?} of {allowed}");
    assert!(off[0] <= 1e-13 && off[1] >= -1e-13, "the set is not cut: {off:?}");
}

#[test]
fn analytic_play_of_one_joint() {
    for (angle_deg, play_m, error_m) in [(25.0, 1.7e-4, 3e-6), (77.0, 0.4e-4, 2e-6), (131.0, 3.1e-4, 8e-6)] {
        let angle = f64::to_radians(angle_deg);
        // The rod carries the push over the cosine of its obliquity.
        let gives_m = yield_m(FORCE_N / (1.0 - (CRANK_M / ROD_M * angle.sin()).powi(2)).sqrt());
        let travel_m = first_travel_m(angle, play_m + gives_m) + 0.3 * error_m;
        let plays = ["gudgeon"];
        let study = study(&model(&plays), &study_text(&plays, &reading("slider", angle_deg, travel_m, error_m)));
        let specimen = answer(&study);
        let known = known(&specimen);
        let exact =
            [-1.0, 1.0].map(|sign| inverse(travel_m + sign * error_m, |sum_m| first_travel_m(angle, sum_m)) - gives_m);
        assert_near(known.plays[0].after_si, exact);
        assert!(known.plays[0].is_identifiable && known.alike.is_empty());
        assert!(known.combinations.len() == 1 && known.combinations[0].weights == [1.0]);
    }
}

#[test]
fn analytic_plays_of_one_loop_have_equal_factors_and_only_their_sum_is_fixed() {
    let plays = ["crank_pin", "gudgeon"];
    // Two angles: more readings of this kind do not tell them apart.
    let (angles_deg, sum_m, error_m) = ([38.0, 104.0], 4.4e-4, 4e-6);
    let gives_m = |angle: f64| 2.0 * yield_m(FORCE_N / (1.0 - (CRANK_M / ROD_M * angle.sin()).powi(2)).sqrt());
    let travels_m = angles_deg.map(|deg: f64| first_travel_m(deg.to_radians(), sum_m + gives_m(deg.to_radians())));
    let readings = [0, 1].map(|k| {
        let text = reading("slider", angles_deg[k], travels_m[k], error_m);
        text.replace("output =", &format!("instrument = \"gauge {k}\"\noutput ="))
    });
    let specimen = answer(&study(&model(&plays), &study_text(&plays, &readings.concat())));
    let known = known(&specimen);
    for reading in &specimen.readings {
        let [first, second] = [0, 1].map(|play| reading.factors[play][1]);
        assert!((second / first - 1.0).abs() < 1e-9, "{:?}", reading.factors);
    }
    assert_eq!(known.alike, [[0, 1]]);
    assert_eq!(known.combinations.len(), 1);
    assert_eq!(known.combinations[0].weights, [1.0; 2]);
    let exact = |k: usize, sign: f64| {
        let angle = angles_deg[k].to_radians();
        inverse(travels_m[k] + sign * error_m, |sum_m| first_travel_m(angle, sum_m)) - gives_m(angle)
    };
    let sums = [f64::max(exact(0, -1.0), exact(1, -1.0)), f64::min(exact(0, 1.0), exact(1, 1.0))];
    assert_near(known.combinations[0].after_si, sums);
    for play in &known.plays {
        assert!(!play.is_identifiable);
        // What the sum leaves where the other one is as small, or as large, as it can be.
        let ends = [f64::max(sums[0] - 0.4e-3, 0.01e-3), f64::min(sums[1] - 0.01e-3, 0.4e-3)];
        let allowed = OF_THE_WIDTH * (sums[1] - sums[0]);
        let off = [play.after_si[0] - ends[0], play.after_si[1] - ends[1]];
        assert!(off.iter().all(|off| off.abs() < allowed), "{play:?} {ends:?}");
    }
}

#[test]
fn analytic_plays_of_two_loops() {
    let plays = ["gudgeon", "upper"];
    let (angle_deg, first_m, own_m) = (62.0_f64, 1.3e-4, 2.2e-4);
    let angle = angle_deg.to_radians();
    let errors_m = [3e-6, 5e-6];
    // Loads by virtual work, from the slopes of the closed forms.
    let slope = |f: &dyn Fn(f64) -> f64| (f(1e-6) - f(-1e-6)) / 2e-6;
    let gives_first_m = yield_m(FORCE_N * slope(&|x| slider_m(angle, x)).abs());
    let [gives_through_m, gives_own_m] = [
        yield_m(FORCE_N * slope(&|x| second_m(angle, x, 0.0)).abs()),
        yield_m(FORCE_N * slope(&|x| second_m(angle, 0.0, x)).abs()),
    ];
    assert!(slope(&|x| second_m(angle, x, 0.0)) < 0.0, "the first slider stands right of the upright guide");
    let travels_m = [
        first_travel_m(angle, first_m + gives_first_m) - 0.4 * errors_m[0],
        second_travel_m(angle, first_m + gives_through_m, own_m + gives_own_m) + 0.5 * errors_m[1],
    ];
    let readings = [
        reading("slider", angle_deg, travels_m[0], errors_m[0]),
        reading("second", angle_deg, travels_m[1], errors_m[1]),
    ];
    let specimen = answer(&study(&model(&plays), &study_text(&plays, &readings.concat())));
    let known = known(&specimen);
    let firsts = [-1.0, 1.0]
        .map(|sign| inverse(travels_m[0] + sign * errors_m[0], |sum_m| first_travel_m(angle, sum_m)) - gives_first_m);
    assert_near(known.plays[0].after_si, firsts);
    let owns = [(-1.0, firsts[1]), (1.0, firsts[0])].map(|(sign, first_m)| {
        let travel_m = |own_m: f64| second_travel_m(angle, first_m + gives_through_m, own_m);
        inverse(travels_m[1] + sign * errors_m[1], travel_m) - gives_own_m
    });
    assert_near(known.plays[1].after_si, owns);
    assert!(known.plays.iter().all(|play| play.is_identifiable));
}

#[test]
fn analytic_common_errors_do_not_shrink_with_repeats_and_independent_ones_do() {
    let plays = ["gudgeon"];
    let travel_m = first_travel_m(0.9, 2e-4);
    let width = |repeats: usize, lines: &str| {
        let mut text = reading("slider", f64::to_degrees(0.9), travel_m, 0.0);
        text = text.replace("error = \"± 0e0 m\"", &format!("repeats = {repeats}\n{lines}"));
        let specimen = answer(&study(&model(&plays), &study_text(&plays, &text)));
        let [low, high] = known(&specimen).plays[0].after_si;
        high - low
    };
    let (common, scatter) = ("error = \"4 um\"", "scatter = \"2 um\"");
    assert!((width(1, common) / width(25, common) - 1.0).abs() < 1e-9, "calibration stays");
    assert!((width(1, scatter) / width(25, scatter) / 5.0 - 1.0).abs() < 1e-3, "scatter goes with the root");
    let both = width(25, &format!("{common}\n{scatter}"));
    assert!((both / (width(1, common) + width(25, scatter)) - 1.0).abs() < 1e-3, "{both}");
}

#[test]
fn analytic_a_guide_whose_corners_give_way_unevenly_tilts() {
    let (half_length_m, lever_m, far_m, play_m, error_m) = (0.05, 0.045, 0.07, 1.4e-4, 1e-6);
    let model = model(&[])
        .replace("points = { pin = [\"0 mm\", \"0 mm\"] }\n\n[body.second_rod]", &format!(
            "points = {{ pin = [\"0 mm\", \"0 mm\"], side = [\"{} mm\", \"0 mm\"], far = [\"{} mm\", \"0 mm\"] }}\n\n[body.second_rod]",
            lever_m * 1e3,
            far_m * 1e3
        ))
        .replace(
            "slider = \"slider.pin\"\n",
            "slider = \"slider.pin\"\nhalf_length = \"50 mm\"\nhalf_height = \"20 mm\"\nclearance = \"0.1 mm\"\n\
             contact = \"pin\"\n",
        );
    let model = format!("{model}\n[output.far]\nposition_of = \"slider.far\"\nalong = \"y\"\n");
    // Pushed across at the lever p: N_1 + N_2 = F and a (N_1 - N_2) = F p at the corners of one face.
    let corner_m = [1.0, -1.0].map(|sign| yield_m(0.5 * FORCE_N * (1.0 + sign * lever_m / half_length_m)));
    let gives_m = (corner_m[0] + corner_m[1]) + far_m / half_length_m * (corner_m[0] - corner_m[1]);
    assert!(
        gives_m > 2.2 * yield_m(FORCE_N),
        "further than if one corner carried all of it and the block stayed upright"
    );
    let text = reading("far", 25.0, 2.0 * play_m + gives_m, error_m)
        .replace("force =", "at = \"slider.side\"\ndirection = \"90 deg\"\nforce =");
    let text = study_text(&["guide"], &text).replace("guide.radial_clearance", "guide.clearance");
    let specimen = answer(&study(&model, &text));
    let [least, most] = specimen.readings[0].compliance_si;
    assert!(least <= gives_m && gives_m <= most, "{gives_m} {least} {most}");
    // Not beyond one corner that carries all of it, over the longer lever.
    let widest = 2.0 * far_m / half_length_m * yield_m(FORCE_N);
    assert!(most <= 1.001 * widest, "{most} {widest}");
    let [low, high] = known(&specimen).plays[0].after_si;
    assert!(low <= play_m && play_m <= high, "{low} {high}");
}
