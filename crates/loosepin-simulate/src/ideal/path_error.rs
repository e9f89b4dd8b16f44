//! The error of a point from its ideal path, in parts.

use loosepin_math::{Real, Vec2};
use loosepin_result::study::PathError;

/// A part of the `error` of a point: [`PathError`] has the equations. `velocity` and `acceleration` are those of the ideal point, over any
/// variable: tangent and curvature are the same for all. NaN if the ideal point stands still, [`PathError::Magnitude`]
/// excepted.
#[inline(always)]
pub fn path_error<T: Real>(part: PathError, error: Vec2<T>, velocity: Vec2<T>, acceleration: Vec2<T>) -> T {
    let speed = velocity.length();
    match part {
        PathError::Magnitude => error.length(),
        PathError::Along => error.dot(velocity) / speed,
        PathError::Normal => velocity.cross(error) / speed,
        PathError::Contour => {
            let (along, normal) = (error.dot(velocity) / speed, velocity.cross(error) / speed);
            let curvature = velocity.cross(acceleration) / (speed * speed * speed);
            let (across, beside) = (T::one() - curvature * normal, curvature * along);
            let two = T::from_f64(2.0);
            (two * normal - curvature * error.length_squared())
                / (T::one() + (across * across + beside * beside).sqrt())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::path_error;
    use loosepin_math::Vec2;
    use loosepin_result::study::PathError;

    const TOLERANCE: f64 = 1e-14;

    #[test]
    fn analytic_errors_beside_a_circle() {
        // A circle of radius 2 about the origin, passed against the clock, at 0.3 rad; the point is 0.1 rad ahead and 0.05 further out.
        for (clock, speed) in [(1.0, 1.0), (-1.0, 7.0)] {
            let at = |angle: f64, radius: f64| Vec2::new(radius * angle.cos(), radius * angle.sin());
            let (angle, ahead, out) = (0.3, 0.1, 0.05);
            let error = at(angle + clock * ahead, 2.0 + out) - at(angle, 2.0);
            let velocity = at(angle + clock * std::f64::consts::FRAC_PI_2, 2.0 * speed);
            // A change of speed along the path changes nothing.
            let acceleration = at(angle, -2.0 * speed * speed).plus(velocity, 3.0);
            let part = |part| path_error(part, error, velocity, acceleration);
            // The left of the motion against the clock is the inside.
            let expected = [
                (PathError::Along, (2.0 + out) * ahead.sin()),
                (PathError::Normal, clock * (2.0 - (2.0 + out) * ahead.cos())),
                (PathError::Magnitude, error.length()),
                (PathError::Contour, -clock * out),
            ];
            for (own, expected) in expected {
                assert!((part(own) - expected).abs() < TOLERANCE, "{own:?}: {} {expected}", part(own));
            }
        }
    }

    #[test]
    fn analytic_beside_a_straight_path_the_contour_error_is_the_normal_one() {
        let (error, velocity) = (Vec2::new(0.2, -0.1), Vec2::new(3.0, 4.0));
        let part = |part| path_error(part, error, velocity, Vec2::new(6.0, 8.0));
        assert!((part(PathError::Normal) + 0.22).abs() < TOLERANCE);
        assert!((part(PathError::Contour) + 0.22).abs() < TOLERANCE);
        assert!((part(PathError::Along) - 0.04).abs() < TOLERANCE);
    }

    #[test]
    fn analytic_the_contour_error_leaves_out_what_the_change_of_curvature_makes() {
        // The parabola y = x², from x = 0.3 on, and a point beside where it is at x = 0.31.
        let at = |x: f64| Vec2::new(x, x * x);
        let (here, foot, distance) = (0.3, 0.31, 1e-3);
        let tangent = Vec2::new(1.0, 2.0 * foot);
        let point = at(foot).plus(tangent.turned(), distance / tangent.length());
        let error = point - at(here);
        let (velocity, acceleration) = (Vec2::new(1.0, 2.0 * here), Vec2::new(0.0, 2.0));
        let contour = path_error(PathError::Contour, error, velocity, acceleration);
        // κ = 2/(1 + 4x²)^(3/2), dκ/ds = -24 x/(1 + 4x²)³.
        let along = path_error(PathError::Along, error, velocity, acceleration);
        let left_out = along.powi(3) / 6.0 * 24.0 * here / (1.0 + 4.0 * here * here).powi(3);
        assert!((contour - distance).abs() < 1.5 * left_out && left_out < 1e-6, "{contour} {left_out}");
        assert!((path_error(PathError::Normal, error, velocity, acceleration) - distance).abs() > 20.0 * left_out);
    }
}
