//! Surrogates: functions learned from runs, with what they do not know.
//!
//! [`TrainingData`] are points in the distributions and intervals of the inputs, and what came out there: numbers, or curves
//! over the cycle. [`Surrogate::fit`] turns a curve into a few modes ([`Modes`]) and fits every mode by a kind ([`Kind`]):
//!
//! * [`Chaos`]: sparse polynomial chaos, orthonormal under the distributions, Chebyshev's polynomials in the intervals;
//! * [`Kriging`]: a Gaussian process with one length scale an input, nugget and known noise;
//! * [`Ensemble`]: neural networks, trained by Levenberg-Marquardt with Bayesian regularisation.
//!
//! [`Choice::Auto`] takes for each mode the kind with the least held-out error. No surrogate comes without its [`Quality`],
//! the held-out error of each output, along a curve at each place, with everything learned anew for each part that is held
//! out (`held_out.rs`); nor without its [`Residual`]: whether what is left falls with more runs, and its distribution where it
//! does not. Outside the range of its runs it gives no answer ([`SurrogateError::Extrapolation`]).
//!
//! The linear algebra is ours, in a fixed order (`math::dense`): a library chooses instructions at run time, and with them
//! the last bits of every search. So a fit has the same bits on every processor, for any number of threads.

mod chaos;
mod data;
mod design;
mod error;
mod fitted;
mod gaussian;
mod held_out;
mod input;
mod modes;
mod network;
mod onnx;
mod options;
mod output;
mod quality;
mod residual;
mod spread;
mod trained;
pub mod trials;

pub use chaos::expansion::{Chaos, Term};
pub use chaos::polynomial::Family;
pub use data::{FEWEST_RUNS, TrainingData, TrainingOutput};
pub use error::SurrogateError;
pub use fitted::{Fitted, Form, Kind};
pub use gaussian::gaussian_process::{Factor, Whitened, matern_five_halves, matern_five_halves_of};
pub use gaussian::kernel::Kernel;
pub use gaussian::kriging::Kriging;
pub use input::Input;
pub use loosepin_terms::SurrogateVerdict;
pub use modes::Modes;
pub use network::ensemble::Ensemble;
pub use network::layer::Network;
pub use onnx::OnnxMetadata;
pub use options::{Choice, Options};
pub use output::OutputSurrogate;
pub use quality::Quality;
pub use residual::{Residual, SHARES};
pub use spread::Spread;
pub use trained::from_versioned_json;
pub use trained::{Prediction, Surrogate};

#[cfg(test)]
mod cases;
