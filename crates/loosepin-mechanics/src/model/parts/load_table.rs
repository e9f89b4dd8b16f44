//! Loads given by points.

use crate::model::parts::table_curve::TableCurve;
use loosepin_text::diagnostics::{Code, problems};
use loosepin_text::numbers::{QuantityId, Values};
use loosepin_text::units::{Dimension, format_apart, format_number};

/// Two numbers that differ by less than this share of the larger one are equal: digits of a file and conversions of units.
const SAME: f64 = 1e-9;

/// The size of a load over the time or over the coordinate or the rate of a joint, by points.
///
/// Beyond both ends it keeps the value of the end, or it goes round with its period.
#[derive(Debug, Clone)]
pub struct LoadTable {
    /// Name of the load.
    pub load: String,
    /// Variable: 0 the time, 1 the coordinate of the joint, 2 its rate.
    pub variable: usize,
    /// Arguments, increasing, and forces, torques or pressures.
    pub points: Vec<[QuantityId; 2]>,
    /// How it goes between the points.
    pub curve: TableCurve,
    /// After which it begins again.
    pub period: Option<QuantityId>,
    /// Converts pressures to forces.
    pub piston: Option<Piston>,
    /// Dimensions of the two columns.
    pub dimensions: [Dimension; 2],
}

/// A pressure p presses with (p - p0) A.
#[derive(Debug, Clone, Copy)]
pub struct Piston {
    /// A, m², > 0.
    pub area_m2: QuantityId,
    /// p0, on its other side, Pa.
    pub back_pressure_pa: QuantityId,
}

problems! {
    /// Why a table cannot go round.
    #[derive(Debug, Clone, PartialEq)]
    pub enum PeriodProblem {
        TooShort { load: String, span: f64, period: f64, dimension: Dimension } => Code::TablePeriod,
            says("load '{load}': {}", {
                let [span, period] = shown([*span, *period], *dimension);
                format!("the points span {span}; they must span at most the period of {period}")
            });
        DoesNotClose { load: String, first: f64, last: f64, dimension: Dimension } => Code::TablePeriod,
            says("load '{load}': {}", {
                let [first, last] = shown([*first, *last], *dimension);
                format!("the last point, one period after the first, is {last}; it must be {first}, as the first point")
            }),
            hint("remove the last point: the curve then continues from the point before it to the first point of the next period");
    }
}

impl PeriodProblem {
    /// The load whose table it is.
    pub fn load(&self) -> &str {
        match self {
            Self::TooShort { load, .. } | Self::DoesNotClose { load, .. } => load,
        }
    }
}

/// Values for people, with enough digits to differ; pressures in bar, as diagrams are measured.
fn shown(values_si: [f64; 2], dimension: Dimension) -> [String; 2] {
    if dimension == Dimension::PRESSURE {
        return values_si.map(|pressure_pa| format!("{} bar", format_number(pressure_pa / 1e5)));
    }
    format_apart(values_si, dimension)
}

impl LoadTable {
    /// The points with `values`; of a periodic one from the first point to where it comes again.
    ///
    /// # Errors
    /// The points and the period do not fit.
    pub fn course(&self, values: &Values) -> Result<Vec<[f64; 2]>, PeriodProblem> {
        let mut points: Vec<[f64; 2]> = self.points.iter().map(|point| point.map(|id| values[id])).collect();
        let (Some(period), Some([start, first]), Some([end, last])) =
            (self.period.map(|id| values[id]), points.first().copied(), points.last().copied())
        else {
            return Ok(points);
        };
        let (span, load) = (end - start, || self.load.clone());
        if span > period * (1.0 + SAME) {
            return Err(PeriodProblem::TooShort { load: load(), span, period, dimension: self.dimensions[0] });
        }
        if span >= period * (1.0 - SAME) {
            if (last - first).abs() > SAME * last.abs().max(first.abs()) {
                return Err(PeriodProblem::DoesNotClose { load: load(), first, last, dimension: self.dimensions[1] });
            }
            points.pop();
        }
        points.push([start + period, first]);
        Ok(points)
    }
}
