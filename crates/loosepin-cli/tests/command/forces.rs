//! What stands beside contact forces, and what is said of physics that nobody builds.

use super::command_line::Desk;

/// A folder with a template.
fn template(name: &str) -> Desk {
    let desk = Desk::new();
    desk.succeed(&["new", name, "."]);
    desk
}

fn change(desk: &Desk, file: &str, from: &str, to: &str) {
    let text = std::fs::read_to_string(desk.path(file)).expect("the file is there");
    assert!(text.contains(from), "{from:?} stands in {file}");
    desk.write(file, &text.replace(from, to));
}

/// The output as one line, so that sentences are found wherever they are broken.
fn one_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

const LIST: &str = "\"contact.steel_pin.law\" = { any_of = [\"lankarani-nikravesh\", \"johnson\"] }";

#[test]
fn a_press_names_the_law_of_its_force_and_what_a_line_contact_gives() {
    let desk = template("toggle-press");
    let of_points = desk.succeed(&["check", "model.toml"]).output;
    assert!(
        of_points.ends_with(&format!(
            "\nThe force in ram_pin is by lankarani-nikravesh, a point contact: it uses no bearing length.\n\
             A long pin is a line contact, whose peak force may be twice as large. To use both in a study:\n  \
             [joint.ram_pin] of the model: bearing_length = \"...\"\n  \
             [epistemic] of the study: {LIST}\n"
        )),
        "{of_points}"
    );
    change(&desk, "model.toml", "contact = \"steel_pin\"\n", "contact = \"steel_pin\"\nbearing_length = \"40 mm\"\n");
    let told = one_line(&desk.succeed(&["simulate", "model.toml", "--all"]).output);
    for sentence in [
        "Contact forces in ram_pin are those of lankarani-nikravesh (point contact, the bearing's length of 40 mm does not enter). The \
         stated restitution of 0.7 acts as 0.796 in a free impact; valid for impacts up to 0.052 m/s (18.2 % are faster). As a line \
         contact over 40 mm the same impact energy gives about 30 kN (johnson).",
        "In ram_pin the parts penetrate each other by up to 15.6 % of the clearance; contact laws hold up to about a tenth. Force and deviation depend on the law: compare with another one.",
    ] {
        assert!(told.contains(sentence), "{told}");
    }
    // The law of a long pin where none is named, with nothing to warn of; the list has nothing to add.
    change(&desk, "model.toml", "law = \"lankarani-nikravesh\"\n", "");
    let unnamed = desk.succeed(&["check", "model.toml"]).output;
    assert!(
        unnamed.contains("contact 'steel_pin': johnson by default, energy loss of lankarani-nikravesh"),
        "{unnamed}"
    );
    assert!(!unnamed.contains("a point contact"), "{unnamed}");
    let told = one_line(&desk.succeed(&["simulate", "model.toml", "--all"]).output);
    assert!(
        told.contains("Contact forces in ram_pin are those of johnson by default (line contact over 40 mm)."),
        "{told}"
    );
    assert!(!told.contains("more than a tenth"), "{told}");
}

#[test]
fn a_study_of_a_force_is_offered_the_list_of_laws_until_it_has_it() {
    let desk = template("toggle-press");
    change(&desk, "model.toml", "contact = \"steel_pin\"\n", "contact = \"steel_pin\"\nbearing_length = \"40 mm\"\n");
    let (asks, force) = (
        "[[ask]]   ",
        "[[ask]]\noutput = \"pin_force\"\nof = \"value\"\nreduce = \"maximum\"\nstatistics = [\"mean\"]\n",
    );
    let study = std::fs::read_to_string(desk.path("study.toml")).expect("the study is there");
    let (before, _) = study.split_once(asks).expect("it asks something");
    desk.write(
        "study.toml",
        &format!("{before}{force}").replace("inner = 256", "inner = 8").replace("outer = 16", "outer = 3"),
    );
    let offered = desk.succeed(&["check", "study.toml"]).output;
    assert!(offered.contains(&format!("  [epistemic] of the study: {LIST}\n")), "{offered}");
    let told = one_line(&desk.succeed(&["study", "study.toml", "--all"]).output);
    assert!(
        told.contains(
            "Contact forces in ram_pin are those of lankarani-nikravesh (point contact, the bearing's length"
        ),
        "{told}"
    );
    assert!(told.contains("of the clearance; contact laws hold up to about a tenth."), "{told}");
    change(&desk, "study.toml", "[[ask]]", &format!("[epistemic]\n{LIST}\n[[ask]]"));
    change(&desk, "study.toml", "[epistemic]   ", "[unused]   ");
    let study = std::fs::read_to_string(desk.path("study.toml")).expect("the study is there");
    let kept: Vec<&str> =
        study.lines().filter(|line| !line.starts_with("[unused]") && !line.contains("radial_clearance")).collect();
    desk.write("study.toml", &kept.join("\n"));
    let both = desk.succeed(&["check", "study.toml"]).output;
    assert!(!both.contains("of the study:"), "{both}");
    let told = one_line(&desk.succeed(&["study", "study.toml", "--force", "--all"]).output);
    assert!(
        told.contains(
            "(point contact, the bearing's length of 40 mm does not enter) and johnson (line contact over 40 mm)."
        ),
        "{told}"
    );
}

#[test]
fn a_least_impact_speed_that_no_contact_reaches_is_told() {
    let desk = template("slider-crank");
    let told =
        desk.succeed(&["simulate", "model.toml", "--set", "contact.steel_pin.minimum_impact_speed=10 m/s"]).output;
    let told = one_line(&told);
    assert!(
        told.contains("In gudgeon no contact began faster than the minimum impact speed of 10 m/s (the fastest at ")
            && told.contains("which lose less energy, and none is counted. Use a lower minimum_impact_speed."),
        "{told}"
    );
}

#[test]
fn a_clearance_that_may_be_below_zero_is_refused_or_told() {
    let with = |clearance: &str| {
        let desk = template("slider-crank");
        let old = "\"joint.gudgeon.radial_clearance\" = { interval = [\"0.1 mm\", \"0.5 mm\"] }\n";
        change(&desk, "study.toml", old, "");
        let rod = "\"parameter.rod_length\" =";
        change(&desk, "study.toml", rod, &format!("\"joint.gudgeon.radial_clearance\" = {{ {clearance} }}\n{rod}"));
        desk.run(&["check", "study.toml"])
    };
    let limits = with("tolerance = \"0.05 ± 0.06 mm\"");
    assert_eq!(limits.status, 2);
    assert_eq!(
        limits.messages,
        "study.toml:17:50: error[E0501]: 'joint.gudgeon.radial_clearance' reaches -0.01 mm, which is impossible: joint 'gudgeon': \
         radial clearance -0.01 mm; must be >= 0\nhint: the radial clearance is radius of the hole minus radius of the pin\n"
    );
    // Φ(-10/3) = 4.3e-4.
    let tail = with("normal = { mean = \"0.1 mm\", standard_deviation = \"0.03 mm\" }");
    assert_eq!(tail.status, 0);
    assert!(
        tail.messages.starts_with(
            "study.toml:17:36: warning[E0606]: 'joint.gudgeon.radial_clearance' is impossible with a probability of 4.3e-4, and such \
             runs fail: "
        ),
        "{}",
        tail.messages
    );
    assert_eq!(with("normal = { mean = \"0.1 mm\", standard_deviation = \"0.02 mm\" }").messages, "");
}

#[test]
fn a_quantile_that_the_samples_do_not_reach_is_told() {
    let desk = template("slider-crank");
    change(&desk, "study.toml", "{ quantile = 0.975 }", "{ quantile = 0.999 }");
    change(&desk, "study.toml", "inner = 256", "inner = 64");
    let said = desk.succeed(&["check", "study.toml"]).messages;
    assert!(
        said.contains(
            "warning[E0608]: the 99.9 % quantile needs more samples: with a probability of 94 %, none of inner = 64 samples lies beyond it, and its bound will have no end\nhint: inner = 8192 bounds it from both sides"
        ),
        "{said}"
    );
}

#[test]
fn links_that_close_only_the_other_way_round_are_named() {
    let desk = Desk::new();
    desk.write(
        "model.toml",
        r#"name = "ram on two guides"
gravity = "0 m/s^2"
[body.ground]
points = { o = ["0 mm", "0 mm"], above = ["0 mm", "30 mm"] }
[body.ram]
mass = "1 kg"
inertia = "1e-3 kg m^2"
centre_of_mass = ["0 mm", "0 mm"]
points = { low = ["0 mm", "0 mm"], high = ["0 mm", "30 mm"] }
[joint.way]
kind = "prismatic"
guide = { point = "ground.o", angle = "0 deg" }
slider = "ram.low"
[joint.rail]
kind = "prismatic"
guide = { point = "ground.above", angle = "180 deg" }
slider = "ram.high"
[drive.feed]
joint = "way"
motion = { kind = "harmonic", mean = "0 mm", amplitude = "5 mm", frequency = "1 Hz" }
[cycle]
duration = "1 s"
samples_per_turn = 10
"#,
    );
    desk.fail(
        &["check", "model.toml"],
        "model.toml:14:8: error[E0704]: the links close at the start only with 'ground' and 'ram' turned by 180 deg against each other \
         in joint 'rail'\n\
         hint: its line points in the opposite direction: change the angle of its guide or slider by 180 deg",
    );
}

#[test]
fn a_drive_too_slow_for_contacts_and_a_dead_point_within_the_clearances_are_told_as_that() {
    let desk = template("slider-crank");
    let slow = desk.run(&["simulate", "model.toml", "--set", "drive.crank.speed=1e-6 rpm"]);
    assert!(
        slow.messages.ends_with(
            "hint: the drive is so slow that contacts, which last microseconds, are shorter than 1e-14 of a turn: use a higher speed, or `loosepin motion`, which needs no dynamics\n"
        ),
        "{}",
        slow.messages
    );
    let singular = desk.run(&["simulate", "model.toml", "--set", "parameter.rod_length=50 mm"]);
    assert!(
        singular.messages.contains(
            "error[E0705]: singular position at 3 ms, drive 'crank' at 90 deg: the drives no longer determine the motion\n\
             hint: the links can be assembled in two ways there"
        ),
        "{}",
        singular.messages
    );
    // Near the change point the play lets the links pass to their other way of assembling.
    let passed = desk.succeed(&["simulate", "model.toml", "--set", "parameter.rod_length=50.01 mm"]).output;
    let passed = one_line(&passed);
    assert!(!passed.contains("This run is wrong"), "{passed}");
    assert!(
        passed.contains("The slider deviates by -100.6 mm with crank at ")
            && passed.contains("in this assembly of the links. Either a dead point lies within the clearances"),
        "{passed}"
    );
}
