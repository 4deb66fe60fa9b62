//! Every rasterizer on every figure, with criterion's statistics: `cargo bench -p zrow-bench --bench coverage`.

mod rasterizers;

use std::hint::black_box;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use rasterizers::{Input, RASTERIZERS};

fn coverage(criterion: &mut Criterion) {
    for input in Input::all() {
        let mut group = criterion.benchmark_group(format!("{}_{}", input.figure.name(), input.size));
        for rasterizer in RASTERIZERS {
            group.bench_function(BenchmarkId::from_parameter(rasterizer.name), |bencher| {
                bencher.iter(|| (rasterizer.fill)(black_box(&input)));
            });
        }
        group.finish();
    }
}

criterion_group!(benches, coverage);
criterion_main!(benches);
