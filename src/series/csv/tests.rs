//! Tables in pieces.

use super::super::pieces::{self, Whole};
use super::super::{ExtraColumns, Reader};

fn all(pieces: &[&[u8]]) -> Whole {
    pieces::all(Reader::csv(ExtraColumns::Refuse), pieces)
}

const AWKWARD: &[&str] = &[
    "\u{feff}# log\r\n\r\n\"time_s\";slip\r\n[s];(-)\r\n0,5;\"0,25\"\r\n\r\n# go\r\n1,5;-0,125\r\n;NaN",
    "time_s,slip\n0,0.1\n1,\"0\n.1\"\n2,0.3\n",
    "time_s\tslip\n1e-3\t1E+2\n-.5\tinf\n",
    "slip,time_s\n0.1\n",
    "\n\n#\n",
    "time_s,slip",
    "time_s,slip\r0,0.1\r\r# go\r1,x\r2,0.3",
    "time_s,slip\r\n0,0.1\r\n1,0.2\n\r2,x\r\n",
    "time_s,slip\n0,0.1\n1,\"0.1\n2,0.1\n",
    "time_s,slip\n0,0.1\n1,\"0.1\"",
    "time_s,slip\n0,0.1\n1,\"",
    "#N/A\ntime_s,slip\n0,0.1\n#N/A,0.1\n#DIV/0! ,0.1\n#NA,0.1\n#",
];

#[test]
fn the_pieces_in_which_a_table_comes_make_no_difference() {
    for text in AWKWARD.iter().map(|text| text.as_bytes()) {
        let whole = all(&[text]);
        for at in 0..=text.len() {
            assert_eq!(all(&[&text[..at], &text[at..]]), whole, "split at {at}");
            assert_eq!(all(&[&text[..at], b"", &text[at..], b""]), whole, "with nothing between at {at}");
        }
        let bytes: Vec<&[u8]> = text.chunks(1).chain([&b""[..]]).collect();
        assert_eq!(all(&bytes), whole, "byte by byte");
    }
    assert_eq!(all(&[AWKWARD[0].as_bytes()]).rows.len(), 3);
}

/// Numbers that look random and are the same in every run (Marsaglia's xorshift).
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % limit as u64) as usize
    }
}

#[test]
fn no_text_and_no_pieces_of_it_make_the_reader_panic_or_differ() {
    const PARTS: [&str; 32] = [
        "0,1\n",
        "0,1\n",
        "0,1\n",
        ".5;1,5\r\n",
        ".5;1,5\r\n",
        ".5;1,5\r\n",
        "1\t.5\n",
        "1\t.5\n",
        "1\t.5\n",
        "\"0\"",
        "\n",
        "\n",
        "\r\n",
        "\r",
        ",",
        ",",
        ";",
        "\t",
        "\"",
        "#",
        " ",
        "0",
        "1",
        "-",
        ".5",
        "1e9",
        "nan",
        "s",
        "time_s",
        "slip",
        "\u{feff}",
        "\0",
    ];
    const HEADERS: [&str; 4] = ["time_s,slip\n", "time_s;slip\r\n", "\u{feff}\"slip\"\ttime_s\n", ""];
    let mut numbers = Numbers(0x9e37_79b9_7f4a_7c15);
    let (mut rows, mut faults, mut unreadable) = (0, 0, 0);
    for _ in 0..4000 {
        let mut text = HEADERS[numbers.below(HEADERS.len())].to_owned();
        for _ in 0..numbers.below(12) {
            text.push_str(PARTS[numbers.below(PARTS.len())]);
        }
        let whole = all(&[text.as_bytes()]);
        let mut pieces = Vec::new();
        let mut left = text.as_bytes();
        while !left.is_empty() {
            let (piece, rest) = left.split_at(1 + numbers.below(left.len().min(9)));
            pieces.push(piece);
            left = rest;
        }
        pieces.push(b"");
        assert_eq!(all(&pieces), whole, "{text:?}");
        unreadable += whole.unreadable.0;
        rows += whole.rows.len();
        faults += usize::from(whole.fault.is_some());
    }
    assert!(rows > 300 && faults > 300, "{rows} rows and {faults} faults are no test");
    assert!(unreadable > 30, "{unreadable} values that are no numbers are no test");
}

#[test]
fn lines_are_counted_whatever_ends_them() {
    for (text, line, column) in [
        ("time_s,slip\n0,0\n1", 3, 2),
        ("time_s,slip\r\n0,0\r\n1\r\n", 3, 2),
        ("time_s,slip\r0,0\r# c\r1\r", 4, 2),
        ("\n\n# c\ntime_s,slip\n\n0,x\n", 6, 2),
        ("time_s,slip\n0,0,0", 2, 3),
    ] {
        let fault = all(&[text.as_bytes()]).fault.expect("a fault");
        assert_eq!((fault.line, fault.column), (line, column), "{text:?}");
    }
}

#[test]
fn an_error_of_a_spreadsheet_in_the_first_column_is_no_comment() {
    let whole = all(&[b"time_s,slip\n0,0.1\n#N/A,0.2\n#DIV/0!,0.2\n#NAME?,0.2\n# N/A\n#end,4\n1,0.1\n"]);
    assert_eq!(whole.fault.map(|fault| fault.line), None);
    assert_eq!(whole.rows.len(), 5);
}

#[test]
fn a_row_without_end_is_refused_in_bounded_memory() {
    let mut reader = Reader::csv(ExtraColumns::Refuse);
    let endless = [b'1'; 1000];
    let fault = (0..100).find_map(|i| {
        let mut left: &[u8] = if i == 0 { b"time_s,slip\n" } else { &endless };
        reader.next(&mut left, false).err()
    });
    assert_eq!(fault.map(|fault| fault.line), Some(2));
}

#[test]
fn every_kind_of_line_end_is_counted_once() {
    for (text, line) in [
        ("time_s,slip\r0,0.1\r\r# go\r1,x\r2,0.3", 5),
        ("time_s,slip\r\n0,0.1\r\n\r\n# go\r\n1,x\r\n2,0.3", 5),
        ("time_s,slip\n0,0.1\n\n# go\n1,x\n2,0.3", 5),
        ("time_s,slip\n0,0.1\n1,\"0\n.1\"\n2,0.3\n", 3),
    ] {
        let whole = all(&[text.as_bytes()]);
        let (count, first) = whole.unreadable;
        assert_eq!((count, first.map(|fault| (fault.line, fault.column))), (1, Some((line, 2))), "{text:?}");
        assert_eq!((whole.rows.len(), whole.fault), (3, None), "{text:?}");
    }
}
