//! Studies with inputs that the inverse question has loosened.

use crate::error::StudyError;
use crate::file::{Allowance, AllowedFit, AllowedInput, Study};
use loosepin_uncertainty::{EpistemicVariable, Interval, Parameter, RandomVariable};

/// `study` with other values of some inputs, by the places of their allowances, and nothing asked but its requirements.
///
/// # Errors
/// An input cannot have that value.
pub fn with_loosened(study: &Study, set: &[(usize, f64)]) -> Result<Study, StudyError> {
    let mut loosened = study.clone();
    loosened.asks.clear();
    for &(place, value) in set {
        let unknown = || StudyError::Loosened {
            path: format!("allowance {place}"),
            value_si: value,
            reason: format!("there are {}", study.allowances.len()),
        };
        loosen(&mut loosened, study.allowances.get(place).ok_or_else(unknown)?, value)?;
    }
    Ok(loosened)
}

fn loosen(study: &mut Study, allowance: &Allowance, value: f64) -> Result<(), StudyError> {
    let impossible = |reason: String| StudyError::Loosened { path: allowance.path.clone(), value_si: value, reason };
    match allowance.input {
        AllowedInput::UpperEnd(index) => {
            let interval =
                Interval::try_new(allowance.least_si, value).map_err(|error| impossible(error.to_string()))?;
            study.epistemic[index].variable = EpistemicVariable::from(interval);
        }
        AllowedInput::FitInterval(index) => {
            let fit = fit_of(allowance, value).ok_or_else(|| impossible("no such fit".to_owned()))?;
            let [least, most] = fit.clearance_m;
            let interval = Interval::try_new(least, most).map_err(|error| impossible(error.to_string()))?;
            study.epistemic[index].variable = EpistemicVariable::from(interval);
        }
        AllowedInput::FitScatter(index) => {
            let fit = fit_of(allowance, value).ok_or_else(|| impossible("no such fit".to_owned()))?;
            let scatter = RandomVariable::try_new(fit.scatter.clone());
            study.random[index].variable = scatter.map_err(|error| impossible(error.to_string()))?;
        }
        AllowedInput::StandardDeviation(index) => {
            let input = &mut study.random[index];
            let loosened = input.variable.with_parameters([(Parameter::StandardDeviation, value)]);
            input.variable = loosened.map_err(|error| impossible(error.to_string()))?;
        }
    }
    Ok(())
}

/// The fit with this greatest clearance.
fn fit_of(allowance: &Allowance, most_m: f64) -> Option<&AllowedFit> {
    allowance.fits.iter().find(|fit| fit.clearance_m[1] == most_m)
}
