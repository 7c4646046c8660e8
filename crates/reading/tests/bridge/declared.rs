//! A request is read by its declaration: all faults at once, and nothing that is sent makes it panic.

use crate::sample::{BRIDGE, Load, bridge, faults_of, read_bridge, said};
use terramechanics_reading::*;

const GOOD: &str = r#"{"span_m": 20, "beam": {"law": "solid", "width_m": 0.3}, "load": 5000}"#;

#[test]
fn what_is_declared_is_read() {
    let read = |text: &str| bridge(text).unwrap_or_else(|faults| panic!("{text}: {faults:?}"));
    let plain = read(GOOD);
    assert_eq!((plain.span, plain.beam.index, plain.beam.values), (20.0, 0, vec![Some(0.3), Some(2.0)]));
    assert_eq!((plain.loads, plain.side, plain.piers), (vec![5000.0], Load::Dead, vec![]));
    let full = read(
        r#"{"span_m": 5, "beam": {"law": "hollow", "width_m": 0.2, "wall_m": 0.01}, "load": [1, 2], "side": "live",
            "piers": [{"height_m": 3}, {"height_m": 4}], "sides": ["live"], "range_m": [1, 2], "note": "old"}"#,
    );
    assert_eq!((full.loads, full.side, full.piers), (vec![1.0, 2.0], Load::Live, vec![3.0, 4.0]));
    assert_eq!((full.sides, full.range), (vec![Load::Live], Some([1.0, 2.0])));
    let spread = r#"{"span_m": 20, "beam": {"law": "solid", "width_m": 0.3}, "load": {"from": 1, "to": 2}}"#;
    assert_eq!(read(spread).loads, [1.0, 2.0]);
    assert_eq!(read(&spread.replace("{\"from\": 1, \"to\": 2}", "\"own\"")).loads, [0.0]);
}

#[test]
fn all_faults_are_told_at_once() {
    let text = r#"{"span_m": 30000, "beam": {"law": "hollow", "depth": 1, "width_m": -1}, "load": [1, "x", null, 1e99],
        "side": "lvie", "piers": [{"hieght_m": 3}, 5], "sides": ["live", "live", "up"], "range_m": [2, 1], "note": "", "sapn_m": 1}"#;
    let faults = faults_of(text);
    let found: Vec<_> = faults.iter().map(|fault| (fault.pointer.as_str(), fault.detail.as_str())).collect();
    assert_eq!(
        found,
        [
            ("/sapn_m", "unknown field; did you mean `span_m`?"),
            ("/span_m", "must be from 1 to 5000, not 30000; it is in metres: 30000 mm are 30"),
            ("/beam/width_m", "must be from 0.01 to 10, not -1"),
            ("/beam/wall_m", "is required"),
            ("/beam/depth", "`hollow` has no such field; it takes width_m, wall_m"),
            ("/load/1", "must be a number, not a string"),
            ("/load/2", "must be a number, not null"),
            ("/load/3", "must be from 0 to 1e9, not 1e99"),
            ("/side", "unknown name `lvie`; did you mean `live`?"),
            ("/piers/0/hieght_m", "unknown field; did you mean `height_m`?"),
            ("/piers/0/height_m", "is required"),
            ("/piers/1", "must be an object, not a number"),
            ("/sides/1", "is named more than once"),
            ("/sides/2", "unknown name `up`; known are dead, live"),
            ("/range_m", "the lower bound must be below the upper bound"),
            ("/note", "must have from 1 to 60 characters, none of them a control character"),
        ]
    );
    let load = faults[7].figures.as_ref().expect("figures");
    assert_eq!((load.value, load.minimum, load.maximum, load.unit.as_deref()), (Some(1e99), Some(0.0), Some(1e9), Some("N")));
}

#[test]
fn null_is_as_good_as_nothing_unless_the_field_is_required() {
    let nulls = r#"{"span_m": 20, "beam": {"law": "solid", "width_m": 0.3, "depth": null, "wall_m": null}, "load": 1, "side": null,
        "piers": null, "sides": null, "range_m": null, "note": null}"#;
    let read = bridge(nulls).expect("a bridge");
    assert_eq!((read.side, read.beam.values[1]), (Load::Dead, Some(2.0)));
    assert_eq!(said(&GOOD.replace("20", "null"), "/span_m"), "must be a number, not null");
    assert_eq!(said(&GOOD.replace("0.3", "null"), "/beam/width_m"), "must be a number, not null");
    assert_eq!(said(&GOOD.replace("\"solid\"", "null"), "/beam/law"), "must be a string, not null");
    assert_eq!(said(r#"{"span_m": 1, "beam": null, "load": 1}"#, "/beam"), "must be an object, not null");
    assert_eq!(said("null", ""), "the body must be a JSON object, not null");
    assert_eq!(said(&GOOD.replace("\"load\"", "\"x_m\": null, \"load\""), "/x_m").split(';').next(), Some("unknown field"));
}

#[test]
fn repeated_names_and_missing_words_are_told() {
    assert_eq!(said(&GOOD.replace("20,", "20, \"span_m\": 20,"), "/span_m"), "is given more than once");
    assert_eq!(said(&GOOD.replace("0.3", "0.3, \"law\": \"solid\""), "/beam/law"), "is given more than once");
    assert_eq!(said(&GOOD.replace("\"law\": \"solid\",", ""), "/beam/law"), "is required: one of solid, hollow");
    assert_eq!(said(&GOOD.replace("5000", "\"mine\""), "/load"), "must be a number, \"own\", an array of numbers or a range");
    assert_eq!(
        said(&GOOD.replace("5000", "true"), "/load"),
        "must be a number, \"own\", an array of numbers or a range, not true"
    );
    assert!(said(&GOOD.replace("0.3", "0.3, \"wide\": 1"), "/beam/wide").ends_with("known are law, width_m, depth, wall_m"));
}

#[test]
fn a_field_knows_where_it_belongs() {
    assert_eq!(
        said(&GOOD.replace("\"load\"", "\"wall_m\": 1, \"load\""), "/wall_m"),
        "unknown field; `wall_m` belongs in `beam`"
    );
}

#[test]
fn a_query_is_read_like_a_body() {
    let query =
        Query::parse("span_m=20&beam.law=solid&beam.width_m=0.3&load.from=1&load.to=2").expect("few parameters").into_node();
    assert_eq!(read(&query, &BRIDGE, &Hints::NONE, read_bridge).expect("a bridge").loads, [1.0, 2.0]);
    let of_sides = |text: &str| {
        let query = format!("span_m=20&beam.law=solid&beam.width_m=1&load=own&sides={text}");
        let node = Query::parse(&query).expect("few parameters").into_node();
        read(&node, &BRIDGE, &Hints::NONE, read_bridge).map(|bridge| bridge.sides)
    };
    assert_eq!(of_sides("live,dead"), Ok(vec![Load::Live, Load::Dead]));
    let faults = of_sides("live,,dead,live").expect_err("faults");
    assert_eq!(faults.iter().map(|fault| fault.pointer.as_str()).collect::<Vec<_>>(), ["/sides/1", "/sides/3"]);
    assert_eq!(of_sides("").expect_err("an empty list")[0].pointer, "/sides/0");
    assert_eq!(of_sides(&"live,".repeat(1000)).expect_err("a long list")[0].detail, "must have from 1 to 4 names");
    let query = Query::parse("span_m=2O&beam=solid&load=own&side=5").expect("few parameters").into_node();
    let faults = read(&query, &BRIDGE, &Hints::NONE, read_bridge).expect_err("faults");
    let said: Vec<_> = faults.iter().map(|fault| fault.detail.as_str()).collect();
    assert_eq!(said, ["must be a number, not `2O`", "must be an object, not `solid`", "must be a string, not a number"]);
}

/// A number of a deterministic sequence that looks random (Knuth's linear congruence).
fn next(seed: &mut u64, below: u64) -> u64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 33) % below
}

fn any_json(seed: &mut u64, depth: u64) -> String {
    const NAMES: [&str; 14] =
        ["span_m", "beam", "load", "side", "piers", "sides", "range_m", "note", "law", "width_m", "from", "height_m", "x", "/~"];
    const PLAIN: [&str; 12] =
        ["null", "true", "false", "0", "-1e308", "20", "0.3", "\"solid\"", "\"live\"", "\"\"", "\"own\"", "\"\\u0000\""];
    let count = next(seed, 6);
    match if depth == 0 { 0 } else { next(seed, 3) } {
        0 => PLAIN[next(seed, 12) as usize].to_owned(),
        1 => format!("[{}]", (0..count).map(|_| any_json(seed, depth - 1)).collect::<Vec<_>>().join(",")),
        _ => {
            let field = |_| format!("{:?}:{}", NAMES[next(seed, 14) as usize], any_json(seed, depth - 1));
            format!("{{{}}}", (0..count).map(field).collect::<Vec<_>>().join(","))
        }
    }
}

#[test]
fn whatever_is_sent_is_a_bridge_or_has_faults_with_pointers() {
    let mut seed = 7;
    for _ in 0..20_000 {
        let text = any_json(&mut seed, 4);
        if let Err(faults) = bridge(&text) {
            assert!(!faults.is_empty(), "{text}");
            assert!(faults.iter().all(|fault| fault.pointer.is_empty() || fault.pointer.starts_with('/')), "{text}");
        }
    }
}

#[test]
fn a_list_of_countless_faults_is_told_in_few() {
    let text = GOOD.replace("5000", &format!("[{}]", vec!["-1"; 100].join(",")));
    let faults = faults_of(&text);
    assert_eq!(faults.len(), 11);
    assert_eq!(faults[10].detail, "has 90 more such faults");
    assert_eq!(said(&GOOD.replace("5000", "[]"), "/load"), "must have from 1 to 100 numbers");
    let long = faults_of(&GOOD.replace("5000", &format!("[{}]", vec!["1"; 101].join(",")))).remove(0).figures.expect("figures");
    assert_eq!((long.value, long.minimum, long.maximum), (Some(101.0), Some(1.0), Some(100.0)));
}

#[test]
fn another_object_can_take_the_place_of_fields() {
    const LOAD: Object = Object { name: "Other", doc: "", groups: &[&[&crate::sample::SPAN]] };
    const OTHER: Field<&Object> = Field::new("other", "", &LOAD);
    const BOTH: Object = Object { name: "Both", doc: "", groups: &[&[&crate::sample::SPAN, &OTHER]] };
    let spans = |text: &str| {
        let node = json(text.as_bytes()).expect("JSON");
        read(&node, &BOTH, &Hints::NONE, |own| {
            let other = own.required(&OTHER)?;
            let varied = own.overlaid(&other);
            Some((
                own.required(&crate::sample::SPAN)?,
                varied.required(&crate::sample::SPAN)?,
                varied.place_of(&crate::sample::SPAN).pointer(),
            ))
        })
    };
    assert_eq!(spans(r#"{"span_m": 2, "other": {"span_m": 3}}"#), Ok((2.0, 3.0, "/other/span_m".to_owned())));
    let faults = spans(r#"{"span_m": 2, "other": {"span_m": 0}}"#).expect_err("a fault");
    assert_eq!(faults[0].pointer, "/other/span_m");
}
