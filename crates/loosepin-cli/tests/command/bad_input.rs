//! Bad input: the message, its place, and exit status 2, word for word.

use std::fs;

use super::command_line::{Desk, Said, case_text};

/// Messages of `check`, `simulate` and `motion` on a model of a case with one text of it replaced.
fn bad_model(case: &str, from: &str, to: &str, messages: &str) {
    let text = case_text(case, "model.toml");
    assert_eq!(text.matches(from).count(), 1, "{from:?} stands once in the model");
    let desk = Desk::new();
    desk.write("model.toml", &text.replace(from, to));
    for command in ["check", "simulate", "motion"] {
        desk.fail(&[command, "model.toml"], messages);
    }
    assert!(!desk.path("results").exists(), "nothing is left behind");
}

/// Messages of `check`, `study` and `motion` on the study of the worn pin with one text replaced.
fn bad_study(from: &str, to: &str, messages: &str) {
    let desk = Desk::with_model("slider_crank_worn_pin");
    let text = case_text("slider_crank_worn_pin", "study.toml");
    assert_eq!(text.matches(from).count(), 1, "{from:?} stands once in the study");
    desk.write("study.toml", &text.replace(from, to));
    for command in ["check", "study", "motion"] {
        desk.fail(&[command, "study.toml"], messages);
    }
    assert!(!desk.path("results").exists(), "nothing is left behind");
}

#[test]
fn an_unknown_key() {
    bad_model(
        "slider_crank_5000",
        "density = \"7800 kg/m^3\"",
        "densty = \"7800 kg/m^3\"",
        "model.toml:34:1: error[E0201]: contact 'steel_pin' has no key 'densty'\nhint: did you mean 'density'?",
    );
}

#[test]
fn a_number_that_is_hardly_possible_is_warned_of_beside_the_answer() {
    let text = case_text("slider_crank_5000", "model.toml");
    let desk = Desk::new();
    desk.write("model.toml", &text.replace("density = \"7800 kg/m^3\"", "density = \"7.8 kg/m^3\""));
    for command in ["check", "simulate", "motion"] {
        let said = desk.succeed(&[command, "model.toml"]).messages;
        assert_eq!(
            said.matches("warning[E0823]: contact 'steel_pin': density 7.8 kg/m^3; usual values are").count(),
            1,
            "{said}"
        );
    }
}

#[test]
fn a_tolerance_in_a_model_shows_the_line_of_the_study() {
    bad_model(
        "slider_crank_5000",
        "rod_length = \"120 mm\"",
        "rod_length = \"120 mm +- 0.1 mm\"",
        "model.toml:6:22: error[E0301]: '+-' gives a tolerance; a single value is expected here\n\
         hint: a model holds nominal values: write \"120 mm\" here, and in study.toml under [random] \"parameter.rod_length\" = { tolerance = \"± 0.1 mm\" }",
    );
    let desk = Desk::with_model("slider_crank_5000");
    for command in ["simulate", "motion"] {
        desk.fail(
            &[command, "model.toml", "--set", "parameter.rod_length=120 mm +- 0.1 mm"],
            "--set:1:29: error[E0301]: '+-' gives a tolerance; a single value is expected here\n\
             hint: a model holds nominal values: write \"120 mm\" here, and in study.toml under [random] \"parameter.rod_length\" = { tolerance = \"± 0.1 mm\" }",
        );
    }
}

#[test]
fn a_value_that_is_set_and_hardly_possible_is_warned_of() {
    let desk = Desk::with_model("slider_crank_5000");
    for command in ["simulate", "motion"] {
        let said = desk.succeed(&[command, "model.toml", "--set", "contact.steel_pin.density=7.8 kg/m^3"]).messages;
        assert_eq!(
            said.matches("--set:1:1: warning[E0823]: contact 'steel_pin': density 7.8 kg/m^3; usual values are")
                .count(),
            1,
            "{said}"
        );
    }
}

#[test]
fn a_missing_unit() {
    bad_model(
        "slider_crank_5000",
        "radial_clearance = \"0.5 mm\"",
        "radial_clearance = 0.5",
        "model.toml:51:20: error[E0303]: joint 'gudgeon': radial clearance is 0.5 without a unit; must be a length\n\
         hint: write the unit, for example \"0.5 mm\" or \"0.5 m\"",
    );
}

#[test]
fn a_wrong_dimension() {
    bad_model(
        "slider_crank_5000",
        "radial_clearance = \"0.5 mm\"",
        "radial_clearance = \"0.5 ms\"",
        "model.toml:51:20: error[E0304]: joint 'gudgeon': radial clearance is a time; must be a length\n\
         hint: for example \"0.5 mm\"",
    );
}

#[test]
fn an_inertia_of_zero_or_below() {
    for (written, shown) in [("0 kg m^2", "0 kg m^2"), ("-2.5e-4 kg m^2", "-0.00025 kg m^2")] {
        bad_model(
            "slider_crank_5000",
            "inertia = \"2.5e-4 kg m^2\"",
            &format!("inertia = \"{written}\""),
            &format!("model.toml:19:11: error[E0501]: body 'rod': inertia {shown}; must be > 0"),
        );
    }
}

#[test]
fn a_restitution_outside_its_range() {
    for value in ["1.2", "-0.1"] {
        bad_model(
            "slider_crank_5000",
            "restitution = 0.9",
            &format!("restitution = {value}"),
            &format!(
                "model.toml:31:15: error[E0501]: contact 'steel_pin': restitution {value}; must be in (0, 1]\n\
                 hint: a restitution of 90 % is 0.9; with 1 an impact loses no energy, with 0 it would end at rest"
            ),
        );
    }
}

#[test]
fn a_clearance_below_zero_or_above_the_bearing_radius() {
    let written = "radial_clearance = \"0.5 mm\"";
    bad_model(
        "slider_crank_5000",
        written,
        "radial_clearance = \"-0.05 mm\"",
        "model.toml:51:20: error[E0501]: joint 'gudgeon': radial clearance -0.05 mm; must be >= 0\n\
         hint: the radial clearance is radius of the hole minus radius of the pin",
    );
    bad_model(
        "slider_crank_5000",
        written,
        "radial_clearance = \"11 mm\"",
        "model.toml:51:20: error[E0502]: joint 'gudgeon': radial clearance 11 mm; must be below joint 'gudgeon': bearing \
         radius 10 mm\n\
         model.toml:50:18: note: it must be below this\n\
         hint: the radial clearance is radius of the hole minus radius of the pin",
    );
}

/// Of the rocker's pin from where the coupler would have it, at 0.6 rad: 240 mm less the distance from the crank's pin to the rocker's pivot,
/// √(80² + 300² - 2·80·300·cos 0.6) mm = 238.2937 mm.
#[test]
fn links_that_cannot_close() {
    bad_model(
        "four_bar_600",
        "rocker_length = \"180 mm\"",
        "rocker_length = \"20 mm\"",
        "model.toml:59:8: error[E0704]: the links cannot close at the start, drive 'crank' at 34.37747 deg: joint 'rocker_pivot' \
         stays 1.706294 mm open at best, from 48 positions tried, all with 'rocker' at 94 deg as guessed\n\
         hint: check the lengths and the start angle; if the loop does close, a guess may be wrong: correct it, or remove it",
    );
}

#[test]
fn links_that_close_at_the_start_and_not_all_the_way_round() {
    let desk = Desk::new();
    let text = case_text("slider_crank_5000", "model.toml");
    desk.write("model.toml", &text.replace("rod_length = \"120 mm\"", "rod_length = \"30 mm\""));
    for command in ["check", "simulate"] {
        let said = desk.run(&[command, "model.toml"]);
        assert_eq!((said.status, said.output.as_str()), (2, ""));
        let (first, second) = said.messages.trim_end().split_once('\n').expect("two lines");
        // The rod points straight down at sin(a) = 30/50, a = 36.87°: after 1.229 ms at 5000 rpm.
        assert!(first.starts_with("model.toml:54:8: error[E0704]: the links cannot close at 1.2"), "{first}");
        assert!(
            first.ends_with(" mm open")
                && first.contains(" ms, drive 'crank' at 3")
                && first.contains(" deg: joint 'guide' stays 0."),
            "{first}"
        );
        assert_eq!(second, "hint: the lengths do not permit a whole turn; check them, or drive another joint");
    }
    assert!(!desk.path("results").exists(), "nothing is left behind");
    // Without dynamics the part of the turn that can be reached is an answer.
    desk.succeed(&["motion", "model.toml"]);
}

#[test]
fn analytic_each_command_says_the_least_gap_of_links_that_do_not_close_all_the_way_round() {
    let desk = Desk::new();
    desk.succeed(&["new", "four-bar", "m"]);
    let model = std::fs::read_to_string(desk.path("m/model.toml")).unwrap();
    desk.write("m/model.toml", &model.replace("crank_length = \"80 mm\"", "crank_length = \"150 mm\""));
    for arguments in
        [["check", "m/model.toml"], ["simulate", "m/model.toml"], ["check", "m/study.toml"], ["study", "m/study.toml"]]
    {
        let said = desk.run(&arguments);
        assert_eq!(said.status, 2, "{arguments:?}: {}", said.messages);
        let line =
            said.messages.lines().find(|line| line.contains("E0704")).unwrap_or_else(|| panic!("{}", said.messages));
        assert!(line.starts_with("m/model.toml:62:8: error[E0704]: the links cannot close"), "{line}");
        let number = |before: &str, behind: &str| -> f64 {
            let rest = line.split_once(before).unwrap_or_else(|| panic!("{line}")).1;
            rest.split_once(behind).unwrap_or_else(|| panic!("{line}")).0.parse().unwrap()
        };
        let angle_rad = number("drive 'crank' at ", " deg: joint 'rocker_pivot' stays ").to_radians();
        // Coupler and rocker reach over 440 mm: what the crank's pin is further from the rocker's pivot is open.
        let distance_mm = (150.0_f64.powi(2) + 300.0_f64.powi(2) - 2.0 * 150.0 * 300.0 * angle_rad.cos()).sqrt();
        let gap_mm = number("stays ", " mm open");
        // The angle has four decimals of a degree.
        assert!(gap_mm > 0.0 && (gap_mm - (distance_mm - 440.0)).abs() < 1e-4, "{line}: {}", distance_mm - 440.0);
        // The values of the study have no part in it.
        assert!(!said.messages.contains("radial_clearance"), "{}", said.messages);
    }
}

#[test]
fn drives_that_are_too_few_or_too_many() {
    bad_model(
        "slider_crank_5000",
        "[joint.guide]\nkind = \"prismatic\"\nguide = { point = \"ground.o\", angle = \"0 deg\" }\nslider = \"slider.pin\"\n",
        "",
        "model.toml:17:7: error[E0701]: the mechanism has 3 degrees of freedom and 1 drive: the motions of 'rod' and \
         'slider' are not determined\n\
         model.toml:23:7: note: this can move too\n\
         hint: add a drive, or a joint that stops the free motion; a motion that only forces determine needs its start under [initial]",
    );
    bad_model(
        "slider_crank_5000",
        "[drive.crank]\n",
        "[drive.rod]\njoint = \"crank_pin\"\nspeed = \"3 rpm\"\nstart_angle = \"0 deg\"\n\n[drive.crank]\n",
        "model.toml:64:8: error[E0702]: the mechanism has 1 degree of freedom and 2 drives: the drives contradict each other\n\
         model.toml:59:8: note: this is driven too\n\
         hint: remove a drive",
    );
}

/// A pendulum beside the slider-crank of the case, and a second drive in the loop of the crank.
fn with_pendulum(start_angle: &str) -> String {
    let pendulum = "[body.bob]\nmass = \"0.2 kg\"\ninertia = \"1e-4 kg m^2\"\ncentre_of_mass = [\"20 mm\", \"0 mm\"]\n\
                    points = { o = [\"0 mm\", \"0 mm\"], tip = [\"40 mm\", \"0 mm\"] }\n\n\
                    [joint.hang]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"bob.o\"\n\n";
    let drive = format!("[drive.rod]\njoint = \"crank_pin\"\nspeed = \"3 rpm\"\nstart_angle = \"{start_angle}\"\n\n");
    case_text("slider_crank_5000", "model.toml")
        .replace("[drive.crank]\n", &format!("{pendulum}{drive}[drive.crank]\n"))
}

#[test]
fn two_drives_on_one_freedom_are_named_whether_the_loop_closes_or_not() {
    // At 0 deg the loop closes by chance, and at -20 deg it does not.
    for start_angle in ["0 deg", "-20 deg"] {
        let desk = Desk::new();
        desk.write("model.toml", &with_pendulum(start_angle));
        desk.fail(
            &["check", "model.toml"],
            "model.toml:75:8: error[E0710]: the drives 'rod' and 'crank' move the same degree of freedom: one of them already determines the position of the links\n\
             model.toml:70:8: note: this moves the same freedom\n\
             hint: keep one of them, and use the other for a joint with another degree of freedom",
        );
    }
    // The second freedom driven as well: nothing to report.
    let desk = Desk::new();
    desk.write("model.toml", &with_pendulum("0 deg").replace("joint = \"crank_pin\"", "joint = \"hang\""));
    desk.succeed(&["check", "model.toml"]);
}

#[test]
fn joints_that_hold_one_another_are_named_with_the_whole_loop() {
    let pinned = "[joint.extra]\nkind = \"revolute\"\nbearing = \"ground.fixed\"\njournal = \"rod.small_end\"\n\n[drive.crank]\n";
    let text = case_text("slider_crank_5000", "model.toml").replace("[drive.crank]\n", pinned);
    // The rod's end is pinned where it is at the start, or elsewhere.
    for place in ["[\"170 mm\", \"0 mm\"]", "[\"100 mm\", \"30 mm\"]"] {
        let desk = Desk::new();
        let points = format!("points = {{ o = [\"0 mm\", \"0 mm\"], fixed = {place} }}");
        desk.write("model.toml", &text.replace("points = { o = [\"0 mm\", \"0 mm\"] }", &points));
        let said = desk.run(&["check", "model.toml"]);
        assert_eq!(said.status, 2, "{}", said.messages);
        let first = said.messages.lines().next().unwrap_or_default();
        assert_eq!(
            first,
            "model.toml:59:8: error[E0711]: the joints 'main', 'crank_pin', 'gudgeon', 'guide' and 'extra' block one another: with general lengths, their bodies cannot move"
        );
    }
}

#[test]
fn a_study_that_names_a_study_as_its_model() {
    let desk = Desk::with_model("slider_crank_worn_pin");
    let text = case_text("slider_crank_worn_pin", "study.toml");
    desk.write("study.toml", &text.replace("model = \"model.toml\"", "model = \"study.toml\""));
    desk.fail(
        &["check", "study.toml"],
        "study.toml:2:9: error[E0905]: model is 'study.toml', this study itself; must be a file with bodies and joints\n\
         hint: for example model = \"model.toml\"",
    );
    desk.write("other.toml", &text.replace("model = \"model.toml\"", "model = \"study.toml\""));
    desk.fail(
        &["check", "other.toml"],
        "other.toml:2:9: error[E0905]: model is 'study.toml', another study; must be a file with bodies and joints\n\
         hint: for example model = \"model.toml\"",
    );
}

#[test]
fn a_drawing_that_is_not_there() {
    let desk = Desk::new();
    desk.write("crane.dxf", "");
    desk.fail(
        &["import", "krane.dxf"],
        "error[E0101]: cannot read krane.dxf: there is no such file\nhint: did you mean 'crane.dxf'?",
    );
}

#[test]
fn round_off_is_shown_as_zero() {
    let desk = Desk::new();
    let output = "[output.across]\nposition_of = \"slider.pin\"\nalong = \"y\"\n";
    let text = case_text("slider_crank_5000", "model.toml");
    desk.write("model.toml", &format!("{text}\n{output}"));
    let said = desk.succeed(&["simulate", "model.toml", "--out", "run"]).output;
    // The deviation across the guide is the last digits of loops that are closed to 1e-14 of the size of the mechanism.
    let summary: serde_json::Value = serde_json::from_str(&desk.read("run/summary.json")).expect("JSON");
    let extremes = summary["extremes"].as_array().expect("a list");
    let is_deviation = |extreme: &&serde_json::Value| extreme["name"] == "across" && extreme["of"] == "total";
    let across = extremes.iter().find(is_deviation).expect("the deviation");
    let largest_m = across["maximum"]["value_si"].as_f64().expect("a number");
    assert!(largest_m > 0.0 && largest_m < 2e-15, "{largest_m:e}");
    let line = said.lines().find(|line| line.starts_with("across, deviation ")).expect("the deviation in the table");
    assert_eq!(line.matches(" 0 mm ").count(), 2, "{line}");
    assert!(!said.contains('∞') && !said.contains("The across has the largest share"), "{said}");
}

#[test]
fn a_singular_position_on_the_way() {
    let desk = Desk::new();
    // A rod as long as the crank is upright at 90° and can fall to either side: 10° after the start, in 1/3 ms.
    let text = case_text("slider_crank_5000", "model.toml");
    let text = text.replace("rod_length = \"120 mm\"", "rod_length = \"50 mm\"");
    desk.write("model.toml", &text.replace("start_angle = \"0 deg\"", "start_angle = \"80 deg\""));
    let said = desk.run(&["check", "model.toml"]);
    assert_eq!((said.status, said.output.as_str()), (2, ""));
    let (first, hint) = said.messages.trim_end().split_once('\n').expect("two lines");
    assert!(first.starts_with("model.toml:59:8: error[E0705]: singular position at 0.33333"), "{first}");
    assert!(first.ends_with(" ms, drive 'crank' at 90 deg: the drives no longer determine the motion"), "{first}");
    assert_eq!(
        hint,
        "hint: the links can be assembled in two ways there: change a length, keep the drive away from this position, or drive another joint"
    );
    assert!(desk.succeed(&["motion", "model.toml"]).output.contains("\nSingular at 90° of crank: "));
}

#[test]
fn a_loop_in_which_every_joint_is_driven() {
    let play = "bearing_radius = \"8 mm\"\nradial_clearance = \"0.2 mm\"\ncontact = \"steel_pin\"\n";
    let text = case_text("four_bar_600", "model.toml");
    assert!(text.contains(play));
    let drives: String = ["crank_pin", "coupler_pin", "rocker_pivot"]
        .map(|joint| format!("[drive.{joint}]\njoint = \"{joint}\"\nspeed = \"7 rpm\"\nstart_angle = \"1 rad\"\n\n"))
        .concat();
    let desk = Desk::new();
    desk.write("model.toml", &text.replace(play, "").replace("[assembly]\n", &format!("{drives}[assembly]\n")));
    desk.fail(
        &["check", "model.toml"],
        "model.toml:34:10: warning[E0408]: contact 'steel_pin' is not used\n\
         hint: changing it has no effect on the results\n\
         model.toml:56:8: error[E0703]: joint 'rocker_pivot' closes a loop in which every joint is driven\n\
         hint: remove one of the drives of this loop",
    );
}

#[test]
fn a_tolerance_below_round_off() {
    let desk = Desk::with_model("slider_crank_5000");
    let said = desk.run(&["simulate", "model.toml", "--tolerance", "1e-30 m"]);
    assert_eq!(said.status, 2);
    assert!(said.messages.starts_with("error[E0802]: at "), "{}", said.messages);
    assert!(said.messages.ends_with(
        "hint: look for a stiffness, mass or inertia far from those of a real part, or a tolerance below round-off\n"
    ));
}

#[test]
fn a_drive_that_stands_still() {
    let desk = Desk::new();
    let text = case_text("slider_crank_5000", "model.toml");
    desk.write("model.toml", &text.replace("speed = \"5000 rpm\"", "speed = \"0 rpm\""));
    let hint = "hint: give it a speed, or use another drive in [cycle]";
    for (command, what) in [
        ("check", "so its turns cannot be counted"),
        ("simulate", "so its turns cannot be counted"),
        ("motion", "so it has no cycle"),
    ] {
        desk.fail(
            &[command, "model.toml"],
            &format!("model.toml:61:9: error[E0801]: drive 'crank' has speed zero, {what}\n{hint}"),
        );
    }
}

#[test]
fn an_interval_turned_round() {
    bad_study(
        "interval = [\"0.1 mm\", \"0.5 mm\"]",
        "interval = [\"0.5 mm\", \"0.1 mm\"]",
        "study.toml:22:49: error[E0601]: epistemic 'joint.gudgeon.radial_clearance': interval goes from 0.5 mm to 0.1 mm; the lower end must be first\n\
         hint: write [\"0.1 mm\", \"0.5 mm\"]",
    );
}

#[test]
fn a_path_of_nothing_and_a_model_that_is_not_there() {
    bad_study(
        "\"parameter.rod_length\"",
        "\"parameter.rodlength\"",
        "study.toml:18:1: error[E0405]: the model has no quantity 'parameter.rodlength'\n\
         hint: did you mean 'parameter.rod_length'?",
    );
    bad_study(
        "model = \"model.toml\"",
        "model = \"modle.toml\"",
        "study.toml:2:9: error[E0101]: cannot read modle.toml: there is no such file\n\
         hint: did you mean 'model.toml'?",
    );
}

#[test]
fn runs_that_do_not_split_into_replicates() {
    let desk = Desk::with_model("slider_crank_worn_pin");
    let text = case_text("slider_crank_worn_pin", "study.toml").replace("inner = 256 ", "inner = 255 ");
    desk.write("study.toml", &text);
    for command in ["check", "study"] {
        desk.fail(
            &[command, "study.toml"],
            "study.toml:12:9: error[E0611]: inner 255; must be a multiple of the 4 replicates, at least 2 runs in each, at \
             most 2^31\n\
             hint: 4 times a power of two is best",
        );
    }
}

#[test]
fn an_error_in_the_model_of_a_study_is_placed_in_the_model() {
    let desk = Desk::new();
    desk.write("study.toml", &case_text("slider_crank_worn_pin", "study.toml"));
    let text = case_text("slider_crank_worn_pin", "model.toml");
    desk.write("model.toml", &text.replace("law = \"lankarani-nikravesh\"", "law = \"lankarani\""));
    let said = desk.run(&["study", "study.toml"]);
    assert_eq!(said.status, 2);
    assert!(
        said.messages.starts_with("model.toml:30:7: error[E0204]: contact 'steel_pin': law is 'lankarani'; must be ")
    );
}

#[test]
fn files_that_cannot_be_read() {
    let desk = Desk::with_model("slider_crank_5000");
    fs::create_dir(desk.path("folder")).expect("writable");
    fs::create_dir(desk.path("full")).expect("writable");
    for name in ["full/study.toml", "full/notes.txt", "full/model.toml"] {
        desk.write(name, "");
    }
    fs::write(desk.path("latin.toml"), b"name = \"gro\xdf\"\n").expect("writable");
    desk.write("empty.toml", "");
    desk.write("big.toml", &" ".repeat(2_000_000));
    for command in ["check", "simulate", "motion", "study"] {
        desk.fail(&[command, "nothing.toml"], "error[E0101]: cannot read nothing.toml: there is no such file");
        desk.fail(&[command, "folder"], "error[E0101]: cannot read folder: it is a folder");
        desk.fail(
            &[command, "full"],
            "error[E0101]: cannot read full: it is a folder\nhint: name a file in it: model.toml or study.toml",
        );
        desk.fail(
            &[command, "latin.toml"],
            "latin.toml:1:12: error[E0102]: the file is not UTF-8 text from this position on\nhint: save the file as UTF-8",
        );
        desk.fail(&[command, "big.toml"], "error[E0103]: big.toml has 2000000 bytes; must be at most 1048576");
        desk.fail(
            &[command, "empty.toml"],
            "empty.toml:1:1: error[E0905]: the file is empty: neither a model nor a study\n\
             hint: `loosepin new slider-crank` writes an example of both",
        );
    }
}

#[test]
fn one_bad_file_does_not_keep_the_others_from_being_checked() {
    let desk = Desk::with_model("slider_crank_5000");
    let said = desk.run(&["check", "nothing.toml", "model.toml"]);
    assert_eq!(said.status, 2);
    assert_eq!(said.messages, "error[E0101]: cannot read nothing.toml: there is no such file\n");
    assert!(said.output.starts_with("model.toml: slider-crank at 5000 rpm, play in the gudgeon\n"));
}

#[test]
fn a_model_where_a_study_is_due_and_the_other_way_round() {
    let desk = Desk::with_model("slider_crank_worn_pin");
    desk.write("study.toml", &case_text("slider_crank_worn_pin", "study.toml"));
    desk.fail(
        &["simulate", "study.toml"],
        "study.toml:1:1: error[E0905]: this is a study; expected a model\nhint: its model is model.toml",
    );
    desk.fail(
        &["study", "model.toml"],
        "model.toml:1:1: error[E0905]: this is a model; expected a study\n\
         hint: a study names its model with the key `model`; for a single run use `loosepin simulate`",
    );
}

#[test]
fn settings_are_reported_with_the_column_in_their_text() {
    let desk = Desk::with_model("slider_crank_5000");
    for (settings, messages) in [
        (
            &["joint.gudgeon.radial_clearence=0.3mm"][..],
            "--set:1:1: error[E0405]: the model has no quantity 'joint.gudgeon.radial_clearence'\n\
             hint: did you mean 'joint.gudgeon.radial_clearance'?",
        ),
        (
            &["joint.gudgeon.radial_clearance"],
            "--set:1:1: error[E0407]: 'joint.gudgeon.radial_clearance' is not written path=value\n\
             hint: for example --set joint.gudgeon.radial_clearance=0.3mm",
        ),
        (
            &["joint.gudgeon.radial_clearance=0.3"],
            "--set:1:32: error[E0303]: joint.gudgeon.radial_clearance is 0.3 without a unit; must be a length\n\
             hint: for example 0.5 mm",
        ),
        (
            &["joint.gudgeon.radial_clearance=0.3 mmm"],
            "--set:1:36: error[E0302]: 'mmm' is not a known unit\nhint: did you mean 'mm'?",
        ),
        (
            &["joint.gudgeon.radial_clearance=20mm"],
            "--set:1:1: error[E0502]: joint 'gudgeon': radial clearance 20 mm; must be below joint 'gudgeon': bearing radius \
             10 mm\n\
             hint: the radial clearance is radius of the hole minus radius of the pin",
        ),
        (
            &["body.crank.points.pin.x=3mm"],
            "--set:1:1: error[E0406]: 'body.crank.points.pin.x' is given by an expression and cannot be set\n\
             hint: it depends on 'parameter.crank_length'",
        ),
        (
            &["gravity=0m/s^2", "gravity=1m/s^2"],
            "--set:1:1: error[E0409]: 'gravity' is set a second time\n--set (the earlier one):1:1: note: set here",
        ),
        (
            &["gravty=0m/s^2", "body.crank.mass=0kg"],
            "--set:1:1: error[E0405]: the model has no quantity 'gravty'\n\
             hint: did you mean 'gravity'?\n\
             --set:1:17: error[E0501]: body 'crank': mass 0 kg; must be > 0",
        ),
    ] {
        for command in ["simulate", "motion"] {
            let mut arguments = vec![command, "model.toml"];
            settings.iter().for_each(|setting| arguments.extend(["--set", setting]));
            desk.fail(&arguments, messages);
        }
    }
}

#[test]
fn a_setting_that_breaks_what_follows_from_it_is_shown_with_it() {
    let desk = Desk::with_model("four_bar_600");
    desk.fail(
        &["simulate", "model.toml", "--set", "parameter.rocker_mass=-1kg"],
        "--set:1:1: error[E0501]: body 'rocker': mass -1 kg; must be > 0\n\
         model.toml:29:8: note: which gives this its value",
    );
}

#[test]
fn arguments_outside_their_range() {
    let desk = Desk::with_model("slider_crank_5000");
    for (tolerance, messages) in [
        (
            "1e-9",
            "--tolerance:1:1: error[E0303]: --tolerance is 1e-9 without a unit; must be a length\nhint: for example 0.5 mm",
        ),
        ("-1mm", "--tolerance:1:1: error[E0501]: --tolerance is -1 mm; must be > 0"),
        ("1 s", "--tolerance:1:1: error[E0304]: --tolerance is a time; must be a length\nhint: for example 0.5 mm"),
    ] {
        desk.fail(&["simulate", "model.toml", "--tolerance", tolerance], messages);
    }
    for (flag, value, reason) in [
        ("--turns <N>", "0", "must be a number in (0, 1e6]"),
        ("--turns <N>", "two", "must be a number in (0, 1e6]"),
        ("--transient <N>", "-1", "must be a number in [0, 1e6]"),
        ("--samples <N>", "0", "0 is not in 1..=1000000"),
        ("--lyapunov <N>", "19", "19 is not in 20..=1000000"),
    ] {
        let name = flag.split(' ').next().expect("a name");
        desk.fail(
            &["simulate", "model.toml", name, value],
            &format!("error: invalid value '{value}' for '{flag}': {reason}\n\nFor more information, try '--help'."),
        );
    }
}

#[test]
fn a_motion_without_neighbours() {
    let desk = Desk::with_model("slider_crank_5000");
    let no_play = "joint.gudgeon.radial_clearance=0mm";
    desk.fail(
        &["simulate", "model.toml", "--lyapunov", "20", "--set", no_play],
        "error[E0812]: the drives alone determine the motion: no neighbouring motion exists, so there is no Lyapunov exponent\n\
         hint: omit --lyapunov, or give a joint some play",
    );
}

#[test]
fn more_rows_than_a_history_can_hold() {
    let desk = Desk::with_model("slider_crank_5000");
    desk.fail(
        &["simulate", "model.toml", "--turns", "1e6", "--samples", "1000000"],
        "model.toml:67:2: error[E0208]: 1000000000000 rows would be recorded; must be at most 1000000\n\
         hint: use fewer turns or fewer samples per turn",
    );
}

#[test]
fn commands_that_do_not_exist() {
    let desk = Desk::new();
    desk.fail(
        &["simulat", "model.toml"],
        "error: unrecognized subcommand 'simulat'\n\n  tip: a similar subcommand exists: 'simulate'\n\n\
         Usage: loosepin <COMMAND>\n\nFor more information, try '--help'.",
    );
}

#[test]
fn an_initial_state_of_what_the_drives_move() {
    bad_model(
        "slider_crank_5000",
        "[assembly]\n",
        "[initial.body.crank]\nangle = \"0 deg\"\n\n[assembly]\n",
        "model.toml:64:2: error[E0706]: the drives determine the motion, so there is no initial state to give under [initial]\n\
         hint: remove [initial], or a drive",
    );
}

#[test]
fn numbers_have_the_digits_that_tell_them_from_their_limit() {
    let desk = Desk::new();
    let text = case_text("slider_crank_worn_pin", "model.toml");
    desk.write("model.toml", &text.replace("\nrestitution = 0.8", "\nrestitution = 1.0000001"));
    desk.fail(
        &["check", "model.toml"],
        "model.toml:31:15: error[E0501]: contact 'steel_pin': restitution 1.0000001; must be in (0, 1]\n\
         hint: a restitution of 90 % is 0.9; with 1 an impact loses no energy, with 0 it would end at rest",
    );
    bad_study(
        "[\"0.1 mm\", \"0.5 mm\"]",
        "[\"0.500000001 mm\", \"0.5 mm\"]",
        "study.toml:22:49: error[E0601]: epistemic 'joint.gudgeon.radial_clearance': interval goes from 0.500000001 mm to 0.5 mm; the lower end must be first\nhint: write [\"0.5 mm\", \"0.500000001 mm\"]",
    );
}

#[test]
fn a_unit_that_is_not_known_is_taken_for_one_of_what_is_due() {
    let desk = Desk::new();
    let text = case_text("slider_crank_worn_pin", "model.toml");
    desk.write("model.toml", &text.replace("radial_clearance = \"0.3 mm\"", "radial_clearance = \"0.3 mn\""));
    desk.fail(
        &["check", "model.toml"],
        "model.toml:51:25: error[E0302]: 'mn' is not a known unit\nhint: did you mean 'mm'?",
    );
}

#[cfg(unix)]
#[test]
fn control_characters_do_not_reach_the_terminal() {
    const NAME: &str = "a\u{1b}[31mb.toml";
    let desk = Desk::new();
    let text = case_text("slider_crank_worn_pin", "model.toml");
    desk.write(NAME, &text);
    let said = desk.succeed(&["check", NAME]);
    assert!(said.output.starts_with("a\\u{1b}[31mb.toml: "), "{:?}", said.output.lines().next());
    let named = text.replace("name = \"slider-crank with a worn gudgeon pin\"", "name = \"a\\u001b[31mb\"");
    desk.write(NAME, &named);
    desk.fail(
        &["check", NAME],
        "a\\u{1b}[31mb.toml:1:8: error[E0203]: name contains the control character \\u{1b}, which cannot be shown\nhint: remove it",
    );
    desk.fail(&["check", "none\u{1b}.toml"], "error[E0101]: cannot read none\\u{1b}.toml: there is no such file");
}

/// Whoever closes a pipe has read enough; where there is nowhere to print to, nobody has.
#[cfg(unix)]
#[test]
fn a_closed_standard_output_is_an_error_and_a_closed_pipe_is_none() {
    let desk = Desk::with_model("slider_crank_worn_pin");
    let run = |redirection: &str| {
        let script = format!("\"$0\" check model.toml {redirection}");
        let mut shell = std::process::Command::new("sh");
        shell.args(["-c", &script, env!("CARGO_BIN_EXE_loosepin")]).current_dir(desk.path("."));
        let said: Said = shell.output().expect("a shell").into();
        (said.status, said.messages)
    };
    let closed = "error: cannot write to standard output: it is closed\n".to_owned();
    assert_eq!(run(">&-"), (2, closed.clone()));
    assert_eq!(run("--help >&-"), (2, closed));
    assert_eq!(run("> /dev/null"), (0, String::new()));
    let piped = run("> /dev/null; { \"$0\" check model.toml; echo $? >&2; } | true");
    assert_eq!(piped, (0, "0\n".to_owned()));
}
