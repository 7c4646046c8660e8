//! The answer of `/v1/identify` as the uncertain inputs of `/v1/uncertainty`.

use serde_json::{Value, json};

use crate::asking::{letter, post, with};
use crate::uncertainty::{COHESION, MODULUS, found, of_two};

/// Two estimates as `/v1/identify` gives them, the one fitted on a linear scale, the other on a logarithmic one.
fn estimates() -> Value {
    let (modulus, deviation) = (754_130.0_f64, 40_000.0);
    let factor = (2.3 * deviation / modulus).exp();
    json!([
        {"parameter": "cohesion_pa", "found": "cohesion_pa", "value": 2000.0, "standard_error": 150.0,
            "interval_95": [1650.0, 2350.0], "at_bound": false, "identifiability": "determined to ± 350 (95 %)",
            "known": {"code": "determined", "half_width": 350.0}},
        {"parameter": "k_phi", "value": modulus, "standard_error": deviation,
            "interval_95": [modulus / factor, modulus * factor], "at_bound": false}
    ])
}

fn of_posterior(posterior: Value) -> Value {
    with(&of_two(json!({"inputs": null})), json!({"posterior": posterior}))
}

/// A lognormal distribution with the median m and the deviation s/m of the logarithm has the mean m exp(v/2) and the variance
/// (exp v − 1) times its square, with v = (s/m)².
#[test]
fn a_posterior_is_the_inputs_that_it_stands_for() {
    let variance = (40_000.0 / 754_130.0_f64).powi(2);
    let mean = 754_130.0 * (0.5 * variance).exp();
    let inputs = json!([
        {"field": COHESION, "distribution": "normal", "mean": 2000, "standard_deviation": 150},
        {"field": MODULUS, "distribution": "lognormal", "mean": mean, "standard_deviation": mean * variance.exp_m1().sqrt()}
    ]);
    let correlation = json!([[1, -0.6], [-0.6, 1]]);
    // A fit leaves the matrix symmetric to rounding alone.
    let rounded = json!([[1, -0.6], [-0.600_000_000_000_001, 1]]);
    let posterior = found(&of_posterior(json!({"estimates": estimates(), "correlation": rounded})));
    let same = found(&of_two(json!({"inputs": inputs, "correlation": correlation})));
    let median = |answer: &Value| {
        let bands = answer["bands"].as_array().expect("bands");
        let pull = bands.iter().find(|band| band["quantity"] == "longitudinal_force_n").expect("the pull");
        ["mean", "standard_deviation", "q05", "q95"].map(|name| pull["columns"][name][0].as_f64().expect("a number"))
    };
    for (one, other) in median(&posterior).into_iter().zip(median(&same)) {
        assert!((one / other - 1.0).abs() < 1e-12, "{one} against {other}");
    }
    assert_eq!(posterior["inputs"][1]["from"], "posterior");
    assert_eq!(posterior["inputs"][1]["distribution"], "lognormal");
    assert_eq!(posterior["sensitivities"][0]["fields"], json!([COHESION, MODULUS]), "they have one share together");
}

/// A fit to forces with 3 % of noise, whose band of the pull is that of the propagated errors: the pull is nearly linear in the
/// parameters within their errors.
#[test]
fn the_bands_of_a_fit_are_its_propagated_errors() {
    let noise = [0.03, -0.02, 0.01, 0.025, -0.03, -0.01, 0.02, -0.025, 0.015];
    let slips = [0.05, 0.08, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8];
    let soil = json!({"cohesion_pa": 1500, "shear_modulus_m": 0.015});
    // At one sinkage friction and cohesion could not be told apart.
    let sinkages = [0.01, 0.02, 0.03, 0.01, 0.02, 0.03, 0.01, 0.02, 0.03];
    let point = |slip: f64, sinkage: f64| json!({"slip": slip, "sinkage_m": sinkage, "method": "linearised"});
    let truth = with(&letter(), json!({"soil": soil}));
    let points = slips.iter().zip(sinkages);
    let forces: Vec<Value> =
        points.map(|(slip, sinkage)| post("/v1/forces", &with(&truth, point(*slip, sinkage))).ok()).collect();
    let noisy = |name: &str, shift: usize| -> Vec<f64> {
        let factor = |i: usize| 1.0 + noise[(i + shift) % noise.len()];
        forces.iter().enumerate().map(|(i, forces)| forces[name].as_f64().expect("a force") * factor(i)).collect()
    };
    let fit = with(
        &letter(),
        json!({
            "slip": null, "sinkage_m": null, "method": "linearised", "fit": ["cohesion_pa", "friction_angle_rad", "shear_modulus_m"],
            "data": {"slip": slips, "sinkage_m": sinkages, "torque_n_m": noisy("torque_n_m", 0),
                "longitudinal_force_n": noisy("longitudinal_force_n", 4), "normal_force_n": noisy("normal_force_n", 7)}
        }),
    );
    let fit = post("/v1/identify", &fit).ok();
    let of_fit = with(&letter(), with(&point(0.25, 0.02), json!({"soil": fit["soil"], "contact": fit["contact"]})));
    let posterior = json!({"estimates": fit["estimates"], "correlation": fit["correlation"]});
    let body = json!({"of": "forces", "request": of_fit, "posterior": posterior, "samples": 4096, "sensitivity": false});
    let bands = found(&body);
    let band = bands["bands"].as_array().expect("bands").iter().find(|band| band["quantity"] == "longitudinal_force_n");
    let deviation = band.expect("the pull")["columns"]["standard_deviation"][0].as_f64().expect("a deviation");

    let pull = |name: &str, value: f64| {
        let changed = with(&of_fit, json!({"soil": {name: value}}));
        post("/v1/forces", &changed).ok()["longitudinal_force_n"].as_f64().expect("a pull")
    };
    let estimates = fit["estimates"].as_array().expect("estimates");
    let effects: Vec<f64> = estimates
        .iter()
        .map(|estimate| {
            let (name, of) =
                (estimate["parameter"].as_str().expect("a name"), |name: &str| estimate[name].as_f64().expect("a number"));
            let (value, step) = (of("value"), 0.1 * of("standard_error"));
            5.0 * (pull(name, value + step) - pull(name, value - step)) // times the standard error
        })
        .collect();
    let correlation = |i: usize, j: usize| fit["correlation"][i][j].as_f64().expect("a coefficient");
    let places = || (0..effects.len()).flat_map(|i| (0..effects.len()).map(move |j| (i, j)));
    let propagated = places().map(|(i, j)| effects[i] * effects[j] * correlation(i, j)).sum::<f64>().sqrt();
    let alone = effects.iter().map(|effect| effect * effect).sum::<f64>().sqrt();
    assert!((deviation / propagated - 1.0).abs() < 0.03, "{deviation} against {propagated}");
    assert!((alone / propagated - 1.0).abs() > 0.2, "the correlation matters: {alone} without it");
}

#[test]
fn a_posterior_that_is_none_is_refused_where_it_is_wrong() {
    let sound = json!([[1, 0], [0, 1]]);
    let faults = |estimates: Value, correlation: &Value| {
        post("/v1/uncertainty", &of_posterior(json!({"estimates": estimates, "correlation": correlation})))
    };
    let changed = |i: usize, changes: Value| {
        let mut all = estimates();
        all[i] = with(&all[i], changes);
        all
    };
    let open = faults(changed(1, json!({"standard_error": null})), &sound);
    assert!(open.fault("/posterior/estimates/1/standard_error").contains("leave this parameter open"));
    let other = faults(changed(0, json!({"parameter": "cohesion"})), &sound);
    assert!(other.fault("/posterior/estimates/0/parameter").contains("`cohesion_pa`"));
    let exact = faults(changed(0, json!({"standard_error": 0})), &sound);
    assert_eq!(exact.pointers(), ["/posterior/estimates/0/standard_error"]);
    for matrix in [json!([[1]]), json!([[1, 0.5], [0.4, 1]]), json!([[1, 1], [1, 1]]), json!([[1, null], [null, 1]])] {
        assert!(faults(estimates(), &matrix).pointers().iter().all(|pointer| pointer.starts_with("/posterior/correlation")));
    }
    let twice = with(&of_two(json!({})), json!({"posterior": {"estimates": estimates(), "correlation": sound}}));
    assert_eq!(
        post("/v1/uncertainty", &twice).fault("/posterior/estimates/0/parameter"),
        format!("`{COHESION}` is varied twice")
    );
}
