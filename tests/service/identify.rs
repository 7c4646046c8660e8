//! `POST /v1/identify`.

use serde_json::{Value, json};

use crate::asking::{Answer, letter, post, post_for_csv, table, with};

const SLIPS: [f64; 9] = [0.05, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8];
const SINKAGES: [f64; 9] = [0.012, 0.03, 0.02, 0.01, 0.035, 0.015, 0.025, 0.012, 0.03];

/// What the service's own forces say of the letter's wheel, with some changes of the soil, by a method.
fn measured(changes: &Value, method: &str) -> Value {
    let mut columns = json!({"slip": SLIPS, "sinkage_m": SINKAGES});
    let points: Vec<Value> = SLIPS
        .iter()
        .zip(SINKAGES)
        .map(|(slip, sinkage)| {
            let point = json!({"slip": slip, "sinkage_m": sinkage, "method": method});
            post("/v1/forces", &with(&with(&letter(), changes.clone()), point)).ok()
        })
        .collect();
    for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m"] {
        columns[name] = points.iter().map(|point| point[name].clone()).collect();
    }
    columns
}

fn cohesive() -> Value {
    json!({"soil": {"cohesion_pa": 400, "shear_modulus_m": 0.015}})
}

/// A fit that knows nothing of the soil.
fn request(method: &str) -> Value {
    json!({
        "wheel": {"radius_m": 0.2, "width_m": 0.1}, "soil": {}, "method": method,
        "fit": ["cohesion_pa", "friction_angle_rad", "shear_modulus_m", "k_s", "n0"],
        "data": measured(&cohesive(), method)
    })
}

fn estimate(reply: &Value, name: &str) -> Value {
    let estimates = reply["estimates"].as_array().expect("estimates");
    estimates.iter().find(|estimate| estimate["parameter"] == name).unwrap_or_else(|| panic!("no {name}")).clone()
}

fn value(reply: &Value, name: &str) -> f64 {
    estimate(reply, name)["value"].as_f64().expect("a number")
}

fn codes(reply: &Value) -> Vec<String> {
    let warnings = reply["warnings"].as_array().expect("warnings");
    warnings.iter().map(|warning| warning["code"].as_str().expect("a code").to_owned()).collect()
}

/// The letter's soil has K_s = 754 130 − 660/0.1 on a wheel of 0.1 m.
#[test]
fn the_soil_behind_forces_is_found_by_every_method() {
    for method in ["quadrature", "linearised", "explicit"] {
        let reply = post("/v1/identify", &request(method)).ok();
        assert_eq!((&reply["converged"], &reply["identifiable"]), (&json!(true), &json!(true)), "{reply}");
        for (name, expected) in
            [("cohesion_pa", 400.0), ("friction_angle_rad", 0.478), ("shear_modulus_m", 0.015), ("k_s", 747_530.0), ("n0", 0.91)]
        {
            assert!((value(&reply, name) / expected - 1.0).abs() < 1e-6, "{method} {name}: {}", estimate(&reply, name));
            let [lower, upper] = [0, 1].map(|end| estimate(&reply, name)["interval_95"][end].as_f64().expect("an end"));
            assert!(lower <= value(&reply, name) && value(&reply, name) <= upper);
        }
        assert!(reply["rmse"]["torque_n_m"].as_f64().expect("a number") < 1e-6);
        assert_eq!(codes(&reply), ["may_be_the_interface"], "the wheel has no lugs");
    }
}

#[test]
fn the_soil_of_the_answer_is_ready_to_be_used() {
    let reply = post("/v1/identify", &request("quadrature")).ok();
    let body = json!({"wheel": {"radius_m": 0.2, "width_m": 0.1}, "soil": reply["soil"], "contact": reply["contact"], "slip": 0.3, "sinkage_m": 0.02});
    let forces = post("/v1/forces", &body).ok();
    let known = post("/v1/forces", &with(&with(&letter(), cohesive()), json!({"slip": 0.3}))).ok();
    let torque = |reply: &Value| reply["torque_n_m"].as_f64().expect("a torque");
    assert!((torque(&forces) / torque(&known) - 1.0).abs() < 1e-6);
}

#[test]
fn without_a_sinkage_the_normal_force_is_the_load() {
    let body = with(&request("explicit"), json!({"data": {"sinkage_m": null}, "start": {"k_s": 5e5}}));
    let reply = post("/v1/identify", &body).ok();
    assert_eq!(reply["rmse"].as_object().expect("columns").keys().collect::<Vec<_>>(), ["longitudinal_force_n", "torque_n_m"]);
    let with_law = with(
        &body,
        json!({"fit": ["cohesion_pa", "friction_angle_rad", "shear_modulus_m"], "start": null,
        "soil": {"pressure_sinkage": {"law": "direct", "k_s": 747_530, "n0": 0.91}}}),
    );
    let reply = post("/v1/identify", &with_law).ok();
    assert!((value(&reply, "friction_angle_rad") / 0.478 - 1.0).abs() < 1e-6, "{reply}");
    let sinkage = reply["columns"]["sinkage_m"][1].as_f64().expect("a sinkage");
    assert!((sinkage / SINKAGES[1] - 1.0).abs() < 1e-6, "the sinkage is solved");
}

#[test]
fn columns_are_measured_predicted_and_their_difference_and_a_table() {
    let body = with(
        &request("linearised"),
        json!({"fit": ["friction_angle_rad"], "soil": {"cohesion_pa": 0, "shear_modulus_m": 0.02,
        "pressure_sinkage": {"law": "direct", "k_s": 7e5, "n0": 1}}}),
    );
    let reply = post("/v1/identify", &body).ok();
    let column = |name: &str| -> Vec<f64> {
        let column = reply["columns"][name].as_array().unwrap_or_else(|| panic!("no {name}"));
        column.iter().map(|value| value.as_f64().expect("a number")).collect()
    };
    assert_eq!(reply["columns"]["measured_torque_n_m"], body["data"]["torque_n_m"]);
    let squares: f64 = column("residual_torque_n_m").iter().map(|residual| residual * residual).sum();
    assert!((reply["rmse"]["torque_n_m"].as_f64().expect("a number") / (squares / 9.0).sqrt() - 1.0).abs() < 1e-12);
    for ((residual, predicted), measured) in
        column("residual_torque_n_m").iter().zip(column("predicted_torque_n_m")).zip(column("measured_torque_n_m"))
    {
        assert_eq!(*residual, predicted - measured);
    }
    let table = table(&post_for_csv("/v1/identify", &body).text);
    assert_eq!(table.len(), 11);
    assert_eq!((table[0].0.as_str(), table[10].0.as_str(), table[0].1.len()), ("slip", "residual_torque_n_m", 9));
}

/// The data of the API's own words: one slip, one load, only F_z.
#[test]
fn what_cannot_be_unique_is_never_converged_without_saying_so() {
    let all = request("quadrature");
    let one_slip: Vec<Value> = SINKAGES
        .iter()
        .map(|sinkage| post("/v1/forces", &with(&with(&letter(), cohesive()), json!({"slip": 0.3, "sinkage_m": sinkage}))).ok())
        .collect();
    let of_one_slip = |name: &str| -> Value { one_slip.iter().map(|point| point[name].clone()).collect() };
    let single_slip = json!({"data": {"slip": [0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3], "torque_n_m": of_one_slip("torque_n_m"),
        "longitudinal_force_n": of_one_slip("longitudinal_force_n"), "normal_force_n": of_one_slip("normal_force_n")}});
    let only_normal = json!({"data": {"torque_n_m": null, "longitudinal_force_n": null}});
    let single_load = json!({"data": {"sinkage_m": null, "normal_force_n": vec![60.0; 9]}});
    for (design, code) in [(single_slip, "single_slip"), (only_normal, "normal_force_only"), (single_load, "single_load")] {
        let reply = post("/v1/identify", &with(&all, design)).ok();
        assert_eq!(reply["identifiable"], false, "{code}: {reply}");
        assert!(codes(&reply).contains(&code.to_owned()) && codes(&reply).contains(&"not_identifiable".to_owned()), "{reply}");
        let words = estimate(&reply, "shear_modulus_m")["identifiability"].as_str().expect("words").to_owned();
        assert!(code == "single_load" || words.starts_with("not determined"), "{words}");
    }
    // n0 and n1 at one slip: a dead direction.
    let exponents = json!({"fit": ["n0", "n1"], "soil": {"cohesion_pa": 400, "friction_angle_rad": 0.478, "shear_modulus_m": 0.015,
        "pressure_sinkage": {"law": "direct", "k_s": 747_530}}, "data": {"slip": vec![0.3; 9]}});
    let reply = post("/v1/identify", &with(&all, exponents)).ok();
    assert_eq!((&reply["identifiable"], &reply["condition_number"]), (&json!(false), &Value::Null));
    assert_eq!(estimate(&reply, "n0")["standard_error"], Value::Null);
    assert!(estimate(&reply, "n0")["identifiability"].as_str().expect("words").contains("together with n1"));
    assert_eq!(reply["dead_directions"].as_array().map(Vec::len), Some(1));
}

#[test]
fn one_load_is_flagged_without_its_column_and_so_is_one_point() {
    let point = |slip: f64| {
        post("/v1/forces", &with(&with(&letter(), cohesive()), json!({"slip": slip, "sinkage_m": null, "normal_load_n": 80})))
            .ok()
    };
    let points = SLIPS.map(point);
    let of = |name: &str| -> Value { points.iter().map(|point| point[name].clone()).collect() };
    let data = json!({"slip": SLIPS, "sinkage_m": of("sinkage_m"), "torque_n_m": of("torque_n_m"), "longitudinal_force_n": of("longitudinal_force_n")});
    let mut body = request("quadrature");
    body["data"] = data;
    let reply = post("/v1/identify", &body).ok();
    assert_eq!(reply["identifiable"], false, "{reply}");
    assert!(codes(&reply).contains(&"single_load".to_owned()), "{:?}", codes(&reply));
    let first = |name: &str| vec![request("explicit")["data"][name][3].clone(); 6];
    let columns = ["slip", "sinkage_m", "torque_n_m", "longitudinal_force_n", "normal_force_n"];
    let repeated: serde_json::Map<String, Value> = columns.iter().map(|name| ((*name).to_owned(), json!(first(name)))).collect();
    let mut body = with(
        &request("explicit"),
        json!({"fit": ["friction_angle_rad", "k_s", "lambda_a"], "lambda_a": 0.0,
        "soil": {"cohesion_pa": 400, "shear_modulus_m": 0.015, "pressure_sinkage": {"law": "direct", "n0": 0.91}}}),
    );
    body["data"] = Value::Object(repeated);
    let reply = post("/v1/identify", &body).ok();
    assert_eq!(reply["identifiable"], false, "{reply}");
    assert!(codes(&reply).contains(&"few_points".to_owned()), "{:?}", codes(&reply));
}

/// Forces in kN beside a torque in N·m: the torque is not met at all.
#[test]
fn a_column_in_another_unit_is_said_to_be_missed() {
    let mut body = request("linearised");
    for name in ["longitudinal_force_n", "normal_force_n"] {
        let values = body["data"][name].as_array_mut().expect("a column");
        values.iter_mut().for_each(|value| *value = json!(1e-3 * value.as_f64().expect("a number")));
    }
    let reply = post("/v1/identify", &body).ok();
    assert!(codes(&reply).contains(&"column_missed".to_owned()), "{reply}");
    let warnings = reply["warnings"].as_array().expect("warnings");
    let missed = warnings.iter().find(|warning| warning["code"] == "column_missed").expect("a warning");
    assert_eq!((&missed["quantity"], &missed["unit"]), (&json!("torque_n_m"), &json!("N.m")));
    assert_eq!(missed["value"], reply["rmse"]["torque_n_m"]);
}

#[test]
fn deviations_far_beyond_the_residuals_are_called_too_large() {
    let deviations = json!({"standard_deviation": {"longitudinal_force_n": 5, "normal_force_n": 5, "torque_n_m": 0.5}});
    let reply = post("/v1/identify", &with(&request("explicit"), deviations.clone())).ok();
    assert_eq!(codes(&reply), ["deviations_too_large", "may_be_the_interface"]);
    // Only their ratios count.
    let tenth = json!({"standard_deviation": {"longitudinal_force_n": 0.5, "normal_force_n": 0.5, "torque_n_m": 0.05}});
    let mut body = with(&request("explicit"), deviations);
    body["data"]["torque_n_m"][2] = json!(body["data"]["torque_n_m"][2].as_f64().expect("a number") + 0.1);
    let errors = |body: &Value| -> Vec<f64> {
        let reply = post("/v1/identify", body).ok();
        let estimates = reply["estimates"].as_array().expect("estimates").clone();
        estimates.iter().map(|one| one["standard_error"].as_f64().expect("an error")).collect()
    };
    for (large, small) in errors(&body).iter().zip(errors(&with(&body, tenth))) {
        assert!((large / small - 1.0).abs() < 1e-4, "{large} {small}");
    }
}

#[test]
fn an_estimate_at_a_bound_says_so() {
    let body =
        with(&request("explicit"), json!({"bounds": {"friction_angle_rad": [0.1, 0.4]}, "start": {"friction_angle_rad": 0.3}}));
    let reply = post("/v1/identify", &body).ok();
    let angle = estimate(&reply, "friction_angle_rad");
    assert_eq!((&angle["value"], &angle["at_bound"]), (&json!(0.4), &json!(true)), "{reply}");
    assert!(codes(&reply).contains(&"at_bound".to_owned()));
}

#[test]
fn a_preset_gives_starts_and_its_law_gives_way_to_a_fitted_modulus() {
    let body = with(&request("explicit"), json!({"soil": {"preset": "letter-sand"}, "fit": ["cohesion_pa", "shear_modulus_m"]}));
    let reply = post("/v1/identify", &body).ok();
    assert!((value(&reply, "shear_modulus_m") / 0.015 - 1.0).abs() < 1e-6);
    let reply = post("/v1/identify", &with(&body, json!({"fit": ["cohesion_pa", "shear_modulus_m", "k_s"]}))).ok();
    assert_eq!(
        (codes(&reply), &reply["soil"]["pressure_sinkage"]["law"]),
        (["may_be_the_interface", "law_replaced"].map(str::to_owned).to_vec(), &json!("direct"))
    );
    assert!((value(&reply, "k_s") / 747_530.0 - 1.0).abs() < 1e-6);
}

#[test]
fn every_parameter_can_be_fitted() {
    let fits = [
        json!({"fit": ["c1", "c2"], "contact": {"rule": "wong_reece"}}),
        json!({"fit": ["c1"]}),
        json!({"fit": ["lambda_a", "lambda_b"]}),
        json!({"fit": ["static_sinkage_m"], "slip_sinkage": {"law": "linear", "gain": 1}}),
        json!({"fit": ["k_phi", "n1"]}),
        json!({"fit": ["k_c"]}),
    ];
    for fit in fits {
        let base = with(&request("explicit"), json!({"soil": letter()["soil"]}));
        let reply = post("/v1/identify", &with(&base, fit.clone())).ok();
        assert!(reply["estimates"].as_array().is_some_and(|estimates| !estimates.is_empty()), "{fit}: {reply}");
        assert!(reply["converged"].as_bool().expect("a word") || !codes(&reply).is_empty());
    }
}

#[test]
fn outliers_and_deviations_and_starts_are_taken() {
    let mut body = with(&request("explicit"), json!({"loss": "cauchy", "starts": 4}));
    body["data"]["torque_n_m"][4] = json!(90.0);
    let reply = post("/v1/identify", &body).ok();
    assert!((value(&reply, "friction_angle_rad") / 0.478 - 1.0).abs() < 1e-3, "{reply}");
    let deviations = json!({"longitudinal_force_n": 0.5, "normal_force_n": vec![2.0; 9], "torque_n_m": 0.05});
    let reply = post("/v1/identify", &with(&request("explicit"), json!({"standard_deviation": deviations}))).ok();
    assert!(reply["reduced_chi_square"].as_f64().expect("a number") < 1e-6);
}

/// What the closed forms say of a wheel, for the linear estimator, which knows nothing but the shear modulus.
fn line_request() -> Value {
    json!({"wheel": {"radius_m": 0.2, "width_m": 0.1}, "soil": {"shear_modulus_m": 0.015}, "estimator": "linear",
        "fit": ["cohesion_pa", "friction_angle_rad"], "data": measured(&cohesive(), "linearised")})
}

#[test]
fn the_linear_estimator_finds_the_strength_in_one_pass() {
    let reply = post("/v1/identify", &line_request()).ok();
    assert!((value(&reply, "cohesion_pa") / 400.0 - 1.0).abs() < 1e-6, "{reply}");
    assert!((value(&reply, "friction_angle_rad") / 0.478 - 1.0).abs() < 1e-9);
    assert_eq!((&reply["converged"], &reply["identifiable"]), (&json!(true), &json!(true)));
    assert_eq!(codes(&reply), ["linearised_stresses"]);
    assert!(estimate(&reply, "cohesion_pa").get("model_bias").is_none(), "no law, no simulation");
    assert!(reply["soil"].get("pressure_sinkage").is_none(), "none was sent");
    // Its soil with a law is one for requests; so is one whose catalogue has the law.
    let named = post("/v1/identify", &with(&line_request(), json!({"soil": {"preset": "letter-sand"}}))).ok();
    assert_eq!(named["soil"]["pressure_sinkage"]["law"], "bekker");
}

/// The contact is not the published one only.
#[test]
fn the_linear_estimator_takes_the_contact_and_the_radius() {
    let around = json!({"contact": {"rule": "wong_reece", "c1": 0.4, "c2": 0.2, "c3": -0.1}, "normal_stress_radius": "shearing",
        "wheel": {"lug_height_m": 0.01}});
    let body = with(&with(&line_request(), around.clone()), json!({"data": measured(&with(&cohesive(), around), "linearised")}));
    let reply = post("/v1/identify", &body).ok();
    assert!((value(&reply, "cohesion_pa") / 400.0 - 1.0).abs() < 1e-6, "{reply}");
    let other = post("/v1/identify", &with(&body, json!({"contact": null}))).ok();
    assert!((value(&other, "cohesion_pa") / 400.0 - 1.0).abs() > 0.05, "{other}");
}

#[test]
fn the_linear_estimator_refuses_what_has_no_meaning_for_it() {
    let faults = |changes: Value| post("/v1/identify", &with(&line_request(), changes)).pointers();
    assert_eq!(faults(json!({"fit": ["cohesion_pa"], "soil": {"friction_angle_rad": 0.5}})), ["/fit"]);
    assert_eq!(faults(json!({"data": {"torque_n_m": null}})), ["/data/torque_n_m"]);
    assert_eq!(faults(json!({"data": {"normal_force_n": vec![0.0; 9]}})), ["/data/normal_force_n/0"]);
    let idle =
        json!({"starts": 3, "loss": "huber", "method": "explicit", "peak_sinkage": "half", "lambda_a": 0.1, "lambda_b": 0});
    let mut pointers = faults(idle);
    pointers.sort();
    assert_eq!(pointers, ["/lambda_a", "/lambda_b", "/loss", "/method", "/peak_sinkage", "/starts"]);
    assert_eq!(post("/v1/identify", &with(&line_request(), json!({"method": "linearised"}))).status, 200);
    let shear = json!({"soil": {"shear": {"law": "wong_peak", "peak_displacement_m": 0.02}}});
    assert_eq!(faults(shear), ["/soil/shear"]);
    let alike = json!({"data": {"slip": [0.2, 0.2], "sinkage_m": [0.02, 0.02], "normal_force_n": [80, 80], "torque_n_m": [7, 7], "longitudinal_force_n": null}});
    assert_eq!(faults(alike), ["/data"]);
    assert_eq!(faults(json!({"soil": {"shear_modulus_m": null}})), ["/soil/shear_modulus_m"]);
}

/// A wheel of 0.125 m with lugs under five loads, by the quadrature: both intervals miss the truth, and the answer says by how much.
#[test]
fn the_bias_of_linear_stresses_is_told() {
    let soil = json!({"cohesion_pa": 800, "friction_angle_rad": 0.52, "shear_modulus_m": 0.012,
        "pressure_sinkage": {"law": "direct", "k_s": 9e5, "n0": 0.9}});
    let base = json!({"wheel": {"radius_m": 0.125, "width_m": 0.1, "lug_height_m": 0.012}, "soil": soil});
    let (mut slips, mut sinkages, mut loads, mut torques) = (vec![], vec![], vec![], vec![]);
    for load in [20, 40, 60, 80, 100] {
        for slip in [0.1, 0.3, 0.6] {
            let forces = post("/v1/forces", &with(&base, json!({"slip": slip, "normal_load_n": load}))).ok();
            slips.push(json!(slip));
            loads.push(json!(load));
            sinkages.push(forces["sinkage_m"].clone());
            torques.push(forces["torque_n_m"].clone());
        }
    }
    let data = json!({"slip": slips, "sinkage_m": sinkages, "normal_force_n": loads, "torque_n_m": torques});
    let body = with(&base, json!({"estimator": "linear", "fit": ["cohesion_pa", "friction_angle_rad"], "data": data}));
    let reply = post("/v1/identify", &body).ok();
    assert_eq!(codes(&reply), ["linearised_stresses", "model_bias", "model_bias"], "{reply}");
    for (name, truth) in [("cohesion_pa", 800.0), ("friction_angle_rad", 0.52)] {
        let found = estimate(&reply, name);
        let [lower, upper] = [0, 1].map(|end| found["interval_95"][end].as_f64().expect("an end"));
        assert!(!(lower..=upper).contains(&truth), "{found}");
        let bias = found["model_bias"].as_f64().expect("a bias");
        assert!(((value(&reply, name) - bias) / truth - 1.0).abs() < 0.02, "{found}");
    }
}

/// One load, one slip: the line has small errors, and they mean nothing.
#[test]
fn a_line_through_samples_of_one_kind_is_flagged() {
    for (slips, sinkages, code) in
        [([0.1, 0.2, 0.4, 0.6], [0.02; 4], "single_load"), ([0.3; 4], [0.01, 0.02, 0.03, 0.035], "single_slip")]
    {
        let points: Vec<Value> = slips
            .iter()
            .zip(sinkages)
            .map(|(slip, sinkage)| {
                let point = json!({"slip": slip, "sinkage_m": sinkage, "method": "explicit"});
                post("/v1/forces", &with(&with(&letter(), cohesive()), point)).ok()
            })
            .collect();
        let column = |name: &str| points.iter().map(|point| point[name].clone()).collect::<Vec<_>>();
        let load = if code == "single_load" { vec![json!(100.0); 4] } else { column("normal_force_n") };
        let data = json!({"slip": slips, "sinkage_m": sinkages, "normal_force_n": load, "torque_n_m": column("torque_n_m"), "longitudinal_force_n": null});
        let reply = post("/v1/identify", &with(&line_request(), json!({ "data": data }))).ok();
        assert_eq!(reply["identifiable"], false, "{reply}");
        assert!(codes(&reply).contains(&code.to_owned()) && codes(&reply).contains(&"not_identifiable".to_owned()), "{reply}");
        for name in ["cohesion_pa", "friction_angle_rad"] {
            let words = estimate(&reply, name)["identifiability"].as_str().expect("words").to_owned();
            assert!(words.starts_with("not determined by data of this kind"), "{words}");
        }
    }
}

fn refused(changes: Value) -> Answer {
    post("/v1/identify", &with(&request("linearised"), changes))
}

#[test]
fn bad_data_are_pointed_at() {
    let faults = |changes: Value| refused(changes).pointers();
    assert_eq!(faults(json!({"data": {"torque_n_m": [1, 2]}})), ["/data/torque_n_m"]);
    let holes = json!([0.1, "0.2", null, 0.3, 7, 0.3, 0.3, 0.3, 0.3]);
    assert_eq!(faults(json!({"data": {"slip": holes}})), ["/data/slip/1", "/data/slip/2", "/data/slip/4"]);
    assert_eq!(faults(json!({"data": {"slip": []}})), ["/data/slip"]);
    assert_eq!(
        faults(json!({"data": {"sinkage_m": [0.01, 0.3, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01, 0.01]}})),
        ["/data/sinkage_m/1"]
    );
    assert_eq!(faults(json!({"data": {"slip": vec![2.0; 30]}})).len(), 11, "ten are listed, the others are counted");
    assert_eq!(faults(json!({"data": {"sinkage_m": null, "normal_force_n": null}})), ["/data"]);
    assert_eq!(faults(json!({"data": {"sinkage_m": null, "normal_force_n": vec![-1.0; 9]}})), ["/data/normal_force_n/0"]);
    assert_eq!(faults(json!({"data": {"torque_n_m": null, "normal_force_n": null, "longitudinal_force_n": null}})), ["/data"]);
    assert_eq!(faults(json!({"data": {"slip": vec![0.1; 10_002]}})), ["/data/slip"]);
    assert_eq!(refused(json!({"data": {"torque": [1]}})).fault("/data/torque"), "unknown field; did you mean `torque_n_m`?");
}

#[test]
fn bad_parameters_are_pointed_at() {
    let faults = |changes: Value| refused(changes).pointers();
    assert_eq!(refused(json!({"fit": ["cohesion"]})).fault("/fit/0"), "unknown name `cohesion`; did you mean `cohesion_pa`?");
    assert_eq!(faults(json!({"fit": ["k_s", "k_s", 3]})), ["/fit/1", "/fit/2"]);
    assert_eq!(faults(json!({"fit": []})), ["/fit"]);
    assert_eq!(faults(json!({"fit": null})), ["/fit"]);
    assert_eq!(faults(json!({"soil": letter()["soil"], "fit": ["k_s"]})), ["/fit/0"]);
    assert_eq!(faults(json!({"soil": letter()["soil"], "fit": ["lambda_a"]})), ["/fit/0"]);
    assert_eq!(
        faults(json!({"fit": ["n0"]})),
        ["/soil/cohesion_pa", "/soil/friction_angle_rad", "/soil/shear_modulus_m", "/soil/pressure_sinkage"]
    );
    assert_eq!(
        refused(json!({"soil": null, "fit": ["n0", "cohesion_pa", "k_c"]})).fault("/soil"),
        "a soil is needed: neither given nor fitted are friction_angle_rad, shear_modulus_m, k_phi"
    );
    let fault = refused(json!({"soil": letter()["soil"], "fit": ["k_s"]})).fault("/fit/0");
    assert!(fault.ends_with("fit `k_c` and `k_phi`, or choose the law `direct`"), "{fault}");
    assert_eq!(faults(json!({"bounds": {"n0": [2, 1]}})), ["/bounds/n0"]);
    assert_eq!(faults(json!({"bounds": {"n0": [0, 1]}})), ["/bounds/n0/0"]);
    assert_eq!(faults(json!({"bounds": {"n0": [1]}, "start": {"c1": 0.4}})), ["/start/c1", "/bounds/n0"]);
    assert_eq!(faults(json!({"bounds": {"n0": [0.5, 1]}, "start": {"n0": 2}})), ["/start/n0"]);
    assert_eq!(
        faults(json!({"standard_deviation": {"torque_n_m": 0.1}})),
        ["/standard_deviation/longitudinal_force_n", "/standard_deviation/normal_force_n"]
    );
    assert_eq!(faults(json!({"standard_deviation": {"torque_n_m": [1, 2]}})), ["/standard_deviation/torque_n_m"]);
    assert_eq!(faults(json!({"slip_sinkage": {"law": "lyasko"}})), ["/slip_sinkage"]);
    assert_eq!(faults(json!({"loss": "hubber", "estimator": "magic", "starts": 33})).len(), 3);
}

/// A wheel that needs more than the soil could carry at any start is an answer, not a failure of the service.
#[test]
fn data_that_the_model_cannot_explain_are_refused_with_the_row() {
    let body = json!({"bounds": {"k_s": [1, 10], "n0": [0.9, 1]}, "start": {"k_s": 5, "n0": 1}, "data": {"sinkage_m": null}});
    assert_eq!(refused(body).pointers(), ["/data/normal_force_n/0"]);
}

/// Every value of a request replaced by odd ones: an answer of the documented shape or a refusal, nothing else.
#[test]
fn whatever_is_sent_the_answer_is_no_500() {
    fn pointers(value: &Value, at: &str, found: &mut Vec<String>) {
        let children: Vec<(String, &Value)> = match value {
            Value::Object(fields) => fields.iter().map(|(name, value)| (name.clone(), value)).collect(),
            Value::Array(items) => items.iter().enumerate().take(2).map(|(i, value)| (i.to_string(), value)).collect(),
            _ => Vec::new(),
        };
        for (name, value) in children {
            let pointer = format!("{at}/{name}");
            found.push(pointer.clone());
            pointers(value, &pointer, found);
        }
    }
    let changes = json!({"soil": letter()["soil"], "fit": ["cohesion_pa", "friction_angle_rad", "n0"], "starts": 2, "loss": "huber",
        "contact": {"rule": "wong_reece", "c1": 0.4, "c2": 0.1}, "bounds": {"n0": [0.5, 1.5]}, "start": {"cohesion_pa": 10},
        "standard_deviation": {"longitudinal_force_n": 1, "normal_force_n": 1, "torque_n_m": vec![0.1; 9]}});
    let base = with(&request("explicit"), changes);
    let mut found = Vec::new();
    pointers(&base, "", &mut found);
    assert!(found.len() > 40);
    let odd = [
        json!(null),
        json!(0),
        json!(-1),
        json!(1e12),
        json!(-1e12),
        json!(5e-324),
        json!(""),
        json!([]),
        json!({}),
        json!(true),
    ];
    for pointer in found {
        for value in &odd {
            let mut body = base.clone();
            *body.pointer_mut(&pointer).expect("a field") = value.clone();
            let answer = post("/v1/identify", &body);
            if answer.status == 200 {
                let reply = answer.json();
                assert!(reply["estimates"].as_array().is_some_and(|all| all.iter().all(|one| one["value"].is_number())));
                assert!(reply["rmse"].as_object().is_some_and(|all| all.values().all(Value::is_number)), "{pointer} = {value}");
            } else {
                answer.problem(422);
            }
        }
    }
}

/// A column whose squares vanish, and one whose load is next to nothing: an answer or a fault, and in time.
#[test]
fn measurements_of_any_size_are_answered() {
    let body = |normal: f64, torque: f64| {
        json!({
            "wheel": {"radius_m": 0.15, "width_m": 0.12},
            "soil": {"cohesion_pa": 600, "shear_modulus_m": 0.012, "pressure_sinkage": {"law": "direct", "k_s": 9e5, "n0": 0.9}},
            "fit": ["friction_angle_rad"],
            "data": {"slip": [0.1, 0.3], "normal_force_n": [normal, 2.0 * normal], "torque_n_m": [torque, torque]}
        })
    };
    assert!(post("/v1/identify", &body(60.0, 1e-200)).fault("/data/torque_n_m").contains("1e-100"));
    assert!(post("/v1/identify", &body(1e-200, 1.0)).fault("/data/normal_force_n").contains("1e-100"));
    assert!(post("/v1/identify", &body(60.0, 1e12)).ok()["estimates"][0]["value"].is_number());
}
