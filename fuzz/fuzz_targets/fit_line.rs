//! The line through rolling samples, at once and one after the other, ends for any finite input, with finite numbers or a typed error.

#![no_main]

#[path = "../../crates/identification/tests/extremes/mod.rs"]
mod extremes;

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    extremes::line(&mut extremes::Draw::new(data));
});
