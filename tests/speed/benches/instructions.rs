//! Instructions by Callgrind. `tests/instructions.sh` runs this and compares with the stored baseline.

#![allow(missing_docs)]

use gungraun::prelude::*;
use schuler_speed::work::*;

macro_rules! benchmarks {
    ($($name:ident = $type:ident),+) => {
        $(
            #[library_benchmark]
            #[bench::samples(<$type as Work>::prepare())]
            fn $name(work: $type) -> $type {
                work.run();
                work
            }
        )+

        library_benchmark_group!(name = per_sample, benchmarks = [$($name),+]);
    };
}

schuler_speed::for_each_work!(benchmarks);

main!(library_benchmark_groups = per_sample);
