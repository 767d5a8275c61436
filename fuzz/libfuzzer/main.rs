//! One program for all targets: MINDEG_FUZZ_TARGET names the one to run.
#![no_main]

use std::sync::LazyLock;

static TARGET: LazyLock<mindeg_fuzz::Target> = LazyLock::new(|| {
    let name = std::env::var("MINDEG_FUZZ_TARGET").unwrap_or_default();
    let target = mindeg_fuzz::TARGETS.iter().find(|target| target.0 == name);
    target.unwrap_or_else(|| panic!("MINDEG_FUZZ_TARGET names no target: {name:?}")).1
});

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| (*TARGET)(bytes));
