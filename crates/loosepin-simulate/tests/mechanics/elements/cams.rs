//! Cams, and tables in files of their own.

use super::{build, file};
use loosepin_mechanics::mechanism::{IdealMotion, Mechanism, Sample};
use loosepin_mechanics::model::Model;
use loosepin_simulate::{Observer, Settings, Step, Window, run};

/// Residual of the energy account over the largest energy exchanged.
const ACCOUNT: f64 = 1e-7;
/// Round-off of millimetres from angles of a few turns, m.
const ROUND_OFF_M: f64 = 1e-14;

/// The lifter without its lever: a mechanism that follows its drive.
fn lifter(motion: &str) -> String {
    let text = file("cam_lifter.toml");
    let cut = |from: &str, to: &str, text: &str| {
        let (before, rest) = text.split_once(from).expect("it begins");
        let (_, after) = rest.split_once(to).expect("it ends");
        format!("{before}{to}{after}")
    };
    let text = cut("[body.lever]", "[joint.shaft]", &text);
    let text = cut("[joint.pin]", "[cam.lift]", &text);
    let text = cut("[spring.coil]", "[drive.shaft]", &text);
    let text = cut("[initial.body.lever]", "[cycle]", &text);
    let text = cut("[output.tip]", "lever.tip\"\n", &text).replace("lever.tip\"\n", "");
    text.replace("speed = \"240 rpm\"\nstart_angle = \"35 deg\"", motion)
        .replace("drive = \"shaft\"\ntrans", "duration = \"0.5 s\"\ntrans")
}

/// The profile meets its points, and its first two derivatives are those of the follower over time.
#[test]
fn identity_the_follower_goes_along_its_profile() {
    let motion = "motion = { kind = \"polynomial\", coefficients = [\"35 deg\", \"11 rad/s\", \"17 rad/s^2\"] }";
    let built = build(&lifter(motion));
    assert!(built.mechanism.is_ideal() && built.mechanism.degrees_of_freedom == 1);
    let sample = built.sample();
    let mut ideal = IdealMotion::new(&built.mechanism, &sample.ideal, &sample.drives).expect("it starts");
    let slot = built.mechanism.ideal.slot_of_body[2];
    let mut at = |time_s: f64| {
        ideal.move_to(time_s).expect("it moves");
        let (pose, twist) = (&ideal.kinematics().poses[slot], &ideal.kinematics().twists[slot]);
        [pose.position_m.y - 0.05, twist.linear.y, ideal.acceleration(slot).linear.y]
    };
    // The angle is 35° + 11 t + 17 t²: through the points of the first two turns.
    for (angle_deg, lift_mm) in [(80.0, 3.0), (150.0, 14.0), (300.0, 4.0), (370.0, 2.0), (510.0, 14.0), (730.0, 2.0)] {
        let turned = (angle_deg - 35.0_f64).to_radians();
        let time_s = ((11.0_f64 * 11.0 + 4.0 * 17.0 * turned).sqrt() - 11.0) / (2.0 * 17.0);
        let [lift_m, ..] = at(time_s);
        assert!((lift_m - 1e-3 * lift_mm).abs() < ROUND_OFF_M, "{angle_deg}: {lift_m}");
    }
    for time_s in [0.03, 0.11, 0.27, 0.31, 0.44] {
        let h = 1e-4;
        let [before, now, after] = [at(time_s - h), at(time_s), at(time_s + h)];
        for k in 0..2 {
            let difference = (after[k] - before[k]) / (2.0 * h);
            // Second order in the step: a third derivative of the next one, (17 + 11)³ · 14 mm, times h²/6.
            let largest = 1e-8 * if k == 0 { 1e3 } else { 1e5 } / 6.0;
            assert!((now[k + 1] - difference).abs() < largest, "{time_s}, {k}: {} {difference}", now[k + 1]);
        }
    }
}

/// Lift and angle of the cam at the ends of all steps.
struct Ends(Vec<[f64; 2]>);

impl Observer for Ends {
    fn step(&mut self, step: &mut Step<'_, '_>) {
        let dynamics = step.end();
        let slots = &dynamics.mechanism().real.slot_of_body;
        let poses = &dynamics.kinematics.poses;
        self.0.push([poses[slots[1]].angle_rad(), poses[slots[2]].position_m.y - 0.05]);
    }
}

/// A cam that is not driven but pulled by its heavy lifter, with a lever that hangs on it with play.
#[test]
fn identity_a_cam_does_no_net_work() {
    let text = file("cam_lifter.toml");
    let free = text
        .replace("[drive.shaft]\njoint = \"shaft\"\nspeed = \"240 rpm\"\nstart_angle = \"35 deg\"\n", "")
        .replace(
            "[initial.body.lever]",
            "[initial.joint.shaft]\nangle = \"35 deg\"\nangular_velocity = \"20 rad/s\"\n[initial.body.lever]",
        )
        .replace("drive = \"shaft\"\ntrans", "duration = \"0.25 s\"\ntrans");
    assert_ne!(free, text);
    for text in [text, free] {
        let built = build(&text);
        let mut ends = Ends(Vec::new());
        let window = Window { start_s: 0.0, end_s: 0.3 };
        let report = run(&built.mechanism, &built.sample(), &window, &Settings::for_simulation(), &mut ends)
            .unwrap_or_else(|failure| panic!("{failure}"));
        let account = report.energy.expect("it is integrated");
        assert!(account.relative_residual() < ACCOUNT && account.contact_loss_j > 1e-7, "{account:?}");
        assert!(report.plays[0].contacts > 2);
        let numbers = built.sample().real.couplings[0].law.clone();
        for [angle_rad, lift_m] in ends.0 {
            let due = numbers.at(angle_rad)[0];
            assert!((lift_m - due).abs() < ROUND_OFF_M, "{angle_rad}: {lift_m} {due}");
        }
    }
}

/// A folder with a model and a table.
fn folder(model: &str, table: &str) -> (tempfile::TempDir, std::path::PathBuf) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("model.toml");
    std::fs::write(&path, model).expect("it is written");
    std::fs::write(folder.path().join("profile.csv"), table).expect("it is written");
    (folder, path)
}

fn from_file() -> String {
    let text = file("cam_lifter.toml");
    let (before, rest) = text.split_once("points = [[\"10 deg\"").expect("points are there");
    let (_, after) = rest.split_once('\n').expect("a line");
    format!("{before}csv = \"profile.csv\"\n{after}")
}

const TABLE: &str =
    "\u{feff}# measured\ncam [deg], lift [mm]\r\n10,\u{a0}2\u{a0}\n80, 3\n 150 , 14\n220,11\n300,\"4\"\n\n370, 2.0e0\n";

#[test]
fn identity_a_table_in_a_file_is_the_table_in_the_model() {
    let (_kept, path) = folder(&from_file(), TABLE);
    let model = Model::from_path(&path).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    assert_eq!(model.tables().len(), 1);
    assert_eq!(model.tables()[0].text(), TABLE);
    let values = model.quantities.nominal();
    let mechanism = Mechanism::new(&model, &values).expect("it moves");
    let numbers = Sample::<f64>::new(&mechanism, &values).expect("it fits").numbers();
    assert_eq!(numbers, build(&file("cam_lifter.toml")).sample().numbers());
    // Drives read the same files.
    let drive = "motion = { kind = \"table\", ends = \"clamped\", csv = \"profile.csv\" }";
    let text = lifter(drive);
    let (_kept, path) = folder(&text, "time [s], angle [deg]\n0, 35\n0.2, 90\n0.5, 95\n");
    let inline = "motion = { kind = \"table\", ends = \"clamped\", points = [[\"0 s\", \"35 deg\"], [\"0.2 s\", \"90 deg\"], [\"0.5 s\", \"95 deg\"]] }";
    let sample = |model: Model| {
        let values = model.quantities.nominal();
        let mechanism = Mechanism::new(&model, &values).expect("it moves");
        Sample::<f64>::new(&mechanism, &values).expect("it fits").numbers()
    };
    let read = Model::from_path(&path).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    assert_eq!(sample(read), sample(build(&lifter(inline)).mechanism.model));
}

#[test]
fn what_is_wrong_with_a_table_is_told_at_its_place() {
    let said = |model: &str, table: &str| {
        let (kept, path) = folder(model, table);
        let diagnostics = Model::from_path(&path).expect_err("it is refused").to_string();
        diagnostics.replace(&format!("{}/", kept.path().display()), "")
    };
    let model = from_file();
    let of = |table: &str| said(&model, table);
    let header = "cam [deg], lift [mm]\n";
    assert_eq!(
        of("cam, lift\n1,2\n"),
        "profile.csv:1:1: error[E0411]: the header is 'cam'; must be a name with a unit in brackets\nhint: for example: time [s], angle [deg]"
    );
    assert_eq!(
        of("cam [deg], lift [N]\n1,2\n"),
        "profile.csv:1:12: error[E0411]: the column 'lift [N]' must contain a length"
    );
    assert_eq!(
        of(&format!("{header}10,2\n80;3,1\n90,x\n")),
        "profile.csv:3:1: error[E0411]: '80;3' is not a number\nhint: columns are separated by commas, and numbers have a decimal point\nprofile.csv:4:4: error[E0411]: 'x' is not a number\nhint: write numbers with a decimal point and no thousands separator, for example 0.25 or 1e-3"
    );
    assert_eq!(
        of(&format!("{header}10,2\n80,3,1\n")),
        "profile.csv:3:1: error[E0411]: a row has 3 columns; expected two\nhint: a comma separates columns; decimal numbers have a point"
    );
    assert_eq!(
        of(&format!("{header}10,2\n80,3\n70,4\n")),
        "profile.csv:4:1: error[E0502]: cam 'lift': csv 2 cam 80 deg; must be below cam 'lift': csv 3 cam 70 deg"
    );
    assert_eq!(
        of(&format!("{header}10,2\n80,3\n")),
        "profile.csv:1:1: error[E0208]: cam 'lift': csv has too few entries; it needs at least 3"
    );
    let nowhere = said(&model.replace("profile.csv", "profil.csv"), TABLE);
    assert_eq!(
        nowhere,
        "model.toml:42:7: error[E0101]: cannot read profil.csv: there is no such file\nhint: did you mean 'profile.csv'?"
    );
}
