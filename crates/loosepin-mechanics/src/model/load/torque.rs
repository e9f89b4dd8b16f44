//! A torque on a body.

use super::course::TimeCourse;
use super::kind::{ActsOn, KindOfLoad, LoadPlace, Push};
use super::size::{JOINT, Oscillation, PointsOfLoad, SizeKeys, SizeTable};
use crate::model::ids::BodyId;
use crate::model::part_reader::PartReader;
use crate::model::parts::table_curve::POINTS;
use crate::model::words::part_names::Names;
use loosepin_math::{Real, Vec2};
use loosepin_text::document::{Entry, Keys, Kind, Table, quantity};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Rule};

/// A torque on a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TorqueLoad {
    /// The body.
    pub body: BodyId,
}

impl KindOfLoad for TorqueLoad {
    const WORD: &'static str = TorqueTable::WORD;
    const KEYS: &'static Keys = &TorqueTable::KEYS;
    const SIZE: Option<SizeKeys> = Some(SizeKeys {
        key: "torque",
        dimension: Dimension::TORQUE,
        harmonic: |reader, entry| {
            let HarmonicTorque { mean, amplitude, at: Oscillation { frequency, phase, .. }, .. } =
                HarmonicTorque::read(reader, entry)?;
            Some(TimeCourse::Harmonic { mean, amplitude, frequency, phase_rad: phase })
        },
    });

    fn read<'t>(table: Table<'t>, reader: &mut dyn PartReader) -> (Option<Self>, Option<SizeTable<'t>>) {
        let Some(own) = TorqueTable::of(reader, table) else { return (None, None) };
        let kind = own.body.map(|body| Self { body });
        let TorqueTable { table, torque: size, joint, points, rest, .. } = own;
        (kind, Some(SizeTable { table, size, joint, points, rest, pressures: None }))
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

record! {
    /// a harmonic torque: mean + amplitude sin(360 deg frequency time + phase)
    struct HarmonicTorque for PartReader;
    /// mean torque
    optional mean: QuantityId = quantity(Dimension::TORQUE, Rule::Finite), "\"0 N m\"", or "0 N m";
    /// amplitude: largest distance from the mean
    required amplitude: QuantityId = quantity(Dimension::TORQUE, Rule::Finite), "\"0.2 N m\"";
    include at: Oscillation<'t>;
}

record! {
    /// a torque on a body
    struct TorqueTable for PartReader, kind "torque" of load, exactly one of [torque, points, csv];
    /// the body on which the torque acts
    required body: Option<BodyId> = Kind::Reference("body"), "\"rocker\"";
    /// size of the torque: constant, an expression over time, or a table with amplitude and frequency
    optional torque: Entry<'t> =
        Kind::AnyOf(&[quantity(Dimension::TORQUE, Rule::Finite), Kind::Table(&HarmonicTorque::KEYS)]), "\"0.2 N m\"";
    optional joint: Entry<'t> as JOINT;
    /// instead of torque: pairs of the variable named by `of` and the torque; the variable increases
    optional points: Entry<'t> =
        POINTS, "[[\"0 rpm\", \"12 N m\"], [\"2000 rpm\", \"15 N m\"], [\"3000 rpm\", \"0 N m\"]]";
    include rest: PointsOfLoad<'t>;
}
