//! A group: a code and its value.

use std::borrow::Cow;

use super::error::{DxfError, DxfProblem, FilePosition};

/// A group: a code and a value.
#[derive(Debug)]
pub(super) struct Group<'a> {
    pub code: i32,
    pub value: Value<'a>,
    /// Position of the value.
    pub place: FilePosition,
}

/// The value of a group.
#[derive(Debug)]
pub(super) enum Value<'a> {
    /// A text, and in a file of text every value: numbers are read where they are asked for.
    Text(Cow<'a, str>),
    Real(f64),
    Integer(i64),
    /// Bytes that nothing here asks for.
    Bytes,
}

impl Group<'_> {
    /// The text; empty for a number of a binary file.
    pub fn text(&self) -> &str {
        match &self.value {
            Value::Text(text) => text,
            Value::Real(_) | Value::Integer(_) | Value::Bytes => "",
        }
    }

    /// The real number.
    pub fn real(&self) -> Result<f64, DxfError> {
        match &self.value {
            Value::Text(text) => text.parse().map_err(|_| self.not_a_number()),
            Value::Real(number) => Ok(*number),
            Value::Integer(_) | Value::Bytes => Err(self.not_a_number()),
        }
    }

    /// The whole number.
    pub fn integer(&self) -> Result<i64, DxfError> {
        match &self.value {
            Value::Text(text) => text.parse().map_err(|_| self.not_a_number()),
            Value::Integer(number) => Ok(*number),
            Value::Real(_) | Value::Bytes => Err(self.not_a_number()),
        }
    }

    fn not_a_number(&self) -> DxfError {
        self.place.error(DxfProblem::NotANumber { code: self.code, text: self.text().to_owned() })
    }
}

/// How the value of a group is written in a binary file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum ValueType {
    /// Ended by a zero.
    Text,
    Real,
    /// One byte.
    Flag,
    Integer16,
    Integer32,
    Integer64,
    /// A length of one byte, then as many bytes.
    Bytes,
}

impl ValueType {
    /// The type for a group code (DXF Reference, "Group Code Value Types"). That 1004 is a chunk of bytes stands in "Group Codes in
    /// Numerical Order".
    pub fn of(code: i32) -> Option<Self> {
        Some(match code {
            0..=9 | 100..=102 | 105 | 300..=309 | 320..=369 | 390..=399 | 410..=419 | 430..=439 | 470..=481 => {
                Self::Text
            }
            999..=1003 | 1005..=1009 => Self::Text,
            10..=59 | 110..=149 | 210..=239 | 460..=469 | 1010..=1059 => Self::Real,
            290..=299 => Self::Flag,
            60..=79 | 170..=179 | 270..=289 | 370..=389 | 400..=409 | 1060..=1070 => Self::Integer16,
            90..=99 | 420..=429 | 440..=459 | 1071 => Self::Integer32,
            160..=169 => Self::Integer64,
            310..=319 | 1004 => Self::Bytes,
            _ => return None,
        })
    }
}
