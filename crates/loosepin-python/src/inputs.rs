//! Uncertain inputs that were stated in Python, as those of the library.

use loosepin::diagnostics::{Code, Problem};
use loosepin::uncertainty::{
    Distribution, EpistemicParameter, EpistemicVariable, Evidence, FocalElement, FuzzyNumber, GaussianCopula, Interval,
    Members, Pair, Parameter, RandomVariable, USUAL_CUTS, normal_of_rank,
};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use std::fmt;

use crate::error::raise_problem;

/// An input that is none.
#[derive(Debug)]
struct InputProblem {
    name: String,
    reason: String,
    code: Code,
}

impl fmt::Display for InputProblem {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "input '{}': {}", self.name, self.reason)
    }
}

impl Problem for InputProblem {
    fn code(&self) -> Code {
        self.code
    }
}

/// An error of the library about one input.
fn refuse(name: &str, code: Code) -> impl Fn(&dyn fmt::Display) -> PyErr + use<> {
    let name = name.to_owned();
    move |error| raise_problem(&InputProblem { name: name.clone(), reason: error.to_string(), code })
}

/// The inputs of a function, random ones before the others.
#[derive(Default)]
pub struct Inputs {
    /// Names of the random inputs.
    pub random_names: Vec<String>,
    /// Distributions of the random inputs.
    pub random: Vec<RandomVariable>,
    /// Names of the epistemic inputs; a parameter of a distribution is called `input.parameter`.
    pub epistemic_names: Vec<String>,
    /// Structures of the unknown inputs: intervals, lists or other descriptions.
    pub epistemic: Vec<EpistemicVariable>,
    /// Parameters of distributions among them.
    pub parameters: Vec<EpistemicParameter>,
}

impl Inputs {
    /// Reads inputs in their order, each an object of one of the classes of `_inputs.py`.
    pub fn read(inputs: Vec<(String, Bound<'_, PyAny>)>) -> PyResult<Self> {
        let mut read = Self::default();
        for (name, input) in inputs {
            match epistemic(&name, &input)? {
                Some(variable) => {
                    read.epistemic_names.push(name);
                    read.epistemic.push(variable);
                }
                None => read.push_random(name, &input)?,
            }
        }
        Ok(read)
    }

    fn push_random(&mut self, name: String, input: &Bound<'_, PyAny>) -> PyResult<()> {
        for parameter in Parameter::ALL {
            let Ok(stated) = input.getattr(parameter.key()) else { continue };
            let of_parameter = format!("{name}.{}", parameter.key());
            if let Some(variable) = epistemic(&of_parameter, &stated)? {
                let (random, epistemic) = (self.random.len(), self.epistemic.len());
                self.parameters.push(EpistemicParameter { random, parameter, epistemic });
                self.epistemic_names.push(of_parameter);
                self.epistemic.push(variable);
            }
        }
        let refused = refuse(&name, Code::BadDistribution);
        let variable = RandomVariable::try_new(distribution(&name, input)?).map_err(|error| refused(&error))?;
        self.random.push(variable);
        self.random_names.push(name);
        Ok(())
    }

    /// The copula of rank correlations between random inputs; `None` if none is stated.
    pub fn copula(&self, ranks: &[(String, String, f64)]) -> PyResult<Option<GaussianCopula>> {
        if ranks.is_empty() {
            return Ok(None);
        }
        let place = |name: &str| {
            let found = self.random_names.iter().position(|known| known == name);
            found.ok_or_else(|| PyValueError::new_err(format!("correlation of '{name}', which is not a random input")))
        };
        let pair = |(first, second, rank): &(String, String, f64)| {
            Ok(Pair { first: place(first)?, second: place(second)?, normal: normal_of_rank(*rank) })
        };
        let pairs = ranks.iter().map(pair).collect::<PyResult<Vec<Pair>>>()?;
        let refused = refuse("correlation", Code::BadCorrelation);
        GaussianCopula::try_new(self.random.len(), pairs).map(Some).map_err(|error| refused(&error))
    }
}

/// A law whose parameters are all numbers; it is called by its class.
///
/// # Errors
/// A parameter that is unknown: the law is then a box, and has no single distribution function.
pub fn certain_law(law: &Bound<'_, PyAny>) -> PyResult<RandomVariable> {
    let name = law.get_type().name()?.to_string();
    for parameter in Parameter::ALL {
        // A law has only some of the parameters.
        let Some(stated) = law.getattr_opt(parameter.key())? else { continue };
        if epistemic(&name, &stated)?.is_some() {
            return Err(PyValueError::new_err(format!(
                "{} of {name} is unknown (epistemic), so it has no single distribution function; must be a number",
                parameter.key()
            )));
        }
    }
    let refused = refuse(&name, Code::BadDistribution);
    RandomVariable::try_new(distribution(&name, law)?).map_err(|error| refused(&error))
}

/// Description of an epistemic input; `None` if the object is none.
fn epistemic(name: &str, input: &Bound<'_, PyAny>) -> PyResult<Option<EpistemicVariable>> {
    let number = |key: &str| number(name, key, &input.getattr(key)?);
    let interval = |lower, upper| {
        let refused = refuse(name, Code::IntervalTurnedRound);
        Interval::try_new(lower, upper).map_err(|error| refused(&error))
    };
    let variable = match input.get_type().name()?.to_string_lossy().as_ref() {
        "Interval" => interval(number("lower")?, number("upper")?)?.into(),
        "Periodic" => EpistemicVariable::Periodic(interval(number("lower")?, number("upper")?)?),
        "OneOf" => {
            let refused = refuse(name, Code::BadList);
            let members: Vec<f64> = stated_as(name, "values", "a list of numbers", &input.getattr("values")?)?;
            Members::try_new(members).map_err(|error| refused(&error))?.into()
        }
        "Evidence" => {
            let refused = refuse(name, Code::BadEvidence);
            let due = "a list of (lower, upper, mass)";
            let stated: Vec<(f64, f64, f64)> = stated_as(name, "elements", due, &input.getattr("elements")?)?;
            let element = |(lower, upper, mass)| Ok(FocalElement { interval: interval(lower, upper)?, mass });
            let elements = stated.into_iter().map(element).collect::<PyResult<Vec<_>>>()?;
            Evidence::try_new(elements).map_err(|error| refused(&error))?.into()
        }
        "Fuzzy" => {
            let refused = refuse(name, Code::BadEvidence);
            let corners: [f64; 4] = stated_as(name, "corners", "four numbers", &input.getattr("corners")?)?;
            FuzzyNumber::trapezoidal(corners, &USUAL_CUTS).map_err(|error| refused(&error))?.into()
        }
        _ => return Ok(None),
    };
    Ok(Some(variable))
}

/// A parameter that must be a number.
fn number(name: &str, key: &str, stated: &Bound<'_, PyAny>) -> PyResult<f64> {
    stated_as(name, key, "a number", stated)
}

/// A parameter of the input `name`, or an exception that says what it is and what is `due`.
fn stated_as<'py, T: FromPyObjectOwned<'py>>(
    name: &str,
    key: &str,
    due: &str,
    stated: &Bound<'py, PyAny>,
) -> PyResult<T> {
    stated.extract().or_else(|_| {
        let class = stated.get_type().name()?;
        Err(PyTypeError::new_err(format!("input '{name}': {key} is a {class}; must be {due}")))
    })
}

/// A distribution, with uncertain parameters in the middle of their ranges.
fn distribution(name: &str, input: &Bound<'_, PyAny>) -> PyResult<Distribution> {
    let n = |key: &str| {
        let stated = input.getattr(key)?;
        match epistemic(name, &stated)? {
            Some(known) => Ok(known.middle()),
            None => number(name, key, &stated),
        }
    };
    let list = |key: &str| stated_as::<Vec<f64>>(name, key, "a list of numbers", &input.getattr(key)?);
    let class = input.get_type().name()?;
    Ok(match class.to_string_lossy().as_ref() {
        "Normal" => Distribution::Normal { mean: n("mean")?, standard_deviation: n("standard_deviation")? },
        "TruncatedNormal" => Distribution::TruncatedNormal {
            mean: n("mean")?,
            standard_deviation: n("standard_deviation")?,
            lower: n("lower")?,
            upper: n("upper")?,
        },
        "Uniform" => Distribution::Uniform { lower: n("lower")?, upper: n("upper")? },
        "Lognormal" => Distribution::Lognormal { mean: n("mean")?, standard_deviation: n("standard_deviation")? },
        "Triangular" => Distribution::Triangular { lower: n("lower")?, mode: n("mode")?, upper: n("upper")? },
        "Beta" => Distribution::Beta { alpha: n("alpha")?, beta: n("beta")?, lower: n("lower")?, upper: n("upper")? },
        "Weibull" => Distribution::Weibull { shape: n("shape")?, scale: n("scale")?, lower: n("lower")? },
        "Gamma" => Distribution::Gamma { shape: n("shape")?, scale: n("scale")?, lower: n("lower")? },
        "Gumbel" => Distribution::Gumbel { mode: n("mode")?, scale: n("scale")? },
        "Exponential" => Distribution::Exponential { mean: n("mean")?, lower: n("lower")? },
        "Discrete" => Distribution::Discrete { values: list("values")?, probabilities: list("probabilities")? },
        "Empirical" => {
            let mut values = list("values")?;
            values.sort_by(f64::total_cmp);
            Distribution::Empirical { values: values.into() }
        }
        other => {
            return Err(PyTypeError::new_err(format!(
                "input '{name}' is a {other}; must be a distribution such as loosepin.Normal, or an unknown (epistemic) input such as loosepin.Interval"
            )));
        }
    })
}
