//! The band in which a share of mechanisms stays for the whole cycle: at each point of a curve both of its ends.

use super::kind::{Description, Form, Number, NumberKind, StatisticKind};

pub(super) struct SimultaneousBand(#[expect(dead_code, reason = "the share belongs to the curve as a whole")] pub f64);

impl SimultaneousBand {
    pub const DESCRIPTION: Description = Description {
        word: "simultaneous_band",
        with_article: "a simultaneous band",
        words: "band of {} for the whole cycle",
        synonyms: &[],
        form: Form::Curve,
        number: Some(Number {
            name: "share",
            kind: NumberKind::Share,
            example: "0.95",
            meaning: "of a curve: the band in which this share of mechanisms stays for the whole cycle, whatever the unknown values",
        }),
    };
}

impl StatisticKind for SimultaneousBand {
    fn of_sorted(&self, _: &[f64]) -> f64 {
        f64::NAN
    }
}
