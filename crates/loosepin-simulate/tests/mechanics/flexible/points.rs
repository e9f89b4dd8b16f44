//! Points inside flexible links: closed forms at rest, other trees and other shapes of the same mechanism in motion.

use super::laws::watched_momenta;
use super::{apart, case_text, record, values};
use crate::elements::{build, file};
use loosepin_mechanics::mechanism::Mechanism;
use loosepin_mechanics::model::Model;

/// EI of the bars, N m², their length, m, and section.
const LENGTH_M: f64 = 0.4;
const AREA_M2: f64 = 0.012 * 0.007;
const BENDING_N_M2: f64 = 207e9 * 0.012 * 0.007 * 0.007 * 0.007 / 12.0;
const MODULUS_M3: f64 = 0.012 * 0.007 * 0.007 / 6.0;
/// Second order of slopes up to 0.004.
const RELATIVE: f64 = 2e-5;

/// A bar at rest with a point inside, at 0.3 of its length and 15 mm above its axis where `is_beside`.
fn bar(is_held: bool, is_beside: bool, load: &str) -> String {
    let support = if is_held {
        "[drive.bar]\njoint = \"main\"\nmotion = { kind = \"expression\", position = \"0 rad + 0 rad/s * time\" }\n"
    } else {
        "[body.foot]\nmass = \"0.1 kg\"\ninertia = \"1e-5 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
         points = { pin = [\"0 mm\", \"0 mm\"] }\n\
         [joint.far]\nkind = \"revolute\"\nbearing = \"bar.tip\"\njournal = \"foot.pin\"\n\
         [joint.guide]\nkind = \"prismatic\"\nguide = { point = \"ground.o\", angle = \"0 deg\" }\nslider = \"foot.pin\"\n\
         [assembly]\nguess = { bar = \"0 deg\" }\n"
    };
    format!(
        "name = \"bar\"\ngravity = \"0 m/s^2\"\n\
         [body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"] }}\n\
         [body.bar]\npoints = {{ root = [\"30 mm\", \"-20 mm\"], eye = [\"150 mm\", \"{} mm\"], tip = [\"430 mm\", \"-20 mm\"] }}\n\
         [body.bar.beam]\nfrom = \"root\"\nto = \"tip\"\nsection = {{ width = \"12 mm\", height = \"7 mm\" }}\n\
         youngs_modulus = \"207 GPa\"\ndensity = \"7800 kg/m^3\"\nframe = \"{}\"\nstart = \"settled\"\n\
         lateral_shapes = 2\naxial_shapes = 1\n\
         [joint.main]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"bar.root\"\n{support}\
         [load.push]\nkind = \"force\"\npoint = \"bar.eye\"\n{load}\n\
         [cycle]\nduration = \"1 ms\"\nsamples_per_turn = 4\n\
         [output.stress]\nstress_in = \"bar\"\n[output.eye]\nposition_of = \"bar.eye\"\nalong = \"y\"\n\
         [output.eye_x]\nposition_of = \"bar.eye\"\nalong = \"x\"\n",
        if is_beside { -5 } else { -20 },
        if is_held { "tangent" } else { "secant" },
    )
}

fn demand(text: &str, output: &str, start: f64, due: f64, relative: f64) {
    let record = record(text);
    for found in values(&record, output) {
        assert!(((found - start) / due - 1.0).abs() < relative, "{output}: {} for {due}", found - start);
    }
}

/// P a² b²/(3 E I L) on two supports and P x³/(3 E I) on one, whatever the number of modes beside the static shape; moments P a b/L and P x.
#[test]
fn analytic_a_force_at_a_point_inside() {
    let (a, b) = (0.12, 0.28);
    let down = "force = \"5 N\"\ndirection = \"-90 deg\"";
    let on_two = bar(false, false, down);
    demand(&on_two, "eye", 0.0, -5.0 * (a * b * a * b) / (3.0 * BENDING_N_M2 * LENGTH_M), RELATIVE);
    demand(&on_two, "stress", 0.0, 5.0 * a * b / LENGTH_M / MODULUS_M3, RELATIVE);
    let held = bar(true, false, down);
    demand(&held, "eye", 0.0, -5.0 * a * a * a / (3.0 * BENDING_N_M2), RELATIVE);
    demand(&held, "stress", 0.0, 5.0 * a / MODULUS_M3, RELATIVE);
    // Along the bar: P x/(E A), and P/A up to the point alone.
    let along = bar(true, false, "force = \"900 N\"\ndirection = \"0 deg\"");
    demand(&along, "eye_x", 0.12, 900.0 * a / (207e9 * AREA_M2), 1e-8);
    demand(&along, "stress", 0.0, 900.0 / AREA_M2, 1e-8);
}

/// A pull P at h beside the axis bends the held bar by a couple: (h - h sech ka) down at the point, k² = P/(E I), and P/A + P h/W of stress.
#[test]
fn analytic_a_force_beside_the_axis() {
    let along = bar(true, true, "force = \"90 N\"\ndirection = \"0 deg\"");
    demand(&along, "stress", 0.0, 90.0 / AREA_M2 + 90.0 * 0.015 / MODULUS_M3, 2e-4);
    let due = -0.015 * (1.0 - 1.0 / ((90.0_f64 / BENDING_N_M2).sqrt() * 0.12).cosh());
    // The turn of the section lowers the point by ½ h α², 3e-4 of it.
    demand(&along, "eye", 0.015, due, 1e-3);
}

/// A rod with a second link at a point beside its axis, whose foot slides on a rail, and a spring from there to the ground; no play.
fn rod_with_a_bob(more: &str) -> String {
    case_text("flexible_slider_crank")
        .replace("duration = \"10 ms\"", "duration = \"3 ms\"")
        .replace("radial_clearance = \"0.2 mm\"", "radial_clearance = \"0 mm\"")
        .replace("small_end = [\"rod_length\", \"0 mm\"] }", "small_end = [\"rod_length\", \"0 mm\"], eye = [\"90 mm\", \"6 mm\"] }")
        .replace("points = { o = [\"0 mm\", \"0 mm\"] }", "points = { o = [\"0 mm\", \"0 mm\"], nail = [\"200 mm\", \"-150 mm\"] }")
        .replace("axial_shapes = 2", &format!("axial_shapes = 2\n{more}"))
        .replace(
            "[drive.crank]",
            "[body.bob]\nmass = \"40 g\"\ninertia = \"2e-5 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"-30 mm\"]\n\
             points = { pin = [\"0 mm\", \"0 mm\"], foot = [\"0 mm\", \"-240 mm\"] }\n\
             [body.block]\nmass = \"30 g\"\ninertia = \"1e-5 kg m^2\"\ncentre_of_mass = [\"0 mm\", \"0 mm\"]\n\
             points = { pin = [\"0 mm\", \"0 mm\"] }\n\
             [joint.foot]\nkind = \"revolute\"\nbearing = \"bob.foot\"\njournal = \"block.pin\"\n\
             [joint.rail]\nkind = \"prismatic\"\nguide = { point = \"ground.nail\", angle = \"0 deg\" }\nslider = \"block.pin\"\n\
             [joint.hinge]\nkind = \"revolute\"\nbearing = \"rod.eye\"\njournal = \"bob.pin\"\n\
             [spring.coil]\nkind = \"linear\"\nfirst = \"ground.nail\"\nsecond = \"rod.eye\"\nstiffness = \"20 kN/m\"\nfree_length = \"120 mm\"\n\
             [drive.crank]",
        )
        .replace("guess = { rod = \"0 deg\" }", "guess = { rod = \"0 deg\", bob = \"45 deg\" }")
        + "\n[output.eye]\nposition_of = \"rod.eye\"\nalong = \"y\"\n[output.bob]\nangle_of = \"bob\"\n\
           [output.hinge_force]\nforce_in = \"joint.hinge\"\ncomponent = \"magnitude\"\n"
}

/// Sines alone come to the static shapes as their number grows, and both keep their energy.
#[test]
fn identity_sines_alone_come_to_the_static_shapes_in_motion() {
    let shapes = |lateral: usize, axial: usize, more: &str| {
        let text = rod_with_a_bob(more).replace(
            "lateral_shapes = 2\naxial_shapes = 2",
            &format!("lateral_shapes = {lateral}\naxial_shapes = {axial}"),
        );
        record(&text)
    };
    let built = build(&rod_with_a_bob(""));
    let cuts: Vec<&str> =
        built.mechanism.real.cuts.iter().map(|cut| built.mechanism.model.joints[cut.joint.0].name.as_str()).collect();
    assert!(cuts.contains(&"hinge"), "{cuts:?}");
    let settled = "start = \"settled\"";
    let without = "static_shapes = \"none\"\nstart = \"settled\"";
    let many = shapes(6, 4, settled);
    let [few, finer] = [shapes(1, 1, settled), shapes(3, 2, settled)];
    let sines = [shapes(2, 2, without), shapes(4, 4, without), shapes(8, 8, without)];
    for record in [&many, &few, &finer].into_iter().chain(&sines) {
        assert!(record.energy.relative_residual < 1e-8, "{:e}", record.energy.relative_residual);
    }
    let off: Vec<f64> = sines.iter().map(|sines| apart(sines, &many, "eye")).collect();
    let own = [apart(&few, &many, "eye"), apart(&finer, &many, "eye")];
    assert!(off[2] < 0.1 * off[0] && off[1] < off[0], "{off:?}");
    // Three modes and one static shape are better than four sines.
    assert!(own[1] < own[0] && own[1] < off[1], "{own:?} {off:?}");
}

/// A rigid body on a point inside a beam, both floating: the beam carries it, or it comes first and the joint is a constraint.
#[test]
fn identity_a_joint_inside_a_beam_may_be_cut() {
    let beam = "[body.lever]\npoints = { a = [\"0 mm\", \"0 mm\"], pivot = [\"90 mm\", \"4 mm\"], b = [\"300 mm\", \"0 mm\"] }\n\
                [body.lever.beam]\nfrom = \"a\"\nto = \"b\"\nsection = { width = \"8 mm\", height = \"4 mm\" }\n\
                youngs_modulus = \"70 GPa\"\ndensity = \"2700 kg/m^3\"\nlateral_shapes = 2\naxial_shapes = 1\n";
    let bob = "[body.bob]\nmass = \"40 g\"\ninertia = \"2e-5 kg m^2\"\ncentre_of_mass = [\"5 mm\", \"-30 mm\"]\n\
               points = { pin = [\"0 mm\", \"0 mm\"] }\n";
    let text = |bodies: [&str; 2]| {
        format!(
            "name = \"floating\"\ngravity = \"0 m/s^2\"\n[body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"] }}\n{}{}\
             [joint.hinge]\nkind = \"revolute\"\nbearing = \"lever.pivot\"\njournal = \"bob.pin\"\n\
             [initial.body.lever]\nangle = \"20 deg\"\nangular_velocity = \"60 rad/s\"\nposition = [\"30 mm\", \"-40 mm\"]\n\
             velocity = [\"1.3 m/s\", \"0.7 m/s\"]\n\
             [initial.body.bob]\nangle = \"-35 deg\"\nangular_velocity = \"-140 rad/s\"\n\
             [cycle]\nduration = \"5 ms\"\nsamples_per_turn = 50\n\
             [output.lever]\nangle_of = \"lever\"\n[output.bob]\nangle_of = \"bob\"\n\
             [output.tip]\nposition_of = \"lever.b\"\nalong = \"y\"\n\
             [output.hinge_force]\nforce_in = \"joint.hinge\"\ncomponent = \"x\"\n",
            bodies[0], bodies[1]
        )
    };
    let texts = [text([beam, bob]), text([bob, beam])];
    let cuts = texts.each_ref().map(|text| build(text).mechanism.real.cuts.len());
    assert_eq!(cuts, [0, 1]);
    let [carried, cut] = texts.map(|text| record(&text));
    for output in ["lever", "bob", "tip"] {
        assert!(apart(&carried, &cut, output) < 1e-10, "{output}: {:e}", apart(&carried, &cut, output));
    }
    assert!(apart(&carried, &cut, "hinge_force") < 1e-4, "{:e} N", apart(&carried, &cut, "hinge_force"));
    for run in [&carried, &cut] {
        assert!(run.energy.relative_residual < 1e-9, "{:e}", run.energy.relative_residual);
    }
}

/// A lever that stands on a point inside: it floats, and its pivot is a constraint.
#[test]
fn analytic_a_lever_on_a_point_inside_swings_as_a_rigid_one() {
    let text = |beam: &str| {
        format!(
            "name = \"lever\"\ngravity = \"9.81 m/s^2\"\n[body.ground]\npoints = {{ o = [\"0 mm\", \"0 mm\"] }}\n\
             [body.lever]\npoints = {{ a = [\"0 mm\", \"0 mm\"], pivot = [\"90 mm\", \"0 mm\"], b = [\"300 mm\", \"0 mm\"] }}\n{beam}\n\
             [joint.pivot]\nkind = \"revolute\"\nbearing = \"ground.o\"\njournal = \"lever.pivot\"\n\
             [initial.body.lever]\nangle = \"-30 deg\"\nangular_velocity = \"2 rad/s\"\n\
             [cycle]\nduration = \"6 ms\"\nsamples_per_turn = 30\n[output.angle]\nangle_of = \"lever\"\n\
             [output.pivot_force]\nforce_in = \"joint.pivot\"\ncomponent = \"magnitude\"\n"
        )
    };
    let beam = |modulus: &str| {
        text(&format!(
            "[body.lever.beam]\nfrom = \"a\"\nto = \"b\"\nsection = {{ width = \"8 mm\", height = \"8 mm\" }}\n\
             youngs_modulus = \"{modulus}\"\ndensity = \"7870 kg/m^3\"\nstart = \"settled\"\nlateral_shapes = 1\naxial_shapes = 1"
        ))
    };
    let built = build(&beam("200 GPa"));
    assert!(built.mechanism.real.links[0].joint().is_none());
    assert_eq!(built.mechanism.real.cuts.len(), 1);
    let rigid = record(&text(
        "mass = \"0.151104 kg\"\ninertia = \"0.151104 kg * (300 mm)^2 / 12\"\ncentre_of_mass = [\"150 mm\", \"0 mm\"]",
    ));
    let off: Vec<f64> = ["200 GPa", "2000 GPa"]
        .map(|modulus| {
            let record = record(&beam(modulus));
            assert!(record.energy.relative_residual < 1e-8, "{:e}", record.energy.relative_residual);
            apart(&record, &rigid, "angle")
        })
        .to_vec();
    // As 1/E.
    assert!((1e-9..1e-4).contains(&off[0]) && (9.0..11.0).contains(&(off[0] / off[1])), "{off:?}");
}

/// Contact with friction off the axes and a spring, all inside the links: momenta and energy are kept.
#[test]
fn identity_momenta_and_energy_with_points_inside() {
    let text = file("flexible_points_inside.toml");
    // More play than lanes have, so that it bounces more often.
    watched_momenta(&text.replace("0.004 mm", "0.1 mm"), 6 + 3 + 4 + 2 + 3);
}

#[test]
fn messages_of_points_that_cannot_be() {
    let diagnostic = |text: &str| match Model::from_text("model.toml", text) {
        Err(diagnostics) => diagnostics.to_string(),
        Ok(model) => Mechanism::new(&model, &model.quantities.nominal())
            .expect_err("it is refused")
            .diagnostic(&model)
            .to_string(),
    };
    let text = rod_with_a_bob("");
    let found = diagnostic(&text.replace("eye = [\"90 mm\", \"6 mm\"]", "eye = [\"301 mm\", \"6 mm\"]"));
    assert!(found.contains("point 'eye' of body 'rod' lies beyond the ends of its beam"), "{found}");
    let found = diagnostic(&text.replace(
        "[joint.hinge]\nkind = \"revolute\"\nbearing = \"rod.eye\"\njournal = \"bob.pin\"",
        "[joint.hinge]\nkind = \"rigid\"\nfirst = \"rod.eye\"\nsecond = \"bob.pin\"\nangle = \"0 deg\"",
    ));
    assert!(found.contains("joint 'hinge': the section of body 'rod' is held at a point between its ends"), "{found}");
    // A run that puts the point elsewhere.
    let built = build(&text);
    let id = built.mechanism.model.quantities.id("body.rod.points.eye.x").expect("a quantity");
    let at = |x_m: f64| {
        let values = built.mechanism.model.quantities.evaluate(&[(id, x_m)]).expect("values");
        loosepin_mechanics::mechanism::Sample::<f64>::new(&built.mechanism, &values).map(|_| ())
    };
    assert!(at(0.0955).is_ok());
    let found = at(0.0975).expect_err("it is refused").to_string();
    assert_eq!(
        found,
        "point 'eye' of body 'rod' is 2.5 % of the length of its beam away from the section chosen for it; at most 2 % is permitted"
    );
}
