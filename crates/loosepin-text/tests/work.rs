//! Reading a file costs what its text does, whatever is wrong with it: counted, since seconds are those of the machine.

use loosepin_text::diagnostics::Source;
use loosepin_text::document::{Key, Keys, Kind, optional, parse_toml};
use loosepin_text::numbers::NumberReader;
use loosepin_text::work;

const PARAMETERS: [Key; 1] = [optional("parameter", Kind::Values(&Kind::AnyQuantity), "", "named values")];
const FILE: Keys = Keys::new("a file", &PARAMETERS);
/// Parameters of the shortest file.
const FEWEST: usize = 100;
/// The same where a name is suggested in place of each wrong one: it is looked for among the first 500.
const FEWEST_SUGGESTED: usize = 600;
/// What the second doubling costs more, in parts of what the first one did: 2 where work grows as the text, 4 where it grows as its square.
const MAX_GROWTH: f64 = 2.5;

/// Bytes, names and entries that are looked at while a file with so many parameters is read, and its diagnostics are placed.
fn looks(parameter: Parameter, count: usize) -> u64 {
    let text: String = (0..count).map(|number| parameter(number) + "\n").collect();
    let source = Source::new("model.toml", format!("[parameter]\n{text}"));
    let before = work::count();
    let toml = parse_toml(&source).expect("it is TOML");
    let mut numbers = NumberReader::new(&source, |_, _| None);
    let root = numbers.reader.root(toml.get_ref(), &FILE);
    numbers.read_parameters(&root.get("parameter").expect("they are there"));
    for diagnostic in numbers.reader.diagnostics.sorted() {
        diagnostic.place.as_ref().expect("it has a place").line_and_column();
    }
    work::count() - before
}

/// The line of the parameter of a number.
type Parameter = fn(usize) -> String;

#[test]
fn parameters_cost_what_their_text_does() {
    let kinds: [(&str, usize, Parameter); 6] = [
        ("numbers", FEWEST, |number| format!("p{number} = \"{number} mm\"")),
        ("each follows the one before", FEWEST, |number| match number {
            0 => "p0 = \"1 mm\"".to_owned(),
            _ => format!("p{number} = \"1 mm + p{}\"", number - 1),
        }),
        // The last one follows a parameter that is not there, so that none has a value.
        ("each follows the next one", FEWEST, |number| format!("p{number} = \"1 mm + p{}\"", number + 1)),
        ("names that are not there", FEWEST_SUGGESTED, |number| format!("p{number} = \"none{number}\"")),
        ("units that are not there", FEWEST, |number| format!("p{number} = \"{number} mn\"")),
        ("names that cannot be used", FEWEST, |number| format!("\"p {number}\" = \"1 mm\"")),
    ];
    for (what, fewest, parameter) in kinds {
        let [few, more, many] = [1, 2, 4].map(|times| looks(parameter, times * fewest) as f64);
        assert!(few > fewest as f64, "{what}: nothing was counted");
        let growth = (many - more) / (more - few);
        assert!(growth < MAX_GROWTH, "{what}: {few}, {more}, {many} looks, growth {growth:.2}");
    }
}
