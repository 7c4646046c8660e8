//! The fit of shear tests ends for any finite input, with finite numbers or a typed error.

#![no_main]

#[path = "../../crates/identification/tests/extremes/mod.rs"]
mod extremes;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    extremes::shear(&mut extremes::Draw::new(data));
});
