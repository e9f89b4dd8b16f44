//! The tables of an `expected.toml`.

use super::case::{QuantityKind, Reduce};
use loosepin_text::document::{Entry, Keys, Kind, Reads, choice, optional, required};
use loosepin_text::units::Rule;
use loosepin_text::{choices, record};

choices!(
    /// Possible sources of a number: the first word of the name of a test.
    pub(super) struct Origin(&'static str):
    "analytic" => "analytic",
    "published" => "published",
    "peer" => "peer",
    "pinned" => "pinned",
);

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

choices!(Reduce:
    "minimum" => Self::Minimum,
    "maximum" => Self::Maximum,
    "angle_of_minimum" => Self::AngleOfMinimum,
    "angle_of_maximum" => Self::AngleOfMaximum,
);

/// A value, or one for each number of a list.
const ONE_OR_EACH: Kind = Kind::AnyOf(&[Kind::AnyQuantity, Kind::List(&Kind::AnyQuantity)]);

record! {
    /// numbers to be met
    pub(super) lenient struct NumberTable for Reads;
    /// the number with its unit, or a list of them
    required value: Entry<'t> = ONE_OR_EACH, "\"45870 N\"";
    /// largest accepted absolute difference
    required tolerance: Entry<'t> = Kind::AnyQuantity, "\"5 N\"";
    /// where the number comes from
    required origin: Origin = choice::<Origin>(), "\"peer\"";
    /// the formula, the paper or the program
    required source: String = Kind::Text, "\"eq. (9)\"";
    /// why the tolerance is what it is
    required reason: String = Kind::Text, "\"six digits\"";
    /// how the number is obtained
    required quantity: Entry<'t> = Kind::ChoiceOf(quantity_words), "\"impact_speed\"";
    /// the joint with play
    optional joint: Entry<'t> = Kind::Reference("joint"), "\"gudgeon\"";
    /// the output of the model
    optional output: Entry<'t> = Kind::Reference("output"), "\"slider\"";
    /// angle, omega or alpha of a body, where no output gives it
    optional state: Entry<'t> = Kind::Text, "\"coupler.angle\"";
    /// what is taken of the course in time
    optional reduce: Entry<'t> = choice::<Reduce>(), "\"maximum\"";
    /// angle of the drive of the cycle
    optional angle: Entry<'t> = ONE_OR_EACH, "\"60 deg\"";
    /// time from the start
    optional time: Entry<'t> = ONE_OR_EACH, "\"3 ms\"";
    /// penetration of a contact at rest
    optional penetration: Entry<'t> = ONE_OR_EACH, "\"10 um\"";
    /// length of the run; the cycle of the model if omitted
    optional span: Entry<'t> = Kind::AnyQuantity, "\"24 ms\"";
    /// a setting for each value
    optional set: Entry<'t> = Kind::List(&Kind::Text), "[\"joint.gudgeon.radial_clearance=0.5mm\"]";
}

record! {
    /// a column of a history
    pub(super) lenient struct ColumnTable for Reads, exactly one of [output, state];
    /// the column of the file
    required column: Entry<'t> = Kind::Text, "\"b3_x\"";
    /// largest accepted absolute difference
    required tolerance: Entry<'t> = Kind::AnyQuantity, "\"1e-8 m\"";
    /// the output of the model
    optional output: Entry<'t> = Kind::Reference("output"), "\"slider\"";
    /// x, y, angle, vx, vy, omega, ax, ay or alpha of a body
    optional state: Entry<'t> = Kind::Text, "\"rod.x\"";
}

record! {
    /// a history to be met
    pub(super) lenient struct HistoryTable for Reads;
    /// rows at equal times, the time in seconds first
    required file: Entry<'t> = Kind::Text, "\"reference.csv\"";
    /// where the history comes from
    required origin: Origin = choice::<Origin>(), "\"peer\"";
    /// the paper or the program
    required source: String = Kind::Text, "\"a program\"";
    /// why the tolerances are what they are
    required reason: String = Kind::Text, "\"agrees with a second run\"";
    /// what is compared
    required columns: Entry<'t> = Kind::List(&Kind::Table(&ColumnTable::KEYS)), "[{ column = \"b3_x\", ... }]";
}

const NUMBER: Kind = Kind::Number { rule: Rule::Finite };

pub(super) const REFERENCE_KEYS: Keys = Keys::new(
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

pub(super) const ENERGY_KEYS: Keys = Keys::new(
    "energies at the end of the run of a script",
    &[
        required("contact_loss_j", NUMBER, "0.01", "lost in normal contact, J"),
        required("friction_loss_j", NUMBER, "0.01", "lost in friction, J"),
        required("drive_work_j", NUMBER, "0.1", "work of the drives, J"),
        required("agreement_j", NUMBER, "1e-10", "with a second run, J"),
        required("residual_j", NUMBER, "1e-12", "of the energy account, J"),
    ],
);

pub(super) const IMPACT_KEYS: Keys = Keys::new(
    "an impact",
    &[
        required("time_s", NUMBER, "1e-3", "when it begins, s"),
        required("speed_m_s", NUMBER, "0.3", "approach speed, m/s"),
        optional("duration_s", NUMBER, "1e-4", "how long it lasts, s"),
        optional("peak_force_n", NUMBER, "1000", "largest normal force, N"),
        optional("separation_speed_m_s", NUMBER, "0.2", "separation speed, m/s"),
    ],
);

pub(super) const JOINT_KEYS: Keys = Keys::new(
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

record! {
    /// what a case must meet
    pub(super) lenient struct ExpectedTable for Reads;
    /// numbers
    optional expected: Entry<'t> = Kind::Tables { keys: &NumberTable::KEYS, except: &[] }, "";
    /// histories
    optional history: Entry<'t> = Kind::Tables { keys: &HistoryTable::KEYS, except: &[] }, "";
    /// the run of a script
    optional reference: Entry<'t> = Kind::Table(&REFERENCE_KEYS), "";
    /// its energies
    optional energy: Entry<'t> = Kind::Table(&ENERGY_KEYS), "";
    /// its joints
    optional joint: Entry<'t> = Kind::Tables { keys: &JOINT_KEYS, except: &[] }, "";
}
