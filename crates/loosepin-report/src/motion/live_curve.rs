//! Curves over the angle of the drive, one at a time, while a mechanism is edited: the charts of the page of the ideal motion.

use serde::{Deserialize, Serialize};

use crate::charts::chart::Chart;
use crate::mechanism::figure::pose_step;
use crate::numbers::number::NumberWriter;
use crate::words::wording::named_words;
use loosepin_result::kinematics::{MechanicalAdvantage, TransmissionAngle};
use loosepin_result::motion::{EffortMotion, MotionRecord};

use super::charts::{
    Derivative, Mover, advantage_chart, mechanical_advantages, motion_chart, movers, transmission_angles,
    transmission_chart, transmission_name,
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
    /// Angle of the drive at each value, degrees; where the time is the input the time, s.
    pub at: Vec<f64>,
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
    /// Its values in the unit of the chart, to six digits, `None` if it is not finite.
    pub values: Vec<Option<f64>>,
}

/// A curve of a record.
#[derive(Clone, Copy)]
enum Curve<'r> {
    Motion(Mover<'r>, Derivative),
    Effort(&'r EffortMotion),
    Angle(&'r TransmissionAngle),
    Advantage(&'r MechanicalAdvantage),
}

/// All of them: of each quantity those of outputs in file order, then those of paths.
fn curves(record: &MotionRecord) -> impl Iterator<Item = Curve<'_>> {
    let of = move |which| movers(record).filter(move |mover| mover.has(which)).map(move |mover| (mover, which));
    let motions = Derivative::ALL.into_iter().flat_map(of).map(|(mover, which)| Curve::Motion(mover, which));
    motions
        .chain(drawn_efforts(record).map(Curve::Effort))
        .chain(transmission_angles(record).map(Curve::Angle))
        .chain(mechanical_advantages(record).map(Curve::Advantage))
}

impl Curve<'_> {
    fn key(self) -> CurveKey {
        let (quantity, of) = match self {
            Curve::Motion(mover, Derivative::Position) => (CurveQuantity::Position, mover.name().to_owned()),
            Curve::Motion(mover, Derivative::Velocity) => (CurveQuantity::Velocity, mover.name().to_owned()),
            Curve::Motion(mover, Derivative::Acceleration) => (CurveQuantity::Acceleration, mover.name().to_owned()),
            Curve::Effort(effort) => (CurveQuantity::Effort, effort.name.clone()),
            Curve::Angle(angle) => (CurveQuantity::TransmissionAngle, transmission_name(angle)),
            Curve::Advantage(each) => (CurveQuantity::MechanicalAdvantage, each.name.clone()),
        };
        CurveKey { quantity, of }
    }

    fn words(self) -> String {
        match self {
            Curve::Motion(mover, _) => mover.named_words(),
            Curve::Effort(effort) => named_words(&effort.name, &effort.words),
            Curve::Angle(angle) if angle.is_pressure_angle => format!("{} (pressure angle)", transmission_name(angle)),
            Curve::Angle(angle) => transmission_name(angle),
            Curve::Advantage(each) => each.name.clone(),
        }
    }

    fn chart(self, record: &MotionRecord, writer: &NumberWriter) -> Option<Chart> {
        match self {
            Curve::Motion(mover, which) => motion_chart(record, mover, which, writer),
            Curve::Effort(effort) => Some(effort_chart(record, effort, writer)),
            Curve::Angle(angle) => Some(transmission_chart(record, angle, writer)),
            Curve::Advantage(each) => Some(advantage_chart(record, each, writer)),
        }
    }
}

/// All curves of a record.
pub fn live_curves(record: &MotionRecord) -> Vec<CurveChoice> {
    curves(record).map(|curve| CurveChoice { key: curve.key(), words: curve.words() }).collect()
}

/// The wanted curve; where nothing has this name, the first curve of its quantity. `None` if the record has none of this quantity.
pub fn live_curve(record: &MotionRecord, wanted: &CurveKey) -> Option<LiveCurve> {
    let of_quantity =
        || curves(record).map(|curve| (curve, curve.key())).filter(|(_, key)| key.quantity == wanted.quantity);
    let (curve, key) = of_quantity().find(|(_, key)| key == wanted).or_else(|| of_quantity().next())?;
    let mut chart = curve.chart(record, &NumberWriter::for_page(&record.display_units))?;
    chart.height = HEIGHT;
    let step = pose_step(record.drive_angle_rad.len());
    let lines = chart.entries.iter().flat_map(|entry| {
        entry.values.lists().into_iter().map(|values| CurveLine {
            words: entry.label.clone(),
            role: entry.role.class(),
            values: values.iter().step_by(step).copied().collect(),
        })
    });
    let all = match &record.time_s[..] {
        [] => record.drive_angle_rad.iter().map(|angle_rad| angle_rad.to_degrees()).collect(),
        times_s => times_s.to_vec(),
    };
    let at = all.into_iter().step_by(step).collect();
    Some(LiveCurve { key, unit: chart.y_symbol.clone(), at, lines: lines.collect(), figure: chart.document() })
}
