//! A cam and its follower, which may lift off.

use super::cam_profile::CamProfile;
use super::kind::{Coupled, KindOfCoupling};
use super::play::CouplingPlay;
use super::reading::CouplingReader;
use crate::model::ids::{ContactId, JointId};
use crate::model::joint::span_of;
use crate::model::parts::table_curve::{CSV, POINTS};
use crate::model::problem::ModelProblem;
use crate::model::words::part_names::Names;
use loosepin_math::Real;
use loosepin_text::document::{Entry, Keys, Kind, Table};
use loosepin_text::numbers::QuantityId;
use loosepin_text::record;
use loosepin_text::units::{Dimension, format_value, listed};

/// Of the angles of a whole period that are written with as many digits as tables have.
const PERIOD_ROUND_OFF: f64 = 1e-9;

/// A periodic cubic spline with dwells: the profile of a cam.
#[derive(Debug, Clone)]
pub struct Cam {
    /// Coordinates of the first joint, increasing, and of the second.
    pub points: Vec<[QuantityId; 2]>,
    /// Whether the follower rests from a point to the next: their values are equal in the model.
    pub dwells: Vec<bool>,
}

impl KindOfCoupling for Cam {
    type Curve<T: Real> = CamProfile<T>;

    const WORD: &'static str = "cam";
    const KEYS: &'static Keys = &CamTable::KEYS;

    fn read(_entry: &Entry<'_>, table: &Table<'_>, reader: &mut dyn CouplingReader) -> Option<Coupled<Self>> {
        let own = CamTable::of(reader, table.clone())?;
        let joints = reader.two_joints(table, [&own.joint, &own.follower], [None; 2])?;
        let [from, to] = joints.map(|joint| reader.coordinate_of(joint));
        let points = reader.table_points([&own.points, &own.csv], [("cam", from), ("follower", to)])?;
        if from == Dimension::ANGLE {
            demand_whole_turns(&own, &points, reader)?;
        }
        let dwells = points.windows(2).map(|pair| {
            let [before, after] = [pair[0][1], pair[1][1]].map(|id| reader.nominal_value(id));
            before == after
        });
        let dwells = dwells.collect();
        let play = match own.contact {
            Some(contact) => Some(lift_off(&own, contact?, joints[1], reader)?),
            None => None,
        };
        Some(Coupled { joints, kind: Self { points, dwells }, play, teeth: None })
    }

    fn quantities(&self) -> Vec<QuantityId> {
        self.points.iter().flatten().copied().collect()
    }

    fn curve<T: Real>(&self, number: &dyn Fn(QuantityId) -> T) -> CamProfile<T> {
        let points: Vec<[T; 2]> = self.points.iter().map(|point| point.map(number)).collect();
        CamProfile::new(&points, &self.dwells)
    }

    fn words(&self, names: &dyn Names) -> String {
        let words = format!("by a cam of {} points", self.points.len());
        let shown = |k: usize| names.quantity(self.points[k][0]);
        let dwells = dwell_ends(&self.dwells).into_iter();
        let dwells: Vec<String> = dwells.map(|[from, to]| format!("from {} to {}", shown(from), shown(to))).collect();
        if dwells.is_empty() { words } else { format!("{words}; dwells {}", listed(&dwells, "and")) }
    }
}

/// The play of a follower that may lift off; `None` after a diagnostic.
fn lift_off(
    own: &CamTable<'_>,
    contact: ContactId,
    follower: JointId,
    reader: &mut dyn CouplingReader,
) -> Option<CouplingPlay> {
    reader.demand_contact_of_flanks(&own.table, contact, "a cam and its follower")?;
    if reader.coordinate_of(follower) != Dimension::LENGTH {
        let joint = reader.joint_name(follower);
        let problem = ModelProblem::FollowerTurns { entry: own.table.path.describe(), joint };
        return reader.document().refuse(&problem, span_of(&own.follower, &own.table));
    }
    Some(CouplingPlay { backlash_m: None, second_radius_m: None, contact })
}

/// The points of a cam that turns span a turn, whole turns, or a whole part of one: after a turn it is where it was.
fn demand_whole_turns(own: &CamTable<'_>, points: &[[QuantityId; 2]], reader: &mut dyn CouplingReader) -> Option<()> {
    let [first, last] = [points[0][0], points[points.len() - 1][0]].map(|id| reader.nominal_value(id));
    let turns = (last - first) / std::f64::consts::TAU;
    let is_whole = |count: f64| (count - count.round()).abs() < PERIOD_ROUND_OFF * count;
    if is_whole(turns) || is_whole(1.0 / turns) {
        return Some(());
    }
    let degrees = |angle_rad: f64| format_value(angle_rad, Dimension::ANGLE);
    let problem = ModelProblem::CamPeriod {
        entry: own.table.path.describe(),
        from: degrees(first),
        to: degrees(last),
        whole: degrees(first + turns.ceil() * std::f64::consts::TAU),
    };
    let given = if own.csv.is_some() { &own.csv } else { &own.points };
    reader.document().refuse(&problem, span_of(given, &own.table))
}

/// The points at which each run of dwelling intervals begins and ends.
fn dwell_ends(dwells: &[bool]) -> Vec<[usize; 2]> {
    let mut ends: Vec<[usize; 2]> = Vec::new();
    for (interval, _) in dwells.iter().enumerate().filter(|(_, is_dwell)| **is_dwell) {
        match ends.last_mut() {
            Some([_, end]) if *end == interval => *end = interval + 1,
            _ => ends.push([interval, interval + 1]),
        }
    }
    ends
}

record! {
    /// a cam: the follower moves along a smooth profile over the angle (or position) of the cam's joint; the profile repeats, and each
    /// period starts where the last one ended
    struct CamTable for CouplingReader, exactly one of [points, csv];
    /// the joint of the cam
    required joint: Option<Entry<'t>> = Kind::Reference("joint"), "\"cam\"";
    /// the joint of the follower
    required follower: Option<Entry<'t>> = Kind::Reference("joint"), "\"lifter\"";
    /// pairs of the cam's angle (or position) and the follower's at this point; those of the cam increase, and the first and the last
    /// are one period apart
    optional points: Entry<'t> = POINTS, "[[\"0 deg\", \"0 mm\"], [\"120 deg\", \"8 mm\"], [\"360 deg\", \"0 mm\"]]";
    optional csv: Entry<'t> as CSV;
    /// contact between cam and follower: the follower may then lift off; if omitted, the cam guides it in both directions
    optional contact: Option<ContactId> = Kind::Reference("contact"), "\"tappet\"";
}
