//! Texts for people, as plain data: sections of sentences, lists, facts, tables and figures.
//!
//! Whoever knows the facts makes an [`Article`], or a [`Section`] of one; `loosepin-report` shows it on a page and on a terminal. So a
//! sentence or a table is made once, and the two cannot come to say different things.
//!
//! What only one of both has room for says so: a block, a column, or a part of a text ([`Block::only`], [`Column::only`],
//! [`Span::only`]). Numbers are digits already, written for the medium that the article is made for; marks that tell what a number is
//! (`tag.rs` of `loosepin-report`) stand in the text and pass through.

mod section;
mod table;
mod text;

pub use section::{Article, Block, Content, Fact, Section};
pub use table::{Cell, Column, Group, Table};
pub use text::{Emphasis, Medium, Span, Text};
