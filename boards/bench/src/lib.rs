//! Benchmarks only: `cargo bench -p zrow-bench`.
