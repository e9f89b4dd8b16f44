//! What may be overlooked: its volume and its height.

use loosepin_uncertainty::{hash, uniform};

/// Something that sets an extreme and may be overlooked.
#[derive(Debug, Clone)]
pub struct Feature {
    pub name: &'static str,
    /// Share of the unit box in which it is above half of its height; of an edge the smaller side.
    pub volume: f64,
    /// Its height, > 0.
    pub height: f64,
    /// Whether it sets the smallest and the largest possible value.
    pub ends: [bool; 2],
}

/// Points that volumes are measured with: one of 0.0045 has a relative error of 7 %.
const POINTS: u64 = 40_000;

/// Share of the unit box in which something holds.
pub fn share(dimensions: usize, holds: impl Fn(&[f64]) -> bool) -> f64 {
    let mut t = vec![0.0; dimensions];
    let held = (0..POINTS).filter(|&point| {
        t[0] = (point as f64 + 0.5) / POINTS as f64;
        for (axis, t) in t.iter_mut().enumerate().skip(1) {
            *t = uniform(hash(8, point), axis as u64);
        }
        holds(&t)
    });
    held.count() as f64 / POINTS as f64
}

/// Volume of the part of a ball that is in the unit box, by points of the cube around it.
pub fn ball_volume(centre: &[f64], radius: f64) -> f64 {
    let dimensions = centre.len();
    let inside = share(dimensions, |t| {
        let offset = |t: &f64| radius * (2.0 * t - 1.0);
        let is_in_ball = t.iter().map(|t| offset(t).powi(2)).sum::<f64>() <= radius * radius;
        is_in_ball && t.iter().zip(centre).all(|(t, c)| (0.0..=1.0).contains(&(c + offset(t))))
    });
    inside * (2.0 * radius).powi(dimensions as i32)
}

#[cfg(test)]
mod tests {
    use super::{ball_volume, share};
    use std::f64::consts::PI;

    #[test]
    fn analytic_volumes_are_those_of_balls_and_slabs() {
        /// Of 40,000 points: three standard errors of the least of these shares of the cube around a ball, 0.31.
        const TOLERANCE: f64 = 0.03;
        let known = [
            (ball_volume(&[0.5, 0.4], 0.1), PI * 0.01),
            (ball_volume(&[0.0, 1.0], 0.1), PI * 0.0025),
            (ball_volume(&[0.3, 0.5, 0.6], 0.05), 4.0 / 3.0 * PI * 0.05_f64.powi(3)),
            (ball_volume(&[0.3, 0.5, 0.6, 0.4], 0.2), PI * PI / 2.0 * 0.2_f64.powi(4)),
            (share(3, |t| t[1] > 0.4 && t[2] < 0.5), 0.3),
        ];
        for (found, exact) in known {
            assert!((found / exact - 1.0).abs() <= TOLERANCE, "{found} {exact}");
        }
    }
}
