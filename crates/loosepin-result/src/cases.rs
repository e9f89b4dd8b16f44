//! What comparing a case leaves behind for tables and pages: plain data in SI.

/// A case compared.
#[derive(Debug, Clone, PartialEq)]
pub struct CaseRecord {
    /// Name of its folder.
    pub name: String,
    /// Name of its model.
    pub title: String,
    /// Its numbers, in the order of the file.
    pub numbers: Vec<NumberRecord>,
}

/// A number compared.
#[derive(Debug, Clone, PartialEq)]
pub struct NumberRecord {
    /// What it is, in words.
    pub name: String,
    /// Where it comes from: `analytic`, `published`, `peer` or `pinned`.
    pub origin: &'static str,
    /// The formula, the paper or the program.
    pub source: String,
    /// What was compared.
    pub comparison: Comparison,
    /// Largest accepted difference, SI.
    pub tolerance_si: f64,
    /// The unit in which it is shown; empty for a pure number.
    pub unit: String,
    /// What one such unit is in SI.
    pub si_per_unit: f64,
}

/// An expected and an obtained number, or the largest of many differences.
#[derive(Debug, Clone, PartialEq)]
pub enum Comparison {
    /// One number.
    Number {
        /// As the source has it, SI.
        expected_si: f64,
        /// As the program has it, SI; NaN if the run has none, for example fewer contacts.
        obtained_si: f64,
    },
    /// Many numbers, of which only the largest difference is kept.
    Largest {
        /// What was compared, for example `501 rows`.
        of: String,
        /// The largest difference, SI; NaN if ours are fewer.
        difference_si: f64,
    },
}

impl NumberRecord {
    /// Obtained minus expected, or the largest difference, SI.
    pub fn difference_si(&self) -> f64 {
        match self.comparison {
            Comparison::Number { expected_si, obtained_si } => obtained_si - expected_si,
            Comparison::Largest { difference_si, .. } => difference_si,
        }
    }

    /// Whether the difference is within the tolerance.
    pub fn is_within(&self) -> bool {
        self.difference_si().abs() <= self.tolerance_si
    }
}
