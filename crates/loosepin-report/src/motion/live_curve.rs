//! Curves over the angle of the drive, one at a time, while a mechanism is edited: the charts of the page of the ideal motion.

use serde::{Deserialize, Serialize};

use crate::charts::chart::Chart;
use crate::mechanism::figure::pose_step;
use crate::numbers::number::NumberWriter;
use crate::words::wording::named_words;
use loosepin_result::motion::MotionRecord;

use super::charts::{
    Derivative, advantage_chart, mechanical_advantages, motion_chart, movers, transmission_angles, transmission_chart,
    transmission_name,
};
use super::efforts::{drawn_efforts, effort_chart};

/// Height of the chart, in units of the picture: that of the live bands.
const HEIGHT: u32 = 200;

/// The quantity of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CurveQuantity {
    /// Position of an output or a point.
    Position,
    /// Its velocity, at the speed of the drive.
    Velocity,
    /// Its acceleration.
    Acceleration,
    /// Force, torque or power of a drive.
    Effort,
    /// Transmission or pressure angle of a loop.
    TransmissionAngle,
    /// Mechanical advantage of an output.
    MechanicalAdvantage,
}

impl CurveQuantity {
    fn derivative(self) -> Option<Derivative> {
        match self {
            CurveQuantity::Position => Some(Derivative::Position),
            CurveQuantity::Velocity => Some(Derivative::Velocity),
            CurveQuantity::Acceleration => Some(Derivative::Acceleration),
            CurveQuantity::Effort | CurveQuantity::TransmissionAngle | CurveQuantity::MechanicalAdvantage => None,
        }
    }
}

/// Identity of a curve.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct CurveKey {
    /// Its quantity.
    pub quantity: CurveQuantity,
    /// Name of the output or the point, or both bodies of a transmission angle: `coupler and rocker`.
    pub of: String,
}

/// A curve that there is.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CurveChoice {
    /// Its identity.
    pub key: CurveKey,
    /// Whose it is, in words.
    pub words: String,
}

/// A curve with its numbers.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LiveCurve {
    /// Its identity.
    pub key: CurveKey,
    /// The chart as an SVG document, with `data-plot`, `data-x` and `data-y` as those of a band.
    pub figure: String,
    /// Unit of the values, as it is shown.
    pub unit: String,
    /// The lines of the chart, in their order.
    pub lines: Vec<CurveLine>,
}

/// A line of a chart.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CurveLine {
    /// Its name: `x`, `magnitude`, `ideal velocity`.
    pub words: String,
    /// Class of its colour.
    pub role: &'static str,
    /// Its values in the unit of the chart, to six digits; one for each pose of the drawing, `None` if it is not finite.
    pub values: Vec<Option<f64>>,
}

/// All curves of a record: of each quantity those of outputs in file order, then those of paths.
pub fn live_curves(record: &MotionRecord) -> Vec<CurveChoice> {
    let choice =
        |quantity, of: &str, words: String| CurveChoice { key: CurveKey { quantity, of: of.to_owned() }, words };
    let mut choices = Vec::new();
    for (quantity, which) in [
        (CurveQuantity::Position, Derivative::Position),
        (CurveQuantity::Velocity, Derivative::Velocity),
        (CurveQuantity::Acceleration, Derivative::Acceleration),
    ] {
        let moving = movers(record).filter(|mover| mover.has(which));
        choices.extend(moving.map(|mover| {
            let words = mover.words();
            let words = if words.contains(mover.name()) { words } else { named_words(mover.name(), &words) };
            choice(quantity, mover.name(), words)
        }));
    }
    choices.extend(
        drawn_efforts(record)
            .map(|effort| choice(CurveQuantity::Effort, &effort.name, named_words(&effort.name, &effort.words))),
    );
    choices.extend(transmission_angles(record).map(|angle| {
        let name = transmission_name(angle);
        let words = if angle.is_pressure_angle { format!("{name} (pressure angle)") } else { name.clone() };
        choice(CurveQuantity::TransmissionAngle, &name, words)
    }));
    choices.extend(
        mechanical_advantages(record)
            .map(|each| choice(CurveQuantity::MechanicalAdvantage, &each.name, each.name.clone())),
    );
    choices
}

/// The wanted curve; where nothing has this name, the first curve of its quantity. `None` if the record has none of this quantity.
pub fn live_curve(record: &MotionRecord, wanted: &CurveKey) -> Option<LiveCurve> {
    let writer = NumberWriter::for_page(&record.display_units);
    let (of, mut chart) = chart_of(record, wanted, &writer)?;
    chart.height = HEIGHT;
    let step = pose_step(record.drive_angle_rad.len());
    let lines = chart.entries.iter().flat_map(|entry| {
        entry.values.lists().into_iter().map(|values| CurveLine {
            words: entry.label.clone(),
            role: entry.role.class(),
            values: values.iter().step_by(step).copied().collect(),
        })
    });
    Some(LiveCurve {
        key: CurveKey { quantity: wanted.quantity, of },
        unit: chart.y_symbol.clone(),
        lines: lines.collect(),
        figure: chart.document(),
    })
}

/// The chart with the name of whose it is.
fn chart_of(record: &MotionRecord, wanted: &CurveKey, writer: &NumberWriter) -> Option<(String, Chart)> {
    let CurveKey { quantity, of } = wanted;
    if let Some(which) = quantity.derivative() {
        let mover = named_or_first(movers(record).filter(|mover| mover.has(which)), |mover| mover.name() == of)?;
        return Some((mover.name().to_owned(), motion_chart(record, mover, which, writer)?));
    }
    match quantity {
        CurveQuantity::Effort => {
            let effort = named_or_first(drawn_efforts(record), |effort| effort.name == *of)?;
            Some((effort.name.clone(), effort_chart(record, effort, writer)))
        }
        CurveQuantity::TransmissionAngle => {
            let angle = named_or_first(transmission_angles(record), |angle| transmission_name(angle) == *of)?;
            Some((transmission_name(angle), transmission_chart(record, angle, writer)))
        }
        CurveQuantity::MechanicalAdvantage => {
            let each = named_or_first(mechanical_advantages(record), |each| each.name == *of)?;
            Some((each.name.clone(), advantage_chart(record, each, writer)))
        }
        CurveQuantity::Position | CurveQuantity::Velocity | CurveQuantity::Acceleration => None,
    }
}

fn named_or_first<T: Copy>(all: impl Iterator<Item = T>, is_named: impl Fn(&T) -> bool) -> Option<T> {
    let mut first = None;
    for each in all {
        if is_named(&each) {
            return Some(each);
        }
        first = first.or(Some(each));
    }
    first
}
