//! The values with which joints have the most play, for what knows no intervals and no distributions.

use crate::file::Study;
use crate::model::StudyModel;
use crate::response::input_limits::InputLimits;
use loosepin_mechanics::model::{QuantityId, Values};
use loosepin_text::units::{ReadableUnit, SiUnit, UNITS, format_value, parse_quantity};

impl Study {
    /// Settings `path=value` of what is uncertain and decides a clearance: each at the end where that is larger, of its interval or list, or
    /// of the limits to which its distribution is taken (`input_limits`).
    ///
    /// A quantity behind several clearances is taken where their sum is larger, the other quantities as they stand in the model;
    /// an end that the model cannot take is none. Clearances that do not change with it leave it as it stands.
    pub fn widest_play(&self) -> Vec<(String, String)> {
        let widest = |(path, id, ends): (String, QuantityId, [f64; 2])| {
            let play = ends.map(|end| (self.sum_of_clearances_m(id, end), end));
            let (_, value_si) = play
                .into_iter()
                .filter_map(|(sum_m, end)| Some((sum_m?, end)))
                .reduce(|low, high| if low.0 > high.0 { low } else { high })?;
            let setting = format!("{path}={}", self.written_exactly(id, value_si));
            Some((path, setting))
        };
        let all = self.input_limits().into_iter();
        let known = all.filter(|input| self.model.has_play_from(input.quantity));
        known.filter_map(|input| widest((input.path, input.quantity, [input.low_si.max(0.0), input.high_si]))).collect()
    }

    /// The sum of all clearances that depend on a quantity where it is `value_si`, m; `None` if the model cannot take that.
    fn sum_of_clearances_m(&self, id: QuantityId, value_si: f64) -> Option<f64> {
        let values = self.model.quantities().evaluate(&[(id, value_si)]).ok()?;
        Some(self.model.play_from(id).into_iter().map(|play| values[play.quantity]).sum())
    }

    /// A value as it is read by people, with all digits where those do not give it back.
    fn written_exactly(&self, id: QuantityId, value_si: f64) -> String {
        let dimension = self.model.quantities()[id].dimension;
        let readable = format_value(value_si, dimension);
        if parse_quantity(&readable).is_ok_and(|read| read.value_si == value_si) {
            return readable;
        }
        let units = UNITS.iter().filter_map(|unit| ReadableUnit::of_dimension(unit.symbol, dimension));
        let texts = units.map(|unit| unit.format(value_si));
        let exact = texts.into_iter().find(|text| parse_quantity(text).is_ok_and(|read| read.value_si == value_si));
        exact.unwrap_or_else(|| format!("{value_si:e} {}", SiUnit::of_dimension(dimension).symbol()))
    }
}

/// The numbers of `model` with every clearance as large as `limits` allow, all else as in `values`, and why they cannot be had.
pub(super) fn with_most_play(model: &StudyModel, values: &Values, limits: &[InputLimits]) -> (Values, Option<String>) {
    let table = model.quantities();
    let mut set: Vec<(QuantityId, f64)> =
        table.iter().filter(|(_, quantity)| quantity.is_settable()).map(|(id, _)| (id, values[id])).collect();
    let mut reason = None;
    for input in limits {
        let plays = model.play_from(input.quantity);
        if plays.is_empty() {
            continue;
        }
        let ends_si = [input.low_si.max(0.0), input.high_si];
        let clearances_m = ends_si.map(|end_si| {
            let set: Vec<(QuantityId, f64)> = set.iter().copied().chain([(input.quantity, end_si)]).collect();
            let values = table.evaluate(&set).ok()?;
            Some(plays.iter().map(|play| values[play.quantity]).collect::<Vec<f64>>())
        });
        let [Some(low_m), Some(high_m)] = clearances_m else {
            reason = Some(format!("{} cannot be set to its limits", input.path));
            continue;
        };
        let is_high = high_m.iter().sum::<f64>() >= low_m.iter().sum::<f64>();
        let (end_si, most_m, least_m) = if is_high { (ends_si[1], high_m, low_m) } else { (ends_si[0], low_m, high_m) };
        if most_m.iter().zip(&least_m).any(|(most_m, least_m)| most_m < least_m) {
            reason = Some(format!("{} makes one play larger where it makes another one smaller", input.path));
        }
        set.push((input.quantity, end_si));
    }
    let values = table.evaluate(&set).unwrap_or_else(|_| {
        reason = Some("the largest clearances cannot be set together".to_owned());
        values.clone()
    });
    (values, reason)
}
