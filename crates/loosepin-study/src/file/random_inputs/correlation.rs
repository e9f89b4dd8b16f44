//! Correlations of random inputs.

use crate::file::description::{Correlation, CorrelationMeasure, StatedCorrelation};
use crate::file::random_inputs::random_problem::{RandomProblem, pair_words, short_number};
use crate::file::reader::StudyReader;
use loosepin_text::document::{Entry, Kind, Reads};
use loosepin_text::record;
use loosepin_text::units::{Rule, format_number};
use loosepin_uncertainty::{Copula, CopulaError, CorrelationSeries, GaussianCopula, Pair, normal_of_rank};

record! {
    /// the correlation of two random inputs (Gaussian copula)
    pub(crate) lenient struct CorrelationTable for Reads, exactly one of [rank, linear];
    /// paths of two random inputs
    required of: Entry<'t> = Kind::List(&Kind::Text), "[\"parameter.crank_length\", \"parameter.rod_length\"]";
    /// rank correlation (Spearman)
    optional rank: Entry<'t> = Kind::Number { rule: Rule::Finite }, "0.6";
    /// linear correlation of the values (Pearson)
    optional linear: Entry<'t> = Kind::Number { rule: Rule::Finite }, "0.6";
}

impl StudyReader {
    /// Reads all `[[correlation]]` tables; `None` if there are none, or something is wrong.
    pub fn read_correlations(&mut self, written: Option<&Entry<'_>>) -> Option<Correlation> {
        let had_errors = self.reader.diagnostics.has_errors();
        let entries = self.double_brackets(written);
        let mut stated: Vec<StatedCorrelation> = Vec::new();
        let mut is_right = true;
        for entry in &entries {
            match self.correlation(entry, &stated, had_errors) {
                Some(correlation) => stated.push(correlation),
                None => is_right = false,
            }
        }
        let first = entries.first()?;
        if !is_right {
            return None;
        }
        let pairs = stated.iter().map(|correlation| Pair {
            first: correlation.first,
            second: correlation.second,
            normal: correlation.normal,
        });
        match GaussianCopula::try_new(self.random.len(), pairs.collect()) {
            Ok(copula) => Some(Correlation { stated, copula: Copula::Gaussian(copula) }),
            Err(CopulaError::NotPositiveDefinite { inputs, least_eigenvalue }) => {
                let involved = stated.iter().filter(|each| inputs.contains(&each.first));
                let pairs = involved
                    .map(|each| pair_words(&self.random[each.first].path, &self.random[each.second].path))
                    .collect();
                // With all correlations times f the eigenvalues are 1 + f (λ - 1).
                let factor = 1.0 / (1.0 - least_eigenvalue);
                let factor = format_number((factor * 1000.0).floor() / 1000.0);
                let least_eigenvalue = short_number(least_eigenvalue);
                self.refused(&RandomProblem::NotPositiveDefinite { pairs, least_eigenvalue, factor }, first.key_span)
            }
            // Pairs and ranges were checked one by one.
            Err(_) => None,
        }
    }

    fn correlation(
        &mut self,
        entry: &Entry<'_>,
        before: &[StatedCorrelation],
        had_errors: bool,
    ) -> Option<StatedCorrelation> {
        let CorrelationTable { of, rank, linear, .. } = CorrelationTable::read(self, entry)?;
        let is_rank = rank.is_some();
        let written = rank.or(linear);
        let value = written.as_ref().and_then(|entry| self.measure(entry));
        let of = of?;
        let pair = self.reader.pair(&of)?;
        let [first, second] = [0, 1].map(|index: usize| self.member(&pair[index], had_errors));
        let (first, second) = first.zip(second)?;
        if first == second {
            let (entry, path) = (of.path.describe(), self.random[first].path.clone());
            return self.refused(&RandomProblem::WithItself { entry, path }, of.span);
        }
        let is_same = |other: &StatedCorrelation| {
            (other.first, other.second) == (first, second) || (other.first, other.second) == (second, first)
        };
        let [first_path, second_path] = [first, second].map(|input| self.random[input].path.clone());
        if before.iter().any(is_same) {
            let entry = of.path.describe();
            return self.refused(&RandomProblem::PairTwice { entry, first: first_path, second: second_path }, of.span);
        }
        let (value, entry) = (value?, written?);
        if is_rank {
            let normal = normal_of_rank(value);
            return Some(StatedCorrelation { first, second, measure: CorrelationMeasure::Rank, value, normal });
        }
        if let Some(input) = [first, second].iter().find(|&&input| !self.random[input].parameters.is_empty()) {
            let path = self.random[*input].path.clone();
            return self.refused(&RandomProblem::LinearOfBox { entry: entry.path.describe(), path }, entry.span);
        }
        let series = CorrelationSeries::new(&self.random[first].variable, &self.random[second].variable);
        match series.normal(value) {
            Ok(normal) => Some(StatedCorrelation { first, second, measure: CorrelationMeasure::Linear, value, normal }),
            Err(error) => {
                let problem = RandomProblem::Unattainable {
                    entry: entry.path.describe(),
                    found: format_number(value),
                    first: first_path,
                    second: second_path,
                    least: short_number(error.least),
                    most: short_number(error.most),
                };
                self.refused(&problem, entry.span)
            }
        }
    }

    fn measure(&mut self, entry: &Entry<'_>) -> Option<f64> {
        let value = self.reader.number_of(entry)?;
        if value.abs() < 1.0 {
            return Some(value);
        }
        self.refused(&RandomProblem::Range { entry: entry.path.describe(), found: format_number(value) }, entry.span)
    }

    /// Which random input a path names.
    fn member(&mut self, entry: &Entry<'_>, had_errors: bool) -> Option<usize> {
        let path = self.reader.text(entry)?.to_owned();
        let quantity = match self.model.find(&path) {
            Ok(quantity) => quantity,
            Err(error) => return self.refused(&error, entry.span),
        };
        let place = self.random.iter().position(|input| input.quantity() == Some(quantity));
        if place.is_none() {
            let words = entry.path.describe();
            if self.epistemic.iter().any(|input| input.quantity() == Some(quantity)) {
                self.reader.report(&RandomProblem::Epistemic { entry: words, path }, entry.span);
            } else if !had_errors {
                // After an error above it may be one that could not be read.
                let of_model = self.random.iter().filter(|input| input.quantity().is_some());
                let known = of_model.map(|input| input.path.clone()).collect();
                self.reader.report(&RandomProblem::NotRandom { entry: words, path, known }, entry.span);
            }
        }
        place
    }
}
