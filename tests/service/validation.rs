//! `GET /v1/validation`.

use axum::body::Body;
use serde_json::{Value, json};

use crate::asking::{get, post, request, send, table, with};

/// A set is run by these, in this order: straight ahead, braking, at a slip angle; by the last of the first two only where the
/// density of the soil is known and the measurements are the set's own, and under a known load only where all sinkages were measured.
const METHODS: [&str; 7] = [
    "quadrature",
    "linearised",
    "explicit",
    "linearised_known_load",
    "linearised_known_load_from_standstill",
    "quadrature_known_load",
    GRAINS,
];
const BRAKING: [&str; 7] =
    ["quadrature", "linearised", "explicit", "quadrature_two_zone", "linearised_known_load", "quadrature_known_load", GRAINS];
const GRAINS: &str = "resistive_force";
pub(crate) const SIDEWAYS: [&str; 4] =
    ["quadrature", "quadrature_mobilised", "quadrature_coupled", "quadrature_coupled_mobilised"];

/// Tolerance for numbers that the test recomputes from the same doubles in another order of summation.
const ROUNDING: f64 = 1e-12;

/// A solved sinkage is good to 1e-9, and forces with it.
const SOLVED: f64 = 1e-8;

pub(crate) fn sets() -> Vec<Value> {
    get("/v1/validation").ok()["sets"].as_array().expect("sets").clone()
}

pub(crate) fn set(id: &str) -> Value {
    get(&format!("/v1/validation/{id}")).ok()
}

pub(crate) fn numbers(column: &Value) -> Vec<Option<f64>> {
    column.as_array().unwrap_or_else(|| panic!("a column: {column}")).iter().map(Value::as_f64).collect()
}

pub(crate) fn measured(set: &Value, name: &str) -> Vec<Option<f64>> {
    numbers(&set["columns"]["measured"][name])
}

pub(crate) fn predicted(set: &Value, series: &str, name: &str) -> Vec<Option<f64>> {
    numbers(&set["columns"]["predicted"][series][name])
}

/// Each result of a set with the name of its columns.
pub(crate) fn results(set: &Value) -> Vec<(&str, &Value)> {
    let results = set["results"].as_array().expect("results").iter();
    results.map(|result| (result["series"].as_str().expect("a name"), result)).collect()
}

#[test]
fn every_published_series_is_there_predicted_and_fitted_apart() {
    let known: Vec<(String, bool)> = sets()
        .iter()
        .map(|set| {
            let results = results(set);
            let (in_grains, by_laws): (Vec<_>, Vec<_>) = results.into_iter().partition(|(series, _)| *series == GRAINS);
            // Friction and density are from tests of their own in every set.
            assert!(in_grains.iter().all(|(_, result)| result["fitted"] == false));
            let fitted: Vec<bool> = by_laws.iter().filter_map(|(_, result)| result["fitted"].as_bool()).collect();
            assert_eq!(fitted, vec![fitted[0]; by_laws.len()], "one set is either fitted or not");
            assert_eq!(set["fitted_to"].is_string(), fitted[0], "a fit says what was fitted");
            (set["id"].as_str().expect("an id").to_owned(), fitted[0])
        })
        .collect();
    let expected = [
        ("ding-2011-smooth", false),
        ("ding-2011-smooth-fitted", true),
        ("ding-2011-lug10", false),
        ("ding-2011-lug10-fitted", true),
        ("wang-han-2016-smooth", false),
        ("wang-han-2016-smooth-fitted", true),
        ("wang-han-2016-lug10", false),
        ("wang-han-2016-lug10-fitted", true),
        ("hurrell-2025-rashid", false),
        ("yoshida-2003-24n", false),
        ("yoshida-2003-34n", false),
        ("yoshida-2003-54n", false),
        ("cmu-grousered-driving", true),
        ("cmu-grousered-braking", true),
        ("cmu-smooth-driving", true),
        ("cmu-smooth-braking", true),
        ("cmu-grousered-side-15", true),
        ("cmu-grousered-side-30", true),
        ("cmu-grousered-side-45", true),
        ("cmu-smooth-side-15", true),
        ("cmu-smooth-side-30", true),
        ("cmu-smooth-side-45", true),
        ("apollo-lrv", false),
    ];
    assert_eq!(known, expected.map(|(id, fitted)| (id.to_owned(), fitted)));
}

#[test]
fn a_set_is_run_by_what_its_wheel_calls_for() {
    for set in sets() {
        let id = set["id"].as_str().expect("an id");
        let has_density = ["ding-", "wang-", "hurrell-", "cmu-", "apollo-"].iter().any(|source| id.starts_with(source));
        let by_grains = has_density && !id.ends_with("-fitted");
        let knows_sinkage = !id.starts_with("yoshida-");
        let all: &[&str] = match id {
            _ if id.contains("-side-") => &SIDEWAYS,
            _ if id.ends_with("-braking") => &BRAKING,
            _ => &METHODS,
        };
        let is_run = |series: &&str| (by_grains || *series != GRAINS) && (knows_sinkage || !series.contains("known_load"));
        let expected: Vec<&str> = all.iter().copied().filter(is_run).collect();
        let found: Vec<&str> = results(&set).into_iter().map(|(series, _)| series).collect();
        assert_eq!(found, expected, "{id}");
        assert_eq!(set["columns"]["predicted"].as_object().expect("columns").len(), expected.len(), "{id}");
        for (series, result) in results(&set) {
            assert!(series.starts_with(result["method"].as_str().expect("a method")));
            assert_eq!(result["braking"] == "two_zone", series.ends_with("_two_zone"), "{id}");
            let known = match series.split_once("_known_load") {
                None => Value::Null,
                Some((_, "")) => json!("measured"),
                Some((_, _)) => json!("from_standstill"),
            };
            assert_eq!(result["sinkage_known"], known, "{id} {series}");
            if id.contains("-side-") {
                assert_eq!(result["shear_coupling"] == "coupled", series.contains("_coupled"), "{id}");
                assert_eq!(result["bulldozing"] == "mobilised", series.ends_with("_mobilised"), "{id}");
            } else {
                assert!(result["shear_coupling"].is_null() && result["bulldozing"].is_null(), "{id}");
            }
        }
    }
}

#[test]
fn a_set_alone_is_the_one_among_all_and_an_unknown_one_is_refused() {
    for each in sets() {
        assert_eq!(set(each["id"].as_str().expect("an id")), each);
    }
    let detail = get("/v1/validation/ding-2011-smoth").problem(404)["detail"].as_str().expect("a detail").to_owned();
    assert!(detail.contains("did you mean `ding-2011-smooth`?"), "{detail}");
}

/// Facts of the sources, as they were published or read off: slip, then what was measured there.
#[test]
fn measured_points_are_those_of_the_sources() {
    let facts = [
        // Ding et al. 2011, Fig. 9: the wheel of 157.35 mm and 165 mm under 80 N, smooth and with lugs of 10 mm.
        ("ding-2011-smooth", 0.0, Some(-6.5), Some(0.005), Some(0.0)),
        ("ding-2011-smooth", 0.2, Some(14.5), Some(0.0075), Some(4.2)),
        ("ding-2011-smooth-fitted", 0.6, Some(15.0), Some(0.0175), Some(5.3)),
        ("ding-2011-lug10", 0.6, Some(24.5), Some(0.027), Some(7.2)),
        // Wang & Han 2016, Fig. 14: 58.86 N on KLS-1.
        ("wang-han-2016-smooth", 0.3, Some(2.0), Some(0.0045), Some(1.9)),
        ("wang-han-2016-lug10", 0.4, Some(12.7), Some(0.0096), Some(3.1)),
        ("wang-han-2016-lug10-fitted", 0.5, Some(6.4), Some(0.0135), Some(2.85)),
        // Hurrell et al. 2025, Figs. 5 and 6: traction coefficient 0.429 of 24.5 N, to the tenth of a newton.
        ("hurrell-2025-rashid", 0.5, Some(10.5), Some(0.0195), None),
        // Yoshida et al. 2003, Fig. 3 (and Fig. 4 for the sinkage).
        ("yoshida-2003-24n", 0.764, Some(7.78), Some(0.03), None),
        ("yoshida-2003-34n", 0.72, Some(17.42), None, None),
        ("yoshida-2003-54n", 0.809, Some(29.87), None, None),
        // Pavlov & Johnson 2024: locked, rolling and driving.
        ("cmu-grousered-braking", -1.0, Some(-38.9417), Some(0.0492498), None),
        ("cmu-grousered-driving", 0.899539, Some(4.76253), Some(0.0420694), None),
        ("cmu-smooth-braking", -1.0, Some(-38.8447), Some(0.050314), None),
        ("cmu-smooth-driving", 0.500002, Some(0.966554), Some(0.02274), None),
        // Carrier 2006: ruts of about 1.25 cm.
        ("apollo-lrv", 0.025, None, Some(0.0125), None),
    ];
    for (id, slip, force, sinkage, torque) in facts {
        let set = set(id);
        let row =
            numbers(&set["columns"]["slip"]).iter().position(|at| *at == Some(slip)).unwrap_or_else(|| panic!("{id} at {slip}"));
        let names = ["longitudinal_force_n", "sinkage_m", "torque_n_m"];
        assert_eq!(names.map(|name| measured(&set, name)[row]), [force, sinkage, torque], "{id} at {slip}");
    }
    let counts = sets().iter().map(|set| set["points"].as_u64().expect("points")).collect::<Vec<_>>();
    assert_eq!(counts, [6, 6, 6, 6, 5, 5, 5, 5, 5, 12, 6, 6, 5, 4, 5, 4, 9, 9, 9, 9, 9, 9, 1]);
}

/// Whether a measured column counts in no error.
fn is_not_scored(set: &Value, name: &str) -> bool {
    set["not_scored"].as_array().is_some_and(|columns| columns.iter().any(|of| of["column"] == name))
}

/// The errors follow from the columns of the reply, row by row, without what was not measured or has no solution.
#[test]
fn every_error_is_that_of_the_columns() {
    let mut errors = 0;
    for set in sets() {
        let load = numbers(&set["columns"]["normal_load_n"]);
        for (series, result) in results(&set) {
            let members = [
                ("drawbar_rmse_over_load", "longitudinal_force_n", true),
                ("sinkage_rmse_m", "sinkage_m", false),
                ("torque_rmse_n_m", "torque_n_m", false),
                ("lateral_rmse_over_load", "lateral_force_n", true),
            ];
            let is_sideways = set["slip_angle_rad"].is_number();
            for (member, name, is_over_load) in members {
                let scale = |row: usize| if is_over_load { load[row].expect("a load") } else { 1.0 };
                if name == "lateral_force_n" && !is_sideways {
                    assert!(result[member].is_null() && set["columns"]["measured"][name].is_null());
                    continue;
                }
                if is_not_scored(&set, name) {
                    assert!(result[member].is_null() && measured(&set, name).iter().any(Option::is_some));
                    continue;
                }
                let pairs = predicted(&set, series, name).into_iter().zip(measured(&set, name)).enumerate();
                let squares: Vec<f64> = pairs.filter_map(|(row, (a, b))| Some(((a? - b?) / scale(row)).powi(2))).collect();
                let place = format!("{} {series} {member}", set["id"]);
                // A sinkage that was given is no prediction.
                let is_given = name == "sinkage_m" && result["sinkage_known"] == "measured";
                if squares.is_empty() || is_given {
                    assert!(result[member].is_null(), "{place}");
                } else {
                    let expected = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
                    let stated = result[member].as_f64().expect("a number");
                    assert!((stated - expected).abs() <= ROUNDING * expected, "{place}: {stated}, not {expected}");
                    errors += 1;
                }
            }
            let sinkages = predicted(&set, series, "sinkage_m");
            let solved = sinkages.iter().flatten().count();
            assert_eq!((&result["solved"], &result["unsolved"]), (&json!(solved), &json!(sinkages.len() - solved)), "{series}");
        }
    }
    assert!(errors > 17 * 3 + 6 * 4 * 3, "only {errors} errors were computed");
}

#[test]
fn columns_are_of_one_length() {
    for set in sets() {
        let columns = &set["columns"];
        let mut groups = vec![&columns["measured"]];
        groups.extend(results(&set).iter().map(|(series, _)| &columns["predicted"][series]));
        let mut further = vec![&columns["slip"], &columns["normal_load_n"]];
        if set["slip_angle_rad"].is_number() {
            groups.push(&columns["contact"]);
            further.push(&columns["travel_slip"]);
        }
        let in_groups = groups.into_iter().flat_map(|group| group.as_object().expect("columns").values());
        for column in in_groups.chain(further) {
            assert_eq!(column.as_array().map(Vec::len), set["points"].as_u64().map(|points| points as usize), "{}", set["id"]);
        }
    }
}

/// The sinkage (m) at the standstill that goes with the first point by (18).
fn standstill(set: &Value) -> f64 {
    let [slip, sinkage] = [numbers(&set["columns"]["slip"]), measured(set, "sinkage_m")].map(|of| of[0].expect("a number"));
    sinkage * (1.0 - 0.5 * slip) / (1.0 + slip)
}

/// Anyone can ask for a point with the wheel, soil, contact and slip angle of the set and the laws of the result.
#[test]
fn every_prediction_is_what_forces_gives() {
    for set in sets() {
        let columns = &set["columns"];
        let mut body = json!({"wheel": set["wheel"], "soil": set["soil"], "slip_radius": set["slip_radius"]});
        for name in ["contact", "slip_angle_rad"] {
            if !set[name].is_null() {
                body[name] = set[name].clone();
            }
        }
        for row in 0..set["points"].as_u64().expect("points") as usize {
            body["slip"] = columns["slip"][row].clone();
            body["normal_load_n"] = columns["normal_load_n"][row].clone();
            if columns["contact"].is_object() {
                let (c1, c3) = (&columns["contact"]["c1"][row], &columns["contact"]["c3"][row]);
                body["contact"] = json!({"rule": "wong_reece", "c1": c1, "c2": 0, "c3": c3});
            }
            for (series, result) in results(&set) {
                let mut asked = body.clone();
                for name in ["method", "braking", "shear_coupling", "bulldozing"] {
                    if !result[name].is_null() {
                        asked[name] = result[name].clone();
                    }
                }
                match result["sinkage_known"].as_str() {
                    Some("measured") => asked["sinkage_m"] = columns["measured"]["sinkage_m"][row].clone(),
                    Some(_) => asked["static_sinkage_m"] = standstill(&set).into(),
                    None => {}
                }
                let place = format!("{} {series} {row}", set["id"]);
                let Some(sinkage) = predicted(&set, series, "sinkage_m")[row] else {
                    assert!(post("/v1/forces", &asked).problem(422)["errors"].is_array(), "{place}");
                    continue;
                };
                let forces = post("/v1/forces", &asked).ok();
                let is = |name: &str, here: f64| {
                    let there = forces[name].as_f64().expect("a value");
                    assert!((here - there).abs() <= SOLVED * there.abs().max(SOLVED), "{place} {name}: {here}, {there}");
                };
                is("sinkage_m", sinkage);
                for name in ["longitudinal_force_n", "torque_n_m", "lateral_force_n"] {
                    if !columns["predicted"][series][name].is_null() {
                        is(name, predicted(&set, series, name)[row].expect("a value"));
                    }
                }
                is("normal_force_n", body["normal_load_n"].as_f64().expect("a load"));
            }
        }
    }
}

#[test]
fn points_without_a_solution_are_null_counted_and_warned_of() {
    let mut gaps = 0;
    for set in sets() {
        let warnings = set["warnings"].as_array().expect("warnings");
        for (series, result) in results(&set) {
            let unsolved = result["unsolved"].as_u64().expect("a count");
            let of_series = |warning: &&Value| {
                warning["code"] == "no_solution"
                    && warning["series"].as_array().is_none_or(|names| names.contains(&json!(series)))
            };
            let counts: Vec<u64> = warnings.iter().filter(of_series).filter_map(|warning| warning["count"].as_u64()).collect();
            assert_eq!(counts, if unsolved > 0 { vec![unsolved] } else { vec![] }, "{} {series}", set["id"]);
            gaps += unsolved;
        }
    }
    assert!(gaps > 0, "the locked wheel of the smooth set is more than the closed forms carry");
}

/// What all methods have in common is not repeated for each.
#[test]
fn a_warning_of_all_methods_is_said_once_and_names_none() {
    let set = set("ding-2011-smooth");
    let of = |code: &str| set["warnings"].as_array().expect("warnings").iter().filter(|w| w["code"] == code).count();
    assert_eq!(of("small_wheel"), 1);
    for set in sets() {
        let warnings = set["warnings"].as_array().expect("warnings");
        for (i, warning) in warnings.iter().enumerate() {
            // Only the place may tell two warnings of one kind and one value apart.
            let said = |of: &Value| (of["code"].clone(), of["value"].clone(), of["range"].clone(), of["rows"].clone());
            let is_of_a_range = warning["range"].is_object();
            let again = warnings[i + 1..].iter().filter(|other| is_of_a_range && said(other) == said(warning)).count();
            assert_eq!(again, 0, "{}: {warning}", set["id"]);
            let names_all = results(&set)
                .iter()
                .all(|(series, _)| warning["series"].as_array().is_some_and(|names| names.contains(&json!(series))));
            assert!(!names_all, "{}: {warning}", set["id"]);
        }
    }
}

/// Wong and Reece's integrals, computed elsewhere with the authors' soil, contact and exit angles on the radius over the
/// grousers, reach the measured pull within 1.2 N and the sinkage within a fifth up to 75 % slip. The authors' values go with a
/// displacement that is counted on the rim.
#[test]
fn the_integral_meets_the_grousered_wheel_of_carnegie_mellon() {
    const PULL_N: f64 = 1.2;
    const SINKAGE_SHARE: f64 = 0.2;
    let set = set("cmu-grousered-driving");
    let slips = numbers(&set["columns"]["slip"]);
    let rows: Vec<usize> = (0..slips.len()).filter(|&row| slips[row].is_some_and(|slip| slip < 0.8)).collect();
    assert_eq!(rows.len(), 4);
    let body = json!({"wheel": set["wheel"], "soil": set["soil"], "contact": set["contact"], "shear_displacement_radius": "rim"});
    for row in rows {
        let value = |column: Vec<Option<f64>>| column[row].expect("a value");
        let (slip, load) = (&set["columns"]["slip"][row], &set["columns"]["normal_load_n"][row]);
        let forces = post("/v1/forces", &with(&body, json!({"slip": slip, "normal_load_n": load}))).ok();
        let number = |name: &str| forces[name].as_f64().expect("a number");
        let pull = number("longitudinal_force_n") - value(measured(&set, "longitudinal_force_n"));
        let sinkage = number("sinkage_m") / value(measured(&set, "sinkage_m")) - 1.0;
        assert!(pull.abs() <= PULL_N && sinkage.abs() <= SINKAGE_SHARE, "slip {:?}: {pull} N, {sinkage}", slips[row]);
    }
}

/// The exponents of a fitted set are the line through those that carry the load at the measured sinkages.
#[test]
fn a_fitted_exponent_is_the_line_through_those_that_carry_the_load() {
    /// The records have two decimals.
    const HALF_A_DIGIT: f64 = 0.005;
    for id in ["ding-2011-smooth", "ding-2011-lug10", "wang-han-2016-smooth", "wang-han-2016-lug10"] {
        let (plain, fitted) = (set(id), set(&format!("{id}-fitted")));
        assert_eq!(plain["columns"]["measured"], fitted["columns"]["measured"]);
        let law = &fitted["soil"]["pressure_sinkage"];
        let load = plain["columns"]["normal_load_n"][0].as_f64().expect("a load");
        let exponent = |slip: f64, sinkage: f64| -> f64 {
            let carried = |exponent: f64| {
                let soil = with(&fitted["soil"], json!({"pressure_sinkage": {"n0": exponent, "n1": 0}}));
                let (wheel, circle) = (&fitted["wheel"], &fitted["slip_radius"]);
                let body = json!({"wheel": wheel, "soil": soil, "slip": slip, "slip_radius": circle, "sinkage_m": sinkage});
                post("/v1/forces", &body).ok()["normal_force_n"].as_f64().expect("a force")
            };
            let (mut stiff, mut soft) = (0.1, 3.0);
            for _ in 0..20 {
                let middle = 0.5 * (stiff + soft);
                if carried(middle) > load { stiff = middle } else { soft = middle }
            }
            0.5 * (stiff + soft)
        };
        let points: Vec<(f64, f64)> = numbers(&plain["columns"]["slip"])
            .into_iter()
            .zip(measured(&plain, "sinkage_m"))
            .map(|(slip, sinkage)| (slip.expect("a slip"), sinkage.expect("a sinkage")))
            .map(|(slip, sinkage)| (slip, exponent(slip, sinkage)))
            .collect();
        let count = points.len() as f64;
        let (mean_slip, mean) =
            (points.iter().map(|p| p.0).sum::<f64>() / count, points.iter().map(|p| p.1).sum::<f64>() / count);
        let gain = points.iter().map(|p| (p.0 - mean_slip) * (p.1 - mean)).sum::<f64>()
            / points.iter().map(|p| (p.0 - mean_slip).powi(2)).sum::<f64>();
        for (name, found) in [("n0", mean - gain * mean_slip), ("n1", gain)] {
            let stated = law[name].as_f64().expect("a number");
            assert!((stated - found).abs() <= HALF_A_DIGIT, "{id} {name}: {stated}, not {found}");
        }
    }
}

/// The plate tests of Yoshida et al. 2003 (sinkage in mm, pressure in Pa) give the moduli by ln p = ln k_i + n ln z with one n
/// for both plates and weights p², k_i = k_c/b_i + k_phi.
#[test]
fn the_moduli_of_the_dry_sand_are_the_weighted_fit_of_its_plate_tests() {
    const PLATES: [(f64, [(f64, f64); 8]); 2] = [
        (
            0.06,
            [
                (0.71, 247.0),
                (1.017, 342.0),
                (1.116, 438.0),
                (1.522, 629.0),
                (1.829, 885.0),
                (2.134, 1100.0),
                (2.538, 1291.0),
                (2.639, 1461.0),
            ],
        ),
        (
            0.116,
            [
                (0.813, 469.0),
                (0.914, 684.0),
                (1.219, 974.0),
                (1.421, 1371.0),
                (1.93, 1744.0),
                (2.233, 2096.0),
                (2.538, 2465.0),
                (3.045, 2826.0),
            ],
        ),
    ];
    let mut slope = (0.0, 0.0);
    let means = PLATES.map(|(width, points)| {
        let logs = points.map(|(z, p): (f64, f64)| ((1e-3 * z).ln(), p.ln(), p * p));
        let weight: f64 = logs.iter().map(|(_, _, w)| w).sum();
        let x = logs.iter().map(|(x, _, w)| w * x).sum::<f64>() / weight;
        let y = logs.iter().map(|(_, y, w)| w * y).sum::<f64>() / weight;
        slope.0 += logs.iter().map(|(lx, ly, w)| w * (lx - x) * (ly - y)).sum::<f64>();
        slope.1 += logs.iter().map(|(lx, _, w)| w * (lx - x).powi(2)).sum::<f64>();
        (width, x, y)
    });
    let exponent = slope.0 / slope.1;
    let [(narrow, k_narrow), (wide, k_wide)] = means.map(|(width, x, y)| (width, (y - exponent * x).exp()));
    let k_c = (k_narrow - k_wide) / (1.0 / narrow - 1.0 / wide);
    let law = set("yoshida-2003-24n")["soil"]["pressure_sinkage"].clone();
    for (name, found, half_a_digit) in [("n0", exponent, 5e-5), ("k_c", k_c, 0.5), ("k_phi", k_narrow - k_c / narrow, 0.5)] {
        let stated = law[name].as_f64().expect("a number");
        assert!((stated - found).abs() <= half_a_digit, "{name}: {stated}, not {found}");
    }
    for other in ["yoshida-2003-34n", "yoshida-2003-54n"] {
        assert_eq!(set(other)["soil"]["pressure_sinkage"], law);
    }
}

#[test]
fn a_set_comes_as_a_table() {
    let answer = send(request("GET", "/v1/validation/cmu-smooth-braking", &[("accept", "text/csv")], Body::empty()));
    assert!(answer.header("content-type").starts_with("text/csv"));
    assert!(answer.header("x-warnings").contains("no_solution"));
    let set = set("cmu-smooth-braking");
    for (name, column) in table(&answer.text) {
        let pointer = format!("/columns/{}", name.replace('.', "/"));
        assert_eq!(column, numbers(set.pointer(&pointer).unwrap_or_else(|| panic!("{pointer}"))), "{name}");
    }
    assert_eq!(answer.text.lines().count(), 5);
    assert_eq!(table(&answer.text).len(), 2 + 4 + BRAKING.len() * 4);
}
