//! Every page is complete in itself, well-formed, escaped, and can be read without seeing its pictures.

use super::report_fixture;
use std::collections::BTreeSet;

use loosepin::report::{
    motion_page, motion_text, short_motion_text, short_simulation_text, short_study_text, simulation_page,
    simulation_text, study_page, study_text, sweep_page,
};
use loosepin::units::SiUnit;
use scraper::{ElementRef, Html, Selector};

/// A page must stay small enough to be sent by mail.
const MAX_PAGE_BYTES: usize = 1_500_000;
/// What the terminal is taken to hold; commands to be copied are exempt.
const TERMINAL_CHARACTERS: usize = 100;
/// A name as a careless or hostile file might hold it.
const HOSTILE: &str = "</script><script>alert(\"1\")</script>&<b>'\"";

fn pages() -> Vec<(&'static str, String)> {
    vec![
        ("study", study_page(&report_fixture::study::worn_pin())),
        ("lists", study_page(&report_fixture::study::with_list())),
        ("simulation", simulation_page(&report_fixture::simulation::worn_pin())),
        ("motion", motion_page(&report_fixture::motion::worn_pin())),
        ("four-bar", motion_page(&report_fixture::motion::four_bar())),
    ]
}

fn select<'a>(page: &'a Html, selector: &str) -> Vec<ElementRef<'a>> {
    let selector = Selector::parse(selector).expect("the selector is valid");
    page.select(&selector).collect()
}

fn parsed(name: &str, text: &str) -> Html {
    let page = Html::parse_document(text);
    assert!(page.errors.is_empty(), "{name} is not well-formed: {:?}", page.errors);
    page
}

#[test]
fn pages_are_well_formed_and_small() {
    for (name, text) in pages() {
        parsed(name, &text);
        assert!(text.len() < MAX_PAGE_BYTES, "{name} has {} bytes", text.len());
    }
}

#[test]
fn pages_have_the_date_when_they_are_written() {
    for (name, text) in pages() {
        let page = parsed(name, &text);
        let date = select(&page, "header .date").first().map(|date| date.text().collect::<String>()).expect("a date");
        // ` · 2026-11-25 17:00 UTC`
        let pattern = date.replace(|c: char| c.is_ascii_digit(), "0");
        assert_eq!(pattern, " · 0000-00-00 00:00 UTC", "{name}: {date}");
    }
}

#[test]
fn pages_load_nothing() {
    for (name, text) in pages() {
        let page = parsed(name, &text);
        for attribute in ["src", "srcset", "data", "poster", "action", "formaction", "background"] {
            let found = select(&page, &format!("[{attribute}]"));
            assert!(found.is_empty(), "{name} loads through {attribute}: {}", found[0].html());
        }
        assert!(select(&page, "link, iframe, object, embed, base").is_empty(), "{name} has an element that loads");
        for link in select(&page, "[href]") {
            assert!(link.attr("href").is_some_and(|target| target.starts_with('#')), "{name}: {}", link.html());
        }
        for style in select(&page, "style") {
            let style = style.inner_html();
            assert!(!style.contains("url(") && !style.contains("@import"), "{name} loads through its style");
        }
        let policy = select(&page, "meta[http-equiv=Content-Security-Policy]");
        assert!(policy[0].attr("content").is_some_and(|policy| policy.starts_with("default-src 'none'")));
    }
}

#[test]
fn every_figure_has_a_caption_and_a_text_alternative() {
    for (name, text) in pages() {
        let page = parsed(name, &text);
        let figures = select(&page, "figure");
        assert!(figures.len() >= 3, "{name} has {} figures", figures.len());
        for figure in figures {
            let inside = |selector: &str| {
                let selector = Selector::parse(selector).expect("the selector is valid");
                figure.select(&selector).collect::<Vec<_>>()
            };
            let captions = inside("figcaption");
            assert_eq!(captions.len(), 1, "{name}: {}", figure.html());
            assert!(captions[0].text().collect::<String>().trim().len() > 20, "{name}: {}", captions[0].html());
            for picture in inside("svg") {
                assert_eq!(picture.attr("role"), Some("img"), "{name}: {}", picture.html());
                assert!(picture.attr("aria-label").is_some_and(|label| label.len() > 3), "{name}: {}", picture.html());
            }
        }
    }
}

/// Words of an element, but for those of its scripts and terms that are explained.
fn words_of(element: ElementRef<'_>, words: &mut String) {
    for child in element.children() {
        if let Some(text) = child.value().as_text() {
            words.push_str(text);
        } else if let Some(inner) = ElementRef::wrap(child) {
            let is_left = ["script", "svg", "pre"].contains(&inner.value().name())
                || inner.value().classes().any(|class| class == "glossary");
            if !is_left {
                words_of(inner, words);
            }
        }
    }
}

#[test]
fn a_study_speaks_of_its_numerical_error_once() {
    for study in [report_fixture::study::worn_pin(), report_fixture::study::with_list()] {
        let page = parsed("study", &study_page(&study));
        let mut words = String::new();
        words_of(select(&page, "main")[0], &mut words);
        let words = words.to_lowercase();
        assert_eq!(words.matches("numerical error").count(), 1, "{words}");
        assert_eq!(words.matches("sampling error").count(), 0, "{words}");
    }
}

#[test]
fn sections_are_written_open_and_can_be_closed() {
    let page = parsed("study", &study_page(&report_fixture::study::worn_pin()));
    let sections = select(&page, ".folds > section");
    assert!(sections.len() >= 8);
    assert_eq!(select(&page, ".folds > section > details.fold[open] > summary > h2").len(), sections.len());
    // What forwards the answer stands before them.
    let shown = |selector: &str| select(&page, &format!(".opening {selector}")).len();
    assert_eq!((shown(".verdict"), shown("figure.mechanism"), shown("[data-chart]")), (1, 1, 1));
    assert_eq!(shown("#contributors-overview tbody tr"), 4, "an input a row");
    // Motions, runs and sweeps have the same form: the answer, one chart and one table.
    for (name, text, charts) in [
        ("motion", motion_page(&report_fixture::motion::worn_pin()), "[data-chart]"),
        ("simulation", simulation_page(&report_fixture::simulation::worn_pin()), "[data-chart]"),
        ("sweep", sweep_page(&report_fixture::sweep::windows()), "figure.section"),
    ] {
        let page = parsed(name, &text);
        assert!(select(&page, ".folds > section > details.fold[open]").len() >= 3, "{name}");
        assert!(select(&page, "nav").is_empty(), "{name}");
        let shown = |selector: &str| select(&page, &format!(".opening {selector}")).len();
        // Numbers behind a chart are a table, too.
        assert_eq!((shown(charts), shown(".more table")), (1, 1), "{name}");
        let rows = shown(".more tbody tr");
        assert!((1..=8).contains(&rows), "{name}: {rows}");
    }
    // A table that has more rows opens.
    let page = parsed("sweep", &sweep_page(&report_fixture::sweep::windows()));
    assert!(select(&page, ".folds #sections tbody tr").len() > 8);
    assert_eq!(select(&page, ".opening a[href='#sections']").len(), 1);
}

#[test]
fn every_id_is_unique_and_every_link_arrives() {
    for (name, text) in pages() {
        let page = parsed(name, &text);
        let mut ids = BTreeSet::new();
        for element in select(&page, "[id]") {
            let id = element.attr("id").expect("it was selected by its id");
            assert!(ids.insert(id.to_owned()), "{name} has two elements '{id}'");
        }
        for link in select(&page, "a[href]") {
            let target = link.attr("href").expect("it was selected by its target").trim_start_matches('#');
            assert!(ids.contains(target), "{name} has no '{target}'");
        }
    }
}

#[test]
fn headings_do_not_skip_a_level() {
    for (name, text) in pages() {
        let page = parsed(name, &text);
        let levels: Vec<u32> = select(&page, "h1, h2, h3, h4")
            .iter()
            .map(|heading| heading.value().name()[1..].parse().expect("h1 to h4"))
            .collect();
        assert_eq!(levels.iter().filter(|level| **level == 1).count(), 1, "{name} has one first heading");
        assert!(levels.windows(2).all(|pair| pair[1] <= pair[0] + 1), "{name}: {levels:?}");
    }
}

#[test]
fn every_joint_is_drawn_whichever_side_is_fixed() {
    let text = motion_page(&report_fixture::motion::four_bar());
    let page = parsed("four-bar", &text);
    let counted = |selector: &str| select(&page, selector).len();
    assert_eq!(counted(".mechanism .support"), 2, "both fixed pins stand on supports");
    assert_eq!(counted(".mechanism .pin"), 3);
    assert_eq!(counted(".mechanism .bearing"), 1, "a bearing in the ground is drawn too");
    assert_eq!(counted(".mechanism .journal"), 1);
    assert_eq!(counted(".mechanism .body .plate"), 1, "three points make a plate");
    assert_eq!(counted(".mechanism .body .bar"), 2);
    let slider_crank = parsed("study", &study_page(&report_fixture::study::worn_pin()));
    assert_eq!(select(&slider_crank, ".mechanism .guide").len(), 2, "two rails");
    assert_eq!(select(&slider_crank, ".mechanism .body .block").len(), 1);
}

#[test]
fn a_drawing_says_what_is_fixed_driven_and_asked_for_and_how_large_it_is() {
    let study = report_fixture::study::worn_pin();
    let page = parsed("study", &study_page(&study));
    let texts = |page: &Html, selector: &str| -> Vec<String> {
        select(page, selector).iter().map(|element| element.text().collect()).collect()
    };
    assert_eq!(select(&page, ".mechanism .ground .hatch").len(), 3, "a support and both rails of a fixed guide");
    assert_eq!(select(&page, ".mechanism .drive").len(), 1);
    assert_eq!(texts(&page, ".mechanism .of-drive text"), ["crank"]);
    assert_eq!(texts(&page, ".mechanism .output text"), ["slider"]);
    assert_eq!(texts(&page, ".mechanism .play-of text"), ["gudgeon"]);
    assert_eq!(texts(&page, ".mechanism .scale text"), ["50\u{a0}mm", "play × 5"]);
    assert_eq!(select(&page, ".magnification option[selected]")[0].attr("value"), Some("5"));
    // A motion has no mechanism with play beside the ideal one.
    let motion = parsed("motion", &motion_page(&report_fixture::motion::worn_pin()));
    assert_eq!(texts(&motion, ".mechanism .scale text"), ["50\u{a0}mm"]);
    // A record of an older version names neither drives nor outputs.
    let mut old = study;
    old.drawing.drives.clear();
    old.drawing.output_points.clear();
    let page = parsed("study", &study_page(&old));
    assert_eq!(select(&page, ".mechanism .drive, .mechanism .output").len(), 0);
    assert_eq!(select(&page, ".mechanism .ground .hatch").len(), 3);
}

#[test]
fn analytic_names_lie_within_the_picture_in_every_pose_and_do_not_hide_one_another() {
    for text in [study_page(&report_fixture::study::worn_pin()), motion_page(&report_fixture::motion::four_bar())] {
        let page = Html::parse_document(&text);
        let figure = select(&page, "figure.mechanism")[0];
        let inside = |selector: &str| {
            let selector = Selector::parse(selector).expect("the selector is valid");
            figure.select(&selector).collect::<Vec<_>>()
        };
        let number = |text: Option<&str>| text.and_then(|text| text.parse::<f64>().ok()).expect("it is a number");
        let view = inside("svg")[0].attr("viewBox").expect("it has a view");
        let view: Vec<f64> = view.split(' ').map(|side| side.parse().expect("a number")).collect();
        let style = inside(".signs")[0].attr("style").expect("letters have a size");
        let font_mm = number(style.trim_start_matches("font-size: ").strip_suffix("px"));
        assert!((0.015..0.05).contains(&(font_mm / view[2].hypot(view[3]))), "{font_mm} in {view:?}");
        let motion: serde_json::Value =
            serde_json::from_str(&inside("script[type='application/json']")[0].inner_html()).expect("poses are JSON");
        let riders = inside(".signs [data-rides]");
        assert!(riders.len() >= 3);
        for pose in 0..motion["angle_deg"].as_array().expect("a list").len() {
            let areas = |factor: f64| -> Vec<[f64; 4]> {
                let area = |rider: &ElementRef| {
                    let body = &motion["bodies"][number(rider.attr("data-rides")) as usize];
                    let at = |key: &str| body[key][pose].as_f64().unwrap_or(0.0);
                    let placed = |key: &str| at(key) + factor * at(&format!("d{key}"));
                    let (sine, cosine) = placed("a").to_radians().sin_cos();
                    let (x, y) = (number(rider.attr("data-x")), number(rider.attr("data-y")));
                    let text = Selector::parse("text").expect("the selector is valid");
                    let text = rider.select(&text).next().expect("a name");
                    let width = 0.5 * font_mm * text.text().collect::<String>().chars().count() as f64;
                    let before = match text.attr("text-anchor") {
                        Some("start") => 0.0,
                        Some("end") => width,
                        _ => 0.5 * width,
                    };
                    let left = placed("x") + cosine * x - sine * y + number(text.attr("x")) - before;
                    let base = -(placed("y") + sine * x + cosine * y) + number(text.attr("y"));
                    [left, left + width, base - 0.7 * font_mm, base]
                };
                riders.iter().map(area).collect()
            };
            for area in [areas(0.0), areas(motion["magnification"].as_f64().expect("a number"))].concat() {
                let [left, right, top, bottom] = area;
                let is_inside =
                    left > view[0] && right < view[0] + view[2] && top > view[1] && bottom < view[1] + view[3];
                assert!(is_inside, "a name at pose {pose}: {area:?} in {view:?}");
            }
            let areas = areas(0.0);
            for (index, [left, right, top, bottom]) in areas.iter().enumerate() {
                let meets =
                    |other: &[f64; 4]| *left < other[1] && other[0] < *right && *top < other[3] && other[2] < *bottom;
                assert!(!areas[..index].iter().any(meets), "names at pose {pose}: {areas:?}");
            }
        }
    }
}

#[test]
fn an_orbit_says_its_run_in_words_and_where_the_journal_touches() {
    let page = parsed("study", &study_page(&report_fixture::study::worn_pin()));
    let titles: Vec<String> = select(&page, "figure.orbit strong").iter().map(|title| title.text().collect()).collect();
    assert_eq!(titles, ["gudgeon, at the upper bound", "gudgeon, gudgeon radial clearance 0.1\u{a0}mm"]);
    for figure in select(&page, "figure.orbit") {
        let inside = |selector: &str| {
            let selector = Selector::parse(selector).expect("the selector is valid");
            figure.select(&selector).next().map(|element| element.inner_html())
        };
        assert!(inside("svg.figure .flight").is_some() && inside("svg.figure .track").is_some());
        let table = inside("script[type='text/csv']").expect("the script needs it");
        assert!(table.starts_with("angle [deg],x [mm],y [mm],force [N]\n0,"), "{}", &table[..60]);
        assert_eq!(table.lines().count(), 1501, "every sample stands in it");
    }
}

#[test]
fn values_of_different_members_of_a_list_are_apart() {
    let stored = |name: &str, text: &str| -> serde_json::Value {
        let page = parsed(name, text);
        let found = select(&page, "[data-what-if] script");
        serde_json::from_str(&found[0].inner_html()).expect("JSON")
    };
    let record = stored("lists", &study_page(&report_fixture::study::with_list()));
    let words =
        |key: &str| -> Vec<&str> { record[key].as_array().unwrap().iter().filter_map(|one| one.as_str()).collect() };
    assert_eq!(words("groups"), ["0.7", "0.8", "0.9"].map(|value| format!("Steel pin restitution {value}")));
    assert_eq!(record["start"], 0);
    assert_eq!(record["inputs"].as_array().map(Vec::len), Some(1));
    for group in 0..3 {
        let points = record["points"].as_array().unwrap().iter().filter(|point| point["group"] == group);
        let places: Vec<f64> = points.map(|point| point["at"][0].as_f64().unwrap()).collect();
        assert_eq!(places, [0.0, 0.25, 0.5, 0.75, 1.0], "group {group}");
    }
    // Two intervals: one group without words.
    let record = stored("study", &study_page(&report_fixture::study::worn_pin()));
    assert_eq!(record["groups"], serde_json::json!([""]));
    assert_eq!(record["inputs"].as_array().map(Vec::len), Some(2));
}

#[test]
fn text_from_files_is_escaped_everywhere() {
    let hostile = || HOSTILE.to_owned();
    let mut study = report_fixture::study::worn_pin();
    let scripts = |text: &str| select(&Html::parse_document(text), "script").len();
    let harmless = scripts(&study_page(&study));
    study.name = hostile();
    study.model = hostile();
    study.version = hostile();
    study.input_hash = hostile();
    study.cycle.drive = hostile();
    study.cycle.method = hostile();
    study.outputs[0].name = hostile();
    study.outputs[0].words = hostile();
    study.outputs[0].unit = SiUnit::from_symbol(HOSTILE);
    for input in &mut study.inputs {
        input.path = format!("a.{HOSTILE}{}", input.path);
        input.words = hostile();
    }
    for value in &mut study.curves[0].at_values {
        let renamed = value.at.iter().map(|(path, at)| (format!("a.{HOSTILE}{path}"), at.clone()));
        value.at = renamed.collect();
    }
    study.repeat.command = hostile();
    for file in &mut study.repeat.files {
        file.name = format!("{HOSTILE}.toml");
        file.text = hostile();
    }
    for bound in &mut study.bounds {
        bound.output = hostile();
        bound.unit = SiUnit::from_symbol(HOSTILE);
    }
    for requirement in &mut study.requirements {
        requirement.output = hostile();
    }
    study.failures[0].words = hostile();
    study.failures[0].code = hostile();
    study.failures[0].example.command = hostile();
    study.curves[0].output = hostile();
    study.boxes[0].output = hostile();
    study.treatments[0].output = hostile();
    study.impacts[0].joint = hostile();
    study.orbits[0].joint = hostile();
    study.orbits[0].label = hostile();
    for body in &mut study.drawing.bodies {
        body.name = hostile();
    }
    for joint in &mut study.drawing.joints {
        joint.name = hostile();
    }
    study.drawing.drives[0].name = hostile();
    study.drawing.output_points[0].name = hostile();
    study.orbits[1].label = format!("joint.{HOSTILE} = 1");
    assert_harmless("study", &study_page(&study), harmless);

    let mut run = report_fixture::simulation::worn_pin();
    let harmless = scripts(&simulation_page(&run));
    run.model = hostile();
    run.overrides[0].path = hostile();
    run.overrides[0].written = hostile();
    run.settings.drive = hostile();
    run.outputs[0].name = hostile();
    run.outputs[0].words = hostile();
    run.contact_forces[0].joint = hostile();
    run.impacts[0].joint = hostile();
    run.joints[0].law = hostile();
    run.joints[0].joint = hostile();
    run.extremes[0].name = hostile();
    run.stop = loosepin::simulate::record::StopReason::Failed { code: hostile(), words: hostile() };
    assert_harmless("simulation", &simulation_page(&run), harmless);

    let mut motion = report_fixture::motion::worn_pin();
    let harmless = scripts(&motion_page(&motion));
    motion.model = hostile();
    motion.mobility = hostile();
    motion.drive = hostile();
    motion.singular_positions[0].words = hostile();
    motion.outputs[0].name = hostile();
    motion.outputs[0].words = hostile();
    motion.outputs[0].clearance.contributors[0].joint = hostile();
    motion.outputs[0].dimensional_contributors[0].path = hostile();
    assert_harmless("motion", &motion_page(&motion), harmless);
}

#[test]
fn identity_a_page_gives_its_input_files_back_byte_for_byte() {
    let study = report_fixture::study::worn_pin();
    let page = parsed("study", &study_page(&study));
    let details = select(&page, "[data-input]");
    assert_eq!(details.len(), study.repeat.files.len());
    for (details, file) in details.iter().zip(&study.repeat.files) {
        let attribute = |name: &str| details.value().attr(name).map(str::to_owned);
        assert_eq!(attribute("data-input").as_deref(), Some(file.name.as_str()));
        let shown = details.text().collect::<String>();
        let shown = shown.strip_prefix(&file.name).expect("the summary, then the text");
        // As the script of the page reads it.
        let text = match attribute("data-exact") {
            Some(exact) => serde_json::from_str(&exact).expect("JSON"),
            None => shown.to_owned(),
        };
        assert_eq!(text, file.text, "{}", file.name);
    }
}

fn assert_harmless(name: &str, text: &str, scripts: usize) {
    let page = parsed(name, text);
    assert_eq!(select(&page, "script").len(), scripts, "{name}: a name became a script");
    assert!(select(&page, "b").is_empty(), "{name}: a name became an element");
    assert!(!text.contains("<script>alert"), "{name}: a name stands unescaped");
    assert!(text.contains("&lt;script&gt;alert"), "{name}: the name is shown");
}

#[test]
fn pages_of_almost_nothing_are_still_pages() {
    let mut study = report_fixture::study::worn_pin();
    study.inputs.clear();
    study.bounds.clear();
    study.curves.clear();
    study.boxes.clear();
    study.treatments.clear();
    study.requirements.clear();
    study.orbits.clear();
    study.failures.clear();
    study.impacts.clear();
    study.energy = None;
    study.settled_share = None;
    study.drawing = loosepin::simulate::record::Drawing::default();
    parsed("study", &study_page(&study));
    study_text(&study);
    let mut run = report_fixture::simulation::worn_pin();
    run.outputs.clear();
    run.extremes.clear();
    run.joints.clear();
    run.impacts.clear();
    run.orbits.clear();
    run.contact_forces.clear();
    run.time_s.clear();
    run.energy.residual_j.clear();
    run.drawing.poses = loosepin::simulate::record::PoseTable::default();
    parsed("simulation", &simulation_page(&run));
    simulation_text(&run);
    let mut motion = report_fixture::motion::worn_pin();
    motion.outputs.clear();
    motion.drive_angle_rad.clear();
    parsed("motion", &motion_page(&motion));
    // Play may be there, but nothing that it moves is asked for.
    let text = motion_text(&motion);
    assert!(text.contains("No output is a position or an angle: no effect of play is shown."), "{text}");
    assert!(!text.contains("is ideal"), "{text}");
}

#[test]
fn crooked_records_do_not_stop_a_page() {
    let mut study = report_fixture::study::worn_pin();
    study.curves[0].mixed.upper_si.truncate(3);
    study.curves[0].random.lower_si.clear();
    study.boxes[0].lower[4] = f64::NAN;
    study.drawing.joints[0].second.body = 99;
    study.drawing.joints[3].first.point = 99;
    study.orbits[0].x_m[5] = f64::NAN;
    study.orbits[1].radial_clearance_m = 0.0;
    study.orbits[1].drive_angle_rad.truncate(3);
    study.orbits[1].force_n.truncate(3);
    study.drawing.drives[0].joint = 99;
    study.drawing.output_points[0].point.body = 99;
    study.bounds[0].upper.value_si = f64::NAN;
    study.bounds[0].upper.widened_si = f64::INFINITY;
    study.treatments[0].bands[0].upper_si = f64::INFINITY;
    if let Some(energy) = &mut study.energy {
        energy.histogram[0].from = 0.0;
    }
    parsed("study", &study_page(&study));
    study_text(&study);
}

#[test]
fn pinned_terminal_text() {
    let expected = [
        ("study", study_text(&report_fixture::study::worn_pin()), include_str!("../expected/study.txt")),
        (
            "simulation",
            simulation_text(&report_fixture::simulation::worn_pin()),
            include_str!("../expected/simulation.txt"),
        ),
        ("motion", motion_text(&report_fixture::motion::worn_pin()), include_str!("../expected/motion.txt")),
        (
            "short study",
            short_study_text(&report_fixture::study::worn_pin()),
            include_str!("../expected/study_short.txt"),
        ),
        (
            "short simulation",
            short_simulation_text(&report_fixture::simulation::worn_pin()),
            include_str!("../expected/simulation_short.txt"),
        ),
        (
            "short motion",
            short_motion_text(&report_fixture::motion::worn_pin()),
            include_str!("../expected/motion_short.txt"),
        ),
    ];
    for (name, text, expected) in expected {
        assert_eq!(text, expected, "{name}: cargo run --example report_pages writes the text of today");
        for line in text.lines().filter(|line| !line.contains("loosepin simulate")) {
            assert!(line.chars().count() <= TERMINAL_CHARACTERS, "{name}: {line}");
            assert_eq!(line, line.trim_end(), "{name}: blanks at the end of a line");
        }
    }
}

#[test]
fn a_first_screen_has_at_most_40_lines_and_nothing_that_the_whole_text_lacks() {
    /// With the two lines of the command on its report.
    const LINES: usize = 38;
    let (mut study, outputs) = (report_fixture::study::worn_pin(), report_fixture::study::with_outputs(8));
    // The study of the README has one requirement, asks for nothing else, and no run fails.
    study.requirements.truncate(1);
    study.allowances.clear();
    (study.together, study.allocation) = (None, None);
    study.answers.clear();
    study.failures.clear();
    let run = report_fixture::simulation::worn_pin();
    let [motion, four_bar] = [report_fixture::motion::worn_pin(), report_fixture::motion::four_bar()];
    let texts = [
        ("study", short_study_text(&study), study_text(&study), LINES),
        // A sentence on each of eight outputs.
        ("outputs", short_study_text(&outputs), study_text(&outputs), 2 * LINES),
        ("simulation", short_simulation_text(&run), simulation_text(&run), LINES),
        ("motion", short_motion_text(&motion), motion_text(&motion), LINES),
        ("four-bar", short_motion_text(&four_bar), motion_text(&four_bar), LINES),
    ];
    for (name, short, whole, most) in texts {
        assert!(short.lines().count() <= most, "{name}: {} lines\n{short}", short.lines().count());
        let whole = whole.split_whitespace().collect::<Vec<_>>().join(" ");
        for line in short.lines() {
            let words = line.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(words.starts_with("---") || whole.contains(&words), "{name}: only on the first screen: {line}");
        }
    }
}
