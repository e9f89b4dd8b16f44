//! The runs at a few u, weighted, in place of runs at many: where u is nothing but parameters of distributions.
//!
//! Then the response does not know u, and the runs at all outer points are one pool from the mixture of their distributions. At any
//! other u, with f the density of the random inputs that parameters belong to,
//!
//! ```text
//! q(x) = 1/K Σ_k f(x; u_k),   w_i = f(x_i; u)/q(x_i) over its sum,   E h(Y) ≈ E h(p(X)) + Σ_i w_i (h(y_i) - h(p(x_i)))
//! ```
//!
//! (A. Owen and Y. Zhou, "Safe and effective importance sampling", Journal of the American Statistical Association 95 (2000)
//! 135-143: weights from a mixture are never above K where u is one of its members, and a control variate takes out what it
//! explains; here p, a polynomial of the random inputs that each replicate takes from the others, or a constant where nothing better is
//! known. E h(p(X)) is taken at points at u, which cost no run.)
//!
//! What is wanted of u is by how much it lies beyond the outer point w that attains a bound. Both are estimated from the same pool, so
//! that near w their errors cancel:
//!
//! ```text
//! D(u) = S(u) - S(w), from each replicate its own;   S(u) <= S(w) + mean of D + t · its standard error
//! ```
//!
//! The bound keeps the value of the runs at w itself. At every u the weights must be worth enough independent runs,
//!
//! ```text
//! n = min((Σ W)²/Σ W²,  N/E_u(w)),   the first from the pool (L. Kish 1965), the second from points at u: it also sees what the pool misses
//! ```
//!
//! where W is the sum of the weights of the runs that one point of the unit cube was mapped to, one at each outer point: these share
//! their random numbers and are one draw. No draw weighs more than 1/√n then. Of quantiles enough draws must lie in the lesser part, and
//! enough must make up the spread of what a mean or variance averages; else nothing is said there: more runs are made at such a u, and
//! where that does not help the search goes by its models alone.
//!
//! Since a look at another u costs no run, u is searched by what is conceded itself: at corners, faces and inside, then by steps up from
//! the furthest places, and what a parabola may rise between the last steps is conceded.

mod climb;
mod gains;
mod ground;
mod next_points;
mod pooled;
mod stand_in;
mod weights;

use std::collections::BTreeMap;
use std::sync::Arc;

use rayon::prelude::*;

use super::plan::DoubleLoop;
use super::pool::Pool;
use super::search_box::Place;
use super::table::SampleTable;
use ground::Ground;
pub(super) use pooled::Pooled;

/// More columns than this are those of curves.
const MANY_COLUMNS: usize = 8;

/// A place beyond an extreme, as far as is known.
#[derive(Debug, Clone)]
pub(super) struct Beyond {
    /// How far the statistic may lie beyond that at the outer point, in units of what is searched; 0 where it does not.
    pub gain: f64,
    /// Where.
    pub place: Place,
}

/// How runs were weighted for values of the epistemic inputs at which none were made.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reweighted {
    /// Outer points, whose runs are the pool.
    pub points: usize,
    /// Places that they were compared with.
    pub places: usize,
    /// To how many independent runs the weights come at least, over these.
    pub least_effective: f64,
    /// Columns whose response polynomials stand for.
    pub polynomials: usize,
    /// Columns that were compared.
    pub columns: usize,
    /// Ends of bounds, distribution functions and bands whose search the weighted runs confirm.
    pub told: usize,
    /// Those that the weights are worth too little for: the models of the search alone tell how far these may go.
    pub untold: usize,
}

impl Pool {
    /// How the runs were weighted; nothing where they were not. `told` and `untold` are counted by whoever asks.
    pub fn reweighted(&self, told: usize, untold: usize) -> Option<Reweighted> {
        let first = self.points.first()?;
        let pooled: Vec<&Pooled> =
            self.column_numbers().filter_map(|column| self.samples(column).first()?.pooled()).collect();
        let ground = &pooled.first()?.ground;
        let outer = ground.layout.outer;
        debug_assert_eq!(ground.layout.rows(), first.runs);
        Some(Reweighted {
            points: outer,
            places: ground.seen.len() - outer,
            least_effective: ground.seen.iter().fold(f64::INFINITY, |least, seen| least.min(seen.effective)),
            polynomials: pooled.iter().filter(|pooled| pooled.is_smooth()).count(),
            columns: self.columns(),
            told,
            untold,
        })
    }

    /// The same with all runs weighted for other u, column by column, where the plan allows that and no run failed.
    pub fn with_weights(mut self, plan: &DoubleLoop, table: &SampleTable) -> Self {
        if self.points.len() > plan.most_reweighted() || self.points.is_empty() {
            return self;
        }
        let many = self.columns() > MANY_COLUMNS;
        let Some(ground) = Ground::new(plan, table, &self, many).map(Arc::new) else { return self };
        let designs = ground.designs();
        let columns: Vec<usize> = self.column_numbers().collect();
        let pooled: Vec<Option<Arc<Pooled>>> = columns
            .par_iter()
            .map(|&column| Pooled::new(&ground, &designs, &self.samples(column)).map(Arc::new))
            .collect();
        let pooled: BTreeMap<usize, Arc<Pooled>> =
            columns.into_iter().zip(pooled).filter_map(|(column, pooled)| Some((column, pooled?))).collect();
        for (column, pooled) in pooled {
            for sample in self.samples_mut(column) {
                sample.set_pooled(pooled.clone());
            }
        }
        self
    }
}
