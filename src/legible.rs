//! Texts of clients that are fit for a message.

/// A text of one line that reads from left to right as it was written: what a client sent must not look like something else.
pub(crate) fn legible(text: &str) -> String {
    let mut legible = String::with_capacity(text.len());
    for letter in text.chars() {
        match letter {
            // Marks without a width, of direction and between lines, and the tags of Unicode.
            '\u{61c}'
            | '\u{200b}'..='\u{200f}'
            | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}'
            | '\u{feff}'
            | '\u{e0000}'..='\u{e007f}' => legible.extend(letter.escape_unicode()),
            _ if letter.is_control() => legible.extend(letter.escape_default()),
            _ => legible.push(letter),
        }
    }
    legible
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_hide_or_turn_a_text_is_escaped() {
        assert_eq!(legible("a\u{202e}b\n\u{1b}[1m\u{85}"), "a\\u{202e}b\\n\\u{1b}[1m\\u{85}");
        for plain in ["`n0` is 5 kN/m³", "Schluff, größer", "土", "\"a\\b'"] {
            assert_eq!(legible(plain), plain);
        }
    }
}
