//! Random variables: distributions stated in files, checked, fitted, with parameters that are themselves uncertain. The mathematics of a
//! family stands in `family`; intervals and evidence outside of these folders.

pub(crate) mod distribution;
pub(crate) mod open_end;
pub(crate) mod parameter;
pub(crate) mod random_variable;
pub(crate) mod sample_fit;
pub(crate) mod second_order;
