//! Numbers that are allowed and hardly possible: each slip is warned of, and no file that is shipped is.

use std::fs;
use std::path::{Path, PathBuf};

use loosepin::model::Model;
use loosepin::space::SpatialModel;
use loosepin::study::{InputFile, Study};
use loosepin::templates::{TEMPLATES, find_template};

fn template() -> &'static str {
    find_template("slider-crank").expect("template").model
}

fn warnings(text: &str) -> Vec<String> {
    warned(&Model::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}")))
}

fn warned(model: &Model) -> Vec<String> {
    let hardly = model.warnings.iter().filter(|warning| warning.code.as_str() == "E0823");
    hardly.map(ToString::to_string).collect()
}

/// What is said of outputs that never move, beside the warnings of the file.
fn still(file: &InputFile) -> Vec<String> {
    let found = loosepin::check::warnings(file);
    assert_eq!(&found[..file.warnings().len()], file.warnings());
    found[file.warnings().len()..].iter().map(ToString::to_string).collect()
}

/// The only warning where `from` of the slider-crank template is `to`, without its place.
fn warning(from: &str, to: &str) -> String {
    assert_eq!(template().matches(from).count(), 1, "{from}");
    let said = warnings(&template().replace(from, to));
    assert_eq!(said.len(), 1, "{to}: {said:?}");
    said[0].split_once("[E0823]: ").expect("a place and a code").1.to_owned()
}

#[test]
fn units_that_are_a_thousand_times_off_are_named() {
    let modulus = "youngs_modulus = \"207 GPa\"";
    assert_eq!(
        warning(modulus, "youngs_modulus = \"207 MPa\""),
        "contact 'steel_pin': youngs modulus 0.207 GPa; usual values are 1 GPa (plastics) to 1300 GPa (diamond)\n\
         hint: did you mean \"207 GPa\" instead of \"207 MPa\"?"
    );
    assert_eq!(
        warning(modulus, "youngs_modulus = \"207e3 GPa\""),
        "contact 'steel_pin': youngs modulus 207000 GPa; usual values are 1 GPa (plastics) to 1300 GPa (diamond)\n\
         hint: did you mean \"207e3 MPa\" instead of \"207e3 GPa\"?"
    );
    assert_eq!(
        warning("poisson_ratio = 0.3", "poisson_ratio = 0.03"),
        "contact 'steel_pin': poisson ratio 0.03; usual values are 0.1 to 0.49; metals have 0.2 to 0.45\nhint: did you mean 0.3?"
    );
    let density = "density = \"7800 kg/m^3\"";
    assert_eq!(
        warning(density, "density = \"7.8 kg/m^3\""),
        "contact 'steel_pin': density 7.8 kg/m^3; usual values are 100 kg/m^3 (foams) to 23000 kg/m^3 (osmium)\n\
         hint: did you mean \"7.8 g/cm^3\" instead of \"7.8 kg/m^3\"?"
    );
    assert_eq!(
        warning(density, "density = \"7.8e6 kg/m^3\""),
        "contact 'steel_pin': density 7800000 kg/m^3; usual values are 100 kg/m^3 (foams) to 23000 kg/m^3 (osmium)\n\
         hint: did you mean \"7.8e6 g/m^3\" instead of \"7.8e6 kg/m^3\"?"
    );
    assert_eq!(
        warning("speed = \"5000 rpm\"", "speed = \"5000 rad/s\""),
        "drive 'crank': speed 47746.48 rpm; usual values are up to 19100 rpm (2000 rad/s)\n\
         hint: did you mean \"5000 rpm\" instead of \"5000 rad/s\"?"
    );
    assert_eq!(
        warning("gravity = \"9.81 m/s^2\"", "gravity = \"9810 m/s^2\""),
        "gravity 9810 m/s^2; usual values are 9.81 m/s^2 on earth, up to 100 m/s^2 elsewhere\n\
         hint: did you mean \"9810 mm/s^2\" instead of \"9810 m/s^2\"?"
    );
    assert_eq!(
        warning("gravity = \"9.81 m/s^2\"", "gravity = \"-9.81 m/s^2\""),
        "gravity -9.81 m/s^2 acts upwards: gravity is the acceleration along -y\nhint: did you mean \"9.81 m/s^2\"?"
    );
}

#[test]
fn numbers_that_were_let_through_are_named() {
    let impact = "restitution = 0.9";
    assert_eq!(
        warning(impact, "restitution = 0.9\nminimum_impact_speed = \"100 m/s\""),
        "contact 'steel_pin': minimum impact speed 100 m/s; usual values are up to 1 m/s; slower impacts lose energy as impacts of this speed do\n\
         hint: did you mean \"100 mm/s\" instead of \"100 m/s\"?"
    );
    assert_eq!(
        warning("radial_clearance = \"0.5 mm\"", "radial_clearance = \"1e-7 mm\""),
        "joint 'gudgeon': radial clearance 1e-7 mm; usual values are above 0.1 µm, or 0\n\
         hint: did you mean \"1e-7 m\" instead of \"1e-7 mm\"?"
    );
    // All bodies alike: their ratio says nothing.
    for mass in ["1e308 kg", "1e-308 kg"] {
        let mut text = template().to_owned();
        for own in template().lines().filter(|line| line.starts_with("mass = ")) {
            text = text.replace(own, &format!("mass = \"{mass}\""));
        }
        let said = warnings(&text);
        assert_eq!(said.len(), 3, "{said:?}");
        assert!(
            said.iter().all(|one| one.contains(&format!(": mass {mass}; usual values are 1e-9 kg (1 µg) to 1e7 kg"))),
            "{said:?}"
        );
    }
    for usual in ["minimum_impact_speed = \"1 mm/s\"", "minimum_impact_speed = \"0.5 m/s\""] {
        assert!(warnings(&template().replace(impact, &format!("{impact}\n{usual}"))).is_empty(), "{usual}");
    }
}

/// A pinion of 20 mm drives a wheel of 40 mm, whose crank pushes a slide; the pinion stands `apart` from the wheel.
fn geared(apart: &str, mesh: &str) -> String {
    format!(
        r#"
name = "geared pusher"
[body.ground]
points = {{ motor = ["-{apart}", "0 mm"], o = ["0 mm", "0 mm"] }}
[body.pinion]
points = {{ o = ["0 mm", "0 mm"] }}
[body.crank]
points = {{ o = ["0 mm", "0 mm"], pin = ["30 mm", "0 mm"] }}
[body.rod]
points = {{ big = ["0 mm", "0 mm"], small = ["120 mm", "0 mm"] }}
[body.slide]
points = {{ pin = ["0 mm", "0 mm"] }}
[joint.motor]
kind = "revolute"
bearing = "ground.motor"
journal = "pinion.o"
[joint.main]
kind = "revolute"
bearing = "ground.o"
journal = "crank.o"
[joint.crankpin]
kind = "revolute"
bearing = "rod.big"
journal = "crank.pin"
radial_clearance = "0.02 mm"
[joint.wrist]
kind = "revolute"
bearing = "rod.small"
journal = "slide.pin"
[joint.way]
kind = "prismatic"
guide = {{ point = "ground.o", angle = "0 deg" }}
slider = "slide.pin"
[coupling.mesh]
kind = "gears"
first = "motor"
second = "main"
mesh = "{mesh}"
radii = ["20 mm", "40 mm"]
[drive.motor]
joint = "motor"
speed = "100 rpm"
start_angle = "0 deg"
[cycle]
drive = "motor"
[output.push]
position_of = "slide.pin"
along = "x"
"#
    )
}

#[test]
fn analytic_gears_whose_pitch_circles_do_not_touch_are_named() {
    let said = warnings(&geared("90 mm", "external"));
    assert_eq!(
        said,
        [
            "model.toml:34:11: warning[E0823]: coupling 'mesh': the pitch circles do not touch: the centres are 90 mm apart; with these radii 60 mm are expected\n\
          hint: radii are those of the pitch circles in mesh: the distance is their sum, or for an internal mesh their difference"
        ]
    );
    let internal = warnings(&geared("60 mm", "internal"));
    assert!(
        internal.len() == 1 && internal[0].contains("60 mm apart; with these radii 20 mm are expected"),
        "{internal:?}"
    );
    for (apart, mesh) in [("60 mm", "external"), ("60.5 mm", "external"), ("20 mm", "internal")] {
        assert!(warnings(&geared(apart, mesh)).is_empty(), "{apart} {mesh}");
    }
    // A rattling crank does not need the radius of its bearing to move; with a contact it does.
    assert!(Model::from_text("model.toml", &geared("60 mm", "external")).is_ok());
}

#[test]
fn an_output_that_never_moves_is_named() {
    // The rod is as long as the crank: closed the other way, it turns with the crank and the slider rests on the axis of the crank.
    let closed = |rod_deg: &str| {
        let mut text = template().replace("rod_length = \"120 mm\"", "rod_length = \"50 mm\"");
        for (from, to) in [("start_angle = \"0 deg\"", "start_angle = \"30 deg\""), ("{ rod = \"0 deg\" }", rod_deg)] {
            assert_eq!(text.matches(from).count(), 1, "{from}");
            text = text.replace(from, to);
        }
        let model = Model::from_text("model.toml", &text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        still(&InputFile::Model(model.into()))
    };
    assert_eq!(
        closed("{ rod = \"210 deg\" }"),
        ["model.toml:77:9: warning[E0823]: output 'slider' never moves: its body stands still over the whole cycle\n\
          hint: the loops may be closed in another way than meant: choose it by guess under [assembly], `loosepin check` shows the ways"]
    );
    assert_eq!(closed("{ rod = \"-30 deg\" }"), Vec::<String>::new());
}

/// A crank of 50 mm and a rod as long, which pushes a slide, in space; a cover is fixed to the ground. The slide stands at `at` at the start, where
/// the rod is turned by `rod`.
fn flat_in_space(at: &str, rod: &str) -> String {
    let pin = |name: &str, bearing: &str, journal: &str| {
        format!("[joint.{name}]\nkind = \"revolute\"\nbearing = \"{bearing}\"\njournal = \"{journal}\"\n")
    };
    let zero = "[\"0 mm\", \"0 mm\", \"0 mm\"]";
    format!(
        "name = \"flat\"\ngeometry = \"space\"\n[body.ground]\npoints = {{ o = {zero} }}\n\
         [body.crank]\npoints = {{ o = {zero}, pin = [\"50 mm\", \"0 mm\", \"0 mm\"] }}\n\
         [body.rod]\npoints = {{ big = {zero}, small = [\"50 mm\", \"0 mm\", \"0 mm\"] }}\n\
         [body.slide]\npoints = {{ pin = {zero} }}\n[body.cover]\npoints = {{ o = {zero} }}\n{}{}{}\
         [joint.way]\nkind = \"prismatic\"\nbearing = \"ground.o\"\njournal = \"slide.pin\"\naxis = \"x\"\n\
         [joint.screws]\nkind = \"rigid\"\nbearing = \"ground.o\"\njournal = \"cover.o\"\n\
         [drive.crank]\njoint = \"main\"\nspeed = \"60 rpm\"\nstart_angle = \"30 deg\"\n\
         [assembly.guess]\nslide = {{ at = [\"{at}\", \"0 mm\", \"0 mm\"] }}\n\
         rod = {{ at = [\"43.3 mm\", \"25 mm\", \"0 mm\"], turned = [\"z {rod}\"] }}\n\
         [cycle]\ndrive = \"crank\"\n\
         [output.slide]\nposition_of = \"slide.pin\"\nalong = \"x\"\n[output.cover]\nturn_of = \"cover\"\nabout = \"z\"\n\
         [output.way]\npath_of = \"slide.pin\"\n[output.lean]\norientation_of = \"slide\"\n",
        pin("main", "ground.o", "crank.o"),
        pin("crankpin", "crank.pin", "rod.big"),
        pin("wrist", "rod.small", "slide.pin"),
    )
}

#[test]
fn an_output_that_never_moves_is_named_in_space_too() {
    let said = |text: &str| {
        let model = SpatialModel::from_text("model.toml", text).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        still(&InputFile::Model(model.into()))
    };
    let never = |place: &str, output: &str| {
        format!(
            "model.toml:{place}: warning[E0823]: output '{output}' never moves: its body stands still over the whole cycle\n\
             hint: the loops may be closed in another way than meant: choose it by guess under [assembly], `loosepin check` shows the ways"
        )
    };
    // Closed the other way, the rod turns with the crank and the slide rests on the axis of the crank.
    let resting = flat_in_space("0 mm", "210 deg");
    assert_eq!(said(&resting), [never("43:9", "slide"), never("49:9", "way"), never("51:9", "lean")]);
    // As it is meant it slides, and does not turn: its body moves. The cover is a part of the ground.
    assert_eq!(said(&flat_in_space("86.6 mm", "-30 deg")), Vec::<String>::new());
    // A body that can turn alone is not held still.
    let hinge = "[body.flap]\npoints = { o = [\"0 mm\", \"0 mm\", \"0 mm\"] }\n[output.flap]\nturn_of = \"flap\"\nabout = \"z\"\n\
                 [joint.hinge]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"flap.o\"\n";
    let named = said(&(resting.clone() + hinge));
    assert!(named.len() == 3 && named.iter().all(|warning| !warning.contains("flap")), "{named:?}");
    // Without a cycle nothing is known, nor where a second loop is left without a drive.
    let between = |from: &str, to: &str| {
        let rest = resting.split_once(from).expect("its beginning").1;
        format!("{from}{}", rest.split_once(to).expect("its end").0)
    };
    let mut second = between("[body.crank]", "[body.cover]") + &between("[joint.main]", "[joint.screws]");
    for name in ["body.crank", "body.rod", "body.slide", "joint.main", "joint.crankpin", "joint.wrist", "joint.way"] {
        second = second.replace(&format!("[{name}]"), &format!("[{name}_2]"));
    }
    for body in ["crank", "rod", "slide"] {
        second = second.replace(&format!("\"{body}."), &format!("\"{body}_2."));
    }
    let undriven = format!("{resting}{second}[output.second]\nposition_of = \"slide_2.pin\"\nalong = \"x\"\n");
    for unknown in [resting.replace("[cycle]\ndrive = \"crank\"\n", ""), undriven] {
        assert_ne!(unknown, resting);
        assert_eq!(said(&unknown), Vec::<String>::new());
    }
}

#[test]
fn values_that_are_set_are_warned_of_like_those_of_the_file() {
    let model = Model::from_text("model.toml", template()).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let set = |texts: &[&str]| {
        let texts: Vec<String> = texts.iter().map(|text| (*text).to_owned()).collect();
        let set = model.set_values(&texts).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        set.warnings().iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    assert_eq!(
        set(&["contact.steel_pin.youngs_modulus=207 MPa"]),
        [
            "--set:1:1: warning[E0823]: contact 'steel_pin': youngs modulus 0.207 GPa; usual values are 1 GPa (plastics) to 1300 GPa (diamond)\n\
          hint: did you mean \"207 GPa\" instead of \"207 MPa\"?"
        ]
    );
    // By what depends on it.
    let negative = set(&["parameter.rod_length=-120 mm"]);
    assert!(negative.len() == 1 && negative[0].contains("parameter 'rod_length' is -120 mm"), "{negative:?}");
    assert!(set(&["parameter.rod_length=121 mm"]).is_empty() && set(&[]).is_empty());
    // What the file says already is not said again.
    let wrong = template().replace("youngs_modulus = \"207 GPa\"", "youngs_modulus = \"207 MPa\"");
    let wrong = Model::from_text("model.toml", &wrong).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let other = wrong.set_values(&["parameter.rod_length=121 mm".to_owned()]);
    assert!(other.unwrap_or_else(|diagnostics| panic!("{diagnostics}")).warnings().is_empty());
}

#[test]
fn bodies_that_no_matter_makes_are_named() {
    assert_eq!(
        warning("mass = \"0.21 kg\"", "mass = \"210 kg\""),
        "body 'rod': mass 210 kg; body 'slider' has 0.14 kg, a ratio of 1500\n\
         hint: did you mean \"210 g\" instead of \"210 kg\"?"
    );
    // A slender rod has mL²/12 = 0.21 kg (120 mm)²/12 = 2.52e-4 kg m²; √(0.25/0.21) = 1.09 m.
    assert_eq!(
        warning("inertia = \"2.5e-4 kg m^2\"", "inertia = \"0.25 kg m^2\""),
        "body 'rod': inertia 0.25 kg m^2; its radius of gyration is then 1090 mm, with points 120 mm apart\n\
         hint: did you mean \"0.25 kg cm^2\" instead of \"0.25 kg m^2\"?"
    );
    assert_eq!(
        warning("inertia = \"2.5e-4 kg m^2\"", "inertia = \"2.5e-10 kg m^2\""),
        "body 'rod': inertia 2.5e-10 kg m^2; its radius of gyration is then 0.0345 mm, with points 120 mm apart\n\
         hint: a slender rod of that mass and length has about 0.00025 kg m^2"
    );
    assert_eq!(
        warning("centre_of_mass = [\"rod_length / 2\", \"0 mm\"]", "centre_of_mass = [\"6 m\", \"0 mm\"]"),
        "body 'rod': centre of mass lies 5880 mm from the points of the body, which are 120 mm apart\n\
         hint: give it in the frame of the body, like the points"
    );
    assert_eq!(
        warning("rod_length = \"120 mm\"", "rod_length = \"-120 mm\""),
        "parameter 'rod_length' is -120 mm; a length is usually above 0\nhint: did you mean \"120 mm\"?"
    );
}

#[test]
fn contacts_that_no_joint_has_are_named() {
    assert_eq!(
        warning("radial_clearance = \"0.5 mm\"", "radial_clearance = \"9 mm\""),
        "joint 'gudgeon': radial clearance 9 mm; usual values are up to a tenth of the radius, 10 mm\n\
         hint: the clearance is radius of the hole minus radius of the pin, not the radius of the pin"
    );
    // χ = 3 (1 - 0.05²)/4 = 0.748, and 0.748 (1 + c) = ln(1.748/(1 - 0.748 c)) at c = 0.664.
    assert_eq!(
        warning("restitution = 0.9", "restitution = 0.05"),
        "contact 'steel_pin': restitution 0.05; with the law lankarani-nikravesh impacts have 0.664\n\
         hint: this law is for nearly elastic impacts; flores and exact-restitution deliver the given restitution"
    );
    assert_eq!(
        warning("restitution = 0.9", "restitution = 0.9\nfriction = { coefficient = 3 }"),
        "contact 'steel_pin': friction coefficient 3; usual values are 0.001 (oil) to 1 (dry)\nhint: did you mean 0.03?"
    );
}

#[test]
fn scatter_that_no_manufacture_has_is_named() {
    let said = |input: &str| {
        let ask = "[[ask]]\noutput = \"slider\"\nof = \"value\"\nreduce = \"range\"\nstatistics = [\"mean\"]\n";
        let text = format!(
            "name = \"wild\"\nmodel = \"model.toml\"\n[random]\n\"parameter.rod_length\" = {{ {input} }}\n{ask}"
        );
        let model = Model::from_text("model.toml", template()).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        let study = Study::from_text("study.toml", &text, model).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
        study.warnings.iter().map(ToString::to_string).collect::<Vec<_>>()
    };
    assert_eq!(
        said("normal = { mean = \"120 mm\", standard_deviation = \"12 mm\" }"),
        [
            "study.toml:4:1: warning[E0823]: 'parameter.rod_length' has a standard deviation of 12 mm, but is 120 mm in the model; usual values are below a hundredth of it\nhint: correct it, or ignore this warning if the value is intended"
        ]
    );
    assert_eq!(
        said("samples = \"tests/files/turned_rods.csv\""),
        [
            "study.toml:4:1: warning[E0823]: the sample of 'parameter.rod_length' contains -120 mm, but the value in the model is 120 mm\n\
          hint: correct the sign or remove the value, or ignore this warning if the value is intended"
        ]
    );
    assert!(said("normal = { mean = \"120 mm\", standard_deviation = \"1.1 mm\" }").is_empty());
    // 5 mm on 50 mm, a tenth of it in floating point a little more.
    let tenth = said("normal = { standard_deviation = \"12 mm\" }");
    assert!(tenth.len() == 1, "{tenth:?}");
    let wide = said("tolerance = \"± 15 mm\"");
    assert!(
        wide.len() == 1 && wide[0].contains("has a standard deviation of 5 mm, but is 120 mm in the model"),
        "{wide:?}"
    );
}

/// Every file under `folder` whose name is `name`.
fn shipped(folder: &str, name: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(folder);
    let folders = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    folders.map(|folder| folder.join(name)).filter(|path| path.exists()).collect()
}

#[test]
fn no_case_and_no_template_has_such_a_number() {
    let files: Vec<PathBuf> =
        ["cases", "crates/loosepin-import/templates"].iter().flat_map(|folder| shipped(folder, "model.toml")).collect();
    assert!(files.len() > 25 + TEMPLATES.len(), "{}", files.len());
    for path in files {
        let Ok(file) = InputFile::from_path(&path) else { panic!("{}", path.display()) };
        assert_eq!(still(&file), Vec::<String>::new(), "{}", path.display());
        let InputFile::Model(model) = file else { panic!("{}", path.display()) };
        let Ok(model) = model.demand_planar() else {
            assert!(model.warnings().is_empty(), "{}: {:?}", path.display(), model.warnings());
            continue;
        };
        assert_eq!(warned(model), Vec::<String>::new(), "{}", path.display());
    }
    let studies = ["cases", "crates/loosepin-import/templates"].map(|folder| shipped(folder, "study.toml")).concat();
    assert!(studies.len() > TEMPLATES.len());
    for path in studies {
        let Ok(InputFile::Study(study)) = InputFile::from_path(&path) else { panic!("{}", path.display()) };
        assert!(study.warnings.iter().all(|warning| warning.code.as_str() != "E0823"), "{:?}", study.warnings);
    }
}

#[test]
fn a_temperature_below_absolute_zero_is_named() {
    let colder = |rise: &str| {
        let keys = format!("thermal_expansion = \"12e-6 1/K\"\ntemperature_rise = \"{rise}\"\nmass = ");
        warnings(&template().replacen("mass = ", &keys, 1))
    };
    let said = colder("-300 K");
    assert_eq!(said.len(), 1, "{said:?}");
    assert!(said[0].contains("temperature rise -300 K; from 20 °C this is below absolute zero"), "{said:?}");
    assert!(colder("-200 K").is_empty());
}
