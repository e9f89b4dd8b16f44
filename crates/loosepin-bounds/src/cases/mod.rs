//! Problems whose bounds are known in closed form or by quadrature.

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
