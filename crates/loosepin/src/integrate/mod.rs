//! Embedded Runge-Kutta pairs with error control and dense output.
