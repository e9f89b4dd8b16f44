//! Every point-contact law of the table: the factor of its energy loss from the coefficient of restitution, once per
//! run and contact.

use criterion::{Criterion, criterion_group, criterion_main};
use loosepin::contact::POINT_LAWS;
use std::hint::black_box;

const RESTITUTION: f64 = 0.87;

fn damping_factor(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("damping_factor");
    for law in POINT_LAWS {
        group.bench_function(law.name, |bencher| bencher.iter(|| (law.damping_factor)(black_box(RESTITUTION))));
    }
    group.finish();
}

criterion_group!(benches, damping_factor);
criterion_main!(benches);
