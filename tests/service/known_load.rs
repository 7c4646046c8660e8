//! A load that is known beside the sinkage, and pull from torque.

use serde_json::{Value, json};

use crate::asking::{get, letter, post, query_of, with};
use crate::track::stream_to;

/// A solved sinkage is good to 1e-9, and what follows from it with it.
const SOLVED: f64 = 1e-8;

/// Some tens of roundings.
const ROUNDING: f64 = 1e-12;

const METHODS: [&str; 3] = ["quadrature", "linearised", "explicit"];

fn number(value: &Value, name: &str) -> f64 {
    value[name].as_f64().unwrap_or_else(|| panic!("{name} in {value}"))
}

fn wheel(changes: Value) -> Value {
    with(&with(&letter(), json!({"wheel": {"lug_height_m": 0.01}, "soil": {"cohesion_pa": 500}})), changes)
}

/// Solve the sinkage for the load, then give both: the same forces, and the soil's own modulus is what the load shows.
#[test]
fn a_load_with_its_own_sinkage_gives_the_same_forces_and_the_soils_modulus() {
    let same = |a: f64, b: f64, scale: f64| (a - b).abs() <= SOLVED * scale;
    for method in METHODS {
        for slip in [-0.3, 0.0, 0.2, 0.7] {
            let body = wheel(json!({"slip": slip, "method": method, "sinkage_m": null, "normal_load_n": 80}));
            let solved = post("/v1/forces", &body).ok();
            let both = post("/v1/forces", &with(&body, json!({"sinkage_m": solved["sinkage_m"]}))).ok();
            let scale = number(&solved["components"], "traction_n").abs() + number(&solved["components"], "resistance_n");
            assert!(
                same(number(&both, "longitudinal_force_n"), number(&solved, "longitudinal_force_n"), scale),
                "{method} {slip}"
            );
            assert!(same(number(&both, "torque_n_m"), number(&solved, "torque_n_m"), scale), "{method} {slip}");
            assert!(same(number(&both, "normal_force_n"), 80.0, 80.0), "{method} {slip}");
            assert!(same(number(&both, "sinkage_modulus") / 747_530.0, 1.0, 1.0), "{method} {slip}: −660/0.1 + 754130 Pa/m^N");
            assert_eq!((&solved["normal_stress_from"], &both["normal_stress_from"]), (&json!("soil"), &json!("load")));
            assert_eq!(both["sinkage_exponent"], 0.91);
        }
    }
}

/// The modulus that was sent has no influence; twice the load beyond what cohesion carries shows twice the modulus.
#[test]
fn the_load_takes_the_place_of_the_modulus() {
    for method in METHODS {
        let asked =
            |changes: Value| post("/v1/forces", &wheel(with(&json!({"method": method, "normal_load_n": 80}), changes))).ok();
        let softer = json!({"soil": {"pressure_sinkage": {"k_phi": 300_000}}});
        assert_eq!(asked(softer), asked(json!({})), "{method}");
        let dry = |load: f64| {
            let reply = asked(json!({"normal_load_n": load, "soil": {"cohesion_pa": 0}}));
            (number(&reply, "sinkage_modulus"), number(&reply, "longitudinal_force_n"))
        };
        let ((once, pull), (twice, twice_the_pull)) = (dry(80.0), dry(160.0));
        assert!((twice / once - 2.0).abs() < ROUNDING && (twice_the_pull / pull - 2.0).abs() < 1e3 * ROUNDING, "{method}");
    }
}

/// Slip, static sinkage and load: the sinkage follows by Lyasko's law, 0.01·1.2/0.9.
#[test]
fn slip_static_sinkage_and_load_are_enough() {
    let known = json!({"sinkage_m": null, "static_sinkage_m": 0.01, "normal_load_n": 80});
    for method in METHODS {
        let by = |changes: &Value| post("/v1/forces", &with(&wheel(json!({"method": method})), changes.clone()));
        let both = by(&known);
        assert_eq!(both.warned_of(), Vec::<String>::new(), "{method}: nothing drifts");
        let given = by(&json!({"sinkage_m": 0.01 * 1.2 / 0.9, "normal_load_n": 80})).ok();
        assert!((number(&both.ok(), "sinkage_m") - 0.01 * 1.2 / 0.9).abs() < 1e-16);
        assert!((number(&both.ok(), "longitudinal_force_n") / number(&given, "longitudinal_force_n") - 1.0).abs() < 1e-9);
    }
    // Without the load the normal force drifts, by the model's own figure.
    let of = |slip: f64| post("/v1/forces", &wheel(json!({"slip": slip, "sinkage_m": null, "static_sinkage_m": 0.01}))).ok();
    let (still, slipping) = (of(0.0), of(0.2));
    let warnings = slipping["warnings"].as_array().expect("warnings");
    let drift = warnings.iter().find(|warning| warning["code"] == "normal_force_drifts").expect("a warning");
    let expected = number(&slipping, "normal_force_n") / number(&still, "normal_force_n") - 1.0;
    assert!((number(drift, "value") - expected).abs() < ROUNDING);
}

#[test]
fn closed_forms_need_no_law_and_the_quadrature_names_it() {
    let bare = |changes: Value| with(&wheel(json!({"soil": {"pressure_sinkage": null}, "normal_load_n": 80})), changes);
    for method in ["linearised", "explicit"] {
        let with_law = post("/v1/forces", &wheel(json!({"normal_load_n": 80, "method": method}))).ok();
        let without = post("/v1/forces", &bare(json!({"method": method}))).ok();
        for name in ["longitudinal_force_n", "normal_force_n", "torque_n_m"] {
            assert_eq!(without[name], with_law[name], "{method} {name}");
        }
        assert_eq!((&without["sinkage_modulus"], &without["sinkage_exponent"]), (&Value::Null, &Value::Null));
        assert_eq!(
            post("/v1/forces", &bare(json!({"method": method, "normal_load_n": null}))).pointers(),
            ["/soil/pressure_sinkage"]
        );
        assert_eq!(
            post("/v1/forces", &bare(json!({"method": method, "sinkage_m": null}))).pointers(),
            ["/soil/pressure_sinkage"]
        );
    }
    assert_eq!(post("/v1/forces", &bare(json!({}))).pointers(), ["/soil/pressure_sinkage"]);
    assert_eq!(post("/v1/stress-profile", &bare(json!({}))).pointers(), ["/soil/pressure_sinkage"]);
    let several = bare(json!({"wheel": {"width_m": -1}}));
    assert_eq!(post("/v1/forces", &several).pointers(), ["/wheel/width_m", "/soil/pressure_sinkage"], "all faults at once");
    let compared = post("/v1/compare", &bare(json!({"methods": ["linearised", "explicit"]}))).ok();
    assert_eq!(compared["series"][0]["gap_to_quadrature"], json!({}), "without a law there is no quadrature to compare with");
    assert_eq!(post("/v1/compare", &bare(json!({}))).pointers(), ["/soil/pressure_sinkage"]);
}

#[test]
fn sweeps_comparisons_and_profiles_take_a_known_load() {
    let body = wheel(json!({"sinkage_m": null, "static_sinkage_m": 0.01, "normal_load_n": 80, "slip": 0.2}));
    let forces = post("/v1/forces", &body).ok();
    let slips = |list: Value| with(&with(&body, json!({"slip": null})), json!({"slip": list}));
    let sweep = post("/v1/slip-sweep", &slips(json!([0.1, 0.2, 0.5]))).ok();
    assert_eq!(sweep["normal_stress_from"], "load");
    for load in sweep["columns"]["normal_force_n"].as_array().expect("loads") {
        assert!((load.as_f64().expect("a load") / 80.0 - 1.0).abs() < ROUNDING);
    }
    assert_eq!(sweep["columns"]["longitudinal_force_n"][1], forces["longitudinal_force_n"]);
    let compared = post("/v1/compare", &slips(json!([0.2]))).ok();
    assert_eq!(compared["series"][0]["columns"]["longitudinal_force_n"][0], forces["longitudinal_force_n"]);
    assert_eq!(compared["series"][0]["normal_stress_from"], "load");
    // The profile is that of a soil with the modulus found.
    let profile = post("/v1/stress-profile", &body).ok();
    assert_eq!((&profile["sinkage_modulus"], &profile["normal_stress_from"]), (&forces["sinkage_modulus"], &json!("load")));
    let law = json!({"law": "direct", "k_s": forces["sinkage_modulus"], "n0": 0.91});
    let soil = with(&body["soil"], json!({"pressure_sinkage": null}));
    let of_soil = json!({"wheel": body["wheel"], "soil": with(&soil, json!({"pressure_sinkage": law})), "slip": 0.2, "sinkage_m": forces["sinkage_m"]});
    let expected = post("/v1/stress-profile", &of_soil).ok();
    assert_eq!(profile["columns"], expected["columns"]);
    assert_eq!(get(&format!("/v1/forces?{}", query_of(&body))).ok(), forces);
}

#[test]
fn what_no_normal_stress_carries_is_refused_at_the_load() {
    let light = wheel(json!({"soil": {"cohesion_pa": 1e5}, "normal_load_n": 1, "slip": 0.5}));
    for method in METHODS {
        assert_eq!(post("/v1/forces", &with(&light, json!({"method": method}))).pointers(), ["/normal_load_n"], "{method}");
    }
}

/// Telemetry: slip, z0 and load give pull and torque, in every form of a series, on a soil without a pressure–sinkage law.
#[test]
fn a_track_leads_from_slip_static_sinkage_and_load_to_pull_and_torque() {
    let soil = json!({"pressure_sinkage": null});
    let settings = with(
        &wheel(json!({"slip": null, "sinkage_m": null, "soil": soil})),
        json!({"static_sinkage_m": 0.01, "method": "linearised"}),
    );
    let constant = with(&settings, json!({"normal_load_n": 80}));
    let csv = "time_s,slip,normal_load_n\n0,0.1,80\n1,0.2,90\n";
    let answer = stream_to(&settings, "text/csv", "text/csv", csv);
    let lines: Vec<Vec<&str>> = answer.text.lines().take(3).map(|line| line.split(',').collect()).collect();
    let place = |name: &str| lines[0].iter().position(|known| *known == name).expect("a column");
    let cell = |row: usize, name: &str| lines[row + 1][place(name)].parse().ok();
    for (row, (slip, load)) in [(0.1, 80), (0.2, 90)].into_iter().enumerate() {
        let forces = post("/v1/forces", &with(&constant, json!({"slip": slip, "normal_load_n": load}))).ok();
        for name in ["sinkage_m", "longitudinal_force_n", "torque_n_m"] {
            assert_eq!(cell(row, name), forces[name].as_f64(), "{name}");
        }
    }
    let body = with(&constant, json!({"columns": {"time_s": [0], "slip": [0.1]}}));
    let reply = post("/v1/track", &body).ok();
    assert_eq!((&reply["normal_stress_from"], &reply["warnings"]), (&json!("load"), &json!([])));
    assert_eq!(reply["columns"]["longitudinal_force_n"][0].as_f64(), cell(0, "longitudinal_force_n"));
    // Without the load the law is needed, which a stream says once its columns are known.
    let unloaded = "time_s,slip\n0,0.1\n";
    assert_eq!(stream_to(&settings, "text/csv", "text/csv", unloaded).pointers(), ["/soil/pressure_sinkage"]);
    let integrated = with(&constant, json!({"method": "quadrature"}));
    assert_eq!(stream_to(&integrated, "text/csv", "text/csv", unloaded).pointers(), ["/soil/pressure_sinkage"]);
}

/// F_x = (A/H + B²/(A H)) T/r_s − (B/A) W: triangular stresses with σm = 9000 Pa in a contact of θ1 = 0.7 rad, integrated elsewhere.
#[test]
fn pull_from_torque_needs_no_soil() {
    let body = json!({
        "wheel": {"radius_m": 0.2, "width_m": 0.1}, "slip": 0.3, "sinkage_m": 0.2 * (1.0 - 0.7_f64.cos()),
        "normal_load_n": 70.459_026, "torque_n_m": 7.000_476_7
    });
    let bare = post("/v1/coupled", &body).ok();
    assert!((number(&bare, "longitudinal_force_n") - 11.163_064_3).abs() < 1e-6);
    let on_sand = post("/v1/coupled", &with(&body, json!({"soil": {"preset": "letter-sand"}}))).ok();
    assert_eq!(on_sand["longitudinal_force_n"], bare["longitudinal_force_n"], "a soil has no influence");
    assert_eq!(post("/v1/coupled", &with(&body, json!({"torque_n_m": null}))).pointers(), ["/soil"]);
    let against = post("/v1/coupled", &with(&body, json!({"torque_n_m": -6, "slip": 0.2})));
    assert!(against.warned_of().contains(&"torque_against_slip".to_owned()), "{:?}", against.warned_of());
}

/// The same as a column of a track, where torque, load and a sinkage are known; a torque of the wrong sign is told.
#[test]
fn a_track_has_the_pull_from_torque() {
    let series = json!({"time_s": [0, 1], "slip": [0.2, 0.3], "torque_n_m": [4, -5], "sinkage_m": [0.02, 0.03]});
    let body = wheel(json!({"slip": null, "sinkage_m": null, "normal_load_n": 80, "columns": series}));
    let reply = post("/v1/track", &body).ok();
    for (row, (slip, torque, sinkage)) in [(0.2, 4, 0.02), (0.3, -5, 0.03)].into_iter().enumerate() {
        let asked =
            json!({"wheel": body["wheel"], "slip": slip, "torque_n_m": torque, "sinkage_m": sinkage, "normal_load_n": 80});
        let coupled = post("/v1/coupled", &asked).ok();
        assert_eq!(reply["columns"]["longitudinal_force_coupled_n"][row], coupled["longitudinal_force_n"]);
    }
    let warnings = reply["warnings"].as_array().expect("warnings");
    let told = warnings.iter().find(|warning| warning["code"] == "torque_against_slip").expect("a warning");
    assert_eq!(told["rows"], json!([[1, 1]]));
}

/// Of Bekker's law alone the exponent counts, so that a request may leave the moduli out; the modulus that the load shows is the same.
#[test]
fn the_exponent_alone_is_enough_under_a_known_load() {
    for method in METHODS {
        for n0 in [0.91, 1.2] {
            let whole = wheel(json!({"method": method, "normal_load_n": 80, "soil": {"pressure_sinkage": {"n0": n0}}}));
            let mut alone = whole.clone();
            alone["soil"]["pressure_sinkage"] = json!({"n0": n0});
            let (by_law, by_exponent) = (post("/v1/forces", &whole).ok(), post("/v1/forces", &alone).ok());
            for name in ["longitudinal_force_n", "torque_n_m", "sinkage_modulus", "sinkage_exponent", "normal_stress_from"] {
                assert_eq!(by_law[name], by_exponent[name], "{method} {name}");
            }
            if method == "quadrature" {
                let profile = post("/v1/stress-profile", &alone).ok();
                assert_eq!(profile["columns"], post("/v1/stress-profile", &whole).ok()["columns"], "{n0}");
            }
        }
    }
    let slips = json!({"slip": {"from": 0, "to": 0.6, "points": 7}, "normal_load_n": 80});
    let mut alone = wheel(slips);
    alone["soil"]["pressure_sinkage"] = json!({"n0": 0.91, "n1": 0.3});
    let whole = with(&alone, json!({"soil": {"pressure_sinkage": {"law": "direct", "k_s": 747_530}}}));
    let swept = post("/v1/slip-sweep", &alone).ok();
    assert!(swept["columns"]["longitudinal_force_n"].as_array().is_some_and(|pulls| pulls.len() == 7), "{swept}");
    assert_eq!(swept["columns"], post("/v1/slip-sweep", &whole).ok()["columns"]);
}

/// Without the load nothing takes the place of the moduli, and an exponent out of bounds is a fault wherever it is read.
#[test]
fn an_exponent_alone_is_refused_without_a_load_or_beside_a_modulus_without_a_law() {
    let mut body = wheel(json!({}));
    body["soil"]["pressure_sinkage"] = json!({"n0": 0.91});
    assert_eq!(post("/v1/forces", &body).pointers(), ["/soil/pressure_sinkage/law"]);
    let solved = with(&body, json!({"sinkage_m": null, "normal_load_n": 80}));
    assert_eq!(post("/v1/forces", &solved).pointers(), ["/soil/pressure_sinkage/law"]);
    let known = with(&body, json!({"normal_load_n": 80}));
    let with_modulus = with(&known, json!({"soil": {"pressure_sinkage": {"k_phi": 8e5}}}));
    assert_eq!(post("/v1/forces", &with_modulus).pointers(), ["/soil/pressure_sinkage/law"]);
    let too_large = with(&known, json!({"soil": {"pressure_sinkage": {"n0": 99}}}));
    assert_eq!(post("/v1/forces", &too_large).pointers(), ["/soil/pressure_sinkage/n0"]);
    let no_exponent = with(&known, json!({"soil": {"pressure_sinkage": {"n0": null, "n1": 0.2}}}));
    assert_eq!(post("/v1/forces", &no_exponent).pointers(), ["/soil/pressure_sinkage/n0"]);
}

/// A soil of the catalogue whose moduli nobody published has its exponent: nothing has to be assumed.
#[test]
fn a_published_exponent_is_enough_under_a_known_load() {
    let soil = get("/v1/soils/wong-reece-loose-sand").ok();
    assert!(soil["soil"]["pressure_sinkage"].get("k_phi").is_none());
    let body = json!({
        "wheel": {"preset": "letter"}, "soil": {"preset": "wong-reece-loose-sand"}, "slip": 0.2, "sinkage_m": 0.02, "normal_load_n": 80
    });
    let found = post("/v1/forces", &body).ok();
    assert_eq!(found["sinkage_exponent"], soil["values"]["n0"]["value"]);
}

/// Loads of a hundred times and a tenth of what the soil carries at that sinkage are told, those that another soil of its kind could
/// carry are not.
#[test]
fn a_load_that_the_soil_does_not_carry_is_told() {
    let body = wheel(json!({"soil": {"cohesion_pa": 0}}));
    let carried = number(&post("/v1/forces", &body).ok(), "normal_force_n");
    let of = |factor: f64| post("/v1/forces", &with(&body, json!({"normal_load_n": factor * carried})));
    for (factor, is_told) in [(100.0, true), (7.0, true), (5.0, false), (1.0, false), (0.2, false), (0.15, true), (0.1, true)] {
        let answer = of(factor);
        assert_eq!(answer.warned_of().contains(&"modulus_unlike_soil".into()), is_told, "{factor}");
        let found = answer.ok();
        let told = found["warnings"].as_array().expect("warnings").iter().find(|one| one["code"] == "modulus_unlike_soil");
        if let Some(told) = told {
            // Without cohesion the normal force is proportional to the modulus.
            assert!((number(told, "value") / factor - 1.0).abs() < SOLVED, "{told}");
        }
    }
    // A soil that has no law of its own has nothing that a load could contradict.
    let mut alone = with(&body, json!({"normal_load_n": 100.0 * carried}));
    alone["soil"]["pressure_sinkage"] = json!({"n0": 0.91});
    assert!(!post("/v1/forces", &alone).warned_of().contains(&"modulus_unlike_soil".into()));
}
