//! A bifurcation diagram: for every value of the quantity the points of its Poincaré section.

use maud::{Markup, html};

use super::number::NumberWriter;
use crate::sweep::record::{SweepPoint, SweepRecord};

/// Width and height of the picture in its own units; a unit is about a pixel.
const WIDTH: f64 = 960.0;
const HEIGHT: f64 = 420.0;
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

    pub fn wider(self) -> Axis {
        let room = 0.04 * (self.to - self.from);
        Axis { from: self.from - room, to: self.to + room }
    }

    pub fn share(&self, value: f64) -> f64 {
        (value - self.from) / (self.to - self.from)
    }

    /// Round numbers within the axis: 1, 2 or 5 times a power of ten apart.
    pub fn ticks(&self) -> Vec<f64> {
        let rough = (self.to - self.from) / TICKS;
        let power = 10_f64.powf(rough.log10().floor());
        let spacing = [1.0, 2.0, 5.0, 10.0].into_iter().map(|m| m * power).find(|s| *s >= rough).unwrap_or(rough);
        let (first, last) = ((self.from / spacing).ceil() as i64, (self.to / spacing).floor() as i64);
        (first..=last).map(|k| k as f64 * spacing).collect()
    }
}

/// One dot for every turn of every value, in two colours: motion that repeats itself, and motion that does not.
pub(super) fn section_figure(record: &SweepRecord, output: usize, writer: &NumberWriter) -> Markup {
    let swept = &record.outputs[output];
    let (across, up) = (writer.units.of(&record.unit), writer.units.of(&swept.unit));
    let x_axis = Axis::over(record.points.iter().map(|point| across.from_si(point.value_si)));
    let sections = || record.points.iter().filter_map(|point| Some((point, point.sections_si.get(output)?)));
    let y_axis = Axis::over(sections().flat_map(|(_, section)| section.iter().map(|v| up.from_si(*v)))).wider();
    let x = |value: f64| LEFT + x_axis.share(value) * (WIDTH - LEFT - MARGIN);
    let y = |value: f64| HEIGHT - BELOW - y_axis.share(value) * (HEIGHT - BELOW - MARGIN);
    let dots = |is_wanted: &dyn Fn(&SweepPoint) -> bool| {
        let mut path = String::new();
        for (point, section) in sections().filter(|(point, _)| is_wanted(point)) {
            let x = x(across.from_si(point.value_si));
            for value_si in section.iter().filter(|value_si| value_si.is_finite()) {
                path.push_str(&format!("M{x:.1} {:.1}h0", y(up.from_si(*value_si))));
            }
        }
        path
    };
    let symbol = |symbol: &str| if symbol.is_empty() { String::new() } else { format!(" [{symbol}]") };
    let name = if swept.words.is_empty() { swept.name.clone() } else { format!("{} ({})", swept.name, swept.words) };
    let angle = writer.value_trimmed(record.section_angle_rad, &crate::units::SiUnit::ANGLE);
    let alternative = format!(
        "Bifurcation diagram: deviation of {name} once a turn, at {angle} of {}, over {}; {} turns for each of {} values.",
        record.drive,
        record.path,
        record.recorded_turns,
        record.points.len()
    );
    html! {
        figure.section {
            svg viewBox=(format!("0 0 {WIDTH} {HEIGHT}")) role="img" aria-label=(alternative) {
                @for tick in x_axis.ticks() {
                    line.grid x1=(format!("{:.1}", x(tick))) x2=(format!("{:.1}", x(tick))) y1=(MARGIN) y2=(HEIGHT - BELOW) {}
                    text x=(format!("{:.1}", x(tick))) y=(HEIGHT - BELOW + 17.0) text-anchor="middle" { (tick_text(tick)) }
                }
                @for tick in y_axis.ticks() {
                    line.grid x1=(LEFT) x2=(WIDTH - MARGIN) y1=(format!("{:.1}", y(tick))) y2=(format!("{:.1}", y(tick))) {}
                    text x=(LEFT - 8.0) y=(format!("{:.1}", y(tick) + 4.0)) text-anchor="end" { (tick_text(tick)) }
                }
                path.irregular d=(dots(&|point| point.period_turns.is_none())) {}
                path.regular d=(dots(&|point| point.period_turns.is_some())) {}
                text x=(0.5 * (LEFT + WIDTH - MARGIN)) y=(HEIGHT - 8.0) text-anchor="middle" {
                    (record.path) (symbol(&across.symbol))
                }
                text transform=(format!("translate(14 {}) rotate(-90)", 0.5 * (HEIGHT - BELOW))) text-anchor="middle" {
                    "deviation of " (swept.name) (symbol(&up.symbol))
                }
            }
            figcaption {
                strong { "Once a turn, at " (angle) " of " (record.drive) ": the deviation of " (name) "." }
                " A dot for each of " (record.recorded_turns) " turns; "
                span.regular { "blue" } " where the motion repeats itself, "
                span.irregular { "orange" } " where it does not."
            }
        }
    }
}

pub(super) fn tick_text(tick: f64) -> String {
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
