//! Keys by the names that they have elsewhere: in textbooks, in other programs, by their letters.

/// What is written elsewhere, the key that it is here, and what else differs.
const OTHER_WORDS: &[(&str, &str, &str)] = &[
    ("E", "youngs_modulus", ""),
    ("e_modulus", "youngs_modulus", ""),
    ("elastic_modulus", "youngs_modulus", ""),
    ("nu", "poisson_ratio", ""),
    ("mu", "coefficient", ""),
    ("rho", "density", ""),
    ("sigma", "standard_deviation", ""),
    ("std", "standard_deviation", ""),
    ("sd", "standard_deviation", ""),
    ("stddev", "standard_deviation", ""),
    ("average", "mean", ""),
    ("mu", "mean", ""),
    ("gauss", "normal", ""),
    ("gaussian", "normal", ""),
    ("distribution", "normal", FAMILY),
    ("family", "normal", FAMILY),
    ("type", "kind", ""),
    ("type", "normal", FAMILY),
    ("mean", "normal", FAMILY),
    ("std", "normal", FAMILY),
    ("sigma", "normal", FAMILY),
    ("standard_deviation", "normal", FAMILY),
    ("min", "lower", ""),
    ("max", "upper", ""),
    ("min", "interval", ENDS),
    ("max", "interval", ENDS),
    ("lower", "interval", ENDS),
    ("upper", "interval", ENDS),
    ("range", "interval", ENDS),
    ("hole", "bearing", ""),
    ("bushing", "bearing", ""),
    ("pin", "journal", ""),
    ("shaft", "journal", ""),
    ("bearing_diameter", "bearing_radius", "It is half of the diameter"),
    ("diameter", "bearing_radius", "It is half of the diameter"),
    ("pin_diameter", "pin_radius", "It is half of the diameter"),
    ("clearance", "radial_clearance", "On the diameter it is 'diametral_clearance', twice as large"),
    ("play", "radial_clearance", "On the diameter it is 'diametral_clearance', twice as large"),
    ("gap", "radial_clearance", "On the diameter it is 'diametral_clearance', twice as large"),
    ("play", "clearance", ""),
    ("gap", "clearance", ""),
    ("cog", "centre_of_mass", ""),
    ("com", "centre_of_mass", ""),
    ("moment_of_inertia", "inertia", ""),
    ("J", "inertia", ""),
    ("I", "inertia", ""),
    ("m", "mass", ""),
    ("weight", "mass", "It is in kg, not in N"),
    ("rpm", "speed", "Write the value with its unit: speed = \"3000 rpm\""),
    ("omega", "speed", ""),
    ("velocity", "speed", ""),
    ("g", "gravity", ""),
    ("bodies", "body", ""),
    ("links", "body", ""),
    ("link", "body", ""),
    ("motor", "drive", ""),
    ("motors", "drive", ""),
    ("force", "load", ""),
    ("forces", "load", ""),
    ("parameters", "parameter", ""),
    ("unknown", "epistemic", "What is known only to lie in an interval stands under [epistemic]"),
    ("path", "output", "A path is an output: [output.NAME] with path_of = \"BODY.POINT\""),
    ("path", "path_of", ""),
    ("position", "position_of", ""),
    ("angle", "angle_of", ""),
    ("interval", "epistemic", "Intervals stand under [epistemic]"),
    ("intervals", "epistemic", "Intervals stand under [epistemic]"),
    ("uncertain", "random", ""),
    ("tolerances", "random", ""),
    ("hinge", "revolute", ""),
    ("pin", "revolute", ""),
    ("rotational", "revolute", ""),
    ("slider", "prismatic", ""),
    ("sliding", "prismatic", ""),
    ("translational", "prismatic", ""),
    ("fixed", "rigid", ""),
    ("weld", "rigid", ""),
    ("question", "ask", "Each question begins with [[ask]]"),
    ("requirement", "require", "Each requirement begins with [[require]]"),
];

const FAMILY: &str = "The family is the key: { normal = { mean = \"50 mm\", standard_deviation = \"0.02 mm\" } }";
const ENDS: &str = "It has both ends: interval = [\"0.1 mm\", \"0.5 mm\"]";

/// The key among `known` that is called `written` elsewhere, with what else differs.
pub(super) fn by_synonym(written: &str, known: &[&'static str]) -> Option<(&'static str, &'static str)> {
    let found = OTHER_WORDS.iter().find(|(other, key, _)| {
        let is_same = if other.len() == 1 { *other == written } else { other.eq_ignore_ascii_case(written) };
        is_same && known.contains(key)
    });
    found.map(|(_, key, note)| (*key, *note))
}

#[cfg(test)]
mod tests {
    use super::{OTHER_WORDS, by_synonym};

    #[test]
    fn a_word_is_taken_for_a_key_of_its_table_only() {
        assert_eq!(by_synonym("mu", &["law", "coefficient"]), Some(("coefficient", "")));
        assert_eq!(by_synonym("mu", &["mean", "standard_deviation"]), Some(("mean", "")));
        assert_eq!(by_synonym("mu", &["mass"]), None);
        assert_eq!(by_synonym("e", &["youngs_modulus"]), None, "letters have their case");
    }

    #[test]
    fn no_word_stands_twice_for_one_key() {
        for (index, (other, key, _)) in OTHER_WORDS.iter().enumerate() {
            assert!(!OTHER_WORDS[..index].iter().any(|(o, k, _)| o == other && k == key), "{other} {key}");
        }
    }
}
