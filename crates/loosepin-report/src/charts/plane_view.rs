//! What pictures of a path in its plane have in common: their view, their scales, how far deviations are magnified.

use maud::{Markup, html};

use crate::mechanism::shapes::MM_PER_M;
use crate::numbers::number::NumberWriter;
use loosepin_text::units::SiUnit;

/// The longer side of the picture in its own units; a unit is about a pixel.
const SIDE: f64 = 640.0;
/// The shorter side, at least.
const MIN_SIDE: f64 = 0.3 * SIDE;
const MARGIN: f64 = 48.0;
/// The widest deviation is drawn as about this share of the size of the path.
const VISIBLE_SHARE: f64 = 0.08;
/// The bar of the scale is about this share of the picture.
const BAR_SHARE: f64 = 0.18;

/// Positions in a picture.
pub(crate) struct PlaneView {
    left_m: f64,
    top_m: f64,
    /// Units of the picture in a metre.
    pub per_m: f64,
    pub width: f64,
    pub height: f64,
}

impl PlaneView {
    /// Around a path, with room about each point.
    pub fn new([x_m, y_m]: [&[f64]; 2], room_m: f64) -> Self {
        let range = |values: &[f64]| {
            let low = values.iter().fold(f64::INFINITY, |low, value| low.min(*value)) - room_m;
            (low, values.iter().fold(f64::NEG_INFINITY, |high, value| high.max(*value)) + room_m)
        };
        let ((left, right), (low, high)) = (range(x_m), range(y_m));
        let per_m = SIDE / (right - left).max(high - low).max(f64::MIN_POSITIVE);
        let sides = [right - left, high - low].map(|side| side * per_m);
        // A flat path lies in the middle.
        let [beside, above] = sides.map(|side| 0.5 * (MIN_SIDE - side).max(0.0) / per_m);
        let [width, height] = sides.map(|side| side.max(MIN_SIDE) + 2.0 * MARGIN);
        Self { left_m: left - beside, top_m: high + above, per_m, width, height: height + MARGIN }
    }

    /// Place in the picture.
    pub fn place(&self, [x_m, y_m]: [f64; 2]) -> [f64; 2] {
        [MARGIN + (x_m - self.left_m) * self.per_m, MARGIN + (self.top_m - y_m) * self.per_m]
    }

    /// Place in the picture as text.
    pub fn point(&self, point_m: [f64; 2]) -> String {
        let [x, y] = self.place(point_m);
        format!("{x:.1} {y:.1}")
    }

    /// A line through points; whole curves are closed.
    pub fn line(&self, points: &[[f64; 2]]) -> String {
        let mut line = String::new();
        for (k, point) in points.iter().enumerate() {
            line.push_str(if k == 0 { "M" } else { "L" });
            line.push_str(&self.point(*point));
        }
        line
    }
}

/// Two bars: a length of the path, and where deviations are drawn, magnified so many times, a deviation from it.
pub(crate) fn bars(view: &PlaneView, magnification: Option<f64>, writer: &NumberWriter) -> Markup {
    let about_m = BAR_SHARE * SIDE / view.per_m;
    let bar = |length_m: f64, factor: f64, y: f64, what: &str, class: &str| {
        let length = length_m * factor * view.per_m;
        html! {
            g class={ "bar " (class) } transform=(format!("translate({MARGIN} {y:.1})")) {
                path d=(format!("M0 -4V4M0 0H{length:.1}M{length:.1} -4V4")) {}
                text x=(format!("{:.1}", length + 10.0)) y="5" {
                    (writer.value_shortest(length_m, &SiUnit::LENGTH)) " " (what)
                }
            }
        }
    };
    let path_y = if magnification.is_some() { view.height - 50.0 } else { view.height - 24.0 };
    html! {
        (bar(round_length_m(about_m), 1.0, path_y, "along the path", "of-path"))
        @if let Some(factor) = magnification {
            (bar(round_length_m(about_m / factor), factor, view.height - 24.0, "of deviation", "of-deviation"))
        }
    }
}

/// The diagonal of the frame of a path, m.
pub(crate) fn size_m([x_m, y_m]: [&[f64]; 2]) -> f64 {
    let extent = |values: &[f64]| {
        let high = values.iter().fold(f64::NEG_INFINITY, |high, value| high.max(*value));
        high - values.iter().fold(f64::INFINITY, |low, value| low.min(*value))
    };
    extent(x_m).hypot(extent(y_m))
}

/// Whether the last pose lies before the first one as poses do.
pub(crate) fn is_closed([x_m, y_m]: [&[f64]; 2], size_m: f64) -> bool {
    let last = x_m.len() - 1;
    let between = |a: usize, b: usize| (x_m[a] - x_m[b]).hypot(y_m[a] - y_m[b]);
    let longest = (0..last).map(|k| between(k, k + 1)).fold(0.0, f64::max);
    between(last, 0) <= 1.5 * longest.max(1e-3 * size_m)
}

/// How many times deviations up to `largest_m` are magnified for a path of this size: a round number; 1 where there are none.
pub(crate) fn magnification(size_m: f64, largest_m: f64) -> f64 {
    if largest_m > 0.0 { round_factor(VISIBLE_SHARE * size_m / largest_m.max(1e-9 * size_m)) } else { 1.0 }
}

/// 1, 2 or 5 times a power of ten, at most `factor`; at least 1.
pub(crate) fn round_factor(factor: f64) -> f64 {
    round_down(factor).max(1.0)
}

/// 1, 2 or 5 times a power of ten millimetres, at most `length_m`.
fn round_length_m(length_m: f64) -> f64 {
    round_down(length_m * MM_PER_M) / MM_PER_M
}

fn round_down(value: f64) -> f64 {
    let power = 10_f64.powf(value.log10().floor());
    let step = [5.0, 2.0, 1.0].into_iter().find(|step| step * power <= value * (1.0 + 1e-9)).unwrap_or(1.0);
    // A power of ten below one has round-off.
    format!("{:.12e}", step * power).parse().unwrap_or(step * power)
}

#[cfg(test)]
mod tests {
    use super::{is_closed, round_down, round_factor};

    #[test]
    fn analytic_round_numbers() {
        for (value, round) in
            [(1.0, 1.0), (1.99, 1.0), (2.0, 2.0), (49.0, 20.0), (50.0, 50.0), (0.03, 0.02), (1e3, 1e3)]
        {
            assert_eq!(round_down(value), round, "{value}");
        }
        assert_eq!(round_factor(0.3), 1.0);
    }

    #[test]
    fn analytic_a_circle_is_closed_and_half_of_it_is_not() {
        let arc = |turns: f64| {
            let angle = |k: usize| std::f64::consts::TAU * turns * k as f64 / 36.0;
            [f64::cos, f64::sin].map(|of| (0..36).map(|k| of(angle(k))).collect::<Vec<f64>>())
        };
        let closed = |[x_m, y_m]: [Vec<f64>; 2]| is_closed([&x_m, &y_m], 2.0);
        assert!(closed(arc(1.0)) && !closed(arc(0.5)));
    }
}
