//! Figures of pages as files of their own: every one of every page, by its name.

use std::collections::BTreeSet;

use loosepin::report::{
    figures, motion_page, simulation_excerpt, simulation_frame, simulation_page, study_excerpt, study_frame, study_page,
};
use loosepin::simulate::record::DriveSense;

use crate::report_fixture;

/// Names that must not change: scripts and papers call figures by them.
const NAMES: [(&str, &[&str]); 4] = [
    ("study", &["mechanism", "deviation.slider", "orbit.gudgeon", "distribution.slider", "energy-residuals"]),
    ("simulation", &["mechanism", "deviation.slider", "output.slider", "orbit.gudgeon"]),
    ("motion", &["mechanism", "clearance.slider", "scatter.slider", "position.slider", "velocity.slider"]),
    ("four_bar", &["mechanism"]),
];

fn pages() -> [(&'static str, String); 4] {
    [
        ("study", study_page(&report_fixture::study::worn_pin())),
        ("simulation", simulation_page(&report_fixture::simulation::worn_pin())),
        ("motion", motion_page(&report_fixture::motion::worn_pin())),
        ("four_bar", motion_page(&report_fixture::motion::four_bar())),
    ]
}

#[test]
fn every_figure_is_a_picture_with_a_stable_name() {
    for ((page, text), (_, known)) in pages().into_iter().zip(NAMES) {
        let found = figures(&text);
        assert_eq!(found.len(), text.matches("data-figure=").count(), "{page}: every figure is found");
        let names: BTreeSet<&str> = found.iter().map(|figure| figure.name.as_str()).collect();
        assert_eq!(names.len(), found.len(), "{page}: names are different: {names:?}");
        for name in known {
            assert!(names.iter().any(|found| found.starts_with(name)), "{page} has no '{name}': {names:?}");
        }
        for figure in &found {
            assert!(figure.title().len() > 10, "{page}: {}", figure.name);
            let svg = figure.to_svg(Some(84.0));
            let root =
                roxmltree::Document::parse(&svg).unwrap_or_else(|error| panic!("{page} {}: {error}", figure.name));
            let root = root.root_element();
            assert_eq!((root.tag_name().name(), root.attribute("width")), ("svg", Some("84.0mm")), "{}", figure.name);
            // Programs that draw know no variables of a page.
            assert!(!svg.contains("var(--"), "{page} {}", figure.name);
        }
    }
}

#[test]
fn identity_the_table_of_a_band_has_all_its_numbers() {
    let result = report_fixture::study::worn_pin();
    let figures = figures(&study_page(&result));
    let band = figures.iter().find(|figure| figure.name == "deviation.slider").expect("the band");
    let csv = band.to_csv().expect("a chart has numbers");
    let mut rows = csv.lines();
    assert!(rows.next().is_some_and(|line| line.starts_with("# figure deviation.slider of study ")), "{csv}");
    let heads = rows.next().expect("a header");
    assert!(heads.starts_with("angle of crank [°],") && heads.contains("lower [mm]"), "{heads}");
    let curve = &result.curves[0];
    assert_eq!(rows.clone().count(), curve.pose_rad.len());
    for (row, line) in rows.enumerate() {
        let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().expect("a number")).collect();
        let due = [curve.pose_rad[row].to_degrees(), 1e3 * curve.mixed.lower_si[row], 1e3 * curve.mixed.upper_si[row]];
        // Six digits.
        for (cell, due) in cells.iter().zip(due) {
            assert!((cell - due).abs() <= 1e-5 * due.abs(), "row {row}: {cell} and {due}");
        }
    }
}

#[test]
fn identity_a_histogram_has_its_counts() {
    let result = report_fixture::study::worn_pin();
    let figures = figures(&study_page(&result));
    let csv = figures.iter().find(|figure| figure.name == "energy-residuals").and_then(|figure| figure.to_csv());
    let csv = csv.expect("a histogram has numbers");
    let rows: Vec<Vec<f64>> =
        csv.lines().skip(2).map(|line| line.split(',').map(|cell| cell.parse().expect("a number")).collect()).collect();
    let bins = result.energy.expect("the fixture has residuals").histogram;
    assert_eq!(rows.len(), bins.len());
    for (row, bin) in rows.iter().zip(&bins) {
        assert_eq!(row[2], bin.count as f64);
        // Nine digits.
        assert!((row[0] / bin.from - 1.0).abs() < 1e-8 && (row[1] / bin.to - 1.0).abs() < 1e-8, "{row:?}");
    }
}

#[test]
fn a_mechanism_tells_signs_that_it_has() {
    let mut record = report_fixture::motion::worn_pin();
    let page = motion_page(&record);
    assert!(page.contains(" Arrow: drive.") && page.contains(" Flag: output."));
    for drive in &mut record.drawing.drives {
        drive.sense = DriveSense::Still;
    }
    record.drawing.output_points.clear();
    let page = motion_page(&record);
    assert!(!page.contains("Arrow: drive.") && !page.contains("Flag: output."));
}

#[test]
fn identity_a_notebook_shows_the_mechanism_and_the_curves() {
    let result = report_fixture::study::worn_pin();
    let of_page = figures(&study_page(&result));
    let excerpt = study_excerpt(&result);
    let curves = of_page.iter().filter(|figure| figure.name.starts_with("deviation."));
    let mechanism = of_page.iter().filter(|figure| figure.name == "mechanism");
    let due: Vec<String> = mechanism.chain(curves).map(|figure| figure.to_svg(None)).collect();
    assert_eq!(pictures(&excerpt), due);
    assert!(due.len() >= 2 && !excerpt.contains("<script"));
    let run = report_fixture::simulation::worn_pin();
    let of_page = figures(&simulation_page(&run));
    assert_eq!(pictures(&simulation_excerpt(&run)), [of_page[0].to_svg(None), of_page[1].to_svg(None)]);
    assert!(of_page[0].name == "mechanism" && of_page[1].name.starts_with("deviation."));
}

#[test]
fn identity_a_frame_is_the_first_screen_of_its_page() {
    let opening = |page: &str, from: &str| {
        let (_, rest) = page.split_once("<div class=\"opening").expect("the first screen");
        rest.split_once(from).expect("its end").0.to_owned()
    };
    let result = report_fixture::study::worn_pin();
    let (page, frame) = (study_page(&result), study_frame(&result).document);
    assert_eq!(opening(&frame, "<section id=\"bounds\""), opening(&page, "<div class=\"folds\""));
    let run = report_fixture::simulation::worn_pin();
    let (page, frame) = (simulation_page(&run), simulation_frame(&run).document);
    assert_eq!(opening(&frame, "</main>"), opening(&page, "<div class=\"folds\""));
    assert_eq!(frame.matches("<section ").count(), 2, "the answer and the extremes");
    // Every script of the page, and one more.
    assert_eq!(frame.matches("<script>").count(), page.matches("<script>").count() + 1);
}

/// The pictures of a part of a page, decoded.
fn pictures(part: &str) -> Vec<String> {
    let sources = part.split("<img src=\"data:image/svg+xml;charset=utf-8,").skip(1);
    sources.map(|rest| decoded(rest.split_once('"').expect("its end").0)).collect()
}

fn decoded(source: &str) -> String {
    let mut parts = source.split('%');
    let mut bytes = parts.next().expect("a beginning").as_bytes().to_vec();
    for part in parts {
        bytes.push(u8::from_str_radix(&part[..2], 16).expect("two digits"));
        bytes.extend_from_slice(&part.as_bytes()[2..]);
    }
    String::from_utf8(bytes).expect("UTF-8")
}
