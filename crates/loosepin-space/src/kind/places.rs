//! Where a joint is on both of its bodies: the tables of that, and how they are read.

use crate::kind::joint_reader::JointReader;
use crate::model::direction::{DIRECTION, Direction, LENGTHS};
use crate::model::marker::{ModelMarker, ModelMisalignment};
use crate::model::problem::SpatialModelProblem;
use loosepin_text::document::{Entry, Kind, Table, quantity};
use loosepin_text::numbers::ReadsNumbers;
use loosepin_text::record;
use loosepin_text::units::{Dimension as D, Rule};

/// The marker of the bearing, and that of the journal.
pub(crate) type Markers = [ModelMarker; 2];

/// Keys of planar joints that those in space do not have yet.
pub(crate) const PLANNED: &[(&str, &str)] = &[
    ("contact", "there are no runs in space yet, so nothing touches"),
    ("friction", "there are no runs in space yet"),
    ("wear", "wear is known in planar models"),
    ("diametral_clearance", "give radial_clearance, which is half of it"),
];

record! {
    /// the points that a joint connects
    pub(crate) struct Points for ReadsNumbers;
    /// point of the body with the hole, the socket, the guide or the nut
    required bearing: Entry<'t> = Kind::Point, "\"ground.o\"";
    /// point of the body with the pin, the ball, the slider or the screw
    required journal: Entry<'t> = Kind::Point, "\"crank.o\"";
}

record! {
    /// the axis of a joint
    pub(crate) struct Axes for ReadsNumbers;
    /// axis of the joint in the frames of both bodies: x, y, z, the name of an axis on both, or three numbers; z if omitted
    optional axis: Entry<'t> = DIRECTION, "\"x\"";
    /// the axis on the body of the bearing, where both differ
    optional bearing_axis: Entry<'t> = DIRECTION, "\"hinge\"";
    /// the axis on the body of the journal
    optional journal_axis: Entry<'t> = DIRECTION, "\"z\"";
}

record! {
    /// directions across the axis, from which its angle is counted
    pub(crate) struct Across for ReadsNumbers;
    /// direction on the body of the bearing from which the angle is counted; if omitted, y of an axis x, and x of an axis y or z
    optional bearing_across: Entry<'t> = DIRECTION, "\"y\"";
    /// direction on the body of the journal to which the angle is counted
    optional journal_across: Entry<'t> = DIRECTION, "\"y\"";
}

/// A rotation vector.
const ANGLES: Kind = Kind::Three(&quantity(D::ANGLE, Rule::Finite));

record! {
    /// errors of manufacture of both sides of a joint: their places
    pub(crate) struct Shifts for ReadsNumbers;
    /// error of manufacture: displacement of the bearing from its point, along the direction across the axis, along that at right angles to both, and along the axis; none if omitted
    optional bearing_shift: Entry<'t> = LENGTHS, "[\"0.02 mm\", \"0 mm\", \"0 mm\"]";
    /// error of manufacture: displacement of the journal from its point, likewise
    optional journal_shift: Entry<'t> = LENGTHS, "[\"0 mm\", \"0.01 mm\", \"0 mm\"]";
}

record! {
    /// errors of manufacture of both sides of a joint: their directions
    pub(crate) struct Tilts for ReadsNumbers;
    /// error of manufacture: rotation vector of the bearing on its body, along the same directions; the first two tilt the axis, the third turns about it; none if omitted, and an input of a study only where it is written
    optional bearing_tilt: Entry<'t> = ANGLES, "[\"0.2 mrad\", \"0 mrad\", \"0 mrad\"]";
    /// error of manufacture: rotation vector of the journal on its body, likewise
    optional journal_tilt: Entry<'t> = ANGLES, "[\"0 mrad\", \"0.2 mrad\", \"0 mrad\"]";
}

impl Points<'_> {
    /// Both markers of a joint without an axis.
    pub(crate) fn markers(&self, reader: &mut dyn JointReader) -> Option<Markers> {
        let [bearing, journal] = [&self.bearing, &self.journal].map(|point| marker(reader, point, None, None));
        Some([bearing?, journal?])
    }
}

impl Axes<'_> {
    /// Both markers of a joint with an axis.
    pub(crate) fn markers(
        &self,
        reader: &mut dyn JointReader,
        table: &Table<'_>,
        points: &Points<'_>,
        across: Option<&Across<'_>>,
    ) -> Option<Markers> {
        let [on_bearing, on_journal] = self.entries(reader, table)?;
        let bearing_across = across.and_then(|own| own.bearing_across.as_ref());
        let journal_across = across.and_then(|own| own.journal_across.as_ref());
        let bearing = marker(reader, &points.bearing, on_bearing, bearing_across);
        let journal = marker(reader, &points.journal, on_journal, journal_across);
        Some([bearing?, journal?])
    }

    /// Both markers of a joint that keeps directions across its axis together.
    pub(crate) fn markers_with_directions(
        &self,
        reader: &mut dyn JointReader,
        table: &Table<'_>,
        points: &Points<'_>,
        across: &Across<'_>,
        kind: &'static str,
    ) -> Option<Markers> {
        let markers = self.markers(reader, table, points, Some(across))?;
        let is_plain = markers.iter().all(|marker| marker.axis.is_coordinate() || marker.across.is_some());
        if !is_plain {
            let problem = SpatialModelProblem::NeedsAcross { entry: table.path.describe(), kind };
            reader.refuse(&problem, table.span);
            return None;
        }
        Some(markers)
    }

    /// Where the axis is written for each body; the outer option is absent after a diagnostic.
    fn entries(&self, reader: &mut dyn JointReader, table: &Table<'_>) -> Option<[Option<&Entry<'_>>; 2]> {
        let own = [&self.bearing_axis, &self.journal_axis];
        let keys = ["bearing_axis", "journal_axis"];
        let entry = table.path.describe();
        if let Some(both) = &self.axis {
            let Some(place) = own.iter().position(|own| own.is_some()) else { return Some([Some(both); 2]) };
            reader.refuse(&SpatialModelProblem::AxisTwice { entry, given: keys[place] }, both.key_span);
            return None;
        }
        let (given, other, at) = match own {
            [Some(at), None] => (keys[0], keys[1], at),
            [None, Some(at)] => (keys[1], keys[0], at),
            [bearing, journal] => return Some([bearing.as_ref(), journal.as_ref()]),
        };
        reader.refuse(&SpatialModelProblem::OneAxis { entry, given, other }, at.key_span);
        None
    }
}

impl Shifts<'_> {
    /// Markers with the errors of manufacture of both sides, which are read where the joint itself has a diagnostic as well.
    pub(crate) fn applied_to(
        &self,
        markers: Option<Markers>,
        reader: &mut dyn JointReader,
        tilts: Option<&Tilts<'_>>,
    ) -> Option<Markers> {
        let bearing = misalignment(reader, &self.bearing_shift, tilts.and_then(|own| own.bearing_tilt.as_ref()));
        let journal = misalignment(reader, &self.journal_shift, tilts.and_then(|own| own.journal_tilt.as_ref()));
        let ([on_bearing, on_journal], of_bearing, of_journal) = (markers?, bearing?, journal?);
        let bearing = ModelMarker { misalignment: of_bearing, ..on_bearing };
        Some([bearing, ModelMarker { misalignment: of_journal, ..on_journal }])
    }
}

fn misalignment(
    reader: &mut dyn JointReader,
    shift: &Option<Entry<'_>>,
    tilt: Option<&Entry<'_>>,
) -> Option<ModelMisalignment> {
    let mut read = |entry: Option<&Entry<'_>>, dimension: D| match entry {
        None => Some(None),
        Some(entry) => reader.numbers().three(entry, dimension).map(Some),
    };
    let (shift_m, tilt_rad) = (read(shift.as_ref(), D::LENGTH), read(tilt, D::ANGLE));
    Some(ModelMisalignment { shift_m: shift_m?, tilt_rad: tilt_rad? })
}

/// The marker at a point: its axis is z where it has no entry.
pub(crate) fn marker(
    reader: &mut dyn JointReader,
    point: &Entry<'_>,
    axis: Option<&Entry<'_>>,
    across: Option<&Entry<'_>>,
) -> Option<ModelMarker> {
    let point = reader.point(point)?;
    let axis = axis.map_or(Some(Direction::Z), |entry| reader.direction(entry, point.body));
    let across = match across {
        None => None,
        Some(entry) => Some(reader.direction(entry, point.body)?),
    };
    Some(ModelMarker { point, axis: axis?, across, misalignment: ModelMisalignment::default() })
}
