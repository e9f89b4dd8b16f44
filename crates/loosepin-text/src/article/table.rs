//! A table of an article.

use super::text::{Medium, Text};

/// Rows below the heads of their columns.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Table {
    /// The columns; each row has a cell for each of them.
    pub columns: Vec<Column>,
    /// The rows, in groups with a heading of their own; a terminal makes a table of each group that has one.
    pub groups: Vec<Group>,
    /// Subject of its rows; empty if the section states it.
    pub title: Text,
    /// Caption below it on the page; empty if there is none.
    pub caption: Text,
}

/// A column of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// Its head.
    pub head: Text,
    /// The head in a word, before each cell on a narrow screen; `None` if it is the head.
    pub label: Option<&'static str>,
    /// The media where its cells stand to the right.
    pub numbers_on: &'static [Medium],
    /// Whether a terminal wraps other columns before it cuts a word of this one.
    pub keeps_words: bool,
    /// The only medium that shows it; `None` if both do.
    pub only: Option<Medium>,
}

/// Rows that belong together.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Group {
    /// Subject of the group; empty if there is one group.
    pub heading: Text,
    /// The rows.
    pub rows: Vec<Vec<Cell>>,
}

/// A cell of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Cell {
    /// A text.
    Text(Text),
    /// A drawing of numbers as HTML, which shows them in text too; a terminal has the text alone.
    Drawn {
        /// The HTML.
        html: String,
        /// The numbers in text.
        text: String,
    },
    /// There is nothing to say: a dash.
    Nothing,
}

impl Column {
    /// A column of words.
    pub fn words(head: impl Into<Text>) -> Column {
        Column { head: head.into(), label: None, numbers_on: &[], keeps_words: false, only: None }
    }

    /// A column of numbers, aligned to the right.
    pub fn numbers(head: impl Into<Text>) -> Column {
        Column { numbers_on: &[Medium::Page, Medium::Terminal], ..Column::words(head) }
    }

    /// A column of numbers, aligned to the right only on a terminal.
    pub fn numbers_on_terminal(head: impl Into<Text>) -> Column {
        Column { numbers_on: &[Medium::Terminal], ..Column::words(head) }
    }
}

impl Table {
    /// A table without groups.
    pub fn new<C: Into<Cell>>(columns: Vec<Column>, rows: impl IntoIterator<Item = Vec<C>>) -> Table {
        let rows = rows.into_iter().map(|row| row.into_iter().map(Into::into).collect()).collect();
        let group = Group { heading: Text::default(), rows };
        Table { columns, groups: vec![group], ..Table::default() }
    }

    /// The places of the columns that a medium shows, with the columns.
    pub fn columns_on(&self, medium: Medium) -> Vec<(usize, &Column)> {
        let columns = self.columns.iter().enumerate();
        columns.filter(|(_, column)| column.only.is_none_or(|only| only == medium)).collect()
    }
}

impl From<Text> for Cell {
    fn from(text: Text) -> Cell {
        Cell::Text(text)
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Cell {
        Cell::Text(text.into())
    }
}

impl From<&str> for Cell {
    fn from(text: &str) -> Cell {
        Cell::Text(text.into())
    }
}

impl<C: Into<Cell>> From<Option<C>> for Cell {
    /// A dash for what is not there.
    fn from(cell: Option<C>) -> Cell {
        cell.map_or(Cell::Nothing, Into::into)
    }
}
