//! The axes of pictures that are drawn whole: ticks, grid, labels.

use maud::{Markup, html};

/// Room for numbers on the left and below.
const LEFT: f64 = 74.0;
const BELOW: f64 = 46.0;
const MARGIN: f64 = 18.0;
/// Ticks of an axis, about.
const TICKS: f64 = 6.0;

/// The part of an axis that is shown, in display units.
pub(super) struct Axis {
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
    pub fn wider(self) -> Axis {
        let room = 0.04 * (self.to - self.from);
        Axis { from: self.from - room, to: self.to + room }
    }

    fn share(&self, value: f64) -> f64 {
        (value - self.from) / (self.to - self.from)
    }

    /// Round numbers within the axis: 1, 2 or 5 times a power of ten apart.
    fn ticks(&self) -> Vec<f64> {
        let rough = (self.to - self.from) / TICKS;
        let power = 10_f64.powf(rough.log10().floor());
        let spacing = [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|s| *s >= rough).unwrap_or(rough);
        let (first, last) = ((self.from / spacing).ceil() as i64, (self.to / spacing).floor() as i64);
        (first..=last).map(|k| k as f64 * spacing).collect()
    }
}

/// Two axes in a picture of so many units; a unit is about a pixel.
pub(super) struct Axes {
    pub width: f64,
    pub height: f64,
    pub x: Axis,
    pub y: Axis,
}

impl Axes {
    /// Where a value of the horizontal axis stands.
    pub fn across(&self, value: f64) -> f64 {
        LEFT + self.x.share(value) * (self.width - LEFT - MARGIN)
    }

    /// Where a value of the vertical axis stands.
    pub fn up(&self, value: f64) -> f64 {
        self.height - BELOW - self.y.share(value) * (self.height - BELOW - MARGIN)
    }

    /// The lines of the ticks, with their numbers.
    pub fn grid(&self) -> Markup {
        let (bottom, right) = (self.height - BELOW, self.width - MARGIN);
        html! {
            @for tick in self.x.ticks() {
                @let place = self.across(tick);
                line.grid x1=(format!("{place:.1}")) x2=(format!("{place:.1}")) y1=(MARGIN) y2=(bottom) {}
                text x=(format!("{place:.1}")) y=(bottom + 17.0) text-anchor="middle" { (tick_text(tick)) }
            }
            @for tick in self.y.ticks() {
                @let place = self.up(tick);
                line.grid x1=(LEFT) x2=(right) y1=(format!("{place:.1}")) y2=(format!("{place:.1}")) {}
                text x=(LEFT - 8.0) y=(format!("{:.1}", place + 4.0)) text-anchor="end" { (tick_text(tick)) }
            }
        }
    }

    /// Names of the axes, each with the symbol of its unit.
    pub fn labels(&self, x: [&str; 2], y: [&str; 2]) -> Markup {
        let label = |[words, symbol]: [&str; 2]| {
            if symbol.is_empty() { words.to_owned() } else { format!("{words} [{symbol}]") }
        };
        html! {
            text x=(0.5 * (LEFT + self.width - MARGIN)) y=(self.height - 8.0) text-anchor="middle" { (label(x)) }
            text transform=(format!("translate(14 {}) rotate(-90)", 0.5 * (self.height - BELOW))) text-anchor="middle" {
                (label(y))
            }
        }
    }
}

/// A tick with no more digits than it has.
fn tick_text(tick: f64) -> String {
    // Ticks are multiples of 1, 2 or 5 times a power of ten: twelve digits clear the round-off, never a digit.
    let text = format!("{:.12}", tick);
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.replace('-', "−") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_ticks_are_round_and_inside() {
        let axis = Axis { from: 0.1, to: 0.5 };
        let texts: Vec<String> = axis.ticks().iter().map(|tick| tick_text(*tick)).collect();
        assert_eq!(texts, ["0.1", "0.2", "0.3", "0.4", "0.5"]);
        let axis = Axis { from: -3.3, to: 2.1 };
        let texts: Vec<String> = axis.ticks().iter().map(|tick| tick_text(*tick)).collect();
        assert_eq!(texts, ["−3", "−2", "−1", "0", "1", "2"]);
    }

    #[test]
    fn analytic_an_axis_of_one_value_has_an_extent() {
        let axis = Axis::over([2.0, 2.0].into_iter());
        assert!(axis.from < 2.0 && axis.to > 2.0);
        let axis = Axis::over([f64::NAN].into_iter());
        assert!(axis.to > axis.from);
    }
}
