//! The tables that `cases/oracle` writes: everything in SI, the tolerances here.
//!
//! The script knows how well two of its own runs agree, not what another program must reach; that is the same for all cases.

use std::path::Path;

use super::case::{
    Case, Check, CheckSubject, ComputedColumn, ExpectedNumber, History, ImpactNumber, Impacts, Numbers, Quantity,
    QuantityKind,
};
use super::dimension::{si_unit, stiffness_dimension};
use super::problem::CaseProblem;
use super::reference::open_reference;
use super::tables::{ENERGY_KEYS, ExpectedTable, IMPACT_KEYS, JOINT_KEYS, REFERENCE_KEYS};
use loosepin_text::diagnostics::Place;
use loosepin_text::document::{Reader, Table};
use loosepin_text::units::{Dimension, ReadableUnit, decimal_exponent, power_of_ten};

/// Positions (m) and angles (rad) at every row. The plays are 1e-4 m and more, and the script agrees with itself to 1e-11 m.
const POSITION_TOLERANCE_M: f64 = 1e-8;
/// Velocities at every row, m/s and rad/s: in contact a time shift of 1e-9 s at accelerations of 1e5 m/s² is 1e-4 m/s; ten times
/// that.
const VELOCITY_TOLERANCE_M_S: f64 = 1e-3;
/// Onsets, s: what a position of 1e-9 m is at an impact of 0.1 m/s. Contacts last 1e-5 s and more.
const ONSET_TOLERANCE_S: f64 = 1e-8;
/// Approach and separation speeds, m/s: flight lasts longer than contact, and its accelerations are a hundredth.
const SPEED_TOLERANCE_M_S: f64 = 1e-5;
/// Peak forces over the largest one of the joint, rounded up to a power of ten: a position of 1e-10 m of a penetration of 1e-5 m.
const FORCE_SHARE: f64 = 1e-5;
/// Energies over the largest of the account, rounded up to a power of ten: as many digits as positions have.
const ENERGY_SHARE: f64 = 1e-6;
/// Stiffnesses over their value, rounded up to a power of ten: a closed form in double precision, given with twelve digits.
const STIFFNESS_SHARE: f64 = 1e-10;
/// Residual of our energy account over the largest energy exchanged.
const RESIDUAL_SHARE: f64 = 1e-8;

const FILE: &str = "reference.csv";

/// Reads the tables of a script, where the file has them.
pub(super) fn read_script(reader: &mut Reader, root: &ExpectedTable<'_>, folder: &Path, case: &Case) -> Vec<Check> {
    let Some(entry) = &root.reference else { return Vec::new() };
    let Some(table) = reader.table(entry, &REFERENCE_KEYS) else { return Vec::new() };
    let source = table.get("source").and_then(|entry| reader.text(&entry)).unwrap_or_default();
    // The script writes the origin in front of its source.
    let source = source.strip_prefix("peer: ").unwrap_or(source).to_owned();
    let place = reader.place(entry.key_span);
    let Some(reference) = open_reference(reader, folder, FILE, entry.key_span) else { return Vec::new() };
    let span_s = reference.span_s();
    let mut found = Found { source, checks: Vec::new(), place, span_s };

    let bodies = case.model.bodies.len() - 1;
    for (name, first, tolerance_si, unit) in [
        ("positions of all bodies", 0, POSITION_TOLERANCE_M, Dimension::LENGTH),
        ("velocities of all bodies", 3 * bodies, VELOCITY_TOLERANCE_M_S, Dimension::VELOCITY),
    ] {
        let columns = (first..first + 3 * bodies).map(|index| (1 + index, ComputedColumn::State(index))).collect();
        if reference.columns.len() < 1 + 9 * bodies {
            let problem = CaseProblem::BadRow { found: reference.columns.len(), due: 1 + 9 * bodies };
            reader.report(&problem, entry.key_span);
            return Vec::new();
        }
        let history = History { reference: reference.clone(), columns, tolerance_si, unit: si_unit(unit) };
        found.push(name.to_owned(), CheckSubject::History(history));
    }
    if let Some(table) = root.energy.as_ref().and_then(|entry| reader.table(entry, &ENERGY_KEYS)) {
        found.energies(reader, &table);
    }
    found.residual();
    for entry in root.joint.as_ref().map(|entry| reader.named(entry, "a joint")).unwrap_or_default() {
        let Some(table) = reader.table(&entry, &JOINT_KEYS) else { continue };
        let name_of = |play: usize| case.model.play_name(case.mechanism.plays[play]);
        match (0..case.mechanism.plays.len()).find(|&play| name_of(play) == entry.name) {
            Some(play) => found.joint(reader, &table, entry.name, play, case),
            None => {
                let known = (0..case.mechanism.plays.len()).map(|play| name_of(play).to_owned()).collect();
                let (what, name) = ("joint with play", entry.name.to_owned());
                let problem = CaseProblem::UnknownName { entry: entry.path.describe(), what, name, known };
                reader.report(&problem, entry.key_span);
            }
        }
    }
    found.checks
}

/// What was read so far.
struct Found {
    source: String,
    checks: Vec<Check>,
    place: Place,
    span_s: f64,
}

impl Found {
    fn push(&mut self, name: String, what: CheckSubject) {
        let (source, place) = (self.source.clone(), self.place.clone());
        self.checks.push(Check { name, origin: "peer", source, place, what });
    }

    /// A number with its tolerance, both SI.
    fn number(
        &mut self,
        name: &str,
        kind: QuantityKind,
        play: Option<usize>,
        [value_si, tolerance_si]: [f64; 2],
        dimension: Dimension,
    ) {
        let quantity = Quantity { kind, play, column: None, reduce: None, span_s: self.span_s };
        let numbers = vec![ExpectedNumber { value_si, settings: Vec::new(), at: None, words: None }];
        // A moment and an energy have the same dimension; here it is always an energy.
        let is_energy = dimension == Dimension::TORQUE;
        let unit = if is_energy { joule() } else { si_unit(dimension) };
        self.push(name.to_owned(), CheckSubject::Numbers(Numbers { quantity, numbers, tolerance_si, unit }));
    }

    /// Of our own account, which no other program needs to know.
    fn residual(&mut self) {
        let number = [0.0, RESIDUAL_SHARE];
        self.number("energy residual", QuantityKind::EnergyResidual, None, number, Dimension::NUMBER);
        if let Some(check) = self.checks.last_mut() {
            (check.origin, check.source) = ("analytic", "energy is kept".to_owned());
        }
    }

    fn energies(&mut self, reader: &mut Reader, table: &Table<'_>) {
        let kinds = [
            ("contact_loss_j", "contact loss", QuantityKind::ContactLoss),
            ("friction_loss_j", "friction loss", QuantityKind::FrictionLoss),
            ("drive_work_j", "drive work", QuantityKind::DriveWork),
        ];
        // A number stays with its name, whichever of them are written.
        let written = kinds.into_iter().filter_map(|(key, name, kind)| Some((name, kind, reader.number(table, key)?)));
        let written: Vec<(&str, QuantityKind, f64)> = written.collect();
        let largest_j = written.iter().fold(0.0_f64, |largest, (_, _, value_j)| largest.max(value_j.abs()));
        for (name, kind, value_j) in written {
            self.number(name, kind, None, [value_j, power_of_ten_above(ENERGY_SHARE * largest_j)], Dimension::TORQUE);
        }
    }

    fn joint(&mut self, reader: &mut Reader, table: &Table<'_>, joint: &str, play: usize, case: &Case) {
        if let Some(stiffness) = reader.number(table, "stiffness_n_m_n") {
            let (name, tolerance) = (format!("{joint}: stiffness"), power_of_ten_above(STIFFNESS_SHARE * stiffness));
            let dimension = stiffness_dimension(case, play);
            self.number(&name, QuantityKind::ContactStiffness, Some(play), [stiffness, tolerance], dimension);
        }
        if let Some(onsets) = reader.number(table, "onsets") {
            let name = format!("{joint}: contacts");
            self.number(&name, QuantityKind::Contacts, Some(play), [onsets, 0.0], Dimension::NUMBER);
        }
        let Some(entries) = table.get("impact").and_then(|entry| reader.list(&entry)) else { return };
        let impacts: Vec<Table<'_>> = entries.iter().filter_map(|entry| reader.table(entry, &IMPACT_KEYS)).collect();
        let slowest_m_s = case.sample.plays[play].minimum_impact_speed_m_s;
        // Contacts below the least impact speed of the law are no impacts.
        let impacts: Vec<Table<'_>> = impacts
            .into_iter()
            .filter(|impact| reader.number(impact, "speed_m_s").is_some_and(|speed_m_s| speed_m_s >= slowest_m_s))
            .collect();
        let peak_n = reader.number(table, "peak_force_n").unwrap_or(0.0);
        for (key, words, of, tolerance_si, dimension) in [
            ("time_s", "onsets", ImpactNumber::Onset, ONSET_TOLERANCE_S, Dimension::TIME),
            ("speed_m_s", "impact speeds", ImpactNumber::Speed, SPEED_TOLERANCE_M_S, Dimension::VELOCITY),
            (
                "peak_force_n",
                "peak forces",
                ImpactNumber::PeakForce,
                power_of_ten_above(FORCE_SHARE * peak_n),
                Dimension::FORCE,
            ),
            (
                "separation_speed_m_s",
                "separation speeds",
                ImpactNumber::SeparationSpeed,
                SPEED_TOLERANCE_M_S,
                Dimension::VELOCITY,
            ),
        ] {
            let listed = impacts.iter().map(|impact| reader.number(impact, key).unwrap_or(f64::NAN));
            let mut expected_si: Vec<f64> = listed.collect();
            // The last contact may not have ended; its end is then not listed. Any other gap is a difference.
            expected_si.pop_if(|last| last.is_nan());
            if !expected_si.is_empty() {
                let (span_s, unit) = (self.span_s, si_unit(dimension));
                let impacts = Impacts { play, of, expected_si, tolerance_si, span_s, unit };
                self.push(format!("{joint}: {words}"), CheckSubject::Impacts(impacts));
            }
        }
    }
}

/// The unit of energies.
fn joule() -> ReadableUnit {
    ReadableUnit { text: "J".to_owned(), si_per_unit: 1.0 }
}

/// The least power of ten that is not below a positive number; zero for zero.
fn power_of_ten_above(value: f64) -> f64 {
    decimal_exponent(value).map_or(value, |exponent| {
        let below = power_of_ten(exponent);
        if below >= value { below } else { power_of_ten(exponent + 1) }
    })
}

#[cfg(test)]
mod tests {
    use super::power_of_ten_above;

    #[test]
    fn tolerances_are_powers_of_ten_that_are_not_below() {
        for (value, power) in [(1e-5, 1e-5), (1.01e-5, 1e-4), (9.9, 10.0), (0.0, 0.0)] {
            assert_eq!(power_of_ten_above(value), power, "{value:e}");
        }
    }
}
