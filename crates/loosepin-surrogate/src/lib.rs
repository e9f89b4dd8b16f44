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
mod eigen;
mod ensemble;
mod error;
mod fitted;
mod gaussian_process;
mod held_out;
mod index_set;
mod input;
mod kernel;
mod kriging;
mod least_angle;
mod likelihood;
mod modes;
mod network;
mod onnx;
mod options;
mod output;
mod polynomial;
mod quality;
mod regression;
mod residual;
mod spread;
mod trained;
mod training;
pub mod trials;

pub use chaos::{Chaos, Term};
pub use data::{FEWEST_RUNS, TrainingData, TrainingOutput};
pub use ensemble::Ensemble;
pub use error::SurrogateError;
pub use fitted::{Fitted, Form, Kind};
pub use gaussian_process::{Factor, Whitened, matern_five_halves, matern_five_halves_of};
pub use input::Input;
pub use kernel::Kernel;
pub use kriging::Kriging;
pub use loosepin_terms::SurrogateVerdict;
pub use modes::Modes;
pub use network::Network;
pub use onnx::OnnxMetadata;
pub use options::{Choice, Options};
pub use output::OutputSurrogate;
pub use polynomial::Family;
pub use quality::Quality;
pub use residual::{Residual, SHARES};
pub use spread::Spread;
pub use trained::from_versioned_json;
pub use trained::{Prediction, Surrogate};

#[cfg(test)]
mod cases;
