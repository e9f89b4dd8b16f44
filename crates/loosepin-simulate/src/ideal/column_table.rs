//! The ideal values of all columns over a short span of time as polynomials, for runs whose steps are much shorter.

/// Nodes of a span: Chebyshev's points of the second kind, ends included.
const NODES: usize = 9;
/// Length of a span over that of a step, at least: a table costs as many evaluations as are looked at in three steps.
const MIN_STEPS: f64 = 8.0;
/// Places between the nodes at which a table is compared with the motion, as shares of the span.
const CHECKED: [f64; 3] = [0.09, 0.4, 0.77];
/// Difference there, at most, over the largest value at the nodes. A kink anywhere in the span is seen at all of the places.
const MAX_DIFFERENCE: f64 = 1e-11;

/// Ideal values by column. A span with a kink or a jump, as that of friction or of a table of a load, has none.
#[derive(Debug, Clone)]
pub(crate) struct ColumnTable {
    /// Length of a span, s.
    length_s: f64,
    start_s: f64,
    end_s: f64,
    /// Values of all columns at the first node, then at the next; empty where a polynomial is not good enough.
    values: Vec<f64>,
}

impl ColumnTable {
    /// Tables of spans of `length_s`.
    pub fn new(length_s: f64) -> Self {
        Self { length_s, start_s: f64::NAN, end_s: f64::NAN, values: Vec::new() }
    }

    /// Whether the table holds the step from `start_s` to `end_s`. Where it does not reach as far, a new one is made if the step is short;
    /// it ends at `break_s` at the latest. `exact` gives the ideal values at a time.
    ///
    /// # Errors
    /// That of `exact`.
    pub fn holds<E>(
        &mut self,
        [start_s, end_s]: [f64; 2],
        break_s: f64,
        mut exact: impl FnMut(f64) -> Result<Vec<f64>, E>,
    ) -> Result<bool, E> {
        if !(self.start_s <= start_s && end_s <= self.end_s) {
            let until_s = (start_s + self.length_s).min(break_s);
            if !(MIN_STEPS * (end_s - start_s) <= until_s - start_s) {
                return Ok(false);
            }
            self.make([start_s, until_s], &mut exact)?;
        }
        Ok(!self.values.is_empty())
    }

    fn make<E>(
        &mut self,
        [start_s, end_s]: [f64; 2],
        exact: &mut impl FnMut(f64) -> Result<Vec<f64>, E>,
    ) -> Result<(), E> {
        (self.start_s, self.end_s) = (start_s, end_s);
        self.values.clear();
        let at = |share: f64| start_s + share * (end_s - start_s);
        for node in 0..NODES {
            self.values.extend(exact(at(node_share(node)))?);
        }
        let columns = self.values.len() / NODES;
        for share in CHECKED {
            let exact = exact(at(share))?;
            let weights = self.weights(at(share));
            let is_off = |column: usize| {
                let of_nodes = self.values[column..].iter().step_by(columns);
                let size = of_nodes.fold(0.0_f64, |size, value| size.max(value.abs()));
                // Negated: what is not a number is off.
                !((self.value(&weights, column) - exact[column]).abs() <= MAX_DIFFERENCE * size)
            };
            if (0..columns).any(is_off) {
                self.values.clear();
                return Ok(());
            }
        }
        Ok(())
    }

    /// The weights of the values at the nodes at `time_s` within the span: the barycentric formula.
    pub fn weights(&self, time_s: f64) -> [f64; NODES] {
        let share = (time_s - self.start_s) / (self.end_s - self.start_s);
        let mut weights = [0.0; NODES];
        for (node, weight) in weights.iter_mut().enumerate() {
            let distance = share - node_share(node);
            if distance == 0.0 {
                weights = [0.0; NODES];
                weights[node] = 1.0;
                return weights;
            }
            let end = if node == 0 || node == NODES - 1 { 0.5 } else { 1.0 };
            *weight = if node % 2 == 0 { end } else { -end } / distance;
        }
        let sum: f64 = weights.iter().sum();
        weights.map(|weight| weight / sum)
    }

    /// The ideal value of a column where the nodes have these [`Self::weights`].
    pub fn value(&self, weights: &[f64; NODES], column: usize) -> f64 {
        let columns = self.values.len() / NODES;
        weights.iter().enumerate().map(|(node, weight)| weight * self.values[node * columns + column]).sum()
    }
}

/// The nodes, as shares of a span: (1 - cos(kπ/8))/2.
fn node_share(node: usize) -> f64 {
    const SHARES: [f64; NODES] = [
        0.0,
        0.038_060_233_744_356_624,
        0.146_446_609_406_726_24,
        0.308_658_283_817_455_1,
        0.5,
        0.691_341_716_182_544_9,
        0.853_553_390_593_273_8,
        0.961_939_766_255_643_4,
        1.0,
    ];
    SHARES[node]
}

#[cfg(test)]
mod tests {
    use super::{ColumnTable, NODES, node_share};
    use std::convert::Infallible;

    const SPAN_S: f64 = 0.002;

    fn holds(table: &mut ColumnTable, step_s: [f64; 2], break_s: f64, motion: fn(f64) -> f64) -> bool {
        table.holds(step_s, break_s, |time_s| Ok::<_, Infallible>(vec![1.0, motion(time_s)])).unwrap()
    }

    #[test]
    fn analytic_nodes_are_those_of_chebyshev() {
        for node in 0..NODES {
            let share = 0.5 - 0.5 * (node as f64 * std::f64::consts::PI / 8.0).cos();
            assert!((node_share(node) - share).abs() < 1e-15);
        }
    }

    #[test]
    fn analytic_a_smooth_motion_is_what_the_table_says() {
        // With a fifth harmonic, over a hundredth of a turn.
        let motion = |time_s: f64| (31.0 * time_s).sin() + 0.2 * (155.0 * time_s).cos();
        let mut table = ColumnTable::new(SPAN_S);
        assert!(holds(&mut table, [0.3, 0.3001], f64::INFINITY, motion));
        for k in 0..=1000 {
            let time_s = 0.3 + SPAN_S * f64::from(k) / 1000.0;
            let weights = table.weights(time_s);
            assert!((table.value(&weights, 1) - motion(time_s)).abs() < 1e-11);
            assert!((table.value(&weights, 0) - 1.0).abs() < 1e-14);
        }
    }

    #[test]
    fn analytic_a_motion_with_a_kink_has_no_table_and_long_steps_need_none() {
        let mut table = ColumnTable::new(SPAN_S);
        for kink in [0.30001, 0.3005, 0.30099, 0.30145, 0.30199] {
            assert!(
                !ColumnTable::new(SPAN_S)
                    .holds([0.3, 0.3001], f64::INFINITY, |time_s| Ok::<_, Infallible>(vec![(time_s - kink).abs()]))
                    .unwrap()
            );
        }
        assert!(!holds(&mut table, [0.3, 0.301], f64::INFINITY, |time_s| time_s));
        // Nothing beyond a break, where a new piece begins.
        assert!(holds(&mut table, [0.3, 0.3001], 0.301, |time_s| time_s));
        assert!(!holds(&mut table, [0.30095, 0.30105], 0.30105, |time_s| time_s));
    }
}
