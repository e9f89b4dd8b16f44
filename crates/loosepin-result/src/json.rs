//! JSON that repeats byte for byte and reads well: objects indented, lists of numbers on one line.

use std::io;

use serde::Serialize;
use serde_json::ser::{Formatter, Serializer};

use crate::identification::Identification;
use crate::motion::MotionRecord;
use crate::simulation::SimulationRecord;
use crate::study::StudyResult;
use crate::sweep::SweepRecord;

/// A record with a file of its own. Its JSON is written and read here: the code of a format is long, and each crate that asked serde for
/// it would compile a copy.
pub trait Stored: Sized {
    /// The text of its file.
    ///
    /// # Errors
    /// A value without a form in JSON.
    fn to_json(&self) -> Result<String, serde_json::Error>;

    /// A record from the text of its file.
    ///
    /// # Errors
    /// A text that does not fit, with line and column.
    fn from_json(text: &str) -> Result<Self, serde_json::Error>;
}

macro_rules! stored {
    ($($record:ty),*) => {$(
        impl Stored for $record {
            fn to_json(&self) -> Result<String, serde_json::Error> {
                to_json(self)
            }

            fn from_json(text: &str) -> Result<Self, serde_json::Error> {
                serde_json::from_str(text)
            }
        }
    )*};
}

stored!(Identification, MotionRecord, SimulationRecord, StudyResult, SweepRecord);

/// Any record as JSON: keys in the order of the type, floats in the shortest form that reads back to the same bits,
/// lists of plain values on one line, a newline at the end. For records of a file of their own: [`Stored`].
///
/// # Errors
/// A value without a form in JSON.
pub fn to_json<T: Serialize>(record: &T) -> Result<String, serde_json::Error> {
    let mut bytes = Vec::new();
    let mut serializer = Serializer::with_formatter(&mut bytes, ReadableLayout::default());
    record.serialize(&mut serializer)?;
    bytes.push(b'\n');
    // The serializer writes only UTF-8, so nothing is ever replaced here.
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Puts objects on lines of their own and keeps lists of numbers and words together.
#[derive(Default)]
struct ReadableLayout {
    depth: usize,
    /// For each open list or object: whether it holds something that began a line of its own.
    has_lines: Vec<bool>,
    /// A list item is about to begin; if it turns out to be a list or an object, it begins a line.
    pending_item: bool,
}

impl ReadableLayout {
    fn new_line<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        if let Some(has_lines) = self.has_lines.last_mut() {
            *has_lines = true;
        }
        writer.write_all(b"\n")?;
        for _ in 0..self.depth {
            writer.write_all(b"  ")?;
        }
        Ok(())
    }

    fn open<W: ?Sized + io::Write>(&mut self, writer: &mut W, bracket: &[u8]) -> io::Result<()> {
        if std::mem::take(&mut self.pending_item) {
            self.new_line(writer)?;
        }
        self.depth += 1;
        self.has_lines.push(false);
        writer.write_all(bracket)
    }

    fn close<W: ?Sized + io::Write>(&mut self, writer: &mut W, bracket: &[u8]) -> io::Result<()> {
        self.pending_item = false;
        self.depth = self.depth.saturating_sub(1);
        if self.has_lines.pop() == Some(true) {
            // The line belongs to the list that closes, not to the one around it.
            writer.write_all(b"\n")?;
            for _ in 0..self.depth {
                writer.write_all(b"  ")?;
            }
        }
        writer.write_all(bracket)
    }
}

impl Formatter for ReadableLayout {
    fn begin_array<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.open(writer, b"[")
    }

    fn end_array<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.close(writer, b"]")
    }

    fn begin_array_value<W: ?Sized + io::Write>(&mut self, writer: &mut W, is_first: bool) -> io::Result<()> {
        self.pending_item = true;
        if is_first { Ok(()) } else { writer.write_all(b",") }
    }

    fn end_array_value<W: ?Sized + io::Write>(&mut self, _writer: &mut W) -> io::Result<()> {
        self.pending_item = false;
        Ok(())
    }

    fn begin_object<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.open(writer, b"{")
    }

    fn end_object<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.close(writer, b"}")
    }

    fn begin_object_key<W: ?Sized + io::Write>(&mut self, writer: &mut W, is_first: bool) -> io::Result<()> {
        if !is_first {
            writer.write_all(b",")?;
        }
        self.new_line(writer)
    }

    fn begin_object_value<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        writer.write_all(b": ")
    }
}
