//! Epistemic inputs made of several intervals: evidence, fuzzy numbers, boxes from quantiles or a mean.

use super::problem::StudyProblem;
use super::reader::StudyReader;
use loosepin_mechanics::model::QuantityId;
use loosepin_text::document::{Entry, Kind, Reads};
use loosepin_text::record;
use loosepin_text::units::{Dimension, Rule, format_apart, format_number};
use loosepin_uncertainty::{Evidence, EvidenceError, FocalElement, FuzzyError, FuzzyNumber, Interval, USUAL_CUTS};

record! {
    /// an interval and its mass of evidence (Dempster-Shafer)
    pub(super) lenient struct ElementTable for Reads;
    /// lower and upper end
    required interval: Entry<'t> = Kind::List(&Kind::AnyQuantity), "[\"0.1 mm\", \"0.3 mm\"]";
    /// above 0; the masses of all elements sum to 1
    required mass: f64 = Kind::Number { rule: Rule::Finite }, "0.4";
}

record! {
    /// a degree of possibility and the interval of all values with at least this degree
    lenient struct CutTable for Reads;
    /// the degree, from 0 to 1, increasing
    required alpha: f64 = Kind::Number { rule: Rule::Finite }, "0.5";
    /// lower and upper end
    required interval: Entry<'t> = Kind::List(&Kind::AnyQuantity), "[\"0.1 mm\", \"0.3 mm\"]";
}

record! {
    /// a fuzzy number
    pub(super) lenient struct FuzzyTable for Reads, exactly one of [triangular, trapezoidal, cuts];
    /// lower end, peak and upper end: the degree of possibility is 0 at the ends and 1 at the peak
    optional triangular: Entry<'t> = Kind::List(&Kind::AnyQuantity), "[\"0.1 mm\", \"0.2 mm\", \"0.5 mm\"]";
    /// four values: the degree of possibility rises from 0 at the first to 1 at the second, and falls from 1 at the third to 0 at the
    /// fourth
    optional trapezoidal: Entry<'t> =
        Kind::List(&Kind::AnyQuantity), "[\"0.1 mm\", \"0.2 mm\", \"0.3 mm\", \"0.5 mm\"]";
    /// the cuts themselves; each interval lies within the one before
    optional cuts: Entry<'t> = Kind::List(&Kind::Table(&CutTable::KEYS)), "";
    /// degrees at which a triangle or trapezoid is cut; 0, 0.25, 0.5, 0.75 and 1 if omitted
    optional degrees: Entry<'t> = Kind::List(&Kind::Number { rule: Rule::Finite }), "[0, 0.25, 0.5, 0.75, 1]";
}

/// Numbers with their places.
type Placed<'t> = Vec<(f64, Entry<'t>)>;

impl StudyReader {
    pub(super) fn evidence(&mut self, written: &Entry<'_>, quantity: QuantityId, path: &str) -> Option<Evidence> {
        let entries = self.reader.list(written)?;
        let mut elements: Vec<Option<FocalElement>> = Vec::new();
        for entry in &entries {
            let element = ElementTable::read(self, entry).and_then(|ElementTable { interval, mass, .. }| {
                let interval = self.interval(&interval?, quantity, path);
                Some(FocalElement { interval: interval?, mass: mass? })
            });
            elements.push(element);
        }
        let elements = elements.into_iter().collect::<Option<Vec<FocalElement>>>()?;
        let dimension = self.model.quantities()[quantity].dimension;
        let found = Evidence::try_new(elements);
        let culprit = match found {
            Err(EvidenceError::Mass { element, .. }) => entries.get(element - 1),
            _ => None,
        };
        self.evidence_of(found, culprit.unwrap_or(written), dimension)
    }

    pub(super) fn box_of_quantiles(
        &mut self,
        written: &Entry<'_>,
        support: Interval,
        quantity: QuantityId,
    ) -> Option<Evidence> {
        let dimension = self.model.quantities()[quantity].dimension;
        let entries = self.reader.list(written)?;
        if entries.is_empty() {
            return self.refused(&StudyProblem::Empty { entry: written.path.describe() }, written.span);
        }
        let mut quantiles = Vec::new();
        for entry in &entries {
            let pair = self.reader.pair(entry)?;
            let probability = self.reader.measured(&pair[0], Dimension::NUMBER, Rule::Probability)?;
            quantiles.push((probability, self.reader.measured(&pair[1], dimension, Rule::Finite)?));
        }
        let found = Evidence::from_quantiles(&quantiles, support);
        let is_culprit = |&(probability, value): &(f64, f64)| match found {
            Err(EvidenceError::NotIncreasing { second_probability, second, .. }) => {
                (probability, value) == (second_probability, second)
            }
            Err(EvidenceError::OutsideSupport { value: outside, .. }) => value == outside,
            Err(EvidenceError::Probability { probability: impossible }) => probability == impossible,
            _ => false,
        };
        // Of two that are the same the later one is too much.
        let culprit = quantiles.iter().rposition(is_culprit).and_then(|place| entries.get(place));
        self.evidence_of(found, culprit.unwrap_or(written), dimension)
    }

    pub(super) fn evidence_of(
        &mut self,
        evidence: Result<Evidence, EvidenceError>,
        written: &Entry<'_>,
        dimension: Dimension,
    ) -> Option<Evidence> {
        evidence
            .map_err(|error| {
                let entry = written.path.describe();
                self.report(&StudyProblem::Structure { entry, words: evidence_words(&error, dimension) }, written);
            })
            .ok()
    }

    pub(super) fn fuzzy<'t>(&mut self, written: &Entry<'t>, quantity: QuantityId, path: &str) -> Option<FuzzyNumber> {
        let dimension = self.model.quantities()[quantity].dimension;
        let table = FuzzyTable::read(self, written)?;
        // Degrees and corners with their places, for diagnostics.
        let (mut at_degrees, mut at_corners): (Placed<'t>, Placed<'t>) = (Vec::new(), Vec::new());
        let mut shape = written.clone();
        let degrees = match &table.degrees {
            Some(entry) => {
                let degrees = self.degrees(entry)?;
                at_degrees = degrees.iter().copied().zip(self.reader.list(entry)?).collect();
                degrees
            }
            None => USUAL_CUTS.to_vec(),
        };
        let found = if let Some(entry) = table.cuts {
            if let Some(degrees) = table.degrees {
                return self.refused(&StudyProblem::DegreesTwice { entry: degrees.path.describe() }, degrees.key_span);
            }
            let cuts = self.cuts(&entry, quantity, path)?;
            at_degrees = cuts.iter().map(|(alpha, _)| *alpha).zip(self.reader.list(&entry)?).collect();
            shape = entry;
            FuzzyNumber::try_new(cuts)
        } else if let Some(entry) = table.triangular {
            let [a, b, c] = self.corners(&entry, quantity, path)?;
            at_corners = [a, b, c].into_iter().zip(self.reader.list(&entry)?).collect();
            FuzzyNumber::trapezoidal([a, b, b, c], &degrees)
        } else {
            let entry = table.trapezoidal?;
            let corners = self.corners(&entry, quantity, path)?;
            at_corners = corners.into_iter().zip(self.reader.list(&entry)?).collect();
            FuzzyNumber::trapezoidal(corners, &degrees)
        };
        found
            .map_err(|error| {
                // Of two that are the same the later one is too much.
                let among = |places: &[(f64, Entry<'t>)], value: f64| {
                    places.iter().rev().find(|(own, _)| *own == value).map(|(_, entry)| entry.clone())
                };
                let culprit = match error {
                    FuzzyError::Corners { second, .. } => among(&at_corners, second),
                    FuzzyError::Degree { alpha }
                    | FuzzyError::NoSupport { alpha }
                    | FuzzyError::NotNested { alpha, .. }
                    | FuzzyError::DegreesNotIncreasing { second: alpha, .. } => among(&at_degrees, alpha),
                    FuzzyError::Empty => None,
                };
                let words = fuzzy_words(&error, dimension);
                let problem = StudyProblem::Structure { entry: written.path.describe(), words };
                self.report(&problem, &culprit.unwrap_or(shape));
            })
            .ok()
    }

    fn degrees(&mut self, entry: &Entry<'_>) -> Option<Vec<f64>> {
        let entries = self.reader.list(entry)?;
        entries.iter().map(|entry| self.reader.measured(entry, Dimension::NUMBER, Rule::Finite)).collect()
    }

    /// Corners of a membership function, the outer ones possible for the model.
    fn corners<const COUNT: usize>(
        &mut self,
        entry: &Entry<'_>,
        quantity: QuantityId,
        path: &str,
    ) -> Option<[f64; COUNT]> {
        let dimension = self.model.quantities()[quantity].dimension;
        let entries = self.reader.list(entry)?;
        let found = entries.len();
        let Ok(entries) = <[Entry<'_>; COUNT]>::try_from(entries) else {
            return self
                .refused(&StudyProblem::Corners { entry: entry.path.describe(), found, due: COUNT }, entry.span);
        };
        let mut corners = [0.0; COUNT];
        for (corner, entry) in corners.iter_mut().zip(&entries) {
            *corner = self.reader.measured(entry, dimension, Rule::Finite)?;
        }
        let lower = self.check_end(quantity, path, corners[0], &entries[0], false);
        let upper = self.check_end(quantity, path, corners[COUNT - 1], &entries[COUNT - 1], false);
        (lower && upper).then_some(corners)
    }

    fn cuts(&mut self, entry: &Entry<'_>, quantity: QuantityId, path: &str) -> Option<Vec<(f64, Interval)>> {
        let entries = self.reader.list(entry)?;
        let mut cuts = Vec::new();
        for entry in &entries {
            let cut = CutTable::read(self, entry)?;
            let interval = self.interval(&cut.interval?, quantity, path);
            cuts.push((cut.alpha?, interval?));
        }
        Some(cuts)
    }
}

/// The text of an error, values with their unit.
fn evidence_words(error: &EvidenceError, dimension: Dimension) -> String {
    let apart = |values_si: [f64; 2]| format_apart(values_si, dimension);
    let shares = |values: [f64; 2]| format_apart(values, Dimension::NUMBER);
    match *error {
        EvidenceError::Sum { sum } => format!("the masses sum to {}; must be 1, within 1e-6", format_number(sum)),
        EvidenceError::NotIncreasing { first_probability, first, second_probability, second } => format!(
            "the quantile {} at {} stands after {} at {}; probabilities and quantiles must increase",
            apart([second, first])[0],
            shares([second_probability, first_probability])[0],
            apart([second, first])[1],
            shares([second_probability, first_probability])[1]
        ),
        EvidenceError::OutsideSupport { what, value, lower, upper } => {
            let [value, lower, upper] = format_apart([value, lower, upper], dimension);
            format!("the {what} {value}; must lie between the ends {lower} and {upper} of the support")
        }
        _ => error.to_string(),
    }
}

/// The text of an error, values with their unit.
fn fuzzy_words(error: &FuzzyError, dimension: Dimension) -> String {
    match *error {
        FuzzyError::Corners { first, second } => {
            let [first, second] = format_apart([first, second], dimension);
            format!("corner {second} after {first}; corners must not decrease")
        }
        FuzzyError::NotNested { alpha, lower, upper, outer_alpha, outer_lower, outer_upper } => {
            let [alpha, outer_alpha] = format_apart([alpha, outer_alpha], Dimension::NUMBER);
            let [lower, upper, outer_lower, outer_upper] =
                format_apart([lower, upper, outer_lower, outer_upper], dimension);
            format!(
                "the cut at {alpha} from {lower} to {upper} is not within the cut at {outer_alpha} from {outer_lower} to \
                 {outer_upper}; cuts must be nested"
            )
        }
        _ => error.to_string(),
    }
}
