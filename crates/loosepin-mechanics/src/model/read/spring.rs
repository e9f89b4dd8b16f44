//! Reading springs.

use super::reader::ModelReader;
use crate::model::entry_reader::{Column, EntryReader};
use crate::model::ids::PointId;
use crate::model::part_reader::{DeferredQuantity, PartReader};
use crate::model::parts::spring::{Elasticity, Spring, SpringKind};
use crate::model::parts::table_curve::{CSV, POINTS, TableCurve};
use crate::model::problem::ModelProblem;
use loosepin_text::document::{Entry, Keys, Kind, Table, choice, quantity};
use loosepin_text::numbers::EntryProblem;
use loosepin_text::record;
use loosepin_text::units::{Dimension, Dimension as D, Rule};

record! {
    /// a file of points instead of points in the table, and the curve through the points
    struct FileAndCurve for PartReader;
    optional csv: Entry<'t> as CSV;
    /// with points or csv: monotone: between two points, no value outside theirs; spline: smoother, no jump in the slope of the stiffness
    optional curve: Option<TableCurve> = choice::<TableCurve>(), "\"spline\"", or "monotone";
}

record! {
    /// a spring with a damper between points of two bodies; it pulls when it is longer than its free length
    pub(super) struct LinearSpring for PartReader, kind "linear" of spring,
        exactly one of [stiffness, points, csv], exactly one of [free_length, points, csv];
    /// point of the first body
    required first: Option<PointId> = Kind::Point, "\"ground.hook\"";
    /// point of the second body
    required second: Option<PointId> = Kind::Point, "\"rocker.eye\"";
    /// force per extension
    optional stiffness: Entry<'t> = quantity(D::SPRING_STIFFNESS, Rule::NonNegative), "\"2 N/mm\"";
    /// length at zero extension
    optional free_length: Entry<'t> = quantity(D::LENGTH, Rule::NonNegative), "\"40 mm\"";
    /// damping force per speed of extension, along the spring; none if omitted
    optional damping: Entry<'t> = quantity(D::DAMPING, Rule::NonNegative), "\"5 N s/m\"";
    /// tension at the free length, below zero for compression
    optional preload: DeferredQuantity<'t> = quantity(D::FORCE, Rule::Finite), "\"10 N\"", or "0 N" called "none";
    /// pairs of a length and the tension at that length, instead of stiffness and free length; the lengths increase, and the curve
    /// continues straight beyond both ends
    optional points: Entry<'t> = POINTS, "[[\"30 mm\", \"-4 N\"], [\"40 mm\", \"0 N\"], [\"55 mm\", \"12 N\"]]";
    include rest: FileAndCurve<'t>;
}

record! {
    /// a torsion spring with a damper that turns two bodies back to their free angle
    pub(super) struct TorsionalSpring for PartReader, kind "torsional" of spring,
        exactly one of [stiffness, points, csv], exactly one of [free_angle, points, csv];
    /// the revolute joint whose axis is that of the spring: from the bearing's body to the journal's
    optional joint: Entry<'t> = Kind::Reference("joint"), "\"pivot\"";
    /// the first body, instead of a joint
    optional first: Entry<'t> = Kind::Reference("body"), "\"ground\"";
    /// the second body, instead of a joint
    optional second: Entry<'t> = Kind::Reference("body"), "\"rocker\"";
    /// torque per angle
    optional stiffness: Entry<'t> = quantity(D::TORSIONAL_STIFFNESS, Rule::NonNegative), "\"2 N m/rad\"";
    /// angle from the first body to the second at zero twist of the spring
    optional free_angle: Entry<'t> = quantity(D::ANGLE, Rule::Finite), "\"30 deg\"";
    /// damping torque per angular velocity; none if omitted
    optional damping: Entry<'t> = quantity(D::TORSIONAL_DAMPING, Rule::NonNegative), "\"0.01 N m s/rad\"";
    /// torque at the free angle that turns the second body backwards
    optional preload: DeferredQuantity<'t> = quantity(D::TORQUE, Rule::Finite), "\"0.1 N m\"", or "0 N m" called "none";
    /// pairs of an angle and the torque at that angle, instead of stiffness and free angle; the angles increase, and the curve continues
    /// straight beyond both ends
    optional points: Entry<'t> =
        POINTS, "[[\"-20 deg\", \"-0.4 N m\"], [\"0 deg\", \"0 N m\"], [\"30 deg\", \"1 N m\"]]";
    include rest: FileAndCurve<'t>;
}

/// The kinds of spring with their keys.
pub(super) static SPRING_KINDS: &[(&str, &Keys)] =
    &[(LinearSpring::WORD, &LinearSpring::KEYS), (TorsionalSpring::WORD, &TorsionalSpring::KEYS)];

/// What the table of a spring says of its pull, without its damper.
struct Pull<'e, 't> {
    table: &'e Table<'t>,
    /// Stiffness, and free length or angle.
    linear: [&'e Option<Entry<'t>>; 2],
    preload: &'e DeferredQuantity<'t>,
    points: &'e Option<Entry<'t>>,
    rest: &'e FileAndCurve<'t>,
    columns: [Column; 2],
}

impl ModelReader {
    /// Reads the table of springs.
    pub fn read_springs(&mut self, entry: &Entry<'_>) {
        for entry in self.numbers.reader.named(entry, "a spring") {
            self.numbers.remember(&entry);
            let spring = self.spring(&entry);
            self.springs.extend(spring);
        }
    }

    fn spring(&mut self, entry: &Entry<'_>) -> Option<Spring> {
        let (word, table) = self.numbers.table_of_kind(entry, SPRING_KINDS)?;
        let (kind, elasticity, damping) = if word == LinearSpring::WORD {
            let own = LinearSpring::of(self, table)?;
            let columns = [("length", Dimension::LENGTH), ("force", Dimension::FORCE)];
            let LinearSpring { table, stiffness, free_length, preload, points, rest, .. } = &own;
            let linear = [stiffness, free_length];
            let elasticity = self.elasticity(Pull { table, linear, preload, points, rest, columns });
            let kind = own.first.zip(own.second).map(|(first, second)| SpringKind::Linear { first, second });
            (kind, elasticity, own.damping)
        } else {
            let own = TorsionalSpring::of(self, table)?;
            let columns = [("angle", Dimension::ANGLE), ("torque", Dimension::TORQUE)];
            let TorsionalSpring { table, stiffness, free_angle, preload, points, rest, .. } = &own;
            let linear = [stiffness, free_angle];
            let elasticity = self.elasticity(Pull { table, linear, preload, points, rest, columns });
            (self.torsional_spring(&own), elasticity, own.damping)
        };
        let damping = damping.and_then(|entry| self.numbers.quantity_at(&entry));
        let kind = kind?;
        let [first, second] = kind.bodies();
        if first == second {
            let body = self.bodies[first.0].name.clone();
            return self
                .numbers
                .reader
                .refuse(&EntryProblem::SameBody { entry: entry.path.describe(), body }, entry.key_span);
        }
        Some(Spring { name: entry.name.to_owned(), kind, elasticity: elasticity?, damping })
    }

    fn elasticity(&mut self, own: Pull<'_, '_>) -> Option<Elasticity> {
        let given = match (own.points, &own.rest.csv) {
            (Some(_), _) => "points",
            (None, Some(_)) => "csv",
            (None, None) => {
                self.numbers.refuse_beside(own.table, "curve", "stiffness");
                let [stiffness, free] = own.linear.map(|entry| self.numbers.quantity_at(entry.as_ref()?));
                let preload = own.preload.quantity(self);
                return Some(Elasticity::Linear { stiffness: stiffness?, free: free?, preload: preload? });
            }
        };
        self.numbers.refuse_beside(own.table, "preload", given);
        let points = self.table_points([own.points, &own.rest.csv], own.columns)?;
        Some(Elasticity::Table { points, curve: own.rest.curve? })
    }

    fn torsional_spring(&mut self, own: &TorsionalSpring<'_>) -> Option<SpringKind> {
        let entry = own.table.path.describe();
        let Some(joint_entry) = &own.joint else {
            let (Some(first), Some(second)) = (&own.first, &own.second) else {
                return self.numbers.reader.refuse(&ModelProblem::NoBodies { entry }, own.table.span);
            };
            let [first, second] = [first, second].map(|entry| PartReader::body(self, entry));
            return Some(SpringKind::Torsional { first: first?, second: second? });
        };
        for key in ["first", "second"] {
            self.numbers.refuse_beside(&own.table, key, "joint");
        }
        let joint = self.joint(joint_entry)?;
        let kind = &self.joints[joint.0].kind;
        if kind.turns() {
            let [first, second] = kind.bodies();
            return Some(SpringKind::Torsional { first, second });
        }
        let name = self.joints[joint.0].name.clone();
        self.numbers.reader.refuse(&ModelProblem::DoesNotTurn { entry, joint: name }, joint_entry.span)
    }
}
