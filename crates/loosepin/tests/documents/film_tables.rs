//! The tables of docs/lubrication.md and measured/films.md: published loads and attitudes of bearings beside ours.

use loosepin::contact::{FILM_LAWS, FilmBearing, FilmForce, FilmMotion, FilmPressure};

const ROTATION: &str = include_str!("../../../loosepin-mechanics/src/contact/film/butenschoen/rotation.csv");
const SQUEEZE: &str = include_str!("../../../loosepin-mechanics/src/contact/film/butenschoen/squeeze.csv");

/// A line of a file: ε, D/L, the load, the attitude; numbers, and as they are printed.
struct Row {
    ratio: f64,
    width: f64,
    numbers: [f64; 2],
    texts: [&'static str; 2],
}

fn rows(file: &'static str) -> Vec<Row> {
    let read = |line: &'static str| {
        let texts: Vec<&str> = line.split(',').collect();
        let number = |column: usize| texts[column].parse::<f64>().expect("a number");
        // 0.333333 is a third.
        let width = (10.0 / number(1)).round() / 10.0;
        Row { ratio: number(0), width, numbers: [number(2), number(3)], texts: [texts[2], texts[3]] }
    };
    file.lines().skip(1).map(read).collect()
}

/// So and the attitude, degrees, of a film by its name, for one row of the table of rotation or of squeeze.
fn of_film(law: &str, row: &Row, is_turning: bool) -> [f64; 2] {
    let description = FILM_LAWS.iter().find(|description| description.name == law).expect("the film");
    // R = c = μ L = 1.
    let film = (description.law)(&FilmBearing {
        viscosity_pa_s: 0.5 * row.width,
        radius_m: 1.0,
        length_m: 2.0 / row.width,
        clearance_m: 1.0,
        roughness_m: 0.01,
    });
    let squeeze_1_s = if is_turning { 0.0 } else { f64::signum(row.ratio) };
    let wedge_1_s = if is_turning { row.ratio } else { 0.0 };
    let FilmForce { radial_n, tangential_n } =
        film.force(&FilmMotion { ratio: row.ratio.abs(), squeeze_1_s, wedge_1_s });
    [0.5 * radial_n.hypot(tangential_n), tangential_n.atan2(-radial_n).to_degrees()]
}

/// `value` with as many decimals as `printed` has.
fn as_printed(value: f64, printed: &str) -> String {
    let decimals = printed.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    format!("{value:.decimals$}")
}

/// One row for each ε, one column for each L/D: what is printed, and ours; bold where they differ by more than is allowed.
fn table(file: &'static str, is_turning: bool, column: usize, is_apart: impl Fn(&Row, f64) -> bool) -> String {
    let rows = rows(file);
    let widths: Vec<f64> = rows.iter().take_while(|row| row.ratio == rows[0].ratio).map(|row| row.width).collect();
    let heads: Vec<String> =
        widths.iter().map(|width| if *width == 1.0 { "1".into() } else { format!("1/{width}") }).collect();
    let mut lines = vec![format!("| ε | {} |", heads.join(" | ")), format!("|--:|{}", "--:|".repeat(heads.len()))];
    for rows in rows.chunk_by(|one, other| one.ratio == other.ratio) {
        let cells = widths.iter().map(|width| {
            let Some(row) = rows.iter().find(|row| row.width == *width) else { return String::new() };
            let found = of_film("reynolds", row, is_turning)[column];
            let ours = as_printed(found, row.texts[column]);
            let ours = if is_apart(row, found) { format!("**{ours}**") } else { ours };
            format!("{} / {ours}", row.texts[column])
        });
        lines.push(format!("| {} | {} |", rows[0].ratio, cells.collect::<Vec<_>>().join(" | ")));
    }
    lines.join("\n")
}

fn load_is_apart(row: &Row, found: f64) -> bool {
    let decimals = row.texts[0].split_once('.').map_or(0, |(_, decimals)| decimals.len());
    (found - row.numbers[0]).abs() > 5e-3 * row.numbers[0] + 0.5 * 10.0_f64.powi(-(decimals as i32))
}

/// What the condition at the rupture does.
fn laws() -> String {
    let mut lines = vec![
        "| ε | L/D | So: Butenschön | `reynolds` | `finite-length` | attitude: Butenschön | `reynolds` | `finite-length` |".to_owned(),
        "|--:|--:|--:|--:|--:|--:|--:|--:|".to_owned(),
    ];
    let shown =
        [(0.1, 1.0), (0.3, 1.0), (0.5, 1.0), (0.8, 1.0), (0.9, 1.0), (0.95, 1.0), (0.8, 2.0), (0.8, 4.0), (0.8, 8.0)];
    for row in rows(ROTATION).iter().filter(|row| shown.contains(&(row.ratio, row.width))) {
        let [ours, half] = ["reynolds", "finite-length"].map(|law| of_film(law, row, true));
        let share = |value: f64| {
            // No minus before 0.0.
            let percent = (1000.0 * (value / row.numbers[0] - 1.0)).round() / 10.0 + 0.0;
            format!("{} ({percent:+.1} %)", as_printed(value, row.texts[0]))
        };
        lines.push(format!(
            "| {} | {} | {} | {} | {} | {}° | {:.2}° | {:.2}° |",
            row.ratio,
            if row.width == 1.0 { "1".to_owned() } else { format!("1/{}", row.width) },
            row.texts[0],
            share(ours[0]),
            share(half[0]),
            row.texts[1],
            ours[1],
            half[1]
        ));
    }
    lines.join("\n")
}

/// The table of a marker of the page.
pub fn markdown(name: &str) -> String {
    match name {
        "laws" => laws(),
        "rotation" => table(ROTATION, true, 0, load_is_apart),
        "attitude" => table(ROTATION, true, 1, |row, found| (found - row.numbers[1]).abs() > 0.6),
        "squeeze" => table(SQUEEZE, false, 0, load_is_apart),
        _ => panic!("there is no table '{name}' of films"),
    }
}
