//! One number as a function of the inputs: the four kinds behind one interface.

use super::design::{Design, mean_and_deviation};
use crate::chaos::expansion::Chaos;
use crate::gaussian::kriging::Kriging;
use crate::network::ensemble::Ensemble;
use serde::{Deserialize, Serialize};

/// A kind of surrogate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// The mean of the runs: right for a constant output, and the fair answer where nothing can be learned.
    Constant,
    /// Sparse polynomial chaos.
    Chaos,
    /// Kriging.
    Kriging,
    /// An ensemble of neural networks.
    Network,
}

impl Kind {
    /// All, in the order in which equal ones are preferred.
    pub const ALL: [Self; 4] = [Self::Constant, Self::Chaos, Self::Kriging, Self::Network];

    /// Name of the kind in texts.
    pub fn name(self) -> &'static str {
        match self {
            Self::Constant => "constant",
            Self::Chaos => "polynomial chaos",
            Self::Kriging => "Kriging",
            Self::Network => "neural network",
        }
    }
}

/// A fitted number: mean + deviation times the fit to the scaled values.
#[derive(Clone, Serialize, Deserialize)]
pub struct Fitted {
    mean: f64,
    deviation: f64,
    form: Form,
}

/// The fitted form.
#[derive(Clone, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Form {
    /// Nothing: the mean.
    Constant,
    /// Polynomials.
    Chaos(Chaos),
    /// A Gaussian process.
    Kriging(Box<Kriging>),
    /// Networks.
    Network(Ensemble),
}

/// Start of a fit to all runs from a fit to some of them: not its results, but where its search begins.
pub(super) enum WarmStart<'a> {
    /// Kernel, trend and first parameters of a process.
    Process(&'a Kriging),
    /// Neurons of a network.
    Neurons(usize),
    /// Nothing.
    Nothing,
}

impl Fitted {
    /// Fits `values`, with their known variances `noise`, at the points of `design`; `None` if this kind cannot be
    /// fitted to them. Only a process makes use of the variances.
    pub(super) fn fit(
        kind: Kind,
        design: &Design,
        values: &[f64],
        noise: &[f64],
        seed: u64,
        like: &WarmStart,
    ) -> Option<Self> {
        let (mean, deviation) = mean_and_deviation(values);
        if kind == Kind::Constant || deviation == 0.0 {
            return Some(Self { mean, deviation, form: Form::Constant });
        }
        let standard: Vec<f64> = values.iter().map(|value| (value - mean) / deviation).collect();
        let form = match kind {
            Kind::Constant => Form::Constant,
            Kind::Chaos => Form::Chaos(Chaos::fit(design, &standard)),
            Kind::Kriging => {
                let like = if let WarmStart::Process(process) = like { Some(*process) } else { None };
                let noise: Vec<f64> = noise.iter().map(|variance| variance / (deviation * deviation)).collect();
                Form::Kriging(Box::new(Kriging::fit(&design.scaled, &standard, &noise, like)?))
            }
            Kind::Network => {
                let neurons = if let WarmStart::Neurons(neurons) = like { *neurons } else { 6 };
                Form::Network(Ensemble::fit(design, &standard, neurons, seed))
            }
        };
        Some(Self { mean, deviation, form })
    }

    /// Value and the form's own standard deviation at a point, given scaled and as standard variables.
    pub(super) fn predict(&self, scaled: &[f64], germ: &[f64]) -> (f64, f64) {
        let (value, spread) = match &self.form {
            Form::Constant => (0.0, f64::from(u8::from(self.deviation > 0.0))),
            Form::Chaos(chaos) => chaos.predict(germ),
            Form::Kriging(process) => process.predict(scaled),
            Form::Network(ensemble) => ensemble.predict(scaled),
        };
        (self.mean + self.deviation * value, self.deviation * spread)
    }

    /// The fitted form.
    pub fn form(&self) -> &Form {
        &self.form
    }

    /// Its kind.
    pub fn kind(&self) -> Kind {
        match self.form {
            Form::Constant => Kind::Constant,
            Form::Chaos(_) => Kind::Chaos,
            Form::Kriging(_) => Kind::Kriging,
            Form::Network(_) => Kind::Network,
        }
    }

    /// Mean and standard deviation of the values that it was fitted to.
    pub(super) fn scale(&self) -> (f64, f64) {
        (self.mean, self.deviation)
    }

    /// Start for a fit to some of the runs.
    pub(super) fn warm_start(&self) -> WarmStart<'_> {
        match &self.form {
            Form::Kriging(process) => WarmStart::Process(process),
            Form::Network(ensemble) => WarmStart::Neurons(ensemble.neurons()),
            Form::Constant | Form::Chaos(_) => WarmStart::Nothing,
        }
    }
}
