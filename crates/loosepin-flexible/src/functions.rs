//! Shape functions over s = x/L.

use loosepin_math::{exponential, sin_cos};
use std::f64::consts::{FRAC_PI_2, PI};

/// The frame in which a beam is described.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Frame {
    /// Its x axis goes through both ends; the section at the root turns against it. Lateral shapes `L sin(iπs)/(iπ)`.
    Secant,
    /// Its x axis touches the beam at the root, whose section turns with it. Lateral shapes: eigenfunctions of a beam that is
    /// clamped at the root and free at the tip, of slope 1 at the tip.
    Tangent,
}

/// Value and slope dψ/ds of the axial shape `index`: s, then sin(kπs).
///
/// The first carries a force at the tip, which the sines alone feel with an error of 1/n only.
pub(crate) fn axial(index: usize, s: f64) -> [f64; 2] {
    if index == 0 {
        return [s, 1.0];
    }
    let factor = index as f64 * PI;
    let (sine, cosine) = sin_cos(factor * s);
    [sine, factor * cosine]
}

/// Value φ/L, slope φ' and its derivative dφ'/ds of the lateral shape `index` of a frame.
pub(crate) fn lateral(frame: Frame, index: usize, s: f64) -> [f64; 3] {
    match frame {
        Frame::Secant => {
            let factor = (index + 1) as f64 * PI;
            let (sine, cosine) = sin_cos(factor * s);
            [sine / factor, cosine, -factor * sine]
        }
        Frame::Tangent => {
            let root = clamped_free_root(index);
            let tip = clamped_free(root, 1.0)[1];
            clamped_free(root, s).map(|value| value / tip)
        }
    }
}

/// βL of the clamped and free beam: cos z cosh z = -1.
fn clamped_free_root(index: usize) -> f64 {
    let mut z = if index == 0 { 1.875 } else { (2 * index + 1) as f64 * FRAC_PI_2 };
    for _ in 0..8 {
        let (sine, cosine) = sin_cos(z);
        let (grown, decayed) = (exponential(z), exponential(-z));
        let inverse_cosh = 2.0 / (grown + decayed);
        let slope = -sine - inverse_cosh * (grown - decayed) / (grown + decayed);
        z -= (cosine + inverse_cosh) / slope;
    }
    z
}

/// cosh βs - cos βs - σ (sinh βs - sin βs) with its first two derivatives by s, without the differences of large numbers.
fn clamped_free(root: f64, s: f64) -> [f64; 3] {
    let (sine, cosine) = sin_cos(root);
    let (grown, decayed) = (exponential(root), exponential(-root));
    // 1 - σ, σ = (cosh + cos)/(sinh + sin) at the tip.
    let rest = (sine - cosine - decayed) / (0.5 * (grown - decayed) + sine);
    let sigma = 1.0 - rest;
    let z = root * s;
    let (sine, cosine) = sin_cos(z);
    let (growing, decaying) = (0.5 * rest * exponential(z), 0.5 * (1.0 + sigma) * exponential(-z));
    [
        growing + decaying - cosine + sigma * sine,
        root * (growing - decaying + sine + sigma * cosine),
        root * root * (growing + decaying + cosine - sigma * sine),
    ]
}

#[cfg(test)]
mod tests {
    use super::{clamped_free, clamped_free_root};

    #[test]
    fn published_roots_and_boundary_conditions_of_the_clamped_and_free_beam() {
        // Roots of cos z cosh z = -1, in any table of beams.
        for (index, known) in [1.875104069, 4.694091133, 7.854757438, 10.995540735].into_iter().enumerate() {
            assert!((clamped_free_root(index) - known).abs() < 6e-10);
        }
        for index in 0..12 {
            let root = clamped_free_root(index);
            let [value, slope, _] = clamped_free(root, 0.0);
            let tip = clamped_free(root, 1.0);
            assert!(value.abs() < 1e-14 && slope.abs() < 1e-13 * root, "shape {index}: {value} {slope}");
            assert!(tip[2].abs() < 1e-11 * root * root, "shape {index}: moment at the tip {}", tip[2]);
            assert!((tip[0].abs() - 2.0).abs() < 1e-12, "shape {index}: {}", tip[0]);
            // Slope and curvature by central differences.
            for s in [0.13, 0.5, 0.87] {
                let h = 1e-5 / root;
                let [below, at, above] = [s - h, s, s + h].map(|s| clamped_free(root, s));
                for k in 0..2 {
                    let difference = (above[k] - below[k]) / (2.0 * h);
                    assert!((difference - at[k + 1]).abs() < 3e-9 * root * root, "shape {index}, derivative {}", k + 1);
                }
            }
        }
    }
}
