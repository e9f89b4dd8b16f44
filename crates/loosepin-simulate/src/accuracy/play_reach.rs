//! Possible displacements of the second body of a joint with play from its ideal place.

use super::error::AccuracyError;
use loosepin_math::{Vec2, sin_cos};
use loosepin_mechanics::mechanism::{Mechanism, PlayFreedom, PlayGeometry, Sample};

/// The displacements that the clearance of a joint allows.
///
/// A displacement is a vector of two numbers: the eccentricity (e_x, e_y) of a journal in the ground's frame, m; the ordinate
/// y, m, and the angle θ, rad, of a slider in its guide; the ordinate of a pin in its slot and zero; the length x by
/// which a coupling deviates and zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlayReach {
    /// A journal in its bearing: |e| <= r.
    Disc {
        /// Radius r, m.
        radius_m: f64,
    },
    /// A slider in its guide: |y| + a |sin θ| <= c + b (1 - cos θ), |θ| <= θ_max. The guide is taken to hold it over its whole length:
    /// where it overhangs an end it can tilt further.
    Guide {
        /// Gap c on each side, m.
        clearance_m: f64,
        /// Half-length a, m.
        half_length_m: f64,
        /// Half-height b, m.
        half_height_m: f64,
        /// θ_max with a sin θ_max = c + b (1 - cos θ_max), rad.
        largest_tilt_rad: f64,
    },
    /// A pin between the faces of its slot: |y| <= c. The ends are not looked at: they can only make it less. Teeth between their
    /// flanks: |x| <= c; a follower on its cam, with c = 0.
    Slot {
        /// Clearance c, m.
        clearance_m: f64,
    },
}

impl PlayReach {
    /// The displacements of every joint with play of a sample whose contacts give way by `penetrations_m`.
    ///
    /// # Errors
    /// A slider that can turn over in its guide.
    pub fn of_sample(
        mechanism: &Mechanism,
        sample: &Sample<f64>,
        penetrations_m: impl IntoIterator<Item = f64>,
    ) -> Result<Vec<Self>, AccuracyError> {
        let joints = mechanism.plays.iter().zip(&sample.plays).zip(penetrations_m);
        joints
            .map(|((joint, play), penetration_m)| {
                let name = || mechanism.model.play_name(*joint).to_owned();
                Self::of_play(play, penetration_m).ok_or_else(|| AccuracyError::TurnsOver { joint: name() })
            })
            .collect()
    }

    fn of_play(play: &PlayGeometry<f64>, penetration_m: f64) -> Option<Self> {
        let clearance_m = play.clearance_m + penetration_m;
        Some(match play.shape.freedom() {
            PlayFreedom::InCircle => Self::Disc { radius_m: clearance_m },
            PlayFreedom::BetweenFaces | PlayFreedom::AlongPitchLine => Self::Slot { clearance_m },
            PlayFreedom::Tilting { half_length_m, half_height_m } => {
                let largest_tilt_rad = largest_tilt_rad(clearance_m, half_length_m, half_height_m)?;
                Self::Guide { clearance_m, half_length_m, half_height_m, largest_tilt_rad }
            }
        })
    }

    /// The displacement e that is furthest along `gradient`, which makes g·e largest; `None` if the gradient is zero.
    ///
    /// The border |y| = c + b (1 - cos θ) - a |sin θ| of a guide is bent inwards (its second derivative over θ,
    /// b cos θ + a |sin θ|, is positive), so that only its four ends (±c, 0) and (0, ±θ_max) can be furthest.
    pub fn furthest(&self, gradient: Vec2<f64>) -> Option<Vec2<f64>> {
        match *self {
            Self::Disc { radius_m } => {
                let length = gradient.length();
                (length > 0.0).then(|| gradient * (radius_m / length))
            }
            Self::Slot { clearance_m } => (gradient.x != 0.0).then(|| Vec2::new(clearance_m.copysign(gradient.x), 0.0)),
            Self::Guide { clearance_m, largest_tilt_rad, .. } => {
                let [across, turning] = [clearance_m * gradient.x, largest_tilt_rad * gradient.y];
                if across.abs() >= turning.abs() {
                    (across != 0.0).then(|| Vec2::new(clearance_m.copysign(across), 0.0))
                } else {
                    Some(Vec2::new(0.0, largest_tilt_rad.copysign(turning)))
                }
            }
        }
    }

    /// The largest g·e: c |g| for a disc, max(c |g_y|, θ_max |g_θ|) for a guide, c |g_y| for a slot.
    pub fn worst_case_si(&self, gradient: Vec2<f64>) -> f64 {
        match *self {
            Self::Disc { radius_m } => radius_m * gradient.length(),
            Self::Slot { clearance_m } => clearance_m * gradient.x.abs(),
            Self::Guide { clearance_m, largest_tilt_rad, .. } => {
                f64::max(clearance_m * gradient.x.abs(), largest_tilt_rad * gradient.y.abs())
            }
        }
    }

    /// Four times the variance of g·e for even chances over all displacements, and twice that for even chances on their
    /// border: c² |g|² for a disc; 2/3 (c² g_y² + θ_max² g_θ²) for a guide, which is to first order a rhombus; 4/3 and 2 times
    /// c² g_y² for a slot.
    pub(super) fn spreads_si2(&self, gradient: Vec2<f64>) -> [f64; 2] {
        match *self {
            Self::Disc { radius_m } => [radius_m * radius_m * gradient.length_squared(); 2],
            Self::Slot { clearance_m } => {
                let square = (clearance_m * gradient.x) * (clearance_m * gradient.x);
                [4.0 / 3.0 * square, 2.0 * square]
            }
            Self::Guide { clearance_m, largest_tilt_rad, .. } => {
                [2.0 / 3.0 * Vec2::new(clearance_m * gradient.x, largest_tilt_rad * gradient.y).length_squared(); 2]
            }
        }
    }

    /// How far along its guide a slider may reach from its ideal centre, m: a + b sin θ_max, since a corner at the tilt θ is
    /// a cos θ + b |sin θ| from the centre, and the clearance c, by which the centre itself may be off. None for other joints.
    pub(super) fn along_guide_m(&self) -> Option<f64> {
        let Self::Guide { clearance_m, half_length_m, half_height_m, largest_tilt_rad } = *self else { return None };
        Some(half_length_m + half_height_m * sin_cos(largest_tilt_rad).0 + clearance_m)
    }

    /// The displacement nearby that the clearance allows: between two ends a guide is narrower than the straight line.
    pub(super) fn within(&self, displacement: Vec2<f64>) -> Vec2<f64> {
        match *self {
            Self::Disc { .. } | Self::Slot { .. } => displacement,
            Self::Guide { clearance_m, half_length_m, half_height_m, largest_tilt_rad } => {
                let tilt_rad = displacement.y.clamp(-largest_tilt_rad, largest_tilt_rad);
                let left_m = f64::max(clearance_m - taken_m(tilt_rad.abs(), half_length_m, half_height_m), 0.0);
                Vec2::new(displacement.x.clamp(-left_m, left_m), tilt_rad)
            }
        }
    }

    /// How far two displacements are from each other, in units of the play.
    pub(super) fn distance(&self, a: Vec2<f64>, b: Vec2<f64>) -> f64 {
        let way = b - a;
        match *self {
            Self::Disc { radius_m } if radius_m > 0.0 => way.length() / radius_m,
            Self::Slot { clearance_m } if clearance_m > 0.0 => way.x.abs() / clearance_m,
            Self::Guide { clearance_m, largest_tilt_rad, .. } if clearance_m > 0.0 => {
                way.x.abs() / clearance_m + way.y.abs() / largest_tilt_rad
            }
            _ => 0.0,
        }
    }

    /// A displacement moved along `gradient` by `step` units of the play and put back to the border where it leaves it; a guide goes towards
    /// the one of its ends that is [furthest](Self::furthest), at most all the way.
    pub(super) fn stepped(&self, at: Vec2<f64>, gradient: Vec2<f64>, step: f64) -> Vec2<f64> {
        match *self {
            Self::Disc { radius_m } => {
                let length = gradient.length();
                if !(length > 0.0) {
                    return at;
                }
                let moved = at + gradient * (step * radius_m / length);
                let distance_m = moved.length();
                if distance_m > radius_m { moved * (radius_m / distance_m) } else { moved }
            }
            Self::Slot { clearance_m } => {
                let sign = if gradient.x == 0.0 { 0.0 } else { gradient.x.signum() };
                Vec2::new((at.x + sign * step * clearance_m).clamp(-clearance_m, clearance_m), 0.0)
            }
            Self::Guide { .. } => {
                let share = step.min(1.0);
                self.furthest(gradient)
                    .map_or(at, |end| if share == 1.0 { end } else { self.within(at + (end - at) * share) })
            }
        }
    }

    /// A displacement on the border in the direction of `angle_rad`; in a guide one of its ends.
    pub(super) fn on_border(&self, angle_rad: f64) -> Vec2<f64> {
        let (sine, cosine) = sin_cos(angle_rad);
        match *self {
            Self::Disc { radius_m } => Vec2::new(cosine, sine) * radius_m,
            Self::Slot { clearance_m } => Vec2::new(clearance_m.copysign(cosine), 0.0),
            Self::Guide { clearance_m, largest_tilt_rad, .. } => {
                if cosine.abs() >= sine.abs() {
                    Vec2::new(clearance_m.copysign(cosine), 0.0)
                } else {
                    Vec2::new(0.0, largest_tilt_rad.copysign(sine))
                }
            }
        }
    }
}

/// Gap that a tilt uses up, m: a sin θ - b (1 - cos θ) for θ >= 0.
fn taken_m(tilt_rad: f64, half_length_m: f64, half_height_m: f64) -> f64 {
    let half_sine = sin_cos(0.5 * tilt_rad).0;
    half_length_m * sin_cos(tilt_rad).0 - 2.0 * half_height_m * half_sine * half_sine
}

/// The smallest θ > 0 with a sin θ = c + b (1 - cos θ); `None` if b + c > √(a² + b²), so that the slider can turn over.
///
/// Newton's method from θ = c/a, which lies below the root; the function is concave there, so that no step goes beyond it.
fn largest_tilt_rad(clearance_m: f64, half_length_m: f64, half_height_m: f64) -> Option<f64> {
    const MAX_STEPS: usize = 100;
    let diagonal_m = Vec2::new(half_length_m, half_height_m).length();
    if half_height_m + clearance_m >= diagonal_m {
        return None;
    }
    let mut tilt_rad = clearance_m / half_length_m;
    for _ in 0..MAX_STEPS {
        let (sine, cosine) = sin_cos(tilt_rad);
        let slope_m = half_length_m * cosine - half_height_m * sine;
        let next_rad = tilt_rad + (clearance_m - taken_m(tilt_rad, half_length_m, half_height_m)) / slope_m;
        if next_rad <= tilt_rad {
            break;
        }
        tilt_rad = next_rad;
    }
    Some(tilt_rad)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_largest_tilt_of_a_slider() {
        /// Round-off of an arc cosine near its end, rad.
        const ROUND_OFF_RAD: f64 = 1e-14;
        for (c, a, b) in [(0.001, 0.05, 0.025), (1e-7, 0.03, 0.17), (0.021, 0.05, 0.013)] {
            let largest = largest_tilt_rad(c, a, b).expect("it cannot turn over");
            // a sin θ + b cos θ = √(a² + b²) cos(θ - atan(a/b)).
            let expected = f64::atan2(a, b) - f64::acos((b + c) / f64::hypot(a, b));
            assert!((largest - expected).abs() < ROUND_OFF_RAD * expected.max(1e-3) / 1e-3, "{largest} {expected}");
            assert!((taken_m(largest, a, b) - c).abs() < 1e-17 + 4.0 * f64::EPSILON * c, "{}", taken_m(largest, a, b));
        }
        assert_eq!(largest_tilt_rad(0.031, 0.05, 0.025), None, "0.056 m of height for a diagonal of 0.0559 m");
        assert!(largest_tilt_rad(0.0308, 0.05, 0.025).is_some());
    }

    #[test]
    fn identity_no_corner_reaches_further_along_its_guide() {
        /// Share of b c/a, the reach by tilt to first order, that θ² terms take or give for c/a = 0.02.
        const HIGHER_ORDER: f64 = 0.03;
        let (c, a, b) = (0.001, 0.05, 0.085);
        let largest_tilt_rad = largest_tilt_rad(c, a, b).expect("it cannot turn over");
        let guide = PlayReach::Guide { clearance_m: c, half_length_m: a, half_height_m: b, largest_tilt_rad };
        let reach_m = guide.along_guide_m().expect("a guide");
        for k in -50..=50 {
            let tilt_rad = largest_tilt_rad * f64::from(k) / 50.0;
            let corner_m = a * tilt_rad.cos() + b * tilt_rad.sin().abs();
            assert!(corner_m + c <= reach_m, "{corner_m} {reach_m}");
        }
        let by_tilt_m = reach_m - a - c;
        assert!((by_tilt_m / (b * c / a) - 1.0).abs() < HIGHER_ORDER, "{by_tilt_m}");
        assert_eq!(PlayReach::Disc { radius_m: c }.along_guide_m(), None);
    }

    #[test]
    fn identity_no_displacement_of_a_guide_goes_further_than_its_ends() {
        let (clearance_m, half_length_m, half_height_m) = (0.003, 0.05, 0.025);
        let largest_tilt_rad =
            largest_tilt_rad(clearance_m, half_length_m, half_height_m).expect("it cannot turn over");
        let reach = PlayReach::Guide { clearance_m, half_length_m, half_height_m, largest_tilt_rad };
        for gradient in [Vec2::new(0.7, 0.031), Vec2::new(-0.2, 0.04), Vec2::new(0.3, -0.0151)] {
            let largest = reach.worst_case_si(gradient);
            let end = reach.furthest(gradient).expect("there is a gradient");
            assert!((gradient.dot(end) - largest).abs() < 1e-18);
            for k in -200..=200 {
                let tilt_rad = largest_tilt_rad * f64::from(k) / 200.0;
                let border = reach.within(Vec2::new(clearance_m.copysign(gradient.x), tilt_rad));
                let [y, sum] = [
                    border.x.abs() + half_length_m * tilt_rad.sin().abs(),
                    clearance_m + half_height_m * (1.0 - tilt_rad.cos()),
                ];
                assert!((y - sum).abs() < 1e-17, "it lies on the border");
                assert!(gradient.dot(border) <= largest * (1.0 + 1e-12), "{border:?}");
            }
        }
        assert_eq!(reach.furthest(Vec2::zero()), None);
    }
}
