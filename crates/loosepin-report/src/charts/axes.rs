//! The axes of pictures that are drawn whole: ticks, grid, labels.

use maud::{Markup, html};

use crate::charts::ticks::{tick_text, ticks};

/// Room below the curves, for numbers and the name of the axis, and at sides without numbers.
pub(crate) const BELOW: f64 = 46.0;
pub(crate) const MARGIN: f64 = 18.0;
/// Distance of the numbers below an axis from it, of those beside an axis, and of the name from the lower edge of the picture.
pub(crate) const NUMBERS_BELOW: f64 = 17.0;
pub(crate) const NUMBERS_BESIDE: f64 = 7.0;
pub(crate) const NAME_ABOVE_EDGE: f64 = 8.0;
/// Half the height of a digit: numbers beside an axis stand so far below their tick.
pub(crate) const HALF_DIGIT: f64 = 4.0;
/// Position of the name of the vertical axis from the left edge of the picture.
pub(crate) const UPRIGHT_NAME: f64 = 13.0;
/// The same of pictures that are drawn whole: narrow screens make their letters larger.
const UPRIGHT_NAME_OF_PICTURE: f64 = 20.0;
/// Room for numbers on the left.
const LEFT: f64 = 74.0;
/// Ticks of an axis, about.
const TICKS: f64 = 6.0;

/// A quantity with the symbol of its unit in brackets, for axes and heads of columns; a pure number has none.
pub(crate) fn with_unit(words: &str, symbol: &str) -> String {
    if symbol.is_empty() { words.to_owned() } else { format!("{words} [{symbol}]") }
}

/// The part of an axis that is shown, in display units.
pub(crate) struct Axis {
    from: f64,
    to: f64,
}

impl Axis {
    /// From the least to the greatest value; with some room where that is one value.
    pub fn over(values: impl Iterator<Item = f64>) -> Axis {
        let finite = values.filter(|value| value.is_finite());
        let (from, to) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
        if to > from {
            Axis { from, to }
        } else if from.is_finite() {
            let room = if from == 0.0 { 1.0 } else { 0.1 * from.abs() };
            Axis { from: from - room, to: from + room }
        } else {
            Axis { from: 0.0, to: 1.0 }
        }
    }

    /// With some room at both ends.
    pub fn with_margin(self) -> Axis {
        let room = 0.04 * (self.to - self.from);
        Axis { from: self.from - room, to: self.to + room }
    }

    fn share(&self, value: f64) -> f64 {
        (value - self.from) / (self.to - self.from)
    }
}

/// Two axes in a picture, in its units; a unit is about a pixel.
pub(crate) struct Axes {
    pub width: f64,
    pub height: f64,
    pub x: Axis,
    pub y: Axis,
}

impl Axes {
    /// Position of a value on the horizontal axis.
    pub fn x_position(&self, value: f64) -> f64 {
        LEFT + self.x.share(value) * (self.width - LEFT - MARGIN)
    }

    /// Position of a value on the vertical axis.
    pub fn y_position(&self, value: f64) -> f64 {
        self.height - BELOW - self.y.share(value) * (self.height - BELOW - MARGIN)
    }

    /// The lines of the ticks, with their numbers.
    pub fn grid(&self) -> Markup {
        let (bottom, right) = (self.height - BELOW, self.width - MARGIN);
        let of = |axis: &Axis| ticks(axis.from, axis.to, (axis.to - axis.from) / TICKS, false);
        let ((x_ticks, x_step), (y_ticks, y_step)) = (of(&self.x), of(&self.y));
        html! {
            @for tick in x_ticks {
                @let place = self.x_position(tick);
                line.grid x1=(format!("{place:.1}")) x2=(format!("{place:.1}")) y1=(MARGIN) y2=(bottom) {}
                text x=(format!("{place:.1}")) y=(bottom + NUMBERS_BELOW) text-anchor="middle" { (tick_text(tick, x_step)) }
            }
            @for tick in y_ticks {
                @let place = self.y_position(tick);
                line.grid x1=(LEFT) x2=(right) y1=(format!("{place:.1}")) y2=(format!("{place:.1}")) {}
                text x=(LEFT - NUMBERS_BESIDE) y=(format!("{:.1}", place + HALF_DIGIT)) text-anchor="end" { (tick_text(tick, y_step)) }
            }
        }
    }

    /// Names of the axes, each with the symbol of its unit.
    pub fn labels(&self, x: [&str; 2], y: [&str; 2]) -> Markup {
        let label = |[words, symbol]: [&str; 2]| with_unit(words, symbol);
        html! {
            text x=(0.5 * (LEFT + self.width - MARGIN)) y=(self.height - NAME_ABOVE_EDGE) text-anchor="middle" { (label(x)) }
            text transform=(format!("translate({UPRIGHT_NAME_OF_PICTURE} {}) rotate(-90)", 0.5 * (self.height - BELOW))) text-anchor="middle" {
                (label(y))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_an_axis_of_one_value_has_an_extent() {
        let axis = Axis::over([2.0, 2.0].into_iter());
        assert!(axis.from < 2.0 && axis.to > 2.0);
        let axis = Axis::over([f64::NAN].into_iter());
        assert!(axis.to > axis.from);
    }
}
