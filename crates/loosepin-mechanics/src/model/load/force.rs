//! A force on a point of a body.

use super::course::TimeCourse;
use super::kind::{ActsOn, Direction, KindOfLoad, LoadPlace, Push};
use super::size::{JOINT, Oscillation, PointsOfLoad, SizeKeys, SizeTable};
use crate::model::ids::PointId;
use crate::model::part_reader::{DeferredQuantity, PartReader};
use crate::model::parts::table_curve::POINTS;
use crate::model::words::part_names::Names;
use loosepin_math::{Real, Vec2, sin_cos};
use loosepin_text::document::{Entry, Keys, Kind, Table, choice, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::units::{Dimension, Rule};
use loosepin_text::{choices, record};

/// A force on a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ForceLoad {
    /// The point.
    pub point: PointId,
    /// Its direction.
    pub direction: Direction,
}

impl KindOfLoad for ForceLoad {
    const WORD: &'static str = ForceTable::WORD;
    const KEYS: &'static Keys = &ForceTable::KEYS;
    const SIZE: Option<SizeKeys> = Some(SizeKeys {
        key: "force",
        dimension: Dimension::FORCE,
        harmonic: |reader, entry| {
            let HarmonicForce { mean, amplitude, at: Oscillation { frequency, phase, .. }, .. } =
                HarmonicForce::read(reader, entry)?;
            Some(TimeCourse::Harmonic { mean, amplitude, frequency, phase_rad: phase })
        },
    });

    fn read<'t>(table: Table<'t>, reader: &mut dyn PartReader) -> (Option<Self>, Option<SizeTable<'t>>) {
        let Some(own) = ForceTable::of(reader, table) else { return (None, None) };
        let direction = own.direction.zip(own.frame);
        let kind = own.point.zip(direction).map(|(point, (angle_rad, FollowsBody(follows_body)))| Self {
            point,
            direction: Direction { angle_rad, follows_body },
        });
        let ForceTable { table, force: size, joint, points, rest, area, back_pressure, .. } = own;
        (kind, Some(SizeTable { table, size, joint, points, rest, pressures: Some((area, back_pressure)) }))
    }

    fn acts_on(&self) -> ActsOn {
        ActsOn::Point(self.point)
    }

    fn direction(&self) -> Option<Direction> {
        Some(self.direction)
    }

    /// x and y of its direction, of length one, in the frame of the ground or of the body.
    fn numbers(&self, number: &dyn Fn(QuantityId) -> f64) -> Vec<f64> {
        let (sine, cosine) = sin_cos(number(self.direction.angle_rad));
        vec![cosine, sine]
    }

    #[inline(always)]
    fn push<T: Real>(&self, numbers: &[T], size: T, place: &impl LoadPlace<T>) -> Push<T> {
        let direction = Vec2::new(numbers[0], numbers[1]);
        let direction = if self.direction.follows_body { place.turned(direction) } else { direction };
        let arm_m = place.arm_m();
        Push { arm_m, force_n: direction * size, torque_n_m: T::zero() }
    }

    fn words(&self, names: &dyn Names, size: &str) -> String {
        let frame = if self.direction.follows_body { "of the body's x axis" } else { "from the x axis" };
        format!("force on {}: {size}, {} {frame}", names.point(self.point), names.quantity(self.direction.angle_rad))
    }
}

choices!(
    /// Whether a direction turns with the body.
    struct FollowsBody(bool): "ground" => false, "body" => true
);

record! {
    /// a harmonic force: mean + amplitude sin(360 deg frequency time + phase)
    struct HarmonicForce for PartReader;
    /// mean force
    optional mean: QuantityId = quantity(Dimension::FORCE, Rule::Finite), "\"0 N\"", or "0 N";
    /// amplitude: largest distance from the mean
    required amplitude: QuantityId = quantity(Dimension::FORCE, Rule::Finite), "\"5 N\"";
    include at: Oscillation<'t>;
}

record! {
    /// a force on a point of a body
    struct ForceTable for PartReader, kind "force" of load, exactly one of [force, points, csv];
    /// the point on which the force acts
    required point: Option<PointId> = Kind::Point, "\"rocker.tip\"";
    /// size of the force: constant, an expression over time, or a table with amplitude and frequency
    optional force: Entry<'t> =
        Kind::AnyOf(&[quantity(Dimension::FORCE, Rule::Finite), Kind::Table(&HarmonicForce::KEYS)]), "\"10 N\"";
    /// angle of the force from the x axis
    required direction: Option<QuantityId> = quantity(Dimension::ANGLE, Rule::Finite), "\"-90 deg\"";
    /// frame of this x axis: that of the ground, or that of the body, so that the force turns with the body
    optional frame: Option<FollowsBody> = choice::<FollowsBody>(), "\"ground\"", or "ground";
    optional joint: Entry<'t> as JOINT;
    /// instead of force: pairs of the variable named by `of` and the force, or with an area the pressure; the variable increases
    optional points: Entry<'t> = POINTS, "[[\"0 deg\", \"40 N\"], [\"90 deg\", \"65 N\"], [\"270 deg\", \"10 N\"]]";
    include rest: PointsOfLoad<'t>;
    /// with points or csv: the points are pressures on this area; the force is (pressure - back_pressure) area
    optional area: Entry<'t> = quantity(Dimension::AREA, Rule::Positive), "\"50 cm^2\"";
    /// with area: the pressure on its other side
    optional back_pressure: DeferredQuantity<'t> = quantity(Dimension::PRESSURE, Rule::Finite), "\"1 bar\"", or "0 Pa";
}
