//! Style sheets that stand in pages and in pictures of their own.

/// Colours by meaning, light and dark.
pub(crate) const COLOURS: &str = include_str!("../../assets/colours.css");
/// Shapes of mechanisms.
pub(crate) const MECHANISM_STYLE: &str = include_str!("../../assets/mechanism.css");
/// Everything that is drawn in figures.
pub(crate) const FIGURE_STYLE: &str = concat!(
    include_str!("../../assets/figure.css"),
    include_str!("../../assets/mechanism.css"),
    include_str!("../../assets/space.css")
);

/// The style of figures and the colours that they name, for pages that put pictures of this library into theirs.
pub fn figure_styles() -> String {
    format!("{COLOURS}{FIGURE_STYLE}")
}

/// The style of figures with the light colours put in: programs that draw know no variables.
pub(crate) fn saved_style() -> String {
    let light = COLOURS.split_once("@media").map_or(COLOURS, |(light, _)| light);
    let colours =
        light.lines().filter_map(|line| line.trim().strip_prefix("--")?.trim_end_matches(';').split_once(": "));
    // The bracket ends the name: `--random` does not meet `--random-fill`.
    let mut style = FIGURE_STYLE.to_owned();
    for (name, colour) in colours {
        style = style.replace(&format!("var(--{name})"), colour);
    }
    let kept = style.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("/*"));
    kept.collect::<Vec<&str>>().join(" ")
}
