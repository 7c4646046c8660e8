//! `POST /v1/identify/plates` and `POST /v1/identify/shear`.

use serde_json::{Value, json};

use crate::asking::{Answer, letter, post, post_for_csv, table, with};

fn plate(width: f64, k_c: f64, k_phi: f64, n0: f64) -> Value {
    let sinkage: Vec<f64> = (1..=8).map(|i| 0.004 * f64::from(i)).collect();
    let pressure: Vec<f64> = sinkage.iter().map(|z| (k_c / width + k_phi) * z.powf(n0)).collect();
    json!({"width_m": width, "columns": {"sinkage_m": sinkage, "pressure_pa": pressure}})
}

fn plates() -> Value {
    json!({"plates": [plate(0.05, 1400.0, 820_000.0, 1.1), plate(0.15, 1400.0, 820_000.0, 1.1)]})
}

fn shear() -> Value {
    let displacement: Vec<f64> = (0..12).map(|i| 0.003 * f64::from(i)).collect();
    let curve = |normal: f64| {
        let shear: Vec<f64> =
            displacement.iter().map(|j| (700.0 + normal * 0.55_f64.tan()) * (1.0 - (-j / 0.012).exp())).collect();
        json!({"normal_stress_pa": normal, "columns": {"displacement_m": displacement, "shear_stress_pa": shear}})
    };
    json!({"curves": [curve(2e3), curve(9e3)]})
}

fn values(reply: &Value) -> Vec<(String, f64)> {
    let estimates = reply["estimates"].as_array().expect("estimates");
    let of = |estimate: &Value| {
        (estimate["parameter"].as_str().expect("a name").to_owned(), estimate["value"].as_f64().expect("a number"))
    };
    estimates.iter().map(of).collect()
}

fn assert_found(reply: &Value, expected: [(&str, f64); 3]) {
    assert_eq!(reply["identifiable"], true, "{reply}");
    for ((name, value), (expected_name, expected)) in values(reply).iter().zip(expected) {
        assert_eq!(name, expected_name);
        assert!((value / expected - 1.0).abs() < 1e-6, "{name}: {value}");
    }
}

#[test]
fn bekkers_parameters_come_back_and_the_law_is_ready_to_be_used() {
    let reply = post("/v1/identify/plates", &plates()).ok();
    assert_found(&reply, [("k_c", 1400.0), ("k_phi", 820_000.0), ("n0", 1.1)]);
    assert_eq!(reply["warnings"], json!([]));
    assert!((reply["plates"][0]["modulus"].as_f64().expect("a number") / (1400.0 / 0.05 + 820_000.0) - 1.0).abs() < 1e-9);
    post("/v1/forces", &with(&letter(), json!({"soil": {"pressure_sinkage": reply["pressure_sinkage"]}}))).ok();
    let columns = table(&post_for_csv("/v1/identify/plates", &plates()).text);
    assert_eq!((columns.len(), columns[0].1.len()), (5, 16));
}

#[test]
fn strength_and_modulus_come_back_from_shear_tests() {
    let reply = post("/v1/identify/shear", &shear()).ok();
    assert_found(&reply, [("cohesion_pa", 700.0), ("friction_angle_rad", 0.55), ("shear_modulus_m", 0.012)]);
    assert_eq!(table(&post_for_csv("/v1/identify/shear", &shear()).text)[3].0, "predicted_shear_stress_pa");
}

#[test]
fn a_negative_cohesive_modulus_is_warned_of() {
    let body = json!({"plates": [plate(0.05, -5000.0, 820_000.0, 1.1), plate(0.15, -5000.0, 820_000.0, 0.7)]});
    let reply = post("/v1/identify/plates", &body).ok();
    let codes: Vec<&Value> = reply["warnings"].as_array().expect("warnings").iter().map(|warning| &warning["code"]).collect();
    assert!(codes.contains(&&json!("exponents_differ")), "{reply}");
    let alike = json!({"plates": [plate(0.05, -5000.0, 820_000.0, 1.1), plate(0.15, -5000.0, 820_000.0, 1.1)]});
    let reply = post("/v1/identify/plates", &alike).ok();
    assert_eq!(reply["warnings"][0]["code"], "fitted_k_c_negative");
}

/// A plate test begins with a row of zeros, which says nothing of a power law.
#[test]
fn rows_without_sinkage_are_left_out_with_a_word() {
    let mut body = plates();
    for (name, value) in [("sinkage_m", 0), ("pressure_pa", 0)] {
        body["plates"][0]["columns"][name].as_array_mut().expect("a column").insert(0, json!(value));
    }
    let reply = post("/v1/identify/plates", &body).ok();
    assert_found(&reply, [("k_c", 1400.0), ("k_phi", 820_000.0), ("n0", 1.1)]);
    assert_eq!(reply["warnings"][0]["code"], "rows_without_sinkage");
    assert_eq!(reply["columns"]["sinkage_m"].as_array().map(Vec::len), Some(16));
    body["plates"][0]["columns"] = json!({"sinkage_m": [0, 0], "pressure_pa": [0, 1]});
    assert_eq!(post("/v1/identify/plates", &body).fault("/plates/0/columns/sinkage_m"), "has no value greater than 0");
    body["plates"][0]["columns"] = json!({"sinkage_m": [0.01, 0.02], "pressure_pa": [0, 0]});
    assert!(post("/v1/identify/plates", &body).fault("/plates/0").contains("not all 0"));
}

#[test]
fn a_slip_of_the_units_is_called_implausible() {
    let codes = |reply: &Value| reply["warnings"].to_string();
    // Pressures in kPa.
    let mut body = plates();
    for plate in body["plates"].as_array_mut().expect("plates") {
        let pressures = plate["columns"]["pressure_pa"].as_array_mut().expect("a column");
        pressures.iter_mut().for_each(|p| *p = json!(1e-3 * p.as_f64().expect("a number")));
    }
    assert!(codes(&post("/v1/identify/plates", &body).ok()).contains("implausible_estimate"));
    // Normal stresses in kPa beside shear stresses in Pa.
    let mut body = shear();
    for curve in body["curves"].as_array_mut().expect("curves") {
        curve["normal_stress_pa"] = json!(1e-3 * curve["normal_stress_pa"].as_f64().expect("a number"));
    }
    let warnings = codes(&post("/v1/identify/shear", &body).ok());
    assert!(warnings.contains("implausible_estimate") && warnings.contains("60 degrees"), "{warnings}");
    // Shear stresses in kPa: next to no friction.
    let mut body = shear();
    for curve in body["curves"].as_array_mut().expect("curves") {
        let stresses = curve["columns"]["shear_stress_pa"].as_array_mut().expect("a column");
        stresses.iter_mut().for_each(|stress| *stress = json!(1e-3 * stress.as_f64().expect("a number")));
    }
    let warnings = codes(&post("/v1/identify/shear", &body).ok());
    assert!(warnings.contains("implausible_estimate") && warnings.contains("`friction_angle_rad` is"), "{warnings}");
}

#[test]
fn a_modulus_bounded_from_above_alone_is_not_determined() {
    let curve = |normal: f64, shear: [f64; 3]| json!({"normal_stress_pa": normal, "columns": {"displacement_m": [0.1, 0.2, 0.3], "shear_stress_pa": shear}});
    let body = json!({"curves": [curve(1e3, [500.0, 501.0, 500.0]), curve(2e3, [900.0, 900.0, 901.0])]});
    let reply = post("/v1/identify/shear", &body).ok();
    let modulus = &reply["estimates"][2];
    assert_eq!((&reply["identifiable"], &modulus["standard_error"]), (&json!(false), &Value::Null), "{reply}");
    assert!(modulus["identifiability"].as_str().expect("words").contains("only from above"), "{modulus}");
    assert_eq!(modulus["known"], json!({"code": "one_sided", "end": "upper"}));
}

#[test]
fn curves_that_cannot_tell_are_refused_in_words() {
    let one_width = json!({"plates": [plate(0.1, 0.0, 1e6, 1.0), plate(0.1, 0.0, 1e6, 1.0)]});
    assert!(post("/v1/identify/plates", &one_width).fault("/plates").contains("two widths"));
    let mut one_stress = shear();
    one_stress["curves"][1]["normal_stress_pa"] = json!(2e3);
    assert!(post("/v1/identify/shear", &one_stress).fault("/curves").contains("two normal stresses"));
}

#[test]
fn bad_curves_are_pointed_at() {
    let faults = |path: &str, body: &Value| post(path, body).pointers();
    assert_eq!(faults("/v1/identify/plates", &json!({"plates": []})), ["/plates"]);
    assert_eq!(faults("/v1/identify/plates", &json!({"plates": [1, plate(0.1, 0.0, 1e6, 1.0)]})), ["/plates/0"]);
    let mut body = plates();
    body["plates"][1]["columns"]["pressure_pa"] = json!([1, -1, 2]);
    assert_eq!(faults("/v1/identify/plates", &body), ["/plates/1/columns/pressure_pa/1"]);
    body["plates"][1]["columns"]["pressure_pa"] = json!([1, 1, 2]);
    assert_eq!(faults("/v1/identify/plates", &body), ["/plates/1/columns/pressure_pa"]);
    body["plates"][0]["widht_m"] = json!(0.1);
    assert_eq!(faults("/v1/identify/plates", &body), ["/plates/0/widht_m", "/plates/1/columns/pressure_pa"]);
    let mut body = shear();
    body["curves"][0] = json!({"columns": {"displacement_m": [0.1]}});
    assert_eq!(faults("/v1/identify/shear", &body), ["/curves/0/normal_stress_pa", "/curves/0/columns/shear_stress_pa"]);
}

/// The answer, unless the service does not give one: a fit that hung is a failure and holds up no other test.
fn post_in_time(path: &'static str, body: &Value) -> Answer {
    let (send, receive) = std::sync::mpsc::channel();
    let body = body.clone();
    // Nobody waits for an answer that comes too late.
    std::thread::spawn(move || drop(send.send(post(path, &body))));
    receive.recv_timeout(std::time::Duration::from_secs(60)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Displacements so far apart that a ratio of them is infinite where its exponential is 0.
#[test]
fn displacements_far_apart_are_answered() {
    let curve = |normal: f64, displacement: &[f64], shear: &[f64]| json!({"normal_stress_pa": normal, "columns": {"displacement_m": displacement, "shear_stress_pa": shear}});
    let tiny = json!({"curves": [curve(2.0, &[5e-324], &[1.0]), curve(0.0, &[0.0], &[0.0])]});
    assert!(post_in_time("/v1/identify/shear", &tiny).fault("/curves").contains("largest displacement"));
    let apart = json!({"curves": [curve(1e3, &[0.001, 1e-6], &[-1.0, 1e3]), curve(1.0, &[0.0, 1e-6], &[0.0, 1e12])]});
    let reply = post_in_time("/v1/identify/shear", &apart).ok();
    assert!(reply["estimates"].as_array().expect("estimates").iter().all(|estimate| estimate["value"].is_number()), "{reply}");
}

#[test]
fn values_too_small_to_be_squared_are_pointed_at() {
    let mut body = plates();
    body["plates"][1]["columns"]["pressure_pa"] = json!(vec![5e-324; 8]);
    assert!(post_in_time("/v1/identify/plates", &body).fault("/plates/1").contains("1e-100"));
    let mut body = shear();
    for curve in body["curves"].as_array_mut().expect("curves") {
        curve["normal_stress_pa"] = json!(1e-200 * curve["normal_stress_pa"].as_f64().expect("a number"));
    }
    assert!(post_in_time("/v1/identify/shear", &body).fault("/curves").contains("1e-100"));
}
