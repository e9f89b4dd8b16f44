//! The keys of an `expected.toml`.

use super::case::{QuantityKind, Reduce};
use loosepin_text::document::{Keys, Kind, optional, required};
use loosepin_text::units::Rule;

/// Where a number may come from: the first word of the name of a test.
pub(super) const ORIGINS: [&str; 4] = ["analytic", "published", "peer", "pinned"];

/// The quantities with their words and the keys that say more.
pub(super) const QUANTITIES: [(&str, QuantityKind, &[&str]); 20] = [
    ("contact_onset", QuantityKind::ContactOnset, &["joint", "span"]),
    ("impact_speed", QuantityKind::ImpactSpeed, &["joint", "span"]),
    ("separation_speed", QuantityKind::SeparationSpeed, &["joint", "span"]),
    ("impact_duration", QuantityKind::ImpactDuration, &["joint", "span"]),
    ("contacts", QuantityKind::Contacts, &["joint", "span"]),
    ("peak_force", QuantityKind::PeakForce, &["joint", "span"]),
    ("largest_penetration", QuantityKind::LargestPenetration, &["joint", "span"]),
    ("contact_stiffness", QuantityKind::ContactStiffness, &["joint"]),
    ("static_force", QuantityKind::StaticForce, &["joint", "penetration"]),
    ("delivered_restitution", QuantityKind::DeliveredRestitution, &["joint"]),
    ("output", QuantityKind::Output, &["output", "state", "reduce", "time", "span"]),
    ("ideal_output", QuantityKind::IdealOutput, &["output", "state", "reduce", "angle", "time"]),
    ("worst_case", QuantityKind::WorstCase, &["output", "angle"]),
    ("first_order_play", QuantityKind::FirstOrderPlay, &["output", "angle"]),
    ("dimensional_standard_deviation", QuantityKind::DimensionalStandardDeviation, &["output", "angle"]),
    ("energy_residual", QuantityKind::EnergyResidual, &["span"]),
    ("loop_drift", QuantityKind::LoopDrift, &["span"]),
    ("contact_loss", QuantityKind::ContactLoss, &["span"]),
    ("friction_loss", QuantityKind::FrictionLoss, &["span"]),
    ("drive_work", QuantityKind::DriveWork, &["span"]),
];

fn quantity_words() -> Vec<&'static str> {
    QUANTITIES.iter().map(|(word, _, _)| *word).collect()
}

/// What may become of a course in time.
pub(super) const REDUCTIONS: [(&str, Reduce); 4] = [
    ("minimum", Reduce::Minimum),
    ("maximum", Reduce::Maximum),
    ("angle_of_minimum", Reduce::AngleOfMinimum),
    ("angle_of_maximum", Reduce::AngleOfMaximum),
];

fn reduction_words() -> Vec<&'static str> {
    REDUCTIONS.iter().map(|(word, _)| *word).collect()
}

/// A value, or one for each number of a list.
const ONE_OR_EACH: Kind = Kind::AnyOf(&[Kind::AnyQuantity, Kind::List(&Kind::AnyQuantity)]);

pub(super) static NUMBER_KEYS: Keys = Keys::new(
    "numbers to be met",
    &[
        required("value", ONE_OR_EACH, "\"45870 N\"", "the number with its unit, or a list of them"),
        required("tolerance", Kind::AnyQuantity, "\"5 N\"", "largest accepted absolute difference"),
        required("origin", Kind::Choice(&ORIGINS), "\"peer\"", "where the number comes from"),
        required("source", Kind::Text, "\"eq. (9)\"", "the formula, the paper or the program"),
        required("reason", Kind::Text, "\"six digits\"", "why the tolerance is what it is"),
        required("quantity", Kind::ChoiceOf(quantity_words), "\"impact_speed\"", "how the number is obtained"),
        optional("joint", Kind::Reference("joint"), "\"gudgeon\"", "the joint with play"),
        optional("output", Kind::Reference("output"), "\"slider\"", "the output of the model"),
        optional("state", Kind::Text, "\"coupler.angle\"", "angle, omega or alpha of a body, where no output gives it"),
        optional("reduce", Kind::ChoiceOf(reduction_words), "\"maximum\"", "what is taken of the course in time"),
        optional("angle", ONE_OR_EACH, "\"60 deg\"", "angle of the drive of the cycle"),
        optional("time", ONE_OR_EACH, "\"3 ms\"", "time from the start"),
        optional("penetration", ONE_OR_EACH, "\"10 um\"", "penetration of a contact at rest"),
        optional("span", Kind::AnyQuantity, "\"24 ms\"", "length of the run; the cycle of the model if left out"),
        optional(
            "set",
            Kind::List(&Kind::Text),
            "[\"joint.gudgeon.radial_clearance=0.5mm\"]",
            "a setting for each value",
        ),
    ],
);

pub(super) static COLUMN_KEYS: Keys = Keys::new(
    "a column of a history",
    &[
        required("column", Kind::Text, "\"b3_x\"", "the column of the file"),
        required("tolerance", Kind::AnyQuantity, "\"1e-8 m\"", "largest accepted absolute difference"),
        optional("output", Kind::Reference("output"), "\"slider\"", "the output of the model"),
        optional("state", Kind::Text, "\"rod.x\"", "x, y, angle, vx, vy, omega, ax, ay or alpha of a body"),
    ],
)
.with_exactly_one(&[&["output", "state"]]);

pub(super) static HISTORY_KEYS: Keys = Keys::new(
    "a history to be met",
    &[
        required("file", Kind::Text, "\"reference.csv\"", "rows at equal times, the time in seconds first"),
        required("origin", Kind::Choice(&ORIGINS), "\"peer\"", "where the history comes from"),
        required("source", Kind::Text, "\"a program\"", "the paper or the program"),
        required("reason", Kind::Text, "\"agrees with a second run\"", "why the tolerances are what they are"),
        required("columns", Kind::List(&Kind::Table(&COLUMN_KEYS)), "[{ column = \"b3_x\", ... }]", "what is compared"),
    ],
);

const NUMBER: Kind = Kind::Number { rule: Rule::Finite };

static REFERENCE_KEYS: Keys = Keys::new(
    "the run of a script and how well a second one agrees with it",
    &[
        required("source", Kind::Text, "\"peer: cases/oracle\"", "the program"),
        required("rows", NUMBER, "251", "rows of reference.csv"),
        required("span_s", NUMBER, "0.05", "its length, s"),
        required("agreement_position_m", NUMBER, "1e-12", "with a second run"),
        required("agreement_velocity_m_s", NUMBER, "1e-9", "with a second run"),
        required("agreement_acceleration_m_s2", NUMBER, "1e-5", "with a second run"),
        required("growth", NUMBER, "100", "of a difference over the span"),
    ],
);

static ENERGY_KEYS: Keys = Keys::new(
    "energies at the end of the run of a script",
    &[
        required("contact_loss_j", NUMBER, "0.01", "lost in normal contact, J"),
        required("friction_loss_j", NUMBER, "0.01", "lost in friction, J"),
        required("drive_work_j", NUMBER, "0.1", "work of the drives, J"),
        required("agreement_j", NUMBER, "1e-10", "with a second run, J"),
        required("residual_j", NUMBER, "1e-12", "of the energy account, J"),
    ],
);

pub(super) static IMPACT_KEYS: Keys = Keys::new(
    "an impact",
    &[
        required("time_s", NUMBER, "1e-3", "when it begins, s"),
        required("speed_m_s", NUMBER, "0.3", "approach speed, m/s"),
        optional("duration_s", NUMBER, "1e-4", "how long it lasts, s"),
        optional("peak_force_n", NUMBER, "1000", "largest normal force, N"),
        optional("separation_speed_m_s", NUMBER, "0.2", "separation speed, m/s"),
    ],
);

static JOINT_KEYS: Keys = Keys::new(
    "what happens in a joint with play in the run of a script",
    &[
        required("law", Kind::Text, "\"flores\"", "the law"),
        required("stiffness_n_m_n", NUMBER, "1e10", "K"),
        required("exponent", NUMBER, "1.5", "n"),
        required("damping_factor", NUMBER, "0.6", "χ"),
        required("onsets", NUMBER, "17", "contacts that begin"),
        required("floored_onsets", NUMBER, "0", "those below the least impact speed"),
        required("ends", NUMBER, "17", "contacts that end"),
        required("force_cuts", NUMBER, "0", "times that the force was cut at zero"),
        required("friction_zone_changes", NUMBER, "0", "changes of the friction law's zone"),
        optional("peak_force_n", NUMBER, "1000", "of the contacts that ended, N"),
        optional("agreement_peak_force_n", NUMBER, "1e-6", "with a second run"),
        optional("agreement_onset_s", NUMBER, "1e-12", "with a second run"),
        optional("agreement_speed_m_s", NUMBER, "1e-10", "with a second run"),
        optional("impact", Kind::List(&Kind::Table(&IMPACT_KEYS)), "[{ time_s = 1e-3, ... }]", "the first impacts"),
    ],
);

pub(super) static SCRIPT_KEYS: [(&str, &Keys); 3] =
    [("reference", &REFERENCE_KEYS), ("energy", &ENERGY_KEYS), ("joint", &JOINT_KEYS)];

pub(super) static EXPECTED_KEYS: Keys = Keys::new(
    "what a case must meet",
    &[
        optional("expected", Kind::Tables { keys: &NUMBER_KEYS, except: &[] }, "", "numbers"),
        optional("history", Kind::Tables { keys: &HISTORY_KEYS, except: &[] }, "", "histories"),
        optional("reference", Kind::Table(&REFERENCE_KEYS), "", "the run of a script"),
        optional("energy", Kind::Table(&ENERGY_KEYS), "", "its energies"),
        optional("joint", Kind::Tables { keys: &JOINT_KEYS, except: &[] }, "", "its joints"),
    ],
);
