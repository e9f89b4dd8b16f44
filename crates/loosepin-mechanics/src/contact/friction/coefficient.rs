//! The force of a friction law against its coefficient, for the test of each law.

use super::Friction;

/// Asserts the force of `law` against μ(v), v >= 0, from rest to fast sliding and in both directions; that friction never supplies
/// power; and that the force jumps nowhere and its slope only where the law says so.
pub(super) fn assert_coefficient<F: Friction<f64>>(law: &F, coefficient: impl Fn(f64) -> f64) {
    const NORMAL_N: f64 = 1700.0;
    let kinks: Vec<f64> = law.kink_speeds_m_s().into_iter().flatten().collect();
    let mut speed_m_s = 1e-9;
    while speed_m_s < 20.0 {
        let expected_n = coefficient(speed_m_s) * NORMAL_N;
        for sign in [-1.0, 1.0] {
            let force_n = law.force_n(sign * speed_m_s, NORMAL_N);
            // Round-off on a few hundred newtons.
            assert!((force_n + sign * expected_n).abs() < 1e-10, "{speed_m_s}: {force_n} {expected_n}");
            assert!(force_n * sign * speed_m_s <= 0.0, "friction never supplies power");
        }
        // Slopes on both sides of the place, over a share of it; they differ by that share where there is no kink.
        let step_m_s = 1e-6 * speed_m_s;
        let slope = |from: f64, to: f64| (law.force_n(to, NORMAL_N) - law.force_n(from, NORMAL_N)) / (to - from);
        let (left, right) = (slope(speed_m_s - step_m_s, speed_m_s), slope(speed_m_s, speed_m_s + step_m_s));
        let is_kink = kinks.iter().any(|kink| (speed_m_s - kink).abs() < 2.0 * step_m_s);
        let steepest = NORMAL_N * 10.0 / speed_m_s.max(1e-4);
        assert!(is_kink || (left - right).abs() < 1e-4 * steepest, "{speed_m_s}: slopes {left} and {right}");
        speed_m_s *= 1.01;
    }
    // At rest there is no force, and it does not jump there.
    assert_eq!(law.force_n(0.0, NORMAL_N), 0.0);
    assert!((law.force_n(1e-12, NORMAL_N) - law.force_n(-1e-12, NORMAL_N)).abs() < 1e-4);
    for kink in kinks {
        let (below, above) = (law.force_n(kink * (1.0 - 1e-9), NORMAL_N), law.force_n(kink * (1.0 + 1e-9), NORMAL_N));
        assert!((below - above).abs() < 1e-5, "the force is continuous at {kink}");
    }
}
