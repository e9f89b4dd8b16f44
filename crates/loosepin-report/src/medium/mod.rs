//! The two media: how an article becomes a page or the text of a terminal.
//! Nothing here knows what is said.

pub(crate) mod article_page;
pub(crate) mod article_text;
pub(crate) mod glue;
pub(crate) mod page;
pub(crate) mod script_data;
pub(crate) mod short_answer;
pub(crate) mod styles;
pub(crate) mod terminal_table;
