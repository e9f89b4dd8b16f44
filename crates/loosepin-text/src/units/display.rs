//! From SI numbers to the units that people read: mm, degrees, rpm.

use std::borrow::Cow;
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::fmt;

use serde::{Deserialize, Serialize};

use super::{Dimension, ReadableUnit};

/// An SI unit by its symbol, as it stands in files: `m`, `rad`, `m/s`, `kg m^2`, `N/m^1.5`, and `1` for a pure number.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(transparent)]
pub struct SiUnit(Cow<'static, str>);

impl SiUnit {
    /// A pure number: probabilities, restitution, shares, counts.
    pub const NONE: SiUnit = SiUnit(Cow::Borrowed("1"));
    /// Length, m.
    pub const LENGTH: SiUnit = SiUnit(Cow::Borrowed("m"));
    /// Angle, rad.
    pub const ANGLE: SiUnit = SiUnit(Cow::Borrowed("rad"));
    /// Time, s.
    pub const TIME: SiUnit = SiUnit(Cow::Borrowed("s"));
    /// Velocity, m/s.
    pub const VELOCITY: SiUnit = SiUnit(Cow::Borrowed("m/s"));
    /// Acceleration, m/s^2.
    pub const ACCELERATION: SiUnit = SiUnit(Cow::Borrowed("m/s^2"));
    /// Angular velocity, rad/s.
    pub const ANGULAR_VELOCITY: SiUnit = SiUnit(Cow::Borrowed("rad/s"));
    /// Angular acceleration, rad/s^2.
    pub const ANGULAR_ACCELERATION: SiUnit = SiUnit(Cow::Borrowed("rad/s^2"));
    /// Force, N.
    pub const FORCE: SiUnit = SiUnit(Cow::Borrowed("N"));
    /// Moment of a force, N m.
    pub const MOMENT: SiUnit = SiUnit(Cow::Borrowed("N m"));
    /// Energy, J.
    pub const ENERGY: SiUnit = SiUnit(Cow::Borrowed("J"));

    /// The SI unit of `dimension`, `1` for a pure number.
    pub fn of_dimension(dimension: Dimension) -> SiUnit {
        let symbol = dimension.si_unit();
        if symbol.is_empty() { SiUnit::NONE } else { SiUnit::from_symbol(symbol) }
    }

    /// A unit by its SI symbol, for quantities without a constant here.
    pub fn from_symbol(symbol: impl Into<String>) -> SiUnit {
        SiUnit(Cow::Owned(symbol.into()))
    }

    /// The symbol as files write it.
    pub fn symbol(&self) -> &str {
        &self.0
    }

    /// The unit of the time derivative; `None` where this table has no name for it.
    pub fn per_second(&self) -> Option<SiUnit> {
        match self.symbol() {
            "m" => Some(SiUnit::VELOCITY),
            "m/s" => Some(SiUnit::ACCELERATION),
            "rad" => Some(SiUnit::ANGULAR_VELOCITY),
            "rad/s" => Some(SiUnit::ANGULAR_ACCELERATION),
            _ => None,
        }
    }
}

impl fmt::Display for SiUnit {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}

/// How one SI unit is shown to people: shown number = SI number times `per_si`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DisplayUnit {
    /// Text behind the number; empty for a pure number.
    pub symbol: String,
    /// Factor from SI to the shown unit, for example 1000 from m to mm.
    pub per_si: f64,
}

impl DisplayUnit {
    /// The SI number `value_si` in this unit.
    pub fn from_si(&self, value_si: f64) -> f64 {
        value_si * self.per_si
    }
}

/// The units that pages and tables use, by SI symbol. A unit that is not in the table is shown as it is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct DisplayUnits(pub BTreeMap<String, DisplayUnit>);

impl Default for DisplayUnits {
    /// mm, degrees, rpm, s, GPa, and powers written with superscripts.
    fn default() -> Self {
        let degrees = 180.0 / PI;
        let table = [
            ("1", "", 1.0),
            ("m", "mm", 1e3),
            ("rad", "°", degrees),
            ("rad/s", "rpm", 30.0 / PI),
            ("rad/s^2", "rad/s²", 1.0),
            ("m/s^2", "m/s²", 1.0),
            ("kg m^2", "kg m²", 1.0),
            ("kg/m^3", "kg/m³", 1.0),
            ("Pa", "GPa", 1e-9),
        ];
        DisplayUnits(
            table
                .into_iter()
                .map(|(si, symbol, per_si)| (si.to_owned(), DisplayUnit { symbol: symbol.to_owned(), per_si }))
                .collect(),
        )
    }
}

impl DisplayUnits {
    /// Shows numbers of `dimension` in `unit` from now on.
    pub fn set(&mut self, dimension: Dimension, unit: &ReadableUnit) {
        let shown = DisplayUnit { symbol: unit.text.clone(), per_si: 1.0 / unit.si_per_unit };
        self.0.insert(SiUnit::of_dimension(dimension).symbol().to_owned(), shown);
    }

    /// The default table with times in ms where the whole history is shorter than a second.
    pub fn for_duration_s(duration_s: f64) -> Self {
        let mut units = DisplayUnits::default();
        if duration_s < 1.0 {
            units.0.insert("s".to_owned(), DisplayUnit { symbol: "ms".to_owned(), per_si: 1e3 });
        }
        units
    }

    /// How `unit` is shown.
    pub fn of(&self, unit: &SiUnit) -> DisplayUnit {
        self.0
            .get(unit.symbol())
            .cloned()
            .unwrap_or_else(|| DisplayUnit { symbol: unit.symbol().to_owned(), per_si: 1.0 })
    }
}
