//! `POST /v1/compare`.

use serde_json::{Value, json};

use crate::asking::{letter, post, post_for_csv, same_but_for_rounding, table, with};

fn comparison(changes: Value) -> Value {
    with(&with(&letter(), json!({"slip": [0.1, 0.3, 0.6]})), changes)
}

#[test]
fn each_series_is_what_the_sweep_gives() {
    for sinkage in [json!({}), json!({"sinkage_m": null, "normal_load_n": 80})] {
        let reply = post("/v1/compare", &comparison(sinkage.clone())).ok();
        assert_eq!(reply["slip"], json!([0.1, 0.3, 0.6]));
        let series = reply["series"].as_array().expect("series");
        assert_eq!(series.len(), 3);
        for (series, method) in series.iter().zip(["quadrature", "linearised", "explicit"]) {
            assert_eq!(series["method"], method);
            let sweep = post("/v1/slip-sweep", &with(&comparison(sinkage.clone()), json!({"method": method}))).ok();
            assert_eq!(series["columns"], sweep["columns"]);
        }
    }
}

#[test]
fn one_operating_point_is_what_forces_gives() {
    for slip in [json!(0.2), json!([0.2])] {
        for sinkage in [json!({}), json!({"sinkage_m": null, "normal_load_n": 80})] {
            let reply = post("/v1/compare", &comparison(with(&sinkage, json!({"slip": slip})))).ok();
            assert_eq!(reply["slip"], json!([0.2]));
            for series in reply["series"].as_array().expect("series") {
                let forces = post("/v1/forces", &with(&letter(), with(&sinkage, json!({"method": series["method"]})))).ok();
                for (name, column) in series["columns"].as_object().expect("columns") {
                    let single = forces.get(name).unwrap_or(&forces["components"][name]);
                    let found = &column[0];
                    // Closed forms take eight rows at a time.
                    let same =
                        if series["method"] == "quadrature" { found == single } else { same_but_for_rounding(found, single) };
                    assert!(same && column.as_array().is_some_and(|rows| rows.len() == 1), "{name}: {column} {single}");
                }
            }
        }
    }
}

#[test]
fn a_variant_is_the_sweep_with_its_laws() {
    let hump = json!({"law": "wong_residual", "residual_ratio": 0.66, "peak_displacement_m": 0.022});
    let direct = json!({"law": "direct", "k_s": 8e5, "n0": 1});
    let halved = json!({"rule": "half_sinkage"});
    let (all, sunk) = (json!(["quadrature", "linearised", "explicit"]), json!({"sinkage_m": null, "static_sinkage_m": 0.01}));
    let cases = [
        (json!({}), all.clone(), json!({"shear": hump}), json!({"soil": {"shear": hump}})),
        (json!({}), all.clone(), json!({"pressure_sinkage": direct}), json!({"soil": {"pressure_sinkage": direct}})),
        (json!({}), all.clone(), json!({"contact": halved}), json!({"contact": halved})),
        (json!({}), all.clone(), json!({"normal_stress_radius": "shearing"}), json!({"normal_stress_radius": "shearing"})),
        (
            sunk,
            json!(["explicit"]),
            json!({"slip_sinkage": {"law": "linear", "gain": 1}}),
            json!({"slip_sinkage": {"law": "linear", "gain": 1}}),
        ),
        (
            json!({"slip": [-0.4, -0.2]}),
            json!(["quadrature"]),
            json!({"braking": "two_zone", "shear": hump}),
            json!({"braking": "two_zone", "soil": {"shear": hump}}),
        ),
    ];
    for (changes, methods, laws, as_sweep) in cases {
        // Lugs, so that the shearing radius is not the rim; what a law replaces leaves nothing behind.
        let mut asked = with(&comparison(changes), json!({"wheel": {"lug_height_m": 0.01}}));
        let variants = json!([with(&json!({"name": "other"}), laws.clone())]);
        let reply = post("/v1/compare", &with(&asked, json!({"methods": methods, "variants": variants}))).ok();
        let series = reply["series"].as_array().expect("series");
        let methods = methods.as_array().expect("methods");
        assert_eq!(series.len(), 2 * methods.len());
        for (i, series) in series.iter().enumerate() {
            if i == methods.len() {
                if laws.get("pressure_sinkage").is_some() {
                    asked = with(&asked, json!({"soil": {"pressure_sinkage": null}}));
                }
                asked = with(&asked, as_sweep.clone());
            }
            let (name, method) = (if i < methods.len() { json!(null) } else { json!("other") }, &methods[i % methods.len()]);
            assert_eq!((&series["variant"], &series["method"]), (&name, method));
            let sweep = post("/v1/slip-sweep", &with(&asked, json!({"method": method}))).ok();
            assert_eq!(series["columns"], sweep["columns"], "{laws}");
        }
        let (own, other) = (&series[0]["columns"], &series[methods.len()]["columns"]);
        assert_ne!(own["longitudinal_force_n"], other["longitudinal_force_n"], "{laws}");
    }
}

type Numbers = Vec<Option<f64>>;

fn column(columns: &Value, name: &str) -> Numbers {
    columns[name].as_array().expect("a column").iter().map(Value::as_f64).collect()
}

fn root_mean_square(values: &[f64]) -> f64 {
    (values.iter().map(|value| value * value).sum::<f64>() / values.len() as f64).sqrt()
}

/// Compares a number with the one found here, which sums in another order.
fn is_near(stated: &Value, found: f64, of: f64, place: &str) {
    let stated = stated.as_f64().unwrap_or_else(|| panic!("{place}: {stated}"));
    assert!((stated - found).abs() <= 1e-12 * of.abs(), "{place}: {stated}, not {found}");
}

fn is_difference(stated: &Value, columns: &Numbers, reference: &Numbers, place: &str) {
    let pairs: Vec<(f64, f64)> = columns.iter().zip(reference).filter_map(|(a, b)| Some(((*a)?, (*b)?))).collect();
    let differences: Vec<f64> = pairs.iter().map(|(a, b)| a - b).collect();
    let rms = root_mean_square(&differences);
    assert_eq!(stated["rows"], pairs.len(), "{place}");
    assert_eq!(stated["max_abs"], differences.iter().map(|d| d.abs()).fold(0.0, f64::max), "{place}");
    is_near(&stated["rms"], rms, rms, place);
    is_near(&stated["mean"], differences.iter().sum::<f64>() / pairs.len() as f64, rms, place);
    let relative = rms / root_mean_square(&pairs.iter().map(|(_, b)| *b).collect::<Vec<_>>());
    is_near(&stated["relative"], relative, relative, place);
}

const QUANTITIES: [&str; 5] = ["sinkage_m", "longitudinal_force_n", "normal_force_n", "torque_n_m", "drawbar_coefficient"];

/// Two laws by two methods, with and without the quadrature among them; at the last slip a variant has no solution.
fn of_two_laws(methods: Value) -> (Value, Value) {
    let contact = json!({"rule": "wong_reece", "c1": 0.5, "c2": 0.6});
    let variants = json!([{"name": "by slip", "contact": contact}]);
    let asked = comparison(json!({"slip": [0.1, 0.3, 0.6, 0.9], "sinkage_m": null, "normal_load_n": 80}));
    let reply = post("/v1/compare", &with(&asked, json!({"methods": methods, "variants": variants}))).ok();
    (with(&asked, json!({"contact": contact})), reply)
}

#[test]
fn differences_are_those_from_the_first_series_and_from_the_integral() {
    for methods in [json!(["linearised", "quadrature"]), json!(["explicit", "linearised"])] {
        let (varied, reply) = of_two_laws(methods);
        let own = with(&varied, json!({"contact": null}));
        let integrals = [own, varied]
            .map(|body| post("/v1/slip-sweep", &with(&body, json!({"method": "quadrature"}))).ok()["columns"].clone());
        for (i, series) in reply["series"].as_array().expect("series").iter().enumerate() {
            for name in QUANTITIES {
                let place = format!("{name} of {} {}", series["variant"], series["method"]);
                let values = column(&series["columns"], name);
                assert_eq!(values.iter().flatten().count(), if i < 2 { 4 } else { 3 }, "{place}");
                let first = column(&reply["series"][0]["columns"], name);
                if i > 0 {
                    is_difference(&series["difference"][name], &values, &first, &place);
                }
                if series["method"] != "quadrature" {
                    is_difference(&series["gap_to_quadrature"][name], &values, &column(&integrals[i / 2], name), &place);
                }
            }
        }
        let zero = |rows| json!({"rms": 0.0, "max_abs": 0.0, "mean": 0.0, "relative": 0.0, "rows": rows});
        assert_eq!(reply["series"][0]["difference"]["torque_n_m"], zero(4));
        for (series, rows) in [(1, 4), (3, 3)].into_iter().filter(|(i, _)| reply["series"][*i]["method"] == "quadrature") {
            assert_eq!(reply["series"][series]["gap_to_quadrature"]["torque_n_m"], zero(rows));
        }
    }
}

#[test]
fn the_spread_is_the_highest_of_all_series_less_the_lowest() {
    let (_, reply) = of_two_laws(json!(["linearised", "quadrature"]));
    for name in QUANTITIES {
        let columns: Vec<Numbers> =
            reply["series"].as_array().expect("series").iter().map(|series| column(&series["columns"], name)).collect();
        let rows: Vec<Vec<f64>> = (0..4).filter_map(|row| columns.iter().map(|column| column[row]).collect()).collect();
        let spreads: Vec<f64> = rows
            .iter()
            .map(|row| row.iter().copied().fold(f64::MIN, f64::max) - row.iter().copied().fold(f64::MAX, f64::min))
            .collect();
        let stated = &reply["spread"][name];
        assert_eq!((&stated["rows"], spreads.len()), (&json!(3), 3), "{name}");
        assert_eq!(stated["max_abs"], spreads.iter().copied().fold(0.0, f64::max), "{name}");
        let rms = root_mean_square(&spreads);
        is_near(&stated["rms"], rms, rms, name);
        let relative = rms / root_mean_square(&rows.iter().map(|row| row[0]).collect::<Vec<_>>());
        is_near(&stated["relative"], relative, relative, name);
    }
}

/// What the letter's simplifications leave out on its own example: 11–13 % and 34–40 % of F_z (`benches/gap.py`).
#[test]
fn the_gap_on_the_letters_example_is_the_known_one() {
    let reply = post("/v1/compare", &comparison(json!({"methods": ["linearised", "explicit"]}))).ok();
    let gap = |series: usize, member: &str| {
        reply["series"][series]["gap_to_quadrature"]["normal_force_n"][member].as_f64().expect("a gap")
    };
    let relative = [0, 1].map(|series| gap(series, "relative"));
    assert!((0.11..0.13).contains(&relative[0]) && (0.34..0.40).contains(&relative[1]), "{relative:?}");
    assert!(gap(0, "mean") < 0.0 && gap(1, "mean") < 0.0, "both carry less");
}

#[test]
fn points_without_a_solution_are_left_out_of_the_differences() {
    let changes = json!({"contact": {"rule": "wong_reece", "c1": 0.5, "c2": 1.0}, "slip": [0.1, 0.9]});
    let variants = json!([{"name": "midpoint", "contact": {"rule": "midpoint"}}]);
    let reply = post("/v1/compare", &with(&comparison(changes), json!({"variants": variants}))).ok();
    let differences = |series: usize| &reply["series"][series]["difference"]["torque_n_m"];
    assert!(differences(1)["rms"].is_number() && differences(1)["rows"] == 1);
    let warnings = reply["warnings"].as_array().expect("warnings");
    let gaps: Vec<&Value> = warnings.iter().filter(|warning| warning["code"] == "no_solution").collect();
    assert_eq!(gaps.len(), 1, "all three methods have the same gap: {warnings:?}");
    assert_eq!(gaps[0]["series"], json!(["quadrature", "linearised", "explicit"]));
    assert_eq!((&gaps[0]["rows"], &gaps[0]["pointer"]), (&json!([[1, 1]]), &json!("/contact")));
    let of_variant = json!("midpoint, explicit");
    let names_variant = |warning: &Value| warning["series"].as_array().is_some_and(|series| series.contains(&of_variant));
    assert!(warnings.iter().any(|warning| warning["code"] != "no_solution" && names_variant(warning)), "{warnings:?}");

    let none =
        post("/v1/compare", &comparison(json!({"contact": {"rule": "wong_reece", "c1": 0.5, "c2": 1.0}, "slip": 0.9}))).ok();
    let nothing = json!({"rms": null, "max_abs": null, "mean": null, "relative": null, "rows": 0});
    assert_eq!(none["series"][1]["gap_to_quadrature"]["torque_n_m"], nothing);
    assert_eq!(none["spread"]["torque_n_m"], json!({"rms": null, "max_abs": null, "relative": null, "rows": 0}));
}

#[test]
fn what_is_said_of_every_series_is_said_once() {
    let reply = post("/v1/compare", &comparison(json!({"slip": [0.1, 0.5, 0.8]}))).ok();
    let warnings = reply["warnings"].as_array().expect("warnings");
    let small: Vec<&Value> = warnings.iter().filter(|warning| warning["code"] == "small_wheel").collect();
    assert!(matches!(small[..], [warning] if warning["series"].is_null() && warning["rows"].is_null()), "{warnings:?}");
}

#[test]
fn a_table_names_its_columns_by_method() {
    let columns = table(&post_for_csv("/v1/compare", &comparison(json!({"methods": ["explicit", "quadrature"]}))).text);
    let names: Vec<&str> = columns.iter().map(|(name, _)| name.as_str()).collect();
    let answer = post("/v1/compare", &comparison(json!({"methods": ["explicit", "quadrature"]}))).ok();
    let series = answer["series"].as_array().expect("series");
    // The slips of all series are one column.
    let lists: usize = series.iter().map(|series| series["columns"].as_object().expect("columns").len() - 1).sum();
    assert_eq!(columns.len(), 1 + lists);
    assert_eq!(names[..2], ["slip", "explicit.sinkage_m"]);
    assert!(names.contains(&"quadrature.tractive_efficiency") && columns.len() >= 21, "{names:?}");
    let variants = json!([{"name": "9\" wheel, lugs", "contact": {"rule": "half_sinkage"}}]);
    let answer = post_for_csv("/v1/compare", &comparison(json!({"methods": ["explicit"], "variants": variants})));
    assert_eq!(answer.header("x-warnings"), "small_wheel");
    let header = answer.text.lines().next().expect("a header");
    assert!(header.ends_with(",\"9\"\" wheel, lugs.explicit.tractive_efficiency\""), "{header}");
}

#[test]
fn bad_names_of_methods_are_pointed_at() {
    let faults = |methods: Value| post("/v1/compare", &comparison(json!({"methods": methods}))).pointers();
    assert_eq!(faults(json!(["quadrature", "explict", 3, "quadrature", "explicit"])), ["/methods"]);
    assert_eq!(faults(json!(["quadrature", "explict", 3])), ["/methods/1", "/methods/2"]);
    assert_eq!(faults(json!(["quadrature", "quadrature"])), ["/methods/1"]);
    assert_eq!(faults(json!([])), ["/methods"]);
    assert_eq!(faults(json!("quadrature")), ["/methods"]);
    let unknown = post("/v1/compare", &comparison(json!({"method": "explicit"}))).fault("/method");
    assert_eq!(unknown, "unknown field; did you mean `methods`?");
}

#[test]
fn every_fault_of_a_variant_is_pointed_at() {
    let asked = |variants: Value| post("/v1/compare", &comparison(json!({"variants": variants})));
    let faults = |variants: Value| asked(variants).pointers();
    let several = json!([
        {"name": "a", "shear": {"law": "wong_peak"}, "contact": {"rule": "wong_reece", "c1": 9}, "colour": "red"},
        {"name": "a", "pressure_sinkage": {"law": "direct", "k_s": 1e6}, "normal_stress_radius": "rims"},
        {"shear": 3},
        4
    ]);
    let expected = [
        "/variants/0/colour",
        "/variants/0/shear/peak_displacement_m",
        "/variants/0/contact/c1",
        "/variants/0/contact/c2",
        "/variants/1/name",
        "/variants/1/pressure_sinkage/n0",
        "/variants/1/normal_stress_radius",
        "/variants/2/name",
        "/variants/2/shear",
        "/variants/3",
    ];
    assert_eq!(faults(several), expected);
    assert_eq!(faults(json!([{"name": "x", "slip_sinkage": {"law": "lyasko"}}])), ["/variants/0/slip_sinkage"]);
    assert_eq!(faults(json!([{"name": "x", "braking": "two_zone"}])), ["/variants/0/braking"]);
    for name in [json!(""), json!("a\nb"), json!("\u{7f}"), json!("é".repeat(61)), json!(7), json!(null)] {
        assert_eq!(faults(json!([{"name": name}])), ["/variants/0/name"], "{name}");
    }
    assert_eq!(asked(json!([{"name": "é".repeat(60)}])).status, 200);
    let many: Vec<Value> = (0..9).map(|i| json!({"name": i.to_string()})).collect();
    assert_eq!(faults(json!(many)), ["/variants"]);
    assert_eq!(faults(json!({"name": "x"})), ["/variants"]);
    assert_eq!(asked(json!([])).ok()["series"].as_array().map(Vec::len), Some(3));
}

#[test]
fn what_the_request_itself_has_wrong_is_said_once() {
    let variants = json!([{"name": "a", "contact": {"rule": "midpoint"}}, {"name": "b", "contact": {"rule": "middle"}}]);
    let body = comparison(json!({"wheel": {"width_m": -1}, "slip": [0, 2], "lambda_a": 9, "contact": 3, "variants": variants}));
    let expected = ["/wheel/width_m", "/contact", "/lambda_a", "/slip/1", "/variants/1/contact/rule"];
    assert_eq!(post("/v1/compare", &body).pointers(), expected);
}

#[test]
fn a_law_that_asks_more_of_the_request_says_so_at_its_variant() {
    let hump = json!({"law": "wong_peak", "peak_displacement_m": 0.02});
    let variants = json!([{"name": "x", "shear": {"law": "janosi_hanamoto"}}]);
    let body = comparison(json!({"soil": {"shear_modulus_m": null, "shear": hump}, "variants": variants}));
    let detail = post("/v1/compare", &body).fault("/variants/0");
    assert_eq!(detail, "with this variant, /soil/shear_modulus_m is required");
}

#[test]
fn a_slip_or_several_are_taken() {
    let faults = |slip: Value| post("/v1/compare", &comparison(json!({"slip": slip}))).pointers();
    assert_eq!(faults(json!(2)), ["/slip"]);
    assert_eq!(faults(json!("fast")), ["/slip"]);
    assert_eq!(faults(json!([])), ["/slip"]);
    assert_eq!(faults(json!(null)), ["/slip"]);
    assert_eq!(faults(json!([0.1, 3])), ["/slip/1"]);
    let far = post("/v1/compare", &comparison(json!({"slip": vec![2; 13]})));
    assert_eq!(far.pointers().len(), 11);
    assert_eq!(far.fault("/slip"), "has 3 more such faults");
}
