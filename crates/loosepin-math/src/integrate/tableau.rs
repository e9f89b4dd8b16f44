//! An embedded pair of explicit Runge-Kutta methods as data.

/// Entries of a row that are not zero: (stage, coefficient).
pub type TableauRow = &'static [(usize, f64)];

/// How the error of a step is estimated from its stages.
#[derive(Debug, Clone, Copy)]
pub enum ErrorEstimate {
    /// h Σ eᵢ kᵢ; may use the stage at the end of the step.
    Single(TableauRow),
    /// Hairer's combination of two estimates, err = |h| e5²/√(e5² + 0.01 e3²); uses no stage at the end of the step.
    Combined {
        /// Weights of the estimate of order 5.
        fifth: TableauRow,
        /// Weights of the estimate of order 3.
        third: TableauRow,
    },
}

/// An explicit pair with dense output. Stage 0 is the derivative at the start of the step; the stage after the last is the
/// derivative at its end, which is stage 0 of the next step.
#[derive(Debug)]
pub struct Tableau {
    /// Name of the method.
    pub name: &'static str,
    /// Order of the step.
    pub order: u32,
    /// c of each stage.
    pub nodes: &'static [f64],
    /// a of each stage.
    pub stages: &'static [TableauRow],
    /// b: the step.
    pub weights: TableauRow,
    /// The error estimate.
    pub error: ErrorEstimate,
    /// a of the further stages that only dense output needs; numbered after the derivative at the end.
    pub dense_stages: &'static [TableauRow],
    /// Rows of the dense output beyond those from both values and both derivatives.
    pub dense: &'static [TableauRow],
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integrate::{DOP853, DORMAND_PRINCE_5, TSITOURAS_5};

    /// A rooted tree of Butcher's theory: the trees that hang at its root, by index.
    struct Tree {
        order: u32,
        branches: Vec<usize>,
    }

    /// All rooted trees up to `order`.
    fn trees(order: u32) -> Vec<Tree> {
        let mut trees = vec![Tree { order: 1, branches: Vec::new() }];
        for order in 2..=order {
            let mut found = Vec::new();
            add_branches(&trees, order - 1, trees.len(), &mut Vec::new(), &mut found);
            trees.extend(found.into_iter().map(|branches| Tree { order, branches }));
        }
        trees
    }

    /// Every set of trees below `limit` with `left` nodes together, added to `chosen`.
    fn add_branches(trees: &[Tree], left: u32, limit: usize, chosen: &mut Vec<usize>, found: &mut Vec<Vec<usize>>) {
        if left == 0 {
            found.push(chosen.clone());
        }
        for branch in (0..limit).filter(|&branch| trees[branch].order <= left) {
            chosen.push(branch);
            add_branches(trees, left - trees[branch].order, branch + 1, chosen, found);
            chosen.pop();
        }
    }

    /// For each tree its order, its density γ and Σ row · Φ over the stages, the one at the end of the step included.
    fn elementary_weights(tableau: &Tableau, row: TableauRow, order: u32) -> Vec<(u32, f64, f64)> {
        let rows: Vec<TableauRow> = tableau.stages.iter().copied().chain([tableau.weights]).collect();
        let trees = trees(order);
        let mut densities: Vec<f64> = Vec::new();
        let mut stages: Vec<Vec<f64>> = Vec::new();
        for tree in &trees {
            densities.push(tree.branches.iter().fold(f64::from(tree.order), |product, &k| product * densities[k]));
            let of_stage = |row: &TableauRow| {
                let sum = |branch: usize| row.iter().map(|(j, a)| a * stages[branch][*j]).sum::<f64>();
                tree.branches.iter().map(|&branch| sum(branch)).product()
            };
            let of_tree = rows.iter().map(of_stage).collect();
            stages.push(of_tree);
        }
        let weight = |k: usize| row.iter().map(|(i, b)| b * stages[k][*i]).sum();
        (0..trees.len()).map(|k| (trees[k].order, densities[k], weight(k))).collect()
    }

    #[test]
    fn identity_trees_are_as_many_as_cayley_counted() {
        let trees = trees(8);
        for (order, count) in [1, 1, 2, 4, 9, 20, 48, 115].into_iter().enumerate() {
            assert_eq!(trees.iter().filter(|tree| tree.order as usize == order + 1).count(), count);
        }
    }

    #[test]
    fn identity_order_conditions() {
        // Σ b Φ = 1/γ for all trees up to the order of the step. Coefficients up to 50 in size are rounded at 1e-16.
        const ROUNDING: f64 = 1e-13;
        for tableau in [&DORMAND_PRINCE_5, &TSITOURAS_5, &DOP853] {
            for (order, density, weight) in elementary_weights(tableau, tableau.weights, tableau.order) {
                let error = (weight - 1.0 / density).abs();
                assert!(error < ROUNDING, "{}, order {order}: {weight} for 1/{density}", tableau.name);
            }
        }
    }

    #[test]
    fn identity_error_estimates_vanish_below_their_order() {
        // The pairs of order five compare with order four, DOP853 with five and three; one order further nothing cancels.
        const ROUNDING: f64 = 1e-13;
        let mut estimates = Vec::new();
        for tableau in [&DORMAND_PRINCE_5, &TSITOURAS_5, &DOP853] {
            match tableau.error {
                ErrorEstimate::Single(row) => estimates.push((tableau, row, 4)),
                ErrorEstimate::Combined { fifth, third } => {
                    estimates.extend([(tableau, fifth, 5), (tableau, third, 3)])
                }
            }
        }
        for (tableau, row, estimated) in estimates {
            let mut largest_beyond = 0.0_f64;
            for (order, _, weight) in elementary_weights(tableau, row, estimated + 1) {
                if order <= estimated {
                    assert!(weight.abs() < ROUNDING, "{}, order {order}: {weight}", tableau.name);
                } else {
                    largest_beyond = largest_beyond.max(weight.abs());
                }
            }
            assert!(largest_beyond > 1e-6, "{}: the estimate of order {estimated} is zero", tableau.name);
        }
    }

    #[test]
    fn identity_rows_sum_to_their_nodes() {
        for tableau in [&DORMAND_PRINCE_5, &TSITOURAS_5, &DOP853] {
            for (row, node) in tableau.stages.iter().zip(tableau.nodes) {
                let sum: f64 = row.iter().map(|(_, a)| a).sum();
                assert!((sum - node).abs() < 1e-14, "{}", tableau.name);
            }
        }
    }
}
