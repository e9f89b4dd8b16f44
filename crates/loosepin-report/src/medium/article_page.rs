//! An article on a page.

use crate::medium::glue::glued;
use crate::medium::page;
use crate::numbers::number::NumberWriter;
use loosepin_text::article::{Cell, Column, Content, Emphasis, Fact, Group, Medium, Section, Table, Text};
use maud::{Markup, PreEscaped, html};

/// A section of a page, where there is one.
pub(crate) fn page_section(section: impl Into<Option<Section>>) -> Option<page::Section> {
    let section = section.into()?;
    Some(page::Section::new(section.id, section.heading.words_on(Medium::Page), blocks(&section)))
}

/// Rows of a table of the first screen, at most.
const MAX_FIRST_ROWS: usize = 8;

/// A section that is one table for the first screen of a page, what there is to say on it below; and where it has more rows than that has room for,
/// the section itself.
pub(crate) fn overview(section: Option<Section>) -> (Markup, Option<page::Section>) {
    let Some(section) = section else { return Default::default() };
    let heading = section.heading.words_on(Medium::Page);
    let is_table = |content: &Content| matches!(content, Content::Table(_));
    let blocks = || section.blocks_on(Medium::Page).map(|block| &block.content);
    let (tables, others): (Vec<_>, Vec<_>) = blocks().partition(|content| is_table(content));
    let shown: Vec<Table> = tables
        .iter()
        .filter_map(|table| if let Content::Table(own) = table { Some(first_rows(own)) } else { None })
        .collect();
    let is_whole = shown.iter().zip(&tables).all(|(shown, table)| matches!(table, Content::Table(own) if own == shown));
    let id = if is_whole { section.id.to_owned() } else { format!("{}-overview", section.id) };
    let markup = html! {
        section.overview id=(id) aria-labelledby={ (id) "-title" } {
            h2 id={ (id) "-title" } { (heading) @if !is_whole { ": first rows" } }
            @for table in &shown { (whole_table(table)) }
            @if is_whole { @for other in others { (content(other)) } }
            @else { p { "All rows: " a href={ "#" (section.id) } { (heading) } "." } }
        }
    };
    let whole = if is_whole { None } else { page_section(section.clone()) };
    (markup, whole)
}

/// The same table with the rows that the first screen has room for.
fn first_rows(table: &Table) -> Table {
    let mut left = MAX_FIRST_ROWS;
    let mut groups = table.groups.clone();
    for group in &mut groups {
        group.rows.truncate(left);
        left -= group.rows.len();
    }
    groups.retain(|group| !group.rows.is_empty());
    Table { groups, ..table.clone() }
}

/// The blocks of a section.
pub(crate) fn blocks(section: &Section) -> Markup {
    html! { @for block in section.blocks_on(Medium::Page) { (content(&block.content)) } }
}

/// Adds figures, which only a page has.
pub(crate) fn push_figure(section: &mut Section, writer: &NumberWriter, draw: impl FnOnce() -> Markup) {
    if writer.medium == Medium::Page {
        section.push(Content::Figure(draw().into_string()));
    }
}

fn content(content: &Content) -> Markup {
    match content {
        Content::Heading(heading) => html! { h3 { (text(heading)) } },
        Content::Sentences(sentences) => html! { @for sentence in shown(sentences) { p { (text(sentence)) } } },
        Content::Note(note) => html! { p.quiet { (text(note)) } },
        Content::Points(points) => html! { ul { @for point in shown(points) { li { (text(point)) } } } },
        Content::Facts(facts) => list_of_facts(facts),
        Content::Table(table) => whole_table(table),
        Content::Figure(figure) => PreEscaped(figure.clone()),
    }
}

/// The sentences that a page shows.
fn shown(texts: &[Text]) -> impl Iterator<Item = &Text> {
    texts.iter().filter(|text| !text.is_empty_on(Medium::Page))
}

fn text(text: &Text) -> Markup {
    html! {
        @for span in text.spans_on(Medium::Page) {
            @match span.emphasis {
                Emphasis::Plain => { (glued(&span.text)) }
                Emphasis::Strong => strong { (glued(&span.text)) },
                Emphasis::Quiet => span.quiet { (glued(&span.text)) },
                Emphasis::Code => code { (span.text) },
            }
        }
    }
}

fn list_of_facts(facts: &[Fact]) -> Markup {
    let lines = |fact: &Fact| {
        html! { @for (index, line) in fact.lines.iter().enumerate() { @if index > 0 { br; } (text(line)) } }
    };
    html! { dl.facts { @for fact in facts { div { dt { (fact.name) } dd { (lines(fact)) } } } } }
}

/// A table with its title, and its caption if there is one.
fn whole_table(table: &Table) -> Markup {
    let title = html! { @if !table.title.is_empty_on(Medium::Page) { h3 { (text(&table.title)) } } };
    if table.caption.is_empty_on(Medium::Page) {
        return html! { (title) (rows(table)) };
    }
    html! { figure.treatments { (title) (rows(table)) figcaption { (text(&table.caption)) } } }
}

/// Columns that a page has room for; a table with more moves sideways in its frame.
const MAX_COLUMNS: usize = 8;

/// Columns of a table whose rows stay lines on a narrow screen, at most.
const MAX_COLUMNS_OF_LINES: usize = 3;

/// Rows become cards on a narrow screen, where each cell stands behind the head of its column, unless they have few numbers. Without groups the first cell of a row
/// is its head.
fn rows(table: &Table) -> Markup {
    let columns = table.columns_on(Medium::Page);
    let is_wide = columns.len() > MAX_COLUMNS;
    let rows = html! {
        table class=[(!is_wide).then_some(if is_of_lines(table, &columns) { "lines" } else { "cards" })] {
            thead {
                tr { @for (_, column) in &columns { th class=[class(column)] scope="col" { (text(&column.head)) } } }
            }
            @for group in &table.groups {
                tbody class=[is_headed(group).then_some("group")] {
                    @if is_headed(group) {
                        tr { th scope="rowgroup" colspan=(columns.len()) { (text(&group.heading)) } }
                    }
                    @for row in &group.rows {
                        tr {
                            @for (place, column) in &columns {
                                @if *place == 0 && !is_headed(group) { th class=[class(column)] scope="row" { (cell(&row[*place])) } }
                                @else { td class=[class(column)] data-label=(label(column)) { (cell(&row[*place])) } }
                            }
                        }
                    }
                }
            }
        }
    };
    if is_wide {
        html! { div.scroll tabindex="0" role="region" aria-label="Wide table" { (rows) } }
    } else {
        rows
    }
}

/// Whether each row has room in one line of a narrow screen: a number or two, and a name that a heading has made short.
fn is_of_lines(table: &Table, columns: &[(usize, &Column)]) -> bool {
    columns.len() <= MAX_COLUMNS_OF_LINES
        && columns.iter().skip(1).all(|(_, column)| class(column).is_some())
        && table.groups.iter().all(is_headed)
}

fn is_headed(group: &Group) -> bool {
    !group.heading.is_empty_on(Medium::Page)
}

fn class(column: &Column) -> Option<&'static str> {
    column.numbers_on.contains(&Medium::Page).then_some("number")
}

fn label(column: &Column) -> String {
    column.label.map_or_else(|| column.head.words_on(Medium::Page), str::to_owned)
}

fn cell(cell: &Cell) -> Markup {
    match cell {
        Cell::Text(own) => text(own),
        Cell::Drawn { html, .. } => PreEscaped(html.clone()),
        Cell::Nothing => html! { "–" },
    }
}

#[cfg(test)]
mod tests {
    use super::blocks;
    use loosepin_text::article::{Cell, Column, Content, Fact, Group, Medium, Section, Table, Text};

    fn shown(content: Content) -> String {
        let mut section = Section::new("bounds", "Bounds");
        section.push(content);
        blocks(&section).into_string()
    }

    #[test]
    fn text_of_files_is_escaped_and_emphasis_is_shown() {
        let text = Text::from("<rod> ").strong("0.25 mm").quiet("at 60°").code("bounds.csv");
        assert_eq!(
            shown(Content::Note(text.on(Medium::Terminal, "not on a page"))),
            "<p class=\"quiet\">&lt;rod&gt; <strong>0.25\u{a0}mm</strong><span class=\"quiet\">at 60°</span><code>bounds.csv</code></p>"
        );
        assert_eq!(
            shown(Content::Facts(vec![Fact::new("rod", ["0.5 kg", "settled"])])),
            "<dl class=\"facts\"><div><dt>rod</dt><dd>0.5\u{a0}kg<br>settled</dd></div></dl>"
        );
    }

    #[test]
    fn the_first_cell_of_a_row_is_its_head_unless_a_group_has_one() {
        let columns = || {
            vec![
                Column::words("play"),
                Column { only: Some(Medium::Terminal), ..Column::words("narrowed") },
                Column { label: Some("after"), ..Column::numbers("after the readings") },
            ]
        };
        let row = || vec![Cell::from("pin"), Cell::from("no"), Cell::Nothing];
        let plain = shown(Content::Table(Table::new(columns(), [row()])));
        assert!(
            plain.contains("<th scope=\"row\">pin</th><td class=\"number\" data-label=\"after\">–</td>"),
            "{plain}"
        );
        assert!(!plain.contains("narrowed") && !plain.contains("<figure"), "{plain}");
        let groups = vec![Group { heading: "rod".into(), rows: vec![row()] }];
        let table = Table { columns: columns(), groups, caption: "Both ends.".into(), ..Table::default() };
        let grouped = shown(Content::Table(table));
        assert!(grouped.contains("<th scope=\"rowgroup\" colspan=\"2\">rod</th>"), "{grouped}");
        assert!(grouped.contains("<td data-label=\"play\">pin</td>"), "{grouped}");
        assert!(grouped.ends_with("<figcaption>Both ends.</figcaption></figure>"), "{grouped}");
    }
}
