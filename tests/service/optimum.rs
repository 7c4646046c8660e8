//! `POST /v1/optimum`, against dense grids by `/v1/sweep` and single points by `/v1/forces`.

use serde_json::{Value, json};

use crate::asking::{letter, post, post_for_csv, table, with};

/// Share by which a point that was found may be beaten by a grid: nothing but rounding.
const ROUNDING: f64 = 1e-6;

/// Mass of an aluminium rim of 2 mm.
pub(crate) const MASS: &str = "2700 * 0.002 * 2 * pi * radius_m * width_m";

fn mass(radius: f64, width: f64) -> f64 {
    2700.0 * 0.002 * std::f64::consts::TAU * radius * width
}

/// A wheel under a load, whose sinkage follows from it.
fn loaded() -> Value {
    with(&letter(), json!({"sinkage_m": null, "normal_load_n": 60, "wheel": null}))
}

/// Radius and width of a wheel.
pub(crate) fn wheels() -> Value {
    json!([
        {"field": "/wheel/radius_m", "from": 0.05, "to": 0.2},
        {"field": "/wheel/width_m", "from": 0.03, "to": 0.2}
    ])
}

pub(crate) fn sought(variables: Value, goal: Value) -> Value {
    with(&json!({"of": "forces", "request": loaded(), "variables": variables}), goal)
}

pub(crate) fn optimum(body: &Value) -> Value {
    post("/v1/optimum", body).ok()
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn value_of(found: &Value, variable: usize) -> f64 {
    number(&found["variables"][variable]["value"])
}

/// A dense grid over the wheels of [`wheels`]: radius, width, and some quantities of each that has them.
fn grid(names: [&str; 2]) -> Vec<[f64; 4]> {
    const POINTS: usize = 41;
    let axes = json!([
        {"field": "/wheel/radius_m", "from": 0.05, "to": 0.2, "points": POINTS},
        {"field": "/wheel/width_m", "from": 0.03, "to": 0.2, "points": POINTS}
    ]);
    let found = post("/v1/sweep", &json!({"of": "forces", "request": loaded(), "axes": axes})).ok();
    let column = |name: &str| found["columns"][name].as_array().unwrap_or_else(|| panic!("a column {name}")).clone();
    let columns = ["wheel.radius_m", "wheel.width_m", names[0], names[1]].map(column);
    let rows = (0..POINTS * POINTS).filter_map(|row| {
        let cells: Vec<f64> = columns.iter().filter_map(|column| column[row].as_f64()).collect();
        <[f64; 4]>::try_from(cells).ok()
    });
    let rows: Vec<_> = rows.collect();
    assert!(rows.len() > POINTS * POINTS * 9 / 10, "{} points", rows.len());
    rows
}

/// What `/v1/forces` gives for the wheel that was found.
fn forces_at(found: &Value) -> Value {
    let wheel = json!({"radius_m": value_of(found, 0), "width_m": value_of(found, 1)});
    post("/v1/forces", &with(&loaded(), json!({"wheel": wheel}))).ok()
}

#[test]
fn the_lightest_wheel_that_pulls_is_lighter_than_any_of_a_dense_grid_and_keeps_its_constraints() {
    let (pull, sinkage) = (6.0, 0.035);
    let constraints = json!([
        {"quantity": "longitudinal_force_n", "at_least": pull},
        {"quantity": "sinkage_m", "at_most": sinkage}
    ]);
    let found = optimum(&sought(wheels(), json!({"minimise": MASS, "constraints": constraints.clone()})));
    assert_eq!((&found["feasible"], &found["converged"]), (&json!(true), &json!(true)));
    let (radius, width, least) = (value_of(&found, 0), value_of(&found, 1), number(&found["objective"]));
    assert!((mass(radius, width) - least).abs() < 1e-12);

    let alone = forces_at(&found);
    for name in ["longitudinal_force_n", "sinkage_m", "torque_n_m", "drawbar_coefficient", "normal_force_n"] {
        assert_eq!(found["quantities"][name], alone[name], "{name}");
    }
    assert!(number(&alone["longitudinal_force_n"]) >= pull * (1.0 - ROUNDING));
    assert!(number(&alone["sinkage_m"]) <= sinkage * (1.0 + ROUNDING));

    let grid = grid(["longitudinal_force_n", "sinkage_m"]);
    let kept = grid.iter().filter(|row| row[2] >= pull && row[3] <= sinkage);
    let best = kept.map(|row| mass(row[0], row[1])).fold(f64::INFINITY, f64::min);
    assert!(least <= best * (1.0 + ROUNDING), "{least} but the grid has {best}");
    // One step of the grid changes radius and width by at most a tenth.
    assert!(least > 0.8 * best, "{least} but the grid has {best}");

    let active: Vec<bool> = found["constraints"].as_array().expect("constraints").iter().map(|of| of["active"] == true).collect();
    assert!(active[0], "the pull holds the wheel: {found}");
    // A pull of a hundredth less would do with a lighter wheel, by what a search for that pull finds.
    let looser = json!([{"quantity": "longitudinal_force_n", "at_least": 0.99 * pull}, constraints[1]]);
    let other = optimum(&sought(wheels(), json!({"minimise": MASS, "constraints": looser})));
    let told = number(&found["constraints"][0]["objective_if_looser"]);
    assert!(told < least && (told / number(&other["objective"]) - 1.0).abs() < ROUNDING, "{told} {other}");
    for constraint in found["constraints"].as_array().expect("constraints") {
        let name = constraint["quantity"].as_str().expect("a name");
        assert_eq!(constraint["value"], alone[name], "{name}");
        assert!(constraint["met"] == true && constraint["best"].is_null() && number(&constraint["margin"]) >= -ROUNDING);
    }
}

#[test]
fn the_wheel_of_a_given_mass_that_pulls_best_beats_all_of_a_grid() {
    // Which radius and width are best, where both share one mass: the question that Ding et al. ask of a rover's wheel.
    let most = 0.25;
    let constraints = json!([{"quantity": MASS, "at_most": most}]);
    let found = optimum(&sought(wheels(), json!({"maximise": "longitudinal_force_n", "constraints": constraints})));
    let pull = number(&found["objective"]);
    assert_eq!(found["quantities"]["longitudinal_force_n"], found["objective"]);
    let (radius, width) = (value_of(&found, 0), value_of(&found, 1));
    assert!(mass(radius, width) <= most * (1.0 + ROUNDING));
    let grid = grid(["longitudinal_force_n", "sinkage_m"]);
    let best = grid.iter().filter(|row| mass(row[0], row[1]) <= most).map(|row| row[2]).fold(f64::NEG_INFINITY, f64::max);
    assert!(pull >= best - ROUNDING && pull < best + 1.0, "{pull} but the grid has {best}");
    // Along the curve of that mass no wheel pulls more.
    for share in 0..=50 {
        let radius = 0.05 + 0.15 * f64::from(share) / 50.0;
        let width = (most / mass(radius, 1.0)).min(0.2);
        let other = post("/v1/forces", &with(&loaded(), json!({"wheel": {"radius_m": radius, "width_m": width}}))).ok();
        assert!(number(&other["longitudinal_force_n"]) <= pull + ROUNDING, "{radius} {other}");
    }
}

#[test]
fn the_slip_of_the_best_efficiency_is_that_of_a_dense_sweep() {
    const POINTS: usize = 951;
    let wheel = json!({"radius_m": 0.1, "width_m": 0.1});
    let request = with(&loaded(), json!({"wheel": wheel, "slip": null}));
    let variables = json!([{"field": "/slip", "from": 0.0, "to": 0.95}]);
    let found = optimum(&json!({"of": "forces", "request": request, "variables": variables, "maximise": "tractive_efficiency"}));
    let slips = with(&request, json!({"slip": {"from": 0, "to": 0.95, "points": POINTS}}));
    let columns = post("/v1/slip-sweep", &slips).ok()["columns"].clone();
    let efficiencies = columns["tractive_efficiency"].as_array().expect("efficiencies");
    let best = (0..POINTS)
        .filter(|&i| efficiencies[i].is_f64())
        .max_by(|&a, &b| number(&efficiencies[a]).total_cmp(&number(&efficiencies[b])));
    let best = best.expect("one of them");
    assert!((value_of(&found, 0) - number(&columns["slip"][best])).abs() <= 0.001, "{found}");
    let gain = number(&found["objective"]) - number(&efficiencies[best]);
    assert!((0.0..1e-4).contains(&gain), "{gain}");
    assert_eq!((&found["converged"], &found["agreed"]), (&json!(true), &found["searches"]));
}

#[test]
fn ground_clearance_is_a_formula_of_radius_and_sinkage() {
    let clearance = "radius_m - sinkage_m - 0.05";
    let goal = json!({"minimise": "torque_n_m", "constraints": [{"quantity": clearance, "at_least": 0.04}]});
    let found = optimum(&sought(wheels(), goal));
    let (radius, sinkage) = (value_of(&found, 0), number(&found["quantities"]["sinkage_m"]));
    assert!(radius - sinkage - 0.05 >= 0.04 - ROUNDING, "{found}");
    let grid = grid(["torque_n_m", "sinkage_m"]);
    let best = grid.iter().filter(|row| row[0] - row[3] >= 0.09).map(|row| row[2]).fold(f64::INFINITY, f64::min);
    assert!(number(&found["objective"]) <= best * (1.0 + ROUNDING), "{found} but the grid has {best}");
}

#[test]
fn what_no_wheel_can_do_is_told_with_the_wheel_that_comes_nearest() {
    let constraints = json!([
        {"quantity": "longitudinal_force_n", "at_least": 40},
        {"quantity": "sinkage_m", "at_most": 0.035}
    ]);
    let found = optimum(&sought(wheels(), json!({"minimise": MASS, "constraints": constraints})));
    assert_eq!(found["feasible"], false);
    let [pull, sinkage] = [0, 1].map(|i| &found["constraints"][i]);
    assert_eq!((&pull["met"], &pull["met_alone"], &sinkage["met"]), (&json!(false), &json!(false), &json!(true)));
    let best = grid(["longitudinal_force_n", "sinkage_m"]).iter().map(|row| row[2]).fold(f64::NEG_INFINITY, f64::max);
    let reached = number(&pull["best"]);
    assert!(reached >= best - ROUNDING && reached < best + 1.0, "{reached} but the grid has {best}");
    assert!(
        (number(&pull["value"]) - reached).abs() < 1e-3 && (number(&pull["margin"]) + 40.0 - reached).abs() < 1e-3,
        "{found}"
    );
    assert!(found["agreed"].is_null() && found["variables"][0]["agreed_from"].is_null());

    // Each of these can be met, but not both: a wheel of 0.1 kg, and one that hardly sinks.
    let constraints = json!([{"quantity": MASS, "at_most": 0.1}, {"quantity": "sinkage_m", "at_most": 0.015}]);
    let found = optimum(&sought(wheels(), json!({"maximise": "longitudinal_force_n", "constraints": constraints})));
    assert_eq!(found["feasible"], false);
    for constraint in found["constraints"].as_array().expect("constraints") {
        assert!(constraint["met"] == true || constraint["met_alone"] == true, "{constraint}");
    }
    let misses = |row: &[f64; 4]| mass(row[0], row[1]) > 0.1 || row[3] > 0.015;
    assert!(grid(["longitudinal_force_n", "sinkage_m"]).iter().all(misses));
}

#[test]
fn a_trade_off_is_a_curve_that_no_wheel_of_a_dense_grid_is_below() {
    let body = sought(
        wheels(),
        json!({
            "minimise": MASS, "against": {"maximise": "longitudinal_force_n", "points": 15}, "evaluations": 10_000,
            "constraints": [{"quantity": "sinkage_m", "at_most": 0.05}]
        }),
    );
    let found = optimum(&body);
    let list =
        |name: &str| found["columns"][name].as_array().unwrap_or_else(|| panic!("a column {name}")).iter().map(number).collect();
    let (masses, pulls): (Vec<f64>, Vec<f64>) = (list("objective"), list("against"));
    let sinkages: Vec<f64> = list("sinkage_m");
    assert!((12..=15).contains(&masses.len()), "{}", masses.len());
    assert!(masses.windows(2).all(|pair| pair[0] < pair[1]) && pulls.windows(2).all(|pair| pair[0] < pair[1]));
    assert!(sinkages.iter().all(|sinkage| *sinkage <= 0.05 * (1.0 + ROUNDING)));
    assert_eq!(pulls, list("longitudinal_force_n"));
    for row in grid(["longitudinal_force_n", "sinkage_m"]).iter().filter(|row| row[3] <= 0.05) {
        // A wheel of the grid that pulls as well as a point of the curve is not lighter.
        let below =
            (0..masses.len()).find(|&i| row[2] >= pulls[i] + ROUNDING && mass(row[0], row[1]) < masses[i] * (1.0 - ROUNDING));
        assert_eq!(below, None, "{row:?}");
    }
    // Its ends are what each goal gives alone.
    let constraints = body["constraints"].clone();
    let lightest = optimum(&sought(wheels(), json!({"minimise": MASS, "constraints": constraints})));
    let strongest = optimum(&sought(wheels(), json!({"maximise": "longitudinal_force_n", "constraints": constraints})));
    assert!((masses[0] / number(&lightest["objective"]) - 1.0).abs() < 1e-4, "{lightest}");
    assert!((pulls[pulls.len() - 1] / number(&strongest["objective"]) - 1.0).abs() < 1e-4, "{strongest}");

    let csv = table(post_for_csv("/v1/optimum", &body).text.as_str());
    assert_eq!(csv[0].0, "objective");
    assert_eq!(csv[0].1, masses.iter().copied().map(Some).collect::<Vec<_>>());
}

#[test]
fn the_best_point_as_a_table_has_one_row() {
    let variables = json!([{"field": "/slip", "from": 0.0, "to": 0.9}]);
    let request = with(&loaded(), json!({"wheel": {"radius_m": 0.1, "width_m": 0.1}}));
    let body = json!({"of": "forces", "request": request, "variables": variables, "maximise": "longitudinal_force_n"});
    let found = optimum(&body);
    let csv = table(post_for_csv("/v1/optimum", &body).text.as_str());
    let names: Vec<&str> = csv.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names[..3], ["objective", "slip", "sinkage_m"]);
    assert!(csv.iter().all(|(_, column)| column.len() == 1));
    assert_eq!(csv[1].1[0], Some(value_of(&found, 0)));
    // The pull of Janosi's law grows with slip as far as it may.
    assert_eq!((&found["variables"][0]["at_bound"], value_of(&found, 0)), (&json!("to"), 0.9));
}

/// A rover of 20 kg on the Moon, by the closed forms.
pub(crate) fn rover() -> Value {
    json!({
        "mass_kg": 20, "gravity_m_s2": 1.625, "slope_rad": 0.1, "method": "linearised",
        "wheels": {"count": 4, "wheel": {"radius_m": 0.1, "width_m": 0.06}},
        "soil": {
            "cohesion_pa": 200, "friction_angle_rad": 0.6, "shear_modulus_m": 0.018,
            "pressure_sinkage": {"law": "bekker", "k_c": 1400, "k_phi": 820e3, "n0": 1}
        },
        "contact": {"rule": "wong_reece", "c1": 0.4, "c2": 0.2}
    })
}

#[test]
fn the_rover_that_climbs_the_steepest_slope_beats_a_grid_of_wheels() {
    let rims = "4 * 2700 * 0.002 * 2 * pi * radius_m * width_m";
    let body = json!({
        "of": "vehicle", "request": rover(), "evaluations": 1000, "maximise": "largest_slope_rad",
        "variables": [
            {"field": "/wheels/wheel/radius_m", "from": 0.05, "to": 0.2},
            {"field": "/wheels/wheel/width_m", "from": 0.03, "to": 0.15}
        ],
        "constraints": [{"quantity": rims, "at_most": 1}, {"quantity": "energy_per_metre_j_m", "at_most": 20}]
    });
    let found = optimum(&body);
    assert_eq!(found["feasible"], true);
    let wheel = json!({"radius_m": value_of(&found, 0), "width_m": value_of(&found, 1)});
    let alone = post("/v1/vehicle", &with(&rover(), json!({"wheels": {"wheel": wheel}}))).ok();
    for name in ["largest_slope_rad", "energy_per_metre_j_m", "slip", "torque_n_m"] {
        assert_eq!(found["quantities"][name], alone[name], "{name}");
    }
    let axes = json!([
        {"field": "/wheels/wheel/radius_m", "from": 0.05, "to": 0.2, "points": 16},
        {"field": "/wheels/wheel/width_m", "from": 0.03, "to": 0.15, "points": 13}
    ]);
    let columns = post("/v1/sweep", &json!({"of": "vehicle", "request": rover(), "axes": axes})).ok()["columns"].clone();
    let at = |name: &str, row: usize| columns[name][row].as_f64().unwrap_or(f64::NAN);
    let kept = (0..16 * 13).filter(|&row| {
        4.0 * mass(at("wheels.wheel.radius_m", row), at("wheels.wheel.width_m", row)) <= 1.0
            && at("energy_per_metre_j_m", row) <= 20.0
    });
    let slopes: Vec<f64> = kept.map(|row| at("largest_slope_rad", row)).filter(|slope| slope.is_finite()).collect();
    assert!(slopes.len() > 20, "{}", slopes.len());
    let best = slopes.into_iter().fold(f64::NEG_INFINITY, f64::max);
    assert!(number(&found["objective"]) >= best - ROUNDING, "{found} but the grid has {best}");
}

#[test]
fn few_evaluations_are_kept_and_told() {
    let found = optimum(&sought(wheels(), json!({"minimise": "torque_n_m", "evaluations": 20})));
    assert_eq!((&found["converged"], &found["stop_reason"]), (&json!(false), &json!("evaluations")));
    assert!(found["evaluations"].as_u64().is_some_and(|evaluations| evaluations <= 20));
    let again = optimum(&sought(wheels(), json!({"minimise": "torque_n_m", "evaluations": 20})));
    assert_eq!(found, again, "the same seed");
}

#[test]
fn points_without_an_answer_are_not_allowed_and_none_at_all_is_a_fault() {
    // Under a wheel this small the sand does not carry the load.
    let small =
        json!([{"field": "/wheel/radius_m", "from": 0.005, "to": 0.3}, {"field": "/wheel/width_m", "from": 0.005, "to": 0.1}]);
    let found = optimum(&sought(small, json!({"minimise": MASS})));
    assert!(found["without_answer"].as_u64().is_some_and(|count| count > 0), "{found}");
    assert_eq!(found["feasible"], true);
    let tiny = json!([{"field": "/wheel/radius_m", "from": 0.001, "to": 0.002}, {"field": "/wheel/width_m", "from": 0.001, "to": 0.002}]);
    let said = post("/v1/optimum", &sought(tiny, json!({"minimise": MASS, "evaluations": 50}))).fault("/request");
    assert!(said.starts_with("has no answer at any of 50 points within the bounds"), "{said}");
}

#[test]
fn faults_stand_where_they_are() {
    let fault = |changes: Value, pointer: &str| {
        post("/v1/optimum", &with(&sought(wheels(), json!({"minimise": "torque_n_m"})), changes)).fault(pointer)
    };
    assert_eq!(fault(json!({"minimise": "torqe_n_m"}), "/minimise"), "unknown name `torqe_n_m`; did you mean `torque_n_m`?");
    assert_eq!(fault(json!({"minimise": "2 +"}), "/minimise"), "ends where a value is due");
    assert_eq!(fault(json!({"minimise": null}), "/minimise"), "is required, or `maximise`");
    assert_eq!(fault(json!({"maximise": "slip"}), "/maximise"), "give either `minimise` or `maximise`");
    assert_eq!(
        fault(json!({"minimise": "(".repeat(20)}), "/minimise"),
        "must have at most 16 brackets, signs and powers within each other"
    );
    assert!(fault(json!({"constraints": [{"quantity": "slip"}]}), "/constraints/0/at_least").starts_with("is required"));
    let unknown = json!({"constraints": [{"quantity": "slip", "at_most": 1}, {"quantity": "sinkage", "at_most": 1}]});
    assert!(fault(unknown, "/constraints/1/quantity").starts_with("unknown name `sinkage`"));
    assert!(fault(json!({"against": {"minimise": "nothing"}}), "/against/minimise").starts_with("unknown name `nothing`"));
    assert!(fault(json!({"against": {"minimise": "slip", "points": 51}}), "/against/points").starts_with("must be"));
    assert!(fault(json!({"starts": 65}), "/starts").starts_with("must be"));
    assert!(fault(json!({"evaluations": 19}), "/evaluations").starts_with("must be"));
    assert!(fault(json!({"request": {"normal_load_n": null}}), "/request/sinkage_m").starts_with("is required"));

    let variable = |changes: Value, pointer: &str| {
        let variables = json!([with(&json!({"field": "/wheel/radius_m", "from": 0.05, "to": 0.2}), changes)]);
        fault(json!({"variables": variables, "request": {"wheel": {"width_m": 0.1}}}), &format!("/variables/0{pointer}"))
    };
    assert_eq!(variable(json!({"to": 0.01}), "/to"), "must be above `from`");
    assert_eq!(variable(json!({"start": 0.3}), "/start"), "must lie between `from` and `to`");
    assert!(variable(json!({"to": 1e6}), "/to").starts_with("must be"));
    assert!(variable(json!({"field": "/wheel/radius"}), "/field").contains("radius_m"));
    assert!(variable(json!({"name": "2r"}), "/name").starts_with("must have letters"));
    let twice =
        json!([{"field": "/slip", "from": 0, "to": 1}, {"field": "/wheel/width_m", "from": 0.1, "to": 0.2, "name": "slip"}]);
    assert!(fault(json!({"variables": twice}), "/variables/1/name").starts_with("another variable is called `slip`"));
    let same = json!([{"field": "/slip", "from": 0, "to": 1}, {"field": "/slip", "from": 0, "to": 1, "name": "other"}]);
    assert_eq!(fault(json!({"variables": same}), "/variables/1/field"), "`/slip` is varied twice");
}

#[test]
fn a_search_that_would_take_too_long_is_refused_before_it_starts() {
    let request = with(&loaded(), json!({"slip_angle_rad": 0.1}));
    let body = json!({
        "of": "forces", "request": request, "variables": wheels(), "minimise": "torque_n_m", "evaluations": 20_000, "starts": 64
    });
    let problem = post("/v1/optimum", &body).problem(422);
    assert_eq!(problem["type"], "/problems/too-costly");
}
