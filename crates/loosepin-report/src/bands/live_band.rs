//! The band of an output without dynamics, as it is shown while a mechanism is edited.
//!
//! At each angle of the drive, with the first-order sum of play w (a preview of the worst case), the standard deviation s_p of journals anywhere in their clearance
//! circles and the standard deviation s_d of the dimensions: the outer band is ±(w + 2 s_d), the inner one ±2 √(s_p² + s_d²).
//! With k clearances of effects w_i, 2 s_p = √(w_1² + … + w_k²) ≤ w: the inner band lies in the outer one.

use maud::html;
use serde::Serialize;

use crate::charts::chart::{Chart, Entry, EntryValues, Role, scaled};
use crate::charts::figure::name_of;
use crate::motion::{angle_chart, asked_place, moved_words, turn_angle};
use crate::numbers::largest::places_of_largest;
use crate::numbers::number::{NumberWriter, PLAIN_DIGITS, Rounding};
use crate::words::wording::named_words;
use loosepin_result::motion::{DimensionContributor, MotionRecord, OutputMotion, PoseEffect};
use loosepin_text::units::SiUnit;

/// Standard deviations on either side of the middle.
const DEVIATIONS: f64 = 2.0;
/// Height of the chart, in units of the picture.
const HEIGHT: u32 = 200;

/// The band of one output.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LiveBand {
    /// Name of the output.
    pub output: String,
    /// Description.
    pub words: String,
    /// How wide the band is where it is widest, in a sentence.
    pub largest: String,
    /// The chart as an SVG document that takes its style from the page. `data-plot` has left, top, width and height of the frame of its
    /// curves in units of the picture, `data-x` the angles at its ends, degrees, `data-y` the values at its foot and head.
    pub figure: String,
    /// Half the width of the outer band where it is widest, in the unit of the figure.
    pub largest_value: f64,
    /// The unit of the figure, in a file.
    pub unit: String,
    /// SI units in a unit of the figure.
    pub si_per_unit: f64,
    /// Whether the band keeps each limit of its output, in a sentence.
    pub kept: Vec<String>,
    /// The place that the parts are at, in words: the first pose of a requirement or a question, else where the band is widest.
    pub parts_at: String,
    /// Parts of the band there, the largest first.
    pub parts: Vec<BandPart>,
}

/// The source of a part of a band.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum PartKind {
    /// The play of a joint.
    Play,
    /// The scatter of a dimension.
    Part,
}

/// The share of one joint or one dimension in a band.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BandPart {
    /// Joint, or path of the dimension.
    pub name: String,
    /// Its source.
    pub kind: PartKind,
    /// Share of the outer band, 0 to 1.
    pub share: f64,
    /// Its share, with the unit.
    pub words: String,
}

/// A limit that a study puts on the magnitude of a deviation over the whole cycle.
#[derive(Debug, Clone, PartialEq)]
pub struct LiveLimit {
    /// Name of the output.
    pub output: String,
    /// The limit, SI, > 0.
    pub within_si: f64,
}

/// The bands of all outputs that have one, each with its limits; empty where nothing has play and nothing scatters.
pub fn live_bands(record: &MotionRecord, limits: &[LiveLimit]) -> Vec<LiveBand> {
    let writer = NumberWriter::for_page(&record.display_units);
    let limits_of = |output: &OutputMotion| -> Vec<f64> {
        let name = banded_name(output);
        limits.iter().filter(|limit| limit.output == name).map(|limit| limit.within_si).collect()
    };
    record.outputs.iter().filter_map(|output| band(record, output, &limits_of(output), &writer)).collect()
}

/// Whether a band stays within a limit, with half widths of the outer band and of the inner one where it has one.
fn kept_words(outer_si: f64, inner_si: Option<f64>, limit_si: f64, limit: &str) -> String {
    if outer_si <= limit_si {
        format!("Without dynamics the band stays within ±{limit}.")
    } else if inner_si.is_some_and(|inner_si| inner_si <= limit_si) {
        format!(
            "Without dynamics ±2 standard deviations stay within ±{limit}, but the largest first-order effect of play does not."
        )
    } else {
        format!("Without dynamics the band goes beyond ±{limit}.")
    }
}

/// An output whose band is drawn.
struct BandSource<'r> {
    name: String,
    /// Its description with its name.
    words: String,
    /// What moves, in the sentence on the largest value.
    moved: String,
    /// A size, which is never negative: its band begins at 0.
    is_size: bool,
    unit: &'r SiUnit,
    /// w, s_p and s_d at each position; s_p and s_d are empty where they are not known, or nothing scatters.
    first_order_si: &'r [f64],
    play_deviation_si: &'r [f64],
    scatter_si: &'r [f64],
}

impl BandSource<'_> {
    /// Half widths of the outer and the inner band at each position, SI.
    fn half_widths_si(&self) -> [Vec<f64>; 2] {
        let at = |list: &[f64], position: usize| list.get(position).copied().unwrap_or(0.0);
        let both = |position: usize| {
            let dimensions_si = at(self.scatter_si, position);
            let (worst_si, anywhere_si) = (at(self.first_order_si, position), at(self.play_deviation_si, position));
            [worst_si + DEVIATIONS * dimensions_si, DEVIATIONS * anywhere_si.hypot(dimensions_si)]
        };
        [0, 1].map(|which| (0..self.first_order_si.len()).map(|position| both(position)[which]).collect())
    }

    /// The position at which the outer band is widest, and half its width there, SI; `None` where it has none.
    fn largest_si(&self) -> Option<(usize, f64)> {
        let [outer_si, _] = self.half_widths_si();
        let [_, last] = places_of_largest(&outer_si)?;
        Some((last, outer_si[last])).filter(|(_, value_si)| *value_si > 0.0)
    }

    /// The band on a chart that has its horizontal axis; `at` is the place of the largest value in words.
    fn band(
        &self,
        mut chart: Chart,
        at: &str,
        (limits_si, parts): (&[f64], PlacedParts),
        writer: &NumberWriter,
    ) -> Option<LiveBand> {
        let (_, largest_si) = self.largest_si()?;
        let [outer_si, inner_si] = self.half_widths_si();
        let has = |values_si: &[f64]| values_si.iter().any(|value| *value != 0.0);
        let (has_play, has_parts) = (has(self.first_order_si), has(self.scatter_si));
        let outer = match has_parts {
            true => "largest first-order effect of play, and parts at ±2 standard deviations",
            false => "largest first-order effect of play",
        };
        let inner = match (has(self.play_deviation_si), has_parts) {
            (true, true) => Some("±2 standard deviations of play and parts"),
            (true, false) => Some("±2 standard deviations of play"),
            (false, true) => Some("±2 standard deviations of the parts"),
            (false, false) => None,
        };
        chart.set_vertical_axis(format!("deviation of {}", self.name), self.unit, writer);
        chart.height = HEIGHT;
        let mut add = |label: &str, role, half_si: &[f64]| {
            let upper = scaled(half_si, self.unit, writer);
            let lower: Vec<f64> = upper.iter().map(|value| if self.is_size { 0.0 } else { -value }).collect();
            chart.entries.push(Entry::new(label, role, false, EntryValues::band(&lower, &upper)));
        };
        if has_play {
            add(outer, Role::Mixed, &outer_si);
        }
        if let Some(inner) = inner {
            add(inner, Role::Random, &inner_si);
        }
        let mut kept = Vec::new();
        let most = |half_si: &[f64]| half_si.iter().fold(0.0_f64, |most, value| most.max(*value));
        for limit_si in limits_si {
            let limit = writer.value_trimmed(*limit_si, self.unit);
            let inner_si = inner.map(|_| most(&inner_si));
            kept.push(kept_words(most(&outer_si), inner_si, *limit_si, &limit));
            let [upper, lower] =
                [*limit_si, -limit_si].map(|value| vec![writer.scaled(value, self.unit); outer_si.len()]);
            chart.entries.push(Entry::new(
                format!("limit ±{limit}"),
                Role::Limit,
                true,
                EntryValues::pair(&lower, &upper),
            ));
        }
        let largest = format!(
            "{} by up to {}{}, at {at}",
            self.moved,
            if self.is_size { "" } else { "±" },
            writer.rounded(largest_si, self.unit, PLAIN_DIGITS, Rounding::Up),
        );
        chart.alternative = format!("Chart of the band of {} over one cycle, without dynamics: {largest}.", self.words);
        chart.caption = html! {};
        Some(LiveBand {
            output: self.name.clone(),
            words: self.words.clone(),
            largest,
            figure: chart.document(),
            largest_value: writer.scaled(largest_si, self.unit),
            unit: writer.symbol(self.unit),
            si_per_unit: 1.0 / writer.scaled(1.0, self.unit),
            kept,
            parts_at: parts.place,
            parts: shares(parts.parts, self.unit, writer),
        })
    }
}

/// The number whose band it is, as studies call it: of a displacement or a rotation its magnitude.
fn banded_name(output: &OutputMotion) -> String {
    if output.is_size() { format!("{} magnitude", output.name) } else { output.name.clone() }
}

fn source(output: &OutputMotion) -> BandSource<'_> {
    BandSource {
        name: banded_name(output),
        words: named_words(&output.name, &output.words),
        moved: moved_words(output),
        is_size: output.is_size(),
        unit: &output.unit,
        first_order_si: &output.clearance.first_order_si,
        play_deviation_si: &output.clearance.disc_standard_deviation_si,
        scatter_si: &output.dimensional_standard_deviation_si,
    }
}

fn band(record: &MotionRecord, output: &OutputMotion, limits_si: &[f64], writer: &NumberWriter) -> Option<LiveBand> {
    let source = source(output);
    let (position, _) = source.largest_si()?;
    let angle_rad = record.drive_angle_rad.get(position).copied().unwrap_or(f64::NAN);
    let at = turn_angle(record, angle_rad, 3, writer);
    let chart = angle_chart(record, name_of("band", &output.name), writer);
    let parts = match record.asked_of(&output.name).next() {
        Some(asked) => PlacedParts { place: asked_place(asked, writer), parts: asked_parts(asked) },
        None => {
            let place = format!("at {at}, where the band is widest");
            PlacedParts { place, parts: parts(output, position) }
        }
    };
    source.band(chart, &at, (limits_si, parts), writer)
}

/// Name, source and half width, SI, of a part of an outer band.
type Part = (String, PartKind, f64);

/// Parts of a band with their place in words.
struct PlacedParts {
    place: String,
    parts: Vec<Part>,
}

/// Parts of the outer band at a pose that a study asks about.
fn asked_parts(asked: &PoseEffect) -> Vec<Part> {
    let plays = asked.joints.iter().map(|own| (own.name.clone(), PartKind::Play, own.value_si));
    let dimensions = asked.dimensions.iter().map(|own| (own.name.as_str(), own.value_si));
    plays.chain(shares_of_scatter(dimensions.collect(), asked.standard_deviation_si)).collect()
}

/// Parts of the outer band at a position.
fn parts(output: &OutputMotion, position: usize) -> Vec<Part> {
    let at = |list: &[f64]| list.get(position).copied().unwrap_or(0.0);
    let plays = output
        .clearance
        .contributors
        .iter()
        .map(|joint| (joint.joint.clone(), PartKind::Play, at(&joint.first_order_si)));
    let all_si = at(&output.dimensional_standard_deviation_si);
    plays.chain(dimension_parts(&output.dimensional_contributors, all_si, position)).collect()
}

/// Parts of what scatters, with its standard deviation at a position. Dimensions share it as their variances do.
fn dimension_parts(dimensions: &[DimensionContributor], deviation_si: f64, position: usize) -> Vec<Part> {
    let own =
        |dimension: &'_ DimensionContributor| dimension.standard_deviation_si.get(position).copied().unwrap_or(0.0);
    let dimensions = dimensions.iter().map(|dimension| (dimension.path.as_str(), own(dimension)));
    shares_of_scatter(dimensions.collect(), deviation_si)
}

/// Parts of what scatters with this standard deviation, by the paths and the standard deviations of the dimensions alone.
fn shares_of_scatter(dimensions: Vec<(&str, f64)>, deviation_si: f64) -> Vec<Part> {
    let variances: f64 = dimensions.iter().map(|(_, own_si)| own_si.powi(2)).sum();
    let part = |(path, own_si): (&str, f64)| {
        let share = if variances > 0.0 { own_si.powi(2) / variances } else { 0.0 };
        (path.to_owned(), PartKind::Part, share * DEVIATIONS * deviation_si)
    };
    dimensions.into_iter().map(part).collect()
}

/// The parts, the largest first, with their shares.
fn shares(parts: Vec<Part>, unit: &SiUnit, writer: &NumberWriter) -> Vec<BandPart> {
    let mut parts: Vec<Part> = parts.into_iter().filter(|part| part.2 > 0.0).collect();
    parts.sort_by(|a, b| b.2.total_cmp(&a.2));
    let whole_si: f64 = parts.iter().map(|part| part.2).sum();
    let shared = |(name, kind, part_si): Part| BandPart {
        name,
        kind,
        share: part_si / whole_si,
        words: format!("±{}", writer.rounded(part_si, unit, PLAIN_DIGITS, Rounding::Nearest)),
    };
    parts.into_iter().map(shared).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_result::motion::{ClearanceAnswer, JointContributor};

    /// Two joints and two dimensions at one position: effects of 3 and 4 µm, standard deviations 1 and 2 µm.
    fn output() -> OutputMotion {
        let joint = |name: &str, worst_si: f64| JointContributor {
            joint: name.to_owned(),
            radial_clearance_m: 1e-4,
            first_order_si: vec![worst_si],
            ..JointContributor::default()
        };
        let dimension = |path: &str, deviation_si: f64| DimensionContributor {
            path: path.to_owned(),
            standard_deviation_si: vec![deviation_si],
        };
        OutputMotion {
            name: "slider".to_owned(),
            words: "x of slider.pin".to_owned(),
            unit: SiUnit::LENGTH,
            coordinate_of: None,
            path_error: None,
            value_si: vec![0.1],
            velocity_si: vec![0.0],
            acceleration_si: vec![0.0],
            clearance: ClearanceAnswer {
                first_order_si: vec![7e-6],
                // Each journal anywhere in its circle: the effect over 2, and 3² + 4² = 5².
                disc_standard_deviation_si: vec![2.5e-6],
                rim_standard_deviation_si: vec![5e-6 / 2f64.sqrt()],
                contributors: vec![joint("crank_pin", 3e-6), joint("gudgeon", 4e-6)],
                ..ClearanceAnswer::default()
            },
            dimensional_standard_deviation_si: vec![5f64.sqrt() * 1e-6],
            dimensional_contributors: vec![dimension("parameter.rod", 1e-6), dimension("parameter.crank", 2e-6)],
        }
    }

    #[test]
    fn analytic_the_inner_band_lies_in_the_outer_one() {
        let [outer_si, inner_si] = source(&output()).half_widths_si();
        assert!((outer_si[0] - (7e-6 + 2.0 * 5f64.sqrt() * 1e-6)).abs() < 1e-18);
        assert!((inner_si[0] - 2.0 * (2.5f64.powi(2) + 5.0).sqrt() * 1e-6).abs() < 1e-18);
        assert!(inner_si[0] < outer_si[0]);
    }

    #[test]
    fn a_limit_between_both_bands_is_kept_by_the_inner_one_alone() {
        let words = |limit_si: f64| kept_words(7.0, Some(5.0), limit_si, "x");
        assert_eq!(words(7.0), "Without dynamics the band stays within ±x.");
        assert!(words(6.0).contains("first-order effect of play does not"));
        assert_eq!(words(4.9), "Without dynamics the band goes beyond ±x.");
    }

    #[test]
    fn analytic_parts_make_the_whole_band() {
        let units = loosepin_text::units::DisplayUnits::default();
        let writer = NumberWriter::for_page(&units);
        let parts = shares(parts(&output(), 0), &SiUnit::LENGTH, &writer);
        let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
        assert_eq!(names, ["gudgeon", "parameter.crank", "crank_pin", "parameter.rod"]);
        assert!((parts.iter().map(|part| part.share).sum::<f64>() - 1.0).abs() < 1e-15);
        // The dimensions share 2 √5 µm as 4 to 1.
        let dimensions_si = 2.0 * 5f64.sqrt() * 1e-6;
        assert!((parts[1].share - 0.8 * dimensions_si / (7e-6 + dimensions_si)).abs() < 1e-15);
    }
}
