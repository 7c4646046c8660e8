//! Which lanes does this machine have?
//!
//! Every level gives the same bits (`crate::levels`), so the choice is one of speed alone.

use fearless_simd::Level;

/// The best lanes of this machine; in a test those that `held::to` names.
///
/// What is built with `RUSTFLAGS='--cfg lanes="avx2"'` or `"sse2"` has no better ones: for measurements.
#[inline]
pub(crate) fn level() -> Level {
    #[cfg(test)]
    if let Some(level) = held::level() {
        return level;
    }
    #[cfg(all(target_arch = "x86_64", lanes = "avx2"))]
    if let Some(lanes) = Level::new().as_avx2() {
        return Level::Avx2(lanes);
    }
    #[cfg(all(target_arch = "x86_64", lanes = "sse2"))]
    if let Some(lanes) = Level::new().as_sse2() {
        return Level::Sse2(lanes);
    }
    Level::new()
}

/// Lanes that a test holds to.
#[cfg(test)]
pub(crate) mod held {
    use super::Level;
    use std::cell::Cell;

    thread_local! {
        static HELD: Cell<Option<Level>> = const { Cell::new(None) };
    }

    pub(super) fn level() -> Option<Level> {
        HELD.get()
    }

    /// What `f` gives with the lanes of `level`.
    pub(crate) fn to<T>(level: Level, f: impl FnOnce() -> T) -> T {
        HELD.set(Some(level));
        let found = f();
        HELD.set(None);
        found
    }
}
