//! Bad requests: every failure is a problem document that says what to do.

use axum::body::Body;
use axum::routing::get as route_get;
use serde_json::{Value, json};
use terramechanics_server::{Limits, Service, contract, layered};
use tower::ServiceExt;

use crate::asking::{Answer, get, letter, post, post_text, request, runtime, send, send_to, with};

#[test]
fn all_faults_are_named_at_once() {
    let body = json!({
        "wheel": {"preset": "leter", "radus_m": 1},
        "soil": {"preset": "letter-sand", "cohesion_pa": -5, "pressure_sinkage": {"law": "bekker", "k_s": 3}},
        "slip": 2, "sinkage_m": "deep", "methd": "explicit", "lambda_a": "exactly"
    });
    let answer = post("/v1/forces", &body);
    let mut pointers = answer.pointers();
    pointers.sort();
    assert_eq!(
        pointers,
        [
            "/lambda_a",
            "/methd",
            "/sinkage_m",
            "/slip",
            "/soil/cohesion_pa",
            "/soil/pressure_sinkage/k_c",
            "/soil/pressure_sinkage/k_phi",
            "/soil/pressure_sinkage/k_s",
            "/soil/pressure_sinkage/n0",
            "/wheel/preset",
            "/wheel/radus_m",
        ]
    );
    for (pointer, hint) in [
        ("/wheel/radus_m", "did you mean `radius_m`?"),
        ("/wheel/preset", "did you mean `letter`?"),
        ("/methd", "did you mean `method`?"),
        ("/soil/cohesion_pa", "from 0 to 1e8, not -5"),
        ("/sinkage_m", "must be a number, not a string"),
    ] {
        assert!(answer.fault(pointer).contains(hint), "{}", answer.fault(pointer));
    }
}

#[test]
fn what_is_missing_is_named() {
    assert_eq!(post("/v1/forces", &json!({})).pointers(), ["/wheel", "/soil", "/sinkage_m", "/slip"]);
    let empty = json!({"wheel": {}, "soil": {}, "slip": 0, "sinkage_m": 0.01});
    let fields = ["/wheel/radius_m", "/wheel/width_m", "/soil/cohesion_pa", "/soil/friction_angle_rad", "/soil/shear_modulus_m"];
    assert_eq!(post("/v1/forces", &empty).pointers(), [fields.as_slice(), &["/soil/pressure_sinkage"]].concat());
    assert_eq!(post("/v1/forces", &with(&letter(), json!({"contact": {"c1": 0.4}}))).pointers(), ["/contact/rule"]);
    let law = with(&letter(), json!({"soil": {"pressure_sinkage": null}}));
    let law = with(&law, json!({"soil": {"pressure_sinkage": {"n0": 1}}}));
    assert_eq!(post("/v1/forces", &law).pointers(), ["/soil/pressure_sinkage/law"]);
}

#[test]
fn slip_and_sinkage_are_given_in_one_way() {
    let faults = |changes: Value| post("/v1/forces", &with(&letter(), changes)).pointers();
    assert_eq!(faults(json!({"static_sinkage_m": 0.01})), ["/sinkage_m", "/static_sinkage_m"]);
    assert_eq!(faults(json!({"sinkage_m": null})), ["/sinkage_m"]);
    assert_eq!(faults(json!({"forward_velocity_m_s": 1})), ["/slip"]);
    assert_eq!(faults(json!({"slip": null, "forward_velocity_m_s": 1})), ["/angular_velocity_rad_s"]);
    assert_eq!(faults(json!({"slip": null, "angular_velocity_rad_s": 1})), ["/forward_velocity_m_s"]);
    assert_eq!(faults(json!({"slip": null})), ["/slip"]);
}

#[test]
fn values_of_any_wrong_type_are_named() {
    for (value, found) in
        [(json!("a"), "a string"), (json!(true), "true"), (json!([1]), "an array"), (json!({"a": 1}), "an object")]
    {
        assert!(post("/v1/forces", &with(&letter(), json!({"slip": value}))).fault("/slip").ends_with(found));
    }
    for (name, value) in [("wheel", json!(3)), ("soil", json!("letter-sand")), ("contact", json!([]))] {
        assert!(
            post("/v1/forces", &with(&with(&letter(), json!({name: null})), json!({name: value})))
                .fault(&format!("/{name}"))
                .contains("object")
        );
    }
    for body in ["[]", "3", "\"text\"", "null", "true"] {
        assert_eq!(post_text("/v1/forces", body).pointers(), [""], "{body}");
    }
}

#[test]
fn a_name_given_twice_is_a_fault() {
    let body = letter().to_string().replace("\"slip\":0.2", "\"slip\":0.2,\"slip\":0.3");
    assert_eq!(post_text("/v1/forces", body).pointers(), ["/slip"]);
}

#[test]
fn unknown_names_are_escaped_cut_and_not_too_many() {
    let answer = post("/v1/forces", &with(&letter(), json!({"a/b~c": 1})));
    assert_eq!(answer.pointers(), ["/a~1b~0c"]);
    let many: serde_json::Map<String, Value> = (0..1000).map(|i| (format!("name{i}"), json!(i))).collect();
    let answer = post("/v1/forces", &with(&letter(), Value::Object(many)));
    assert!(answer.pointers().len() <= 20);
    let long = "x".repeat(100_000);
    assert!(post("/v1/forces", &with(&letter(), json!({long: 1}))).text.len() < 2000);
}

#[test]
fn broken_json_is_a_400_with_line_and_column() {
    for (body, line) in
        [("", 1), ("{", 1), ("{\n \"wheel\": {,}\n}", 2), ("{} x", 1), ("{\"slip\": NaN}", 1), ("{\"slip\": 1e999}", 1)]
    {
        let problem = post_text("/v1/forces", body).problem(400);
        assert_eq!(problem["line"], line, "{problem}");
        assert!(problem["column"].is_number());
        assert!(problem["detail"].as_str().expect("a detail").contains("column"));
    }
    post_text("/v1/forces", "[".repeat(100_000)).problem(400);
    post_text("/v1/forces", vec![b'{', 0xff, 0xfe]).problem(400);
}

#[test]
fn other_content_types_are_a_415() {
    for headers in [&[][..], &[("content-type", "text/plain")][..], &[("content-type", "application/x-www-form-urlencoded")][..]]
    {
        send(request("POST", "/v1/forces", headers, letter().to_string())).problem(415);
    }
    let declared = [("content-type", "application/json; charset=utf-8")];
    send(request("POST", "/v1/forces", &declared, letter().to_string())).ok();
}

#[test]
fn a_body_beyond_the_limit_is_a_413_declared_or_not() {
    let service = || Service::new(Limits { body: 1000, ..Limits::default() });
    let json = ("content-type", "application/json");
    let long = " ".repeat(1001);
    send_to(service(), request("POST", "/v1/forces", &[json, ("content-length", "1001")], long.clone())).problem(413);
    send_to(service(), request("POST", "/v1/forces", &[json], long)).problem(413);
    let padded = format!("{:<1000}", letter().to_string());
    send_to(service(), request("POST", "/v1/forces", &[json], padded)).ok();
}

/// Reading a long body takes a place on the pool; what it says is the same.
#[test]
fn a_long_body_is_read_like_a_short_one() {
    let padded = format!("{}{}", " ".repeat(500_000), letter());
    post_text("/v1/forces", padded).ok();
    let problem = post_text("/v1/forces", format!("{}{{", "\n".repeat(500_000))).problem(400);
    assert_eq!(problem["line"], 500_001);
}

#[test]
fn a_body_that_never_ends_is_a_408() {
    let limits = Limits { body_deadline: std::time::Duration::from_millis(50), ..Limits::default() };
    let never = Body::new(Never);
    send_to(Service::new(limits), request("POST", "/v1/forces", &[("content-type", "application/json")], never)).problem(408);
}

/// A body whose bytes do not come.
struct Never;

impl hyper::body::Body for Never {
    type Data = axum::body::Bytes;
    type Error = std::convert::Infallible;

    fn poll_frame(
        self: std::pin::Pin<&mut Self>,
        _: &mut std::task::Context<'_>,
    ) -> std::task::Poll<Option<Result<hyper::body::Frame<Self::Data>, Self::Error>>> {
        std::task::Poll::Pending
    }
}

#[test]
fn unknown_paths_and_methods_are_problems() {
    for path in ["/nope", "/v1", "/v1/forces/", "/static/nope.js", "/docs/nope", "/v1/wheels/a/b", "/static/..%2fCargo.toml"] {
        get(path).problem(404);
    }
    for (method, path, allow) in [("GET", "/v1/compare", "POST"), ("DELETE", "/v1/wheels", "GET,HEAD"), ("PUT", "/", "GET,HEAD")]
    {
        let answer = send(request(method, path, &[], Body::empty()));
        answer.problem(405);
        assert_eq!(answer.header("allow"), allow);
    }
}

#[test]
fn a_path_or_method_that_is_not_there_leads_to_one_that_is() {
    for (path, meant) in [("/v1/force", "/v1/forces"), ("/forces", "/v1/forces"), ("/v1/soils/", "/v1/soils")] {
        let detail = get(path).problem(404)["detail"].as_str().expect("a detail").to_owned();
        assert_eq!(detail, format!("no such path: {path}; did you mean {meant}?"));
    }
    for (method, path, use_instead) in [("GET", "/v1/compare", "use POST;"), ("DELETE", "/v1/forces", "use GET or POST;")] {
        let problem = send(request(method, path, &[], Body::empty())).problem(405);
        assert!(problem["detail"].as_str().expect("a detail").starts_with(use_instead), "{problem}");
    }
}

/// A parameter that has no effect is refused and not ignored.
#[test]
fn a_query_where_none_is_taken_is_refused() {
    let json = [("content-type", "application/json")];
    let answer = send(request("POST", "/v1/forces?format=csv", &json, letter().to_string()));
    assert!(answer.fault("/format").contains("Accept"), "{}", answer.text);
    for path in ["/v1/model", "/v1/validation", "/v1/wheels/letter", "/v1/soils/letter-sand", "/v1/validation/ding-2011-smooth"] {
        assert_eq!(get(&format!("{path}?frmat=csv")).pointers(), ["/frmat"], "{path}");
    }
    let set = get("/v1/validation/ding-2011-smooth?format=csv");
    assert!(set.header("content-type").starts_with("text/csv"), "{}", set.text);
    assert_eq!(get("/v1/validation/ding-2011-smooth?format=xml").pointers(), ["/format"]);
}

#[test]
fn a_name_or_a_number_of_another_habit_is_told_what_was_meant() {
    let fault = |changes: Value, pointer: &str| post("/v1/forces", &with(&letter(), changes)).fault(pointer);
    for (changes, pointer, end) in [
        (json!({"method": "exact"}), "/method", "did you mean `quadrature`?"),
        (json!({"soil": {"phi": 0.5}}), "/soil/phi", "did you mean `friction_angle_rad`?"),
        (json!({"soil": {"k_c": 0}}), "/soil/k_c", "`k_c` belongs in `pressure_sinkage`"),
        (json!({"soil": {"pressure_sinkage": {"n": 1}}}), "/soil/pressure_sinkage/n", "did you mean `n0`?"),
        (json!({"cohesion_pa": 0}), "/cohesion_pa", "`cohesion_pa` belongs in `soil`"),
        (json!({"sinkage_mm": 20}), "/sinkage_mm", "`sinkage_m` is in m: 1 mm is 0.001 m"),
        (json!({"wheel": {"radius_m": 125}}), "/wheel/radius_m", "125 mm are 0.125"),
        (json!({"soil": {"shear_modulus_m": 25}}), "/soil/shear_modulus_m", "25 mm are 0.025"),
        (json!({"sinkage_m": 20}), "/sinkage_m", "20 mm are 0.02"),
        (json!({"slip": 100}), "/slip", "100 % are 1"),
        (json!({"slip_sinkage": {"law": "lyasko", "gain": 1}}), "/slip_sinkage/gain", "it takes no further field"),
    ] {
        let said = fault(changes, pointer);
        assert!(said.ends_with(end), "{pointer}: {said}");
    }
    let towed = json!({"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "normal_load_n": 80, "slip": 0.1});
    assert!(post("/v1/towed", &towed).fault("/slip").starts_with("unknown field; "));
    let fit = |name: &str| post("/v1/identify", &json!({"fit": [name]})).fault("/fit/0");
    assert!(fit("n").ends_with("did you mean `n0`?") && fit("phi").ends_with("did you mean `friction_angle_rad`?"));
    let sweep = |slip: Value, pointer: &str| post("/v1/slip-sweep", &with(&letter(), json!({"slip": slip}))).fault(pointer);
    assert!(sweep(json!({"from": 0, "to": 100, "points": 11}), "/slip/to").ends_with("100 % are 1"));
    assert!(sweep(json!([0, 20]), "/slip/1").ends_with("20 % are 0.2"));
    let one = post("/v1/forces", &with(&letter(), json!({"sinkage_m": -1}))).problem(422);
    assert!(one["detail"].as_str().expect("a detail").starts_with("/sinkage_m: must be"), "{one}");
}

#[test]
fn a_panic_is_a_500_without_details_and_the_next_request_works() {
    let service = Service::new(Limits::default());
    async fn panics() -> &'static str {
        panic!("secret cause")
    }
    let app = layered(
        axum::Router::new().route("/panic", route_get(panics)).route("/fine", route_get(|| async { "fine" })),
        contract(),
        service,
    );
    let ask = |path: &'static str| {
        let app = app.clone();
        runtime().block_on(async move {
            let response = app.oneshot(request("GET", path, &[], Body::empty())).await.expect("an answer");
            let (parts, body) = response.into_parts();
            let bytes = axum::body::to_bytes(body, usize::MAX).await.expect("a body");
            Answer { status: parts.status, headers: parts.headers, text: String::from_utf8_lossy(&bytes).into_owned() }
        })
    };
    let answer = ask("/panic");
    answer.problem(500);
    assert!(!answer.text.contains("secret"));
    assert_eq!(ask("/fine").text, "fine");
}

#[test]
fn a_clients_request_id_comes_back_if_it_is_harmless() {
    let id =
        |sent: &str| send(request("GET", "/healthz", &[("x-request-id", sent)], Body::empty())).header("x-request-id").to_owned();
    assert_eq!(id("trace-7"), "trace-7");
    assert_ne!(id("a b"), "a b");
}

#[test]
fn whatever_is_sent_the_answer_is_no_500() {
    // Every value of the example replaced by each of these, and taken away.
    let odd = [
        json!(null),
        json!(0),
        json!(-1),
        json!(1e308),
        json!(-1e308),
        json!(5e-324),
        json!(""),
        json!([]),
        json!({}),
        json!(true),
    ];
    fn pointers(value: &Value, at: String, found: &mut Vec<String>) {
        if let Value::Object(fields) = value {
            for (name, value) in fields {
                found.push(format!("{at}/{name}"));
                pointers(value, format!("{at}/{name}"), found);
            }
        }
    }
    let base = with(
        &letter(),
        json!({"method": "explicit", "lambda_a": 0, "lambda_b": "exact", "peak_sinkage": "half", "normal_stress_radius": "rim",
               "contact": {"rule": "wong_reece", "c1": 0.4, "c2": 0.1, "c3": 0}}),
    );
    let mut found = Vec::new();
    pointers(&base, String::new(), &mut found);
    assert!(found.len() > 20);
    for pointer in found {
        for value in &odd {
            let mut body = base.clone();
            *body.pointer_mut(&pointer).expect("a field") = value.clone();
            let answer = post("/v1/forces", &body);
            if answer.status.as_u16() != 200 {
                answer.problem(422);
            } else {
                assert!(!answer.text.contains("null,\"normal_force_n\""));
            }
        }
    }
}

#[test]
fn the_type_of_a_problem_answers_with_its_meaning() {
    let failures = [
        (get("/nowhere"), 404),
        (get("/v1/forces"), 422),
        (post_text("/v1/forces", "{"), 400),
        (send(request("DELETE", "/v1/forces", &[], Body::empty())), 405),
        (send(request("POST", "/v1/forces", &[("content-type", "text/plain")], "x")), 415),
    ];
    for (failure, status) in failures {
        let problem = failure.problem(status);
        let kind = get(problem["type"].as_str().expect("an address")).json();
        assert_eq!(kind["status"], status);
        assert_eq!(kind["title"], problem["title"]);
        assert!(kind["meaning"].as_str().is_some_and(|text| text.len() > 20), "{kind}");
    }
    let all = get("/problems").json();
    let all = all["problems"].as_array().expect("kinds");
    for kind in all {
        assert_eq!(&get(&format!("/problems/{}", kind["name"].as_str().expect("a name"))).json(), kind);
    }
    assert!(all.len() >= 15);
    let unknown = get("/problems/bussy").problem(404);
    assert!(unknown["detail"].as_str().expect("words").contains("did you mean `busy`?"), "{unknown}");
}

/// A value in another unit is often the reason why there is no answer.
#[test]
fn a_failed_computation_says_which_values_may_be_in_another_unit() {
    let hinted = |path: &str, body: &Value| {
        let problem = post(path, body).problem(422);
        let warnings = problem["warnings"].as_array().unwrap_or_else(|| panic!("no warnings in {problem}")).clone();
        let hints = warnings.iter().map(|warning| (warning["code"].clone(), warning["pointer"].clone()));
        hints.collect::<Vec<_>>()
    };
    let is_far = |pointer: &str| (json!("outside_catalogue"), json!(pointer));
    // kPa in place of Pa, and k_phi in kN/m^(n+2).
    let soil = json!({
        "cohesion_pa": 1, "friction_angle_rad": 0.5, "shear_modulus_m": 0.015,
        "pressure_sinkage": {"law": "bekker", "k_c": 1.4, "k_phi": 820, "n0": 1}
    });
    let wheel = json!({"radius_m": 0.2, "width_m": 0.1});
    let under_load = json!({"wheel": wheel, "soil": soil, "slip": 0.2, "normal_load_n": 500});
    let k_phi = is_far("/soil/pressure_sinkage/k_phi");
    for path in ["/v1/forces", "/v1/stress-profile"] {
        assert!(hinted(path, &under_load).contains(&k_phi), "{path}");
    }
    assert!(hinted("/v1/towed", &with(&under_load, json!({"slip": null}))).contains(&k_phi));
    let rover = json!({"mass_kg": 200, "wheels": {"count": 4, "wheel": wheel}, "soil": soil});
    assert!(hinted("/v1/vehicle", &rover).contains(&k_phi));
    let search = json!({
        "of": "forces", "request": under_load, "maximise": "longitudinal_force_n",
        "variables": [{"field": "/slip", "from": 0.1, "to": 0.3}]
    });
    assert!(hinted("/v1/optimum", &search).contains(&k_phi));
    let rows = json!({"of": "forces", "request": under_load, "axes": [{"field": "/slip", "values": [0.1, 0.2]}]});
    let answer = post("/v1/sweep", &rows);
    assert_eq!(answer.ok()["columns"]["status"], json!(["no_solution", "no_solution"]));
    assert!(answer.warned_of().contains(&"outside_catalogue".to_owned()));
    // A request whose fields are wrong is not computed, and a failure without such a value has no hint.
    assert_eq!(post("/v1/forces", &with(&under_load, json!({"slip": 3}))).problem(422).get("warnings"), None);
    assert_eq!(
        post("/v1/forces", &with(&letter(), json!({"sinkage_m": null, "normal_load_n": 1e9}))).problem(422).get("warnings"),
        None
    );
}

/// What a newcomer is likely to have meant.
#[test]
fn a_fault_names_what_was_probably_meant() {
    let said = |path: &str, changes: Value, pointer: &str| post(path, &with(&letter(), changes)).fault(pointer);
    // 1 − v/(rω) = −1.2 has rω/v = 1/2.2, and rω/v − 1 = 1.5 has v/(rω) = 1/2.5.
    let below = said("/v1/forces", json!({"slip": -1.2}), "/slip");
    assert!(below.contains("1 − v/(rω)") && below.contains("-0.545"), "{below}");
    let above = said("/v1/forces", json!({"slip": 1.5}), "/slip");
    assert!(above.contains("rω/v − 1") && above.ends_with("0.6"), "{above}");
    let none = said("/v1/forces", json!({"slip": null}), "/slip");
    assert!(none.contains("`longitudinal_force_n`") && none.contains("`drawbar_coefficient`"), "{none}");
    let elsewhere = said("/v1/stress-profile", json!({"slip": null}), "/slip");
    assert!(!elsewhere.contains("drawbar"), "a profile does not solve the slip: {elsewhere}");
    let density = said(
        "/v1/forces",
        json!({"method": "resistive_force", "soil": {"preset": null, "friction_angle_rad": 0.5}}),
        "/soil/bulk_density_kg_m3",
    );
    assert!(density.contains("`granular_stiffness_n_m3`"), "{density}");
    for (changes, pointer, meant) in [
        (json!({"SLIP": 0.1}), "/SLIP", "did you mean `slip`?"),
        (json!({"weight_n": 80}), "/weight_n", "did you mean `normal_load_n`?"),
        (json!({"wheel": {"diameter_m": 0.4}}), "/wheel/diameter_m", "`radius_m` is half of the diameter"),
        (json!({"soil": {"Cohesion_Pa": 4}}), "/soil/Cohesion_Pa", "did you mean `cohesion_pa`?"),
    ] {
        let said = said("/v1/forces", changes, pointer);
        assert!(said.contains(meant), "{said}");
    }
    let data = json!({"slip": [0.1, 0.2], "sinkage_m": [12, 14], "torque_n_m": [1, 2]});
    let fit = json!({"wheel": {"preset": "letter"}, "soil": {"preset": "letter-sand"}, "fit": ["shear_modulus_m"], "data": data});
    assert!(post("/v1/identify", &fit).fault("/data/sinkage_m/0").contains("12 mm are 0.012"));
    let still = with(&letter(), json!({"slip": null, "forward_velocity_m_s": 0, "angular_velocity_rad_s": 0}));
    for path in ["/v1/forces", "/v1/stress-profile"] {
        assert!(post(path, &still).warned_of().contains(&"at_rest".to_owned()), "{path}");
    }
    assert!(!post("/v1/forces", &letter()).warned_of().contains(&"at_rest".to_owned()));
}
