//! Tables of problems: the fields, code, text and hint of each problem in one place.

/// An enum of problems with its `Display` and its [`Problem`](crate::diagnostics::Problem), from a table:
///
/// ```
/// use loosepin_text::diagnostics::{Code, Problem, problems};
///
/// problems! {
///     /// What can be wrong with a list.
///     #[derive(Debug)]
///     pub enum ListProblem {
///         /// A list without entries.
///         Empty { entry: String } => Code::AskNotPossible,
///             says("{entry} is empty; give at least one");
///         /// The same entry again.
///         Twice { entry: String, value: f64 } => Code::BadList,
///             says("{entry} holds {value} twice"),
///             hint("keep one of the two");
///     }
/// }
///
/// let problem = ListProblem::Twice { entry: "any_of".to_owned(), value: 0.3 };
/// assert_eq!(problem.to_string(), "any_of holds 0.3 twice");
/// assert_eq!(problem.hint().as_deref(), Some("keep one of the two"));
/// ```
///
/// `pub enum Name | Variant(Other) {` adds a variant for each problem of another such type, which keeps its text, code and hint.
/// `says` and `hint` take what `format!` takes, with the fields by their names; `hint_of` takes an `Option<String>`.
/// A field has a doc comment where its name does not say what it is.
#[macro_export]
macro_rules! problems {
    (
        $(#[$about:meta])*
        pub enum $name:ident $(| $passed:ident($inner:ty))* {
            $(
                $(#[$doc:meta])*
                $variant:ident $({ $($(#[$note:meta])* $field:ident: $type:ty),+ $(,)? })? => $code:expr,
                    says($($said:tt)+) $(, $hint:ident($($hinted:tt)+))?;
            )+
        }
    ) => {
        $(#[$about])*
        #[allow(missing_docs, reason = "the text of a problem says what each field is")]
        pub enum $name {
            $(#[doc = concat!("As [`", stringify!($inner), "`] has it.")] $passed($inner),)*
            $($(#[$doc])* $variant $({ $($(#[$note])* $field: $type),+ })?,)+
        }

        #[allow(unused_variables, reason = "no text needs all fields")]
        const _: () = {
            impl std::fmt::Display for $name {
                fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                    match self {
                        $(Self::$passed(problem) => std::fmt::Display::fmt(problem, formatter),)*
                        $(Self::$variant $({ $($field),+ })? => write!(formatter, $($said)+),)+
                    }
                }
            }

            impl std::error::Error for $name {}

            $(impl From<$inner> for $name {
                fn from(problem: $inner) -> Self {
                    Self::$passed(problem)
                }
            })*

            impl $crate::diagnostics::Problem for $name {
                fn code(&self) -> $crate::diagnostics::Code {
                    match self {
                        $(Self::$passed(problem) => problem.code(),)*
                        $(Self::$variant $({ $($field),+ })? => $code,)+
                    }
                }

                fn hint(&self) -> Option<String> {
                    match self {
                        $(Self::$passed(problem) => problem.hint(),)*
                        $(Self::$variant $({ $($field),+ })? => $crate::problems!(@ $($hint($($hinted)+))?),)+
                    }
                }
            }
        };
    };
    (@) => { None };
    (@ hint($($hinted:tt)+)) => { Some(format!($($hinted)+)) };
    (@ hint_of($hinted:expr)) => { $hinted };
}

pub use problems;
