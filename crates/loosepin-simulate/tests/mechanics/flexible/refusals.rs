//! What a flexible body cannot have is refused where it stands.

use super::case_text;
use crate::elements::build;
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::Model;
use loosepin_simulate::{Plan, simulate};

/// The complaints about a text, without place and colour: first lines.
fn complaints(text: &str) -> String {
    match Model::from_text("model.toml", text) {
        Err(complaints) => complaints.to_string(),
        Ok(model) => match Mechanism::new(&model, &model.quantities.nominal()) {
            Err(error) => error.complaint(&model).to_string(),
            Ok(_) => String::new(),
        },
    }
}

#[test]
fn messages_of_what_a_flexible_body_cannot_have() {
    let text = case_text("flexible_slider_crank");
    let points = "points = { big_end = [\"0 mm\", \"0 mm\"], small_end = [\"rod_length\", \"0 mm\"] }";
    let with = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    };
    let more = |table: &str| format!("{text}\n{table}\n");
    let cases = [
        (
            with("lateral_shapes = 2\naxial_shapes = 2", "formulation = \"absolute-nodal\"\naxial_shapes = 2"),
            "'axial_shapes' belongs to formulation = \"floating-frame\"",
        ),
        (with("axial_shapes = 2", "elements = 8"), "'elements' belongs to formulation = \"absolute-nodal\""),
        (
            with(points, &format!("{points}\nmass = \"0.2 kg\"")),
            "body 'rod': 'mass' and 'beam' cannot be used together; give exactly one of 'mass' and 'beam'",
        ),
        (
            with(
                "small_end = [\"rod_length\", \"0 mm\"] }",
                "small_end = [\"rod_length\", \"0 mm\"], eye = [\"340 mm\", \"0 mm\"] }",
            ),
            "point 'eye' of body 'rod' lies beyond the ends of its beam",
        ),
        (with("to = \"small_end\"", "to = \"end\""), "body 'rod' has no point 'end'"),
        (with("to = \"small_end\"", "to = \"big_end\""), "ends where it begins"),
        // No number holds the second moment of a section as high as that.
        (with("height = \"8 mm\" }", "height = \"1e200 m\" }"), "body 'rod': beam second moment"),
        (with("height = \"8 mm\" }", "diameter = \"8 mm\" }"), "cannot be used together; give exactly one of"),
        (with(", height = \"8 mm\" }", ", second_moment = \"341 mm^4\" }"), "'width' needs 'height'"),
        (
            with("lateral_shapes = 2\naxial_shapes = 2", "lumps.bush = { at = \"end\", mass = \"1 g\" }"),
            "body 'rod' has no point 'end'",
        ),
        (
            with(
                "lateral_shapes = 2\naxial_shapes = 2",
                "formulation = \"absolute-nodal\"\nlumps.bush = { at = \"small_end\", mass = \"1 g\" }",
            ),
            "'lumps' belongs to formulation = \"floating-frame\"",
        ),
        (
            with("lateral_shapes = 2\naxial_shapes = 2", "lumps.bush = { at = \"small_end\", mass = \"-1 g\" }"),
            "must be >= 0",
        ),
        (
            with("lateral_shapes = 2\naxial_shapes = 2", "lateral_shapes = 0\naxial_shapes = 0"),
            "has neither lateral nor axial shapes",
        ),
        (
            with(
                "[joint.gudgeon]\nkind = \"revolute\"",
                "[joint.second_guide]\nkind = \"prismatic\"\n\
                  guide = { point = \"ground.o\", angle = \"0 deg\" }\nslider = \"rod.small_end\"\n[joint.gudgeon]\nkind = \"revolute\"",
            ),
            "joint 'second_guide': body 'rod' is flexible and cannot be held by a prismatic joint",
        ),
        (
            with("lateral_shapes = 2\naxial_shapes = 2", "formulation = \"absolute-nodal\"")
                .replacen("joint = \"main\"", "joint = \"crank_pin\"", 1)
                .replacen("kind = \"revolute\"\nbearing = \"rod.small_end\"\njournal = \"slider.pin\"\nbearing_radius = \"10 mm\"\nradial_clearance = \"0.2 mm\"\ncontact = \"steel_pin\"", "kind = \"rigid\"\nfirst = \"rod.small_end\"\nsecond = \"slider.pin\"\nangle = \"0 deg\"", 1)
                + "\n[output.stress]\nstress_in = \"rod\"\n",
            "output 'stress': stress in: the section of body 'rod' is held at both ends, and the stress does not include the moments there yet",
        ),
        (
            with("axial_shapes = 2", "axial_shapes = 2\nframe = \"tangent\""),
            "joint 'crank_pin': body 'rod' has a tangent frame and turns freely at from",
        ),
        (
            with("joint = \"main\"", "joint = \"crank_pin\""),
            "joint 'crank_pin': body 'rod' has a secant frame, but its section at from is held",
        ),
        (
            with(
                "kind = \"revolute\"\nbearing = \"crank.pin\"",
                "kind = \"revolute\"\npin_radius = \"9 mm\"\n\
                  friction = { coefficient = 0.1 }\nbearing = \"crank.pin\"",
            ),
            "joint 'crank_pin': this is not computed yet in a mechanism with a flexible body, here 'rod'",
        ),
        (
            more("[load.twist]\nkind = \"torque\"\nbody = \"rod\"\ntorque = \"1 N m\""),
            "load 'twist': body 'rod' is flexible, so each of its sections has its own angle",
        ),
        (
            more(
                "[spring.coil]\nkind = \"torsional\"\njoint = \"crank_pin\"\nstiffness = \"1 N m/rad\"\nfree_angle = \"0 deg\"",
            ),
            "spring 'coil': body 'rod' is flexible, so each of its sections has its own angle",
        ),
        (
            with("[parameter]", "temperature_rise = \"40 K\"\n[parameter]").replacen(
                points,
                &format!("{points}\nthermal_expansion = \"11.7e-6 1/K\""),
                1,
            ),
            "body 'rod': 'thermal_expansion' cannot be used with 'beam'",
        ),
    ];
    for (text, due) in cases {
        let found = complaints(&text);
        assert!(found.contains(due), "{due}\nis not said:\n{found}");
    }
    assert_eq!(complaints(&text), "");
}

/// A beam that no step can follow is named where it stands, in either formulation: the only number that is far from those of a real part.
#[test]
fn messages_of_a_run_that_a_beam_takes_beyond_finite_numbers() {
    let shapes = "lateral_shapes = 2\naxial_shapes = 2";
    for keys in [shapes, "formulation = \"absolute-nodal\"\nelements = 4"] {
        for (from, to) in [("200 GPa", "1e150 Pa"), ("7870 kg/m^3", "1e-200 kg/m^3")] {
            let text = case_text("flexible_slider_crank").replace(shapes, keys).replacen(from, to, 1);
            let built = build(&text);
            let plan = Plan::of_model(&built.mechanism.model);
            let failure = simulate(&built.mechanism, &built.values, &plan).expect_err("no step follows it");
            let said = failure.complaint(&built.mechanism.model).to_string();
            assert_eq!(
                said,
                "model.toml:20:11: error[E0803]: at 0 ms the beam of body 'rod' vibrates faster than the smallest step can resolve: a position or velocity is \
                     not a finite number\nhint: look for a modulus, a density or a section far from those of a real part"
            );
        }
    }
}
