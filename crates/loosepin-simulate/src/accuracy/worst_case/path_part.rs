//! The error of a point along its path, or across it.

use loosepin_math::{Interval, Real};

/// An error of a path.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct PathPart {
    /// Coordinates of the point.
    pub coordinates: [usize; 2],
    /// Whether it is along the path; else across it.
    pub is_along: bool,
}

impl PathPart {
    /// By how much the weights of the error differ from `weights` wherever the slopes of x and y by the input lie in `slopes`: the slopes
    /// have the sense in which the path is followed, as the weights have.
    pub fn turned_weights(&self, slopes: [Interval; 2], weights: [f64; 2]) -> [Interval; 2] {
        let [x, y] = slopes;
        let speed = (x.squared() + y.squared()).sqrt();
        // A direction has no component beyond one.
        let [along_x, along_y] = [x, y].map(|own| (own / speed).part(-1.0, 1.0).unwrap_or(Interval::WHOLE));
        let now = if self.is_along { [along_x, along_y] } else { [-along_y, along_x] };
        [0, 1].map(|k| now[k] - Interval::from_f64(weights[k]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn identity_no_direction_within_the_slopes_turns_weights_further() {
        let mut count = 0;
        for direction in 0..72 {
            let (sine, cosine) = (5.0 * f64::from(direction)).to_radians().sin_cos();
            for half_width in [0.02, 0.2, 0.5, 0.8, 1.2, 2.4] {
                let slopes = [cosine, sine].map(|middle| Interval::new(middle - half_width, middle + half_width));
                for is_along in [false, true] {
                    let weights_of = |[x, y]: [f64; 2]| {
                        let [x, y] = [x, y].map(|own| own / x.hypot(y));
                        if is_along { [x, y] } else { [-y, x] }
                    };
                    let weights = weights_of([cosine, sine]);
                    let turned = PathPart { coordinates: [0, 1], is_along }.turned_weights(slopes, weights);
                    // Slopes within a small square: their direction turns by less than twice its half width.
                    let widest = turned.map(|turn| turn.high() - turn.low()).into_iter().fold(0.0, f64::max);
                    assert!(half_width > 0.2 || widest < 5.0 * half_width, "{direction} {half_width}: {widest}");
                    for place in 0..121 {
                        let shares = [place % 11, place / 11].map(|share| f64::from(share) / 5.0 - 1.0);
                        let slope = [cosine + shares[0] * half_width, sine + shares[1] * half_width];
                        if slope[0].hypot(slope[1]) < 1e-9 {
                            continue;
                        }
                        let now = weights_of(slope);
                        for k in 0..2 {
                            let turn = now[k] - weights[k];
                            let is_inside = turned[k].low() - 1e-12 <= turn && turn <= turned[k].high() + 1e-12;
                            assert!(is_inside, "{direction} {half_width} {is_along}: {turn} is not in {:?}", turned[k]);
                            count += 1;
                        }
                    }
                }
            }
        }
        assert!(count > 200_000, "{count}");
    }
}
