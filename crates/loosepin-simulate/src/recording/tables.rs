//! The CSV files of a run, SI.

use crate::recording::history::BodyStates;
use loosepin_result::simulation::{OutputHistory, SimulationRecord, Spectrum};
use loosepin_text::diagnostics::{Code, problems};
use std::borrow::Cow;
use std::fmt::Write;

/// A column of `history.csv` or `motion.csv`.
#[derive(Debug, Clone, PartialEq)]
pub struct HistoryColumn<'s> {
    /// Its name, with the unit: `slider_m`. No two columns have the same.
    pub name: String,
    /// Its SI unit, for example `m/s^2`.
    pub unit: &'s str,
    /// Its values, SI, one for each sample.
    pub values_si: Cow<'s, [f64]>,
}

/// The columns of `history.csv`: the time, the angle of the drive, the outputs in file order, then for each output that has an ideal
/// value this value and the deviation from it, then the states of all bodies where they were recorded.
pub fn history_columns<'s>(record: &'s SimulationRecord, states: Option<&'s BodyStates>) -> Vec<HistoryColumn<'s>> {
    let mut columns = Vec::new();
    add(&mut columns, "time_s".to_owned(), "s", &record.time_s);
    add(&mut columns, format!("{}_rad", record.settings.drive), "rad", &record.drive_angle_rad);
    let name = |output: &OutputHistory, what: &str| {
        format!("{}{what}{}", output.name.replace(' ', "_"), unit_suffix(output.unit.symbol()))
    };
    for output in &record.outputs {
        add(&mut columns, name(output, ""), output.unit.symbol(), &output.value_si);
    }
    for output in &record.outputs {
        for (what, values_si) in [("_ideal", &output.ideal_si), ("_deviation", &output.deviation_si)] {
            if !values_si.is_empty() {
                add(&mut columns, name(output, what), output.unit.symbol(), values_si);
            }
        }
    }
    if let Some(states) = states {
        let parts = [
            [("x_m", "m"), ("y_m", "m"), ("angle_rad", "rad")],
            [("vx_m_s", "m/s"), ("vy_m_s", "m/s"), ("omega_rad_s", "rad/s")],
            [("ax_m_s2", "m/s^2"), ("ay_m_s2", "m/s^2"), ("alpha_rad_s2", "rad/s^2")],
        ];
        let named =
            parts.iter().flat_map(|parts| states.bodies.iter().flat_map(move |body| parts.map(|part| (body, part))));
        for (index, (body, (part, unit))) in named.enumerate() {
            let values_si = states.rows.iter().map(|row| row[index]).collect();
            columns.push(HistoryColumn { name: format!("{body}.{part}"), unit, values_si: Cow::Owned(values_si) });
        }
    }
    columns
}

/// Adds a column of an output or before them; a name that is taken gets a further word.
pub(super) fn add<'s>(columns: &mut Vec<HistoryColumn<'s>>, mut name: String, unit: &'s str, values_si: &'s [f64]) {
    while columns.iter().any(|column| column.name == name) {
        name.push_str("_output");
    }
    columns.push(HistoryColumn { name, unit, values_si: Cow::Borrowed(values_si) });
}

/// `history.csv`: the [`history_columns`], one row a sample.
pub fn history_csv(record: &SimulationRecord, states: Option<&BodyStates>) -> String {
    table(&history_columns(record, states), record.time_s.len())
}

/// Columns as comma-separated values with their names above.
pub(super) fn table(columns: &[HistoryColumn<'_>], rows: usize) -> String {
    let names: Vec<&str> = columns.iter().map(|column| column.name.as_str()).collect();
    let mut text = names.join(",");
    text.push('\n');
    for row in 0..rows {
        for (index, column) in columns.iter().enumerate() {
            let _ = write!(text, "{}{:?}", if index > 0 { "," } else { "" }, column.values_si[row]);
        }
        text.push('\n');
    }
    text
}

/// Numbers of a body in a row of [`BodyStates`].
const NUMBERS_OF_A_BODY: usize = 9;

problems! {
    /// Why the text of a `history.csv` is not that of a run.
    #[derive(Debug, Clone, PartialEq, Eq)]
    pub enum HistoryError {
        /// Columns of bodies that do not come in groups.
        Columns { found: usize } => Code::NoResults,
            says("it has {found} columns of bodies; must be nine for each");
        /// A row that is no row of numbers.
        Row { row: usize } => Code::NoResults,
            says("row {row} is not a row of numbers");
        /// Other rows than those of the summary.
        Rows { found: usize, expected: usize } => Code::NoResults,
            says("it has {found} rows; must be {expected}, as in the summary");
    }
}

/// The states of bodies in the text of the `history.csv` of `record`; `None` if they were not recorded.
///
/// # Errors
/// The text is not what [`history_csv`] writes.
pub fn body_states_of_csv(text: &str, record: &SimulationRecord) -> Result<Option<BodyStates>, HistoryError> {
    let others = history_columns(record, None).len();
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap_or_default().split(',').skip(others).collect();
    if names.is_empty() {
        return Ok(None);
    }
    let of_positions = names[..names.len() / 3].iter();
    let bodies: Vec<String> = of_positions.filter_map(|name| name.strip_suffix(".x_m")).map(str::to_owned).collect();
    if bodies.len() * NUMBERS_OF_A_BODY != names.len() {
        return Err(HistoryError::Columns { found: names.len() });
    }
    let row = |(row, line): (usize, &str)| {
        let numbers: Result<Vec<f64>, _> = line.split(',').skip(others).map(str::parse).collect();
        numbers.ok().filter(|numbers| numbers.len() == names.len()).ok_or(HistoryError::Row { row: row + 1 })
    };
    let rows = lines.enumerate().map(row).collect::<Result<Vec<_>, _>>()?;
    if rows.len() != record.time_s.len() {
        return Err(HistoryError::Rows { found: rows.len(), expected: record.time_s.len() });
    }
    Ok(Some(BodyStates { bodies, rows }))
}

/// `impacts.csv`: one impact a row, in the order of time. An empty separation speed: the run ended in contact.
pub fn impacts_csv(record: &SimulationRecord) -> String {
    let mut text = String::from("time_s,joint,speed_m_s,duration_s,peak_force_n,separation_speed_m_s\n");
    for impact in &record.impacts {
        let _ = write!(text, "{:?},{},{:?},", impact.time_s, impact.joint, impact.speed_m_s);
        let _ = write!(text, "{:?},{:?},", impact.duration_s, impact.peak_force_n);
        if let Some(speed_m_s) = impact.separation_speed_m_s {
            let _ = write!(text, "{speed_m_s:?}");
        }
        text.push('\n');
    }
    text
}

/// A column of `spectrum.csv`.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumColumn<'r> {
    /// Its name, with the unit: `slider_m`, `gudgeon.contact_force_n`.
    pub name: String,
    /// The output, `slider`, or the normal force of a contact, `gudgeon.contact_force`.
    pub of: String,
    /// SI unit of its amplitudes.
    pub unit: &'r str,
    /// Its numbers; all columns of a run have the same orders.
    pub spectrum: Spectrum,
}

/// The columns of `spectrum.csv`: the outputs in file order, then the contact forces; none where no drive turns at constant speed or less
/// than a turn was recorded.
pub fn spectrum_columns(record: &SimulationRecord) -> Vec<SpectrumColumn<'_>> {
    let outputs = record.outputs.iter().filter_map(|output| {
        let (of, unit) = (output.name.clone(), output.unit.symbol());
        let name = format!("{}{}", of.replace(' ', "_"), unit_suffix(unit));
        Some(SpectrumColumn { name, of, unit, spectrum: record.spectrum(&output.value_si)? })
    });
    let forces = record.contact_forces.iter().filter_map(|history| {
        let of = format!("{}.contact_force", history.joint);
        Some(SpectrumColumn { name: format!("{of}_n"), of, unit: "N", spectrum: record.spectrum(&history.force_n)? })
    });
    outputs.chain(forces).collect()
}

/// `spectrum.csv`: the orders of the drive, one a row, and the amplitude of each output there ([`Spectrum`]); absent where there are no
/// [`spectrum_columns`].
pub fn spectrum_csv(record: &SimulationRecord) -> Option<String> {
    let columns = spectrum_columns(record);
    let orders = &columns.first()?.spectrum.orders;
    let mut text = String::from("order");
    columns.iter().for_each(|column| text.extend([",", &column.name]));
    text.push('\n');
    for (row, order) in orders.iter().enumerate() {
        let _ = write!(text, "{order:?}");
        for column in &columns {
            let _ = write!(text, ",{:?}", column.spectrum.amplitudes_si[row]);
        }
        text.push('\n');
    }
    Some(text)
}

/// The unit as a suffix of a column name: `m/s^2` becomes `_m_s2`.
pub(super) fn unit_suffix(symbol: &str) -> String {
    let plain: String = symbol
        .chars()
        .filter(|c| *c != '^')
        .map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' })
        .collect();
    if symbol == "1" { String::new() } else { format!("_{plain}") }
}
