//! Several inputs that are loosened together, against direct studies.

use crate::allowed_fits::{CLEARANCE, conducted, conducted_with};
use loosepin::report::{study_page, study_text};
use loosepin::study::result::{Together, TogetherRecord, Verdict};

const CRANK: &str = "\"parameter.crank_length\"";

/// The play as an interval up to this, and the scatter of the crank.
fn inputs(play_mm: f64, deviation_mm: f64) -> String {
    format!(
        "{CRANK} = {{ normal = {{ mean = \"50 mm\", standard_deviation = \"{deviation_mm} mm\" }} }}
        [epistemic]
        {CLEARANCE} = {{ interval = [\"0.002 mm\", \"{play_mm} mm\"] }}
        "
    )
}

fn together(how: &str) -> (TogetherRecord, String, String) {
    let allow = format!("[allow]\n{CLEARANCE}.up_to = \"0.2 mm\"\n{CRANK}.up_to = \"0.1 mm\"\n");
    let result = conducted_with(&format!("allow_together = \"{how}\""), &format!("{}{allow}", inputs(0.05, 0.01)));
    assert!(result.allowances.is_empty());
    let text = study_text(&result).split_whitespace().collect::<Vec<&str>>().join(" ");
    (result.together.clone().expect("together"), text, study_page(&result))
}

/// What a study of its own says at these values.
fn verdict(values_si: &[f64]) -> Verdict {
    conducted(&inputs(1e3 * values_si[0], 1e3 * values_si[1])).requirements[0].verdict
}

/// What the record says of these values with the random numbers of the study; of refused ones, the last of both.
fn first_verdict(record: &TogetherRecord, values_si: &[f64]) -> Verdict {
    let mut of_values = record.checks.iter().filter(|check| check.values_si == values_si);
    let first = of_values.next().expect("was run").answer.verdict;
    assert_ne!(of_values.next().map_or(first, |confirmation| confirmation.answer.verdict), Verdict::Met);
    first
}

#[test]
fn identity_direct_studies_agree_with_the_same_share_of_both() {
    let (record, text, _) = together("proportional");
    assert_eq!(record.how, Together::Proportional);
    let [allowed, beyond] = [&record.allowed_si[0], &record.beyond_si[0]];
    // The same share of both, a 128th of it apart.
    let shares = [allowed[0] / 2e-4, allowed[1] / 1e-4];
    assert!((shares[0] - shares[1]).abs() < 1e-12 && shares[0] > 0.1 && shares[0] < 0.9, "{record:?}");
    assert!((beyond[0] / 2e-4 - shares[0] - 1.0 / 128.0).abs() < 1e-12, "{record:?}");
    assert_eq!(verdict(allowed), Verdict::Met);
    assert_eq!(verdict(beyond), first_verdict(&record, beyond));
    assert!(text.contains("Together, each at"), "{text}");
}

#[test]
fn identity_direct_studies_agree_with_both_sides_of_a_frontier() {
    let (record, text, page) = together("frontier");
    let loosest = |at: usize| record.allowed_si[at][1];
    let columns = record.allowed_si.len();
    assert_eq!(columns, 7);
    // More play leaves less room for scatter.
    assert!(
        (1..columns).all(|at| loosest(at) <= loosest(at - 1)) && loosest(0) > 2.0 * loosest(columns - 1),
        "{record:?}"
    );
    // The first column has no width: a file cannot say so.
    for at in [1, 3] {
        assert_eq!(verdict(&record.allowed_si[at]), Verdict::Met, "{record:?}");
        let first = record.allowed_si[at][0];
        let beyond = record.beyond_si.iter().find(|pair| pair[0] == first).expect("refused above");
        assert_eq!(verdict(beyond), first_verdict(&record, beyond), "{record:?}");
    }
    assert!(text.contains("One against the other: upper limit of the gudgeon radial clearance"), "{text}");
    assert!(page.contains("id=\"frontier\""));
}
