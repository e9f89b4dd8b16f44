//! An article on a terminal: plain text, aligned, readable without colour.

use crate::medium::terminal_table::{TERMINAL_COLUMNS, keep_words, table, trimmed, wrapped};
use loosepin_text::article::{Article, Cell, Content, Fact, Group, Medium, Section, Table, Text};

/// A title and sections as a terminal shows them.
pub(crate) fn terminal_text(title: &str, sections: impl IntoIterator<Item = Section>) -> String {
    let article = Article { title: title.to_owned(), sections: sections.into_iter().collect() };
    as_shown(&article_text(&article, Some(TERMINAL_COLUMNS)))
}

/// An article as text for a terminal: its title, then its sections. Sentences are wrapped to `columns`, or stay on one line where there
/// are none; tables are never wider than a terminal.
pub fn article_text(article: &Article, columns: Option<u16>) -> String {
    let mut text = format!("{}\n", article.title);
    for section in &article.sections {
        push_section(&mut text, section, columns);
    }
    text
}

fn push_section(text: &mut String, section: &Section, columns: Option<u16>) {
    if !section.heading.is_empty_on(Medium::Terminal) {
        text.push_str(&format!("\n{}\n", words(&section.heading)));
    }
    let width = name_width(section);
    for block in section.blocks_on(Medium::Terminal) {
        if !block.is_close {
            text.push('\n');
        }
        match &block.content {
            Content::Heading(heading) => text.push_str(&format!("{}\n", words(heading))),
            Content::Note(note) => text.push_str(&format!("{}\n", wrapped(&words(note), "", columns))),
            Content::Sentences(sentences) => push_lines(text, sentences, "", columns),
            Content::Points(points) => push_lines(text, points, "- ", columns),
            Content::Facts(facts) => push_facts(text, facts, width),
            Content::Table(table) => push_table(text, table),
            // A terminal shows none.
            Content::Figure(_) => {}
        }
    }
}

fn words(text: &Text) -> String {
    text.words_on(Medium::Terminal)
}

fn push_lines(text: &mut String, lines: &[Text], bullet: &str, columns: Option<u16>) {
    for line in lines.iter().filter(|line| !line.is_empty_on(Medium::Terminal)) {
        text.push_str(&format!("{}\n", wrapped(&words(line), bullet, columns)));
    }
}

/// Characters of the longest name among the facts of a section, which stand in one column.
fn name_width(section: &Section) -> usize {
    let names = section.blocks_on(Medium::Terminal).flat_map(|block| match &block.content {
        Content::Facts(facts) => facts.iter().map(|fact| fact.name.chars().count()).max(),
        Content::Heading(_)
        | Content::Sentences(_)
        | Content::Note(_)
        | Content::Points(_)
        | Content::Table(_)
        | Content::Figure(_) => None,
    });
    names.max().unwrap_or(0)
}

/// Names in a column, their first lines beside them, further lines below these.
fn push_facts(text: &mut String, facts: &[Fact], width: usize) {
    for Fact { name, lines } in facts {
        let (first, indent) = match name.is_empty() {
            true => ("  ".to_owned(), "  ".to_owned()),
            false => (format!("  {name:width$}  "), " ".repeat(width + 4)),
        };
        for (index, line) in lines.iter().enumerate() {
            let before = if index == 0 { &first } else { &indent };
            text.push_str(&format!("{before}{}\n", words(line)));
        }
    }
}

/// Appends a table for each group that has a heading, below it; groups without one continue the table before them.
fn push_table(text: &mut String, table: &Table) {
    let title = words(&table.title);
    if !title.is_empty() {
        text.push_str(&format!("{title}\n\n"));
    }
    let tables: Vec<String> = table
        .groups
        .chunk_by(|_, next| next.heading.is_empty_on(Medium::Terminal))
        .map(|one| group_text(table, one))
        .collect();
    text.push_str(&tables.join("\n"));
}

fn group_text(of: &Table, groups: &[Group]) -> String {
    let columns = of.columns_on(Medium::Terminal);
    let heads: Vec<String> = columns.iter().map(|(_, column)| words(&column.head)).collect();
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let numbers = columns.iter().enumerate().filter(|(_, (_, own))| own.numbers_on.contains(&Medium::Terminal));
    let mut aligned = table(&heads, &numbers.map(|(place, _)| place).collect::<Vec<usize>>());
    for row in groups.iter().flat_map(|group| &group.rows) {
        aligned.add_row(columns.iter().map(|(place, _)| cell_words(&row[*place])));
    }
    for (place, _) in columns.iter().enumerate().filter(|(_, (_, own))| own.keeps_words) {
        keep_words(&mut aligned, place);
    }
    let heading = groups.first().map_or_else(String::new, |group| words(&group.heading));
    let heading = if heading.is_empty() { heading } else { format!("{heading}\n\n") };
    format!("{heading}{}\n", trimmed(&aligned))
}

fn cell_words(cell: &Cell) -> String {
    match cell {
        Cell::Text(text) => words(text),
        Cell::Drawn { text, .. } => text.clone(),
        Cell::Nothing => "-".to_owned(),
    }
}

/// The text for a terminal: breakable spaces, and names of a file without characters that move the cursor or turn the line round.
fn as_shown(text: &str) -> String {
    let is_command =
        |c: char| c.is_control() && c != '\n' || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let shown = |c| match c {
        '\u{a0}' => ' ',
        c if is_command(c) => char::REPLACEMENT_CHARACTER,
        c => c,
    };
    text.chars().map(shown).collect()
}

#[cfg(test)]
mod tests {
    use super::article_text;
    use loosepin_text::article::{Article, Cell, Column, Content, Fact, Group, Medium, Section, Table, Text};

    fn shown(section: Section) -> String {
        article_text(&Article { title: "worn pin".to_owned(), sections: vec![section] }, Some(30))
    }

    #[test]
    fn what_belongs_together_stands_close_and_the_page_has_its_own() {
        let mut section = Section::of_facts(
            "bodies",
            "2 bodies",
            [Fact::new("rod", ["0.5 kg", "starts settled"]), Fact::nameless("gravity not given")],
        );
        section.push(Content::sentences(["A sentence that is longer than a line."]));
        section.push_close(Content::points([Text::from("a point").on(Medium::Page, ", with more on a page")]));
        section.push_on(Medium::Page, Content::sentences(["Nobody reads this on a terminal."]));
        section.push(Content::Figure("<svg></svg>".to_owned()));
        assert_eq!(
            shown(section),
            "worn pin\n\n2 bodies\n  rod  0.5 kg\n       starts settled\n  gravity not given\n\n\
             A sentence that is longer than\na line.\n- a point\n"
        );
    }

    #[test]
    fn each_group_of_rows_is_a_table_of_its_own() {
        let group = |heading: &str, row: [Cell; 3]| Group { heading: heading.into(), rows: vec![row.into()] };
        let table = Table {
            columns: vec![
                Column::words(Text::by_medium("Statistic", "statistic")),
                Column { only: Some(Medium::Page), ..Column::words("Guarantee") },
                Column::numbers("upper"),
            ],
            groups: vec![
                group("slider", ["mean".into(), "proven".into(), "0.25 mm".into()]),
                group("pin", ["mean".into(), "proven".into(), Cell::Nothing]),
            ],
            ..Table::default()
        };
        let mut section = Section::new("bounds", "Bounds");
        section.push(Content::Table(table));
        assert_eq!(
            shown(section),
            "worn pin\n\nBounds\n\nslider\n\nstatistic    upper\n-------------------\nmean       0.25 mm\n\n\
             pin\n\nstatistic  upper\n-----------------\nmean           -\n"
        );
    }
}
