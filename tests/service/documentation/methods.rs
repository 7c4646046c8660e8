//! `docs/methods.md`: the advice is that of `/v1/model`, and its errors are those that the service finds.

use serde_json::{Value, json};

use super::table;
use crate::asking::{get, post, with};

const TEXT: &str = include_str!("../../../docs/methods.md");

/// The sets of the 27 points with their loads (N), as their sources state them.
const SETS: [(&str, f64); 5] = [
    ("ding-2011-smooth", 80.0),
    ("ding-2011-lug10", 80.0),
    ("hurrell-2025-rashid", 24.5),
    ("wang-han-2016-smooth", 58.86),
    ("wang-han-2016-lug10", 58.86),
];

/// One measured point.
struct Point {
    request: Value,
    slip: f64,
    sinkage: f64,
    /// That of (18) from the standstill, which the first point shows.
    from_standstill: f64,
    load: f64,
    torque: Option<f64>,
    pull: f64,
}

/// Eq. (18): the sinkage over the static one.
fn growth(slip: f64) -> f64 {
    (1.0 + slip) / (1.0 - 0.5 * slip)
}

fn points(sets: &[(&str, f64)]) -> Vec<Point> {
    let mut found = Vec::new();
    for (id, load) in sets {
        let set = get(&format!("/v1/validation/{id}")).ok();
        let columns = &set["columns"];
        let numbers = |column: &Value| column.as_array().into_iter().flatten().map(Value::as_f64).collect::<Vec<_>>();
        let slips = numbers(&columns["slip"]);
        let measured = |name: &str| numbers(&columns["measured"][name]);
        let (sinkages, pulls, torques) = (measured("sinkage_m"), measured("drawbar_coefficient"), measured("torque_n_m"));
        let first = sinkages[0].expect("a sinkage") / growth(slips[0].expect("a slip"));
        for (i, slip) in slips.iter().enumerate() {
            let slip = slip.expect("a slip");
            found.push(Point {
                request: json!({"wheel": set["wheel"], "soil": set["soil"], "slip_radius": set["slip_radius"], "slip": slip}),
                slip,
                sinkage: sinkages[i].expect("a sinkage"),
                from_standstill: first * growth(slip),
                load: *load,
                torque: torques.get(i).copied().flatten(),
                pull: pulls[i].expect("a pull"),
            });
        }
    }
    found
}

/// Root mean square of predicted less measured pull over the load, in three digits.
fn error(points: &[Point], pull: impl Fn(&Point) -> f64) -> String {
    let squares: f64 = points.iter().map(|point| (pull(point) / point.load - point.pull).powi(2)).sum();
    format!("{:.3}", (squares / points.len() as f64).sqrt())
}

fn forces(point: &Point, changes: Value) -> f64 {
    let request = with(&point.request, json!({"normal_load_n": point.load}));
    post("/v1/forces", &with(&request, changes)).ok()["longitudinal_force_n"].as_f64().expect("a pull")
}

fn from_torque(point: &Point, sinkage: f64) -> f64 {
    let request = json!({
        "wheel": point.request["wheel"], "slip": point.slip, "sinkage_m": sinkage, "normal_load_n": point.load,
        "torque_n_m": point.torque.expect("a torque")
    });
    post("/v1/coupled", &request).ok()["longitudinal_force_n"].as_f64().expect("a pull")
}

#[test]
fn the_table_is_the_advice_of_the_model() {
    let model = get("/v1/model").ok();
    let advice = model["advice"].as_array().expect("advice");
    let rows: Vec<Vec<&str>> = advice
        .iter()
        .map(|row| ["when", "take", "pull_error"].map(|name| row[name].as_str().expect("a text")).to_vec())
        .collect();
    assert_eq!(table(TEXT, "# Which method to use"), rows);
}

/// A row says that a soil was fitted to the very tests where it was, and no other row does.
#[test]
fn a_row_says_whether_its_soil_was_fitted() {
    let fitted = |id: &str| get(&format!("/v1/validation/{id}")).ok()["fitted_to"].is_string();
    let braking = ["cmu-smooth-braking", "cmu-grousered-braking"];
    assert!(braking.iter().all(|id| fitted(id)) && !SETS.iter().any(|(id, _)| fitted(id)));
    let advice = get("/v1/model").ok()["advice"].as_array().expect("advice").clone();
    let says: Vec<bool> = advice.iter().map(|row| row["pull_error"].to_string().contains("fitted to these tests")).collect();
    let brakes: Vec<bool> = advice.iter().map(|row| row["when"].to_string().contains("braking")).collect();
    assert_eq!(says, brakes);
    assert_eq!(brakes.iter().filter(|brakes| **brakes).count(), 1);
    let document: Value = serde_json::from_str(include_str!("../../../openapi/openapi.json")).expect("JSON");
    let meaning = document["components"]["schemas"]["Advice"]["properties"]["pull_error"]["description"].to_string();
    assert!(meaning.contains("unless it says so"), "{meaning}");
    assert!(TEXT.contains("Nothing was fitted unless the row says so"));
}

/// Each number of the last column, from the measured points.
#[test]
fn the_errors_are_those_of_the_service() {
    let (all, tested, smooth, lugs) = (points(&SETS), points(&SETS[..2]), points(&SETS[..1]), points(&SETS[1..2]));
    assert_eq!((all.len(), tested.len()), (27, 12));
    let explicit = |point: &Point, sinkage: f64| {
        forces(point, json!({"sinkage_m": sinkage, "method": "explicit", "lambda_a": "exact", "lambda_b": "exact"}))
    };
    let grains = |point: &Point| forces(point, json!({"method": "resistive_force"}));
    let quadrature = |point: &Point| forces(point, json!({}));
    let braking = |id: &str| {
        let set = get(&format!("/v1/validation/{id}")).ok();
        let results = set["results"].as_array().expect("results").clone();
        let two = results.into_iter().find(|result| result["braking"] == "two_zone").expect("two zones");
        assert_eq!((two["solved"].as_u64(), set["points"].as_u64()), (Some(3), Some(4)), "{id}");
        format!("{:.3}", two["drawbar_rmse_over_load"].as_f64().expect("an error"))
    };
    let expected = [
        format!(
            "{} of the load at measured sinkages and {} at those of (18) from the standstill (12 points of Ding et al. 2011)",
            error(&tested, |point| from_torque(point, point.sinkage)),
            error(&tested, |point| from_torque(point, point.from_standstill)),
        ),
        format!(
            "{} of the load at measured sinkages and {} at those of (18) (27 points)",
            error(&all, |point| explicit(point, point.sinkage)),
            error(&all, |point| explicit(point, point.from_standstill)),
        ),
        format!(
            "{} of the load (27 points); {} on a smooth wheel in dry sand, {} with lugs",
            error(&all, grains),
            error(&smooth, grains),
            error(&lugs, grains)
        ),
        format!(
            "{} of the load (12 points of Ding et al. 2011); {} where soils with borrowed values count as well (27 points)",
            error(&tested, quadrature),
            error(&all, quadrature)
        ),
        format!(
            "{} of the load on a smooth wheel, {} with lugs (3 of 4 points each), on soils that were fitted to these tests",
            braking("cmu-smooth-braking"),
            braking("cmu-grousered-braking")
        ),
    ];
    let shown: Vec<&str> = table(TEXT, "# Which method to use").into_iter().map(|row| row[2]).collect();
    assert_eq!(shown, expected);
}
