//! Numbers are shown in the units that outputs state.

use loosepin::model::Model;
use loosepin::templates::find_template;
use loosepin::units::{DisplayUnits, SiUnit};

#[test]
fn numbers_are_shown_in_the_unit_that_an_output_states() {
    // The template has a force in kN.
    let text = find_template("slider-crank").expect("template").model;
    let own = "[output.far]\nposition_of = \"slider.pin\"\nalong = \"x\"\nunit = \"m\"\n";
    let model = Model::from_text("model.toml", &format!("{text}\n{own}")).unwrap_or_else(|said| panic!("{said}"));
    let units = model.shown_in(DisplayUnits::default());
    let shown = |unit: &SiUnit| units.0.get(unit.symbol()).map(|shown| (shown.symbol.as_str(), shown.per_si));
    assert_eq!(shown(&SiUnit::FORCE), Some(("kN", 1e-3)));
    assert_eq!(shown(&SiUnit::LENGTH), Some(("m", 1.0)));
    assert_eq!(shown(&SiUnit::ANGLE).map(|(symbol, _)| symbol), Some("°"));
}
