//! Numbers of Radau IIA of three stages (Hairer and Wanner, section IV.8).

/// √6.
const ROOT: f64 = 2.449489742783178;
/// c.
pub(super) const NODES: [f64; 3] = [(4.0 - ROOT) / 10.0, (4.0 + ROOT) / 10.0, 1.0];
/// b, the last row of A.
pub(super) const WEIGHTS: [f64; 3] = [(16.0 - ROOT) / 36.0, (16.0 + ROOT) / 36.0, 1.0 / 9.0];
/// Real eigenvalue γ of A⁻¹.
pub(super) const GAMMA: f64 = 3.637834252744496;
/// Real part of the others.
pub(super) const ALPHA: f64 = 2.6810828736277523;
/// Imaginary part of the others.
pub(super) const BETA: f64 = 3.050430199247411;
/// T of A⁻¹ = T diag(γ, [α -β; β α]) T⁻¹.
pub(super) const T: [[f64; 3]; 3] = [
    [0.09123239487089295, -0.1412552950209542, -0.030029194105147424],
    [0.241717932707107, 0.20412935229379994, 0.3829421127572619],
    [0.966048182615093, 1.0, 0.0],
];
/// T⁻¹.
pub(super) const T_INVERSE: [[f64; 3]; 3] = [
    [4.325579890063155, 0.33919925181580984, 0.5417705399358749],
    [-4.178718591551905, -0.32768282076106237, 0.47662355450055044],
    [-0.5028726349457868, 2.571926949855605, -0.5960392048282249],
];
/// Shares of the stages in the error estimate: (γ/h - J)⁻¹ (f(y) + Σ e_i (Y_i - y)/h).
pub(super) const ERROR: [f64; 3] = [-(13.0 + 7.0 * ROOT) / 3.0, (-13.0 + 7.0 * ROOT) / 3.0, -1.0 / 3.0];

#[cfg(test)]
mod tests {
    use super::*;

    /// A from its defining property, Σ a_ij c_j^(k-1) = c_i^k/k for k = 1, 2, 3, and A⁻¹ = T Λ T⁻¹.
    #[test]
    fn identity_the_tables_are_those_of_the_collocation_at_radaus_points() {
        let blocks = [[GAMMA, 0.0, 0.0], [0.0, ALPHA, -BETA], [0.0, BETA, ALPHA]];
        let product = |left: &[[f64; 3]; 3], right: &[[f64; 3]; 3]| -> [[f64; 3]; 3] {
            std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| left[i][k] * right[k][j]).sum()))
        };
        let inverse = product(&product(&T, &blocks), &T_INVERSE);
        let unit = product(&T, &T_INVERSE);
        for i in 0..3 {
            for k in 1..=3 {
                // A⁻¹ (c^k/k) = c^(k-1).
                let found: f64 = (0..3).map(|j| inverse[i][j] * NODES[j].powi(k) / f64::from(k)).sum();
                assert!((found - NODES[i].powi(k - 1)).abs() < 1e-13, "{i} {k}: {found}");
            }
            for (j, entry) in unit[i].iter().enumerate() {
                assert!((entry - if i == j { 1.0 } else { 0.0 }).abs() < 1e-14);
            }
        }
        for k in 0..3 {
            let sum: f64 = (0..3).map(|j| WEIGHTS[j] * NODES[j].powi(k)).sum();
            assert!((sum - 1.0 / f64::from(k + 1)).abs() < 1e-15);
        }
    }
}
