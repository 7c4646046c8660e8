//! GET twins of `/v1/forces`, `/v1/resistances`, `/v1/stress-profile` and `/v1/slip-sweep`: a query instead of a body.

use serde_json::{Value, json};

use crate::asking::{Answer, get, letter, post, post_for_csv, query_of, request, send, with};

fn asked(path: &str, body: &Value) -> Answer {
    get(&format!("{path}?{}", query_of(body)))
}

/// Bodies that name every kind of field once: presets and overrides, laws, words, velocities, the three sinkages.
fn bodies() -> Vec<(&'static str, Value)> {
    let presets =
        json!({"wheel": {"preset": "letter", "lug_height_m": 0.01}, "soil": {"preset": "letter-sand", "cohesion_pa": 200}});
    let solved = with(&presets, json!({"slip": -0.1, "normal_load_n": 80, "method": "linearised"}));
    let exact =
        with(&presets, json!({"slip": 0.3, "sinkage_m": 0.02, "method": "explicit", "lambda_a": "exact", "lambda_b": 1e-2}));
    let moving = with(
        &letter(),
        json!({"slip": null, "forward_velocity_m_s": -0.15, "angular_velocity_rad_s": -1, "normal_stress_radius": "shearing"}),
    );
    let linear = json!({"sinkage_m": null, "static_sinkage_m": 0.01, "slip_sinkage": {"law": "linear", "gain": 0.5}});
    let rule = json!({"contact": {"rule": "wong_reece", "c1": 0.4, "c2": 0.1, "c3": -0.05}});
    let range = json!({"slip": {"from": -1, "to": 1, "points": 21}});
    let sideways = json!({"slip_angle_rad": -0.1, "shear_coupling": "coupled", "bulldozing": "mobilised",
        "soil": {"unit_weight_n_m3": 15_000, "lateral_shear_modulus_m": 0.004}});
    vec![
        ("/v1/forces", letter()),
        ("/v1/resistances", with(&letter(), json!({"sinkage_m": null, "normal_load_n": 80}))),
        ("/v1/forces", with(&letter(), sideways.clone())),
        ("/v1/slip-sweep", with(&with(&letter(), sideways), json!({"slip": range["slip"]}))),
        ("/v1/forces", solved.clone()),
        ("/v1/forces", exact),
        ("/v1/forces", moving.clone()),
        ("/v1/forces", with(&letter(), linear.clone())),
        ("/v1/stress-profile", with(&moving, json!({"points": 11, "peak_sinkage": "half"}))),
        ("/v1/stress-profile", with(&letter(), rule.clone())),
        ("/v1/slip-sweep", with(&solved, json!({"slip": null}))),
        ("/v1/slip-sweep", with(&with(&letter(), json!({"slip": null})), range.clone())),
        ("/v1/slip-sweep", with(&with(&with(&letter(), json!({"slip": null})), range), with(&rule, linear))),
    ]
}

#[test]
fn a_query_gives_the_bits_of_the_body_it_stands_for() {
    for (path, body) in bodies() {
        let (query, json) = (asked(path, &body), post(path, &body));
        assert_eq!((query.status, &query.text), (json.status, &json.text), "{path} {body}");
        assert_eq!(query.header("content-type"), json.header("content-type"));
        let table = get(&format!("{path}?{}&format=csv", query_of(&body)));
        assert_eq!(table.text, if json.status == 200 { post_for_csv(path, &body).text } else { json.text }, "{path} {body}");
    }
}

#[test]
fn faults_have_the_pointers_and_words_of_the_body() {
    for changes in [
        json!({"slip": 1.5, "soil": {"cohesion_pa": -5}}),
        json!({"wheel": {"radus_m": 1}, "methud": "explicit"}),
        json!({"soil": {"pressure_sinkage": {"law": "bekkr"}}}),
        json!({"sinkage_m": null}),
        json!({"static_sinkage_m": 0.01}),
        json!({"slip": {"from": 0}}),
        json!({"wheel": null}),
        json!({"wheel": 7}),
        json!({"sinkage_m": 0.3}),
        json!({"lambda_a": "exactly", "method": "explicit"}),
        json!({"contact": {"rule": "midpoint", "c1": 0.3}}),
    ] {
        // A text where an object stood replaces it in both.
        let mut body = with(&letter(), json!({}));
        for (name, change) in changes.as_object().expect("an object") {
            body = match change {
                Value::Object(_) | Value::Null if body[name].is_object() || change.is_null() => {
                    with(&body, json!({name: change}))
                }
                _ => with(&with(&body, json!({name: null})), json!({name: change})),
            };
        }
        let (query, json) = (asked("/v1/forces", &body), post("/v1/forces", &body));
        assert_eq!(query.problem(422), json.problem(422), "{body}");
    }
}

#[test]
fn what_is_no_json_number_is_refused() {
    let rest = query_of(&with(&letter(), json!({"slip": null})));
    for text in ["NaN", "inf", "-inf", "Infinity", "+0.2", ".2", "0,2", "", "0x1p-3", "1e999", "-1e999"] {
        let answer = get(&format!("/v1/forces?{rest}&slip={text}"));
        assert_eq!(answer.pointers(), ["/slip"], "{text}");
        assert!(answer.fault("/slip").starts_with("must be"), "{text}");
    }
}

#[test]
fn a_text_for_an_object_is_repeated() {
    let rest = query_of(&with(&letter(), json!({"soil": null})));
    assert_eq!(get(&format!("/v1/forces?{rest}&soil=sand")).fault("/soil"), "must be an object, not `sand`");
    let sweep = get("/v1/slip-sweep?wheel.preset=letter&soil.preset=letter-sand&sinkage_m=0.02&slip=0,0.1").fault("/slip");
    assert!(sweep.contains("`slip.from`, `slip.to` and `slip.points`"), "{sweep}");
}

#[test]
fn a_text_for_a_number_is_repeated() {
    let rest = query_of(&with(&letter(), json!({"sinkage_m": null})));
    for (text, said) in [
        ("80,5", "must be a number, not `80,5`, whose decimal point is a comma"),
        ("NaN", "must be a number, not `NaN`"),
        ("", "must be a number, not nothing"),
    ] {
        assert_eq!(get(&format!("/v1/forces?{rest}&normal_load_n={text}")).fault("/normal_load_n"), said);
    }
    let long = "x".repeat(5000);
    assert!(get(&format!("/v1/forces?{rest}&normal_load_n={long}")).fault("/normal_load_n").chars().count() < 100);
}

#[test]
fn a_repeated_name_is_refused_at_every_depth() {
    let whole = query_of(&letter());
    for (more, pointer) in [
        ("slip=0.2", "/slip"),
        ("%73lip=0.2", "/slip"),
        ("soil.cohesion_pa=0", "/soil/cohesion_pa"),
        ("soil.pressure_sinkage.n0=0.91", "/soil/pressure_sinkage/n0"),
        ("format=csv&format=csv", "/format"),
    ] {
        let answer = get(&format!("/v1/forces?{whole}&{more}"));
        assert_eq!(answer.fault(pointer), "is given more than once", "{more}");
        assert_eq!(answer.pointers(), [pointer]);
    }
    // A text and fields under one name.
    assert_eq!(get(&format!("/v1/forces?{whole}&soil=letter-sand")).fault("/soil"), "is given more than once");
}

#[test]
fn all_faults_are_named_at_once_with_the_format() {
    let answer = get(
        "/v1/forces?format=xml&slip=2&wheel.preset=leter&soil.preset=letter-sand&sinkage_m=0.02&nothing.at.all.here.is=known",
    );
    assert_eq!(answer.pointers(), ["/format", "/nothing", "/wheel/preset", "/slip"]);
    assert!(answer.fault("/wheel/preset").contains("did you mean `letter`?"));
    assert!(get("/v1/forces").pointers().contains(&"/wheel".to_owned()));
}

#[test]
fn a_query_of_no_sense_is_refused_in_bounded_time() {
    let deep = format!("/v1/forces?{}=1", "a.".repeat(30_000));
    assert_eq!(get(&deep).status, 422);
    let many = format!("/v1/forces?{}", "a=1&".repeat(15_000));
    assert_eq!(get(&many).fault(""), "the query may have at most 100 parameters");
    for odd in ["=", "&&&", "..=..", "%=%", "%ff=%fe", "a.=1&.a=2", "?slip=1"] {
        assert_eq!(get(&format!("/v1/forces?{odd}")).status, 422, "{odd}");
    }
}

#[test]
fn the_format_named_wins_over_the_header() {
    let query = query_of(&letter());
    let asked = |format: &str, accept: &str| {
        let answer = send(request("GET", &format!("/v1/forces?{query}{format}"), &[("accept", accept)], ""));
        assert_eq!(answer.status, 200);
        answer.header("content-type").split(';').next().expect("a type").to_owned()
    };
    assert_eq!(asked("", "text/csv"), "text/csv");
    assert_eq!(asked("&format=json", "text/csv"), "application/json");
    assert_eq!(asked("&format=csv", "application/json"), "text/csv");
    assert_eq!(asked("", "*/*"), "application/json");
}
