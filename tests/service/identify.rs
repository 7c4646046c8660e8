//! `POST /v1/identify`.

use serde_json::{Value, json};

use crate::asking::{letter, post, post_for_csv, table, with};

const SLIPS: [f64; 9] = [0.05, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8];
const SINKAGES: [f64; 9] = [0.012, 0.03, 0.02, 0.01, 0.035, 0.015, 0.025, 0.012, 0.03];

/// What the service's own forces say of the letter's wheel, with some changes of the soil, by a method.
pub(crate) fn measured(changes: &Value, method: &str) -> Value {
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

pub(crate) fn cohesive() -> Value {
    json!({"soil": {"cohesion_pa": 400, "shear_modulus_m": 0.015}})
}

/// A fit that knows nothing of the soil.
pub(crate) fn request(method: &str) -> Value {
    json!({
        "wheel": {"radius_m": 0.2, "width_m": 0.1}, "soil": {}, "method": method,
        "fit": ["cohesion_pa", "friction_angle_rad", "shear_modulus_m", "k_s", "n0"],
        "data": measured(&cohesive(), method)
    })
}

pub(crate) fn estimate(reply: &Value, name: &str) -> Value {
    let estimates = reply["estimates"].as_array().expect("estimates");
    estimates.iter().find(|estimate| estimate["parameter"] == name).unwrap_or_else(|| panic!("no {name}")).clone()
}

pub(crate) fn value(reply: &Value, name: &str) -> f64 {
    estimate(reply, name)["value"].as_f64().expect("a number")
}

pub(crate) fn codes(reply: &Value) -> Vec<String> {
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
    assert_eq!(estimate(&reply, "n0")["known"], json!({"code": "inseparable", "tied_to": ["n1"]}));
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
    let warning = reply["warnings"].as_array().into_iter().flatten().find(|warning| warning["code"] == "at_bound");
    for said in [&angle["known"], warning.expect("a warning")] {
        assert_eq!((&said["code"], &said["end"]), (&json!("at_bound"), &json!("upper")), "{reply}");
    }
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

/// The load takes the place of the sinkage modulus: strength and shear modulus are found without a pressure–sinkage law, and a law
/// that is there changes nothing in the closed forms.
#[test]
fn under_a_known_load_a_fit_needs_no_law() {
    for method in ["linearised", "explicit"] {
        let mut data = measured(&cohesive(), method);
        data["normal_load_n"] = data["normal_force_n"].take();
        let fit = |soil: Value| {
            let fit = ["cohesion_pa", "friction_angle_rad", "shear_modulus_m"];
            let wheel = json!({"radius_m": 0.2, "width_m": 0.1});
            post("/v1/identify", &json!({"wheel": wheel, "soil": soil, "method": method, "fit": fit, "data": data})).ok()
        };
        let bare = fit(json!({}));
        assert_eq!((&bare["converged"], &bare["identifiable"]), (&json!(true), &json!(true)), "{bare}");
        for (name, expected) in [("cohesion_pa", 400.0), ("friction_angle_rad", 0.478), ("shear_modulus_m", 0.015)] {
            let found = value(&bare, name);
            assert!((found / expected - 1.0).abs() < 1e-6, "{method}, {name}: {found}");
        }
        assert_eq!(bare["soil"]["pressure_sinkage"], Value::Null);
        assert_eq!(
            bare["rmse"].as_object().map(|of| of.keys().cloned().collect::<Vec<_>>()),
            Some(vec!["longitudinal_force_n".to_owned(), "torque_n_m".to_owned()])
        );
        let law = json!({"pressure_sinkage": {"law": "direct", "k_s": 1e5, "n0": 1.3}});
        assert_eq!(fit(law)["estimates"], bare["estimates"], "{method}");
    }
}

#[test]
fn a_known_load_stands_beside_a_sinkage_alone() {
    let body = |changes: Value| post("/v1/identify", &with(&request("linearised"), json!({"data": changes})));
    let load = json!([80, 80, 80, 80, 80, 80, 80, 80, 80]);
    let both = body(json!({"normal_load_n": load}));
    assert!(both.fault("/data/normal_load_n").starts_with("stands in place of `normal_force_n`"));
    let alone = body(json!({"normal_load_n": load, "normal_force_n": null, "sinkage_m": null}));
    assert!(alone.fault("/data/normal_load_n").starts_with("needs `sinkage_m`"));
}

/// By resistive force the stiffness is found, or the friction angle by which it follows from the density.
#[test]
fn the_grains_behind_forces_are_found() {
    let grains = json!({"friction_angle_rad": 0.55, "bulk_density_kg_m3": 1600, "gravity_m_s2": 1.62});
    let wheel = json!({"radius_m": 0.2, "width_m": 0.1});
    let at = |slip: f64, sinkage: f64| {
        let body = json!({"wheel": wheel, "soil": grains, "method": "resistive_force", "slip": slip, "sinkage_m": sinkage});
        post("/v1/forces", &body).ok()
    };
    let points: Vec<Value> = SLIPS.iter().zip(SINKAGES).map(|(slip, sinkage)| at(*slip, sinkage)).collect();
    let mut data = json!({"slip": SLIPS, "sinkage_m": SINKAGES});
    for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m"] {
        data[name] = points.iter().map(|point| point[name].clone()).collect();
    }
    let fit = |soil: Value, parameter: &str, data: &Value| {
        let body = json!({"wheel": wheel, "soil": soil, "method": "resistive_force", "fit": [parameter], "data": data});
        post("/v1/identify", &body)
    };
    let is = |reply: &Value, name: &str, expected: f64| {
        assert_eq!(reply["identifiable"], true, "{reply}");
        let found = value(reply, name);
        assert!((found / expected - 1.0).abs() < 1e-6, "{name}: {found} against {expected}");
        assert_eq!(estimate(reply, name)["found"], name, "a rough rim has no interface");
    };
    let stiffness = points[0]["granular_stiffness_n_m3"].as_f64().expect("a stiffness");
    let of_nothing = fit(json!({}), "granular_stiffness_n_m3", &data).ok();
    is(&of_nothing, "granular_stiffness_n_m3", stiffness);
    let known = json!({"bulk_density_kg_m3": 1600, "gravity_m_s2": 1.62});
    is(&fit(known, "friction_angle_rad", &data).ok(), "friction_angle_rad", 0.55);
    // Under the measured load, with the sinkage solved.
    let loads = with(&data, json!({"sinkage_m": null}));
    is(&fit(json!({}), "granular_stiffness_n_m3", &loads).ok(), "granular_stiffness_n_m3", stiffness);
    // The answer is a soil of a request as it stands.
    let again = json!({"wheel": wheel, "soil": of_nothing["soil"], "method": "resistive_force", "slip": 0.1, "sinkage_m": 0.02});
    let again = post("/v1/forces", &again).ok()["normal_force_n"].as_f64().expect("a force");
    assert!((again / at(0.1, 0.02)["normal_force_n"].as_f64().expect("a force") - 1.0).abs() < 1e-6);
    assert_eq!(fit(json!({}), "friction_angle_rad", &data).pointers(), ["/soil/bulk_density_kg_m3"]);
    let soil = json!({"preset": "letter-sand"});
    let by_laws = json!({"wheel": wheel, "soil": soil, "method": "linearised", "fit": ["granular_stiffness_n_m3"], "data": data});
    assert_eq!(post("/v1/identify", &by_laws).pointers(), ["/fit/0"], "laws have no granular stiffness");
}
