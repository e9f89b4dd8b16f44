//! Problems whose bounds are known in closed form or by quadrature.
//! Each problem is a file with its test. The measured campaigns stand in `tests/`.

mod any_statistic;
mod correlated;
mod curves;
mod discrete;
mod evidence;
pub(crate) mod exact;
mod kink;
mod noisy;
mod parameter;
mod periodic;
mod promise;
mod sampling;
mod second_order;
mod simultaneous;
mod tail;
