//! How small probabilities were estimated.

use super::bounds::Rare;
use crate::assemble::Material;
use loosepin_result::study::{RareEnd, RareRecord};

/// How small probabilities were estimated.
pub fn rare_records(material: &Material<'_>) -> Vec<RareRecord> {
    let end = |end: &super::bounds::RareEnd| RareEnd {
        method: end.method,
        probability: end.estimate.value,
        standard_error: end.estimate.standard_error,
        reliability_index: end.index,
        runs: end.runs as u64,
        failed: end.failed as u64,
    };
    let record = |rare: &Rare| RareRecord {
        output: material.name_of(rare.column),
        of: material.plan().columns[rare.column].deviation,
        at: material.point_of(rare.column, false),
        statistic: rare.statistic,
        lower: end(&rare.ends[0]),
        upper: end(&rare.ends[1]),
    };
    material.rare.iter().map(record).collect()
}
