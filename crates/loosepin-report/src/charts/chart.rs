//! Charts over one axis: what is in them.

use maud::Markup;
use std::f64::consts::TAU;

use crate::medium::script_data::{rounded, rounded_distinct};
use crate::numbers::number::NumberWriter;
use loosepin_text::units::SiUnit;

/// A turn of a drive, degrees.
pub(crate) const TURN_DEG: f64 = 360.0;
/// What a record names in place of a drive where none turns evenly: the phase of its cycle.
pub(crate) const PHASE: &str = "cycle";
/// A record that begins this share of a turn before a whole number of turns, by round-off, begins at 0°.
const SHARE_OF_TURN: f64 = 1e-9;

/// Whole turns before the recorded part, either way round, rad: charts and drawings count from there. What starts at -20° starts there.
pub(crate) fn turns_before_rad(drive_angle_rad: &[f64]) -> f64 {
    let first_turns = drive_angle_rad.first().copied().unwrap_or_default() / TAU;
    (first_turns + SHARE_OF_TURN.copysign(first_turns)).trunc() * TAU
}

/// Kind of the horizontal axis; decides on the ticks.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum HorizontalAxis {
    /// Angle of a drive: ticks at 30°, 45°, 90°.
    Angle,
    /// Anything else.
    #[default]
    Plain,
}

/// The colour of an entry, by its meaning; the style sheet has the colours for light and dark.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Role {
    Random,
    Mixed,
    Nominal,
    Mean,
    Worst,
    Probability,
    Limit,
    First,
    Second,
    Third,
    Fourth,
    Fifth,
}

impl Role {
    pub fn class(self) -> &'static str {
        match self {
            Role::Random => "random",
            Role::Mixed => "mixed",
            Role::Nominal => "nominal",
            Role::Mean => "mean",
            Role::Worst => "worst",
            Role::Probability => "probability",
            Role::Limit => "limit",
            Role::First => "first",
            Role::Second => "second",
            Role::Third => "third",
            Role::Fourth => "fourth",
            Role::Fifth => "fifth",
        }
    }

    /// The colour of the n-th of several equal curves.
    pub fn of_index(index: usize) -> Role {
        [Role::First, Role::Second, Role::Third, Role::Fourth, Role::Fifth][index % 5]
    }
}

/// Values of one entry, in the units of the chart.
#[derive(Debug, Clone)]
pub(crate) enum EntryValues {
    /// A filled band between two curves.
    Band { lower: Vec<Option<f64>>, upper: Vec<Option<f64>> },
    /// Two curves without a filling.
    Pair { lower: Vec<Option<f64>>, upper: Vec<Option<f64>> },
    /// One curve.
    Line { values: Vec<Option<f64>> },
}

impl EntryValues {
    pub fn band(lower: &[f64], upper: &[f64]) -> Self {
        EntryValues::Band { lower: rounded(lower), upper: rounded(upper) }
    }

    pub fn pair(lower: &[f64], upper: &[f64]) -> Self {
        EntryValues::Pair { lower: rounded(lower), upper: rounded(upper) }
    }

    pub fn line(values: &[f64]) -> Self {
        EntryValues::Line { values: rounded(values) }
    }

    pub fn lists(&self) -> Vec<&Vec<Option<f64>>> {
        match self {
            EntryValues::Band { lower, upper } | EntryValues::Pair { lower, upper } => vec![lower, upper],
            EntryValues::Line { values } => vec![values],
        }
    }

    pub fn lists_mut(&mut self) -> Vec<&mut Vec<Option<f64>>> {
        match self {
            EntryValues::Band { lower, upper } | EntryValues::Pair { lower, upper } => vec![lower, upper],
            EntryValues::Line { values } => vec![values],
        }
    }
}

/// One line of the legend and what it stands for.
#[derive(Debug, Clone)]
pub(crate) struct Entry {
    pub label: String,
    pub role: Role,
    pub dashed: bool,
    pub values: EntryValues,
}

impl Entry {
    pub fn new(label: impl Into<String>, role: Role, dashed: bool, values: EntryValues) -> Entry {
        Entry { label: label.into(), role, dashed, values }
    }

    /// A curve of SI values.
    pub fn line(
        label: &str,
        role: Role,
        dashed: bool,
        values_si: &[f64],
        unit: &SiUnit,
        writer: &NumberWriter,
    ) -> Entry {
        Entry::new(label, role, dashed, EntryValues::line(&scaled(values_si, unit, writer)))
    }
}

/// Single points in the units of the chart, such as peaks between samples.
#[derive(Debug, Clone)]
pub(crate) struct Dots {
    /// The curve that they belong to.
    pub entry: usize,
    pub role: Role,
    pub points: Vec<[f64; 2]>,
}

/// An upright line with a name.
#[derive(Debug, Clone)]
pub(crate) struct Mark {
    pub at: Option<f64>,
    pub label: String,
}

/// One chart.
#[derive(Debug, Clone, Default)]
pub(crate) struct Chart {
    /// Name of the figure, unique in the page.
    pub id: String,
    pub horizontal: HorizontalAxis,
    pub x_label: String,
    pub x_symbol: String,
    pub x: Vec<Option<f64>>,
    pub y_label: String,
    pub y_symbol: String,
    /// Fixed ends of the vertical axis, where it has any.
    pub y_range: Option<[f64; 2]>,
    /// Whether the values of a turn whose last pose is a step before its end come back: curves are then drawn to the end of the turn.
    pub is_periodic: bool,
    pub entries: Vec<Entry>,
    /// Single points beside the curves.
    pub dots: Vec<Dots>,
    /// Upright lines.
    pub marks: Vec<Mark>,
    pub height: u32,
    /// One sentence on the figure, for the caption.
    pub caption: Markup,
    /// Text alternative for readers who cannot see the chart.
    pub alternative: String,
}

/// SI values as the chart shows them.
pub(crate) fn scaled(values_si: &[f64], unit: &SiUnit, writer: &NumberWriter) -> Vec<f64> {
    let display = writer.units.of(unit);
    values_si.iter().map(|value_si| display.from_si(*value_si)).collect()
}

impl Chart {
    /// Over values in SI, without entries and words.
    pub fn over(id: String, x_label: &str, x_si: &[f64], x_unit: &SiUnit, writer: &NumberWriter) -> Chart {
        Chart {
            id,
            x_label: x_label.to_owned(),
            x_symbol: writer.symbol(x_unit),
            x: rounded_distinct(&scaled(x_si, x_unit, writer)),
            height: 300,
            ..Chart::default()
        }
    }

    /// Over angles of a drive.
    pub fn over_angle(id: String, drive: &str, angles_rad: &[f64], writer: &NumberWriter) -> Chart {
        // Then 0° to 360° are one cycle, and the angle of no drive.
        let label = if drive == PHASE { "phase of the cycle".to_owned() } else { format!("angle of {drive}") };
        let chart = Chart::over(id, &label, angles_rad, &SiUnit::ANGLE, writer);
        Chart { horizontal: HorizontalAxis::Angle, ..chart }
    }

    /// Sets the quantity of the vertical axis, with its unit.
    pub fn set_vertical_axis(&mut self, what: impl Into<String>, unit: &SiUnit, writer: &NumberWriter) {
        (self.y_label, self.y_symbol) = (what.into(), writer.symbol(unit));
    }

    /// Whether it is over angles of a drive in degrees: those have ticks of their own, and follow the cursor of the page.
    pub fn is_in_degrees(&self) -> bool {
        self.horizontal == HorizontalAxis::Angle && self.x_symbol == "°"
    }

    /// Whether it is over one turn whose last pose is a step before its end.
    pub fn is_open_turn(&self) -> bool {
        let finite: Vec<f64> = self.x.iter().copied().flatten().collect();
        let ([first, ..], [.., before, last]) = (&finite[..], &finite[..]) else { return false };
        let step = last - before;
        // Poses are rounded to their own digits.
        self.is_in_degrees() && step > 0.0 && (last + step - first - TURN_DEG).abs() < 1e-2 * step
    }

    /// Adds the first pose once more at the end of the turn, where all values come back there: none of them leaps more than from pose to
    /// pose. Says whether it did.
    pub fn close_turn(&mut self) -> bool {
        let comes_back = |list: &&Vec<Option<f64>>| {
            let leap = |from: Option<f64>, to: Option<f64>| Some((to? - from?).abs());
            let largest = list.windows(2).filter_map(|pair| leap(pair[0], pair[1])).fold(0.0, f64::max);
            let [Some(first), Some(last)] = [list.first(), list.last()] else { return false };
            leap(*last, *first).is_some_and(|leap| leap <= largest)
        };
        let lists: Vec<&Vec<Option<f64>>> = self.entries.iter().flat_map(|entry| entry.values.lists()).collect();
        let is_closed = self.is_periodic && self.is_open_turn() && !lists.is_empty() && lists.iter().all(comes_back);
        if is_closed {
            self.x.push(self.x.first().copied().flatten().map(|first| first + TURN_DEG));
            for list in self.entries.iter_mut().flat_map(|entry| entry.values.lists_mut()) {
                list.push(list.first().copied().flatten());
            }
        }
        is_closed
    }
}

#[cfg(test)]
mod tests {
    use super::turns_before_rad;
    use std::f64::consts::TAU;

    #[test]
    fn analytic_whole_turns_before_the_record_count_either_way_round() {
        for (first_deg, turns) in
            [(0.0, 0.0), (60.0, 0.0), (-20.0, 0.0), (420.0, 1.0), (720.0 - 1e-8, 2.0), (-740.0, -2.0), (-720.0, -2.0)]
        {
            assert_eq!(turns_before_rad(&[f64::to_radians(first_deg), 9.0]), turns * TAU, "{first_deg}°");
        }
        assert_eq!(turns_before_rad(&[]), 0.0);
    }
}
