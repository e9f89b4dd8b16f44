//! Inputs beside the plays that are uncertain: what several do together, and what follows from a parameter.

use super::{answer, study, text_of};
use loosepin_identify::record::TestReading;

/// The first reading of the case without random lengths, its model and study changed by `change` of (model, study).
fn reading(change: impl Fn(String, String) -> (String, String)) -> TestReading {
    let text = text_of("first.toml");
    let (start, end) = (text.find("[random]").expect("a table"), text.find("[epistemic]").expect("a table"));
    let (model, text) = change(text_of("model.toml"), format!("{}{}", &text[..start], &text[end..]));
    answer(&study(&model, &text)).readings.remove(0)
}

/// `study` with further inputs that are intervals.
fn with_inputs(study: &str, inputs: &str) -> String {
    study.replace("[epistemic]\n", &format!("[epistemic]\n{inputs}\n"))
}

#[test]
fn identity_friction_that_follows_from_a_parameter_counts_like_friction_that_is_an_input() {
    const COEFFICIENT: &str = "friction = { coefficient = 0.12 }";
    let ends = "interval = [0.02, 0.3]";
    let direct = reading(|model, study| {
        (model, with_inputs(&study, &format!("\"contact.bush.friction.coefficient\" = {{ {ends} }}")))
    });
    let followed = reading(|model, study| {
        assert!(model.contains(COEFFICIENT));
        let model = model
            .replace(COEFFICIENT, "friction = { coefficient = \"bush_friction\" }")
            .replace("[parameter]\n", "[parameter]\nbush_friction = 0.12\n");
        (model, with_inputs(&study, &format!("\"parameter.bush_friction\" = {{ {ends} }}")))
    });
    for (direct, followed) in direct.factors.iter().zip(&followed.factors) {
        for (direct, followed) in direct.iter().zip(followed) {
            assert!((direct / followed - 1.0).abs() < 1e-9, "{direct} {followed}");
        }
    }
    // It is more than 1 - cos(atan 0.3) = 4.2 %; in the middle of the interval, 0.16, it would be 1.3 %.
    let [least, nominal, _] = followed.factors[0];
    assert!(least < 0.96 * nominal, "{least} {nominal}");
}

#[test]
fn analytic_two_moduli_that_are_low_together_give_way_by_more_than_either() {
    let moduli = |names: &[&str]| {
        let inputs: Vec<String> = names
            .iter()
            .map(|name| {
                let middle_gpa = if *name == "bearing" { 110.0 } else { 207.0 };
                let [low, high] = [0.7, 1.3].map(|share| share * middle_gpa);
                format!("\"contact.bush.{name}_youngs_modulus\" = {{ interval = [\"{low} GPa\", \"{high} GPa\"] }}\n")
            })
            .collect();
        reading(|model, study| (model, with_inputs(&study, &inputs.concat()))).compliance_si[1]
    };
    let [neither, both] = [moduli(&[]), moduli(&["bearing", "journal"])];
    // N = K δ^1.5, and K is proportional to a modulus that both are: δ goes with its power -2/3.
    let due = neither * f64::powf(0.7, -2.0 / 3.0);
    assert!(both >= due * (1.0 - 1e-9), "{both} {due}");
    assert!(moduli(&["bearing"]).max(moduli(&["journal"])) < due);
    // The sum of the two is not counted twice: it is at most the product of what each does.
    assert!(both < 1.03 * due, "{both} {due}");
}

#[test]
fn identity_a_load_that_grows_with_a_length_makes_contacts_give_way_further() {
    // The moment on the rocker over its length: a rocker that may be 20 mm shorter carries more in every pin.
    let compliance = |length: &str| {
        reading(|model, study| {
            (model.replace("rocker_length = \"130 mm\"", &format!("rocker_length = \"{length}\"")), study)
        })
        .compliance_si[1]
    };
    let with_length = reading(|model, study| {
        (model, with_inputs(&study, "\"parameter.rocker_length\" = { interval = [\"120 mm\", \"140 mm\"] }"))
    });
    let ends = [compliance("120 mm"), compliance("140 mm")];
    assert!(with_length.compliance_si[1] >= ends[0].max(ends[1]) * (1.0 - 1e-9), "{with_length:?} {ends:?}");
}

#[test]
fn identity_factors_hold_where_all_lengths_are_at_an_end_together() {
    let lengths = [("crank_length", 60.0, 4.0), ("coupler_length", 180.0, 8.0), ("rocker_length", 130.0, 8.0)];
    let inputs: Vec<String> = lengths
        .iter()
        .map(|(name, middle, half)| {
            format!("\"parameter.{name}\" = {{ interval = [\"{} mm\", \"{} mm\"] }}\n", middle - half, middle + half)
        })
        .collect();
    // With four more inputs, none of which moves a factor, not all corners are looked at any more.
    let more = ["bearing_youngs_modulus", "journal_youngs_modulus"]
        .map(|name| format!("\"contact.bush.{name}\" = {{ interval = [\"100 GPa\", \"220 GPa\"] }}\n"))
        .concat()
        + &["bearing_poisson_ratio", "journal_poisson_ratio"]
            .map(|name| format!("\"contact.bush.{name}\" = {{ interval = [0.28, 0.35] }}\n"))
            .concat();
    let few = reading(|model, study| (model, with_inputs(&study, &inputs.concat())));
    let many = reading(|model, study| (model, with_inputs(&study, &format!("{}{more}", inputs.concat()))));
    for bits in 0..8 {
        let at = reading(|model, study| {
            let moved = lengths.iter().enumerate().fold(model, |model, (k, (name, middle, half))| {
                let end = if (bits >> k) & 1 == 0 { middle - half } else { middle + half };
                model.replace(&format!("{name} = \"{middle} mm\""), &format!("{name} = \"{end} mm\""))
            });
            (moved, study)
        });
        for spread in [&few, &many] {
            for (spread, at) in spread.factors.iter().zip(&at.factors) {
                assert!(spread[0] <= at[1] && at[1] <= spread[2], "{bits}: {spread:?} {at:?}");
                // Friction of every pin at its corner: 1 - cos(atan 0.12) = 0.71 % at least.
                assert!(spread[0] <= 0.993 * at[1], "{bits}: {spread:?} {at:?}");
            }
        }
    }
}

#[test]
fn analytic_a_push_beyond_the_contact_law_is_refused() {
    // Steel and bronze a metre deep would carry some 1e11 N, and the pins get the moment over 0.13 m.
    let text = text_of("first.toml").replace("moment = \"1.5 N m\"", "moment = \"1e12 N m\"");
    let refused = loosepin_identify::identify(
        &study(&text_of("model.toml"), &text),
        &Default::default(),
        loosepin_identify::NO_CALLBACK,
    );
    let error = refused.expect_err("no contact carries it").to_string();
    assert!(error.contains("with a larger force than its contact law can give"), "{error}");
}
