//! Options of a fit.

use super::fitted::Kind;

/// Which kind of surrogate.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Choice {
    /// That with the least held-out error, for each output and each mode of a curve.
    #[default]
    Auto,
    /// This one.
    Only(Kind),
}

/// Options of a fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// Which kind; automatic by default.
    pub choice: Choice,
    /// Seed of the folds and of the first weights of networks; 1 by default.
    pub seed: u64,
    /// Share of the variance of a curve that its modes may leave out; 1e-5 by default, 0.3 % of its standard deviation.
    pub left_share: f64,
    /// Most modes of a curve; 20 by default.
    pub most_modes: usize,
    /// Most neurons of a network; 16 by default. Training takes the third power of it.
    pub most_neurons: usize,
}

impl Default for Options {
    fn default() -> Self {
        Self { choice: Choice::Auto, seed: 1, left_share: 1e-5, most_modes: 20, most_neurons: 16 }
    }
}

impl Options {
    pub(super) fn kinds(&self) -> Vec<Kind> {
        match self.choice {
            Choice::Auto => Kind::ALL.to_vec(),
            Choice::Only(kind) => vec![kind],
        }
    }

    pub(super) fn kind_name(&self) -> &'static str {
        match self.choice {
            Choice::Auto => "a surrogate",
            Choice::Only(kind) => kind.name(),
        }
    }
}
