//! The clearance of a fit: an interval, or a distribution.

use crate::file::description::AllowedFit;
use crate::file::random_inputs::random_problem::RandomProblem;
use crate::file::reader::StudyReader;
use loosepin_mechanics::model::QuantityId;
use loosepin_text::diagnostics::{Diagnostic, Place};
use loosepin_text::document::{Entry, Key, Kind, Table, optional};
use loosepin_text::tolerance::{Fit, FitError, FitLimits};
use loosepin_text::units::{Dimension, Rule, format_value};
use loosepin_uncertainty::{Distribution, Interval};

/// The fit of a hole and a shaft.
pub(crate) const FIT: Key = optional(
    "fit",
    Kind::Text,
    "\"H7/g6\"",
    "clearance of a hole and a shaft by ISO 286, on the radius or the diameter as the joint states it: hole in capital letters, then shaft; with diameter",
);
/// Its diameter.
pub(crate) const DIAMETER: Key = optional("diameter", Kind::AnyQuantity, "\"20 mm\"", "nominal diameter of the fit");

/// The limits of hole and shaft lie this many standard deviations from the middles of their tolerances.
const DEVIATIONS_TO_LIMIT: f64 = 3.0;

/// A clearance at which is found out whether a quantity that is zero in the model is one on the radius or on the diameter.
const TRIED_M: f64 = 1e-6;
/// Round-off of a clearance from an expression.
const ROUND_OFF: f64 = 1e-9;

/// A diameter that differs from that of the bearing by more than this share belongs to something else.
const OTHER_DIAMETER: f64 = 0.02;

impl StudyReader {
    /// The radial clearance of a fit as a distribution: hole and shaft normal about the middles of their tolerances, the limits 3
    /// standard deviations away, c = (hole - shaft)/2; with where it comes from, in words.
    pub(crate) fn fit_scatter(
        &mut self,
        table: &Table<'_>,
        entry: &Entry<'_>,
        quantity: QuantityId,
        path: &str,
    ) -> Option<(Distribution, String)> {
        let (limits, words, per_radial) = self.fit_limits(table, entry, quantity, path)?;
        let origin = format!("{words}, limits of hole and shaft taken as 3 standard deviations from centred means");
        Some((scatter(&limits, per_radial), origin))
    }

    /// Fits that are asked about, the tightest first: by the greatest clearance, of equal ones by the least.
    pub(crate) fn allowed_fits(
        &mut self,
        table: &Table<'_>,
        entry: &Entry<'_>,
        quantity: QuantityId,
        path: &str,
    ) -> Option<Vec<AllowedFit>> {
        let place = self.fit_place(table, entry, quantity, path)?;
        let entries = self.reader.list(entry)?;
        if entries.len() < 2 {
            let problem = RandomProblem::SingleFit { entry: entry.path.describe(), found: entries.len() };
            return self.refused(&problem, entry.span);
        }
        let mut fits: Vec<AllowedFit> = Vec::new();
        let mut is_whole = true;
        for written in &entries {
            let Some((limits, _)) = self.fit_at(written, &place) else {
                is_whole = false;
                continue;
            };
            let name = self.reader.text(written)?.to_owned();
            let clearance_m = limits.radial_clearance_m().map(|clearance_m| place.per_radial * clearance_m);
            if let Some(known) = fits.iter().find(|known| known.clearance_m == clearance_m) {
                let problem = RandomProblem::SameFit { fit: name, other: known.name.clone() };
                self.reader.report(&problem, written.span);
                is_whole = false;
                continue;
            }
            fits.push(AllowedFit { name, clearance_m, scatter: scatter(&limits, place.per_radial) });
        }
        fits.sort_by(|a, b| {
            let [first, second] = [a, b].map(|fit| fit.clearance_m);
            first[1].total_cmp(&second[1]).then(first[0].total_cmp(&second[0]))
        });
        is_whole.then_some(fits)
    }

    /// The radial clearance of a fit as an interval, with the fit in words.
    pub(crate) fn fit_interval(
        &mut self,
        table: &Table<'_>,
        entry: &Entry<'_>,
        quantity: QuantityId,
        path: &str,
    ) -> Option<Interval> {
        let (limits, _, per_radial) = self.fit_limits(table, entry, quantity, path)?;
        let [least, most] = limits.radial_clearance_m().map(|clearance_m| per_radial * clearance_m);
        Interval::try_new(least, most).ok()
    }

    fn fit_limits(
        &mut self,
        table: &Table<'_>,
        entry: &Entry<'_>,
        quantity: QuantityId,
        path: &str,
    ) -> Option<(FitLimits, String, f64)> {
        let place = self.fit_place(table, entry, quantity, path);
        let text = self.reader.text(entry)?;
        if let Err(error) = Fit::parse(text) {
            return self.refused(&RandomProblem::Fit { entry: entry.path.describe(), error }, entry.span);
        }
        let place = place?;
        let (limits, words) = self.fit_at(entry, &place)?;
        place.is_play.then_some((limits, words, place.per_radial))
    }

    /// What fits of `quantity` belong to: a joint with play, at a diameter.
    fn fit_place<'t>(
        &mut self,
        table: &Table<'t>,
        entry: &Entry<'_>,
        quantity: QuantityId,
        path: &str,
    ) -> Option<FitPlace<'t>> {
        let concerned = self.model.bearings_with_play_from(quantity);
        let per_radial = self.per_radial(quantity);
        let is_play = per_radial.is_some() && !concerned.is_empty();
        if !is_play {
            self.reader.report(&RandomProblem::FitElsewhere { path: path.to_owned() }, entry.key_span);
        }
        let has_diameter = self.reader.demand(table, "diameter");
        let diameter_entry = table.get("diameter").filter(|_| has_diameter)?;
        let diameter_m = self.reader.measured(&diameter_entry, Dimension::LENGTH, Rule::Positive)?;
        for (joint, bearing_radius_m) in concerned {
            let Some(radius) = bearing_radius_m else { continue };
            let bearing_m = 2.0 * self.model.quantities().nominal()[radius];
            if (bearing_m - diameter_m).abs() > OTHER_DIAMETER * bearing_m {
                let [diameter, bearing] =
                    [diameter_m, bearing_m].map(|value_m| format_value(value_m, Dimension::LENGTH));
                let problem =
                    RandomProblem::OtherDiameter { entry: diameter_entry.path.describe(), diameter, joint, bearing };
                let place = Place::new(&self.reader.source, diameter_entry.span);
                self.reader.diagnostics.push(Diagnostic::warning(&problem, Some(place)));
            }
        }
        Some(FitPlace { diameter_m, entry: diameter_entry, is_play, per_radial: per_radial.unwrap_or(1.0) })
    }

    /// What a quantity is for each unit of radial clearance: 1 of a radial clearance, 2 of a diametral one. `None` if it is
    /// neither of the joints that depend on it.
    fn per_radial(&self, quantity: QuantityId) -> Option<f64> {
        let quantities = self.model.quantities();
        if quantities[quantity].dimension != Dimension::LENGTH {
            return None;
        }
        let nominal_m = quantities.nominal()[quantity];
        let tried_m = if nominal_m > 0.0 { nominal_m } else { TRIED_M };
        let values = quantities.evaluate(&[(quantity, tried_m)]).ok()?;
        let found = |clearance: QuantityId| {
            [1.0, 2.0].into_iter().find(|times| {
                (times * values[quantities.stated_clearance(clearance)] - tried_m).abs() <= ROUND_OFF * tried_m
            })
        };
        let mut all = self.model.play_from(quantity).into_iter().map(|play| found(play.quantity));
        let first = all.next()??;
        all.all(|other| other == Some(first)).then_some(first)
    }

    /// The limits of the fit that is written, and the fit in words.
    fn fit_at(&mut self, entry: &Entry<'_>, place: &FitPlace<'_>) -> Option<(FitLimits, String)> {
        let text = self.reader.text(entry)?;
        let words = entry.path.describe();
        let fit = match Fit::parse(text) {
            Ok(fit) => fit,
            Err(error) => return self.refused(&RandomProblem::Fit { entry: words, error }, entry.span),
        };
        let limits = match fit.limits(place.diameter_m) {
            Ok(limits) => limits,
            Err(error) => {
                let of_size = matches!(error, FitError::Size { .. });
                let (entry, span) =
                    if of_size { (place.entry.path.describe(), place.entry.span) } else { (words, entry.span) };
                return self.refused(&RandomProblem::Fit { entry, error }, span);
            }
        };
        let length = |value_m: f64| format_value(value_m, Dimension::LENGTH);
        let [least, most] = limits.radial_clearance_m();
        let diameter = length(place.diameter_m);
        if !(least > 0.0) {
            let (fit, least, most) = (text.to_owned(), length(least), length(most));
            return self.refused(&RandomProblem::Interference { entry: words, fit, diameter, least, most }, entry.span);
        }
        Some((limits, format!("fit {text} at {diameter}")))
    }
}

/// Place of a fit in the file.
struct FitPlace<'t> {
    diameter_m: f64,
    entry: Entry<'t>,
    /// Whether it is the play of a joint.
    is_play: bool,
    /// Its value for each unit of radial clearance: 2 on the diameter.
    per_radial: f64,
}

/// The radial clearance c = (hole - shaft)/2, hole and shaft normal about the middles of their tolerances, the limits 3 standard
/// deviations away; times `per_radial`.
fn scatter(limits: &FitLimits, per_radial: f64) -> Distribution {
    let middle = |[lower, upper]: [f64; 2]| 0.5 * (lower + upper);
    let deviation = |[lower, upper]: [f64; 2]| (upper - lower) / (2.0 * DEVIATIONS_TO_LIMIT);
    let (hole, shaft) = (deviation(limits.hole_m), deviation(limits.shaft_m));
    Distribution::Normal {
        mean: per_radial * 0.5 * (middle(limits.hole_m) - middle(limits.shaft_m)),
        standard_deviation: per_radial * 0.5 * (hole * hole + shaft * shaft).sqrt(),
    }
}
