//! Numbers of the mechanism without play, and of the quasi-static answer.

use super::case::{Case, CheckInstant, ExpectedNumber, Quantity, QuantityKind, Reduce};
use super::problem::CaseProblem;
use loosepin_mechanics::mechanism::{Mechanism, Sample, SampleError};
use loosepin_mechanics::model::Values;
use loosepin_simulate::accuracy::{MotionPlan, motion, motion_with_worst_cases};
use loosepin_simulate::{Arms, IdealReference, RunFailure, Settings, input, maximum_within};
use loosepin_text::diagnostics::{Diagnostic, Place};

/// Positions of a turn at which an extreme is looked for before it is located.
const LOOKS: usize = 720;
/// Positions of a turn of the quasi-static answer: every degree.
const POSITIONS: usize = 360;

/// An output of the mechanism without play: at an instant, or reduced over a turn.
pub(super) fn ideal_output(
    mechanism: &Mechanism,
    values: &Values,
    quantity: &Quantity,
    number: &ExpectedNumber,
) -> Result<f64, RunFailure> {
    let input = input(mechanism, values, mechanism.model.cycle.span)?;
    let output = IdealOutput::new(mechanism, values, quantity)?;
    match (quantity.reduce, number.at) {
        (None, Some(CheckInstant::Angle(angle_rad))) => output.at((angle_rad - input.start_rad) / input.speed_rad_s),
        (None, Some(CheckInstant::Time(time_s))) => output.at(time_s),
        (None, Some(CheckInstant::Penetration(_)) | None) => output.at(0.0),
        (Some(reduce), _) => {
            let sign = if matches!(reduce, Reduce::Minimum | Reduce::AngleOfMinimum) { -1.0 } else { 1.0 };
            output.extreme(input.turn_s(), sign).map(|[value_si, time_s]| match reduce {
                Reduce::Minimum | Reduce::Maximum => value_si,
                Reduce::AngleOfMinimum | Reduce::AngleOfMaximum => input.angle_rad(time_s),
            })
        }
    }
}

/// The ideal motion, read through one output.
struct IdealOutput<'q> {
    ideal: Mechanism,
    sample: Sample<f64>,
    arms: Arms,
    quantity: &'q Quantity,
}

impl<'q> IdealOutput<'q> {
    fn new(mechanism: &Mechanism, values: &Values, quantity: &'q Quantity) -> Result<Self, SampleError> {
        let sample = Sample::new(mechanism, values)?.without_play();
        Ok(Self { ideal: mechanism.without_play(), sample, arms: Arms::new(mechanism, values), quantity })
    }

    fn reference(&self, end_s: f64) -> Result<IdealReference<'_>, RunFailure> {
        IdealReference::new(&self.ideal, &self.sample, end_s, &Settings::for_simulation())
    }

    fn at(&self, time_s: f64) -> Result<f64, RunFailure> {
        Ok(self.read(&mut self.reference(time_s)?, time_s)?)
    }

    fn read(&self, reference: &mut IdealReference<'_>, time_s: f64) -> Result<f64, SampleError> {
        let dynamics = reference.at(time_s, true)?;
        Ok(self.quantity.column.as_ref().map_or(f64::NAN, |column| column.reading.value(&self.arms, dynamics)))
    }

    /// The largest value of `sign` times the output in a turn, the first of equal ones: the output there, and the time, s.
    fn extreme(&self, turn_s: f64, sign: f64) -> Result<[f64; 2], RunFailure> {
        /// Share of the range within which two extremes of a turn count as equal: a symmetric motion has each twice, and
        /// round-off must not choose.
        const EQUAL: f64 = 1e-9;
        let mut reference = self.reference(turn_s)?;
        let time = |look: usize| turn_s * look as f64 / LOOKS as f64;
        let mut points = Vec::with_capacity(LOOKS + 1);
        for look in 0..=LOOKS {
            points.push((time(look), sign * self.read(&mut reference, time(look))?));
        }
        let (low, high) = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p.1), h.max(p.1)));
        let first = points.iter().position(|point| point.1 >= high - EQUAL * (high - low)).unwrap_or(0);
        let around = &points[first.saturating_sub(1)..(first + 2).min(points.len())];
        let peak = maximum_within(around, |time_s| {
            self.read(&mut reference, time_s).map_or(f64::NEG_INFINITY, |value_si| sign * value_si)
        });
        Ok([sign * peak.value, peak.time_s])
    }
}

/// Worst case of the play, its first-order sum, or standard deviation of what scatters to first order, at an angle of the drive.
pub(super) fn quasi_static(
    case: &Case,
    values: &Values,
    mechanism: &Mechanism,
    quantity: &Quantity,
    number: &ExpectedNumber,
    place: &Place,
) -> Result<f64, Diagnostic> {
    let plan = MotionPlan {
        span: case.model.cycle.span,
        positions: POSITIONS,
        scatter: case.scatter.clone(),
        correlations: case.correlations.clone(),
        paths: Vec::new(),
        asked: Vec::new(),
        overrides: Vec::new(),
    };
    let of = match quantity.kind {
        QuantityKind::WorstCase => motion_with_worst_cases,
        _ => motion,
    };
    let record = of(mechanism, values, &plan).map_err(|error| error.diagnostic(&case.model))?;
    let Some(CheckInstant::Angle(angle_rad)) = number.at else { return Ok(f64::NAN) };
    /// An angle counts as that of a position to round-off of a turn, rad.
    const SAME_ANGLE_RAD: f64 = 1e-9;
    let Some(position) = record.drive_angle_rad.iter().position(|known| (known - angle_rad).abs() < SAME_ANGLE_RAD)
    else {
        let angle_deg = angle_rad.to_degrees().to_string();
        return Err(Diagnostic::error(&CaseProblem::NoPosition { angle_deg }, Some(place.clone())));
    };
    let name = quantity.column.as_ref().map(|column| &column.name);
    let output = record.outputs.iter().find(|output| Some(&output.name) == name);
    let series = output.map(|output| match quantity.kind {
        QuantityKind::WorstCase => &output.clearance.worst_case_si,
        QuantityKind::FirstOrderPlay => &output.clearance.first_order_si,
        _ => &output.dimensional_standard_deviation_si,
    });
    Ok(series.and_then(|series| series.get(position)).copied().unwrap_or(f64::NAN))
}
