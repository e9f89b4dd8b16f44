//! The clearance of a fit: an interval, or a distribution.

use super::StudyReader;
use super::random::Stated;
use super::random_problem::RandomProblem;
use crate::document::{Entry, Table};
use crate::model::QuantityId;
use crate::study::iso_286::{Fit, FitLimits};
use crate::uncertainty::{Distribution, Interval};
use crate::units::{Dimension, Rule, format_value};

/// The limits of hole and shaft lie this many standard deviations from the middles of their tolerances.
const DEVIATIONS_TO_LIMIT: f64 = 3.0;

impl StudyReader {
    /// The radial clearance of a fit as a distribution: hole and shaft normal about the middles of their tolerances, the limits 3
    /// standard deviations away, c = (hole - shaft)/2.
    pub(super) fn fit_scatter(
        &mut self,
        table: &Table<'_>,
        entry: &Entry<'_>,
        quantity: QuantityId,
        path: &str,
    ) -> Option<Stated> {
        let (limits, words) = self.fit_limits(table, entry, quantity, path)?;
        let middle = |[lower, upper]: [f64; 2]| 0.5 * (lower + upper);
        let deviation = |[lower, upper]: [f64; 2]| (upper - lower) / (2.0 * DEVIATIONS_TO_LIMIT);
        let (hole, shaft) = (deviation(limits.hole_m), deviation(limits.shaft_m));
        let distribution = Distribution::Normal {
            mean: 0.5 * (middle(limits.hole_m) - middle(limits.shaft_m)),
            standard_deviation: 0.5 * (hole * hole + shaft * shaft).sqrt(),
        };
        let origin = format!("{words}, limits of hole and shaft taken as 3 standard deviations from centred means");
        Some(Stated { distribution, origin, mean: None })
    }

    /// The radial clearance of a fit as an interval, with the fit in words.
    pub(super) fn fit_interval(
        &mut self,
        table: &Table<'_>,
        entry: &Entry<'_>,
        quantity: QuantityId,
        path: &str,
    ) -> Option<Interval> {
        let (limits, _) = self.fit_limits(table, entry, quantity, path)?;
        let [least, most] = limits.radial_clearance_m();
        Interval::try_new(least, most).ok()
    }

    fn fit_limits(
        &mut self,
        table: &Table<'_>,
        entry: &Entry<'_>,
        quantity: QuantityId,
        path: &str,
    ) -> Option<(FitLimits, String)> {
        let is_play = self.model.play_from(quantity).next().is_some();
        if !is_play || self.model.quantities[quantity].dimension != Dimension::LENGTH {
            self.reader.complain(&RandomProblem::FitElsewhere { path: path.to_owned() }, entry.key_span);
        }
        let has_diameter = self.reader.demand(table, "diameter");
        let diameter_entry = table.get("diameter").filter(|_| has_diameter);
        let diameter_m = diameter_entry
            .as_ref()
            .and_then(|diameter| self.reader.measured(diameter, Dimension::LENGTH, Rule::Positive));
        let text = self.reader.text(entry)?;
        let words = entry.path.describe();
        let fit = match Fit::parse(text) {
            Ok(fit) => fit,
            Err(error) => {
                self.reader.complain(&RandomProblem::Fit { entry: words, error }, entry.span);
                return None;
            }
        };
        let (diameter_m, diameter_entry) = diameter_m.zip(diameter_entry)?;
        let limits = match fit.limits(diameter_m) {
            Ok(limits) => limits,
            Err(error) => {
                let place =
                    if matches!(error, crate::study::iso_286::FitError::Size { .. }) { &diameter_entry } else { entry };
                self.reader.complain(&RandomProblem::Fit { entry: place.path.describe(), error }, place.span);
                return None;
            }
        };
        let length = |value_m: f64| format_value(value_m, Dimension::LENGTH);
        let [least, most] = limits.radial_clearance_m();
        let diameter = length(diameter_m);
        if !(least > 0.0) {
            let (fit, least, most) = (text.to_owned(), length(least), length(most));
            let problem = RandomProblem::Interference { entry: words, fit, diameter, least, most };
            self.reader.complain(&problem, entry.span);
            return None;
        }
        is_play.then(|| (limits, format!("fit {text} at {diameter}")))
    }
}
