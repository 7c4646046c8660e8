//! The sentence of every warning that a test meets: it is made of the place, of what holds and of what to do.

use std::collections::HashMap;
use std::sync::OnceLock;

use serde_json::Value;

use crate::asking::get;

/// Looks at every warning in an answer, wherever it stands.
pub(crate) fn assert_told(answer: &Value) {
    match answer {
        Value::Object(fields) => {
            let warnings = fields.get("warnings").and_then(Value::as_array);
            // The list of all warnings in /v1/model has meanings, but no sentences.
            for warning in warnings.into_iter().flatten().filter(|warning| warning.get("detail").is_some()) {
                assert_made_of_its_parts(warning);
                assert_advice_is_general(warning);
            }
            fields.values().for_each(assert_told);
        }
        Value::Array(items) => items.iter().for_each(assert_told),
        _ => {}
    }
}

fn text<'a>(warning: &'a Value, name: &str) -> &'a str {
    warning[name].as_str().filter(|text| !text.is_empty()).unwrap_or_else(|| panic!("{name} in {warning}"))
}

fn assert_made_of_its_parts(warning: &Value) {
    let (detail, said) = (text(warning, "detail"), format!("{} {}", text(warning, "finding"), text(warning, "advice")));
    let series = warning["series"].as_array().map_or(&[][..], Vec::as_slice);
    let rows = warning["rows"].as_array().map_or(&[][..], Vec::as_slice);
    if series.is_empty() && rows.is_empty() {
        let letter = said.chars().next().expect("a letter");
        let capital = said.replacen(letter, &letter.to_uppercase().to_string(), 1);
        assert!(detail == said || detail == capital, "{warning}");
        assert!(!said.starts_with("the ") || detail == capital, "{warning}");
        return;
    }
    let place = detail.strip_suffix(&said).and_then(|place| place.strip_suffix(": ")).unwrap_or_else(|| panic!("{warning}"));
    assert!(place.starts_with(if series.is_empty() { "At " } else { "In " }), "{warning}");
    for name in series {
        assert!(place.contains(&format!("`{}`", name.as_str().expect("a name"))), "{warning}");
    }
    // Of a stretch of rows, both ends are named.
    let told = numbers(place);
    for row in rows.iter().flat_map(|stretch| stretch.as_array().expect("a stretch")) {
        assert!(told.contains(&row.to_string()), "row {row}: {warning}");
    }
}

/// What is advised holds for every request, so its numbers are those of the list of warnings.
fn assert_advice_is_general(warning: &Value) {
    static MEANINGS: OnceLock<HashMap<String, String>> = OnceLock::new();
    let meanings = MEANINGS.get_or_init(|| {
        let mut meanings: HashMap<String, String> = HashMap::new();
        for warning in get("/v1/model").json()["warnings"].as_array().expect("warnings") {
            let known = meanings.entry(text(warning, "code").to_owned()).or_default();
            *known += &format!("{} {} ", text(warning, "meaning"), warning["advice"].as_str().unwrap_or_default());
        }
        meanings
    });
    let advice = text(warning, "advice");
    assert!(advice.starts_with(|first: char| first == '`' || first.is_uppercase()) && advice.ends_with('.'), "{warning}");
    let general = numbers(&meanings[text(warning, "code")]);
    for number in numbers(advice) {
        assert!(general.contains(&number), "{number} is not general: {warning}");
    }
}

/// The numbers in a text. Figures in a name, such as `n1`, are none.
fn numbers(text: &str) -> Vec<String> {
    let words = text.split(|letter: char| !(letter.is_alphanumeric() || letter == '.' || letter == '_'));
    let bare = words.map(|word| word.trim_matches('.')).filter(|word| word.starts_with(|first: char| first.is_ascii_digit()));
    bare.map(str::to_owned).collect()
}

#[test]
fn the_numbers_of_a_text_are_found() {
    assert_eq!(numbers("At rows 3, 5 to 9: n1 of 0.4 m, 4.5° and k_2 (2024)."), ["3", "5", "9", "0.4", "4.5", "2024"]);
}
