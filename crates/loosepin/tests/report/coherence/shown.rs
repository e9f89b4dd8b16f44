//! Numbers as people read them, out of the text of a page or a terminal.

use loosepin::report::{Tag, TaggedNumber, TaggedText};
use scraper::{ElementRef, Html, Node, Selector};

/// A number with its tag, and between what it lies to the digits that are shown, in the unit that is shown.
#[derive(Debug, Clone)]
pub struct Shown {
    pub tag: Tag,
    pub low: f64,
    pub high: f64,
    /// Where it stands, and how.
    pub source: &'static str,
    pub text: String,
}

impl Shown {
    pub fn exact(source: &'static str, tag: Tag, value: f64) -> Self {
        Self { tag, low: value, high: value, source, text: format!("{value:?}") }
    }

    pub fn words(&self) -> String {
        format!("'{}' ({})", self.text, self.source)
    }
}

/// What files say, in which digits are no numbers of ours: names, paths, hashes, descriptions of inputs, commands.
pub struct Names(Vec<String>);

impl Names {
    pub fn of(summary: &str) -> Self {
        let mut names = Vec::new();
        strings(&serde_json::from_str(summary).unwrap(), &mut names);
        let hashes: Vec<String> =
            names.iter().filter(|name| name.len() > 16).map(|name| name.chars().take(8).collect()).collect();
        let words = |path: &String| path.split_once('.').map(|(_, rest)| rest.replace(['.', '_'], " "));
        names.extend(names.iter().filter_map(words).collect::<Vec<String>>());
        names.extend(hashes);
        let is_version = |name: &str| name.matches('.').count() == 2;
        names.retain(|name| {
            name.contains(|c: char| c.is_ascii_digit()) && (name.contains(char::is_alphabetic) || is_version(name))
        });
        names.sort_by_key(|name| std::cmp::Reverse(name.len()));
        names.dedup();
        Self(names)
    }

    fn without(&self, text: &str) -> String {
        // A page keeps a number of theirs with its unit.
        self.0.iter().fold(text.replace('\u{a0}', " "), |text, name| text.replace(name, "…"))
    }
}

fn strings(value: &serde_json::Value, found: &mut Vec<String>) {
    match value {
        serde_json::Value::String(text) => found.extend(text.split('\n').map(str::to_owned)),
        serde_json::Value::Array(items) => items.iter().for_each(|item| strings(item, found)),
        serde_json::Value::Object(entries) => entries.iter().for_each(|(key, value)| {
            found.push(key.clone());
            strings(value, found);
        }),
        _ => {}
    }
}

/// Tagged numbers of a page, and what is wrong: numbers without a tag, and digits that no writer made. Pictures have ticks of their own; what
/// they draw is data, not text.
pub fn page_numbers(page: &TaggedText, names: &Names, left: &[&str]) -> (Vec<Shown>, Vec<String>) {
    let document = Html::parse_document(&page.text);
    let sections = Selector::parse("section[id], header, div.below").unwrap();
    let mut found = (Vec::new(), Vec::new());
    for section in document.select(&sections) {
        let id = section
            .value()
            .attr("id")
            .unwrap_or_else(|| if section.value().name() == "div" { "below" } else { "header" });
        if !left.contains(&id) {
            let mut texts = Vec::new();
            visible(section, &mut texts);
            let whole = texts.join(" ");
            read(("page", id), &whole, page, names, &mut found);
        }
    }
    found
}

fn visible(element: ElementRef<'_>, texts: &mut Vec<String>) {
    const NOT_READ: [&str; 4] = ["script", "style", "svg", "template"];
    for child in element.children() {
        match child.value() {
            Node::Text(text) => texts.push(text.to_string()),
            Node::Element(inner) => {
                // The date of writing, commands and files as they were given, and the data of a picture.
                let is_given =
                    inner.classes().any(|class| class == "date" || class == "numbers") || inner.name() == "pre";
                if let Some(inner) = ElementRef::wrap(child).filter(|_| !NOT_READ.contains(&inner.name()) && !is_given)
                {
                    visible(inner, texts);
                }
            }
            _ => {}
        }
    }
}

/// The same of a text for a terminal. `left`: first lines of parts that are not read.
pub fn terminal_numbers(terminal: &TaggedText, names: &Names, left: &[&str]) -> (Vec<Shown>, Vec<String>) {
    let mut found = (Vec::new(), Vec::new());
    let mut kept = String::new();
    let mut is_left = false;
    for (line, next) in terminal.text.lines().zip(terminal.text.lines().skip(1).chain([""])) {
        // A part begins with a line between two empty ones.
        if next.is_empty() && !line.is_empty() && kept.ends_with('\n') || left.contains(&line) {
            is_left = left.contains(&line);
        }
        // A command is one line of its own.
        if !is_left && !line.starts_with("  again: ") {
            kept.push_str(line);
        }
        kept.push('\n');
    }
    let words: Vec<&str> = kept.split_whitespace().collect();
    read(("terminal", ""), &words.join(" "), terminal, names, &mut found);
    found
}

fn read(
    (source, section): (&'static str, &str),
    text: &str,
    of: &TaggedText,
    names: &Names,
    (shown, faults): &mut (Vec<Shown>, Vec<String>),
) {
    let place = if section.is_empty() { source.to_owned() } else { format!("{source}, {section}") };
    let mut rest = text.chars();
    let mut plain = String::new();
    while let Some(character) = rest.next() {
        let Some(number) = of.begun_by(character) else {
            plain.push(character);
            continue;
        };
        let inside: String = rest.by_ref().take_while(|c| !TaggedText::is_end(*c)).collect();
        plain.push('#');
        match interval(number, &inside) {
            Err(words) => faults.push(format!("{place}: {words}")),
            Ok([low, high]) => match &number.tag {
                None | Some(Tag::Group(_)) => {
                    let before: String = plain.chars().rev().take(60).collect::<Vec<_>>().into_iter().rev().collect();
                    faults.push(format!("{place}: '{inside}' has no tag, behind '{before}'"));
                }
                // What is given is told where it stands; equal words need not be equal numbers.
                Some(Tag::Given(_)) => {}
                Some(tag) => shown.push(Shown { tag: tag.clone(), low, high, source, text: inside }),
            },
        }
    }
    let plain = names.without(&plain);
    let characters: Vec<char> = plain.chars().collect();
    for (at, _) in characters.iter().enumerate().filter(|(_, c)| c.is_ascii_digit()) {
        if at > 0 && characters[at - 1].is_ascii_digit() {
            continue;
        }
        let around: String = characters[at.saturating_sub(40)..(at + 40).min(characters.len())].iter().collect();
        faults.push(format!("{place}: digits that no writer of numbers made: '{around}'"));
    }
}

/// Between what a number lies, by the digits that are read; refused where these are not digits of its value.
fn interval(number: &TaggedNumber, text: &str) -> Result<[f64; 2], String> {
    // A member of a list stands as the file has it, and may be no number.
    if number.value.is_nan() {
        return if number.digits == text {
            Ok([f64::NEG_INFINITY, f64::INFINITY])
        } else {
            Err(format!("'{text}' is changed"))
        };
    }
    let Some((value, place)) = digits(text) else {
        // Infinite ends are words.
        return if number.value.is_finite() { Err(format!("'{text}' is no number")) } else { Ok([number.value; 2]) };
    };
    // Decimal fractions have no exact binary form.
    let slack = 1e-9 * value.abs().max(place);
    let around = |place: f64| match number.rounding {
        1 => [value - place - slack, value + slack],
        -1 => [value - slack, value + place + slack],
        _ => [value - 0.5 * place - slack, value + 0.5 * place + slack],
    };
    // Zeros at the end of a whole number may only hold places.
    let mut places = vec![place];
    while places.len() < 9 && value != 0.0 && (value / (10.0 * places[places.len() - 1])).fract() == 0.0 && place >= 1.0
    {
        places.push(10.0 * places[places.len() - 1]);
    }
    let found = places.into_iter().map(around).find(|[low, high]| (*low..=*high).contains(&number.value));
    found.ok_or_else(|| format!("'{text}' is not {}", number.value))
}

/// The number at the beginning of a text, and the size of its last digit.
fn digits(text: &str) -> Option<(f64, f64)> {
    const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    let plain: String = text.chars().filter(|c| *c != '\u{202f}').map(|c| if c == '−' { '-' } else { c }).collect();
    let end = plain.find(|c: char| !(c.is_ascii_digit() || matches!(c, '-' | '.'))).unwrap_or(plain.len());
    let mantissa: f64 = plain[..end].parse().ok()?;
    let decimals = plain[..end].split_once('.').map_or(0, |(_, behind)| behind.len());
    let rest = &plain[end..];
    let exponent = if let Some(power) = rest.strip_prefix('e') {
        let end = power.find(|c: char| !(c.is_ascii_digit() || c == '-')).unwrap_or(power.len());
        power[..end].parse().ok()?
    } else if let Some(power) = rest.strip_prefix("\u{a0}·\u{a0}10").or_else(|| rest.strip_prefix(" · 10")) {
        let digits: String = power
            .chars()
            .map_while(|c| match c {
                '⁻' => Some('-'),
                _ => SUPERSCRIPTS.chars().position(|s| s == c).and_then(|digit| char::from_digit(digit as u32, 10)),
            })
            .collect();
        digits.parse().ok()?
    } else {
        0
    };
    let power = 10f64.powi(exponent);
    Some((mantissa * power, 10f64.powi(-(decimals as i32)) * power))
}

#[test]
fn analytic_digits_are_read_with_the_size_of_the_last_one() {
    for (text, value, place) in [
        ("0.76\u{a0}mm", 0.76, 0.01),
        ("−12\u{202f}345.5\u{a0}N", -12_345.5, 0.1),
        ("1.2\u{a0}·\u{a0}10⁻⁹", 1.2e-9, 1e-10),
        ("1.8e-6", 1.8e-6, 1e-7),
        ("97.6\u{a0}%", 97.6, 0.1),
        ("60°", 60.0, 1.0),
        ("17536", 17_536.0, 1.0),
    ] {
        let (read, last) = digits(text).unwrap();
        assert!(
            (read - value).abs() <= 1e-12 * value.abs() && (last - place).abs() <= 1e-12 * place,
            "{text}: {read} {last}"
        );
    }
    assert_eq!(digits("not known"), None);
}
