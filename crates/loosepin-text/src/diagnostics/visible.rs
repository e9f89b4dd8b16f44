//! Text of others made safe to show.

use std::borrow::Cow;

/// `text` with every character that would change a terminal, or the reading order, as its number: `\u{1b}`. Ends of lines and tabs stay.
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.chars().any(is_hidden) {
        return Cow::Borrowed(text);
    }
    let shown = |character: char| {
        if is_hidden(character) { character.escape_unicode().to_string() } else { character.to_string() }
    };
    Cow::Owned(text.chars().map(shown).collect())
}

/// The first character of `text` that no name may have: one that is not shown as itself, ends of lines and tabs included.
pub fn first_control_character(text: &str) -> Option<char> {
    text.chars().find(|character| character.is_control() || is_hidden(*character))
}

fn is_hidden(character: char) -> bool {
    // Marks that turn the order of what stands behind them.
    let turns_order = matches!(character, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    turns_order || character.is_control() && !matches!(character, '\n' | '\t')
}

#[cfg(test)]
mod tests {
    use super::{first_control_character, visible};

    #[test]
    fn what_would_change_a_terminal_is_shown_as_its_number() {
        assert_eq!(visible("a\u{1b}[31mb\r\n\tµ\u{202e}\u{9b}"), "a\\u{1b}[31mb\\u{d}\n\tµ\\u{202e}\\u{9b}");
        assert!(matches!(visible("plain\ttext\n"), std::borrow::Cow::Borrowed(_)));
        assert_eq!(["worn pin ß", "a\tb", "a\u{7}"].map(first_control_character), [None, Some('\t'), Some('\u{7}')]);
    }
}
