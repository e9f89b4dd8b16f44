//! A torque on a body.

use super::kind::{ActsOn, KindOfLoad, LoadPlace, Push};
use super::size::{CURVE, FREQUENCY, JOINT, OF, PERIOD, PHASE, SizeKeys};
use crate::model::ids::BodyId;
use crate::model::keys::table::CSV;
use crate::model::part_names::Names;
use crate::model::part_reader::PartReader;
use loosepin_math::{Real, Vec2};
use loosepin_text::document::{Keys, Kind, Table, optional, quantity, required};
use loosepin_text::units::{Dimension, Rule};

/// A torque on a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TorqueLoad {
    /// The body.
    pub body: BodyId,
}

impl KindOfLoad for TorqueLoad {
    const WORD: &'static str = "torque";
    const KEYS: &'static Keys = &KEYS;
    const SIZE: Option<SizeKeys> = Some(SizeKeys {
        key: "torque",
        dimension: Dimension::TORQUE,
        harmonic: &HARMONIC_KEYS,
        takes_pressures: false,
    });

    fn read(table: &Table<'_>, reader: &mut dyn PartReader) -> Option<Self> {
        reader.body(&table.get("body")?).map(|body| Self { body })
    }

    fn acts_on(&self) -> ActsOn {
        ActsOn::Body(self.body)
    }

    #[inline(always)]
    fn push<T: Real>(&self, _numbers: &[T], size: T, _place: &impl LoadPlace<T>) -> Push<T> {
        Push { arm_m: Vec2::zero(), force_n: Vec2::zero(), torque_n_m: size }
    }

    fn words(&self, names: &dyn Names, size: &str) -> String {
        format!("torque on {}: {size}", names.body(self.body))
    }
}

static HARMONIC_KEYS: Keys = Keys::new(
    "a torque that goes up and down: mean + amplitude sin(360 deg frequency time + phase)",
    &[
        optional("mean", quantity(Dimension::TORQUE, Rule::Finite), "\"0 N m\"", "its middle; 0 N m if left out"),
        required(
            "amplitude",
            quantity(Dimension::TORQUE, Rule::Finite),
            "\"0.2 N m\"",
            "largest departure from the middle",
        ),
        FREQUENCY,
        PHASE,
    ],
);

static KEYS: Keys = Keys::new(
    "a torque on a body",
    &[
        required("kind", Kind::Choice(&["torque"]), "\"torque\"", "the kind of load"),
        required("body", Kind::Reference("body"), "\"rocker\"", "the body that it acts on"),
        optional(
            "torque",
            Kind::AnyOf(&[quantity(Dimension::TORQUE, Rule::Finite), Kind::Table(&HARMONIC_KEYS)]),
            "\"0.2 N m\"",
            "its size: constant, an expression over time, or a table with amplitude and frequency",
        ),
        JOINT,
        optional(
            "points",
            Kind::List(&Kind::List(&Kind::AnyQuantity)),
            "[[\"0 rpm\", \"12 N m\"], [\"2000 rpm\", \"15 N m\"], [\"3000 rpm\", \"0 N m\"]]",
            "in place of torque: pairs of what it is over and the torque there, the first ones increasing",
        ),
        CSV,
        OF,
        PERIOD,
        CURVE,
    ],
)
.with_exactly_one(&[&["torque", "points", "csv"]]);
