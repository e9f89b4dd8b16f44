//! Errors of paths against a closed form: a crank-rocker whose pins sit eccentrically, nobody knows in which direction.

use crate::silent::{run, run_on};
use loosepin::model::Model;
use loosepin::study::result::{PathError, StudyResult};
use loosepin::study::{InputFile, Study, study_inputs};
use std::sync::atomic::AtomicBool;

const MODEL: &str = r#"
name = "crank-rocker with eccentric pins"
gravity = "0 m/s^2"

[parameter]
crank_direction = "0 deg"
rocker_direction = "0 deg"

[body.ground]
points = { o = ["0 mm", "0 mm"], pivot = ["300 mm", "0 mm"] }

[body.crank]
mass = "0.2 kg"
inertia = "1e-4 kg m^2"
centre_of_mass = ["40 mm", "0 mm"]
points = { main = ["0 mm", "0 mm"], pin = ["80 mm + 0.2 mm * cos(crank_direction)", "0.2 mm * sin(crank_direction)"] }

[body.coupler]
mass = "0.5 kg"
inertia = "2.5e-3 kg m^2"
centre_of_mass = ["130 mm", "0 mm"]
points = { tail = ["0 mm", "0 mm"], head = ["260 mm", "0 mm"], tool = ["130 mm", "90 mm"] }

[body.rocker]
mass = "0.3 kg"
inertia = "1e-3 kg m^2"
centre_of_mass = ["90 mm", "0 mm"]
points = { pivot = ["0 mm", "0 mm"], pin = ["180 mm + 0.3 mm * cos(rocker_direction)", "0.3 mm * sin(rocker_direction)"] }

[joint.main]
kind = "revolute"
bearing = "ground.o"
journal = "crank.main"

[joint.crank_pin]
kind = "revolute"
bearing = "crank.pin"
journal = "coupler.tail"

[joint.rocker_pin]
kind = "revolute"
bearing = "coupler.head"
journal = "rocker.pin"

[joint.rocker_pivot]
kind = "revolute"
bearing = "ground.pivot"
journal = "rocker.pivot"

[drive.crank]
joint = "main"
speed = "60 rpm"
start_angle = "0 deg"

[assembly]
guess = { rocker = "110 deg" }

[cycle]
drive = "crank"
transient_turns = 0
recorded_turns = 1
samples_per_turn = 36

[output.tool]
path_of = "coupler.tool"
"#;

const STUDY: &str = r#"
name = "eccentric pins"
model = "model.toml"

[sampling]
outer = 96

[epistemic]
"parameter.crank_direction" = { periodic = ["0 deg", "360 deg"] }
"parameter.rocker_direction" = { periodic = ["0 deg", "360 deg"] }
"#;

/// A direction of each eccentricity, rad.
type Directions = [f64; 2];

/// The tool over the angle of the crank with two eccentricities, m: two circles about the ends of the coupler.
fn tool_m(angle: f64, eccentricities_m: [f64; 2], [crank, rocker]: Directions) -> [f64; 2] {
    let pin = [0.08 + eccentricities_m[0] * crank.cos(), eccentricities_m[0] * crank.sin()];
    let (sine, cosine) = angle.sin_cos();
    let tail = [pin[0] * cosine - pin[1] * sine, pin[0] * sine + pin[1] * cosine];
    let radius = (0.18 + eccentricities_m[1] * rocker.cos()).hypot(eccentricities_m[1] * rocker.sin());
    let to_pivot = [0.3 - tail[0], -tail[1]];
    let distance = to_pivot[0].hypot(to_pivot[1]);
    // Law of cosines at the tail; the rocker's pin lies above the line to the pivot.
    let share = (distance * distance + 0.26 * 0.26 - radius * radius) / (2.0 * distance * 0.26);
    let direction = to_pivot[1].atan2(to_pivot[0]) + share.acos();
    let (sine, cosine) = direction.sin_cos();
    [tail[0] + 0.13 * cosine - 0.09 * sine, tail[1] + 0.13 * sine + 0.09 * cosine]
}

/// A part of the error at an angle of the crank, m. The distance from the path is found by sections of the path, not by its curvature.
fn error_m(part: PathError, angle: f64, directions: Directions) -> f64 {
    const ECCENTRICITIES_M: [f64; 2] = [2e-4, 3e-4];
    // The drawing has unknown values in the middle of their ranges.
    let ideal = |angle: f64| tool_m(angle, ECCENTRICITIES_M, [std::f64::consts::PI; 2]);
    let actual = tool_m(angle, ECCENTRICITIES_M, directions);
    let from = |at: [f64; 2]| [actual[0] - at[0], actual[1] - at[1]];
    let tangent = |angle: f64| {
        let (behind, ahead) = (ideal(angle - 1e-5), ideal(angle + 1e-5));
        let along = [ahead[0] - behind[0], ahead[1] - behind[1]];
        along.map(|part| part / along[0].hypot(along[1]))
    };
    let (e, t) = (from(ideal(angle)), tangent(angle));
    match part {
        PathError::Along => e[0] * t[0] + e[1] * t[1],
        PathError::Normal => t[0] * e[1] - t[1] * e[0],
        PathError::Magnitude => e[0].hypot(e[1]),
        PathError::Contour => {
            // Where the distance from the path is square to it.
            let beside = |angle: f64| {
                let (e, t) = (from(ideal(angle)), tangent(angle));
                e[0] * t[0] + e[1] * t[1]
            };
            let (mut low, mut high) = (angle - 0.05, angle + 0.05);
            for _ in 0..50 {
                let middle = 0.5 * (low + high);
                if beside(middle) > 0.0 { low = middle } else { high = middle }
            }
            let (e, t) = (from(ideal(low)), tangent(low));
            t[0] * e[1] - t[1] * e[0]
        }
    }
}

/// The largest magnitude of a part over the turn, m.
fn worst_m(part: PathError, directions: Directions) -> f64 {
    const LOOKS: u32 = 48;
    let of = |angle: f64| error_m(part, angle, directions).abs();
    let angle = |k: u32| std::f64::consts::TAU * f64::from(k) / f64::from(LOOKS);
    let mut top = (0..LOOKS).map(angle).max_by(|a, b| of(*a).total_cmp(&of(*b))).expect("an angle");
    let (mut most, mut step) = (of(top), angle(1));
    while step > 1e-5 {
        let beside = [top - step, top + step].map(|place| (place, of(place)));
        match beside.into_iter().find(|(_, value)| *value > most) {
            Some(better) => (top, most) = better,
            None => step *= 0.5,
        }
    }
    most
}

/// The least and the largest value over all directions.
fn extremes(of: impl Fn(Directions) -> f64) -> [f64; 2] {
    const LOOKS: u32 = 18;
    let direction = |k: u32| std::f64::consts::TAU * f64::from(k) / f64::from(LOOKS);
    [-1.0, 1.0].map(|sign| {
        let of = |place: Directions| sign * of(place);
        let places = (0..LOOKS).flat_map(|i| (0..LOOKS).map(move |j| [direction(i), direction(j)]));
        let all: Vec<(Directions, f64)> = places.map(|place| (place, of(place))).collect();
        let (mut place, mut most) = all.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).expect("a place");
        let mut step = direction(1);
        while step > 1e-4 {
            let [x, y] = place;
            // The eight neighbours: along a ridge those on the axes are lower.
            let moves =
                [[-1.0, 0.0], [1.0, 0.0], [0.0, -1.0], [0.0, 1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]];
            let beside = moves.map(|[a, b]| [x + a * step, y + b * step]).map(|place| (place, of(place)));
            match beside.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, value)| *value > most) {
                Some(better) => (place, most) = better,
                None => step *= 0.5,
            }
        }
        sign * most
    })
}

/// The study with these questions, or what is wrong with them.
fn read(model: &str, asks: &str) -> Result<Study, String> {
    let model = Model::from_text("model.toml", model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    Study::from_text("study.toml", &format!("{STUDY}{asks}"), model).map_err(|diagnostics| diagnostics.to_string())
}

fn conducted(asks: &str) -> StudyResult {
    conduct_study(&read(MODEL, asks).unwrap_or_else(|diagnostics| panic!("{diagnostics}")))
}

fn conduct_study(study: &Study) -> StudyResult {
    run(study).result
}

#[test]
fn analytic_bounds_of_path_errors_hold_what_eccentric_pins_can_do() {
    // Tables of the ideal motion err by 1e-9 m; the contour error leaves out the change of the curvature along 0.7 mm, half as much.
    const TABLES_M: f64 = 2e-9;
    let ask = |place: &str| {
        let of_part = |part: PathError| {
            let component = part.word();
            format!(
                "[[ask]]\noutput = \"tool\"\ncomponent = \"{component}\"\nof = \"dimensional\"\n{place}\nstatistics = [\"mean\"]\n"
            )
        };
        PathError::ALL.map(of_part).concat()
    };
    let result = conducted(&(ask("reduce = \"maximum_absolute\"") + &ask("poses = { crank = [\"60 deg\"] }")));
    for part in PathError::ALL {
        let own: Vec<_> = result.bounds.iter().filter(|own| own.output == format!("tool {}", part.word())).collect();
        let [whole, pose] = own[..] else { panic!("two bounds were asked for: {own:?}") };
        let of_pose = extremes(|directions| error_m(part, 60_f64.to_radians(), directions));
        for (bound, exact) in [(whole, extremes(|directions| worst_m(part, directions))), (pose, of_pose)] {
            let [lower, upper] = [&bound.lower, &bound.upper];
            let attained = [lower.value_si, upper.value_si];
            let beyond = [exact[0] - lower.widened_si, upper.widened_si - exact[1]];
            println!("{part:?}: {exact:?} {attained:?} {beyond:?}");
            assert!(beyond.iter().all(|beyond| *beyond > -TABLES_M), "{part:?}: {exact:?}, {bound:?}");
            // No run is further out than what is possible.
            let outside = [exact[0] - attained[0], attained[1] - exact[1]];
            assert!(outside.iter().all(|outside| *outside < TABLES_M), "{part:?}: {exact:?}, {bound:?}");
        }
        // At one angle all parts but the magnitude, which has a cone where there is no error, are smooth: bounds are as good as exact.
        let width = of_pose[1] - of_pose[0];
        let excess = (pose.upper.widened_si - pose.lower.widened_si - width) / width;
        assert!(part == PathError::Magnitude || excess < 1e-5, "{part:?}: too wide by {excess} of the width");
    }
}

/// The tool marks a disc that turns with the crank: seen from there its error is as large as relative to the ground, but the path is
/// another one, and so are the parts along and across it.
#[test]
fn identity_an_error_is_as_large_seen_from_a_driven_body() {
    let ask = |output: &str, part: PathError| {
        let component = part.word();
        format!(
            "[[ask]]\noutput = \"{output}\"\ncomponent = \"{component}\"\nof = \"dimensional\"\n\
             poses = {{ crank = [\"60 deg\", \"200 deg\"] }}\nstatistics = [\"mean\"]\n"
        )
    };
    let asks = ["tool", "mark"].map(|output| ask(output, PathError::Magnitude) + &ask(output, PathError::Along));
    let model = format!("{MODEL}\n[output.mark]\npath_of = \"coupler.tool\"\nrelative_to = \"crank.main\"\n");
    let study = read(&model, &asks.concat()).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let result = conduct_study(&study);
    let found = |name: &str| -> Vec<[f64; 2]> {
        let own = result.bounds.iter().filter(|bound| bound.output == name);
        own.map(|bound| [bound.lower.value_si, bound.upper.value_si]).collect()
    };
    let (ground, crank) = (found("tool magnitude"), found("mark magnitude"));
    assert_eq!((ground.len(), crank.len()), (2, 2), "one bound for each pose");
    for (ground, crank) in ground.iter().flatten().zip(crank.iter().flatten()) {
        assert!((ground - crank).abs() < 1e-12, "{ground} {crank}");
    }
    let (ground, crank) = (found("tool along"), found("mark along"));
    let apart = ground.iter().flatten().zip(crank.iter().flatten()).map(|(a, b)| (a - b).abs());
    assert!(apart.fold(f64::INFINITY, f64::min) > 1e-6, "{ground:?} {crank:?}");
}

const ASK: &str =
    "[[ask]]\noutput = \"tool\"\ncomponent = \"normal\"\nof = \"total\"\nat = \"cycle\"\nstatistics = [\"mean\"]\n";

#[test]
fn a_path_is_asked_for_by_part_and_its_error_is_no_value() {
    for (written, changed, said) in [
        (
            "component = \"normal\"\n",
            "",
            "study.toml:12:10: error[E0608]: [[ask]] 1: output 'tool' is a path, but 'component' is missing\n\
             hint: add component: normal or along is the error across or along the path, magnitude the whole error, contour the distance from the path regardless of time, x or y a coordinate",
        ),
        (
            "of = \"total\"",
            "of = \"value\"",
            "study.toml:14:6: error[E0608]: [[ask]] 1: of: component 'normal' is an error from the ideal path, not a value\n\
             hint: write of = \"total\" to compare with the nominal mechanism, or of = \"clearance\" to compare with the same lengths without play",
        ),
        (
            "\"normal\"",
            "\"nromal\"",
            "study.toml:13:13: error[E0204]: [[ask]] 1: component is 'nromal'; must be \"x\", \"y\", \"along\", \"normal\", \"magnitude\" or \
             \"contour\"\nhint: did you mean \"normal\"?",
        ),
    ] {
        let diagnostics = read(MODEL, &ASK.replace(written, changed)).expect_err("a part that is not clear");
        assert_eq!(diagnostics.trim_end(), said);
    }
}

/// A rocker turns round where its pin stands still: there the path has no direction.
#[test]
fn a_path_whose_point_stands_still_has_no_direction() {
    let model = MODEL.replace("path_of = \"coupler.tool\"", "path_of = \"rocker.pin\"");
    let refused = |model: &str, ask: &str| {
        let study = read(model, ask).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        run_on(2, &study).map(|_| ()).map_err(|error| error.to_string())
    };
    // Wherever between two looks the stop lies.
    for start_deg in ["0", "0.23", "0.47", "0.7"] {
        let model = model.replace("start_angle = \"0 deg\"", &format!("start_angle = \"{start_deg} deg\""));
        let said = refused(&model, ASK).expect_err("a path without direction");
        assert!(said.starts_with("output 'tool normal': its point hardly moves after "), "{said}");
    }
    assert!(refused(&model, &ASK.replace("normal", "magnitude")).is_ok(), "a distance needs no direction");
}

/// A further point has the path of the quasi-static answer in the record of a study, and is an input of it.
#[test]
fn identity_a_further_path_is_that_of_the_motion_without_dynamics() {
    let plain = read(MODEL, ASK).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let mut study = plain.clone();
    study.add_paths(&["coupler.head".to_owned()]).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let found = conduct_study(&study).paths.expect("paths");
    let names: Vec<&str> = found.paths.iter().map(|path| path.name.as_str()).collect();
    assert_eq!(names, ["tool", "coupler.head"]);
    let file = InputFile::Study(Box::new(plain.clone()));
    let motion = file.motion_answer(&[], &["coupler.head".to_owned()], &AtomicBool::new(false)).expect("it moves");
    let due = motion.paths.iter().find(|path| path.name == "coupler.head").expect("the point");
    // The record of a motion has each degree, that of a study every second one.
    assert_eq!((found.paths[1].positions(), due.positions()), (181, 361));
    for k in 0..found.paths[1].positions() {
        let apart_m = [found.paths[1].x_m[k] - due.x_m[2 * k], found.paths[1].y_m[k] - due.y_m[2 * k]];
        assert!(apart_m.iter().all(|apart_m| apart_m.abs() < 1e-12), "{k}: {apart_m:?}");
    }
    assert_ne!(study_inputs(&study, &[], None).to_string(), study_inputs(&plain, &[], None).to_string());
    let refused = |points: &[&str]| {
        let points: Vec<String> = points.iter().map(|point| (*point).to_owned()).collect();
        plain.clone().add_paths(&points).expect_err("no such point").to_string()
    };
    assert_eq!(
        refused(&["coupler.haed"]),
        "--path:1:1: error[E0401]: --path: there is no point 'coupler.haed'\nhint: did you mean 'coupler.head'?"
    );
}
