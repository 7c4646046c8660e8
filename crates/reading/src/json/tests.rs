//! A JSON text becomes the tree it stands for, or none.

use super::*;

fn object<'a>(node: &'a Node<'a>) -> &'a Fields<'a> {
    let Node::Object(fields) = node else { panic!("{node:?} is no object") };
    fields
}

#[test]
fn numbers_have_the_bits_of_the_nearest_double() {
    for text in ["0.1", "-0", "4.35e-5", "1.7976931348623157e308", "5e-324", "123456789012345678901", "7", "-9007199254740993"] {
        let expected: f64 = text.parse().expect("a number");
        assert_eq!(json(text.as_bytes()).expect("JSON"), Node::Number(expected), "{text}");
        let list = format!("[{text}]");
        let Node::List(list) = json(list.as_bytes()).expect("JSON") else { panic!("a list") };
        assert_eq!(list.numbers()[0].to_bits(), expected.to_bits(), "{text}");
    }
}

#[test]
fn names_and_texts_are_borrowed_unless_they_are_escaped() {
    let node = json(br#"{"a": "b", "\u0061": "\n"}"#).expect("JSON");
    let fields = &object(&node).0;
    assert!(matches!(&fields[0], (Cow::Borrowed("a"), Node::Text(Cow::Borrowed("b")))));
    assert!(matches!(&fields[1], (Cow::Owned(name), Node::Text(Cow::Owned(text))) if name == "a" && text == "\n"));
}

#[test]
fn a_byte_order_mark_is_passed_over_and_what_follows_the_text_is_not() {
    assert_eq!(json("\u{feff}{}".as_bytes()).expect("JSON"), Node::Object(Fields::default()));
    for text in ["{} x", "", "[1,", "{\"a\": NaN}", "1e999", "{a: 1}"] {
        assert!(matches!(json(text.as_bytes()), Err(Unread::NotJson(_))), "{text}");
    }
}

#[test]
fn what_lies_too_deep_is_left_out_and_a_parser_has_its_own_limit() {
    let deep = |levels: usize| format!("{}1{}", "{\"a\":".repeat(levels), "}".repeat(levels));
    let (text, mut depth) = (deep(100), 0);
    let mut node = &json(text.as_bytes()).expect("JSON");
    while let Node::Object(fields) = node
        && let Some((_, below)) = fields.0.first()
    {
        (node, depth) = (below, depth + 1);
    }
    assert_eq!((depth, node), (DEEPEST, &Node::Object(Fields::default())));
    assert!(matches!(json("[".repeat(100_000).as_bytes()), Err(Unread::NotJson(_))));
}

#[test]
fn a_text_of_too_many_fields_is_refused_wherever_they_are() {
    let fields = |count: usize| vec!["\"a\":1"; count].join(",");
    assert!(json(format!("{{{}}}", fields(MOST_NODES)).as_bytes()).is_ok());
    let one_object = format!("{{{}}}", fields(MOST_NODES + 1));
    let many_lists = format!("[{}]", vec![format!("[{}]", vec!["{}"; 64].join(",")); 64].join(","));
    let in_lists = format!("{{{}}}", vec![format!("\"a\":{many_lists}"); 3].join(","));
    for text in [&one_object, &in_lists] {
        assert!(matches!(json(text.as_bytes()), Err(Unread::TooMuch)));
    }
    // Numbers are cheap, and odd items beyond the first are not kept.
    for item in ["1", "null", "{\"a\":[1]}", "\"a\""] {
        assert!(json(format!("[{}]", vec![item; 50_000].join(",")).as_bytes()).is_ok(), "{item}");
    }
}

#[test]
fn a_value_of_a_program_gives_the_tree_of_its_text() {
    let value = serde_json::json!({"a": [1, null, "x", {"b": 0.1}], "c": true, "d": null});
    let (tree, text) = (Node::from(&value), value.to_string());
    // As text, for a missing number is not equal to itself.
    assert_eq!(format!("{tree:?}"), format!("{:?}", json(text.as_bytes()).expect("JSON")));
}
