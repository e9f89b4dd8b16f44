//! A force on a point of a body.

use super::kind::{ActsOn, Direction, KindOfLoad, LoadPlace, Push};
use super::size::{CURVE, FREQUENCY, JOINT, OF, PERIOD, PHASE, SizeKeys};
use crate::model::ids::PointId;
use crate::model::keys::table::CSV;
use crate::model::part_names::Names;
use crate::model::part_reader::PartReader;
use crate::model::quantity::QuantityId;
use loosepin_math::{Real, Vec2, sin_cos};
use loosepin_text::document::{Keys, Kind, Table, optional, quantity, required};
use loosepin_text::units::{Dimension, Rule};

/// A force on a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ForceLoad {
    /// The point.
    pub point: PointId,
    /// Its direction.
    pub direction: Direction,
}

impl KindOfLoad for ForceLoad {
    const WORD: &'static str = "force";
    const KEYS: &'static Keys = &KEYS;
    const SIZE: Option<SizeKeys> =
        Some(SizeKeys { key: "force", dimension: Dimension::FORCE, harmonic: &HARMONIC_KEYS, takes_pressures: true });

    fn read(table: &Table<'_>, reader: &mut dyn PartReader) -> Option<Self> {
        let point = table.get("point").and_then(|entry| reader.point(&entry));
        let angle_rad = reader.quantity(table, "direction");
        let follows_body = match table.get("frame") {
            Some(entry) => reader.document().choice(&entry, &[("ground", false), ("body", true)]),
            None => Some(false),
        };
        let direction = Direction { angle_rad: angle_rad?, follows_body: follows_body? };
        Some(Self { point: point?, direction })
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

static HARMONIC_KEYS: Keys = Keys::new(
    "a force that goes up and down: mean + amplitude sin(360 deg frequency time + phase)",
    &[
        optional("mean", quantity(Dimension::FORCE, Rule::Finite), "\"0 N\"", "its middle; 0 N if left out"),
        required("amplitude", quantity(Dimension::FORCE, Rule::Finite), "\"5 N\"", "largest departure from the middle"),
        FREQUENCY,
        PHASE,
    ],
);

static KEYS: Keys = Keys::new(
    "a force on a point of a body",
    &[
        required("kind", Kind::Choice(&["force"]), "\"force\"", "the kind of load"),
        required("point", Kind::Point, "\"rocker.tip\"", "the point that it acts on"),
        optional(
            "force",
            Kind::AnyOf(&[quantity(Dimension::FORCE, Rule::Finite), Kind::Table(&HARMONIC_KEYS)]),
            "\"10 N\"",
            "its size: constant, an expression over time, or a table with amplitude and frequency",
        ),
        required("direction", quantity(Dimension::ANGLE, Rule::Finite), "\"-90 deg\"", "its direction from the x axis"),
        optional(
            "frame",
            Kind::Choice(&["ground", "body"]),
            "\"ground\"",
            "whose x axis: the ground's, if left out, or the body's, with which it then turns",
        ),
        JOINT,
        optional(
            "points",
            Kind::List(&Kind::List(&Kind::AnyQuantity)),
            "[[\"0 deg\", \"40 N\"], [\"90 deg\", \"65 N\"], [\"270 deg\", \"10 N\"]]",
            "in place of force: pairs of what it is over and the force there, or the pressure where there is an area; the first ones \
             increasing",
        ),
        CSV,
        OF,
        PERIOD,
        CURVE,
        optional(
            "area",
            quantity(Dimension::AREA, Rule::Positive),
            "\"50 cm^2\"",
            "beside points or csv: the points are pressures on this area; the force is (pressure - back_pressure) area",
        ),
        optional(
            "back_pressure",
            quantity(Dimension::PRESSURE, Rule::Finite),
            "\"1 bar\"",
            "beside area: the pressure on its other side; 0 Pa if left out",
        ),
    ],
)
.with_exactly_one(&[&["force", "points", "csv"]]);
