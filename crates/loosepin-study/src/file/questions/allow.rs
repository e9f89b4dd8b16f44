//! Allowances: the unknowns of the inverse question.

use crate::file::description::{Allowance, AllowedInput};
use crate::file::problem::StudyProblem;
use crate::file::reader::StudyReader;
use loosepin_math::sort_by_number;
use loosepin_mechanics::model::QuantityId;
use loosepin_result::study::Together;
use loosepin_text::document::{Choice, Entry, Kind, Reads, Value};
use loosepin_text::units::{Dimension, Rule, format_apart};
use loosepin_text::{choices, record};
use loosepin_uncertainty::{Distribution, EpistemicVariable, Parameter};

choices!(
    /// How inputs are loosened together.
    pub(crate) struct TogetherWord(Together):
    "proportional" => Together::Proportional,
    "frontier" => Together::Frontier,
);

record! {
    /// a value to loosen as far as the requirements permit: the upper end of an interval, a standard deviation, or a fit
    pub(crate) lenient struct AllowTable for Reads, exactly one of [up_to, fit];
    /// the largest value to try
    optional up_to: Entry<'t> = Kind::AnyQuantity, "\"0.5 mm\"";
    /// ISO 286 fits of a joint with play, in any order; the loosest permitted fit is sought
    optional fit: Entry<'t> = Kind::List(&Kind::Text), "[\"H7/g6\", \"H8/f7\", \"H9/e9\"]";
    /// diameter of the fits
    optional diameter: Entry<'t> = Kind::AnyQuantity, "\"20 mm\"";
    /// the values on offer, each with its cost; the cheapest permitted combination over all inputs is chosen
    optional cost: Entry<'t> =
        Kind::List(&Kind::List(&Kind::AnyQuantity)), "[[\"0.01 mm\", 12.0], [\"0.05 mm\", 3.0]]";
}

impl StudyReader {
    /// Reads what may be loosened. `inputs`: the tables of random and of epistemic inputs; `has_requirements`: whether any are written.
    pub fn read_allowances(
        &mut self,
        written: Option<&Entry<'_>>,
        inputs: [Option<&Entry<'_>>; 2],
        has_requirements: bool,
    ) -> Vec<Allowance> {
        let Some(entry) = written else { return Vec::new() };
        let allowances = self.reader.any_keys(entry).iter().filter_map(|entry| self.allowance(inputs, entry)).collect();
        if !has_requirements {
            self.report(&StudyProblem::NothingRequired, &entry.at_key());
        }
        allowances
    }

    /// How the inputs are loosened together.
    pub fn together(&mut self, written: Option<&Entry<'_>>, allowances: &[Allowance]) -> Option<Together> {
        let entry = written?;
        let TogetherWord(together) = TogetherWord::read(self, entry)?;
        // An input that is refused has its own diagnostic.
        if self.reader.diagnostics.has_errors() {
            return None;
        }
        let is_number_possible = match together {
            Together::Proportional => allowances.len() >= 2,
            Together::Frontier => allowances.len() == 2,
        };
        let found = match allowances.iter().find(|one| !one.fits.is_empty() || !one.costs.is_empty()) {
            Some(one) => format!("'{}' with '{}'", one.path, if one.fits.is_empty() { "cost" } else { "fit" }),
            None if is_number_possible => return Some(together),
            None if allowances.is_empty() => "none".to_owned(),
            None => allowances.len().to_string(),
        };
        let word =
            TogetherWord::CHOICES.iter().find(|known| known.1.0 == together).map_or("", |known| known.0).to_owned();
        self.refused(&StudyProblem::Together { word, found }, entry.span)
    }

    fn allowance(&mut self, inputs: [Option<&Entry<'_>>; 2], entry: &Entry<'_>) -> Option<Allowance> {
        let path = entry.name.to_owned();
        let table = AllowTable::read(self, entry)?;
        if let Some(fits) = &table.fit {
            return self.fit_allowance(path, entry, &table, fits);
        }
        let Some((input, least, dimension)) = self.allowed_input(&path) else {
            // An input that is refused where it is described has its diagnostic there.
            return if self.is_refused(inputs, &path) {
                None
            } else {
                self.refused(&StudyProblem::AllowedInput { path }, entry.key_span)
            };
        };
        if let Some(diameter) = table.diameter {
            let problem = StudyProblem::BesideFits { entry: diameter.path.describe(), has_fits: false };
            return self.refused(&problem, diameter.key_span);
        }
        let written = table.up_to?;
        let up_to = self.reader.measured(&written, dimension, Rule::Finite)?;
        if !(up_to > least) {
            self.above(&written, up_to, least, dimension);
            return None;
        }
        if let AllowedInput::UpperEnd(index) = input
            && let Some(quantity) = self.epistemic[index].quantity()
            && !self.check_end(quantity, &path, up_to, &written, false)
        {
            return None;
        }
        let mut costs: Vec<[f64; 2]> = Vec::new();
        if let Some(list) = &table.cost {
            for offer in self.reader.list(list)? {
                let pair = self.reader.pair(&offer)?;
                let value = self.reader.measured(&pair[0], dimension, Rule::Finite)?;
                let cost = self.reader.measured(&pair[1], Dimension::NUMBER, Rule::NonNegative)?;
                if !(value > least) {
                    self.above(&pair[0], value, least, dimension);
                    return None;
                }
                costs.push([value, cost]);
            }
            sort_by_number(&mut costs, |a| a[0]);
            // What is tighter costs more, or nobody would choose what is looser.
            if costs.is_empty() || costs.windows(2).any(|pair| pair[0][0] == pair[1][0] || pair[0][1] <= pair[1][1]) {
                return self.refused(&StudyProblem::Costs { entry: list.path.describe() }, list.span);
            }
        }
        if let Some([offer, _]) = costs.iter().rev().find(|[offer, _]| *offer > up_to)
            && let Some(list) = &table.cost
        {
            let [offer, up_to] = format_apart([*offer, up_to], dimension);
            return self.refused(&StudyProblem::OfferBeyond { entry: list.path.describe(), offer, up_to }, list.span);
        }
        Some(Allowance { path, input, least_si: least, up_to_si: up_to, fits: Vec::new(), costs })
    }

    /// Whether an input is described in the file and could not be read.
    fn is_refused(&mut self, inputs: [Option<&Entry<'_>>; 2], path: &str) -> bool {
        let is_read =
            self.random.iter().any(|input| input.path == path) || self.epistemic.iter().any(|input| input.path == path);
        let mut tables = inputs.into_iter().flatten();
        !is_read && tables.any(|table| self.reader.any_keys(table).iter().any(|input| input.name == path))
    }

    /// The loosest of several fits.
    fn fit_allowance(
        &mut self,
        path: String,
        entry: &Entry<'_>,
        table: &AllowTable<'_>,
        fits: &Entry<'_>,
    ) -> Option<Allowance> {
        let Some((input, quantity)) = self.fitted_input(&path) else {
            return self.refused(&StudyProblem::FittedInput { path }, entry.key_span);
        };
        if let Some(cost) = &table.cost {
            return self
                .refused(&StudyProblem::BesideFits { entry: cost.path.describe(), has_fits: true }, cost.key_span);
        }
        let fits = self.allowed_fits(&table.table, fits, quantity, &path)?;
        let least = fits.first()?.clearance_m[1];
        let most = fits.last()?.clearance_m[1];
        Some(Allowance { path, input, least_si: least, up_to_si: most, fits, costs: Vec::new() })
    }

    /// The input whose fit is asked for: an interval, or a normal distribution that is known.
    fn fitted_input(&self, path: &str) -> Option<(AllowedInput, QuantityId)> {
        if let Some(index) = self.epistemic.iter().position(|input| input.path == path) {
            let input = &self.epistemic[index];
            let is_interval = matches!(input.variable, EpistemicVariable::Interval(_));
            return Some((AllowedInput::FitInterval(index), input.quantity()?)).filter(|_| is_interval);
        }
        let index = self.random.iter().position(|input| input.path == path)?;
        let input = &self.random[index];
        let is_normal = matches!(input.variable.distribution(), Distribution::Normal { .. });
        let found = (AllowedInput::FitScatter(index), input.quantity()?);
        (is_normal && input.parameters.is_empty()).then_some(found)
    }

    /// The input that `path` names, the least value of what is loosened, and its dimension.
    fn allowed_input(&self, path: &str) -> Option<(AllowedInput, f64, Dimension)> {
        if let Some(index) = self.epistemic.iter().position(|input| input.path == path) {
            let input = &self.epistemic[index];
            let dimension = self.model.quantities()[input.quantity()?].dimension;
            // Masses and degrees have no single end that could be moved.
            let EpistemicVariable::Interval(interval) = &input.variable else { return None };
            return Some((AllowedInput::UpperEnd(index), interval.lower(), dimension));
        }
        let index = self.random.iter().position(|input| input.path == path)?;
        let input = &self.random[index];
        let has_deviation = matches!(
            input.variable.distribution(),
            Distribution::Normal { .. } | Distribution::Lognormal { .. } | Distribution::TruncatedNormal { .. }
        );
        let is_known = input.parameters.iter().all(|own| own.parameter != Parameter::StandardDeviation);
        let dimension = input.dimension(&self.model);
        (has_deviation && is_known).then_some((AllowedInput::StandardDeviation(index), 0.0, dimension))
    }

    fn above(&mut self, entry: &Entry<'_>, found: f64, least: f64, dimension: Dimension) {
        let [found, least] = format_apart([found, least], dimension);
        self.report(&StudyProblem::AllowedRange { entry: entry.path.describe(), found, least }, entry);
    }
}
