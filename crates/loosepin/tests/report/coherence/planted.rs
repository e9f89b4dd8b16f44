//! Contradictions that are planted: one writer has another record than the others.

use super::{Reader, Texts, Writer, faults};
use crate::report_fixture::study::worn_pin;
use loosepin::result::json::Stored;
use loosepin::study::result::{StudyResult, WitnessValue};

type Change = fn(&mut StudyResult);

/// Each by a hundredth or more of the number, as a slip of a writer or a stale record would.
const PLANTED: [(&str, Writer, Change); 24] = [
    ("upper bound of the main quantile", Writer::Page, |r| r.bounds[0].upper.widened_si *= 1.03),
    ("upper bound of the main quantile", Writer::Terminal, |r| r.bounds[0].upper.widened_si *= 1.03),
    ("upper bound of the main quantile", Writer::Table, |r| r.bounds[0].upper.widened_si *= 1.03),
    ("lower bound of a mean", Writer::Summary, |r| r.bounds[1].lower.widened_si *= 0.9),
    ("error of a bound", Writer::Page, |r| r.bounds[1].upper.error.sampling_si *= 4.0),
    ("error of a bound", Writer::Terminal, |r| r.bounds[0].upper.error.optimisation_si *= 5.0),
    ("error of a bound", Writer::Table, |r| r.bounds[0].upper.error.optimisation_si *= 5.0),
    ("witness of a bound", Writer::Page, |r| witness(r, 0.45e-3)),
    ("witness of a bound", Writer::Terminal, |r| witness(r, 0.45e-3)),
    ("witness of a bound", Writer::Table, |r| witness(r, 0.45e-3)),
    ("share of a requirement", Writer::Terminal, |r| r.requirements[0].probability[0] -= 0.01),
    ("share of a requirement", Writer::Page, |r| r.requirements[0].probability[0] -= 0.01),
    ("runs", Writer::Terminal, |r| r.counts.runs += 1),
    ("failed runs", Writer::Page, |r| r.counts.failed += 1),
    ("end of a treatment", Writer::Page, |r| r.treatments[0].bands[1].upper_si *= 1.05),
    ("end of a treatment", Writer::Summary, |r| r.treatments[0].bands[2].lower_si *= 0.9),
    ("share inside a band", Writer::Terminal, |r| r.treatments[0].bands[0].coverage_minimum -= 0.02),
    ("one point of the band over the cycle", Writer::Summary, |r| r.curves[0].mixed.upper_si[40] *= 3.0),
    ("band of scatter alone", Writer::Terminal, |r| scale(&mut r.curves[0].random.upper_si, 1.2)),
    ("error of the band over the cycle", Writer::Page, |r| r.curves[0].numerical_error_si *= 3.0),
    ("energy residual", Writer::Page, |r| r.energy.as_mut().unwrap().maximum *= 70.0),
    ("largest normal force", Writer::Summary, |r| r.impacts[0].peak_force_n *= 1.01),
    ("share of impacts that are too fast", Writer::Terminal, |r| r.impacts[0].share_outside_validity = Some(0.75)),
    ("sensitivity to an input", Writer::Terminal, |r| r.contributors[0].random[0].band_share += 0.05),
];

fn witness(result: &mut StudyResult, clearance_m: f64) {
    let witness = &mut result.bounds[0].upper.witness;
    witness.insert("joint.gudgeon.radial_clearance".to_owned(), WitnessValue::Number(clearance_m));
}

fn scale(values: &mut [f64], by: f64) {
    values.iter_mut().for_each(|value| *value *= by);
}

#[test]
fn planted_contradictions_are_found() {
    const WRITERS: [Writer; 4] = [Writer::Page, Writer::Terminal, Writer::Summary, Writer::Table];
    let result = worn_pin();
    let reader = Reader::of(&result.to_json().unwrap());
    let mut read = WRITERS.map(|writer| reader.written(writer, &result));
    let before = faults(&read);
    assert!(before.is_empty(), "{}", before.join("\n"));
    for (what, writer, change) in PLANTED {
        let mut other = result.clone();
        change(&mut other);
        assert!(other != result, "{what}: nothing is planted");
        let place = writer as usize;
        let kept = std::mem::replace(&mut read[place], reader.written(writer, &other));
        assert!(!faults(&read).is_empty(), "{what} ({writer:?}) is not found");
        read[place] = kept;
    }
}

#[test]
fn a_number_without_a_tag_is_found() {
    let mut texts = Texts::of(&worn_pin());
    texts.page.text = texts.page.text.replacen("of mechanisms", "of 31 mechanisms", 1);
    assert!(
        texts
            .faults()
            .iter()
            .any(|fault| fault.contains("digits that no writer of numbers made: ") && fault.contains("31"))
    );
    let mut texts = Texts::of(&worn_pin());
    let tagged = texts.terminal.numbers.iter().position(|number| number.tag.is_some()).unwrap();
    texts.terminal.numbers[tagged].tag = None;
    assert!(texts.faults().iter().any(|fault| fault.contains("has no tag")));
    let mut texts = Texts::of(&worn_pin());
    texts.summary = texts.summary.replacen("\"seed\"", "\"spread\": 0.25, \"seed\"", 1);
    assert!(texts.faults().iter().any(|fault| fault.contains("nothing says what 'spread' is")));
}
