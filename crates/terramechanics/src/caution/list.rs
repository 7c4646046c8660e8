//! All kinds there are.

use super::{Caution, CautionKind, grain_kinds, kinds, load_kinds, slip_kinds};

impl Caution {
    /// Everything that is watched.
    pub const KINDS: &'static [&'static CautionKind] = {
        const PARTS: [&[&CautionKind]; 4] = [kinds::KINDS, slip_kinds::KINDS, load_kinds::KINDS, grain_kinds::KINDS];
        const COUNT: usize = PARTS[0].len() + PARTS[1].len() + PARTS[2].len() + PARTS[3].len();
        &joined::<COUNT>(PARTS)
    };
}

/// The kinds of all parts, one after another.
const fn joined<const COUNT: usize>(parts: [&'static [&'static CautionKind]; 4]) -> [&'static CautionKind; COUNT] {
    let mut all = [parts[0][0]; COUNT];
    let (mut part, mut place) = (0, 0);
    while part < parts.len() {
        let mut i = 0;
        while i < parts[part].len() {
            all[place] = parts[part][i];
            place += 1;
            i += 1;
        }
        part += 1;
    }
    all
}
