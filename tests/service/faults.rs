//! Faults of a request as data, what counts as absent, and bounds on what is told.

use serde_json::json;

use crate::asking::{letter, post, post_text, with};

/// Null is how pydantic and MATLAB write a field that was left out; one that nothing works without is asked for by its type.
#[test]
fn null_for_a_field_that_may_be_absent_is_as_good_as_none() {
    let text = letter().to_string();
    let with_nulls = text.replacen('{', "{\"normal_load_n\":null,\"contact\":null,\"method\":null,\"lambda_a\":null,", 1);
    let with_nulls = with_nulls.replace("\"n0\":", "\"n1\":null,\"k_s\":null,\"n0\":");
    assert_eq!(post_text("/v1/forces", with_nulls).ok(), post_text("/v1/forces", text.clone()).ok());
    for (from, to, pointer, said) in [
        ("\"slip\":0.2", "\"slip\":null", "/slip", "is required, or both"),
        ("\"radius_m\":0.2", "\"radius_m\":null", "/wheel/radius_m", "is required"),
        ("\"n0\":0.91", "\"n0\":null", "/soil/pressure_sinkage/n0", "must be a number, not null"),
        ("\"law\":\"bekker\"", "\"law\":null", "/soil/pressure_sinkage/law", "must be a string, not null"),
    ] {
        let answer = post_text("/v1/forces", text.replace(from, to));
        assert!(answer.fault(pointer).starts_with(said), "{pointer}: {}", answer.text);
    }
    assert_eq!(post_text("/v1/forces", "{\"wheel\":null}").fault("/wheel"), "must be an object, not null");
}

/// A program needs not take the sentence apart.
#[test]
fn a_number_out_of_bounds_comes_with_its_bounds_and_unit() {
    let body = with(&letter(), json!({"slip": 2, "soil": {"cohesion_pa": -5, "friction_angle_rad": 1.6}, "sinkage_m": 0.3}));
    let problem = post("/v1/forces", &body).problem(422);
    let figures = |pointer: &str| {
        let fault = problem["errors"].as_array().into_iter().flatten().find(|error| error["pointer"] == pointer);
        let fault = fault.unwrap_or_else(|| panic!("{pointer} in {problem}"));
        ["value", "minimum", "maximum", "exclusive_maximum", "unit"].map(|name| fault[name].clone())
    };
    let half_pi = std::f64::consts::FRAC_PI_2;
    for (pointer, expected) in [
        ("/slip", json!([2.0, -1.0, 1.0, null, "1"])),
        ("/soil/cohesion_pa", json!([-5.0, 0.0, 1e8, null, "Pa"])),
        ("/soil/friction_angle_rad", json!([1.6, 0.0, null, half_pi, "rad"])),
        ("/sinkage_m", json!([0.3, 1e-9, 0.2, null, "m"])),
    ] {
        assert_eq!(json!(figures(pointer)), expected, "{pointer}");
    }
    let sinkage = problem["errors"].as_array().into_iter().flatten().find(|error| error["pointer"] == "/sinkage_m");
    assert_eq!(sinkage.map(|fault| &fault["maximum_from"]), Some(&json!("/wheel/radius_m")));
}

/// The sinkage that follows from a static one is no number of the request.
#[test]
fn a_refused_number_that_was_not_sent_is_not_given_as_that_of_the_field() {
    let body = with(&letter(), json!({"slip": 0.9, "sinkage_m": null, "static_sinkage_m": 0.19}));
    let answer = post("/v1/forces", &body);
    assert!(answer.fault("/static_sinkage_m").contains("the sinkage"), "{}", answer.text);
    assert!(answer.problem(422)["errors"][0]["value"].is_null(), "{}", answer.text);
}

#[test]
fn a_body_of_countless_faults_has_a_short_answer() {
    let fields: Vec<String> = (0..40_000).map(|i| format!("\"x{i}\":{{\"y\":1}}")).collect();
    let answer = post_text("/v1/forces", format!("{{{}}}", fields.join(",")));
    assert_eq!(answer.pointers(), [""]);
    let plates = vec!["[[1],2,{\"a\":1}]"; 1000].join(",");
    let answer = post_text("/v1/identify/plates", format!("{{\"plates\":[{plates}]}}"));
    assert_eq!(answer.pointers(), ["/plates"]);
}
