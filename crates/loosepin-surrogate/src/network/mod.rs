//! Neural networks.
//! One hidden layer, its training, and several of them together. Files for other programs are written in `onnx`.

pub(crate) mod ensemble;
pub(crate) mod layer;
pub(crate) mod training;
