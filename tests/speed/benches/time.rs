//! Time by Criterion: each mechanization's steps, and the kernels that they are made of.

#![allow(missing_docs)]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use schuler::math::compensated::Pair;
use schuler::math::quaternion::Quaternion;
use schuler::math::vector::Vector;
use schuler::strapdown::frame::gravitation::Latitude;
use schuler_speed::work::*;
use std::hint::black_box;

/// Per sample, block ends only.
fn steps(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("steps");
    group.throughput(Throughput::Elements(SAMPLES));
    macro_rules! benchmarks {
        ($($name:ident = $type:ident),+) => {
            $(
                let work = <$type as Work>::prepare();
                group.bench_function(stringify!($name), |bencher| bencher.iter(|| work.run()));
            )+
        };
    }
    schuler_speed::for_each_work!(benchmarks);
    group.finish();
}

/// One call each.
fn kernels(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("kernels");
    let (a, b) = (Quaternion::new(0.8, Vector::new(0.4, -0.4, 0.2)), Vector::new(1.0, -2.0, 0.5));
    group.bench_function("quaternion product", |bencher| {
        bencher.iter(|| black_box(a) * black_box(a));
    });
    group.bench_function("rotation matrix times vector", |bencher| {
        bencher.iter(|| black_box(a).matrix(1.0) * black_box(b));
    });
    group.bench_function("compensated product", |bencher| {
        let pair = Pair { hi: 1.0 / 3.0, lo: 1e-17 };
        bencher.iter(|| black_box(pair) * black_box(pair));
    });
    group.bench_function("gravitation at the next position", |bencher| {
        let mut latitude = Latitude { sine: 0.5_f64.sqrt(), cosine: 0.5_f64.sqrt(), change: 0.0 };
        let position = Vector::new(3.2e6, 3.2e6, 4.487e6);
        bencher.iter(|| latitude.gravitation(black_box(position)));
    });
    group.finish();
}

criterion_group!(benches, steps, kernels);
criterion_main!(benches);
