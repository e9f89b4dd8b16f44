//! Every number of every reference case is met, and `measured/validation.md` says so.
//!
//! With `LOOSEPIN_BLESS=1` in the environment the page is written anew, to be read before it is committed.

use std::path::{Path, PathBuf};

use loosepin::cases::record::CaseRecord;
use loosepin::cases::{Case, case_names, compare_all};
use loosepin::report::cases_page;

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn all_cases() -> Vec<Case> {
    let folder = repository().join("cases");
    let names = case_names(&folder).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    let read =
        |name: &String| Case::from_folder(&folder.join(name)).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    names.iter().map(read).collect()
}

fn outside(records: &[CaseRecord]) -> Vec<String> {
    let numbers = records.iter().flat_map(|record| record.numbers.iter().map(move |number| (record, number)));
    numbers
        .filter(|(_, number)| !number.is_within())
        .map(|(record, number)| format!("{}: {}: {:?}", record.name, number.name, number.comparison))
        .collect()
}

#[test]
fn peer_and_analytic_numbers_of_all_cases_are_met_and_the_page_is_up_to_date() {
    let cases = all_cases();
    assert!(cases.len() > 20, "only {} cases", cases.len());
    assert!(cases.iter().all(|case| case.count() > 0), "a case without a number");
    let with_history =
        cases.iter().filter(|case| repository().join("cases").join(&case.name).join("reference.csv").exists());
    let without: Vec<&str> = with_history.filter(|case| case.histories() < 2).map(|case| case.name.as_str()).collect();
    assert!(without.is_empty(), "a reference.csv without positions and velocities that are compared: {without:?}");
    let records = compare_all(&cases).unwrap_or_else(|diagnostics| panic!("{diagnostics}"));
    for record in &records {
        for number in &record.numbers {
            let share = number.difference_si() / number.tolerance_si;
            println!("{}: {}: {:.1e}, {share:.1e} of the tolerance", record.name, number.name, number.difference_si());
        }
    }
    let outside = outside(&records);
    assert!(outside.is_empty(), "outside of their tolerances: {outside:#?}");
    let path = repository().join("measured/validation.md");
    let page = cases_page(&records);
    if std::env::var_os("LOOSEPIN_BLESS").is_some() {
        std::fs::write(&path, &page).expect("the page can be written");
    }
    let stored = std::fs::read_to_string(&path).expect("measured/validation.md is there");
    assert!(
        stored == page,
        "measured/validation.md is out of date; hint: loosepin cases run --write measured/validation.md, and read what changed"
    );
}
