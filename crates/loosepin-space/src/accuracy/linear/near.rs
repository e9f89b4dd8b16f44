//! Of places that are equally good the nearest one.

/// What keeps v near v0.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Near<'a> {
    pub weight: f64,
    pub place: &'a [f64],
}
