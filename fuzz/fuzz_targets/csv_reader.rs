//! No table makes the reader panic, and the pieces in which it comes make no difference.

#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    // The first byte says where the table is cut in two.
    let Some((&at, table)) = data.split_first() else { return };
    let (first, rest) = table.split_at(usize::from(at).min(table.len()));
    assert_eq!(terramechanics_server::fuzzing::csv_rows(&[first, rest]), terramechanics_server::fuzzing::csv_rows(&[table]));
});
