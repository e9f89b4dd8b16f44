//! Place in the cycle of a question or requirement.

use crate::file::problem::StudyProblem;
use crate::file::reader::StudyReader;
use crate::file::sizes::MAX_POSES;
use crate::file::words::REDUCTIONS;
use crate::places::Where;
use loosepin_result::study::Deviation;
use loosepin_text::document::{Entry, Key, Kind, Reader, Written, optional};
use loosepin_text::units::{Dimension, Rule, format_number, format_value, parse_quantity};

/// Angles at which an output is asked for.
pub(crate) const POSES: Key = optional(
    "poses",
    Kind::Values(&Kind::List(&Kind::AnyQuantity)),
    "{ crank = [\"60 deg\"] }",
    "angles of the drive that the cycle counts",
);

impl StudyReader {
    /// Reads the place in the cycle: `everywhere` stands for the whole curve, `reduction` for a number of it, which is `of` an output and a
    /// deviation.
    pub(crate) fn location(
        &mut self,
        [everywhere, poses, reduction]: [&Option<Entry<'_>>; 3],
        of: Option<(usize, Deviation)>,
    ) -> Option<Where> {
        if let Some(entry) = everywhere {
            if let Some(found) = angle_of(entry, &mut self.reader) {
                let drive = self.model.cycle_input(&self.model.quantities().nominal()).name;
                let problem = StudyProblem::AngleForCurve { entry: entry.path.describe(), found, drive };
                return self.refused(&problem, entry.span);
            }
            return self.reader.choice(entry, &[("cycle", ())]).map(|()| Where::over_cycle());
        }
        if let Some(entry) = poses {
            return self.poses(entry, of);
        }
        self.reader.choice(reduction.as_ref()?, &REDUCTIONS).map(Where::reduced)
    }

    fn poses(&mut self, entry: &Entry<'_>, of: Option<(usize, Deviation)>) -> Option<Where> {
        if !entry.is_table() {
            return self.reader.wrong_type(entry, "a table such as { crank = [\"60 deg\"] }");
        }
        let due = self.model.cycle_input(&self.model.quantities().nominal()).name;
        let mut angles_rad = Vec::new();
        for entry in self.reader.any_keys(entry) {
            if entry.name != due {
                let problem = StudyProblem::WrongDrive {
                    entry: entry.path.describe(),
                    name: entry.name.to_owned(),
                    due: due.clone(),
                };
                return self.refused(&problem, entry.key_span);
            }
            let angles = self.reader.list(&entry)?;
            if let Some(surplus) = angles.get(MAX_POSES) {
                let problem = StudyProblem::TooManyPoses { entry: entry.path.describe(), found: angles.len() };
                return self.refused(&problem, surplus.span);
            }
            for angle in angles {
                let Some(angle_rad) = self.reader.measured(&angle, Dimension::ANGLE, Rule::Finite) else { continue };
                if angles_rad.contains(&angle_rad) {
                    let pose = format_value(angle_rad, Dimension::ANGLE);
                    self.report(&StudyProblem::PoseTwice { entry: angle.path.describe(), pose }, &angle);
                    continue;
                }
                self.check_apart(&angle, of, angle_rad);
                angles_rad.push(angle_rad);
            }
        }
        if angles_rad.is_empty() {
            if !self.reader.diagnostics.has_errors() {
                self.report(&StudyProblem::Empty { entry: entry.path.describe() }, entry);
            }
            return None;
        }
        Some(Where::at_angles(angles_rad))
    }

    /// Two angles that the results could not distinguish, since both have the same name there.
    fn check_apart(&mut self, entry: &Entry<'_>, of: Option<(usize, Deviation)>, angle_rad: f64) {
        let Some(of) = of else { return };
        let known = self.poses.entry((of, (named_angle_rad(angle_rad) + 0.0).to_bits())).or_default();
        let beside_rad = known.iter().copied().find(|known_rad| *known_rad != angle_rad);
        known.push(angle_rad);
        if let Some(beside_rad) = beside_rad {
            let problem = StudyProblem::PosesTooNear {
                entry: entry.path.describe(),
                pose: format_value(angle_rad, Dimension::ANGLE),
                apart: format!("{:.1e} rad", (angle_rad - beside_rad).abs()),
            };
            self.report(&problem, entry);
        }
    }
}

/// The angle that stands where a whole curve is named, as it is written.
fn angle_of(entry: &Entry<'_>, reader: &mut Reader) -> Option<String> {
    if entry.is_table() {
        return None;
    }
    if !entry.is_text() {
        return reader.number_at(entry).map(format_number);
    }
    let Some(Written::Text(text)) = reader.written(entry) else { return None };
    parse_quantity(text).is_ok_and(|read| read.dimension == Dimension::ANGLE).then(|| format!("\"{text}\""))
}

/// An angle as it stands in the names of columns of runs: to 1e-9 rad.
pub fn named_angle_rad(angle_rad: f64) -> f64 {
    (angle_rad * 1e9).round() / 1e9
}
