//! Networks as ONNX, the exchange format that other programs evaluate: scaling of the inputs, layers, scaling of the outputs and modes
//! of a curve are nodes of one graph in double precision.
//!
//! ```text
//! "inputs" [batch, d]  ->  z = (x - c) f  ->  t = tanh(z W + b)  ->  a = μ + σ (t V + v)  ->  y = m + a Φ  ->  "values" [batch, places]
//! ```
//!
//! W, b hold the neurons of all networks of all modes side by side; V takes the mean over the networks of each mode; μ, σ scale the
//! score of a mode, m and Φ are the mean curve and the shapes of the modes. A row of which an input lies outside of the range that the
//! surrogate answers in comes out as not-a-number. The spread of the error and what is left of the runs are not part of the graph.

mod graph;
mod protobuf;

pub(super) use graph::{Layers, model};

/// Metadata of a file: pairs of a name and a text, in this order.
pub type OnnxMetadata = Vec<(String, String)>;
