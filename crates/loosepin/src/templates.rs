//! Commented files to start from, for `loosepin new`.

/// A model file and a study file to start from.
#[derive(Debug, Clone, Copy)]
pub struct Template {
    /// The name to ask for it by.
    pub name: &'static str,
    /// What mechanism it is, in one line.
    pub description: &'static str,
    /// Text of `model.toml`.
    pub model: &'static str,
    /// Text of `study.toml`.
    pub study: &'static str,
}

/// Every template, in the order in which they are listed.
pub static TEMPLATES: &[Template] = &[
    Template {
        name: "slider-crank",
        description: "crank, rod and slider at 5000 rpm with play in the gudgeon pin (Flores)",
        model: include_str!("../templates/slider-crank/model.toml"),
        study: include_str!("../templates/slider-crank/study.toml"),
    },
    Template {
        name: "four-bar",
        description: "crank, coupler and rocker at 600 rpm with play between coupler and rocker",
        model: include_str!("../templates/four-bar/model.toml"),
        study: include_str!("../templates/four-bar/study.toml"),
    },
];

/// The template called `name`.
pub fn find_template(name: &str) -> Option<&'static Template> {
    TEMPLATES.iter().find(|template| template.name == name)
}
