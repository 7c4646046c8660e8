//! A pull in place of the slip, in `/v1/forces`.

use serde_json::{Value, json};

use crate::asking::{get, letter, post, query_of, with};

/// A solved slip.
const SOLVED: f64 = 1e-9;

fn number(reply: &Value, name: &str) -> f64 {
    reply[name].as_f64().unwrap_or_else(|| panic!("no {name} in {reply}"))
}

/// The letter's wheel under 80 N, with `changes`.
fn loaded(changes: Value) -> Value {
    with(&with(&letter(), json!({"slip": null, "sinkage_m": null, "normal_load_n": 80})), changes)
}

#[test]
fn the_answer_of_a_slip_leads_back_to_it() {
    for method in ["quadrature", "linearised", "explicit"] {
        for slip in [-0.2, 0.05, 0.4] {
            let asked = post("/v1/forces", &loaded(json!({"slip": slip, "method": method}))).ok();
            for name in ["longitudinal_force_n", "drawbar_coefficient"] {
                let pull = loaded(json!({"method": method, name: asked[name]}));
                let solved = post("/v1/forces", &pull).ok();
                assert!((number(&solved, "slip") - slip).abs() < SOLVED, "{method}, {name}: {}", solved["slip"]);
                assert!((number(&solved, "torque_n_m") / number(&asked, "torque_n_m") - 1.0).abs() < 1e-7);
                assert_eq!(get(&format!("/v1/forces?{}", query_of(&pull))).ok(), solved);
            }
        }
    }
}

#[test]
fn a_pull_that_no_slip_gives_is_refused_with_the_largest() {
    let spinning = number(&post("/v1/forces", &loaded(json!({"slip": 1}))).ok(), "longitudinal_force_n");
    let answer = post("/v1/forces", &loaded(json!({"longitudinal_force_n": 100})));
    assert_eq!(answer.pointers(), ["/longitudinal_force_n"]);
    let fault = &answer.problem(422)["errors"][0];
    // Under a load the pull of this wheel rises up to spinning on the spot.
    assert!((number(fault, "maximum") / spinning - 1.0).abs() < SOLVED, "{fault}");
    assert_eq!((number(fault, "value"), fault["unit"].as_str()), (100.0, Some("N")));
    assert!(answer.fault("/longitudinal_force_n").ends_with("at a slip of 1"), "{fault}");

    let answer = post("/v1/forces", &loaded(json!({"drawbar_coefficient": 2})));
    let fault = &answer.problem(422)["errors"][0];
    assert_eq!(fault["pointer"], "/drawbar_coefficient");
    assert!((number(fault, "maximum") / (spinning / 80.0) - 1.0).abs() < SOLVED, "{fault}");
    let least = &post("/v1/forces", &loaded(json!({"longitudinal_force_n": -500}))).problem(422)["errors"][0];
    assert!(number(least, "minimum") < 0.0 && least.get("maximum").is_none(), "{least}");
}

#[test]
fn there_is_one_way_to_the_slip() {
    let both = loaded(json!({"longitudinal_force_n": 10, "drawbar_coefficient": 0.1}));
    assert_eq!(post("/v1/forces", &both).pointers(), ["/longitudinal_force_n", "/drawbar_coefficient"]);
    for motion in [json!({"slip": 0.1}), json!({"forward_velocity_m_s": 0.1})] {
        let beside = with(&loaded(json!({"longitudinal_force_n": 10})), motion);
        let said = post("/v1/forces", &beside).fault("/longitudinal_force_n");
        assert!(said.starts_with("only one of `slip`, both velocities, `longitudinal_force_n`"), "{said}");
    }
    assert_eq!(post("/v1/forces", &loaded(json!({"longitudinal_force_n": "10"}))).pointers(), ["/longitudinal_force_n"]);
    assert_eq!(post("/v1/forces", &loaded(json!({"longitudinal_force_n": 1e13}))).pointers(), ["/longitudinal_force_n"]);
    // Other operations have no such field.
    assert_eq!(
        post("/v1/slip-sweep", &loaded(json!({"slip": [0, 0.1], "drawbar_coefficient": 0.1}))).pointers(),
        ["/drawbar_coefficient"]
    );
}
