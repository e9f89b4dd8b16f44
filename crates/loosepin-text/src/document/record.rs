//! One description of a table of a file: its keys, what they mean, what they may be and how they are read.

use super::entry::{Entry, Table};
use super::keys::Kind;
use super::reader::Reader;
use crate::units::Dimension;

/// Something that reads a file with a [`Reader`].
pub trait Reads {
    /// The reader of the file.
    fn document(&mut self) -> &mut Reader;
}

impl Reads for Reader {
    fn document(&mut self) -> &mut Reader {
        self
    }
}

/// A value that `R` reads at an entry.
pub trait Value<'t, R: ?Sized>: Sized {
    /// The value; `None` after a diagnostic.
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self>;

    /// What stands for a required key that is not written, which was reported.
    fn missing() -> Option<Self> {
        None
    }
}

/// `None` after a diagnostic: the other keys of the table are read and looked at nevertheless.
impl<'t, R: ?Sized, T: Value<'t, R>> Value<'t, R> for Option<T> {
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        Some(T::read(reader, entry))
    }

    fn missing() -> Option<Self> {
        Some(None)
    }
}

/// Default value of an omitted key, written as `D` in the description of its table.
pub trait DefaultValue<'t, R: ?Sized, D>: Value<'t, R> {
    /// The value that `usual` stands for.
    fn default_value(reader: &mut R, table: &Table<'t>, key: &'static str, usual: D) -> Option<Self>;
}

impl<'t, R: ?Sized, D, T: DefaultValue<'t, R, D>> DefaultValue<'t, R, D> for Option<T> {
    fn default_value(reader: &mut R, table: &Table<'t>, key: &'static str, usual: D) -> Option<Self> {
        T::default_value(reader, table, key, usual).map(Some)
    }
}

/// A value written as one of a few words, each with its meaning.
pub trait Choice: Copy + 'static {
    /// The words in the order of the documentation, where [`Self::choices`] says nothing else.
    const CHOICES: &'static [(&'static str, Self)] = &[];

    /// The words in the order of the documentation.
    fn choices() -> Vec<(&'static str, Self)> {
        Self::CHOICES.to_vec()
    }
}

/// The words of a choice.
pub fn words_of<T: Choice>() -> Vec<&'static str> {
    T::choices().iter().map(|(word, _)| *word).collect()
}

/// A key whose value is one of the words of `T`.
pub const fn choice<T: Choice>() -> Kind {
    Kind::ChoiceOf(words_of::<T>)
}

/// A whole number within limits.
pub const fn count(least: u64, most: u64) -> Kind {
    Kind::Count { least, most }
}

/// Any entry, to be read by code that knows more about it.
impl<'t, R: ?Sized> Value<'t, R> for Entry<'t> {
    fn read(_reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        Some(entry.clone())
    }
}

impl<'t, R: Reads + ?Sized, T: Choice> Value<'t, R> for T {
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        reader.document().choice(entry, &T::choices())
    }
}

impl<'t, R: Reads + ?Sized, T: Choice> DefaultValue<'t, R, &'static str> for T {
    fn default_value(_reader: &mut R, _table: &Table<'t>, key: &'static str, usual: &'static str) -> Option<Self> {
        let found = T::choices().into_iter().find(|(word, _)| *word == usual);
        debug_assert!(found.is_some(), "{key}: {usual} is none of its words");
        found.map(|(_, meaning)| meaning)
    }
}

impl<'t, R: Reads + ?Sized> Value<'t, R> for String {
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        reader.document().text(entry).map(str::to_owned)
    }
}

/// A bare number, or a value with the unit that its kind demands, SI.
impl<'t, R: Reads + ?Sized> Value<'t, R> for f64 {
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        match entry.due_quantity() {
            Some((dimension, rule)) => reader.document().measured(entry, dimension, rule),
            None => reader.document().number_of(entry),
        }
    }
}

impl<'t, R: Reads + ?Sized> DefaultValue<'t, R, f64> for f64 {
    fn default_value(_reader: &mut R, table: &Table<'t>, key: &'static str, usual: f64) -> Option<Self> {
        debug_assert!(table.due_quantity(key).is_none_or(|(dimension, _)| dimension == Dimension::NUMBER), "{key}");
        Some(usual)
    }
}

impl<'t, R: Reads + ?Sized> Value<'t, R> for u64 {
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        reader.document().count_of(entry)
    }
}

impl<'t, R: Reads + ?Sized> DefaultValue<'t, R, u64> for u64 {
    fn default_value(_reader: &mut R, _table: &Table<'t>, _key: &'static str, usual: u64) -> Option<Self> {
        Some(usual)
    }
}

impl<'t, R: Reads + ?Sized> Value<'t, R> for usize {
    fn read(reader: &mut R, entry: &Entry<'t>) -> Option<Self> {
        reader.document().count_of(entry).and_then(|count| usize::try_from(count).ok())
    }
}

impl<'t, R: Reads + ?Sized> DefaultValue<'t, R, usize> for usize {
    fn default_value(_reader: &mut R, _table: &Table<'t>, _key: &'static str, usual: usize) -> Option<Self> {
        Some(usual)
    }
}

/// Declares a table of a file: a struct with a field for each key, `KEYS` with their description, and `read`.
///
/// ```
/// use loosepin_text::document::{Kind, Reads, count};
/// use loosepin_text::record;
///
/// record! {
///     /// how many there are
///     struct Amounts for Reads, exactly one of [few, many];
///     /// a few of them
///     optional few: u64 = count(1, 9), "3";
///     /// a lot of them
///     optional many: u64 = count(10, 1000), "300";
///     /// how often each is taken
///     optional times: u64 = count(1, 10), "2", or 1;
///     /// what they are called
///     required name: String = Kind::Text, "\"screws\"";
/// }
/// assert_eq!(Amounts::KEYS.keys[2].doc, "how often each is taken; 1 if omitted");
/// ```
///
/// A key is `required` or `optional`; an optional one with `or` has the value that is written there where it is left out, and says so in
/// its documentation. Its type says how it is read ([`Value`]), what follows `=` what may stand there, with an example as it is written
/// in a file. `as KEY` takes a key that tables share, and `include` all keys of another table, which has its own struct. Where a value is
/// left out whose words are others, `called` says them: `or "0 s" called "none"`. `for` names the trait of what reads the table. Of a table
/// whose keys depend on its kind, `kind "rigid" of joint` gives the key `kind`, with the word for it as `WORD`.
///
/// Nothing is read of a table in which a value is refused or missing. Where the rest is to be looked at nevertheless, the type of the value
/// is an `Option`, `None` after a diagnostic.
///
/// Of a `lenient struct` what is wrong or missing counts as left out after the diagnostic about it, so that everything else in the table is
/// checked too: every field without `or` is an option, of required keys as well. It can be read where it is left out.
///
/// ```
/// use loosepin_text::diagnostics::Source;
/// use loosepin_text::document::{Kind, Reader, Reads, count};
/// use loosepin_text::record;
///
/// record! {
///     /// how often something is done
///     lenient struct Repeats for Reads;
///     /// how often
///     optional times: u64 = count(1, 10), "2", or 1;
///     /// what is done
///     required name: String = Kind::Text, "\"turn\"";
/// }
/// let repeats = Repeats::read_or_usual(&mut Reader::new(&Source::new("", "")), None);
/// assert_eq!((repeats.times, repeats.name), (1, None));
/// ```
#[macro_export]
macro_rules! record {
    ($(#[doc = $doc:literal])+ $visibility:vis lenient struct $($rest:tt)+) => {
        $crate::record! { @table lenient $(#[doc = $doc])+ $visibility struct $($rest)+ }
    };
    ($(#[doc = $doc:literal])+ $visibility:vis struct $($rest:tt)+) => {
        $crate::record! { @table strict $(#[doc = $doc])+ $visibility struct $($rest)+ }
    };
    (
        @table $mode:ident
        $(#[doc = $doc:literal])+
        $visibility:vis struct $name:ident for $reads:path
            $(, kind $word:literal of $what:ident)?
            $(, exactly one of [$($one:ident),+])* $(, planned $planned:expr)? $(, removed $removed:expr)?;
        $(
            $(#[doc = $key_doc:literal])*
            $(#[allow($allowed:ident)])?
            $need:ident $key:ident : $type:ty
                $(= $kind:expr, $example:literal $(, or $usual:literal $(called $called:literal)?)?)?
                $(as $shared:expr)?;
        )*
    ) => {
        $(#[doc = $doc])+
        $visibility struct $name<'t> {
            /// The table as it stands in the file.
            #[allow(dead_code)]
            $visibility table: $crate::document::Table<'t>,
            $(
                $(#[allow($allowed)])?
                $visibility $key: $crate::record!(@type $mode $need $type $(, $($usual)?)?),
            )*
        }

        impl<'t> $name<'t> {
            $(
                /// The word for its kind.
                $visibility const WORD: &'static str = $word;
            )?

            const LISTS: &'static [&'static [$crate::document::Key]] = &[
                $(&[$crate::document::required(
                    "kind",
                    $crate::document::Kind::Choice(&[$word]),
                    concat!("\"", $word, "\""),
                    concat!("the kind of ", stringify!($what)),
                )],)?
                $($crate::record!(
                    @key $need $type, stringify!($key), [$($key_doc),*]
                    $(, $kind, $example $(, $usual $(called $called)?)?)? $(; $shared)?
                )),*
            ];

            /// Its keys.
            #[allow(clippy::needless_update)]
            $visibility const KEYS: $crate::document::Keys = {
                const ALL: &[$crate::document::Key; $crate::document::count_of($name::LISTS)] =
                    &$crate::document::joined($name::LISTS);
                $crate::document::Keys {
                    exactly_one: &[$(&[$(stringify!($one)),+]),*],
                    $(planned: $planned,)?
                    $(removed: $removed,)?
                    ..$crate::document::Keys::new(concat!($($doc),+).trim_ascii_start(), ALL)
                }
            };

            /// Reads the table at an entry; `None` after a diagnostic about what it must have.
            #[allow(dead_code)]
            $visibility fn read<R: $reads + ?Sized>(
                reader: &mut R,
                entry: &$crate::document::Entry<'t>,
            ) -> Option<Self> {
                let table = $crate::document::Reads::document(reader).table(entry, &Self::KEYS)?;
                Self::of(reader, table)
            }

            /// Reads the values of a table that was opened with [`Self::KEYS`].
            #[allow(dead_code)]
            $visibility fn of<R: $reads + ?Sized>(
                reader: &mut R,
                table: $crate::document::Table<'t>,
            ) -> Option<Self> {
                $(let $key = $crate::record!(@read $mode $need $type, reader, table, stringify!($key) $(, $($usual)?)?);)*
                Some(Self { $($key: $key?,)* table })
            }

            $crate::record!(@read_or_usual $mode $visibility $reads);
        }

        impl<'t, R: $reads + ?Sized> $crate::document::Value<'t, R> for $name<'t> {
            fn read(reader: &mut R, entry: &$crate::document::Entry<'t>) -> Option<Self> {
                Self::read(reader, entry)
            }
        }
    };
    (@read_or_usual strict $visibility:vis $reads:path) => {};
    (@read_or_usual lenient $visibility:vis $reads:path) => {
        /// Reads the table at an entry; as if it were there without keys where it is left out or is no table.
        #[allow(dead_code)]
        $visibility fn read_or_usual<R: $reads + ?Sized>(
            reader: &mut R,
            entry: Option<&$crate::document::Entry<'t>>,
        ) -> Self {
            let table = entry.and_then(|entry| $crate::document::Reads::document(reader).table(entry, &Self::KEYS));
            let table = table
                .unwrap_or_else(|| $crate::document::Table::omitted(Default::default(), &Self::KEYS));
            Self::of(reader, table).expect("every key has a value, or may have none")
        }
    };
    (@type lenient $need:ident $type:ty $(,)?) => { Option<$type> };
    (@type $mode:ident optional $type:ty $(,)?) => { Option<$type> };
    (@type $mode:ident $need:ident $type:ty $(, $($usual:literal)?)?) => { $type };
    (@key include $type:ty, $name:expr, []) => { <$type>::KEYS.keys };
    (@key $need:ident $type:ty, $name:expr, []; $shared:expr) => { &[$shared] };
    (@key $need:ident $type:ty, $name:expr, [$($doc:literal),+], $kind:expr, $example:expr) => {
        &[$crate::document::$need($name, $kind, $example, concat!($($doc),+).trim_ascii_start())]
    };
    (@key $need:ident $type:ty, $name:expr, $doc:tt, $kind:expr, $example:expr, $usual:literal) => {
        $crate::record!(@key $need $type, $name, $doc, $kind, $example, $usual called $usual)
    };
    (
        @key $need:ident $type:ty, $name:expr, [$($doc:literal),+], $kind:expr, $example:expr,
        $usual:literal called $called:literal
    ) => {
        &[$crate::document::$need(
            $name,
            $kind,
            $example,
            concat!($($doc,)+ "; ", $called, " if omitted").trim_ascii_start(),
        )]
    };
    (@read $mode:ident include $type:ty, $reader:ident, $table:ident, $key:expr $(,)?) => {
        <$type>::of($reader, $table.clone())
    };
    (@read lenient $need:ident $type:ty, $reader:ident, $table:ident, $key:expr $(,)?) => {
        Some($table.get($key).and_then(|entry| <$type as $crate::document::Value<'t, R>>::read($reader, &entry)))
    };
    (@read lenient $need:ident $type:ty, $reader:ident, $table:ident, $key:expr, $usual:literal) => {
        match $table.get($key).and_then(|entry| <$type as $crate::document::Value<'t, R>>::read($reader, &entry)) {
            Some(value) => Some(value),
            None => <$type as $crate::document::DefaultValue<'t, R, _>>::default_value($reader, &$table, $key, $usual),
        }
    };
    (@read strict required $type:ty, $reader:ident, $table:ident, $key:expr $(,)?) => {
        match $table.get($key) {
            Some(entry) => <$type as $crate::document::Value<'t, R>>::read($reader, &entry),
            None => <$type as $crate::document::Value<'t, R>>::missing(),
        }
    };
    (@read strict optional $type:ty, $reader:ident, $table:ident, $key:expr $(,)?) => {
        match $table.get($key) {
            Some(entry) => <$type as $crate::document::Value<'t, R>>::read($reader, &entry).map(Some),
            None => Some(None),
        }
    };
    (@read strict optional $type:ty, $reader:ident, $table:ident, $key:expr, $usual:literal) => {
        match $table.get($key) {
            Some(entry) => <$type as $crate::document::Value<'t, R>>::read($reader, &entry),
            None => <$type as $crate::document::DefaultValue<'t, R, _>>::default_value($reader, &$table, $key, $usual),
        }
    };
}

/// Declares which word of a file stands for which value: of a type that is there already, or of a new one around a value.
#[macro_export]
macro_rules! choices {
    ($(#[$attribute:meta])* $visibility:vis struct $name:ident($inner:ty): $($word:literal => $value:expr),+ $(,)?) => {
        $(#[$attribute])*
        #[derive(Debug, Clone, Copy)]
        $visibility struct $name($visibility $inner);
        $crate::choices!($name: $($word => Self($value)),+);
    };
    ($name:ty: $($word:literal => $value:expr),+ $(,)?) => {
        impl $crate::document::Choice for $name {
            const CHOICES: &'static [(&'static str, Self)] = &[$(($word, $value)),+];
        }
    };
}
