//! The words of a value's text.

use std::ops::Range;

use super::{ExpressionError, ExpressionProblem, LONGEST_EXPRESSION_CHARS};
use crate::work;

/// A word of the text, with its byte range.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Token {
    pub kind: TokenKind,
    pub span: Range<usize>,
}

/// The kinds of word.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum TokenKind {
    /// A number without sign.
    Number(f64),
    /// A name or the symbol of a unit.
    Word(String),
    /// `²` or `³` behind a unit.
    Superscript(f64),
    /// One of `+ - * / ^ ( ) ,`; the middle dot and the cross count as `*`, the true minus as `-`.
    Sign(char),
    /// The end of the text.
    End,
}

/// Whether a name may begin with this character.
pub(super) fn begins_word(character: char) -> bool {
    character.is_alphabetic() || matches!(character, '_' | '°' | '%')
}

fn continues_word(character: char) -> bool {
    (character.is_alphanumeric() || character == '_') && superscript(character).is_none()
}

fn superscript(character: char) -> Option<f64> {
    match character {
        '²' => Some(2.0),
        '³' => Some(3.0),
        _ => None,
    }
}

/// Splits the text into words; the last token is [`TokenKind::End`].
///
/// # Errors
/// Text that is too long, characters that belong in no value, numbers that cannot be read, signs of a tolerance.
pub(super) fn tokens(text: &str) -> Result<Vec<Token>, ExpressionError> {
    let length_chars = text.chars().count();
    work::add(length_chars);
    if length_chars > LONGEST_EXPRESSION_CHARS {
        return Err(ExpressionError { problem: ExpressionProblem::TooLong { length_chars }, span: 0..text.len() });
    }
    let mut list = Vec::new();
    let mut rest = text.char_indices().peekable();
    while let Some((start, character)) = rest.next() {
        let mut end = start + character.len_utf8();
        if let Some(written) = sign_of_tolerance(&text[start..]) {
            let problem = ExpressionProblem::Tolerance { written: written.to_owned(), instead: None };
            return Err(ExpressionError { problem, span: start..start + written.len() });
        }
        let kind = if character.is_whitespace() {
            continue;
        } else if character.is_ascii_digit() || character == '.' {
            end = number_end(text, start);
            while rest.peek().is_some_and(|(index, _)| *index < end) {
                rest.next();
            }
            TokenKind::Number(number(text, start..end)?)
        } else if let Some(exponent) = superscript(character) {
            TokenKind::Superscript(exponent)
        } else if begins_word(character) {
            while let Some((index, next)) = rest.next_if(|(_, next)| continues_word(*next)) {
                end = index + next.len_utf8();
            }
            TokenKind::Word(text[start..end].to_owned())
        } else {
            match character {
                '+' | '-' | '*' | '/' | '^' | '(' | ')' | ',' => TokenKind::Sign(character),
                '·' | '×' | '⋅' => TokenKind::Sign('*'),
                '−' => TokenKind::Sign('-'),
                _ => {
                    let problem = ExpressionProblem::UnexpectedCharacter { character };
                    return Err(ExpressionError { problem, span: start..end });
                }
            }
        };
        list.push(Token { kind, span: start..end });
    }
    list.push(Token { kind: TokenKind::End, span: text.len()..text.len() });
    Ok(list)
}

/// The sign of a tolerance at the start of a text. `+-` is one where both are written together: `a + -b` is a difference.
fn sign_of_tolerance(text: &str) -> Option<&str> {
    ["±", "+-", "+−", "+/-", "+/−"].into_iter().find(|sign| text.starts_with(sign))
}

/// End of the number that begins at `start`: digits, point, and an exponent where digits follow the `e`.
fn number_end(text: &str, start: usize) -> usize {
    let bytes = text.as_bytes();
    let digits = |mut index: usize| {
        while bytes.get(index).is_some_and(|byte| byte.is_ascii_digit() || *byte == b'.' || *byte == b'_') {
            index += 1;
        }
        index
    };
    let end = digits(start);
    if !matches!(bytes.get(end), Some(b'e' | b'E')) {
        return end;
    }
    let sign = usize::from(matches!(bytes.get(end + 1), Some(b'+' | b'-')));
    if bytes.get(end + 1 + sign).is_some_and(u8::is_ascii_digit) { digits(end + 1 + sign) } else { end }
}

fn number(text: &str, span: Range<usize>) -> Result<f64, ExpressionError> {
    let written = &text[span.clone()];
    match written.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        Ok(_) => Err(ExpressionError { problem: ExpressionProblem::NumberTooLarge { text: written.to_owned() }, span }),
        Err(_) => Err(ExpressionError { problem: ExpressionProblem::BadNumber { text: written.to_owned() }, span }),
    }
}
