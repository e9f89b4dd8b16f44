//! Charts and still pictures: what is in them, how they are drawn, how they become figures of a page or files.
//! They take numbers and words, and know no results but those of surrogates, zones and paths.

pub(crate) mod axes;
pub(crate) mod chart;
pub(crate) mod drawing;
pub(crate) mod figure;
pub(crate) mod figure_of_chart;
pub(crate) mod path_figure;
pub(crate) mod plane_view;
pub(crate) mod still_figures;
pub(crate) mod surrogate_figure;
pub(crate) mod ticks;
pub(crate) mod zone_figure;
