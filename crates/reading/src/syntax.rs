//! What is wrong with a text that is not JSON, in the words of one who wrote it and not of the parser.

/// What is wrong, with line and column.
#[must_use]
pub fn fault_in_words(text: &[u8], error: &serde_json::Error) -> String {
    let (line, column) = (error.line(), error.column());
    if text.trim_ascii().is_empty() {
        return format!("the body is empty: send a JSON object (line {line}, column {column})");
    }
    let said = error.to_string();
    let place = format!(" at line {line} column {column}");
    let said = said.strip_suffix(&place).unwrap_or(&said);
    match habit(said, rest_at(text, line, column)) {
        Some(habit) => format!("{habit}{place}"),
        None => format!("{said}{place}"),
    }
}

/// What other notations write and JSON does not, if it is that.
fn habit(said: &str, rest: &[u8]) -> Option<&'static str> {
    let begins = |words: &[&str]| words.iter().any(|word| rest.starts_with(word.as_bytes()));
    if said.starts_with("EOF") {
        return Some("the body ends before its JSON does");
    }
    if said.starts_with("trailing comma") {
        return Some("JSON has no comma after the last item");
    }
    if said.starts_with("trailing characters") {
        return Some("there is more after the end of the JSON");
    }
    if begins(&["NaN", "nan", "Infinity", "-Infinity", "Inf", "inf", "-inf", "-Inf"]) {
        return Some("JSON has no NaN or Infinity: leave the field out, or send null where a column may have gaps");
    }
    if begins(&["'"]) {
        return Some("JSON takes double quotes, not single ones");
    }
    if begins(&["True", "False", "None"]) {
        return Some("JSON writes true, false and null");
    }
    if begins(&["//", "/*", "#"]) {
        return Some("JSON has no comments");
    }
    if begins(&["."]) || (said.starts_with("expected value") && begins(&["+"])) {
        return Some("a JSON number begins with a digit or a minus: 0.5, not .5 or +0.5");
    }
    (said.starts_with("key must be a string")).then_some("a name has to stand in double quotes")
}

/// The text from the word in which the parser stopped, at the character of that column, counted from 1, or a minus before it.
fn rest_at(text: &[u8], line: usize, column: usize) -> &[u8] {
    let around = text.split(|&byte| byte == b'\n').nth(line.saturating_sub(1)).unwrap_or(&[]);
    let at = column.saturating_sub(1).min(around.len());
    let word = around[..at].iter().rev().take_while(|byte| byte.is_ascii_alphabetic()).count();
    let start = at - word;
    let minus = usize::from(start > 0 && around[start - 1] == b'-');
    &around[start - minus..]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_other_notations_write_is_told_in_their_words() {
        for (text, begin) in [
            ("", "the body is empty"),
            (" \n ", "the body is empty"),
            ("{\"slip\": 0.2", "the body ends before"),
            ("{\"slip\": NaN}", "JSON has no NaN"),
            ("{\"slip\": nan}", "JSON has no NaN"),
            ("{\"a\": 1,\n \"slip\": -Infinity}", "JSON has no NaN"),
            ("{'slip': 0.2}", "JSON takes double quotes"),
            ("{\"method\": 'explicit'}", "JSON takes double quotes"),
            ("{slip: 0.2}", "a name has to stand"),
            ("{\"slip\": 0.2,}", "JSON has no comma after"),
            ("{\"slip\": True}", "JSON writes true"),
            ("{\"slip\": .2}", "a JSON number begins"),
            ("{\"slip\": 0.2} // driving", "there is more"),
            ("{ // driving\n\"slip\": 0.2}", "JSON has no comments"),
            ("{\"slip\": 0.2 \"sinkage_m\": 1}", "expected `,` or `}`"),
        ] {
            let error = serde_json::from_str::<serde_json::Value>(text).expect_err("not JSON");
            let said = fault_in_words(text.as_bytes(), &error);
            assert!(said.starts_with(begin), "{text}: {said}");
            assert!(
                said.contains(&format!("line {}", error.line())) && said.contains(&format!("column {}", error.column())),
                "{said}"
            );
        }
    }
}
