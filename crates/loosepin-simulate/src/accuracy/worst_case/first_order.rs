//! First-order effect of play, for previews and as shares of joints.

use super::super::play_reach::PlayReach;
use loosepin_math::Vec2;

/// First-order worst case, the sum of [`PlayReach::worst_case_si`]: Σ c_k |g_k| for journals.
pub fn first_order_si(joints: &[(PlayReach, Vec2<f64>)]) -> f64 {
    joints.iter().map(|(reach, gradient)| reach.worst_case_si(*gradient)).sum()
}

/// Standard deviation with all joints uniform over their play: variance Σ c_k² |g_k|²/4 for journals in their discs,
/// (c² g_y² + θ_max² g_θ²)/6 for a slider, c² g_y²/3 for a pin in a slot.
pub fn disc_standard_deviation_si(joints: &[(PlayReach, Vec2<f64>)]) -> f64 {
    0.5 * root_sum_of_squares(joints, 0)
}

/// Standard deviation with all joints uniform on the borders of their play: variance Σ c_k² |g_k|²/2 for journals on their
/// rims, (c² g_y² + θ_max² g_θ²)/3 for a slider, c² g_y² for a pin in a slot.
pub fn rim_standard_deviation_si(joints: &[(PlayReach, Vec2<f64>)]) -> f64 {
    std::f64::consts::FRAC_1_SQRT_2 * root_sum_of_squares(joints, 1)
}

fn root_sum_of_squares(joints: &[(PlayReach, Vec2<f64>)], which: usize) -> f64 {
    joints.iter().map(|(reach, gradient)| reach.spreads_si2(*gradient)[which]).sum::<f64>().sqrt()
}
