//! Pictures that do not move and need no script: the path of a journal, bars, histograms.

use maud::{Markup, html};

use crate::charts::axes::with_unit;
use crate::charts::figure::{Picture, csv_number, csv_text, name_of};
use crate::charts::ticks::{tick_text, ticks};
use crate::medium::glue::glued;
use crate::numbers::number::{NumberWriter, Rounding, plain_name};
use crate::numbers::tag::Tag;
use loosepin_result::simulation::JournalOrbit;
use loosepin_result::study::HistogramBin;
use loosepin_text::units::SiUnit;

/// Half the side of an orbit picture in its own units; the clearance circle has radius 1000.
const ORBIT_HALF_SIDE: f64 = 1180.0;
/// Radius of the clearance circle.
const ORBIT_RADIUS: f64 = 1000.0;
/// Points of an orbit in a page.
const ORBIT_POINTS: usize = 3000;

/// A journal this close to the circle, as a share of the clearance, is on the rim: nobody sees the difference.
const RIM_SHARE: f64 = 0.999;
/// Width of a picture for which the caption says how large the clearance is drawn.
const STATED_WIDTH_MM: f64 = 80.0;
/// The bar of the scale is at least this share of the picture's width.
const BAR_SHARE: f64 = 0.1;
/// Classes of a path on the rim, by force; the widths of their lines grow as well.
const FORCE_CLASSES: [&str; 3] = ["low", "middle", "high"];

/// Path of a journal inside the circle of its clearance: on the rim coloured by force where it is known, in flight dotted.
pub(crate) fn orbit_figure(orbit: &JournalOrbit, writer: &NumberWriter) -> Markup {
    let clearance = writer.value_trimmed(orbit.radial_clearance_m, &SiUnit::LENGTH);
    let radii = || orbit.x_m.iter().zip(&orbit.y_m).map(|(x_m, y_m)| x_m.hypot(*y_m));
    let farthest_m = radii().fold(0.0, f64::max);
    let on_rim = radii().filter(|radius_m| *radius_m >= RIM_SHARE * orbit.radial_clearance_m).count();
    let rim_share = on_rim as f64 / orbit.x_m.len().max(1) as f64;
    let farthest = writer.value_trimmed(farthest_m, &SiUnit::LENGTH);
    let rim = writer.percent(rim_share, Rounding::Nearest);
    let label = label_words(&orbit.label);
    let title = orbit_title(orbit);
    // The name of the figure keeps what the record says, word for word.
    let named = if label.is_empty() { orbit.joint.clone() } else { format!("{}, {}", orbit.joint, orbit.label) };
    let steps = force_steps(orbit);
    let track = track(orbit, steps);
    let magnification = ORBIT_RADIUS / (2.0 * ORBIT_HALF_SIDE) * STATED_WIDTH_MM * 1e-3 / orbit.radial_clearance_m;
    let drawn = html! {
        @if !track.flight.is_empty() { path.flight d=(track.flight) {} }
        // A line of the ground's colour parts the path from the circle on which it lies.
        @for path in track.contact.iter().filter(|path| !path.is_empty()) { path.casing d=(path) {} }
        @for (class, path) in FORCE_CLASSES.into_iter().zip(&track.contact).filter(|(_, path)| !path.is_empty()) {
            path class={ "track " (if steps.is_some() { class } else { "middle" }) } d=(path) {}
        }
    };
    let caption = html! {
        strong { (title) } ". Circle: radial clearance " (clearance)
        @if magnification.is_finite() {
            ", magnified " (round_to_two(magnification)) " times at a width of " (STATED_WIDTH_MM) "\u{a0}mm"
        }
        ". On the rim in " (rim) " of the samples. "
        @if let Some([low_n, high_n]) = steps {
            @let [low, high] = [low_n, high_n].map(|force_n| writer.value_trimmed(force_n, &SiUnit::FORCE));
            (key("low", &format!("below {low},"))) " " (key("middle", &format!("up to {high},"))) " "
            (key("high", "above;")) " "
        } @else {
            (key("middle", "on the rim,")) " "
        }
        (key("flight", "in flight.")) " Straight between samples."
        @if step(orbit) > 1 { " One of " (step(orbit)) " samples is drawn." }
    };
    let csv = csv(orbit, writer);
    in_circle(
        orbit.radial_clearance_m,
        writer,
        &format!("Path of the journal of {title}: within {farthest} of the bearing's centre, clearance {clearance}."),
        &name_of("orbit", &named),
        (drawn, caption),
        Some(&csv),
    )
}

/// All orbits, and a list of their names: where scripts run, it chooses the one that is shown.
pub(crate) fn orbit_chooser(orbits: &[JournalOrbit], writer: &NumberWriter) -> Markup {
    html! {
        div.orbits data-chooser {
            @if orbits.len() > 1 {
                div.controls {
                    label { span { "Bearing" } select { @for orbit in orbits { option { (orbit_title(orbit)) } } } }
                }
            }
            @for orbit in orbits { (orbit_figure(orbit, writer)) }
        }
    }
}

/// Joint and run of an orbit in words.
fn orbit_title(orbit: &JournalOrbit) -> String {
    let label = label_words(&orbit.label);
    if label.is_empty() { orbit.joint.clone() } else { format!("{}, {label}", orbit.joint) }
}

/// A label of a record in words: `joint.gudgeon.radial_clearance = 0.1 mm` is "gudgeon radial clearance 0.1 mm".
fn label_words(label: &str) -> String {
    match label.split_once(" = ") {
        Some((path, value)) if path.contains('.') && !path.contains(' ') => {
            format!("{} {}", plain_name(path, &[]), glued(value))
        }
        _ => glued(label),
    }
}

/// A line as in the picture and what it stands for, for a caption.
fn key(class: &str, stands_for: &str) -> Markup {
    let (path, words) = match class {
        "flight" => ("flight", "dotted line"),
        "low" => ("track low", "thin line"),
        "high" => ("track high", "thick line"),
        _ => ("track middle", "line"),
    };
    html! {
        span.entry {
            svg.orbit.key viewBox="0 0 220 60" role="img" aria-label=(words) { path class=(path) d="M10 30H210" {} }
            " " (stands_for)
        }
    }
}

/// The forces that part the samples on the rim into thirds, N, to one digit; `None` if no forces are known, or hardly different ones.
fn force_steps(orbit: &JournalOrbit) -> Option<[f64; 2]> {
    if orbit.force_n.len() != orbit.x_m.len() {
        return None;
    }
    let is_on_rim =
        |sample: &usize| orbit.x_m[*sample].hypot(orbit.y_m[*sample]) >= RIM_SHARE * orbit.radial_clearance_m;
    let count = orbit.x_m.len().min(orbit.y_m.len());
    let mut forces_n: Vec<f64> = (0..count)
        .filter(is_on_rim)
        .map(|sample| orbit.force_n[sample])
        .filter(|force_n| force_n.is_finite())
        .collect();
    forces_n.sort_by(f64::total_cmp);
    let third = |share: usize| forces_n.get(share * forces_n.len() / FORCE_CLASSES.len()).copied().map(round_to_one);
    match (third(1), third(2)) {
        (Some(low_n), Some(high_n)) if low_n > 0.0 && high_n > low_n => Some([low_n, high_n]),
        _ => None,
    }
}

fn round_to_one(value: f64) -> f64 {
    format!("{value:.0e}").parse().unwrap_or(value)
}

/// To two digits, without an exponent.
fn round_to_two(value: f64) -> String {
    let rounded: f64 = format!("{value:.1e}").parse().unwrap_or(value);
    tick_text(rounded, 10_f64.powf(rounded.log10().floor() - 1.0))
}

/// The path in parts.
struct Track {
    flight: String,
    /// On the rim, by step of force; all in the first where there are none.
    contact: [String; 3],
}

/// Lines from sample to sample. One is on the rim where both of its ends are; its force is the larger of both.
fn track(orbit: &JournalOrbit, steps: Option<[f64; 2]>) -> Track {
    let mut track = Track { flight: String::new(), contact: Default::default() };
    // Where the last line ended, and of which part it was.
    let mut last: Option<(usize, Option<usize>)> = None;
    let samples: Vec<usize> = drawn_samples(orbit).collect();
    for pair in samples.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let (Some(start), Some(end)) = (place(orbit, from), place(orbit, to)) else {
            last = None;
            continue;
        };
        let is_on_rim =
            |sample: usize| orbit.x_m[sample].hypot(orbit.y_m[sample]) >= RIM_SHARE * orbit.radial_clearance_m;
        let part = (is_on_rim(from) && is_on_rim(to)).then(|| {
            let force_n = |sample: usize| orbit.force_n.get(sample).copied().unwrap_or(0.0);
            let largest_n = force_n(from).max(force_n(to));
            steps.map_or(0, |steps| steps.iter().filter(|step_n| largest_n > **step_n).count())
        });
        let path = part.map_or(&mut track.flight, |step| &mut track.contact[step]);
        if last != Some((from, part)) {
            path.push_str(&format!("M{start}"));
        }
        path.push_str(&format!("L{end}"));
        last = Some((to, part));
    }
    track
}

/// The samples of a page: all, up to its limit.
fn drawn_samples(orbit: &JournalOrbit) -> impl Iterator<Item = usize> + use<> {
    (0..samples(orbit)).step_by(step(orbit))
}

/// Interval between the samples shown in a page.
fn step(orbit: &JournalOrbit) -> usize {
    samples(orbit).div_ceil(ORBIT_POINTS).max(1)
}

fn samples(orbit: &JournalOrbit) -> usize {
    orbit.x_m.len().min(orbit.y_m.len())
}

/// Position of a journal, in units of the picture.
fn place(orbit: &JournalOrbit, sample: usize) -> Option<String> {
    let scale = if orbit.radial_clearance_m > 0.0 { ORBIT_RADIUS / orbit.radial_clearance_m } else { 0.0 };
    let (x_m, y_m) = (orbit.x_m[sample], orbit.y_m[sample]);
    (x_m + y_m).is_finite().then(|| format!("{:.0} {:.0}", x_m * scale, y_m * scale))
}

/// The drawn samples as a table; the script reads the angles and places from it.
fn csv(orbit: &JournalOrbit, writer: &NumberWriter) -> String {
    let symbol = writer.symbol(&SiUnit::LENGTH);
    let has_angles = orbit.drive_angle_rad.len() == orbit.x_m.len();
    let has_forces = orbit.force_n.len() == orbit.x_m.len();
    let mut heads = Vec::new();
    if has_angles {
        heads.push("angle [deg]".to_owned());
    }
    heads.extend(["x", "y"].map(|words| with_unit(words, &symbol)));
    if has_forces {
        heads.push("force [N]".to_owned());
    }
    let number = |value: f64, places| if value.is_finite() { to_places(value, places) } else { String::new() };
    // The picture shows a thousandth of the clearance: places for a hundredth of that.
    let clearance = writer.scaled(orbit.radial_clearance_m, &SiUnit::LENGTH);
    let length_places = (5.0 - clearance.log10().floor()).clamp(0.0, 12.0) as usize;
    let mut table = format!("{}\n", heads.join(","));
    for sample in drawn_samples(orbit) {
        let mut cells = Vec::new();
        if has_angles {
            cells.push(number(orbit.drive_angle_rad[sample].to_degrees(), 2));
        }
        cells.extend(
            [orbit.x_m[sample], orbit.y_m[sample]]
                .map(|value_m| number(writer.scaled(value_m, &SiUnit::LENGTH), length_places)),
        );
        if has_forces {
            cells.push(number(orbit.force_n[sample], 2));
        }
        table.push_str(&format!("{}\n", cells.join(",")));
    }
    table
}

/// A number rounded to this number of decimals, without trailing zeros.
fn to_places(value: f64, places: usize) -> String {
    let text = format!("{value:.places$}");
    let text = if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

/// A journal once a turn, inside the circle of its clearance: a dot for each turn.
pub(crate) fn journal_sections(journal: &JournalOrbit, writer: &NumberWriter) -> Markup {
    let joint = &journal.joint;
    let tag = Tag::joint(joint, "clearance", "radial");
    let clearance = writer.with_tag(&tag).value_trimmed(journal.radial_clearance_m, &SiUnit::LENGTH);
    let turns = writer.with_tag(&Tag::Given("turns that are examined")).count(journal.x_m.len() as u64);
    let places = drawn_samples(journal).filter_map(|sample| place(journal, sample));
    let dots: String = places.map(|place| format!("M{place}h0")).collect();
    let caption =
        html! { strong { (joint) ", once a turn" } ". Circle: radial clearance " (clearance) ". " (turns) " turns." };
    in_circle(
        journal.radial_clearance_m,
        writer,
        &format!("The journal of {joint} once a turn, {turns} turns: dots in the circle of the clearance {clearance}."),
        &name_of("once-a-turn", joint),
        (html! { path.dots d=(dots) {} }, caption),
        Some(&sections_csv(journal, writer)),
    )
}

/// The dots, a row for each turn that is drawn.
fn sections_csv(journal: &JournalOrbit, writer: &NumberWriter) -> String {
    let symbol = writer.symbol(&SiUnit::LENGTH);
    let heads = ["turn".to_owned(), with_unit("x", &symbol), with_unit("y", &symbol)].map(|head| csv_text(&head));
    let mut table = format!("{}\n", heads.join(","));
    for turn in drawn_samples(journal) {
        let [x, y] =
            [journal.x_m[turn], journal.y_m[turn]].map(|value_m| csv_number(writer.scaled(value_m, &SiUnit::LENGTH)));
        table.push_str(&format!("{},{x},{y}\n", turn + 1));
    }
    table
}

/// The circle of a clearance with what is drawn in it, and a bar of a round length below.
fn in_circle(
    clearance_m: f64,
    writer: &NumberWriter,
    alternative: &str,
    name: &str,
    (drawn, caption): (Markup, Markup),
    csv: Option<&str>,
) -> Markup {
    let view = [-ORBIT_HALF_SIDE, -ORBIT_HALF_SIDE, 2.0 * ORBIT_HALF_SIDE, 2.0 * ORBIT_HALF_SIDE];
    let clearance = writer.scaled(clearance_m, &SiUnit::LENGTH);
    let per_unit = ORBIT_RADIUS / clearance;
    let width = 2.0 * ORBIT_HALF_SIDE / per_unit;
    let (_, bar) = ticks(0.0, width, BAR_SHARE * width, false);
    let drawn = html! {
        g transform="scale(1 -1)" {
            line.axis x1="-1120" x2="1120" y1="0" y2="0" {}
            line.axis y1="-1120" y2="1120" x1="0" x2="0" {}
            circle.clearance r=(ORBIT_RADIUS) data-radius=(clearance) {}
            (drawn)
        }
        @if per_unit.is_finite() && per_unit > 0.0 {
            g.bar {
                path d=(format!("M-1140 1100v40h{:.0}v-40", bar * per_unit)) {}
                text x=(format!("{:.0}", bar * per_unit - 1105.0)) y="1148" { (tick_text(bar, bar)) "\u{a0}" (writer.symbol(&SiUnit::LENGTH)) }
            }
        }
    };
    Picture { name: name.to_owned(), class: "orbit", view, below: 0.0, alternative: alternative.to_owned(), drawn }
        .figure(caption, csv)
}

/// Position of `value` between `from` and `to`, in percent of the width.
pub(crate) fn percent_of(value: f64, from: f64, to: f64) -> String {
    let share = if to > from { (value - from) / (to - from) } else { 0.5 };
    // The ends may be infinite where a bound does not exist.
    let share = if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 };
    format!("{:.3}%", 100.0 * share)
}

/// Width and height of a histogram in its own units; a unit is about a pixel.
const HISTOGRAM: [f64; 2] = [600.0, 190.0];
/// Room at the sides of a histogram, height of its highest bar, and where its axis is.
const HISTOGRAM_SIDE: f64 = 40.0;
const HISTOGRAM_BAR: f64 = 120.0;
const HISTOGRAM_AXIS: f64 = 135.0;
/// Room between two bars.
const HISTOGRAM_GAP: f64 = 1.5;

/// Bars of the numbers of runs over a logarithmic axis of `what`, a pure number.
pub(crate) fn histogram_figure(
    bins: &[HistogramBin],
    name: &str,
    what: &str,
    caption: Markup,
    alternative: String,
) -> Markup {
    // A logarithmic axis has no place for anything else, and its decades are counted below.
    let bins: Vec<&HistogramBin> = bins
        .iter()
        .filter(|bin| bin.from.is_normal() && bin.from > 0.0 && bin.to > bin.from && bin.to.is_finite())
        .collect();
    let most = bins.iter().map(|bin| bin.count).max().unwrap_or(0).max(1) as f64;
    let (Some(first), Some(last)) = (bins.first(), bins.last()) else { return html! {} };
    let (from, to) = (first.from.log10(), last.to.log10());
    let decades: Vec<i32> = (from.ceil() as i32..=to.floor() as i32).collect();
    let every = decades.len().div_ceil(8).max(1);
    let [width, height] = HISTOGRAM;
    let (left, right) = (HISTOGRAM_SIDE, width - HISTOGRAM_SIDE);
    let place = |power: f64| left + (power - from) / (to - from) * (right - left);
    let drawn = html! {
        @for bin in &bins {
            @let (start, end) = (place(bin.from.log10()), place(bin.to.log10()));
            @let high = HISTOGRAM_BAR * bin.count as f64 / most;
            rect.bar x=(format!("{start:.2}")) width=(format!("{:.2}", (end - start - HISTOGRAM_GAP).max(0.5)))
                y=(format!("{:.2}", HISTOGRAM_AXIS - high)) height=(format!("{high:.2}")) {
                title { (bin.count) @if bin.count == 1 { " run" } @else { " runs" } }
            }
        }
        line.axis x1=(left) x2=(right) y1=(HISTOGRAM_AXIS) y2=(HISTOGRAM_AXIS) {}
        @for decade in decades.iter().step_by(every) {
            text x=(format!("{:.2}", place(f64::from(*decade)))) y=(HISTOGRAM_AXIS + 20.0) text-anchor="middle" {
                "10" tspan dy="-5" font-size="80%" { (decade.to_string().replace('-', "−")) }
            }
        }
        text x=(0.5 * width) y=(height - 8.0) text-anchor="middle" { (what) }
    };
    let rows = bins.iter().map(|bin| format!("{},{},{}\n", csv_number(bin.from), csv_number(bin.to), bin.count));
    let table = format!(
        "{},{},runs\n{}",
        csv_text(&format!("{what} from")),
        csv_text(&format!("{what} to")),
        rows.collect::<String>()
    );
    let view = [0.0, 0.0, width, height];
    Picture { name: name.to_owned(), class: "histogram", view, below: 0.0, alternative, drawn }
        .figure(caption, Some(&table))
}

#[cfg(test)]
mod tests {
    use super::*;
    use loosepin_text::units::DisplayUnits;

    /// Flight from the rim across the hole, then along the rim with growing force.
    fn orbit() -> JournalOrbit {
        let rim = |degrees: f64| (1e-4 * degrees.to_radians().cos(), 1e-4 * degrees.to_radians().sin());
        let places = [rim(180.0), (0.0, 0.0), rim(0.0), rim(30.0), rim(60.0), rim(90.0)];
        JournalOrbit {
            joint: "gudgeon".to_owned(),
            label: "joint.gudgeon.radial_clearance = 0.1 mm".to_owned(),
            radial_clearance_m: 1e-4,
            x_m: places.iter().map(|place| place.0).collect(),
            y_m: places.iter().map(|place| place.1).collect(),
            drive_angle_rad: (0..6).map(f64::from).map(|k| (60.0 * k).to_radians()).collect(),
            force_n: vec![3.0, 0.0, 12.0, 31.0, 58.0, 400.0],
        }
    }

    fn figure(orbit: &JournalOrbit) -> String {
        let units = DisplayUnits::default();
        orbit_figure(orbit, &NumberWriter::for_page(&units)).into_string()
    }

    #[test]
    fn analytic_a_path_in_flight_is_apart_from_that_on_the_rim() {
        let track = track(&orbit(), None);
        assert_eq!(track.flight, "M-1000 0L0 0L1000 0");
        assert_eq!(track.contact[0], "M1000 0L866 500L500 866L0 1000");
        let mut broken = orbit();
        broken.x_m[4] = f64::NAN;
        assert_eq!(
            super::track(&broken, None).contact[0],
            "M1000 0L866 500",
            "no line through a sample without a place"
        );
    }

    #[test]
    fn analytic_forces_are_parted_into_thirds_of_the_samples_on_the_rim() {
        let orbit = orbit();
        // On the rim: 3, 12, 31, 58, 400 N; entries 1 and 3 of five.
        assert_eq!(force_steps(&orbit), Some([10.0, 60.0]));
        let track = track(&orbit, force_steps(&orbit));
        assert_eq!(track.contact, ["", "M1000 0L866 500L500 866", "M500 866L0 1000"].map(str::to_owned));
        let even = JournalOrbit { force_n: vec![7.0; 6], ..orbit.clone() };
        assert_eq!(force_steps(&even), None);
        let old = JournalOrbit { force_n: Vec::new(), ..orbit };
        assert_eq!(force_steps(&old), None);
        assert!(figure(&old).contains("on the rim,<") && !figure(&old).contains("by force"));
    }

    #[test]
    fn a_caption_says_words_and_magnification() {
        let text = figure(&orbit());
        assert!(text.contains("<strong>gudgeon, gudgeon radial clearance 0.1\u{a0}mm</strong>"), "{text}");
        // 80 mm times 1000 / 2360, over 0.1 mm: 339.
        assert!(text.contains("magnified 340 times at a width of 80\u{a0}mm"), "{text}");
        assert!(text.contains("below 10\u{a0}N") && text.contains("up to 60\u{a0}N"), "{text}");
        assert_eq!(label_words("at e = 2"), "at e = 2", "words stay");
    }

    #[test]
    fn analytic_the_table_has_angles_only_where_they_are_known() {
        let text = figure(&orbit());
        assert!(text.contains("angle [deg],x [mm],y [mm],force [N]\n0,-0.1,0,3\n60,0,0,0\n120,0.1,0,12\n"), "{text}");
        let old = JournalOrbit { drive_angle_rad: Vec::new(), force_n: Vec::new(), ..orbit() };
        assert!(figure(&old).contains("\nx [mm],y [mm]\n") || figure(&old).contains(">x [mm],y [mm]\n"));
    }

    #[test]
    fn nothing_is_left_out_below_the_limit() {
        let many = |count: usize| JournalOrbit { x_m: vec![0.0; count], y_m: vec![0.0; count], ..orbit() };
        assert_eq!(drawn_samples(&many(ORBIT_POINTS)).count(), ORBIT_POINTS);
        assert!(drawn_samples(&many(ORBIT_POINTS + 1)).count() <= ORBIT_POINTS);
        assert!(!figure(&many(ORBIT_POINTS)).contains("samples is drawn"));
        assert!(figure(&many(2 * ORBIT_POINTS + 1)).contains("One of 3 samples is drawn."));
    }
}
