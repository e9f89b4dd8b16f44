//! Places of bodies, points nearer to each other than anybody makes being one.

use std::collections::HashMap;

/// Two points of a body nearer to each other are one centre, m.
pub const SAME_CENTRE_M: f64 = 1e-9;

/// Places of bodies that lie apart from each other.
#[derive(Debug, Default)]
pub struct Centres(HashMap<(usize, [i64; 2]), Vec<[f64; 2]>>);

impl Centres {
    /// Whether a place of a body is a new one, which is known from then on. It is compared with its neighbours alone, so that thousands of
    /// points do not cost their square.
    pub fn is_new(&mut self, body: usize, [x, y]: [f64; 2]) -> bool {
        let cell = |value: f64| (value / SAME_CENTRE_M).floor() as i64;
        let [own_x, own_y] = [cell(x), cell(y)];
        for next_x in [own_x.saturating_sub(1), own_x, own_x.saturating_add(1)] {
            for next_y in [own_y.saturating_sub(1), own_y, own_y.saturating_add(1)] {
                let near = self.0.get(&(body, [next_x, next_y])).into_iter().flatten();
                if near.into_iter().any(|known| (x - known[0]).hypot(y - known[1]) < SAME_CENTRE_M) {
                    return false;
                }
            }
        }
        self.0.entry((body, [own_x, own_y])).or_default().push([x, y]);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_new_where_they_lie_apart() {
        let mut centres = Centres::default();
        assert!(centres.is_new(1, [0.03, -0.04]));
        assert!(!centres.is_new(1, [0.03 + 0.7e-9, -0.04 - 0.7e-9]));
        assert!(centres.is_new(1, [0.03 + 0.8e-9, -0.04 - 0.8e-9]));
        assert!(centres.is_new(2, [0.03, -0.04]));
        assert!(centres.is_new(1, [-0.03, 0.04]));
    }
}
