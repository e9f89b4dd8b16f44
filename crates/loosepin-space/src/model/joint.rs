//! Joints: where they are on both bodies, their kind and their play.

use super::direction::Direction;
use super::misalignment::{Shifts, Tilts};
use super::parts::{ModelJoint, ModelJointForm, ModelMarker, ModelMisalignment, ModelPlay};
use super::problem::SpatialModelProblem;
use super::reader::{DIRECTION, SpaceReader};
use crate::kind::kind_of_joint::KindOfJoint;
use crate::kind::{Cylindrical, Planar, Prismatic, Revolute, Rigid, SpatialKind, Spherical, Universal};
use loosepin_text::document::{Entry, Keys, Kind, Table, quantity};
use loosepin_text::numbers::{EntryProblem, QuantityId, ReadsNumbers};
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule};

/// Keys of planar joints that those in space do not have yet.
const PLANNED: &[(&str, &str)] = &[
    ("contact", "there are no runs in space yet, so nothing touches"),
    ("friction", "there are no runs in space yet"),
    ("wear", "wear is known in planar models"),
    ("diametral_clearance", "give radial_clearance, which is half of it"),
];

record! {
    /// the points that a joint connects
    struct Points for ReadsNumbers;
    /// point of the body with the hole, the socket, the guide or the nut
    required bearing: Entry<'t> = Kind::Point, "\"ground.o\"";
    /// point of the body with the pin, the ball, the slider or the screw
    required journal: Entry<'t> = Kind::Point, "\"crank.o\"";
}

record! {
    /// the axis of a joint
    struct Axes for ReadsNumbers;
    /// axis of the joint in the frames of both bodies: x, y, z, the name of an axis on both, or three numbers; z if omitted
    optional axis: Entry<'t> = DIRECTION, "\"x\"";
    /// the axis on the body of the bearing, where both differ
    optional bearing_axis: Entry<'t> = DIRECTION, "\"hinge\"";
    /// the axis on the body of the journal
    optional journal_axis: Entry<'t> = DIRECTION, "\"z\"";
}

record! {
    /// directions across the axis, from which its angle is counted
    struct Across for ReadsNumbers;
    /// direction on the body of the bearing from which the angle is counted; if omitted, y of an axis x, and x of an axis y or z
    optional bearing_across: Entry<'t> = DIRECTION, "\"y\"";
    /// direction on the body of the journal to which the angle is counted
    optional journal_across: Entry<'t> = DIRECTION, "\"y\"";
}

record! {
    /// play of a pin
    struct BearingPlay for ReadsNumbers;
    /// radius of the hole minus radius of the pin; without it the joint is ideal
    optional radial_clearance: QuantityId = quantity(D::LENGTH, Rule::NonNegative), "\"0.1 mm\"";
    /// radius of the hole; the motion does not depend on it, a clearance is compared with it
    optional bearing_radius: QuantityId = quantity(D::LENGTH, Rule::Positive), "\"10 mm\"";
    /// length of the bearing, its middle at the point: the pin leans by up to 2 clearances over it
    optional bearing_length: QuantityId = quantity(D::LENGTH, Rule::Positive), "\"20 mm\"";
}

record! {
    /// both bodies turn about an axis
    struct RevoluteTable for ReadsNumbers, kind "revolute" of joint, planned PLANNED;
    include points: Points<'t>;
    include axes: Axes<'t>;
    include across: Across<'t>;
    include play: BearingPlay<'t>;
    /// how far the pin moves along the axis from the middle to either stop; 0 if omitted
    optional axial_clearance: QuantityId = quantity(D::LENGTH, Rule::NonNegative), "\"0.2 mm\"";
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}

record! {
    /// a body slides along an axis and does not turn
    struct PrismaticTable for ReadsNumbers, kind "prismatic" of joint, planned PLANNED;
    include points: Points<'t>;
    include axes: Axes<'t>;
    include across: Across<'t>;
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}

record! {
    /// a body turns about an axis and slides along it
    struct CylindricalTable for ReadsNumbers, kind "cylindrical" of joint, planned PLANNED;
    include points: Points<'t>;
    include axes: Axes<'t>;
    include across: Across<'t>;
    include play: BearingPlay<'t>;
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}

record! {
    /// a ball in a socket
    struct SphericalTable for ReadsNumbers, kind "spherical" of joint, planned PLANNED;
    include points: Points<'t>;
    /// radius of the socket minus radius of the ball; without it the joint is ideal
    optional radial_clearance: QuantityId = quantity(D::LENGTH, Rule::NonNegative), "\"0.1 mm\"";
    /// radius of the socket; the motion does not depend on it, a clearance is compared with it
    optional bearing_radius: QuantityId = quantity(D::LENGTH, Rule::Positive), "\"10 mm\"";
    include shifts: Shifts<'t>;
}

record! {
    /// two shafts and a cross, whose pins stay at a right angle
    struct UniversalTable for ReadsNumbers, kind "universal" of joint, planned PLANNED;
    include points: Points<'t>;
    /// the pin of the cross in the body of the bearing
    required bearing_pin: Entry<'t> = DIRECTION, "\"y\"";
    /// the pin of the cross in the body of the journal
    required journal_pin: Entry<'t> = DIRECTION, "\"z\"";
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}

record! {
    /// a body slides on a plane and turns in it; the axis is across the plane
    struct PlanarTable for ReadsNumbers, kind "planar" of joint, planned PLANNED;
    include points: Points<'t>;
    include axes: Axes<'t>;
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}

record! {
    /// a nut on its screw
    struct ScrewTable for ReadsNumbers, kind "screw" of joint, planned PLANNED;
    include points: Points<'t>;
    include axes: Axes<'t>;
    include across: Across<'t>;
    /// advance in one turn; negative for a left-hand thread
    required pitch: QuantityId = quantity(D::LENGTH, Rule::Finite), "\"5 mm\"";
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}

record! {
    /// both bodies move as one
    struct RigidTable for ReadsNumbers, kind "rigid" of joint, planned PLANNED;
    include points: Points<'t>;
    include axes: Axes<'t>;
    include across: Across<'t>;
    include shifts: Shifts<'t>;
    include tilts: Tilts<'t>;
}

/// Lists the kinds once: the table of each, and the function that reads it.
macro_rules! joint_tables {
    ($($table:ident => $read:ident),* $(,)?) => {
        /// The kinds with their keys.
        pub(super) const JOINTS: &[(&str, &Keys)] = &[$(($table::WORD, &$table::KEYS),)*];

        /// The kinds with the functions that read their tables.
        const READERS: &[(&str, fn(&mut SpaceReader, Table<'_>) -> Option<Read>)] = &[$(($table::WORD, SpaceReader::$read),)*];
    };
}

joint_tables! {
    RevoluteTable => revolute,
    PrismaticTable => prismatic,
    CylindricalTable => cylindrical,
    SphericalTable => spherical,
    UniversalTable => universal,
    PlanarTable => planar,
    ScrewTable => screw,
    RigidTable => rigid,
}

/// Where a joint is, before its kind and its play.
type Markers = [ModelMarker; 2];

/// A joint without its name: its kind, where it is, and its play.
type Read = (ModelJointForm, Markers, Option<ModelPlay>);

impl SpaceReader {
    /// Reads the table of joints.
    pub fn read_joints(&mut self, entry: &Entry<'_>) {
        for entry in self.numbers.reader.named(entry, "a joint") {
            self.numbers.remember(&entry);
            let number = self.read_joint(&entry).map(|joint| {
                self.joints.push(joint);
                self.joints.len() - 1
            });
            self.joint_names.push((entry.name.to_owned(), number));
        }
    }

    fn read_joint(&mut self, entry: &Entry<'_>) -> Option<ModelJoint> {
        let (word, table) = self.numbers.table_of_kind(entry, JOINTS)?;
        // A word that is none of these has its diagnostic.
        let (_, read) = READERS.iter().find(|(known, _)| *known == word)?;
        let (form, [bearing, journal], play) = read(self, table)?;
        if bearing.point.body == journal.point.body {
            let body = self.bodies[bearing.point.body].name.clone();
            let problem = EntryProblem::SameBody { entry: entry.path.describe(), body };
            return self.numbers.reader.refuse(&problem, entry.key_span);
        }
        Some(ModelJoint { name: entry.name.to_owned(), form, bearing, journal, play })
    }

    fn revolute(&mut self, table: Table<'_>) -> Option<Read> {
        let own = RevoluteTable::of(self, table)?;
        let markers = self.markers(&own.table, &own.points, &own.axes, Some(&own.across));
        if own.axial_clearance.is_some() && own.play.radial_clearance.is_none() {
            self.numbers.report_missing(&own.table, "axial_clearance", vec!["radial_clearance", "bearing_length"]);
            return None;
        }
        let bearing = self.bearing_play(&own.table, &own.play)?;
        let play = bearing.map(|[radial_clearance_m, bearing_length_m]| {
            let axial = own.axial_clearance;
            let none = &own.table.path.join("axial_clearance");
            let axial_clearance_m =
                axial.unwrap_or_else(|| self.numbers.default_quantity(none, D::LENGTH, Rule::NonNegative, 0.0));
            ModelPlay::Pin { bearing_length_m, radial_clearance_m, axial_clearance_m }
        });
        let found = markers.map(|markers| (ModelJointForm::Plain(Revolute.into()), markers, play));
        self.off(found, &own.shifts, Some(&own.tilts))
    }

    fn prismatic(&mut self, table: Table<'_>) -> Option<Read> {
        let own = PrismaticTable::of(self, table)?;
        let held = self.held(&own.table, Prismatic.into(), &own.points, &own.axes, &own.across);
        self.off(held, &own.shifts, Some(&own.tilts))
    }

    fn rigid(&mut self, table: Table<'_>) -> Option<Read> {
        let own = RigidTable::of(self, table)?;
        let held = self.held(&own.table, Rigid.into(), &own.points, &own.axes, &own.across);
        self.off(held, &own.shifts, Some(&own.tilts))
    }

    fn cylindrical(&mut self, table: Table<'_>) -> Option<Read> {
        let own = CylindricalTable::of(self, table)?;
        let markers = self.markers(&own.table, &own.points, &own.axes, Some(&own.across));
        let play = self
            .bearing_play(&own.table, &own.play)?
            .map(|[radial_clearance_m, bearing_length_m]| ModelPlay::Shaft { bearing_length_m, radial_clearance_m });
        let found = markers.map(|markers| (ModelJointForm::Plain(Cylindrical.into()), markers, play));
        self.off(found, &own.shifts, Some(&own.tilts))
    }

    fn spherical(&mut self, table: Table<'_>) -> Option<Read> {
        let own = SphericalTable::of(self, table)?;
        if !self.fits_in_radius(&own.table, own.radial_clearance, own.bearing_radius) {
            return None;
        }
        let play = own.radial_clearance.map(|radial_clearance_m| ModelPlay::Ball { radial_clearance_m });
        let [bearing, journal] = [&own.points.bearing, &own.points.journal].map(|entry| self.point(entry));
        let marker =
            |point| ModelMarker { point, axis: Direction::Z, across: None, misalignment: ModelMisalignment::default() };
        let markers = bearing.zip(journal).map(|(bearing, journal)| [marker(bearing), marker(journal)]);
        let found = markers.map(|markers| (ModelJointForm::Plain(Spherical.into()), markers, play));
        self.off(found, &own.shifts, None)
    }

    fn universal(&mut self, table: Table<'_>) -> Option<Read> {
        let own = UniversalTable::of(self, table)?;
        let bearing = self.marker(&own.points.bearing, Some(&own.bearing_pin), None);
        let journal = self.marker(&own.points.journal, Some(&own.journal_pin), None);
        let markers = bearing.zip(journal).map(|(bearing, journal)| [bearing, journal]);
        let found = markers.map(|markers| (ModelJointForm::Plain(Universal.into()), markers, None));
        self.off(found, &own.shifts, Some(&own.tilts))
    }

    fn planar(&mut self, table: Table<'_>) -> Option<Read> {
        let own = PlanarTable::of(self, table)?;
        let markers = self.markers(&own.table, &own.points, &own.axes, None);
        let found = markers.map(|markers| (ModelJointForm::Plain(Planar.into()), markers, None));
        self.off(found, &own.shifts, Some(&own.tilts))
    }

    fn screw(&mut self, table: Table<'_>) -> Option<Read> {
        let own = ScrewTable::of(self, table)?;
        let markers = self.markers(&own.table, &own.points, &own.axes, Some(&own.across));
        let found = markers.map(|markers| (ModelJointForm::Screw { pitch_m: own.pitch }, markers, None));
        self.off(found, &own.shifts, Some(&own.tilts))
    }

    /// A joint with the errors of manufacture of both sides; they are read where the joint itself has a diagnostic as well.
    fn off(&mut self, found: Option<Read>, shifts: &Shifts<'_>, tilts: Option<&Tilts<'_>>) -> Option<Read> {
        let errors = self.misalignments(shifts, tilts);
        let ((form, [bearing, journal], play), [of_bearing, of_journal]) = found.zip(errors)?;
        let bearing = ModelMarker { misalignment: of_bearing, ..bearing };
        Some((form, [bearing, ModelMarker { misalignment: of_journal, ..journal }], play))
    }

    /// A joint that keeps directions across its axis together.
    fn held(
        &mut self,
        table: &Table<'_>,
        kind: SpatialKind,
        points: &Points<'_>,
        axes: &Axes<'_>,
        across: &Across<'_>,
    ) -> Option<Read> {
        let markers = self.markers(table, points, axes, Some(across))?;
        let is_plain = markers.iter().all(|marker| marker.axis.is_coordinate() || marker.across.is_some());
        if !is_plain {
            let problem = SpatialModelProblem::NeedsAcross { entry: table.path.describe(), kind: kind.word() };
            return self.numbers.reader.refuse(&problem, table.span);
        }
        Some((ModelJointForm::Plain(kind), markers, None))
    }

    /// Whether a clearance is smaller than the radius of its bearing, where that is stated; reports if not, and a radius without clearance.
    fn fits_in_radius(&mut self, table: &Table<'_>, clearance: Option<QuantityId>, radius: Option<QuantityId>) -> bool {
        let Some(radius) = radius else { return true };
        let Some(clearance) = clearance else {
            if !table.has("radial_clearance") {
                self.numbers.report_missing(table, "bearing_radius", vec!["radial_clearance"]);
            }
            return false;
        };
        let span = table.get("radial_clearance").map_or(table.span, |entry| entry.span);
        self.numbers.demand_order(clearance, radius, span)
    }

    /// Radial clearance and length of a bearing; the outer option is absent after a diagnostic, the inner for an ideal joint.
    fn bearing_play(&mut self, table: &Table<'_>, own: &BearingPlay<'_>) -> Option<Option<[QuantityId; 2]>> {
        if !self.fits_in_radius(table, own.radial_clearance, own.bearing_radius) {
            return None;
        }
        let (key, needs) = match (own.radial_clearance, own.bearing_length) {
            (Some(clearance), Some(length)) => return Some(Some([clearance, length])),
            (None, None) => return Some(None),
            (Some(_), None) => ("radial_clearance", "bearing_length"),
            (None, Some(_)) => ("bearing_length", "radial_clearance"),
        };
        self.numbers.report_missing(table, key, vec![needs]);
        None
    }

    /// Both markers of a joint with an axis.
    fn markers(
        &mut self,
        table: &Table<'_>,
        points: &Points<'_>,
        axes: &Axes<'_>,
        across: Option<&Across<'_>>,
    ) -> Option<Markers> {
        let [on_bearing, on_journal] = self.axis_entries(table, axes)?;
        let bearing = self.marker(&points.bearing, on_bearing, across.and_then(|own| own.bearing_across.as_ref()));
        let journal = self.marker(&points.journal, on_journal, across.and_then(|own| own.journal_across.as_ref()));
        Some([bearing?, journal?])
    }

    /// Where the axis is written for each body; the outer option is absent after a diagnostic.
    fn axis_entries<'e, 't>(&mut self, table: &Table<'t>, axes: &'e Axes<'t>) -> Option<[Option<&'e Entry<'t>>; 2]> {
        let own = [&axes.bearing_axis, &axes.journal_axis];
        let keys = ["bearing_axis", "journal_axis"];
        let entry = table.path.describe();
        if let Some(both) = &axes.axis {
            let Some(place) = own.iter().position(|own| own.is_some()) else { return Some([Some(both); 2]) };
            return self
                .numbers
                .reader
                .refuse(&SpatialModelProblem::AxisTwice { entry, given: keys[place] }, both.key_span);
        }
        let (given, other, at) = match own {
            [Some(at), None] => (keys[0], keys[1], at),
            [None, Some(at)] => (keys[1], keys[0], at),
            [bearing, journal] => return Some([bearing.as_ref(), journal.as_ref()]),
        };
        self.numbers.reader.refuse(&SpatialModelProblem::OneAxis { entry, given, other }, at.key_span)
    }

    fn marker(
        &mut self,
        point: &Entry<'_>,
        axis: Option<&Entry<'_>>,
        across: Option<&Entry<'_>>,
    ) -> Option<ModelMarker> {
        let point = self.point(point)?;
        let axis = axis.map_or(Some(Direction::Z), |entry| self.direction(entry, point.body));
        let across = match across {
            None => None,
            Some(entry) => Some(self.direction(entry, point.body)?),
        };
        Some(ModelMarker { point, axis: axis?, across, misalignment: ModelMisalignment::default() })
    }
}
