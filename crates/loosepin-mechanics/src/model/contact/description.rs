//! The normal force laws as model files, help and reports know them.

use crate::contact::{LINE_LAWS, LINEAR_LAWS, LineLaw, LinearLaw, POINT_LAWS, PointLaw};

/// A normal force law as model files, help and reports know it, by where its numbers come from.
#[derive(Debug, Clone, Copy)]
pub enum NormalDescription {
    /// K from the materials or given with its exponent, χ from the restitution.
    Point(&'static PointLaw),
    /// K given, D given or from the restitution and the masses that meet.
    Linear(&'static LinearLaw),
    /// From the materials, the radii and the length of the bearing; χ from the restitution by a point-contact law.
    Line(&'static LineLaw),
}

impl NormalDescription {
    /// Every law: point contact, linear, line contact.
    pub fn all() -> impl Iterator<Item = Self> {
        let points = POINT_LAWS.iter().map(Self::Point);
        points.chain(LINEAR_LAWS.iter().map(Self::Linear)).chain(LINE_LAWS.iter().map(Self::Line))
    }

    /// The name used in model files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Point(law) => law.name,
            Self::Linear(law) => law.name,
            Self::Line(law) => law.name,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_laws_differ_and_all_have_a_source() {
        let mut names: Vec<&str> = NormalDescription::all().map(|law| law.name()).collect();
        let count = names.len();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), count);
        let sources = POINT_LAWS.iter().map(|law| law.source).chain(LINEAR_LAWS.iter().map(|law| law.source));
        let mut sources = sources.chain(LINE_LAWS.iter().map(|law| law.source));
        assert!(sources.all(|source| source.contains(|c: char| c.is_ascii_digit() || c == ':')));
    }
}
