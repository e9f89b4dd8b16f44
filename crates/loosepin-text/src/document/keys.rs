//! Tables of keys: the one description of a file format.

use crate::units::{Dimension, Rule};

/// Kind of value of a key.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// Text that is not empty.
    Text,
    /// Text with a unit, or an expression over parameters; a bare number where the dimension is that of a number.
    Quantity {
        /// Its dimension.
        dimension: Dimension,
        /// The range it must lie in.
        rule: Rule,
    },
    /// As [`Kind::Quantity`], of whatever dimension its text has.
    AnyQuantity,
    /// A contact stiffness, whose dimension follows from the exponent beside it.
    Stiffness,
    /// Two lengths, x and y.
    Vector,
    /// Three values of one kind, along x, y and z.
    Three(&'static Kind),
    /// A bare number.
    Number {
        /// The range it must lie in.
        rule: Rule,
    },
    /// A whole number.
    Count {
        /// The least.
        least: u64,
        /// The most.
        most: u64,
    },
    /// One of a few words.
    Choice(&'static [&'static str]),
    /// One of the words that the function gives.
    ChoiceOf(fn() -> Vec<&'static str>),
    /// A point, written `body.point`.
    Point,
    /// The name of something in the file, for example a joint.
    Reference(&'static str),
    /// A unit in which the value is shown.
    Unit,
    /// A table with fixed keys.
    Table(&'static Keys),
    /// Tables under names of the person's choosing; some names may have keys of their own.
    Tables {
        /// Keys of the tables.
        keys: &'static Keys,
        /// Names with other keys.
        except: &'static [(&'static str, &'static Keys)],
    },
    /// Tables under names of the person's choosing whose keys depend on the choice behind `tag`.
    TaggedTables {
        /// The key that chooses.
        tag: &'static str,
        /// The choices with their keys.
        variants: &'static [(&'static str, &'static Keys)],
    },
    /// A table whose keys depend on the choice behind `tag`.
    Tagged {
        /// The key that chooses.
        tag: &'static str,
        /// The choices with their keys.
        variants: &'static [(&'static str, &'static Keys)],
    },
    /// Values under names of the person's choosing.
    Values(&'static Kind),
    /// A list.
    List(&'static Kind),
    /// One of several kinds.
    AnyOf(&'static [Kind]),
}

/// One key of a table.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    /// The key.
    pub name: &'static str,
    /// Kind of its value.
    pub kind: Kind,
    /// Whether it must be there.
    pub is_required: bool,
    /// An example, as written in the file; empty for tables.
    pub example: &'static str,
    /// Meaning, for hints and editors.
    pub doc: &'static str,
}

/// The keys of a table.
#[derive(Debug, Clone, Copy)]
pub struct Keys {
    /// Meaning of the table, for editors.
    pub doc: &'static str,
    /// Its keys.
    pub keys: &'static [Key],
    /// Groups of keys of which exactly one must be there.
    pub exactly_one: &'static [&'static [&'static str]],
    /// Keys that are planned, with what they will do; refused for now.
    pub planned: &'static [(&'static str, &'static str)],
    /// Keys that earlier versions knew, with what to do instead.
    pub removed: &'static [(&'static str, &'static str)],
}

impl Keys {
    /// Keys without alternatives.
    pub const fn new(doc: &'static str, keys: &'static [Key]) -> Keys {
        Keys { doc, keys, exactly_one: &[], planned: &[], removed: &[] }
    }

    /// These keys, of which exactly one of each group must be there.
    pub const fn with_exactly_one(self, exactly_one: &'static [&'static [&'static str]]) -> Keys {
        Keys { exactly_one, ..self }
    }

    /// The key called `name`.
    pub fn find(&self, name: &str) -> Option<&'static Key> {
        self.keys.iter().find(|key| key.name == name)
    }
}

/// A key that must be there.
pub const fn required(name: &'static str, kind: Kind, example: &'static str, doc: &'static str) -> Key {
    Key { name, kind, is_required: true, example, doc }
}

/// A key that may be left out.
pub const fn optional(name: &'static str, kind: Kind, example: &'static str, doc: &'static str) -> Key {
    Key { name, kind, is_required: false, example, doc }
}

/// How many there are in all of `lists`.
pub const fn count_of<T>(lists: &[&[T]]) -> usize {
    let (mut count, mut list) = (0, 0);
    while list < lists.len() {
        count += lists[list].len();
        list += 1;
    }
    count
}

/// `lists` one after the other, put together by the compiler: tables of keys are static. `COUNT` is [`count_of`] them, above zero.
pub const fn joined<T: Copy, const COUNT: usize>(lists: &[&[T]]) -> [T; COUNT] {
    let mut first = 0;
    while lists[first].is_empty() {
        first += 1;
    }
    let mut all = [lists[first][0]; COUNT];
    let (mut count, mut list) = (0, 0);
    while list < lists.len() {
        let mut own = 0;
        while own < lists[list].len() {
            all[count] = lists[list][own];
            count += 1;
            own += 1;
        }
        list += 1;
    }
    all
}

/// A value with a unit.
pub const fn quantity(dimension: Dimension, rule: Rule) -> Kind {
    Kind::Quantity { dimension, rule }
}
